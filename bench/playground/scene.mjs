// The picture: the path to come with its impacts, the fog, the engine's body and the exact one on their cables.

import { endOf, startOf } from "./case.mjs";

/// How long a cable flashes after an impact, and the part of the path that is drawn as a trail [s on the screen].
const FLASH = 0.16, TRAIL = 0.9;
/// An attachment this near to the length of its cable is drawn straight [-].
const STRAIGHT = 2e-3;
/// Radii of impacts: of the smallest, and what the largest adds [px].
const DOT = 1.1, MORE = 5.5;
/// Points of the path that are nearer to the last one drawn are left out [px].
const FINE = 0.8;

/// The radius of a ring with the inertia of the body.
export const gyration = ({ body: { mass, inertia } }) => Math.sqrt(inertia / mass);
/// How far the body reaches from its centre.
export const reach = (one) => Math.max(gyration(one), ...one.cables.map(({ attachment }) => Math.hypot(...attachment)));

/// What has to be in the picture: the start, the path and, unless it is a close view, the anchors.
export function extent(the_case, motion, close) {
  const r = reach(the_case), box = { left: Infinity, right: -Infinity, low: Infinity, high: -Infinity };
  const include = (x, y, by = 0) => {
    box.left = Math.min(box.left, x - by);
    box.right = Math.max(box.right, x + by);
    box.low = Math.min(box.low, y - by);
    box.high = Math.max(box.high, y + by);
  };
  if (!close) the_case.cables.forEach(({ anchor: [x, y] }) => include(x, y));
  include(...the_case.initial.position, r);
  for (let i = 0; motion && i < motion.states.length; i += 6) include(motion.states[i], motion.states[i + 1], r);
  return box;
}

/// The view that shows a box in `width` x `height` [px], with room for handles.
export function fitted({ left, right, low, high }, width, height) {
  const room = Math.min(44, 0.09 * Math.min(width, height) + 12);
  const scale = Math.min((width - 2 * room) / Math.max(right - left, 1e-9), (height - 2 * room) / Math.max(high - low, 1e-9));
  return { x: 0.5 * (left + right), y: 0.5 * (low + high), scale };
}

/// Between a place in the world and on a canvas of `width` x `height` [px].
export const toScreen = (view, width, height) => ([x, y]) => [0.5 * width + view.scale * (x - view.x), 0.5 * height - view.scale * (y - view.y)];
export const toWorld = (view, width, height) => ([px, py]) => [view.x + (px - 0.5 * width) / view.scale, view.y - (py - 0.5 * height) / view.scale];

/// In what time a velocity moves the body by the length of its arrow [s]: a part of a swing.
export const arrowTime = ({ gravity, cables }) =>
  0.35 * Math.sqrt(cables[0].length / (Math.hypot(...gravity) || cables[0].length));

/// Where the arrow of a velocity begins at least, and where it ends at rest; how far below the body its turning handle
/// hangs [px].
const RING = 16, REST = 30, STEM = 30;

const direction = ([x, y]) => {
  const size = Math.hypot(x, y);
  return size > 0 ? [x / size, y / size] : [1, 0];
};

/// The tip of the arrow of the start's velocity, in the world.
export function tipOf(the_case, { scale }) {
  const { position: [x, y], velocity } = the_case.initial, [ux, uy] = direction(velocity);
  const length = REST / scale + Math.hypot(...velocity) * arrowTime(the_case);
  return [x + ux * length, y + uy * length];
}

/// The velocity whose arrow ends at a place.
export function velocityOf(the_case, place, { scale }) {
  const d = place.map((at, k) => at - the_case.initial.position[k]);
  const speed = Math.max(0, Math.hypot(...d) - REST / scale) / arrowTime(the_case);
  return direction(d).map((part) => part * speed);
}

/// Where the handle is that turns the body at its start.
export function knobOf(the_case, { scale }) {
  const { position: [x, y], angle } = the_case.initial, r = reach(the_case) + STEM / scale;
  return [x + r * Math.sin(angle), y - r * Math.cos(angle)];
}

const sizes = new WeakMap();

/// Keeps the size of a canvas on the page, which is dear to ask for while something moves; `changed` hears of another.
export function watch(canvas, changed) {
  new ResizeObserver(() => {
    sizes.set(canvas, [canvas.clientWidth, canvas.clientHeight]);
    changed();
  }).observe(canvas);
}
export const sizeOf = (canvas) => sizes.get(canvas) ?? [0, 0];

/// A canvas of this size [px], empty, and its context in these pixels.
export function cleared(canvas, [width, height]) {
  const ratio = devicePixelRatio || 1, [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== w || canvas.height !== h) Object.assign(canvas, { width: w, height: h });
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  return context;
}

/// What does not change from frame to frame. A canvas of its own keeps it once it has been drawn a few times: while a hand
/// moves the copy would cost more than it saves.
export class Still {
  #canvas = document.createElement("canvas");
  #drawn = [];
  #times = 0;
  #kept = [];

  /// Draws by `paint(context)` what depends on `of` alone, onto `context` of this `size`.
  draw(context, size, of, paint) {
    const all = [...of, ...size, devicePixelRatio], same = (one) => all.every((each, i) => each === one[i]);
    this.#times = same(this.#drawn) ? this.#times + 1 : 0;
    this.#drawn = all;
    if (this.#times > 3 && !same(this.#kept)) {
      paint(cleared(this.#canvas, size));
      this.#kept = all;
    }
    if (same(this.#kept)) context.drawImage(this.#canvas, 0, 0, ...size);
    else paint(context);
  }
}

const parabola = (a, control, b, n) => {
  let [sum, x, y] = [0, a[0], a[1]];
  for (let i = 1; i <= n; ++i) {
    const t = i / n, u = 1 - t;
    const nx = u * u * a[0] + 2 * u * t * control[0] + t * t * b[0], ny = u * u * a[1] + 2 * u * t * control[1] + t * t * b[1];
    sum += Math.hypot(nx - x, ny - y);
    [x, y] = [nx, ny];
  }
  return sum;
};

/// The control point of a curve of this length from `a` to `b` that hangs along gravity.
function hanging(a, b, length, [gx, gy]) {
  const g = Math.hypot(gx, gy) || 1, at = (depth) => [0.5 * (a[0] + b[0]) + (depth * gx) / g, 0.5 * (a[1] + b[1]) + (depth * gy) / g];
  let [low, high] = [0, 2 * length];
  for (let i = 0; i < 18; ++i) {
    const half = 0.5 * (low + high);
    [low, high] = parabola(a, at(half), b, 12) < length ? [half, high] : [low, half];
  }
  return at(low);
}

/// Draws on `canvas`.
export class Scene {
  #canvas;
  #still = new Still();

  constructor(canvas) { this.#canvas = canvas; }

  /// `picture`: {the_case, motion, run, fog, time, speed, view, colours, impossible, still, unit}.
  draw(picture) {
    const [width, height] = sizeOf(this.#canvas), g = cleared(this.#canvas, [width, height]), to = toScreen(picture.view, width, height);
    const { the_case, motion, run, fog, time, colours, impossible, view } = picture;
    if (motion) this.#still.draw(g, [width, height], [motion, view, colours, impossible], (on) => drawPath(on, to, picture));
    if (impossible) {
      drawBody(g, to, picture, startOf(the_case), { colour: colours.hit, fill: 0.08, dash: [4, 4] }, (cable, end) =>
        (Math.hypot(end[0] - cable.anchor[0], end[1] - cable.anchor[1]) > cable.length ? { colour: colours.hit, width: 1.5, dash: [5, 4], straight: true }
          : { colour: colours.exact, width: 1 }));
    } else if (motion) {
      const veiled = Boolean(fog) && drawFog(g, to, picture);
      if (run?.at) drawBody(g, to, picture, run.at(time), { colour: colours.engine, fill: 0, dash: [5, 4] }, () => ({ colour: colours.engine, width: 1, dash: [5, 4] }));
      drawTrail(g, to, picture);
      drawExact(g, to, picture, veiled);
    }
    if (time === 0) drawStart(g, to, picture);
    for (const { anchor } of the_case.cables) drawAnchor(g, to(anchor), the_case.gravity, colours);
    drawScale(g, picture, width, height);
  }
}

/// The path and its impacts: paler where nothing is sure, and palest where it is that of another case.
function drawPath(g, to, { motion, colours, impossible, view: { scale } }) {
  const { times, states, sure } = motion, [left, top] = to([0, 0]);
  Object.assign(g, { lineWidth: 1, strokeStyle: colours.exact, fillStyle: colours.hit, lineJoin: "bevel" });
  for (const [alpha, within] of [[0.2, 0], [0.62, 1]]) {
    g.globalAlpha = impossible ? 0.15 : alpha;
    g.beginPath();
    let on = false, lastX = 0, lastY = 0;
    for (let i = 0; i < times.length; ++i) {
      const x = left + scale * states[6 * i], y = top - scale * states[6 * i + 1];
      if (sure[i] !== within) on = false;
      else if (!on) {
        g.moveTo(x, y);
        [on, lastX, lastY] = [true, x, y];
      } else if (Math.abs(x - lastX) + Math.abs(y - lastY) >= FINE) {
        g.lineTo(x, y);
        [lastX, lastY] = [x, y];
      }
    }
    g.stroke();
    g.beginPath();
    for (const { time, x, y, size } of motion.impacts) {
      if (motion.isSure(time) !== Boolean(within)) continue;
      const at = to([x, y]), radius = DOT + MORE * Math.sqrt(size / motion.largest);
      g.moveTo(at[0] + radius, at[1]);
      g.arc(...at, radius, 0, 2 * Math.PI);
    }
    g.fill();
  }
  g.globalAlpha = 1;
}

function drawCable(g, to, { anchor, length }, end, gravity, { colour, width, dash = [], straight = false }) {
  const a = to(anchor), b = to(end), scale = Math.hypot(a[0] - b[0], a[1] - b[1]) / (Math.hypot(anchor[0] - end[0], anchor[1] - end[1]) || 1);
  Object.assign(g, { strokeStyle: colour, lineWidth: width, lineCap: "round" });
  g.setLineDash(dash);
  g.beginPath();
  g.moveTo(...a);
  if (straight || !(scale > 0)) g.lineTo(...b);
  else g.quadraticCurveTo(...hanging(a, b, length * scale, [gravity[0], -gravity[1]]), ...b);
  g.stroke();
  g.setLineDash([]);
}

/// A disc with the inertia of the body, and its attachments as a bar or a plate. `look(cable, end, i)` of each cable.
function drawBody(g, to, { the_case, view, colours }, state, { colour, fill, dash = [], veiled = false }, look) {
  const ends = the_case.cables.map((cable) => endOf(cable, state)), centre = to(state);
  if (!centre.every(Number.isFinite)) return;
  the_case.cables.forEach((cable, i) => drawCable(g, to, cable, ends[i], the_case.gravity, look(cable, ends[i], i)));
  const radius = Math.max(gyration(the_case) * view.scale, 5), corners = [...new Map(the_case.cables.map((cable, i) =>
    [cable.attachment.join(), { turn: Math.atan2(cable.attachment[1], cable.attachment[0]), at: to(ends[i]) }])).values()].sort((a, b) => a.turn - b.turn);
  Object.assign(g, { strokeStyle: colour, fillStyle: colour, lineWidth: veiled ? 2.4 : 1.4, lineJoin: "round" });
  g.setLineDash(dash);
  g.beginPath();
  g.arc(...centre, radius, 0, 2 * Math.PI);
  if (fill > 0) {
    if (veiled) { // the fog does not hide it
      Object.assign(g, { fillStyle: colours.paper, globalAlpha: 0.7 });
      g.fill();
      g.fillStyle = colour;
    }
    g.globalAlpha = fill; // the path shines through
    g.fill();
    g.globalAlpha = 1;
  }
  g.stroke();
  g.setLineDash([]);
  g.lineWidth = veiled ? 3.4 : 2.4;
  g.beginPath();
  if (corners.length > 2) corners.forEach(({ at }) => g.lineTo(...at));
  else corners.forEach(({ at }) => { g.moveTo(...centre); g.lineTo(...at); });
  if (corners.length > 2) g.closePath();
  if (the_case.body.inertia > 0 && corners.every(({ at }) => Math.hypot(at[0] - centre[0], at[1] - centre[1]) < 1)) { // shows the turning
    g.moveTo(...centre);
    g.lineTo(centre[0] + radius * Math.cos(state[2]), centre[1] - radius * Math.sin(state[2]));
  }
  g.stroke();
  for (const [at, r] of [[centre, 3], ...corners.map((one) => [one.at, 2.6])]) {
    g.beginPath();
    g.arc(...at, r, 0, 2 * Math.PI);
    g.fill();
  }
}

function drawExact(g, to, picture, veiled) {
  const { the_case, motion, time, speed, colours, still } = picture;
  const state = motion.at(time), taut = motion.tautAt(time);
  const hit = (i) => (still ? 0 : motion.impacts.reduce((most, one) => (one.time <= time && time - one.time < FLASH * speed && one.impulses[i] > 0
    ? Math.max(most, 1 - (time - one.time) / (FLASH * speed)) : most), 0));
  drawBody(g, to, picture, state, { colour: colours.exact, fill: 0.14, veiled }, (cable, end, i) => {
    const flash = hit(i), gap = cable.length - Math.hypot(end[0] - cable.anchor[0], end[1] - cable.anchor[1]);
    const holds = ((taut >> i) & 1) === 1 || gap < STRAIGHT * cable.length;
    return flash > 0 ? { colour: colours.hit, width: 1.6 + 2.4 * flash, straight: holds }
      : { colour: colours.exact, width: holds ? 2.6 : 1.2, straight: holds };
  });
}

/// The way of the last moments, which fades.
function drawTrail(g, to, { motion, time, speed, colours, still }) {
  if (still || time <= 0) return;
  const { times, states } = motion, from = time - TRAIL * speed;
  Object.assign(g, { strokeStyle: colours.exact, lineWidth: 2, lineCap: "round" });
  let last = to(motion.at(Math.max(0, from)));
  const to_ = (i) => to([states[6 * i], states[6 * i + 1]]);
  for (let i = times.findIndex((one) => one > from); i >= 0 && i < times.length; ++i) {
    const now = times[i] >= time, at = now ? to(motion.at(time)) : to_(i);
    g.globalAlpha = Math.max(0, 1 - (time - Math.min(times[i], time)) / (TRAIL * speed));
    g.beginPath();
    g.moveTo(...last);
    g.lineTo(...at);
    g.stroke();
    if (now) break;
    last = at;
  }
  g.globalAlpha = 1;
}

/// The futures at `time`: each one a ring and its bar, so faint that only many are seen. While they are within a part of a
/// pixel they are behind the body. Whether they are spread over more than that.
function drawFog(g, to, { the_case, fog: { count, instants, end, poses, spread }, time, view, colours }) {
  const place = Math.min((time / end) * (instants - 1), instants - 1), i = Math.min(Math.floor(place), instants - 2), part = place - i;
  if (Math.max(spread[i], spread[i + 1]) * view.scale < FINE / 4) return false;
  const radius = Math.max(gyration(the_case) * view.scale, 5), bars = the_case.cables.filter(({ attachment }) => Math.hypot(...attachment) > 0);
  Object.assign(g, { strokeStyle: colours.exact, fillStyle: colours.exact, lineWidth: 1 });
  const rings = new Path2D(), lines = new Path2D();
  for (let one = 0; one < count; ++one) {
    const at = 3 * (one * instants + i), pose = [0, 1, 2].map((k) => poses[at + k] * (1 - part) + poses[at + 3 + k] * part);
    if (!Number.isFinite(pose[0])) continue;
    const [x, y] = to(pose);
    rings.moveTo(x + radius, y);
    rings.arc(x, y, radius, 0, 2 * Math.PI);
    for (const cable of bars) {
      lines.moveTo(x, y);
      lines.lineTo(...to(endOf(cable, pose)));
    }
  }
  g.globalAlpha = 0.2;
  g.stroke(rings);
  g.stroke(lines);
  g.globalAlpha = 1;
  return Math.max(spread[i], spread[i + 1]) * view.scale > 2;
}

/// The arrow of the velocity, and the stem of the handle that turns.
function drawStart(g, to, { the_case, view, colours }) {
  const centre = to(the_case.initial.position), tip = to(tipOf(the_case, view)), knob = to(knobOf(the_case, view));
  const [ux, uy] = direction([tip[0] - centre[0], tip[1] - centre[1]]);
  Object.assign(g, { strokeStyle: colours.ink, fillStyle: colours.ink, lineWidth: 1.8, lineCap: "round" });
  g.beginPath();
  g.moveTo(centre[0] + RING * ux, centre[1] + RING * uy);
  g.lineTo(tip[0] - 5 * ux, tip[1] - 5 * uy);
  g.stroke();
  g.beginPath();
  g.moveTo(...tip);
  g.lineTo(tip[0] - 9 * ux - 4.5 * uy, tip[1] - 9 * uy + 4.5 * ux);
  g.lineTo(tip[0] - 9 * ux + 4.5 * uy, tip[1] - 9 * uy - 4.5 * ux);
  g.fill();
  if (the_case.body.inertia === 0) return;
  const [kx, ky] = direction([knob[0] - centre[0], knob[1] - centre[1]]), r = reach(the_case) * view.scale;
  Object.assign(g, { strokeStyle: colours.exact, lineWidth: 1 });
  g.setLineDash([2, 3]);
  g.beginPath();
  g.moveTo(centre[0] + r * kx, centre[1] + r * ky);
  g.lineTo(...knob);
  g.stroke();
  g.setLineDash([]);
}

/// A nail in the wall: what pulls it points along gravity.
function drawAnchor(g, [x, y], [gx, gy], { ink, paper }) {
  const size = Math.hypot(gx, gy), [dx, dy] = size > 0 ? [gx / size, -gy / size] : [0, 1];
  Object.assign(g, { fillStyle: ink, strokeStyle: ink, lineWidth: 1.5 });
  g.beginPath();
  g.moveTo(x - 9 * dx - 7 * dy, y - 9 * dy + 7 * dx);
  g.lineTo(x - 9 * dx + 7 * dy, y - 9 * dy - 7 * dx);
  g.lineTo(x, y);
  g.fill();
  g.beginPath();
  g.arc(x, y, 3, 0, 2 * Math.PI);
  g.fillStyle = paper;
  g.fill();
  g.stroke();
}

/// A bar of a round length, and the direction of gravity where that is not down.
function drawScale(g, { view, the_case, colours, unit }, width, height) {
  const most = 90 / view.scale, power = 10 ** Math.floor(Math.log10(most)), length = [5, 2, 1].find((one) => one * power <= most) * power;
  const [x, y] = [14, height - 14], w = length * view.scale;
  Object.assign(g, { strokeStyle: colours.muted, fillStyle: colours.muted, lineWidth: 1, font: `12px ${colours.sans}`, textBaseline: "bottom", textAlign: "left" });
  g.beginPath();
  for (const [px, py] of [[x, y - 4], [x, y], [x + w, y], [x + w, y - 4]]) g.lineTo(px + 0.5, py + 0.5);
  g.stroke();
  g.fillText(`${+length.toPrecision(1)}${unit}`, x, y - 6);
  const [gx, gy] = the_case.gravity, size = Math.hypot(gx, gy);
  if (size > 0 && Math.abs(gx) < 1e-9 * size && gy < 0) return;
  const [cx, cy] = [width - 26, height - 26];
  g.textAlign = "center";
  g.textBaseline = "middle";
  if (size === 0) g.fillText("no gravity", cx - 20, cy);
  else {
    const [dx, dy] = [(16 * gx) / size, (-16 * gy) / size];
    g.beginPath();
    g.moveTo(cx - dx, cy - dy);
    g.lineTo(cx + dx, cy + dy);
    g.lineTo(cx + 0.6 * dx - 0.3 * dy, cy + 0.6 * dy + 0.3 * dx);
    g.moveTo(cx + dx, cy + dy);
    g.lineTo(cx + 0.6 * dx + 0.3 * dy, cy + 0.6 * dy - 0.3 * dx);
    g.stroke();
    g.fillText("g", cx - 0.9 * dy - 2, cy + 0.9 * dx);
  }
}
