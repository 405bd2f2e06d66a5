// The geometry of a system in space. Vectors have three numbers and quaternions four, w first. A body is {position,
// orientation, velocity, spin}, the spin in its own axes: 13 numbers of a message.

export const plus = ([a, b, c], [x, y, z], times = 1) => [a + times * x, b + times * y, c + times * z];
export const dot = ([a, b, c], [x, y, z]) => a * x + b * y + c * z;
export const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
export const norm = (v) => Math.sqrt(dot(v, v));

/** `v`, in the axes of a body of orientation `q`, in world axes. */
export function rotated([w, x, y, z], v) {
  const axis = [x, y, z], half = cross(axis, v), more = cross(axis, half);
  return plus(plus(v, half, 2 * w), more, 2);
}
/** `v`, in world axes, in the axes of the body. */
export const rotatedBack = ([w, x, y, z], v) => rotated([w, -x, -y, -z], v);

/** A quaternion of length 1 again. */
export function normalized(q) {
  const length = Math.hypot(...q);
  return q.map((number) => number / length);
}

/** The orientation `q` after the turn `r`, in the axes of the body. */
export const followed = ([w, ...axis], [c, ...by]) => normalized([c * w - dot(axis, by), ...plus(plus(cross(axis, by), axis, c), by, w)]);
/** The orientation `q` after a turn by `by` [rad]. */
export function turned(q, by) {
  const angle = norm(by), s = angle > 0 ? Math.sin(angle / 2) / angle : 0;
  return followed(q, [Math.cos(angle / 2), ...by.map((one) => s * one)]);
}

/** The bodies of the numbers of a message, and back. */
export const bodiesOf = (numbers) => Array.from({ length: numbers.length / 13 }, (_, i) => {
  const part = (from, to) => numbers.slice(13 * i + from, 13 * i + to);
  return { position: part(0, 3), orientation: part(3, 7), velocity: part(7, 10), spin: part(10, 13) };
});
export const numbersOf = (bodies) => bodies.flatMap(({ position, orientation, velocity, spin }) => [...position, ...orientation, ...velocity, ...spin]);

/** What is given over time, `size` numbers, at `time` [s], its rate and its second rate: of polynomials from knot to knot, and waves. */
export function given({ pieces, waves }, time, size = 3) {
  const value = new Array(size).fill(0), rate = [...value], second = [...value];
  const piece = pieces.filter(({ from }) => from <= time).at(-1) ?? pieces[0];
  const since = Math.max(0, time - (piece?.from ?? 0)), polynomial = piece?.polynomial ?? [];
  for (let k = 0; k < size; ++k) {
    for (let power = polynomial.length - 1; power >= 0; --power) {
      second[k] = since * second[k] + 2 * rate[k];
      rate[k] = since * rate[k] + value[k];
      value[k] = since * value[k] + polynomial[power][k];
    }
    if (piece && time < piece.from) rate[k] = second[k] = 0; // constant before the first knot
    for (const { amplitude, frequency, phase } of waves) {
      const angle = frequency * time + phase, wave = amplitude[k] * Math.cos(angle);
      value[k] += wave;
      rate[k] -= amplitude[k] * frequency * Math.sin(angle);
      second[k] -= frequency * frequency * wave;
    }
  }
  return [value, rate, second];
}

/** Whether a cable is hooked up and not cut at `time` [s] and right after it. */
export const actsAt = ({ from_time = -Infinity, cut_at = Infinity }, time) => time >= from_time && time < cut_at;

/** The place of an end in the world, its velocity, and its acceleration while the velocities of all bodies stay as they are. */
function pointOf({ body, at, motion }, bodies, time) {
  if (body === undefined) {
    const [moved, ...rates] = given(motion, time);
    return [plus(at, moved), ...rates];
  }
  const { position, orientation, velocity, spin } = bodies[body], sweep = cross(spin, at);
  const [arm, swept, turning] = [at, sweep, cross(spin, sweep)].map((v) => rotated(orientation, v));
  return [plus(position, arm), plus(velocity, swept), turning];
}

/**
 * A cable as a one-sided row at `time` [s]. An impulse of 1 changes the momenta of the bodies by `wrench`, six numbers a body: in the
 * world, and about its centre in its own axes. `acceleration` is of the gap while the velocities of the bodies stay as they are.
 */
export function systemRow(cable, bodies, time) {
  const wrench = new Array(6 * bodies.length).fill(0), { ends } = cable;
  if (!actsAt(cable, time)) return { wrench, gap: Infinity, rate: 0, acceleration: 0, length: Infinity };
  let [[gap], [rate], [acceleration]] = given(cable.length, time, 1);
  const length = gap, points = ends.map((end) => pointOf(end, bodies, time));
  const pull = ({ body, at }, force) => {
    if (body === undefined) return;
    const moment = cross(at, rotatedBack(bodies[body].orientation, force));
    [...force, ...moment].forEach((number, k) => (wrench[6 * body + k] += number));
  };
  for (let i = 0; i + 1 < ends.length; ++i) {
    const [along, velocity, bent] = [0, 1, 2].map((k) => plus(points[i][k], points[i + 1][k], -1)), distance = norm(along);
    const u = along.map((number) => (distance > 0 ? number / distance : 0)), opening = dot(u, velocity);
    gap -= distance;
    rate -= opening;
    acceleration -= dot(u, bent) + (distance > 0 ? (dot(velocity, velocity) - opening * opening) / distance : 0);
    pull(ends[i], u.map((number) => -number));
    pull(ends[i + 1], u);
  }
  return { wrench, gap, rate, acceleration, length };
}
