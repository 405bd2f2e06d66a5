// The chapter's figures, redrawn from the exact solver's curves: each with its boundary and marks.
(() => {
  'use strict';
  const { report, axis, chart } = tautline;
  const dashes = ['solid', 'dash', 'dot', 'dashdot', 'longdash'];

  const titleOf = (label) => (typeof label === 'string' ? label
    : `${label.name} [${label.unit || '-'}]`);
  const listOf = (boundary) => (!boundary ? [] : Array.isArray(boundary) ? boundary
    : boundary.curves || [boundary]);

  function line(curve, colour, dash, width) {
    return { type: 'scatter', mode: 'lines', name: curve.name, x: curve.x, y: curve.y,
      line: { color: colour, dash, width },
      hovertemplate: '<b>%{fullData.name}</b><br>%{x:.4g}, %{y:.4g}<extra></extra>' };
  }

  function build(figure) {
    return (colours) => ({
      data: [...listOf(figure.boundary).map((one) => line({ name: 'boundary', ...one },
        colours.muted, 'solid', 3)),
      ...figure.curves.map((one, i) => line(one, colours.engines[i % colours.engines.length],
        dashes[i % dashes.length], 1.5))],
      layout: { height: 340, showlegend: true,
        legend: { orientation: 'h', y: 1, yanchor: 'bottom', x: 0 }, margin: { l: 64, r: 16, t: 40, b: 52 },
        xaxis: axis(colours, { title: { text: titleOf(figure.x) } }),
        yaxis: axis(colours, { title: { text: titleOf(figure.y) } }),
        shapes: (figure.marks || []).map((mark) => ({ type: 'line', yref: 'paper', y0: 0, y1: 1,
          x0: mark.time, x1: mark.time, line: { color: colours.flag, width: 1, dash: 'dot' } })),
        annotations: (figure.marks || []).map((mark, i) => ({ x: mark.time, y: 1 - 0.08 * (i % 4),
          yref: 'paper', text: mark.meaning, showarrow: false, xanchor: 'left', yanchor: 'top',
          font: { color: colours.flag, size: 11 } })) },
    });
  }

  for (const element of document.querySelectorAll('.chart[data-figure]')) {
    const figure = report.chapter
      && report.chapter.figures.find((one) => one.name === element.dataset.figure);
    if (figure) {
      chart(element, build(figure));
    }
  }
})();
