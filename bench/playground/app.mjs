// The page: what is asked of the workers, what is drawn, and what a hand changes.

import { Asker } from "./asker.mjs";
import { changedName, inUnits, readState, SPEEDS, spellState, view } from "./case.mjs";
import { Chart, heightOf, spreadAt } from "./chart.mjs";
import { formsOf } from "./exports.mjs";
import { motionOf, runOf } from "./motion.mjs";
import { Pane } from "./pane.mjs";
import { make, Panel } from "./panel.mjs";
import { allow, pluck } from "./sound.mjs";
import { atInstant, sentences, short } from "./words.mjs";

const FUTURES = 150;
/// What is not the motion itself waits until a hand has stopped for this time: how far it is sure, and the fog, which keeps
/// a whole processor busy. The engine runs at most once in it [ms].
const REST = 60;
/// With less motion, how long an event is shown [ms].
const EVENT_TIME = 700;
/// The address and what is read out follow a change after this time [ms].
const CALM = 350;

const $ = (id) => document.getElementById(id);
const lessMotion = matchMedia("(prefers-reduced-motion: reduce)");

let { state, problem, stays } = readState(location.hash, CASES);
/// The motion that is shown, and the case that it is of; `impossible` is the sentence on another one that has none.
let motion, run, fog, impossible, possible;
let colours, playing = false, resume = false, sound = false;
/// Another case than before: the view and the sliders fit it as soon as its motion is there.
let fresh = true, held = false;
let engines = [], version = "";

const page = {
  shipped: CASES, get state() { return state; }, get motion() { return motion; }, get engines() { return engines; },
  get impossible() { return impossible; },
  units: (unit) => units(unit), draw: () => requestDraw(), address: () => spellState({ ...view, the_case: state.the_case }, CASES),
  picture: () => ({ ...picture(), the_case: state.the_case }), grab, change, drop, cancel, set, say,
  open: (text, name) => solver.ask({ what: "read", text, name }, opened),
};
page.forms = formsOf(page);
const units = (unit) => inUnits(state.the_case, unit);
const chart = new Chart($("chart"), requestDraw), panel = new Panel($("panel"), page);
const panes = [new Pane($("far"), false, page), new Pane($("near"), true, page)];

// ---- what is asked

const cannotRun = (what) => (message) => tellProblem(problem = `This browser cannot run ${what}: ${message}`);
const solver = new Asker(SOLVER_SOURCE, { started: (data) => ({ version } = data), failed: cannotRun("the solver") });
const fogger = new Asker(SOLVER_SOURCE, { started: () => {}, failed: cannotRun("the solver") });
const runner = new Asker(ENGINES_SOURCE, { failed: cannotRun("the engines"), pace: REST, started: (data) => {
  ({ engines } = data);
  panel.engines(engines);
  panel.show(state, units, false);
  tellParts();
} });

async function loadSolver() {
  const bytes = Uint8Array.from(atob($("wasm").textContent), (one) => one.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  const module = await WebAssembly.compile(await new Response(stream).arrayBuffer());
  solver.say({ module });
  fogger.say({ module });
}

let rest = 0;
/// Asks for the motion of the state's case. `since` is the time of the hand's move that asks.
/// `whole`: with how far it is sure. `nudge`: what cannot be leaves the case as it was.
function ask({ moving = false, whole = !moving, nudge = false, since } = {}) {
  const { the_case, law } = state;
  clearTimeout(rest);
  if (!whole) rest = setTimeout(() => ask({ moving, whole: true }), REST);
  solver.ask({ what: "solve", the_case, law, whole }, (answer) => {
    if (answer.problems) {
      if (nudge && possible) state = { ...state, the_case: possible };
      else impossible = answer.problems[0];
      tellProblem(answer.problems.join("; "), Boolean(possible) && !moving && !nudge);
    } else {
      [impossible, possible] = [undefined, the_case];
      tellProblem(problem);
      show(motionOf(the_case, answer), moving, whole);
    }
    draw();
    measure("drag to picture", since);
    if (answer.problems || !moving) panel.show(state, units, false);
  });
}

function show(next, moving, whole) {
  const others = next.the_case.cables.length !== motion?.the_case.cables.length;
  motion = next;
  if (others || fresh) [run, fog] = [undefined, undefined];
  state.time = Math.min(state.time, motion.end);
  askEngine();
  if (whole) askFog();
  arrange();
  if (fresh) {
    fresh = false;
    panes.forEach((pane) => pane.fit());
    panel.show(state, units, true);
  } else if (!moving) {
    panes.forEach((pane) => pane.glide(lessMotion.matches));
  }
  tell(moving);
}

function askEngine() {
  if (state.model === "") return;
  const { the_case, end } = motion, { engine, model, rate, law } = state;
  runner.ask({ the_case, engine, model, rate, law, end }, (answer) => {
    if (state.model === "" || the_case.cables.length !== motion.the_case.cables.length) return;
    run = answer.states ? { ...runOf(the_case, answer), engine, model } : { refused: answer.refused };
    tellKey();
    requestDraw();
  });
}

function askFog() {
  if (!state.fog) return;
  const { the_case, end } = motion, { law, apart } = state, since = performance.now();
  fogger.ask({ what: "fog", the_case, law, apart, end, count: FUTURES }, (answer) => {
    if (!state.fog || answer.problems) return;
    fog = answer;
    arrange();
    draw();
    measure("fog", since);
    tellParts();
  });
}

/// For the tests, and for who opens the browser's tools.
function measure(name, start) {
  if (start === undefined) return;
  if (performance.getEntriesByName(name).length > 500) performance.clearMeasures(name);
  performance.measure(name, { start, end: performance.now() });
}

// ---- what is drawn

/// What is drawn: the case of the motion, and not the one that is asked for, unless that has none.
function picture() {
  return { the_case: impossible || !motion ? state.the_case : motion.the_case, motion, run: state.model === "" ? undefined : run, foggy: state.fog, fog: state.fog ? fog : undefined, time: impossible ? 0 : state.time, speed: state.speed,
    colours, impossible, unit: units, still: lessMotion.matches };
}

let due = 0;
function requestDraw() {
  due ||= requestAnimationFrame(() => draw());
}

function draw() {
  cancelAnimationFrame(due);
  due = 0;
  const now = picture();
  for (const pane of panes) pane.draw({ ...now, unit: units("m") }, state.the_case);
  chart.draw(now);
  if (!motion) return;
  const slider = $("time");
  $("speed").value = state.speed;
  slider.max = motion.end;
  slider.value = state.time;
  slider.setAttribute("aria-valuetext", `t = ${short(state.time)}${units("s")}`);
  $("clock").textContent = `t = ${state.time.toFixed(motion.end < 10 ? 3 : 2)}${units("s")}`;
  $("apart-now").textContent = now.fog ? `futures ${short(spreadAt(fog, state.time), 2)}${units("m")} apart` : "";
}

/// The height of the chart follows what is in it, or will be soon: the picture above must not move under a hand.
function arrange() {
  const height = heightOf(motion.the_case.cables.length, state.fog);
  const pixels = `${height}px`;
  if ($("chart").style.height !== pixels) $("chart").style.height = pixels;
}

// ---- what is said

let calm = 0;
function tell(moving) {
  const said = sentences(motion);
  $("words").replaceChildren(make("b", {}, said[0]), ` ${said.slice(1).join(" ")}`);
  tellKey();
  tellParts();
  clearTimeout(calm);
  calm = setTimeout(() => {
    $("spoken").textContent = said.join(" ");
    keepAddress();
  }, moving ? 4 * CALM : CALM);
}

function say(text) { $("spoken").textContent = text; }

/// A sentence on what cannot be, with a way back if there is one.
function tellProblem(sentence, back = false) {
  const box = $("problem");
  box.hidden = !sentence;
  if (!sentence || box.dataset.said === sentence + back) return;
  box.dataset.said = sentence + back;
  box.replaceChildren(make("span", {}, sentence), ...(back ? [make("button", { type: "button", class: "plain", click: cancel }, "Back to what was")] : []));
}

function tellKey() {
  const sample = (kind) => make("i", { class: `sample ${kind}`, "aria-hidden": "true" });
  const entries = [["exact", "exact"], ...(state.model === "" ? [] : [["engine", run?.refused ? `${state.engine} ${state.model}: ${run.refused}` : `${state.engine} ${state.model}, step 1/${state.rate} s`]]),
    ["hit", "an impact, sized by its impulse"], ["taut", "taut"], ...(motion && motion.horizon < Infinity ? [["shade", "no digit is sure"]] : [])];
  const text = entries.map(([, name]) => name).join();
  if ($("key").dataset.text === text) return;
  $("key").dataset.text = text;
  $("key").replaceChildren(...entries.map(([kind, name]) => make("li", {}, sample(kind), name)));
}

function tellParts() {
  if (!motion) return;
  const ms = (value) => `${value < 10 ? value.toFixed(2) : value.toFixed(0)} ms`;
  $("parts").textContent = `Exact motion in ${ms(motion.took)}${fog ? `, ${fog.count} futures in ${ms(fog.took)}` : ""}${run?.took === undefined ? "" : `, ${run.steps.toLocaleString("en")} steps of ${state.engine} in ${ms(run.took)}`}.`;
  $("versions").textContent = `tautline ${version}${engines.map((one) => `, ${one.name} ${one.version}`).join("")}`;
}

/// A link shows the instant that is looked at, and plays if there is none.
const addressNow = () => `#${spellState({ ...state, time: playing || state.time >= motion.end ? 0 : state.time }, CASES)}`;

/// The address that the page last wrote or read.
let known = location.hash;

/// The address of what is seen, without a step of the history.
function keepAddress() {
  if (held || impossible || !motion) return;
  if (location.hash !== known) return; // a link that was followed is about to be heard of
  const address = addressNow();
  if (address === known) return;
  known = address;
  history.replaceState(null, "", address);
  panel.showExport();
}

// ---- what a hand changes

/// Takes hold of the start; `here`: the body where it is now.
function grab(here) {
  if (!held) resume = playing;
  held = true;
  panes.forEach((pane) => pane.hold());
  stop();
  const at = here && state.time > 0 && motion ? motion.at(state.time) : undefined;
  state.time = 0;
  if (at) {
    change((one) => {
      const [x, y, angle] = at;
      Object.assign(one.initial, { position: [x, y], angle: Number(angle.toFixed(4)) });
      one.cables.forEach((cable) => delete cable.taut);
    }, { moving: true });
  } else draw();
}

/// A changed copy of the case, solved. `moving`: more changes follow until `drop`. `nudge` and `since` as of `ask`.
function change(edit, { moving = false, nudge = false, since } = {}) {
  const the_case = structuredClone(state.the_case);
  edit(the_case);
  the_case.name = changedName(the_case.name);
  problem = undefined;
  state = { ...state, the_case };
  if (nudge) [held, resume] = [false, false];
  ask({ moving, nudge, since });
  if (moving) panel.show(state, units, false);
}

/// The hand lets go: what is impossible goes back to what was possible.
function drop() {
  held = false;
  if (impossible && possible) state = { ...state, the_case: possible };
  ask({ nudge: true }); // the last move may not have been answered yet
  if (resume) play();
  resume = false;
}

function cancel() {
  held = false;
  if (possible) state = { ...state, the_case: possible };
  ask();
}

/// Other settings of the page.
function set({ engineModel, ...values }) {
  if (engineModel !== undefined) [values.engine, values.model] = engineModel === "" ? [state.engine, ""] : engineModel.split("/");
  state = { ...state, ...values };
  if (problem) { // of an address that this changes
    problem = undefined;
    tellProblem(impossible);
  }
  if ("speed" in values) keepAddress();
  else if ("law" in values) ask();
  else if (motion) {
    if ("fog" in values || "apart" in values) {
      fog = undefined;
      askFog();
    } else {
      run = undefined;
      askEngine();
    }
    arrange();
    tell(false);
    requestDraw();
  }
  panel.show(state, units, false);
}

/// A case from a file.
function opened({ the_case, problems }) {
  if (problems) return tellProblem(problems.join("; "));
  return load({ state: { ...state, the_case, time: 0 } });
}

/// Another state, as an address or a file has it.
function load(read) {
  ({ state, problem, stays } = read);
  [fresh, possible, impossible] = [true, undefined, undefined];
  stop();
  draw(); // the instant is another one at once
  panel.show(state, units, true);
  ask();
  if (!stays && !lessMotion.matches) play();
}

// ---- time

let frame = 0, timer = 0;
const button = $("play");

function stop() {
  playing = false;
  cancelAnimationFrame(frame);
  clearTimeout(timer);
  button.textContent = "Play";
  button.setAttribute("aria-pressed", "false");
}

function play() {
  stop();
  playing = true;
  button.textContent = "Pause";
  button.setAttribute("aria-pressed", "true");
  if (motion && state.time >= motion.end) state.time = 0;
  if (lessMotion.matches) {
    standStill();
    return;
  }
  let before = performance.now();
  const step = (now) => {
    if (!playing) return;
    if (motion && !impossible) {
      const from = state.time;
      state.time = Math.min(motion.end, from + (state.speed * Math.min(100, Math.max(0, now - before))) / 1000);
      if (sound) ring(from, state.time);
      draw();
      if (state.time >= motion.end) return goTo(motion.end);
    }
    before = now;
    frame = requestAnimationFrame(step);
    return undefined;
  };
  frame = requestAnimationFrame(step);
}

function ring(from, to) {
  for (const { time, cables, size } of motion.impacts) {
    if (time > from && time <= to) pluck(size / motion.largest, cables[0]);
  }
}

/// With less motion a play goes from event to event.
function standStill() {
  if (!playing) return;
  if (motion) {
    state.time = nextEvent(1);
    draw();
    if (state.time >= motion.end) return goTo(motion.end);
  }
  timer = setTimeout(standStill, EVENT_TIME / state.speed);
  return undefined;
}

const nextEvent = (direction) => (direction > 0 ? motion.moments.find((one) => one > state.time + 1e-9) ?? motion.end
  : motion.moments.findLast((one) => one < state.time - 1e-9) ?? 0);

/// Shows an instant, and stays there.
function goTo(time) {
  if (!motion) return;
  stop();
  state.time = Math.min(motion.end, Math.max(0, time));
  draw();
  clearTimeout(calm);
  calm = setTimeout(() => {
    say(atInstant(motion, state.time));
    keepAddress();
  }, CALM);
}

button.addEventListener("click", () => (playing ? goTo(state.time) : play()));
$("start").addEventListener("click", () => goTo(0));
$("before").addEventListener("click", () => motion && goTo(nextEvent(-1)));
$("after").addEventListener("click", () => motion && goTo(nextEvent(1)));
$("time").addEventListener("input", ({ target }) => goTo(target.valueAsNumber));
// on a narrow page one view at a time
$("close").addEventListener("click", () => {
  const close = $("scene").classList.toggle("close");
  $("close").setAttribute("aria-pressed", String(close));
});
new ResizeObserver(() => panes[1].repeat($("near").clientWidth > 0 && $("far").clientWidth > 0)).observe($("near"));
$("speed").append(...SPEEDS.map((one) => make("option", { value: one }, `× ${one}`)));
$("speed").addEventListener("change", ({ target }) => set({ speed: Number(target.value) }));
$("sound").addEventListener("change", ({ target }) => {
  sound = target.checked;
  if (sound) allow();
});
for (const kind of ["pointerdown", "pointermove"]) {
  $("chart").addEventListener(kind, (event) => {
    if (!motion || !(event.buttons & 1)) return;
    if (kind === "pointerdown") $("chart").setPointerCapture(event.pointerId);
    goTo(chart.timeAt(event.offsetX, motion.end));
  });
}
addEventListener("keydown", (event) => {
  if (event.key !== " " || /^(BUTTON|INPUT|SELECT|TEXTAREA|SUMMARY|A)$/.test(event.target.tagName)) return;
  event.preventDefault();
  button.click();
});

// ---- the page

addEventListener("hashchange", () => {
  if (location.hash === known) return;
  known = location.hash;
  load(readState(known, CASES));
});
function retheme() {
  const style = getComputedStyle(document.documentElement);
  colours = Object.fromEntries(["ink", "paper", "muted", "line", "shade", "exact", "engine", "hit", "sans"].map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
  requestDraw();
}
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", retheme);

retheme();
panel.show(state, units, true);
loadSolver().catch(({ message }) => cannotRun("the solver")(message));
load({ state, problem, stays });
// for the tests, and for who opens the browser's tools
globalThis.playground = page;
