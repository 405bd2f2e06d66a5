// Impulses along cables, found by hand: for engines whose own solver cannot be asked.

/** A planar body has three ways to move: more cables than that share their impulses in more ways than one [-]. */
const mostIndependent = 3;

/** Of a case [-]. */
const mostCables = 8;

/** A pivot below this part of its diagonal is a cable that the others make superfluous [-]. */
const leastPivot = 1e-10;

/** A rate is met, and an impulse not negative, up to this part of the largest number asked for [-]. */
const rounding = 1e-12;

/** What an impulse of 1 along `b` adds to the gap rate of `a` [1/kg]. A point mass cannot be turned. */
export function response(a, b, { mass, inertia }) {
  return (a.nx * b.nx + a.ny * b.ny) / mass + (inertia > 0 ? (a.moment * b.moment) / inertia : 0);
}

/** The solution of a symmetric positive system; none where its rows depend on each other. */
function solved(matrix, right) {
  const size = right.length, m = matrix.map((row, i) => [...row, right[i]]);
  for (let k = 0; k < size; ++k) {
    if (!(m[k][k] > leastPivot * matrix[k][k])) return undefined;
    for (let i = k + 1; i < size; ++i) {
      const part = m[i][k] / m[k][k];
      for (let j = k; j <= size; ++j) m[i][j] -= part * m[k][j];
    }
  }
  const x = new Array(size);
  for (let k = size - 1; k >= 0; --k) {
    x[k] = m[k][size];
    for (let j = k + 1; j < size; ++j) x[k] -= m[k][j] * x[j];
    x[k] /= m[k][k];
  }
  return x;
}

/** The sets of at most three of the numbers below `count`, small sets first. */
const subsets = Array.from({ length: mostCables + 1 }, (_, count) => {
  const all = [[]];
  for (let k = 0; k < all.length; ++k) {
    const set = all[k], first = set.length > 0 ? set[set.length - 1] + 1 : 0;
    for (let i = first; set.length < mostIndependent && i < count; ++i) all.push([...set, i]);
  }
  return all;
});

/**
 * The impulses >= 0 [N s] along `rows` that raise each gap rate by at least its `rise` [m/s], and by no more where they
 * are > 0: the complementarity problem 0 <= a <= W a >= rise. With more than three cables several sets of impulses may
 * give the same motion; this is the first with the fewest cables. Where no impulses will do, the nearest miss.
 */
export function impulsesFor(rows, body, rise) {
  const scale = rounding * Math.max(...rise.map(Math.abs));
  const w = rows.map((a) => rows.map((b) => response(a, b, body)));
  let best = [], chosen = [], smallestMiss = Infinity;
  for (const set of subsets[rows.length]) {
    const pulls = solved(set.map((i) => set.map((j) => w[i][j])), set.map((i) => rise[i]));
    if (!pulls || pulls.some((pull) => pull < 0)) continue;
    let miss = 0; // of the cables that take no part
    for (let i = 0; i < rows.length; ++i) {
      if (!set.includes(i)) miss = Math.max(miss, rise[i] - set.reduce((sum, j, k) => sum + w[i][j] * pulls[k], 0));
    }
    if (miss < smallestMiss) [best, chosen, smallestMiss] = [pulls, set, miss];
    if (miss <= scale) break;
  }
  return rows.map((_, i) => best[chosen.indexOf(i)] ?? 0);
}

/**
 * The impulses >= 0 [N s] along `rows` that explain the `jump` of velocity [vx, vy, spin] best, by least squares in the
 * kinetic energy: the same problem, as its solution opens each gap at least as fast as the jump does.
 */
export function impulsesBehind(rows, body, [x, y, turn]) {
  return impulsesFor(rows, body, rows.map(({ nx, ny, moment }) => nx * x + ny * y + moment * turn));
}
