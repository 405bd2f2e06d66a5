// Sorting and filtering of the page's tables. What the tables say stands in the page without this; the
// order and the filters are part of the address, so that a view can be passed on. Case, step, model and
// engines are those of the whole page.
(() => {
  'use strict';
  const { address, filter, make } = tautline;
  /// More rows than this are folded: see most_open_rows of bench/report.
  const most = 40;

  // headings in the order of the columns, whatever row they stand in
  const headings = (table) => {
    const [upper, lower] = [...table.tHead.rows].map((row) => [...row.cells]);
    return upper.flatMap((cell) => (cell.scope === 'colgroup' ? lower.splice(0, cell.colSpan) : [cell]));
  };

  // each row once: its cells by the columns' keys, as numbers where they have one
  const read = (table, keys) => [...table.tBodies].map((body) => ({
    body,
    rows: [...body.rows].map((row) => {
      const values = {};
      [...keys.keys()].forEach((key, index) => {
        const cell = row.cells[index];
        // a number that is shown in full stands in its cell alone
        const shown = cell?.className === 'n' && Number.isFinite(Number(cell.textContent)) ? cell.textContent : undefined;
        const value = cell?.dataset.value ?? shown;
        const spread = (cell?.colSpan ?? 2) > 1;
        values[key] = spread || value === '' ? null : value === undefined ? cell.textContent : Number(value);
      });
      return { row, values, text: row.textContent.toLowerCase() };
    }),
  }));

  const compare = (one, two) => (typeof one === 'number' && typeof two === 'number'
    ? one - two : String(one).localeCompare(String(two), 'en', { numeric: true }));

  // Rows keep their body: the control stays apart, and engines that are missing stay last.
  function order(bodies, key, descending) {
    for (const { body, rows } of bodies.filter((one) => !one.body.classList.contains('missing'))) {
      const sorted = [...rows];
      if (key) {
        sorted.sort((a, b) => {
          const [one, two] = [a.values[key], b.values[key]];
          if (one === null || two === null) {
            return (one === null) - (two === null); // none is last, either way
          }
          return descending ? compare(two, one) : compare(one, two);
        });
      }
      body.append(...sorted.map(({ row }) => row));
    }
  }

  /// Shows the rows that fit and counts them; the control fits whatever engine, model or word.
  function filtered(bodies, by, text) {
    const words = text.toLowerCase().split(/\s+/).filter(Boolean);
    let [shown, all] = [0, 0];
    for (const { body, rows } of bodies) {
      const [apart, missing] = [body.classList.contains('control'), body.classList.contains('missing')];
      for (const { row, values, text: own } of rows) {
        const of = Object.fromEntries((missing ? ['engine'] : by).filter((key) => key in values).map((key) => [key, values[key]]));
        const hidden = !(filter.fits(of) && (apart || missing || words.every((word) => own.includes(word))));
        if (row.hidden !== hidden) {
          row.hidden = hidden;
        }
        if (!apart && !missing) {
          all += 1;
          shown += hidden ? 0 : 1;
        }
      }
    }
    return { shown, all };
  }

  /// `by` are the keys of the page's filter that its rows are chosen by; it has inputs for the `shared` ones.
  function setUp(table, name, by, shared = []) {
    if (!table) {
      return;
    }
    const keys = new Map(headings(table).map((cell) => [cell.dataset.key, cell]));
    const bodies = read(table, keys);
    const fold = table.closest('details');
    const inputs = new Map();
    const state = () => Object.fromEntries([...shared.map((key) => [key, address.get(key)]),
      ...['sort', 'order', 'text'].map((key) => [key, address.get(`${name}.${key}`)])]);
    const place = (key) => (shared.includes(key) ? key : `${name}.${key}`);
    const change = (part) => address.set(Object.fromEntries(Object.entries(part)
      .map(([key, value]) => [place(key), value])));

    const count = make('output');
    const reset = make('button', { type: 'button', on: { click: () => {
      filter.clear();
      change({ text: '' });
    } } }, 'show all');
    const bar = make('div', { class: 'filters' });
    for (const key of shared) {
      const values = [...new Set(bodies.filter(({ body }) => body.className === '')
        .flatMap(({ rows }) => rows.map((row) => String(row.values[key]))))];
      const input = make('select', { name: key, on: { change: () => change({ [key]: input.value }) } },
        new Option('all', ''), ...values.map((value) => new Option(value, value)));
      inputs.set(key, input);
      bar.append(make('label', {}, key, input));
    }
    const search = make('input', { type: 'search', name: 'text', on: { input: () => change({ text: search.value }) } });
    inputs.set('text', search);
    bar.append(make('label', {}, 'text', search), count, reset);
    if (shared.length > 0) {
      (fold ?? table.parentElement).before(bar); // a short table needs none
    }

    for (const [key, cell] of keys) {
      if (key) {
        const button = make('button', { type: 'button' }, ...cell.childNodes);
        cell.append(button);
        // once up, once down, then as it was
        button.addEventListener('click', () => {
          const { sort, order: way } = state();
          change(sort !== key ? { sort: key, order: 'ascending' }
            : way === 'ascending' ? { sort: key, order: 'descending' } : { sort: '', order: '' });
        });
      }
    }

    let before = {};
    let seen = '';
    let byHand = false;
    fold?.querySelector('summary').addEventListener('click', () => { byHand = !fold.open; });
    address.listen(() => {
      const now = state();
      for (const [key, input] of inputs) {
        if (input !== document.activeElement || input.value !== (now[key] ?? '')) {
          input.value = now[key] ?? '';
        }
      }
      if (now.sort !== before.sort || now.order !== before.order) {
        if (before.sort !== undefined || now.sort) {
          order(bodies, now.sort, now.order === 'descending');
        }
        for (const [key, cell] of keys) {
          if (key === now.sort) {
            cell.setAttribute('aria-sort', now.order || 'ascending');
          } else {
            cell.removeAttribute('aria-sort');
          }
        }
      }
      before = now;
      const filters = JSON.stringify([now, ...filter.keys.map(address.get)]);
      if (filters === seen) {
        return;
      }
      seen = filters;
      const { shown, all } = filtered(bodies, by, now.text ?? '');
      count.textContent = shown === all ? `${all} rows` : `${shown} of ${all} rows`;
      reset.hidden = shown === all;
      if (fold) {
        fold.querySelector('summary').textContent = shown === all ? `All ${all} rows` : `${shown} of ${all} rows`;
        // a few rows need no fold; many are as the reader left them
        const rows = [...table.tBodies].flatMap((body) => [...body.rows]).filter((row) => !row.hidden).length;
        fold.open = (shown > 0 && rows <= most) || byHand;
      }
    });
  }

  // what is of all cases or of all steps is not chosen by them: filter.js says so
  const models = ['engine', 'model'];
  const setups = [...models, 'step'];
  for (const [id, name, by, shared] of [['scorecards-table', 'engines', models], ['slopes-table', 'slopes', models],
    ['attribution-table', 'causes', setups], ['distributions-table', 'settling', setups],
    ['answers-table', 'answers', setups, ['step', 'model']],
    ['cases-table', 'cases', [...setups, 'case'], ['case', 'step', 'model']],
    ['steps-table', 'steps', ['case']], ['certified-table', 'trust', ['case']]]) {
    setUp(document.getElementById(id), name, by, shared);
  }
})();
