// The chapter's figures, drawn from the exact motions: each with its boundaries and marks.
(() => {
  'use strict';
  const { axis, chart } = tautline;
  const { figures } = JSON.parse(document.getElementById('chapter-data').textContent);
  const symbols = ['circle', 'square-open'];

  const hover = '<b>%{fullData.name}</b><br>%{x:.4g}, %{y:.4g}<extra></extra>';

  const line = (curve, colour, width, dash = 'solid') => ({ type: 'scatter', mode: 'lines', name: curve.name,
    x: curve.x, y: curve.y, line: { color: colour, width, dash }, hovertemplate: hover });

  const points = (curve, colour, symbol) => ({ type: 'scatter', mode: 'markers', name: curve.name, x: curve.x,
    y: curve.y, marker: { color: colour, symbol, size: 5 }, hovertemplate: hover });

  const isTime = (heading) => heading.startsWith('t ');

  /// A mark is an instant: a plot without a time axis has no place for it.
  const marksOf = (figure) => (isTime(figure.x) ? figure.marks : []);

  function build(figure) {
    const impacts = figure.y.startsWith('vn');
    return (colours) => ({
      data: [
        ...figure.boundary.map((one, i) => line(one, colours.muted, i === 2 ? 3 : 1.2, i === 2 ? 'solid' : 'dot')),
        ...figure.curves.map((one, i) => (impacts ? points(one, colours.engines[i], symbols[i])
          : line(one, colours.engines[i], 1.5)))],
      layout: { height: 360, showlegend: true,
        legend: { orientation: 'h', y: 1, yanchor: 'bottom', x: 0 }, margin: { l: 64, r: 16, t: 40, b: 52 },
        xaxis: axis(colours, { title: { text: figure.x } }),
        yaxis: axis(colours, { title: { text: figure.y } }),
        shapes: marksOf(figure).map((mark) => ({ type: 'line', yref: 'paper', y0: 0, y1: 1, x0: mark.time,
          x1: mark.time, line: { color: colours.flag, width: 1, dash: 'dot' } })),
        annotations: marksOf(figure).map((mark, i) => ({ x: mark.time, y: 1 - 0.08 * i, yref: 'paper',
          text: mark.meaning, showarrow: false, xanchor: 'left', yanchor: 'top',
          font: { color: colours.flag, size: 11 } })) },
    });
  }

  for (const element of document.querySelectorAll('.chart[data-figure]')) {
    chart(element, build(figures.find((one) => one.name === element.dataset.figure)));
  }
})();
