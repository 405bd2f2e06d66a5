// The chart under the picture: energy, the spread of the fog and a strip for each cable over one axis of time.

import { cleared, sizeOf, Still, watch } from "./scene.mjs";

/// Heights [px] and margins of the plot, which the slider of the time shares.
const ENERGY = 132, SPREAD = 46, STRIP = 20, AXIS = 24, GAP = 14, TOP = 10;
export const MARGIN = { left: 66, right: 16 };

export const heightOf = (cables, fog) => TOP + ENERGY + (fog ? GAP + SPREAD : 0) + GAP + cables * STRIP + AXIS;

/// Round numbers from `low` to `high`, about `count` of them.
function ticks(low, high, count) {
  const rough = (high - low) / count, power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find((one) => one * power >= rough * 0.999);
  const all = [];
  const first = Math.ceil(low / step - 1e-9); // may be too large for ++
  for (let k = first; k * step <= high + 1e-9 * step && all.length < 100; ++k) all.push(+(k * step).toPrecision(12));
  return all;
}

/// The range of the exact energy, and of the engine's as far as it does not dwarf the motion's.
function energyRange({ stairs, fastest }, run) {
  let low = Infinity, high = -Infinity;
  for (const one of stairs.energies) [low, high] = [Math.min(low, one), Math.max(high, one)];
  const size = Math.max(high - low, fastest, 1e-12), exact = [low, high];
  if (run?.energies) {
    for (const one of run.energies) {
      if (Number.isFinite(one)) [low, high] = [Math.min(low, Math.max(one, exact[0] - size)), Math.max(high, Math.min(one, exact[1] + size))];
    }
  }
  const room = Math.max(0.06 * (high - low), 0.02 * size);
  return [low - room, high + room];
}

export class Chart {
  #canvas;
  #still = new Still();

  /// `changed` hears of another size.
  constructor(canvas, changed) {
    this.#canvas = canvas;
    watch(canvas, changed);
  }

  /// The time at `x` [px] from the left of the canvas.
  timeAt(x, end) {
    const width = sizeOf(this.#canvas)[0] - MARGIN.left - MARGIN.right;
    return end * Math.min(1, Math.max(0, (x - MARGIN.left) / width));
  }

  draw(picture) {
    const [width, height] = sizeOf(this.#canvas), { motion, run, fog, colours, time } = picture;
    if (!motion || width === 0 || height === 0) return;
    const g = cleared(this.#canvas, [width, height]);
    this.#still.draw(g, [width, height], [motion, run, fog, colours], (on) => this.#drawStill(on, picture, width, height));
    const x = MARGIN.left + ((width - MARGIN.left - MARGIN.right) * time) / motion.end;
    Object.assign(g, { strokeStyle: colours.ink, lineWidth: 1 });
    g.beginPath();
    g.moveTo(Math.round(x) + 0.5, TOP - 4);
    g.lineTo(Math.round(x) + 0.5, height - AXIS + 4);
    g.stroke();
  }

  #drawStill(g, { motion, run, foggy, fog, colours, unit }, width, height) {
    const right = width - MARGIN.right, bottom = height - AXIS, end = motion.end, cables = motion.the_case.cables.length;
    const X = (t) => MARGIN.left + ((right - MARGIN.left) * t) / end;
    Object.assign(g, { font: `12px ${colours.sans}`, textBaseline: "middle", lineJoin: "round" });
    const label = (text, y, colour = colours.muted) => Object.assign(g, { textAlign: "right", fillStyle: colour }).fillText(text, MARGIN.left - 8, y);
    // what nobody can know
    g.fillStyle = colours.shade;
    for (const { from, until } of motion.unsure) g.fillRect(X(from), TOP - 4, X(Math.min(until, end)) - X(from), bottom - TOP + 8);
    if (motion.horizon < end) { // its name on the side that has room
      const x = X(motion.horizon), before = x > 0.5 * (MARGIN.left + right);
      Object.assign(g, { fillStyle: colours.muted, textAlign: before ? "right" : "left" });
      g.fillText("horizon", x + (before ? -5 : 5), TOP + 4);
      g.fillRect(x, TOP - 4, 1, bottom - TOP + 8);
    }
    // the axis of time
    Object.assign(g, { strokeStyle: colours.line, lineWidth: 1, fillStyle: colours.muted, textAlign: "center" });
    for (const t of ticks(0, end, Math.max(2, Math.min(10, (right - MARGIN.left) / 70)))) {
      g.beginPath();
      g.moveTo(Math.round(X(t)) + 0.5, TOP);
      g.lineTo(Math.round(X(t)) + 0.5, bottom + 4);
      g.stroke();
      g.fillText(String(t), X(t), bottom + 14);
    }
    label(`t${unit("s") && " [s]"}`, bottom + 14);
    this.#drawEnergy(g, motion, run, colours, X, right, unit, label);
    let y = TOP + ENERGY + GAP;
    if (fog) this.#drawSpread(g, fog, colours, X, y, label);
    if (foggy) y += SPREAD + GAP;
    for (let cable = 0; cable < cables; ++cable) this.#drawStrip(g, { motion, run, colours, X, cable, cables, y: y + STRIP * cable, end, right, label });
  }

  #drawEnergy(g, motion, run, colours, X, right, unit, label) {
    const [low, high] = energyRange(motion, run), bottom = TOP + ENERGY, Y = (e) => bottom - (ENERGY * (e - low)) / (high - low);
    const marks = ticks(low, high, 4);
    for (const one of marks) label(Math.abs(one) >= 1e5 || (one !== 0 && Math.abs(one) < 1e-3) ? one.toExponential(1) : String(one), Y(one));
    g.save();
    g.beginPath();
    g.rect(MARGIN.left, TOP - 4, right - MARGIN.left, ENERGY + 8);
    g.clip();
    if (run?.energies) {
      Object.assign(g, { strokeStyle: colours.engine, lineWidth: 1.6 });
      g.setLineDash([5, 3]);
      g.beginPath();
      const every = Math.max(1, Math.floor(run.steps / (right - MARGIN.left))); // as many as pixels
      for (let i = 0; i <= run.steps; i += every) g.lineTo(X(i / run.rate), Math.max(-1e4, Math.min(1e4, Y(run.energies[i]))));
      g.stroke();
      g.setLineDash([]);
    }
    const { times, energies } = motion.stairs;
    Object.assign(g, { strokeStyle: colours.exact, lineWidth: 2 });
    g.beginPath();
    times.forEach((t, i) => {
      if (i > 0) g.lineTo(X(t), Y(energies[i - 1]));
      g.lineTo(X(t), Y(energies[i]));
    });
    g.lineTo(X(motion.end), Y(energies.at(-1)));
    g.stroke();
    g.restore();
    const name = `energy${unit("J") && " [J]"}`;
    g.save();
    Object.assign(g, { fillStyle: colours.ink, textAlign: "center" });
    g.translate(9, TOP + ENERGY / 2);
    g.rotate(-Math.PI / 2);
    g.fillText(name, 0, 0);
    g.restore();
  }

  /// How far the futures are apart, on a logarithmic axis.
  #drawSpread(g, { spread, instants, end }, colours, X, top, label) {
    let low = Infinity, high = -Infinity;
    for (const one of spread) if (one > 0) [low, high] = [Math.min(low, one), Math.max(high, one)];
    if (!(high > 0)) return;
    const bounds = [Math.floor(Math.log10(low)), Math.max(Math.ceil(Math.log10(high)), Math.floor(Math.log10(low)) + 1)];
    const Y = (value) => top + SPREAD - (SPREAD * (Math.log10(value) - bounds[0])) / (bounds[1] - bounds[0]);
    for (const power of bounds) label(power === 0 ? "1" : `1e${power}`, Y(10 ** power));
    Object.assign(g, { strokeStyle: colours.exact, lineWidth: 1.4 });
    g.beginPath();
    for (let i = 0; i < instants; ++i) if (spread[i] > 0) g.lineTo(X((end * i) / (instants - 1)), Y(spread[i]));
    g.stroke();
    g.save();
    Object.assign(g, { fillStyle: colours.ink, textAlign: "center" });
    g.translate(9, top + SPREAD / 2);
    g.rotate(-Math.PI / 2);
    g.fillText("spread", 0, 0);
    g.restore();
  }

  /// Where a cable is taut, its impacts as tall as their impulse, and below them those of the engine.
  #drawStrip(g, { motion, run, colours, X, cable, cables, y, right, label }) {
    const bar = STRIP - 6;
    label(`cable ${cable}`, y + bar / 2, colours.ink);
    g.fillStyle = colours.line;
    g.fillRect(MARGIN.left, y + bar, right - MARGIN.left, 1);
    Object.assign(g, { fillStyle: colours.exact, globalAlpha: 0.38 });
    for (const { start, end } of motion.stretches[cable]) g.fillRect(X(start), y + 2, Math.max(X(end) - X(start), 1), bar - 2);
    Object.assign(g, { fillStyle: colours.hit, globalAlpha: 0.9 });
    g.beginPath();
    for (const { time, impulses } of motion.impacts) {
      const tall = impulses[cable] > 0 ? 2 + (bar - 2) * Math.sqrt(impulses[cable] / motion.largest) : 0;
      if (tall > 0) g.rect(X(time) - 0.6, y + bar - tall, 1.2, tall);
    }
    g.fill();
    if (run?.impulses) {
      Object.assign(g, { fillStyle: colours.engine, globalAlpha: 0.8 });
      g.beginPath();
      for (let i = 0, from = -1; i <= run.steps; ++i) { // from where it pulls to where it lets go
        const pulls = i < run.steps && run.impulses[cables * i + cable] > 0;
        if (pulls && from < 0) from = i;
        else if (!pulls && from >= 0) {
          const x = X((from + 1) / run.rate);
          if (x < right) g.rect(x, y + bar + 2, Math.max(1, Math.min(X(i / run.rate), right) - x), 2);
          from = -1;
        }
      }
      g.fill();
    }
    g.globalAlpha = 1;
  }
}

/// The fog's spread at a time.
export const spreadAt = ({ spread, instants, end }, time) => spread[Math.min(instants - 1, Math.floor((time / end) * (instants - 1)))];
