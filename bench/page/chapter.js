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

  /// An instant has its place where time is the abscissa.
  const marksOf = (figure) => (figure.x.startsWith('t ') ? figure.marks : []);

  const markLine = ({ time, meaning }, [low, high], color) => ({ type: 'scatter', mode: 'lines', name: meaning,
    x: [time, time], y: [low, high], line: { color, width: 1.5, dash: 'dot' },
    hovertemplate: '<b>%{fullData.name}</b><br>%{x:.4g}<extra></extra>' });

  function build(figure) {
    const impacts = figure.y.startsWith('vn ');
    const [xs, ys] = ['x', 'y'].map((key) => range(figure.curves.flatMap((one) => one[key])));
    return (colours) => ({
      data: [
        ...(figure.boundary ? [line(figure.boundary, colours.muted, 3)] : []),
        ...figure.curves.map((one, i) => (impacts ? points(one, colours.engines[i], symbols[i])
          : line(one, colours.engines[i], 1.5))),
        ...marksOf(figure).map((mark) => markLine(mark, ys, colours.flag))],
      layout: { height: 360, showlegend: true,
        legend: { orientation: 'h', y: 1, yanchor: 'bottom', x: 0 }, margin: { l: 64, r: 16, t: 40, b: 52 },
        xaxis: axis(colours, { title: { text: figure.x }, range: xs }),
        yaxis: axis(colours, { title: { text: figure.y }, range: ys }) },
    });
  }

  for (const element of document.querySelectorAll('.chart[data-figure]')) {
    chart(element, build(figures.find((one) => one.name === element.dataset.figure)));
  }
})();
