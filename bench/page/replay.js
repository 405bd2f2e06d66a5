// The replay of a case: the exact path and up to three runs over it. Play, scrub, step by event,
// change the speed; the keys are written beside it. Where the system asks for less motion, play goes
// from event to event.
(() => {
  'use strict';
  const { report, filter, make, select, refill, sample, number, plots, scene } = tautline;
  const { exactMotion, runMotion, eventTimes, inSpace } = tautline.motions;
  const app = document.getElementById('replay-app');
  const cases = report.cases.filter((one) => one.path && (one.path.time.steps.length > 0 || one.path.bodies?.length > 0));
  if (!app) {
    return;
  }
  if (cases.length === 0) {
    app.textContent = 'This report has no paths to replay.';
    return;
  }

  /// Slots for runs beside the exact path: more would hide each other.
  const slots = 3;
  const still = matchMedia('(prefers-reduced-motion: reduce)');
  /// With less motion, how long an event stands [ms].
  const stand = 1200;

  /// The pair of the picture at the top, where it has one.
  const hero = document.querySelector('.stills[data-case]')?.dataset ?? {};
  const home = cases.find((one) => one.name === hero.case) ?? cases[0];
  const heroRun = report.runs.find((run) => run.case === home.name && run.engine === hero.engine && run.model === hero.model
    && String(run.step) === hero.step && run.impacts);

  /// `recorded` are the motions of the case's runs, null until they came; `problem` says why they do not.
  const state = { system: home, runs: [], recorded: null, problem: '', motions: [exactMotion(home)], cable: 0, body: 0, time: 0, speed: 1, playing: false };
  let picture;
  let times = [];
  /// The next step of a play: a frame, or with less motion a timer. Pausing takes it back, or the next play has two.
  const coming = { frame: 0, timer: 0 };

  const runsOf = (system) => report.runs.filter((run) => run.case === system.name && run.impacts);
  const keyOf = (run) => `${run.engine} ${run.model} ${run.step}`;
  const end = () => state.motions[0].end;

  /// Runs to start with: that of the picture, or the one whose restitution is off the most, or the first
  /// model of the first engines, at the middle step.
  function firstRuns(system) {
    // of the filter all but its case, which is not yet this one
    const runs = runsOf(system).filter((run) => run.engine !== 'exact'
      && filter.fits({ ...run, case: tautline.address.get('case') || run.case }));
    const off = ({ e }) => (e && e[0] !== 0 && e[0] !== 2 ? Math.abs(e[2] - e[1]) : -1);
    const worst = runs.includes(heroRun) ? heroRun : [...runs].sort((a, b) => off(b) - off(a))[0];
    if (worst && (worst === heroRun || off(worst) > 0)) {
      return [keyOf(worst)];
    }
    const steps = [...new Set(runs.map((run) => run.step))].sort((a, b) => b - a);
    const middle = runs.filter((run) => run.step === steps[steps.length >> 1]);
    const engines = [...new Set(middle.map((run) => run.engine))].slice(0, 2);
    return engines.map((engine) => keyOf(middle.find((run) => run.engine === engine)));
  }

  const canvas = make('canvas', { class: 'replay-canvas', role: 'img', tabindex: '0', 'aria-label': 'the moving body' });
  /// The picture of a case in the plane or in space; with the latter, what turns it.
  const sceneOf = (system) => (inSpace(system) ? window.tautlineSpace.scene : scene);
  const again = () => picture && show(state.time, false);
  const turning = window.tautlineSpace?.install(canvas, again);
  const drawnAs = make('ul', { class: 'note replay-note' });
  const status = make('p', { class: 'replay-status', role: 'status' });
  const slider = make('input', { type: 'range', min: 0, step: 'any', 'aria-label': 'time [s]' });
  const keys = make('div', { class: 'keys' });
  const graphs = make('div', { class: 'chart', id: 'chart-replay' });
  const button = (text, label, action, id) => make('button', { type: 'button', 'aria-label': label,
    title: label, id, on: { click: action } }, text);
  const play = button('Play', 'play or pause (space)', () => toggle(), 'replay-play');

  /// The case in the live page, in reports that know where that is.
  const live = report.live_page ? make('a', { class: 'replay-live' }, 'This case in the live page') : '';
  const linkLive = () => {
    if (live) {
      live.hidden = !state.system.live; // the live page has one body in the plane
      live.setAttribute('href', `${report.live_page}#${state.system.live}`);
    }
  };

  function describe() {
    const at = (event) => Math.abs(event.time - state.time) < 1e-6;
    const told = state.motions.flatMap((one) => one.happenings.filter(at).map((event) =>
      `${one.name}: ${event.kind} of cable ${event.cables.join(' and ')}`
      + `${event.speed ? `, closing at ${number(event.speed)} m/s` : ''}`));
    return [`t = ${number(state.time, 5)} s of ${number(end(), 5)} s`, ...told, picture.words(state.time),
      ...(state.time > state.system.horizon
        ? ['beyond the horizon: what differs here says nothing about an engine'] : [])].join(' \u00b7 ');
  }

  function show(time, speak = true) {
    state.time = Math.min(end(), Math.max(0, time));
    slider.value = state.time;
    slider.setAttribute('aria-valuetext', `${number(state.time, 4)} s`);
    picture.draw(state.time, state.speed);
    graph.cursor(state.time);
    // a moving text is read out by nobody: with the play, only the time
    status.setAttribute('aria-live', speak ? 'polite' : 'off');
    status.textContent = tautline.inUnits(describe(), state.system);
    if (speak) {
      tautline.replay.changed?.();
    }
  }

  function stop() {
    state.playing = false;
    cancelAnimationFrame(coming.frame);
    clearTimeout(coming.timer);
    play.textContent = 'Play';
  }

  function frame(before) {
    return (now) => {
      show(state.time + state.speed * (now - before) / 1000, false);
      if (state.time >= end()) {
        stop();
      } else {
        coming.frame = requestAnimationFrame(frame(now));
      }
    };
  }

  function standStill() {
    toEvent(1);
    if (state.time < end()) {
      coming.timer = setTimeout(standStill, stand / state.speed);
    } else {
      stop();
    }
  }

  function toggle() {
    if (state.playing) {
      stop();
      show(state.time);
      return;
    }
    state.playing = true;
    play.textContent = 'Pause';
    if (state.time >= end()) {
      show(0);
    }
    if (still.matches) {
      standStill();
    } else {
      coming.frame = requestAnimationFrame((now) => frame(now)(now));
    }
  }

  function toEvent(direction) {
    const next = direction > 0 ? times.find((time) => time > state.time + 1e-6)
      : times.findLast((time) => time < state.time - 1e-6);
    show(next === undefined ? (direction > 0 ? end() : 0) : next);
  }

  /// How near to what it stands for a motion is drawn, and what of its impacts is not shown.
  function drawnHow(one) {
    const { error, spacing } = one.path;
    const size = tautline.nondimensional(state.system) ? number(error, 2) : `${number(1000 * error, 2)} mm`;
    const near = `within ${size} (${number(error / picture.pixel(), 1)} pixel)`;
    const count = (value) => value.toLocaleString('en');
    const [shown, all] = [one.impacts.length, one.impacts.length + one.leftOut];
    const counted = one.reference ? 'impacts' : `impacts faster than ${
      tautline.inUnits(`${number(tautline.report.options.count_speed)} m/s`, state.system)}`;
    const whole = all === 0 ? `It has no ${counted}.` : `All ${count(all)} ${counted} are shown.`;
    return `${one.name}: drawn ${near} of ${one.reference ? 'the solution' : `the run’s record, every ${
      tautline.inUnits(`${number(spacing)} s`, state.system)} and at its impacts; in between nothing is known`}. ${one.leftOut
      ? `${count(shown)} of ${count(all)} ${counted} are shown, the fastest.` : whole}`;
  }

  function tellHow() {
    const waiting = state.recorded || state.problem ? state.problem : 'The motions of the runs are being loaded.';
    const missing = state.runs.filter((key) => key && state.recorded && !state.problem
      && !state.recorded.some((run) => keyOf(run) === key));
    const told = [...state.motions.map(drawnHow), ...(waiting ? [waiting] : []),
      ...missing.map((key) => `The motion of ${key} s is not among those of this case.`)];
    drawnAs.replaceChildren(...told.map((text) => make('li', {}, text)));
  }

  /// Everything anew for the chosen case, runs and cable.
  function load() {
    const chosen = new Set(state.runs);
    state.motions = [exactMotion(state.system),
      ...(state.recorded || []).filter((run) => chosen.has(keyOf(run))).map((run) => runMotion(run, state.system))];
    times = eventTimes(state.motions);
    picture = sceneOf(state.system)(canvas, state.system, state.motions);
    turning?.show(state.system, state.motions, picture);
    slider.max = end();
    linkLive();
    app.style.setProperty('--horizon', `${Math.min(100, 100 * state.system.horizon / end())}%`);
    keys.replaceChildren(...state.motions.map((one) => make('span', { class: 'key' },
      ...(one.reference ? [make('span', { class: 'sample exact', 'aria-hidden': 'true' })]
        : [sample(one.engine, one.model)]), one.name)));
    graph.update();
    show(Math.min(state.time, end()));
    tellHow();
  }

  /// The motions of the runs of `system`, which may have to be loaded.
  async function fetchRuns(system) {
    [state.recorded, state.problem] = [null, ''];
    const came = await tautline.motions.runsOf(system).catch(() => null);
    if (system === state.system) {
      state.recorded = came || [];
      state.problem = came ? '' : `The motions of the runs are not available: ${system.motions} is missing next to this `
        + 'page. The exact motion and everything else on the page are whole.';
      load();
    }
  }

  const runChoices = () => [['', 'none'], ...runsOf(state.system).map((run) =>
    [keyOf(run), `${run.engine} ${run.model}, step ${number(run.step)} s`])];
  const cableChoices = () => Array.from({ length: state.system.cables }, (_, i) => [String(i), `cable ${i}`]);
  const bodyChoices = () => (state.system.system?.bodies ?? []).map((_, i) => [String(i), window.tautlineSpace.nameOf(state.system.system, i)]);
  const runSelects = Array.from({ length: slots }, (_, i) => select(`Run ${i + 1}`, [['', 'none']], '',
    (value) => { state.runs[i] = value; load(); }));
  const cable = select('Gap of', cableChoices(), '0', (value) => { state.cable = Number(value); load(); });
  const body = select('Turn of', bodyChoices(), '0', (value) => { state.body = Number(value); load(); });

  function choose(system) {
    state.system = system;
    [state.cable, state.body, state.time] = [0, 0, 0];
    const first = firstRuns(system);
    runSelects.forEach((one, i) => {
      refill(one, runChoices());
      one.box.value = first[i] || '';
      state.runs[i] = one.box.value;
    });
    refill(cable, cableChoices());
    refill(body, bodyChoices());
    body.element.hidden = bodyChoices().length < 2;
    const loading = fetchRuns(system);
    load();
    return loading;
  }

  const speeds = [['0.1', '\u00d7 0.1'], ['0.25', '\u00d7 0.25'], ['0.5', '\u00d7 0.5'], ['1', '\u00d7 1'],
    ['2', '\u00d7 2'], ['4', '\u00d7 4']];
  app.replaceChildren(
    make('div', { class: 'controls' },
      select('Case', cases.map((one) => [one.name, one.name]), home.name, (value) => {
        stop();
        choose(cases.find((one) => one.name === value));
      }).element, ...runSelects.map((one) => one.element)),
    keys, ...(turning ? [turning.legend] : []), canvas, slider, make('div', { class: 'horizon', 'aria-hidden': 'true' }),
    make('div', { class: 'controls replay-buttons' },
      button('Start', 'to the start (Home)', () => show(0)),
      button('\u2190 Event', 'to the event before (Shift and arrow left)', () => toEvent(-1), 'replay-before'),
      play,
      button('Event \u2192', 'to the next event (Shift and arrow right)', () => toEvent(1), 'replay-next'),
      button('End', 'to the end (End)', () => show(end())),
      select('Speed', speeds, '1', (value) => { state.speed = Number(value); }).element, cable.element, body.element,
      ...(turning ? turning.buttons : [])),
    status, live, drawnAs,
    make('p', { class: 'replay-keys' }, 'Keys: ', make('kbd', {}, 'space'), ' plays and pauses, ',
      make('kbd', {}, '\u2190'), ' ', make('kbd', {}, '\u2192'), ' move by a hundredth, with ',
      make('kbd', {}, 'Shift'), ' to the next event, ', make('kbd', {}, 'Home'), ' and ',
      make('kbd', {}, 'End'), ' go to the ends. Slack cables sag and are dashed, taut ones are straight.',
      still.matches ? ' Your system asks for less motion: play goes from event to event.' : ''),
    ...(turning ? [turning.help] : []), graphs);
  const graph = plots(graphs, state);

  app.addEventListener('keydown', (event) => {
    const tag = event.target.tagName;
    const own = { ' ': toggle, Home: () => show(0), End: () => show(end()),
      ArrowLeft: () => (event.shiftKey ? toEvent(-1) : show(state.time - end() / 100)),
      ArrowRight: () => (event.shiftKey ? toEvent(1) : show(state.time + end() / 100)) }[event.key];
    if (!own || tag === 'SELECT' || event.ctrlKey || event.altKey || event.metaKey
        || (event.key === ' ' && tag === 'BUTTON')) {
      return;
    }
    event.preventDefault();
    own();
  });
  slider.addEventListener('input', () => show(Number(slider.value)));
  new ResizeObserver(again).observe(canvas);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => picture && load());
  // drawn when it comes near the view: to measure it earlier would lay out the whole page
  const near = new IntersectionObserver((entries) => {
    if (entries.some((one) => one.isIntersecting)) {
      near.disconnect();
      performance.mark('replay wanted');
      choose(home);
      performance.measure('replay shown', 'replay wanted');
      tautline.replay.started?.();
    }
  }, { rootMargin: '300px' });
  near.observe(app);

  // on paper, four stills from the start to the end of what can be predicted
  const stills = make('div', { class: 'print-stills' });
  const stillSize = [480, 270]; // [px]
  canvas.before(stills);
  addEventListener('beforeprint', () => {
    if (!picture) {
      choose(home);
    }
    const last = Math.min(end(), state.system.horizon);
    const instants = [0, 1, 2, 3].map((part) => part * last / 3);
    const sheet = make('canvas');
    const drawing = sceneOf(state.system)(sheet, state.system, state.motions, stillSize);
    stills.replaceChildren(...instants.map((time) => {
      drawing.draw(time, state.speed);
      const text = tautline.inUnits(`t = ${number(time, 4)} s: ${drawing.words(time)}`, state.system);
      return make('figure', {}, make('img', { src: sheet.toDataURL(), alt: text }), make('figcaption', {}, text));
    }));
  });
  addEventListener('afterprint', () => stills.replaceChildren());

  // for the address, for the picture in space and for tests
  tautline.replay = { state, home, show, load, picture: () => picture, runs: () => state.runs.filter(Boolean),
    chooseCase: (name) => {
      choose(cases.find((one) => one.name === name) || home);
      app.querySelector('select').value = state.system.name;
    },
    chooseRuns: (keys) => { runSelects.forEach((one, i) => { one.box.value = keys[i] || ''; state.runs[i] = one.box.value; }); load(); } };
})();
