// Error against cost and error against step, one curve a model: of one case, or the median over the
// cases. The slopes beside the names are the report's ("convergence"), fitted case by case.
(() => {
  'use strict';
  const { report, mark, logAxis, chart, make, select, legend, number } = tautline;

  /// An error this small is rounding: it does not shrink with the step [m]. The report's slopes are
  /// fitted to what is above it; below it a point is drawn at the foot of the chart.
  const rounding = 1e-9;

  const key = (row) => `${row.engine}/${row.model}`;
  const models = [...new Map(report.runs.map((run) => [key(run), run])).values()]
    .map(({ engine, model }) => ({ engine, model }));
  const costOf = (list, of) => new Map(list.map((row) => [of(row), row.second_cost]));
  const costs = costOf(report.context.timing, (row) => `${row.case}\n${key(row)}\n${row.step}`);
  const medianCosts = costOf(report.context.costs, (row) => `${key(row)}\n${row.step}`);
  const slopes = Object.fromEntries(report.convergence.filter((row) => row.slope)
    .map((row) => [key(row), `slope ${number(Number(row.slope.median.toFixed(2)))}`]));

  const grouped = (rows) => {
    const groups = new Map();
    rows.forEach((row) => groups.set(key(row), [...(groups.get(key(row)) || []), row]));
    return groups;
  };
  const runsOf = grouped(report.runs);
  const summaryOf = grouped(report.summary);
  const worked = (run) => run.status === 'finished' || run.status === 'stopped';

  /// The points of one model, in falling step: {step, error, cost, cases}. Over all cases they are
  /// the report's medians.
  function points(model, choice) {
    const found = choice.case
      ? runsOf.get(model).filter((run) => run.case === choice.case && worked(run) && run.metrics).map((run) => ({
        step: run.step, error: run.metrics[`${choice.window}_position_error`], cases: 1,
        cost: costs.get(`${run.case}\n${model}\n${run.step}`) }))
      : (summaryOf.get(model) || []).map((row) => ({ step: row.step,
        error: row.metrics[`${choice.window}_position_error`]?.median, cases: row.cases - row.failed,
        cost: medianCosts.get(`${model}\n${row.step}`) }));
    return found.filter(({ error }) => typeof error === 'number').sort((a, b) => b.step - a.step);
  }

  function curve({ engine, model }, choice, abscissa, colours, hidden) {
    const { colour, symbol, dash } = mark(engine, model);
    const found = points(`${engine}/${model}`, choice).filter((point) => point[abscissa] > 0);
    return {
      name: `${engine} ${model}`, mode: 'lines+markers', type: 'scatter',
      visible: !hidden.has(`${engine}/${model}`),
      x: found.map((point) => point[abscissa]),
      y: found.map((point) => point.error),
      text: found.map((point) => `step ${number(point.step)} s, error ${number(point.error)} m, cost `
        + `${number(point.cost)} s/s${choice.case ? '' : `, median of ${point.cases} cases`}`),
      hovertemplate: '<b>%{fullData.name}</b><br>%{text}<extra></extra>',
      line: { color: colour, dash, width: engine === 'exact' ? 2.4 : 1.5 },
      marker: { color: colour, symbol, size: 9,
        line: { color: /-open/.test(symbol) ? colour : colours.paper, width: 1 } },
    };
  }

  /// Thin lines of slope one and two through the corner of the drawn errors, to compare with.
  function guides(curves, errors, colours) {
    const xs = curves.flatMap((one) => one.x);
    if (errors.length === 0) {
      return [];
    }
    const [left, right] = [Math.min(...xs), Math.max(...xs)];
    const top = Math.max(...errors);
    return [1, 2].map((slope) => ({ type: 'scatter', mode: 'lines+text', hoverinfo: 'skip',
      name: `slope ${slope}`, x: [left, right], y: [top * (left / right) ** slope, top],
      text: [`slope ${slope} `, ''], textposition: 'bottom right', showlegend: false,
      textfont: { color: colours.muted, size: 12 },
      line: { color: colours.muted, width: 1, dash: 'dot' } }));
  }

  function build(choice, abscissa, hidden) {
    return (colours) => {
      const curves = models.map((model) => curve(model, choice, abscissa, colours, hidden));
      if (curves.every((one) => one.x.length === 0)) {
        return { empty: 'No run of this choice has an error to draw.' };
      }
      const title = { step: 'step [s]', cost: 'processor time per simulated second [s/s]' }[abscissa];
      const range = { early: 'over the early impacts', horizon: 'to the horizon' }[choice.window];
      const errors = curves.flatMap((one) => one.y);
      const large = errors.filter((error) => error > rounding);
      const foot = large.length ? 10 ** (Math.floor(Math.log10(Math.min(...large))) - 1) : rounding;
      curves.forEach((one) => { one.y = one.y.map((error) => (error > rounding ? error : foot)); });
      return { data: [...(abscissa === 'step' ? guides(curves, large, colours) : []), ...curves],
        layout: { height: 480,
          annotations: large.length < errors.length ? [{ xref: 'paper', x: 0.5, y: Math.log10(foot),
            yanchor: 'bottom', showarrow: false, text: `drawn here: errors up to ${number(rounding)} m, rounding`,
            font: { color: colours.muted, size: 12 } }] : [],
          xaxis: logAxis(colours, { title: { text: title } }),
          yaxis: logAxis(colours, { title: { text: `position error ${range} [m]` } }) } };
    };
  }

  function install(id, abscissa, notes) {
    const element = document.getElementById(id);
    if (!element) {
      return;
    }
    const choice = { case: '', window: 'early' };
    const hidden = new Set();
    const made = chart(element, build(choice, abscissa, hidden));
    const change = (name) => (value) => { choice[name] = value; made.update(); };
    const cases = [['', `median over the cases (${report.cases.length})`],
      ...report.cases.map((one) => [one.name, one.name])];
    const keys = make('div', { class: 'legend' });
    element.before(make('div', { class: 'controls' },
      select('Case', cases, '', change('case')).element,
      select('Error', [['early', `over the first ${report.options.early_impacts} impacts`],
        ['horizon', 'to the predictability horizon']], 'early', change('window')).element));
    element.after(keys);
    const rows = () => legend(keys, models, hidden, notes, () => made.update());
    rows();
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', rows);
  }

  install('chart-cost', 'cost', {});
  install('chart-step', 'step', slopes);
})();
