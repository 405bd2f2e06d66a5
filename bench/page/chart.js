// What every page shares: the colours of the current scheme, axes, and charts that are drawn when they
// come into view and again when the scheme changes.
Object.assign(window.tautline, (() => {
  'use strict';
  // Okabe and Ito's order, darkened on light paper and lightened on dark for 3:1 against either.
  const lightColours = ['#0b62a3', '#b34700', '#00795a', '#a03a7c', '#8a6400', '#1f7fb8', '#5b3fa0',
    '#4d6b00', '#b01f3a', '#3d5a66'];
  const darkColours = ['#6cb4ee', '#f0935c', '#3ecba4', '#e58fc4', '#e0b643', '#8fd4f7', '#b5a1f2',
    '#a9cf52', '#ff8a95', '#a9c4cf'];

  function variable(name, fallback) {
    if (printing) {
      return { '--paper': '#ffffff', '--ink': '#1c1b19', '--muted': '#66625b', '--line': '#d6d1c7',
        '--accent': '#1f4e79', '--flag': '#9c3a14', '--pass': '#2c6144' }[name] || fallback;
    }
    const value = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
    return value || fallback;
  }

  /// On paper everything is light, and as wide as the paper [px].
  const paperWidth = 680;
  let printing = false;

  /// The colours of the page as it is shown now.
  function theme() {
    const dark = !printing && matchMedia('(prefers-color-scheme: dark)').matches;
    return {
      dark, printing,
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
  /// The same for a decade or two, with ticks at 2 and 5 too.
  const tickvals = [-5, -4, -3, -2, -1, 0, 1, 2].flatMap((power) => [1, 2, 5].map((one) =>
    Number((one * 10 ** power).toPrecision(1))));
  const speedAxis = (colours, more) => logAxis(colours, { tickmode: 'array', tickvals, ticktext: tickvals.map(String), ...more });

  /// Room for Plotly's bar above the curves [px].
  const barHeight = 34;

  function layoutOf(colours, layout) {
    return {
      paper_bgcolor: 'rgba(0,0,0,0)', plot_bgcolor: 'rgba(0,0,0,0)', showlegend: false,
      font: { family: colours.font, size: 13, color: colours.ink }, hovermode: 'closest',
      margin: { l: 64, r: 16, t: barHeight, b: 52 }, height: colours.printing ? 320 : 420,
      hoverlabel: { bgcolor: colours.paper, bordercolor: colours.muted,
        font: { family: colours.font, size: 13, color: colours.ink } },
      ...layout,
    };
  }

  /// A figure in the units of the report: see `inUnits` of common.js; the chapter has its own.
  const inTheseUnits = (text, figure) => (tautline.inUnits ? tautline.inUnits(text, figure.system) : text);
  function inUnits(figure) {
    const change = (text) => inTheseUnits(text, figure);
    for (const trace of figure.data) {
      trace.hovertemplate = trace.hovertemplate && change(trace.hovertemplate);
      trace.text = Array.isArray(trace.text) ? trace.text.map(change) : trace.text;
    }
    for (const [key, part] of Object.entries(figure.layout)) {
      if (/^[xy]axis\d*$/.test(key) && part.title?.text) {
        part.title.text = change(part.title.text);
      }
    }
    for (const note of figure.layout.annotations || []) {
      note.text = change(note.text);
    }
    return figure;
  }

  /// Below this width of the window a bar of buttons would be as wide as the chart [px].
  const narrow = 600;
  /// What the bar has. Saving is the business of buttons that say so.
  const barButtons = [['zoom2d', 'pan2d', 'zoomIn2d', 'zoomOut2d', 'resetScale2d']];
  /// A chart that is saved is at least this wide, and this much higher than on the page [px].
  const least = 720;
  const legendRoom = 40;

  /// Every point of every curve, with the titles of its axes: the numbers of a chart that names no others.
  function pointsOf({ data, layout }) {
    const title = (letter, name) => (layout[`${letter}axis${(name || letter).slice(1)}`]?.title?.text || letter);
    return { columns: ['curve', title('x'), 'quantity', 'value'],
      rows: data.filter((one) => one.hoverinfo !== 'skip').flatMap((one) => [...one.x].map((x, i) =>
        [one.name, x, title('y', one.yaxis), one.y[i]]).filter((row) => row[3] !== null)) };
  }

  const charts = {};
  const seen = new IntersectionObserver((entries) => {
    for (const entry of entries.filter((one) => one.isIntersecting)) {
      seen.unobserve(entry.target);
      entry.target.tautlineChart.show();
    }
  }, { rootMargin: '300px' });

  /// A chart in `element`, drawn from what `build(colours)` returns ({data, layout}, or {empty}, a
  /// sentence, if there is nothing to draw) as soon as it is near the view. `update` draws it again.
  /// `numbers` of what is built returns the {columns, rows} to save; without it they are all points.
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
    const name = (element.id || element.dataset.figure).replace(/^chart-/, '');
    const saving = tautline.saveButtons({ name: `tautline-${name}`, what: element.getAttribute('aria-label') || name,
      svg: async () => decodeURIComponent((await made.picture('svg', Math.max(least, element.clientWidth))).replace(/^[^,]*,/, '')),
      numbers: () => {
        const figure = inUnits(build(theme(), element.clientWidth));
        const { columns, rows } = figure.numbers ? figure.numbers() : pointsOf(figure);
        return tautline.csv({ columns: columns.map((one) => inTheseUnits(one, figure)), rows });
      } });
    element.after(saving);
    function draw() {
      const colours = theme();
      const figure = build(colours, printing ? paperWidth : element.clientWidth);
      note.textContent = figure.empty || figure.note || '';
      note.hidden = !note.textContent;
      body.hidden = Boolean(figure.empty);
      saving.hidden = body.hidden;
      if (figure.empty) {
        return Promise.resolve();
      }
      inUnits(figure);
      const layout = layoutOf(colours, figure.layout);
      layout.margin = { ...layout.margin, t: Math.max(layout.margin.t, barHeight) };
      return Plotly.react(body, figure.data, printing ? { ...layout, width: paperWidth } : layout,
        { responsive: !printing, displaylogo: false, displayModeBar: innerWidth < narrow || printing ? false : 'hover',
          modeBarButtons: barButtons });
    }
    const made = {
      element, body,
      update: () => (shown ? draw() : Promise.resolve()),
      show: () => { shown = true; return draw(); },
      /// The chart by itself, with its legend, for a file: `format` is svg or png. Without a `height` it is that
      /// of the page's chart.
      picture: (format, width, height) => {
        const colours = theme();
        const figure = build(colours, width);
        if (figure.empty) {
          return Promise.reject(new Error(figure.empty));
        }
        inUnits(figure);
        const layout = layoutOf(colours, figure.layout);
        const high = height || layout.height + legendRoom;
        const margin = height ? { l: 72, r: 16, t: 24, b: 72 } : { ...layout.margin, t: Math.max(layout.margin.t, legendRoom) };
        return Plotly.toImage({ data: figure.data, layout: { ...layout, width, height: high, margin,
          paper_bgcolor: colours.paper, showlegend: true,
          legend: { font: { size: 11 }, tracegroupgap: 2, ...layout.legend } } },
        { format, width, height: high, scale: format === 'png' ? 2 : 1 });
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

  // every chart is on the paper, those too that were never in view
  const forPaper = (on) => {
    printing = on;
    Object.values(charts).forEach((one) => (on ? one.show() : one.update()));
  };
  addEventListener('beforeprint', () => forPaper(true));
  addEventListener('afterprint', () => forPaper(false));

  return { theme, axis, logAxis, speedAxis, chart, charts };
})());
