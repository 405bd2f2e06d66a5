// Error against cost and error against step as work-precision diagrams: a panel for each engine with
// the others in grey behind it, of one case or the median over the cases. The front, on which nothing
// is both cheaper and more accurate, is the same in every panel. Slopes are the report's
// ("convergence"), fitted case by case.
(() => {
  'use strict';
  const { report, address, filter, mark, logAxis, chart, make, select, legend, number, metric, lines } = tautline;

  /// An error this small is rounding: it does not shrink with the step [m]. The report's slopes are
  /// fitted to what is above it; below it a point is drawn at the foot of the chart.
  const rounding = 1e-9;
  /// A panel is at least this wide [px].
  const leastWidth = 330;

  const key = (row) => `${row.engine}/${row.model}`;
  const models = [...new Map(report.runs.map((run) => [key(run), run])).values()]
    .map(({ engine, model }) => ({ engine, model }));
  const byKey = (list, of) => new Map(list.map((row) => [of(row), row]));
  const costs = byKey(report.context.costs, (row) => `${key(row)}\n${row.step}`);
  /// Of each model its slope, or that its error is rounding, which has none.
  const slopes = Object.fromEntries(report.convergence.filter((row) => row.slope || row.cases_at_rounding > 0)
    .map((row) => [key(row), row.slope ? `slope ${number(Number(row.slope.median.toFixed(2)))}` : 'at rounding']));

  const grouped = (rows) => {
    const groups = new Map();
    rows.forEach((row) => groups.set(key(row), [...(groups.get(key(row)) || []), row]));
    return groups;
  };
  const runsOf = grouped(report.runs);
  const summaryOf = grouped(report.summary);
  const worked = (run) => run.status === 'finished' || run.status === 'stopped';

  /// The points of one model, in falling step: {step, error, cost, spread, cases}. The costs are the
  /// report's medians and `spread` its quartiles: over the cases, or of one case over the repetitions.
  function points(model, choice) {
    const found = choice.case
      ? (runsOf.get(model) || []).filter((run) => run.case === choice.case && worked(run) && run.metrics).map((run) => ({
        step: run.step, error: run.metrics[choice.metric], cases: 1, cost: run.cost?.[0], spread: run.cost?.slice(1) }))
      : (summaryOf.get(model) || []).map((row) => {
        const { second_cost: cost, second_spread: quartiles } = costs.get(`${model}\n${row.step}`) ?? {};
        return { step: row.step, error: row.metrics[choice.metric]?.median, cases: row.cases - row.failed, cost,
          spread: quartiles && [quartiles.lower, quartiles.upper] };
      });
    return found.filter(({ error }) => typeof error === 'number').sort((a, b) => b.step - a.step);
  }

  /// The points, of engines, that no other is below and left of, from left to right.
  function front(all, abscissa) {
    const sorted = [...all].sort((a, b) => a[abscissa] - b[abscissa] || a.drawn - b.drawn);
    let least = Infinity;
    return sorted.filter((point) => point.drawn < least && (least = point.drawn, true));
  }

  /// Every point that is drawn, with the height it is drawn at, and the foot of the chart.
  function drawn(choice, abscissa) {
    // the control has no error to draw
    const all = models.filter(({ engine }) => engine !== 'exact').flatMap(({ engine, model }) => points(`${engine}/${model}`, choice)
      .filter((point) => point[abscissa] > 0).map((point) => ({ ...point, engine, model })));
    const large = all.map((point) => point.error).filter((error) => error > rounding);
    const foot = large.length ? 10 ** (Math.floor(Math.log10(Math.min(...large))) - 1) : rounding;
    all.forEach((point) => { point.drawn = point.error > rounding ? point.error : foot; });
    return { all, foot, floored: large.length < all.length, top: Math.max(...large, 10 * foot) };
  }

  function told(point, choice) {
    const error = metric(choice.metric);
    const over = choice.case ? '' : `, median of ${point.cases} ${point.cases === 1 ? 'case' : 'cases'}`;
    const spread = point.spread ? `, the middle half of the ${choice.case ? 'repetitions' : 'cases'} ${number(1e3 * point.spread[0])} to ${number(1e3 * point.spread[1])}` : '';
    return `step ${number(point.step)} s<br>${error.words}: ${number(point.error)} ${error.unit}${over}`
      + `<br>cost: ${number(point.cost === undefined ? undefined : 1e3 * point.cost)} ms per simulated second${spread}<br><i>${lines(error.meaning)}</i>`;
  }

  const axisName = (letter, panel) => `${letter}${panel === 0 ? '' : panel + 1}`;

  /// One model's curve in its panel.
  function curve(model, own, panel, choice, abscissa, colours, onFront) {
    const { colour, symbol, dash } = mark(model.engine, model.model);
    const line = (point) => (onFront.has(point) ? colours.ink : /-open/.test(symbol) ? colour : colours.paper);
    return {
      name: `${model.engine} ${model.model}`, mode: 'lines+markers', type: 'scatter',
      xaxis: axisName('x', panel), yaxis: axisName('y', panel),
      x: own.map((point) => point[abscissa]), y: own.map((point) => point.drawn),
      text: own.map((point) => told(point, choice)),
      hovertemplate: '<b>%{fullData.name}</b><br>%{text}<extra></extra>',
      line: { color: colour, dash, width: 1.5 },
      error_x: abscissa === 'cost' && own.some((point) => point.spread) ? { type: 'data', symmetric: false,
        array: own.map((point) => (point.spread ? Math.max(0, point.spread[1] - point.cost) : 0)),
        arrayminus: own.map((point) => (point.spread ? Math.max(0, point.cost - point.spread[0]) : 0)),
        color: colour, thickness: 1, width: 3 } : undefined,
      marker: { color: colour, symbol, size: own.map((point) => (onFront.has(point) ? 12 : 8)),
        line: { color: own.map(line), width: own.map((point) => (onFront.has(point) ? 2 : 1)) } },
    };
  }

  /// All other engines behind a panel, as one grey curve with gaps.
  function others(all, engine, panel, abscissa, colours) {
    const rest = all.filter((point) => point.engine !== engine);
    const [x, y] = [[], []];
    rest.forEach((point, i) => {
      if (i > 0 && key(rest[i - 1]) !== key(point)) {
        x.push(null);
        y.push(null);
      }
      x.push(point[abscissa]);
      y.push(point.drawn);
    });
    return { name: 'the other engines', type: 'scatter', mode: 'lines+markers', hoverinfo: 'skip', x, y,
      xaxis: axisName('x', panel), yaxis: axisName('y', panel), opacity: 0.45,
      line: { color: colours.muted, width: 1 }, marker: { color: colours.muted, size: 3 } };
  }

  const frontLine = (best, panel, abscissa, colours) => ({ name: 'front of all engines', type: 'scatter',
    mode: 'lines', hoverinfo: 'skip', x: best.map((point) => point[abscissa]), y: best.map((point) => point.drawn),
    xaxis: axisName('x', panel), yaxis: axisName('y', panel),
    line: { color: colours.ink, width: 1.2, dash: 'dot', shape: 'hv' } });

  /// Thin lines of slope one and two through the corner of the drawn errors, to compare with.
  const guides = (range, top, foot, panel, colours) => [1, 2].map((slope) => {
    const [left, right] = range;
    const start = Math.max(left, right * (foot / top) ** (1 / slope));
    return { type: 'scatter', mode: 'lines', hoverinfo: 'skip', name: `slope ${slope}`,
      x: [start, right], y: [top * (start / right) ** slope, top],
      xaxis: axisName('x', panel), yaxis: axisName('y', panel),
      line: { color: colours.muted, width: 1, dash: slope === 1 ? 'longdash' : 'dashdot' } };
  });

  /// The decades from the foot up; what is drawn at the foot is named there, in place of its decade.
  function errorTicks(foot, top, floored) {
    const [low, high] = [Math.round(Math.log10(foot)), Math.ceil(Math.log10(top))];
    const every = Math.ceil((high - low) / 9);
    const powers = Array.from({ length: high - low + 1 }, (_, i) => low + i)
      .filter((power, i) => i === 0 || (i % every === 0));
    const text = (power) => `10<sup>${String(power).replace('-', '\u2212')}</sup>`;
    return { tickvals: powers.map((power) => 10 ** power),
      ticktext: powers.map((power) => (floored && power === low ? `\u2264 ${text(Math.log10(rounding))}` : text(power))),
      range: [low - 0.4, high + 0.2] };
  }

  /// What both charts draw, as it is measured: rounding, too.
  function numbers(shown, choice) {
    const error = metric(choice.metric);
    return { columns: ['case', 'engine', 'model', 'step [s]', `${error.words} [${error.unit}]`,
      'cost [s/s]', 'lower quartile of cost [s/s]', 'upper quartile of cost [s/s]', 'cases'],
    rows: shown.map((point) => [choice.case || 'median over the cases', point.engine, point.model, point.step, point.error,
      point.cost, ...(point.spread || [null, null]), point.cases]) };
  }

  function build(choice, abscissa) {
    return (colours, available) => {
      const width = Math.max(available, leastWidth);
      const { all, foot, floored, top } = drawn(choice, abscissa);
      const visible = all.filter((point) => !filter.isOff(point.engine, point.model));
      const own = visible.filter(({ engine, model }) => filter.fits({ engine, model }));
      const panels = filter.choices.filter((engine) => own.some((point) => point.engine === engine));
      if (panels.length === 0) {
        return { empty: 'No run of this choice has an error to draw.' };
      }
      const best = front(visible, abscissa);
      const onFront = new Set(best);
      // on paper a whole chart fits a page
      const columns = colours.printing ? Math.min(panels.length, 3)
        : Math.max(1, Math.min(panels.length, 4, Math.floor(width / leastWidth)));
      const rows = Math.ceil(panels.length / columns);
      const panelHeight = colours.printing || (columns === 1 && panels.length > 2) ? 210 : 270;
      const xs = visible.map((point) => point[abscissa]);
      const span = [Math.min(...xs), Math.max(...xs)];
      const xRange = [Math.log10(span[0]) - 0.2, Math.log10(span[1]) + 0.2];
      const height = rows * panelHeight + 90;
      const layout = { height, margin: { l: 82, r: 14, t: 50, b: 52 }, annotations: [], showlegend: false };
      const data = [];
      const title = { step: 'step [s]', cost: width / columns < 300 ? 'cost [s/s]' : 'processor time per simulated second [s/s]' }[abscissa];
      const error = metric(choice.metric);
      const ticks = errorTicks(foot, top, floored);
      const gap = { x: 26 / width, y: 44 / height };
      panels.forEach((engine, panel) => {
        const [column, row] = [panel % columns, Math.floor(panel / columns)];
        const size = [(1 - gap.x * (columns - 1)) / columns, (1 - gap.y * (rows - 1)) / rows];
        const left = column * (size[0] + gap.x);
        const high = 1 - row * (size[1] + gap.y);
        const last = panel + columns >= panels.length;
        layout[`xaxis${panel === 0 ? '' : panel + 1}`] = logAxis(colours, { domain: [left, left + size[0]],
          anchor: axisName('y', panel), range: xRange, title: last ? { text: title, font: { size: 12 } } : undefined,
          matches: panel === 0 ? undefined : 'x', showticklabels: last, automargin: false });
        layout[`yaxis${panel === 0 ? '' : panel + 1}`] = logAxis(colours, { domain: [high - size[1], high],
          anchor: axisName('x', panel), ...ticks, tickmode: 'array', matches: panel === 0 ? undefined : 'y',
          title: column === 0 ? { text: `${error.words} [${error.unit}]`, font: { size: 12 }, standoff: 8 } : undefined,
          showticklabels: column === 0, automargin: false });
        layout.annotations.push({ xref: 'paper', yref: 'paper', x: left, y: high, yanchor: 'bottom', xanchor: 'left',
          text: `<b>${engine}</b>`, showarrow: false, font: { color: colours.ink, size: 13 } });
        data.push(others(visible, engine, panel, abscissa, colours),
          ...(abscissa === 'step' ? guides(span, top, foot, panel, colours) : [frontLine(best, panel, abscissa, colours)]),
          ...models.filter((model) => model.engine === engine && filter.fits(model)).map((model) =>
            curve(model, visible.filter((point) => key(point) === key(model)), panel, choice, abscissa, colours,
              abscissa === 'cost' ? onFront : new Set())));
      });
      const what = abscissa === 'cost' ? 'Dotted: the front of all engines, on which nothing is both cheaper and more '
        + `accurate; its points are ringed. Bars: the middle half of the ${choice.case ? 'repetitions' : 'cases'}. Grey: the other engines.`
        : 'Grey: the other engines; the straight lines have slopes 1 and 2.';
      return { data, layout, note: what, numbers: () => numbers(own, choice) };
    };
  }

  function install(id, abscissa, notes) {
    const element = document.getElementById(id);
    if (!element) {
      return;
    }
    const choice = { get case() { return address.get('case'); },
      get metric() { return address.get('error') || 'early_position_error'; } };
    const made = chart(element, build(choice, abscissa));
    const cases = [['', `median over the cases (${report.cases.length})`],
      ...report.cases.map((one) => [one.name, one.name])];
    const keys = make('div', { class: 'legend' });
    element.before(make('div', { class: 'controls' },
      filter.bound('Case', cases, 'case').element,
      filter.bound('Error', [['early_position_error', `over the first ${report.options.early_impacts} impacts`],
        ['horizon_position_error', 'to the predictability horizon']], 'error', 'early_position_error').element));
    element.after(keys);
    const byName = [...models].sort((a, b) => filter.choices.indexOf(a.engine) - filter.choices.indexOf(b.engine));
    const rows = () => legend(keys, byName.filter((one) => one.engine !== 'exact' && filter.chooses(one)),
      choice.case ? {} : notes); // slopes are medians over the cases
    address.listen(() => { rows(); made.update(); }, [...filter.keys, 'error']);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', rows);
    addEventListener('beforeprint', rows);
    addEventListener('afterprint', rows);
    let before = element.clientWidth;
    new ResizeObserver(() => {
      if (Math.floor(before / leastWidth) !== Math.floor(element.clientWidth / leastWidth)) {
        before = element.clientWidth;
        made.update();
      }
    }).observe(element);
  }

  install('chart-cost', 'cost', {});
  install('chart-step', 'step', slopes);
})();
