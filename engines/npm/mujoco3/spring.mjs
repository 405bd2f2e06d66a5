// The spring and damper of a tendon's limit that give a restitution: beyond the length the overstretch x follows
// x'' = -k x - b x', which cannot push.

/** A bounce without damping lasts this many steps: fewer overstretch the cable less, and come less close to e. */
const stepsPerBounce = 20;

/** The damping that stops a body in one step, b dt = 1, as a ratio [-]; more would overshoot. */
const largestRatio = stepsPerBounce / (2 * Math.PI);

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

/** The ratio whose restitution is `e`: it falls as the ratio grows. The largest one where that gives more, 0.02. */
function ratioOf(e) {
  let low = 0, high = largestRatio;
  for (let halving = 0; halving < 60; ++halving) {
    const middle = (low + high) / 2;
    restitutionOf(middle) > e ? (low = middle) : (high = middle);
  }
  return (low + high) / 2;
}

/** Stiffness [1/s^2] and damping [1/s] for a restitution `e` in steps of `step` [s]. */
export function springFor(e, step) {
  const frequency = Math.PI / (stepsPerBounce * step);
  return { stiffness: frequency ** 2, damping: 2 * ratioOf(e) * frequency };
}
