// The engines of the first screen. Beside each sentence stand bars: the restitution that a case asks for,
// what the engine's worst model gets, and what the recommended one gets. Where the reader chose a model, a
// case or a step, sentence and bars are of these runs.
(() => {
  'use strict';
  const { report, address, filter, make, number, short } = tautline;
  const list = document.querySelector('ul.engines');
  if (!list) {
    return;
  }
  const looks = ['sound', 'problem', 'too-few-to-tell', 'problem', 'problem'];
  const more = ['', '', '', ', some lost', ', scattered'];
  const items = [...list.children].map((item) => {
    const [name, fault, advice] = ['b', '.fault', '.advice'].map((part) => item.querySelector(part));
    const bars = make('div', { class: 'bars' });
    name.after(bars);
    return { item, name, fault, advice, bars, look: name.className, said: fault.textContent, advised: advice.textContent, ...item.dataset };
  });

  /// The verdicts of the runs, from their table: [{case, engine, model, step, look, notes}].
  let verdicts = null;
  function readVerdicts() {
    const table = document.getElementById('cases-table');
    const keys = [...(table?.tHead.rows[0].cells ?? [])].map((cell) => cell.dataset.key);
    const rows = keys.includes('verdict') ? [...table.tBodies].filter((body) => body.className === '').flatMap((body) => [...body.rows]) : [];
    return rows.map((row) => {
      const text = (key) => row.cells[keys.indexOf(key)].dataset.value ?? row.cells[keys.indexOf(key)].firstChild.textContent;
      const cell = row.cells[keys.indexOf('verdict')];
      return { case: text('case'), engine: text('engine'), model: text('model'), step: Number(text('step')),
        look: cell.className.replace('verdict ', ''), notes: [...cell.childNodes].slice(1).map((one) => one.textContent).filter(Boolean) };
    });
  }

  /// What is said of the chosen runs of an engine: {look, text}.
  function saidOf({ engine, model }) {
    verdicts ??= readVerdicts();
    const runs = verdicts.filter((run) => run.engine === engine && filter.fits(run));
    const of = (look) => runs.filter((run) => run.look === look);
    const wrong = [...of('problem'), ...of('listed-problem')];
    const runsOf = (count) => `${count} ${count === 1 ? 'run' : 'runs'}`;
    if (runs.length === 0) {
      return { look: 'too-few-to-tell', text: 'No run of this choice.' };
    }
    if (wrong.length > 0) {
      const [worst] = wrong.sort((a, b) => (a.look === 'problem' ? 0 : 1) - (b.look === 'problem' ? 0 : 1)
        || (a.model === model ? 0 : 1) - (b.model === model ? 0 : 1) || a.step - b.step);
      return { look: worst.look, text: `${worst.model}${address.get('case') ? '' : ` in ${worst.case}`}${
        address.get('step') ? '' : ` at ${number(worst.step)} s`}: ${worst.notes.join('; ')}. ${
        wrong.length} of ${runsOf(runs.length)} ${wrong.length === 1 ? 'has' : 'have'} a problem.` };
    }
    const few = of('too-few-to-tell').length;
    return few === 0 ? { look: 'sound', text: `No problem found in ${runsOf(runs.length)}.` }
      : { look: 'too-few-to-tell', text: `Too few impacts to judge ${few} of ${runsOf(runs.length)}.` };
  }

  /// The first of `runs` by these numbers of theirs, the least first.
  const least = (runs, ...numbers) => [...runs].sort((a, b) => numbers.reduce((found, of) => found || of(a) - of(b), 0))[0];

  /// The runs that the bars are of: of the model that the sentence is of, and of the recommended one in the
  /// same case. What is off over all cases is shown where it is off the same way, by about as much; what is
  /// not, in a case that asks for a rebound: two bars of 0 look like an engine that does not throw back.
  function runsOf({ engine, model, use }) {
    const runs = report.runs.filter((run) => run.e && run.engine === engine && filter.fits(run));
    const wanted = runs.some((run) => run.model === model) ? model : runs[0]?.model;
    const own = runs.filter((run) => run.model === wanted);
    const [word, deviation] = report.models.find((one) => one.engine === engine && one.model === wanted)?.e ?? [];
    const off = looks[word] === 'problem' ? own.filter(({ e }) => looks[e[0]] === 'problem') : [];
    const shown = off.length > 0
      ? least(off, (run) => run.step, ({ e }) => Number(e[0] !== word),
        ({ e: [, asked, got] }) => Math.round(100 * Math.abs(got - asked - (deviation ?? -1))), ({ e }) => -e[1])
      : least(own, ({ e }) => Number(e[1] === 0), (run) => run.step, ({ e }) => e[0], ({ e }) => -e[1]);
    const other = shown && use !== wanted ? runs.find((run) => run.model === use && run.case === shown.case && run.step === shown.step) : null;
    return shown ? [shown, ...(other ? [other] : [])] : [];
  }

  function draw() {
    const some = ['model', 'case', 'step', 'off'].some(address.get);
    const shown = items.filter(({ item, engine }) => { item.hidden = !filter.shows(engine); return !item.hidden; })
      .map((one) => ({ ...one, runs: runsOf(one) }));
    const longest = Math.max(1, ...shown.flatMap(({ runs }) => runs.flatMap(({ e }) => [e[1], e[2]])));
    /// With two digits behind the point: what is less is rounding.
    const told = (value) => String(Number(value.toFixed(2)) || 0);
    const bar = (text, value, look, rest = '') => [make('span', {}, text),
      make('span', { class: `bar ${look}` }, make('i', { style: `width:${100 * value / longest}%` })),
      make('span', { class: 'n' }, told(value) + rest)];
    for (const one of shown) {
      const { runs: [first, ...others], bars } = one;
      bars.replaceChildren(...(first ? [make('span', { class: 'head' }, `Restitution in ${short(first.case)}, median, step ${number(first.step)} s`),
        ...bar('asked', first.e[1], 'asked'), ...[first, ...others].flatMap(({ model, e }) => bar(model, e[2], looks[e[0]], more[e[0]]))]
        : [make('span', { class: 'head' }, 'No case here asks for one restitution that can be read.')]));
      const { look, text } = some ? saidOf(one) : { look: one.look.replace('verdict ', ''), text: one.said };
      one.name.className = `verdict ${look}`;
      one.fault.textContent = text;
      one.advice.textContent = some ? `Of all cases and steps: ${one.advised}` : one.advised;
    }
  }
  address.listen(draw, filter.keys);
})();
