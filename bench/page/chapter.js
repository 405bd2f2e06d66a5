// The chapter's figures, drawn from the exact motions.
(() => {
  'use strict';
  const { axis, chart } = tautline;
  const { figures } = JSON.parse(document.getElementById('chapter-data').textContent);
  const symbols = ['circle', 'square-open'];
  const hovertemplate = '<b>%{fullData.name}</b><br>%{x:.4g}, %{y:.4g}<extra></extra>';

  const line = ({ name, x, y }, color, width) => ({ type: 'scatter', mode: 'lines', name, x, y, line: { color, width },
    hovertemplate });

  const points = ({ name, x, y }, color, symbol) => ({ type: 'scatter', mode: 'markers', name, x, y,
    marker: { color, symbol, size: 5 }, hovertemplate });

  /// The extent of `values` with a margin: what is plotted fills the plot, its boundary may leave it.
  function range(values) {
    const [low, high] = [Math.min(...values), Math.max(...values)];
    const margin = 0.06 * (high - low);
    return [low - margin, high + margin];
  }

  /// An instant has its place where time is the abscissa. Its name stands on the roomier side.
  const marksOf = (figure, [left, right]) => (figure.x.startsWith('t ') ? figure.marks : []).map((mark) => ({
    ...mark, side: mark.time < (left + right) / 2 ? 'left' : 'right' }));

  function build(figure) {
    const impacts = figure.y.startsWith('vn ');
    const [xs, ys] = ['x', 'y'].map((key) => range(figure.curves.flatMap((one) => one[key])));
    const marks = marksOf(figure, xs);
    return (colours) => ({
      data: [
        ...(figure.boundary ? [line(figure.boundary, colours.muted, 3)] : []),
        ...figure.curves.map((one, i) => (impacts ? points(one, colours.engines[i], symbols[i])
          : line(one, colours.engines[i], 1.5)))],
      layout: { height: 360, showlegend: true,
        legend: { orientation: 'h', y: 1, yanchor: 'bottom', x: 0 }, margin: { l: 64, r: 16, t: 40, b: 52 },
        xaxis: axis(colours, { title: { text: figure.x }, range: xs }),
        yaxis: axis(colours, { title: { text: figure.y }, range: ys }),
        shapes: marks.map(({ time }) => ({ type: 'line', yref: 'paper', y0: 0, y1: 1, x0: time, x1: time,
          line: { color: colours.flag, width: 1, dash: 'dot' } })),
        annotations: marks.map(({ time, meaning, side }, i) => ({ x: time, y: 1 - 0.08 * i, yref: 'paper', text: meaning,
          showarrow: false, xanchor: side, yanchor: 'top', font: { color: colours.flag, size: 11 } })) },
    });
  }

  for (const element of document.querySelectorAll('.chart[data-figure]')) {
    chart(element, build(figures.find((one) => one.name === element.dataset.figure)));
  }
})();
