// The one filter of engines, for every table and chart of the page: chosen ones are shown, and all
// where none is chosen. The exact control is always there.
(() => {
  'use strict';
  const { address, make, engines, report } = tautline;
  const ran = new Set(report.runs.map((run) => run.engine));
  /// By name, which favours none.
  const choices = engines.filter((name) => name !== 'exact' && ran.has(name)).sort();

  const chosen = () => new Set(address.list('engines').filter((name) => choices.includes(name)));
  const shows = (engine) => {
    const some = chosen();
    return engine === 'exact' || some.size === 0 || some.has(engine);
  };
  function toggle(engine) {
    const some = chosen();
    if (!some.delete(engine)) {
      some.add(engine);
    }
    address.set({ engines: [...some].join(',') });
  }

  const off = () => new Set(address.list('off'));
  const isOff = (engine, model) => off().has(`${engine}/${model}`);
  function toggleModel(engine, model) {
    const some = off();
    if (!some.delete(`${engine}/${model}`)) {
      some.add(`${engine}/${model}`);
    }
    address.set({ off: [...some].join(',') });
  }

  const nav = document.querySelector('nav');
  if (nav && choices.length > 1) {
    const all = make('button', { type: 'button', on: { click: () => address.set({ engines: '' }) } }, 'all');
    const buttons = choices.map((name) => make('button', { type: 'button',
      on: { click: () => toggle(name) } }, name));
    nav.append(make('div', { class: 'engine-filter', role: 'group', 'aria-label': 'Engines shown' },
      make('span', {}, 'Engines:'), all, ...buttons));
    address.listen(() => {
      const some = chosen();
      all.setAttribute('aria-pressed', String(some.size === 0));
      buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(some.has(choices[i]))));
    }, ['engines']);
  }

  /// A select whose value is that of a key of the address.
  function bound(label, choicesOf, key, fallback = '') {
    const one = tautline.select(label, choicesOf, address.get(key) || fallback,
      (value) => address.set({ [key]: value === fallback ? '' : value }));
    address.listen(() => {
      const value = address.get(key) || fallback;
      one.box.value = [...one.box.options].some((option) => option.value === value) ? value : fallback;
    }, [key]);
    return one;
  }

  tautline.filter = { shows, toggle, isOff, toggleModel, bound, choices };
})();
