// The restitution audit: the impacts in the report, by case, engine, model and step. Requested
// against effective restitution over impact speed and over the lever arm, the impulse errors, and
// the ladder of bounce heights against e^(2n). The page of many runs has the fastest impacts of each
// only; a note below a chart says how many it has not, and report.json has them.
(() => {
  'use strict';
  const { report, address, filter, mark, axis, logAxis, speedAxis, chart, make, select, refill, short, number, modelsOf } = tautline;

  /// More points than this in a chart are thinned evenly: a page has to stay quick.
  const most = () => (tautline.theme().printing ? 800 : 4000);
  /// Errors at or below this are rounding and drawn here, as a logarithm has no zero [N s, N m s].
  const floor = 1e-17;
  /// A ladder ends where the exact one is this low: nobody sees a lower bounce [-].
  const lowest = 1e-6;

  const app = document.getElementById('audit-app');
  if (!app) {
    return;
  }
  // impacts in space have no arm and no errors: the replay shows them
  const planar = new Set(report.cases.filter((one) => !one.system).map((one) => one.name));
  const audited = report.runs.filter((run) => run.impacts?.time.length > 0 && planar.has(run.case));
  const engines = [...new Set(audited.map((run) => run.engine))];
  const steps = [...new Set(audited.map((run) => run.step))].sort((a, b) => b - a);
  if (audited.length === 0) {
    app.textContent = 'Charts of single impacts are for cases of one body in the plane. No run of this report has such impacts.';
    return;
  }
  /// One engine at a time: the one that is shown alone, or that was chosen here, or the first.
  const shown = () => engines.filter((name) => filter.shows(name) && (name !== 'exact' || engines.length === 1));
  const choice = {
    get case() { return address.get('case'); },
    get step() { return address.get('step'); },
    get engine() {
      const wanted = address.get('audit.engine');
      return shown().includes(wanted) || (wanted === 'exact' && engines.includes(wanted)) ? wanted
        : shown()[0] || engines[0];
    },
    get model() {
      const wanted = address.get('model');
      return modelsOf(choice.engine).includes(wanted) ? wanted : '';
    } };

  const chosen = () => audited.filter((run) => run.engine === choice.engine
    && (!choice.case || run.case === choice.case) && (!choice.model || run.model === choice.model)
    && (!choice.step || String(run.step) === choice.step) && !filter.isOff(run.engine, run.model));

  /// The impacts of the chosen runs by model, thinned: {total, missing, numbers, models: [{model, rows}]}; `numbers` has all.
  /// `missing` impacts of these runs are not on the page.
  function impacts() {
    const byModel = new Map();
    let total = 0;
    let missing = 0;
    for (const run of chosen()) {
      const columns = run.impacts;
      total += columns.time.length;
      missing += columns.left_out;
      const rows = byModel.get(run.model) || [];
      columns.time.forEach((time, i) => rows.push({ time, run, requested: columns.requested[i],
        speed: -columns.rate_before[i], effective: -columns.rate_after[i] / columns.rate_before[i],
        cable: columns.cable[i], arm: columns.arm[i], tangential: columns.tangential_error[i],
        angular: columns.angular_error[i] }));
      byModel.set(run.model, rows);
    }
    const stride = Math.ceil(total / most());
    const numbers = () => ({ columns: ['case', 'engine', 'model', 'step [s]', 'time [s]', 'cable', 'impact speed [m/s]',
      'lever arm [m]', 'asked restitution', 'got restitution', 'across the cable [N s]', 'angular error [N m s]'],
    rows: [...byModel.values()].flat().map((row) => [row.run.case, row.run.engine, row.run.model, row.run.step, row.time, row.cable,
      row.speed, row.arm, row.requested, row.effective, row.tangential, row.angular]) });
    return { total, missing, numbers, models: [...byModel].map(([model, rows]) => ({ model,
      rows: rows.filter((row, i) => i % stride === 0) })) };
  }

  const told = (row) => `${short(row.run.case)}<br>step ${number(row.run.step)} s, t = ${number(row.time, 5)}`
    + ` s, cable ${row.cable}<br>closing at ${number(row.speed)} m/s, arm ${number(row.arm)} m`
    + `<br>asked ${number(row.requested)}, got ${number(row.effective)}`;
  // Plotly reads markup in hover text: a name must not be able to write any
  const plain = (text) => text.replace(/&/g, '&amp;').replace(/<(?!br>)/g, '&lt;');

  /// One engine alone is shown here: colour tells its models, symbol and dash are those of everywhere.
  function own(engine, model) {
    const colours = tautline.theme().engines;
    return { ...mark(engine, model), colour: colours[Math.max(0, modelsOf(engine).indexOf(model)) % colours.length] };
  }

  function dots(model, rows, x, y, more = {}) {
    const { colour, symbol } = own(choice.engine, model);
    return { type: 'scatter', mode: 'markers', name: `${choice.engine} ${model}`,
      x: rows.map(x), y: rows.map(y), text: rows.map((row) => plain(told(row))),
      hovertemplate: '<b>%{fullData.name}</b><br>%{text}<extra></extra>',
      marker: { color: colour, symbol, size: 7, opacity: 0.75,
        line: { color: colour, width: /-open/.test(symbol) ? 1.2 : 0 } }, ...more };
  }

  function requested(models, x, colours) {
    const rows = models.flatMap((one) => one.rows).filter((row) => row.requested !== null);
    return { type: 'scatter', mode: 'markers', name: 'asked', hoverinfo: 'skip',
      x: rows.map(x), y: rows.map((row) => row.requested),
      marker: { symbol: 'line-ew-open', size: 11, color: colours.ink, line: { width: 1.6 } } };
  }

  /// What a chart of `drawn` impacts does not show.
  function note({ total, missing }, drawn) {
    const thinned = total > drawn ? `${drawn} of ${total} impacts are drawn. ` : '';
    const slower = missing === 1 ? '1 slower impact of these runs is' : `${missing} slower impacts of these runs are`;
    return thinned + (missing > 0 ? `${slower} not on this page; report.json has them.` : '');
  }
  const nothing = { empty: 'No impact in this choice.' };

  /// The thresholds that were found in what is chosen, as upright lines.
  function thresholds(colours) {
    const found = (report.findings || []).filter((one) => one.kind === 'threshold'
      && one.engine === choice.engine && one.value > 0 && (!choice.model || one.model === choice.model));
    const values = [...new Set(found.map((one) => one.value))];
    return { shapes: values.map((value) => ({ type: 'line', x0: value, x1: value, yref: 'paper', y0: 0,
      y1: 1, line: { color: colours.flag, width: 1.5, dash: 'dash' } })),
    annotations: values.map((value) => ({ x: Math.log10(value), y: 1, yref: 'paper', showarrow: false,
      text: `threshold ${number(value)} m/s`, xanchor: 'left', yanchor: 'top',
      font: { color: colours.flag } })) };
  }

  const withLegend = { showlegend: true,
    legend: { orientation: 'h', y: 1.02, yanchor: 'bottom', x: 0, font: { size: 11 } } };

  function restitution(x, axisOf, extra) {
    return (colours) => {
      const found = impacts();
      const { models } = found;
      const rows = models.flatMap((one) => one.rows);
      if (found.total === 0) {
        return nothing;
      }
      return { note: note(found, rows.length), numbers: found.numbers,
        data: [...models.map((one) => dots(one.model, one.rows, x, (row) => row.effective)),
          requested(models, x, colours)],
        layout: { ...extra(colours), ...withLegend, xaxis: axisOf(colours),
          yaxis: axis(colours, { title: { text: 'restitution [-]' } }) } };
    };
  }

  /// A range of decades, and labels that are not too close.
  function spread(range) {
    const [low, high] = [Math.ceil(range[0]), Math.floor(range[1])];
    const every = Math.max(1, Math.ceil((high - low) / 8));
    const powers = Array.from({ length: high - low + 1 }, (_, i) => low + i).filter((power, i) => i % every === 0);
    const text = (power) => `10<sup>${String(power).replace('-', '\u2212')}</sup>`;
    return { range, tickmode: 'array', tickvals: powers.map((power) => 10 ** power),
      ticktext: powers.map((power) => (10 ** power <= floor * 1.001 ? `\u2264 ${text(power)}` : text(power))) };
  }

  function impulse(colours) {
    const found = impacts();
    const { models } = found;
    if (found.total === 0) {
      return nothing;
    }
    const size = (value) => Math.max(Math.abs(value), floor);
    const speed = (row) => row.speed;
    const decades = (name) => {
      const sizes = models.flatMap((one) => one.rows).map((row) => Math.log10(size(row[name])));
      return [Math.floor(Math.min(...sizes)) - 0.2, Math.ceil(Math.max(...sizes) + 1e-9) + 0.2];
    };
    return { note: note(found, models.flatMap((one) => one.rows).length), numbers: found.numbers,
      data: [...models.map((one) => dots(one.model, one.rows, speed, (row) => size(row.tangential))),
        ...models.map((one) => dots(one.model, one.rows, speed, (row) => size(row.angular),
          { yaxis: 'y2', showlegend: false }))],
      layout: { height: colours.printing ? 460 : 560, ...withLegend, xaxis: speedAxis(colours, { title: { text: 'impact speed [m/s]' }, anchor: 'y2' }),
        yaxis: logAxis(colours, { title: { text: 'across the cable [N s]', standoff: 8 }, domain: [0.54, 1],
          ...spread(decades('tangential')) }),
        yaxis2: logAxis(colours, { title: { text: 'angular error [N m s]', standoff: 8 }, domain: [0, 0.46],
          ...spread(decades('angular')) }) } };
  }

  function ladder(colours) {
    const runs = chosen().filter((run) => run.audit && run.audit.ladder);
    if (runs.length === 0) {
      return { empty: 'No run of this choice bounces straight up and down on one cable, as a ladder '
        + 'of heights needs.' };
    }
    const exact = runs.map((run) => run.audit.ladder.exact).sort((a, b) => b.length - a.length)[0]
      .filter((height) => height >= lowest);
    const counted = (values) => values.map((value, i) => i + 1); // h_0 is the first height itself
    const traces = runs.map((run) => {
      const { colour, symbol, dash } = own(run.engine, run.model);
      const heights = run.audit.ladder.heights.slice(0, Math.max(2, exact.length));
      return { type: 'scatter', mode: 'lines+markers', x: counted(heights), y: heights,
        name: `${run.engine} ${run.model}, step ${number(run.step)} s`,
        hovertemplate: '<b>%{fullData.name}</b><br>bounce %{x}: %{y:.3g}<extra></extra>',
        line: { color: colour, dash, width: 1.3 }, marker: { color: colour, symbol, size: 8 } };
    });
    const shownHeights = [...exact, ...traces.flatMap((one) => one.y)].filter((height) => height > 0);
    return { data: [{ type: 'scatter', mode: 'lines', name: 'e^(2n)', x: counted(exact), y: exact,
      hovertemplate: 'e^(2n), bounce %{x}: %{y:.3g}<extra></extra>',
      line: { color: colours.muted, width: 4 } }, ...traces],
    layout: { ...withLegend, xaxis: axis(colours, { title: { text: 'bounce n [-]' } }),
      yaxis: logAxis(colours, { title: { text: 'height over the first, h<sub>n</sub>/h<sub>0</sub> [-]' },
        ...spread([Math.log10(Math.max(lowest, Math.min(...shownHeights))) - 0.2,
          Math.log10(Math.max(...shownHeights)) + 0.2]) }) } };
  }

  const ids = { restitution: 'chart-restitution', arm: 'chart-arm', impulse: 'chart-impulse',
    ladder: 'chart-ladder' };
  const place = (id, title) => {
    const element = make('div', { class: 'chart', id });
    app.append(make('figure', {}, make('figcaption', {}, title), element));
    return element;
  };
  const all = (text, values) => [['', text], ...values.map((value) => [String(value), String(value)])];
  const choices = (names) => names.map((name) => [name, name]);
  const engine = select('Engine', choices(engines), choice.engine, (name) => address.set({ 'audit.engine': name, model: '' }));
  const model = select('Model', all('all models', modelsOf(choice.engine)), choice.model,
    (name) => address.set({ model: name }));
  app.replaceChildren(make('div', { class: 'controls' }, engine.element, model.element,
    filter.bound('Step [s]', all('all steps', steps), 'step').element,
    filter.bound('Case', all('all cases', report.cases.map((one) => one.name)), 'case').element));
  chart(place(ids.restitution, 'Restitution over the speed of the impact: asked (bars) and got (marks).'),
    restitution((row) => row.speed, (colours) => speedAxis(colours,
      { title: { text: 'impact speed [m/s]' } }), thresholds));
  chart(place(ids.arm, 'The same over the lever arm of the cable about the centre of mass.'),
    restitution((row) => row.arm, (colours) => axis(colours, { title: { text: 'lever arm [m]' } }),
      () => ({})));
  chart(place(ids.impulse, 'Errors of the impulse: across the cable, where it should be none, and in '
    + 'the spin against arm times impulse.'), impulse);
  chart(place(ids.ladder, 'Bounce ladder: heights over the first, against e^(2n).'), ladder);
  address.listen(() => {
    document.querySelectorAll('#audit .findings li').forEach((item) => {
      item.hidden = !filter.chooses({ ...item.dataset });
    });
    refill(engine, choices([...new Set([...shown(), ...(engines.includes('exact') ? ['exact'] : [])])]));
    engine.box.value = choice.engine;
    refill(model, all('all models', modelsOf(choice.engine)));
    model.box.value = choice.model;
    Object.values(ids).forEach((id) => tautline.charts[id]?.update());
  }, [...filter.keys, 'audit.engine']);
})();
