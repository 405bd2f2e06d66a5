// The spring and damper of a limit that give a restitution: beyond the length the overstretch x follows
// x'' = -k x - b x', which cannot push.

/**
 * The restitution from x = 0 until the pull is zero. With z = b / (2 sqrt k) = sin beta it ends at the phase pi - 2 beta,
 * so e = exp(-(pi - 2 beta) tan beta); beyond z = 1, where z = cosh mu, e = exp(-2 mu coth mu).
 */
function restitutionOf(ratio) {
  if (ratio < 1) {
    const beta = Math.asin(ratio);
    return Math.exp(-(Math.PI - 2 * beta) * Math.tan(beta));
  }
  const mu = Math.acosh(ratio);
  return Math.exp(-2 * (mu > 0 ? mu / Math.tanh(mu) : 1));
}

/** The damping that stops a body in one step, b dt = 1, as a ratio [-]; more would overshoot. */
const largestRatio = (frequency, step) => 1 / (2 * frequency * step);

/** The ratio up to `largest` whose restitution is `e`: it falls as the ratio grows. */
function ratioOf(e, largest) {
  let low = 0, high = largest;
  for (let halving = 0; halving < 60; ++halving) {
    const middle = (low + high) / 2;
    restitutionOf(middle) > e ? (low = middle) : (high = middle);
  }
  return (low + high) / 2;
}

/**
 * The frequency [1/s] with which a bounce without damping lasts `bounce` steps of `step` [s], and the damping ratio [-] for a
 * restitution `e`. Fewer steps overstretch the cable less, and come less close to e. `numerical` is the part of the product
 * of frequency and step that the integrator adds to the ratio [-]: 1/2 of the implicit method of Euler.
 */
export function springFor(e, step, { bounce, numerical = 0 }) {
  const frequency = Math.PI / (bounce * step), ratio = ratioOf(e, largestRatio(frequency, step));
  return { frequency, ratio: Math.max(0, ratio - numerical * frequency * step) };
}

/** A spring as the protocol has it: stiffness [1/s^2] and damping [1/s]. */
export const softRow = ({ frequency, ratio }) => ({ stiffness: frequency ** 2, damping: 2 * ratio * frequency });
