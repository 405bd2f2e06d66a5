// The geometry of a cable. A state is [x, y, angle, vx, vy, spin]; the rest is named as in a case.

/** A cable as a one-sided row: an impulse along (nx, ny) at (px, py) raises its gap rate. */
export function cableRow({ anchor, attachment, length }, [x, y, angle, vx, vy, spin]) {
  const c = Math.cos(angle), s = Math.sin(angle);
  const rx = c * attachment[0] - s * attachment[1], ry = s * attachment[0] + c * attachment[1]; // [m], the arm
  const px = x + rx, py = y + ry; // [m], the attachment in the world
  const dx = anchor[0] - px, dy = anchor[1] - py, distance = Math.hypot(dx, dy);
  const nx = distance > 0 ? dx / distance : 0, ny = distance > 0 ? dy / distance : 0;
  const moment = rx * ny - ry * nx; // [m]; the gap's gradient is (nx, ny, moment)
  return { px, py, nx, ny, moment, gap: length - distance, rate: nx * vx + ny * vy + moment * spin };
}

/** The restitution [-] of a cable whose gap closes at `rate` [m/s]: a number, or a table over the speed. */
export function restitution({ restitution: e }, rate) {
  if (!Array.isArray(e)) return e;
  const speed = Math.abs(rate), above = e.findIndex(([at]) => at > speed);
  if (above <= 0) return e.at(above)[1]; // before the first point, or beyond the last
  const [[v0, e0], [v1, e1]] = e.slice(above - 1, above + 1);
  return e0 + ((speed - v0) / (v1 - v0)) * (e1 - e0);
}
