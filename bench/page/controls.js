// Small parts of the page made by script: labelled selects, the legend that switches curves on and
// off, and numbers as text. Text goes in as text, never as markup: names of cases are the user's.
(() => {
  'use strict';
  const { mark, theme } = tautline;

  /// An element with attributes and children; a string child is text.
  function make(tag, attributes = {}, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
      if (name === 'on') {
        Object.entries(value).forEach(([event, action]) => element.addEventListener(event, action));
      } else if (value !== false && value !== null) {
        element.setAttribute(name, value === true ? '' : value);
      }
    }
    element.append(...children);
    return element;
  }

  /// A name that a user gave may be of any length; a control may not.
  const short = (text) => (text.length > 60 ? `${text.slice(0, 59)}\u2026` : text);

  /// A labelled select. `choices` is a list of [value, text], or {group, choices}.
  function select(label, choices, chosen, onchange) {
    const option = ([value, text]) => make('option', { value, selected: value === chosen }, short(text));
    const box = make('select', {}, ...choices.map((choice) => (Array.isArray(choice)
      ? option(choice)
      : make('optgroup', { label: choice.group }, ...choice.choices.map(option)))));
    box.addEventListener('change', () => onchange(box.value));
    const element = make('label', { class: 'choice' }, make('span', {}, label), box);
    return { element, box, get value() { return box.value; } };
  }

  /// Replaces the choices of a select and keeps the chosen one where it is still there.
  function refill(one, choices) {
    const before = one.box.value;
    one.box.replaceChildren(...choices.map(([value, text]) => make('option', { value }, short(text))));
    if (choices.some(([value]) => value === before)) {
      one.box.value = before;
    }
  }

  // unit paths of the marker symbols, within -1..1
  const outlines = {
    circle: 'M1,0A1,1,0,1,1,-1,0A1,1,0,1,1,1,0Z', square: 'M-.9-.9H.9V.9H-.9Z',
    diamond: 'M0-1.2L1.2,0L0,1.2L-1.2,0Z', 'triangle-up': 'M0-1.1L1.1,.9H-1.1Z',
    'triangle-down': 'M0,1.1L1.1-.9H-1.1Z', pentagon: 'M0-1.1L1.05-.34L.65,.9H-.65L-1.05-.34Z',
    'triangle-left': 'M-1.1,0L.9-1.1V1.1Z', 'triangle-right': 'M1.1,0L-.9-1.1V1.1Z',
    hourglass: 'M-1-1H1L-1,1H1Z', bowtie: 'M-1-1V1L1-1V1Z',
    'star-diamond': 'M0-1.35L.4-.4L1.35,0L.4,.4L0,1.35L-.4,.4L-1.35,0L-.4-.4Z',
    hexagram: 'M0-1.25L.36-.62H1.08L.72,0L1.08,.62H.36L0,1.25L-.36,.62H-1.08L-.72,0L-1.08-.62H-.36Z',
    star: 'M0-1.3L.35-.4L1.25-.4L.52,.15L.8,1.1L0,.55L-.8,1.1L-.52,.15L-1.25-.4L-.35-.4Z',
    hexagon: 'M-.55-1H.55L1.1,0L.55,1H-.55L-1.1,0Z',
    cross: 'M-.4-1.1H.4V-.4H1.1V.4H.4V1.1H-.4V.4H-1.1V-.4H-.4Z',
    x: 'M-1-.5L-.5-1L0-.5L.5-1L1-.5L.5,0L1,.5L.5,1L0,.5L-.5,1L-1,.5L-.5,0Z',
  };
  const strokes = { solid: '', dash: '6 3', dot: '2 2', dashdot: '6 2 2 2', longdash: '10 3',
    longdashdot: '10 2 2 2' };

  /// The sample of a curve: its dash with its symbol in the middle, as the charts draw them.
  function sample(engine, model) {
    const { colour, symbol, dash } = mark(engine, model);
    const { paper } = theme();
    const space = 'http://www.w3.org/2000/svg';
    const svg = document.createElementNS(space, 'svg');
    svg.setAttribute('viewBox', '-16 -7 32 14');
    svg.setAttribute('aria-hidden', 'true');
    svg.setAttribute('class', 'sample');
    const [name, open, dot] = [symbol.replace(/(-open)?(-dot)?$/, ''), /-open/.test(symbol),
      /-dot$/.test(symbol)];
    const draw = (tag, attributes) => {
      const part = document.createElementNS(space, tag);
      Object.entries(attributes).forEach(([key, value]) => part.setAttribute(key, value));
      svg.append(part);
    };
    draw('path', { d: 'M-15,0H15', stroke: colour, 'stroke-width': 1.6,
      'stroke-dasharray': strokes[dash] });
    draw('path', { d: outlines[name], transform: 'scale(4.4)', stroke: colour, 'stroke-width': 0.3,
      fill: open ? paper : colour });
    if (dot) {
      draw('circle', { r: 1.5, fill: open ? colour : paper });
    }
    return svg;
  }

  /// A legend of buttons, one line an engine, that switch models on and off everywhere; the name of
  /// an engine shows it alone. `notes` [engine/model] are set behind the names.
  function legend(element, models, notes) {
    const { filter } = tautline;
    const byEngine = new Map();
    models.forEach(({ engine, model }) => {
      byEngine.set(engine, [...(byEngine.get(engine) || []), model]);
    });
    const button = (engine, model) => make('button', { type: 'button', class: 'key', 'data-key': `${engine}/${model}`,
      'aria-pressed': String(!filter.isOff(engine, model)),
      on: { click: () => {
        filter.toggleModel(engine, model);
        element.querySelector(`[data-key="${CSS.escape(`${engine}/${model}`)}"]`)?.focus();
      } } }, sample(engine, model), model, ...(notes[`${engine}/${model}`]
      ? [make('small', {}, notes[`${engine}/${model}`])] : []));
    element.replaceChildren(...[...byEngine].map(([engine, list]) => make('div', { class: 'keys' },
      make('b', { class: 'key engine' }, engine), ...list.map((model) => button(engine, model)))));
  }

  /// A number with few digits, as the tables write it.
  const number = (value, digits = 3) => (value === null || value === undefined ? 'none'
    : (Number(value.toPrecision(digits)) || 0).toString().replace('-', '\u2212'));

  Object.assign(tautline, { make, short, select, refill, sample, legend, number });
})();
