// What the scripts of the report page share: the report, and the marks that tell engines and models
// apart (colour, symbol and dash, so that grey is enough).
(() => {
  'use strict';
  const { theme } = tautline;
  const report = JSON.parse(document.getElementById('report-data').textContent);
  // Plotly makes links of <a> in names
  for (const row of [report.runs, report.cases, report.engines, report.summary, report.convergence,
    report.findings || [], report.causes || [], report.context.timing,
    report.context.costs || []].flat()) {
    for (const key of ['case', 'engine', 'model', 'name']) {
      if (typeof row[key] === 'string' && /[<>]/.test(row[key])) {
        row[key] = row[key].replaceAll('<', '‹').replaceAll('>', '›');
      }
    }
  }

  const symbols = ['circle', 'square', 'diamond', 'triangle-up', 'triangle-down', 'pentagon', 'star',
    'hexagon', 'cross', 'x'];
  const fills = ['', '-open', '-dot', '-open-dot'];
  const dashes = ['solid', 'dash', 'dot', 'dashdot', 'longdash', 'longdashdot'];

  const engines = report.engines.map((engine) => engine.name);
  const modelsOf = (name) => {
    const engine = report.engines.find((one) => one.name === name);
    return (engine && engine.models || []).map((model) => model.name);
  };

  /// How a model of an engine is drawn everywhere on the page. The exact engine, the control, is
  /// grey. Symbol tells the engine; its fill and the dash tell the model.
  function mark(engine, model) {
    const colours = theme();
    const at = Math.max(0, engines.indexOf(engine));
    const which = Math.max(0, modelsOf(engine).indexOf(model));
    return {
      colour: engine === 'exact' ? colours.muted : colours.engines[at % colours.engines.length],
      symbol: symbols[at % symbols.length] + fills[which % fills.length],
      dash: dashes[which % dashes.length],
    };
  }

  Object.assign(tautline, { report, mark, engines, modelsOf });
})();
