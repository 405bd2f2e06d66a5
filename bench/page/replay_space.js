// Systems in space for the replay: their motions, evaluated as bench/replay/path.cpp evaluates them, and what a
// picture shows of them. This script comes before those of the page, which call it; it calls them in turn.
window.tautlineSpace = (() => {
  'use strict';

  const plus = (a, b, part = 1) => a.map((value, k) => value + part * b[k]);
  const minus = (a, b) => plus(a, b, -1);
  const dot = (a, b) => a.reduce((sum, value, k) => sum + value * b[k], 0);
  const norm = (a) => Math.sqrt(dot(a, a));
  const scaled = (a, by) => a.map((value) => by * value);
  const unit = (a) => scaled(a, 1 / norm(a));
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const vectors = { plus, minus, dot, norm, scaled, unit, cross };

  /// `v` turned by the unit quaternion `q`, w first.
  function turned(q, v) {
    const axis = q.slice(1);
    const twice = scaled(cross(axis, v), 2);
    return plus(plus(v, twice, q[0]), cross(axis, twice));
  }

  /// The value of a function over time of the report at `time` [s].
  function valueAt({ pieces, waves }, time) {
    const piece = pieces.findLast((one) => one.from <= time);
    const [first, ...more] = (piece ?? pieces[0])?.coefficients ?? [waves[0].amplitude.map(() => 0)];
    const since = time - (piece?.from ?? 0);
    const sum = (piece ? more : []).reduce((all, coefficient, k) => plus(all, coefficient, since ** (k + 1)), first);
    return waves.reduce((all, wave) => plus(all, wave.amplitude, Math.cos(wave.frequency * time + wave.phase)), sum);
  }

  const names = ['x', 'y', 'z', 'qw', 'qx', 'qy', 'qz'];

  /// A path with its columns as numbers.
  function drawn(path) {
    const { numbers, taut } = tautline.motions;
    const line = ({ time, value }) => ({ time: numbers(time), value: numbers(value) });
    return { error: path.error, spacing: path.spacing, energy_time: numbers(path.energy_time), energy: numbers(path.energy),
      bodies: (path.bodies ?? []).map((body) => ({ time: numbers(body.time), places: names.map((name) => numbers(body[name])),
        bends: names.map((name) => numbers(body[`${name}_bends`])) })),
      cables: (path.cables ?? []).map((cable) => ({ ...taut(cable), tension: cable.tension && line(cable.tension) })) };
  }

  /// The place of a body at `at` [s]: its centre [m] and its orientation.
  function bodyAt({ time, places, bends }, at) {
    const i = tautline.motions.indexAt(time, at);
    const inside = i + 1 < time.length && at > time[i];
    const s = inside ? (at - time[i]) / (time[i + 1] - time[i]) : 0;
    const seven = places.map((place, k) => (inside ? place[i] + s * (place[i + 1] - place[i])
      + 3 * s * (1 - s) * ((1 - s) * bends[k][2 * i] + s * bends[k][2 * i + 1]) : place[i]));
    return { p: seven.slice(0, 3), q: unit(seven.slice(3)) };
  }

  const pose = (path, at) => ({ time: at, bodies: path.bodies.map((body) => bodyAt(body, at)) });

  /// The value of a line at `at` [s]; at a jump the one after it.
  function lineAt({ time, value }, at) {
    const i = tautline.motions.indexAt(time, at);
    const length = time[i + 1] - time[i];
    return at <= time[0] || !(length > 0) ? value[i] : value[i] + (at - time[i]) / length * (value[i + 1] - value[i]);
  }

  /// The place of an end of a cable, or of a ring, in the world [m].
  function pointOf(end, { time, bodies }) {
    if (end.body === null) {
      return end.motion ? plus(end.at, valueAt(end.motion, time)) : end.at;
    }
    return plus(bodies[end.body].p, turned(bodies[end.body].q, end.at));
  }
  const endsOf = (cable) => [cable.from, ...cable.through, cable.to];
  const lengthOf = (cable, time) => (cable.length_over_time ? valueAt(cable.length_over_time, time)[0] : cable.length);
  /// True while it is hooked up and not cut.
  const acts = (cable, time) => time >= (cable.from_time ?? 0) && time < (cable.cut_at ?? Infinity);

  /// Length less the distances from end to end [m]; none of a cable that does not act.
  function gap(cable, pose) {
    const points = endsOf(cable).map((end) => pointOf(end, pose));
    return acts(cable, pose.time) ? points.slice(1).reduce((free, point, i) => free - norm(minus(point, points[i])),
      lengthOf(cable, pose.time)) : null;
  }

  /// The way up: against gravity, or z without.
  const upOf = ({ gravity }) => (norm(gravity) > 0 ? scaled(unit(gravity), -1) : [0, 0, 1]);
  const isPoint = (body) => body.inertia.every((one) => one === 0);
  const nameOf = (system, i) => system.bodies[i].name || `body ${i}`;

  /// The motion of `path` in the system of a case; `more` of its members.
  function motion(path, the_case, more) {
    const { system } = the_case;
    const own = drawn(path);
    const at = (time) => pose(own, time);
    const times = [...new Set(own.bodies.flatMap((body) => body.time))].sort((a, b) => a - b);
    const fine = (parts) => tautline.motions.instants({ time: times }, Math.max(2, Math.round(parts / own.bodies.length)));
    const up = upOf(system);
    return { ...more, path: own, pose: at, end: times[times.length - 1], instants: fine, way: fine(8).map(at),
      gapCurve: (i, instants) => tautline.motions.gapCurve(own, null, i, instants, (time) => gap(system.cables[i], at(time))),
      tension: (i, time) => (own.cables[i].tension ? Math.max(0, lineAt(own.cables[i].tension, time)) : null),
      /// How far a body has turned from its start [rad]; how high a point mass is [m].
      turn: (i, time) => {
        const [{ q: from }, { p, q }] = [at(0).bodies[i], at(time).bodies[i]];
        const vector = plus(plus(scaled(q.slice(1), from[0]), scaled(from.slice(1), -q[0])), cross(q.slice(1), from.slice(1)));
        return isPoint(system.bodies[i]) ? dot(up, p) : 2 * Math.atan2(norm(vector), Math.abs(dot(q, from)));
      } };
  }

  /// The title of the panel of `turn`.
  const turnTitle = ({ system }, i) => (isPoint(system.bodies[i]) ? `height of ${nameOf(system, i)} [m]`
    : `turn of ${nameOf(system, i)} [rad]`);

  /// The shape of a body, in its own axes: the solid box that has its moments, or a ball where they are equal, with
  /// a mark that shows its turn; a point mass is a small ball. `least` is the smallest that is seen [m].
  function shapeOf({ mass, inertia }, least) {
    const circle = (a, b, shift = 0, radius = 1) => Array.from({ length: 49 }, (_, i) => {
      const point = [0, 0, 0];
      point[a] = radius * Math.cos(i * Math.PI / 24);
      point[b] = radius * Math.sin(i * Math.PI / 24);
      point[3 - a - b] = shift;
      return point;
    });
    const [small, large] = [Math.min(...inertia), Math.max(...inertia)];
    if (large - small <= 1e-9 * large) {
      const radius = Math.max(least, Math.sqrt(2.5 * large / mass));
      const lines = large > 0 ? [circle(0, 1), circle(1, 2), circle(2, 0), circle(1, 2, 0.9, Math.sqrt(0.19))] : [circle(0, 1)];
      return { ball: radius, lines: lines.map((line) => line.map((point) => scaled(point, 1.004 * radius))) };
    }
    const sum = inertia[0] + inertia[1] + inertia[2];
    const sides = inertia.map((one) => Math.sqrt(Math.max(0, 1.5 * (sum - 2 * one) / mass)));
    const box = scaled(sides, Math.max(1, least / norm(sides)));
    const corner = (...signs) => signs.map((sign, k) => sign * box[k]);
    const lines = [0, 1, 2].flatMap((k) => [-1, 1].flatMap((a) => [-1, 1].map((b) => [-1, 1].map((along) => {
      const signs = [a, b];
      signs.splice(k, 0, along);
      return corner(...signs);
    }))));
    // the face of its first axis is crossed
    lines.push([corner(1, -1, -1), corner(1, 1, 1)], [corner(1, -1, 1), corner(1, 1, -1)]);
    return { box, lines };
  }

  return { vectors, turned, valueAt, drawn, pose, pointOf, endsOf, lengthOf, acts, gap, upOf, isPoint, nameOf, motion, turnTitle, shapeOf };
})();
