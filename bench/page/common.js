// What the scripts of the report page share: the report, the marks that tell engines and models
// apart (colour, symbol and dash, so that grey is enough), and the words and units of its numbers.
(() => {
  'use strict';
  const { theme } = tautline;
  const report = JSON.parse(document.getElementById('report-data').textContent);
  // Plotly makes links of <a> in names
  for (const row of [report.runs, report.cases, report.engines, report.summary, report.convergence,
    report.findings || [], report.causes || [], report.context.costs || []].flat()) {
    for (const key of ['case', 'engine', 'model', 'name']) {
      if (typeof row[key] === 'string' && /[<>]/.test(row[key])) {
        row[key] = row[key].replaceAll('<', '‹').replaceAll('>', '›');
      }
    }
  }

  const asked = new Map(report.cases.map((row) => [row.name, (row.geometry ?? row.system.cables).find((cable) => !cable.elasticity)?.restitution]));
  for (const run of report.runs) {
    run.status ??= 'finished'; // which nearly all are
    if (run.e) {
      run.e = [run.e[0], asked.get(run.case), run.e[1]]; // a word, the restitution asked and got
    }
  }
  // impacts come as columns, whose names stand once; behind the first, one of a single value as that value
  for (const run of report.runs.filter((one) => one.impacts)) {
    const [{ length }] = run.impacts;
    const full = (column) => (Array.isArray(column) ? column : Array(length).fill(column));
    run.impacts = Object.fromEntries(report.impact_columns.map((name, i) =>
      [name, name === 'left_out' ? run.impacts[i] : full(run.impacts[i])]));
  }

  const shapes = ['circle', 'square', 'diamond', 'triangle-up', 'triangle-down', 'pentagon', 'star',
    'hexagon', 'cross', 'x', 'triangle-left', 'triangle-right', 'hourglass', 'bowtie', 'star-diamond',
    'hexagram'];
  const fills = ['', '-open', '-dot', '-open-dot'];
  const dashes = ['solid', 'dash', 'dot', 'dashdot', 'longdash', 'longdashdot'];

  const engines = report.engines.map((engine) => engine.name);
  const modelsOf = (name) => report.engines.find((one) => one.name === name)?.models ?? [];
  /// The place of each model among all of them, engine after engine.
  const places = new Map(engines.flatMap((engine) => modelsOf(engine).map((model) => `${engine}/${model}`))
    .map((key, place) => [key, place]));

  /// How a model of an engine is drawn everywhere on the page. The exact engine, the control, is
  /// grey. Colour tells the engine; symbol and dash tell the model. No two models have one symbol,
  /// up to as many as there are shapes and fills.
  function mark(engine, model) {
    const colours = theme();
    const at = Math.max(0, engines.indexOf(engine));
    const place = places.get(`${engine}/${model}`) ?? 0;
    return {
      colour: engine === 'exact' ? colours.muted : colours.engines[at % colours.engines.length],
      symbol: shapes[place % shapes.length] + fills[Math.floor(place / shapes.length) % fills.length],
      dash: dashes[Math.max(0, modelsOf(engine).indexOf(model)) % dashes.length],
    };
  }

  /// A case in units of its own: its gravity is exactly one.
  const nondimensional = (row) => {
    const gravity = row.gravity ?? row.system?.gravity;
    return gravity && gravity.reduce((sum, part) => sum + part ** 2, 0) === 1;
  };
  const ownUnits = report.cases.length > 0 && report.cases.every(nondimensional);
  const physical = '(?:N m s|N s|rad/s|m/s|s/s|J|m|s)';
  const afterNumber = new RegExp(`(\\d|%\\{[^}]*\\}|none) ${physical}(?![\\w/²])`, 'g');
  const inBrackets = new RegExp(`\\[${physical}\\]`, 'g');

  /// `text` in the units of `system`, or of the case that the page is of: without metres, seconds
  /// and joules where it, or every case, has units of its own.
  function inUnits(text, system) {
    const name = tautline.address?.get('case');
    const of = system || (name && report.cases.find((one) => one.name === name));
    return (of ? nondimensional(of) : ownUnits) && typeof text === 'string'
      ? text.replace(inBrackets, '[-]').replace(afterNumber, '$1') : text;
  }

  /// A metric of the list: its name in words, its unit and what it means.
  function metric(name) {
    const found = (report.metrics || []).find((one) => one.name === name) || {};
    return { words: name.replaceAll('_', ' '), unit: found.unit === '1' ? '' : found.unit || '',
      meaning: found.meaning || '' };
  }

  /// `text` in lines of about `width` characters, for a tooltip.
  function lines(text, width = 52) {
    const made = [''];
    for (const word of text.split(' ')) {
      if (made.at(-1).length + word.length > width) {
        made.push('');
      }
      made[made.length - 1] += (made.at(-1) ? ' ' : '') + word;
    }
    return made.join('<br>');
  }

  Object.assign(tautline, { report, mark, engines, modelsOf, nondimensional, ownUnits, inUnits, metric, lines });
})();
