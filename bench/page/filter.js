// The one filter, for every table, chart and sentence of the page: engines, a model, a case, a step, and
// the models that a legend has switched off. Chosen ones are shown, and all where none is chosen. The
// exact control is always there. What is of all cases or steps by its nature says so.
(() => {
  'use strict';
  const { address, make, engines, report } = tautline;
  const ran = new Set(report.runs.map((run) => run.engine));
  const choices = engines.filter((name) => name !== 'exact' && ran.has(name)).sort();
  const keys = ['engines', 'model', 'case', 'step', 'off'];

  const chosen = () => new Set(address.list('engines').filter((name) => choices.includes(name)));
  const shows = (engine) => {
    const some = chosen();
    return engine === undefined || engine === 'exact' || some.size === 0 || some.has(engine);
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

  /// Whether a row is among what is chosen: by its engine, model, case and step, as far as it has them.
  const chooses = (row) => shows(row.engine) && ['model', 'case', 'step'].every((key) => {
    const wanted = address.get(key);
    return !wanted || row[key] === undefined || (key === 'model' && row.engine === 'exact') || String(row[key]) === wanted;
  });
  /// The same, and its model is not switched off.
  const fits = (row) => chooses(row) && !isOff(row.engine, row.model);
  const clear = () => address.set(Object.fromEntries([...keys, 'replay.runs', 'replay.t'].map((key) => [key, ''])));

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

  tautline.filter = { shows, chooses, fits, keys, clear, isOff, toggleModel, choices };

  const distinct = (key) => [...new Set(report.runs.map((run) => run[key]))];
  const nav = document.querySelector('nav');
  if (nav && choices.length > 0) {
    const all = make('button', { type: 'button', on: { click: () => address.set({ engines: '' }) } }, 'all');
    const buttons = choices.map((name) => make('button', { type: 'button',
      on: { click: () => toggle(name) } }, name));
    const models = [...new Set(report.runs.filter((run) => run.engine !== 'exact').map((run) => run.model))];
    const text = (values) => [['', 'all'], ...values.map((value) => [String(value), String(value)])];
    const one = (label, values, key) => (values.length > 1 ? [bound(label, text(values), key).element] : []);
    const reset = make('button', { type: 'button', on: { click: clear } }, 'show all');
    nav.append(make('div', { class: 'page-filter', role: 'group', 'aria-label': 'What the page shows' },
      ...(choices.length > 1 ? [make('div', { class: 'engine-filter', role: 'group', 'aria-label': 'Engines shown' },
        make('span', {}, 'Engines:'), all, ...buttons)] : []),
      ...one('Model', models, 'model'), ...one('Case', report.cases.map((row) => row.name), 'case'),
      ...one('Step [s]', distinct('step').sort((a, b) => b - a), 'step'), reset));
    address.listen(() => {
      const some = chosen();
      all.setAttribute('aria-pressed', String(some.size === 0));
      buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(some.has(choices[i]))));
      reset.hidden = keys.every((key) => !address.get(key));
    }, keys);
  }

  // what is over all cases or steps whatever is chosen
  for (const [id, of] of Object.entries({ 'scorecards-table': ['case', 'step'], 'answers-table': ['case'],
    'slopes-table': ['case', 'step'], 'attribution-table': ['case'], 'chart-cost': ['step'], 'chart-step': ['step'] })) {
    const element = document.getElementById(id);
    if (element) {
      const note = make('p', { class: 'note of-all' });
      const place = element.closest('.table-box') ?? element;
      (element.closest('details') ?? place).before(note);
      address.listen(() => {
        const set = of.filter((key) => address.get(key));
        note.hidden = set.length === 0;
        note.textContent = `This ${element.tagName === 'TABLE' ? 'table' : 'chart'} is of all ${set.map((key) => `${key}s`).join(' and ')}, `
          + `whichever ${set.join(' and ')} you chose.`;
      }, of);
    }
  }

  Object.assign(tautline.filter, { bound });
})();
