// Stacked bars of what a deviation is made of, by engine, model and step: over all cases, or of one.
// Hatching tells the causes apart where colour does not.
(() => {
  'use strict';
  const { report, address, filter, axis, chart, make, number } = tautline;
  const element = document.getElementById('chart-attribution');
  if (!element) {
    return;
  }

  // the causes in the report's order; hatches come round again
  const hatches = ['', '/', '\\', 'x', '-', '|', '+', '.'];
  const names = (report.causes || []).map((row) => Object.keys(row.shares || {}))
    .reduce((most, some) => (some.length > most.length ? some : most), []);
  const causes = names.map((name, i) =>
    [name, name.replaceAll('_', ' '), hatches[i % hatches.length]]);

  const steps = [...new Set(report.runs.map((run) => run.step))].sort((a, b) => b - a);
  const middle = String(steps[steps.length >> 1]);
  const choice = { get case() { return address.get('case'); }, get step() { return address.get('step') || middle; } };

  /// Shares of the sum of the sizes of all parts; null where the run has none.
  function sharesOf(run) {
    const parts = run.attribution && run.attribution.parts;
    const sizes = causes.map((cause, i) => Math.abs(parts && parts[i] || 0));
    const sum = sizes.reduce((a, b) => a + b, 0);
    return sum > 0 ? Object.fromEntries(causes.map(([name], i) => [name, sizes[i] / sum])) : null;
  }

  /// {name, shares, deviation, covered} of what is drawn, first on top.
  function rows() {
    const fits = ({ engine, model, step }) => String(step) === choice.step && filter.fits({ engine, model });
    const name = (row) => `${row.engine} ${row.model}`;
    const found = choice.case
      ? report.runs.filter((run) => run.case === choice.case && fits(run)).map((run) => ({
        name: name(run), shares: sharesOf(run), deviation: run.attribution && run.attribution.deviation,
        covered: run.attribution && run.attribution.covered }))
      : (report.causes || []).filter(fits).map((row) => ({ name: name(row),
        shares: row.shares, deviation: row.deviation && row.deviation.median, covered: row.covered }));
    return found.filter((row) => row.shares && causes.some(([cause]) => row.shares[cause] > 0)).reverse();
  }

  function build(colours) {
    const found = rows();
    if (found.length === 0) {
      return { empty: 'No run of this choice has a deviation that was taken apart.' };
    }
    return {
      numbers: () => ({ columns: ['engine and model', 'step [s]', ...causes.map(([, text]) => `share of ${text}`), 'deviation [m]',
        'covered share of the time to the horizon'],
      rows: found.map((row) => [row.name, choice.step, ...causes.map(([cause]) => row.shares[cause] || 0), row.deviation, row.covered]) }),
      data: causes.map(([cause, text, hatch], i) => ({ type: 'bar', orientation: 'h', name: text,
        y: found.map((row) => row.name), x: found.map((row) => row.shares[cause] || 0),
        customdata: found.map((row) => [number(row.deviation), number(100 * row.covered, 2)]),
        hovertemplate: `<b>%{y}</b><br>${text}: %{x:.1%}; deviation %{customdata[0]} m, in the first %{customdata[1]} %<br>of the time to the horizon<extra></extra>`,
        marker: { color: colours.engines[i], line: { color: colours.paper, width: 0.6 },
          pattern: { shape: hatch, bgcolor: colours.engines[i], fgcolor: colours.paper, size: 6,
            solidity: 0.3 } } })),
      layout: { barmode: 'stack', bargap: 0.25, height: 120 + (colours.printing ? 16 : 22) * found.length, showlegend: true,
        legend: { orientation: 'h', y: 1, yanchor: 'bottom', x: 0, traceorder: 'normal' },
        margin: { l: 64, r: 16, t: 70, b: 52 },
        xaxis: axis(colours, { rangemode: 'tozero',
          title: { text: `${choice.case ? '' : 'mean '}share of the parts [-]` } }),
        yaxis: axis(colours, { title: { text: 'engine and model' }, type: 'category', ticks: '',
          tickfont: { size: colours.printing ? 9 : 11 } }) },
    };
  }

  const made = chart(element, build);
  element.before(make('div', { class: 'controls' },
    filter.bound('Case', [['', 'all cases'], ...report.cases.map((one) => [one.name, one.name])], 'case').element,
    filter.bound('Step [s]', steps.map((step) => [String(step), String(step)]), 'step', middle).element));
  address.listen(() => made.update(), filter.keys);
})();
