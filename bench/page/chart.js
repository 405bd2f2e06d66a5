// What every page shares: the colours of the current scheme, axes, and charts that are drawn when they
// come into view and again when the scheme changes.
window.tautline = (() => {
  'use strict';
  // Okabe and Ito's order, darkened on light paper and lightened on dark for 3:1 against either.
  const lightColours = ['#0b62a3', '#b34700', '#00795a', '#a03a7c', '#8a6400', '#1f7fb8', '#5b3fa0',
    '#4d6b00', '#b01f3a', '#3d5a66'];
  const darkColours = ['#6cb4ee', '#f0935c', '#3ecba4', '#e58fc4', '#e0b643', '#8fd4f7', '#b5a1f2',
    '#a9cf52', '#ff8a95', '#a9c4cf'];

  function variable(name, fallback) {
    const value = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
    return value || fallback;
  }

  /// The colours of the page as it is shown now.
  function theme() {
    const dark = matchMedia('(prefers-color-scheme: dark)').matches;
    return {
      dark,
      paper: variable('--paper', dark ? '#16181b' : '#ffffff'),
      ink: variable('--ink', dark ? '#e6e4df' : '#1d1d1b'),
      muted: variable('--muted', dark ? '#a9a69f' : '#5a5854'),
      line: variable('--line', dark ? '#3b3e43' : '#d9d6cf'),
      accent: variable('--accent', dark ? '#8ab8e6' : '#14507f'),
      flag: variable('--flag', dark ? '#f0a060' : '#a03c00'),
      pass: variable('--pass', dark ? '#7fc99a' : '#1e6b3a'),
      font: variable('--sans', 'sans-serif'),
      engines: dark ? darkColours : lightColours,
    };
  }

  const axis = (colours, more) => ({
    color: colours.ink, gridcolor: colours.line, linecolor: colours.muted, tickcolor: colours.muted,
    zerolinecolor: colours.line, showline: true, mirror: true, ticks: 'inside', automargin: true,
    exponentformat: 'power', tickfont: { size: 12 }, ...more,
  });

  /// An axis in decades, labelled at whole powers of ten.
  const logAxis = (colours, more) => axis(colours, { type: 'log', dtick: 1, ...more });

  function layoutOf(colours, layout) {
    return {
      paper_bgcolor: 'rgba(0,0,0,0)', plot_bgcolor: 'rgba(0,0,0,0)', showlegend: false,
      font: { family: colours.font, size: 13, color: colours.ink }, hovermode: 'closest',
      margin: { l: 64, r: 16, t: 16, b: 52 }, height: 420,
      hoverlabel: { bgcolor: colours.paper, bordercolor: colours.muted,
        font: { family: colours.font, size: 13, color: colours.ink } },
      ...layout,
    };
  }

  const charts = {};
  const seen = new IntersectionObserver((entries) => {
    for (const entry of entries.filter((one) => one.isIntersecting)) {
      seen.unobserve(entry.target);
      entry.target.tautlineChart.show();
    }
  }, { rootMargin: '300px' });

  /// A chart in `element`, drawn from what `build(colours)` returns ({data, layout}, or {empty}, a
  /// sentence, where there is nothing to draw) as soon as it is near the view. `update` draws anew.
  function chart(element, build) {
    if (!window.Plotly) {
      // a build without Plotly: the page says so, and its tables say the rest
      return { element, update: () => Promise.resolve(), show: () => Promise.resolve(), body: element };
    }
    let shown = false;
    const body = document.createElement('div');
    const note = document.createElement('p');
    note.className = 'empty';
    element.replaceChildren(body, note);
    function draw() {
      const colours = theme();
      const figure = build(colours);
      note.textContent = figure.empty || figure.note || '';
      note.hidden = !note.textContent;
      body.hidden = Boolean(figure.empty);
      if (figure.empty) {
        return Promise.resolve();
      }
      return Plotly.react(body, figure.data, layoutOf(colours, figure.layout),
        { responsive: true, displaylogo: false,
          modeBarButtonsToRemove: ['select2d', 'lasso2d', 'autoScale2d'] });
    }
    const made = {
      element, body,
      update: () => (shown ? draw() : Promise.resolve()),
      show: () => { shown = true; return draw(); },
      /// The chart by itself, with its legend, for a file: `format` is svg or png.
      picture: (format, width, height) => {
        const colours = theme();
        const figure = build(colours);
        if (figure.empty) {
          return Promise.reject(new Error(figure.empty));
        }
        const layout = layoutOf(colours, figure.layout);
        return Plotly.toImage({ data: figure.data, layout: { ...layout, width, height,
          margin: { l: 72, r: 16, t: 24, b: 72 },
          paper_bgcolor: colours.paper, showlegend: true,
          legend: { font: { size: 11 }, tracegroupgap: 2, ...layout.legend } } },
        { format, width, height, scale: format === 'png' ? 2 : 1 });
      },
    };
    element.tautlineChart = made;
    charts[element.id || element.dataset.figure] = made;
    seen.observe(element);
    return made;
  }

  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
    Object.values(charts).forEach((one) => one.update());
  });

  return { theme, axis, logAxis, chart, charts };
})();
