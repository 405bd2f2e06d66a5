// Where a row of a table leads: a button in it opens its replay, settings, causes and files, the
// command that repeats it, and a link to it. One dialog for all rows.
(() => {
  'use strict';
  const { report, address, make, short } = tautline;
  const folders = JSON.parse(document.getElementById('run-folders')?.textContent || 'null');

  /// A word as a shell reads it back.
  const quoted = (word) => (/^[\w./:@%+,-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);

  /// The command that repeats a run; of no case, all runs of the engine, model and step.
  const command = ({ the_case: name, engine, model, step }) => (name
    ? `tautline run ${quoted(name)} --engine ${quoted(engine)} --model ${quoted(model)} --step ${step}`
    : `tautline bench --engines ${quoted(engine)} --models ${quoted(model)} --steps ${step}`);

  /// The folder of a run's files beside the page, or none.
  function folder({ the_case: name, engine, model, step }) {
    const [at, of] = [report.cases.findIndex((one) => one.name === name),
      report.engines.findIndex((one) => one.name === engine)];
    const which = tautline.modelsOf(engine).indexOf(model);
    return folders && at >= 0 && of >= 0 && which >= 0
      ? ['runs', folders.cases[at], folders.engines[of], folders.models[of][which], step].join('/') : null;
  }

  /// A command with a button that copies it.
  function copyable(text) {
    const code = make('code', {}, text);
    const copy = make('button', { type: 'button', on: { click: async () => {
      try {
        await navigator.clipboard.writeText(text);
        copy.textContent = 'copied';
      } catch {
        getSelection().selectAllChildren(code); // not allowed here: ready for the keyboard
        copy.textContent = 'selected';
      }
    } } }, 'copy');
    return [code, copy];
  }
  document.querySelectorAll('.command').forEach((place) => place.replaceChildren(...copyable(place.textContent)));

  const dialog = make('dialog', { class: 'lead-on', 'aria-labelledby': 'lead-on-title' });
  document.body.append(dialog);
  // a click beside it closes it
  dialog.addEventListener('click', (event) => event.target === dialog && dialog.close());

  function open(row) {
    const { the_case: name, engine, model, step } = row;
    const to = (text, section, values) => make('li', {}, make('a', { href: `#${section}`, on: { click: (event) => {
      event.preventDefault();
      dialog.close();
      address.set(values, section);
    } } }, text));
    const here = { engines: engine === 'exact' ? '' : engine, step, ...(name ? { case: name } : {}) };
    const at = folder(row);
    const file = (kind) => make('a', { href: encodeURI(`${at}/${kind}`).replaceAll('#', '%23'), target: '_blank' }, kind);
    const run = report.runs.find((one) => (!name || one.case === name) && one.engine === engine && one.model === model
      && one.step === Number(step));
    dialog.replaceChildren(
      make('h2', { id: 'lead-on-title' }, short(`${engine} ${model}`), make('small', {},
        ` step ${step}${name ? `, ${short(name)}` : ', all cases'}`)),
      make('ul', {},
        ...(name && run?.impacts ? [to('its replay over the exact motion', 'replay',
          { ...here, 'replay.runs': `${engine} ${model} ${step}`, 'replay.t': '' })] : []),
        to('its impacts, one by one', 'audit', { ...here, model }),
        to('what its errors come from', 'attribution', here),
        to('its error and cost', 'error', here),
        ...(name ? [] : [to('all its runs', 'cases', { ...here, model })]),
        to('its settings', `settings-of-${engine}`, {}),
        ...(name && at ? [make('li', {}, 'its files: ', file('trajectory.csv'), ', ', file('events.csv'), ', ',
          file('settings.json'), ', ', file('result.json'))] : [])),
      make('p', {}, 'The command that repeats it:'),
      make('p', { class: 'command' }, ...copyable(command(row))),
      make('p', {}, make('button', { type: 'button', on: { click: () => dialog.close() } }, 'close')));
    dialog.showModal();
  }

  /// A button at the end of each row's name, once, when its table comes into view: thousands of
  /// buttons would make the page slow to open.
  function lead(table, columns) {
    if (!table) { return; }  // a report without runs
    const add = (body) => {
      for (const row of body.rows) {
        const first = row.cells[0];
        if (row.cells.length < columns.length || first.querySelector('.lead')) {
          continue;
        }
        const values = Object.fromEntries(columns.map((key, i) =>
          [key, row.cells[i].dataset.value ?? row.cells[i].textContent]));
        first.append(make('button', { type: 'button', class: 'lead', 'aria-label':
          `leads on from ${columns.map((key) => short(values[key])).join(' ')}`,
        on: { click: () => open({ ...values, the_case: values.case }) } }, '\u2192'));
      }
    };
    const seen = new IntersectionObserver((entries) => {
      if (entries.some((one) => one.isIntersecting)) {
        seen.disconnect();
        [...table.tBodies].filter((body) => !body.classList.contains('missing')).forEach(add);
      }
    }, { rootMargin: '200px' });
    seen.observe(table);
  }
  tautline.leadOn = { lead, command, folder, open };
  lead(document.getElementById('answers-table'), ['engine', 'model', 'step']);
  lead(document.getElementById('cases-table'), ['case', 'title', 'engine', 'model', 'step']);
})();
