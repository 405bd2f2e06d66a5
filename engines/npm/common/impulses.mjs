// Impulses along cables, found by hand: for engines whose own solver cannot be asked.

/** A planar body has three ways to move: more cables than that share their impulses in more ways than one [-]. */
const mostIndependent = 3;

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

/** The sets of at most `most` of the numbers below `count`, small sets first. */
function* subsets(count, most) {
  let sets = [[]];
  for (let size = 0; size <= most && sets.length > 0; ++size) {
    yield* sets;
    sets = sets.flatMap((set) => {
      const first = set.length > 0 ? set[set.length - 1] + 1 : 0;
      return Array.from({ length: count - first }, (_, i) => [...set, first + i]);
    });
  }
}

/**
 * The impulses >= 0 [N s] along `rows` that raise each gap rate by at least its `rise` [m/s], and by no more where they
 * are > 0: the complementarity problem 0 <= a <= W a >= rise. With more than three cables several sets of impulses may
 * give the same motion; this is the first with the fewest cables. Where no impulses will do, the nearest miss.
 */
export function impulsesFor(rows, body, rise) {
  const none = rows.map(() => 0);
  const scale = rounding * Math.max(...rise.map(Math.abs));
  const w = rows.map((a) => rows.map((b) => response(a, b, body)));
  let best = none, smallestMiss = Infinity;
  for (const set of subsets(rows.length, mostIndependent)) {
    const pulls = solved(set.map((i) => set.map((j) => w[i][j])), set.map((i) => rise[i]));
    if (!pulls || pulls.some((pull) => pull < 0)) continue;
    const missed = rise.map((want, i) => want - set.reduce((sum, j, k) => sum + w[i][j] * pulls[k], 0));
    const miss = Math.max(...missed.filter((_, i) => !set.includes(i)), 0);
    if (miss < smallestMiss) {
      best = none.map((_, i) => (set.includes(i) ? pulls[set.indexOf(i)] : 0));
      smallestMiss = miss;
    }
    if (miss <= scale) break;
  }
  return best;
}

/**
 * The impulses >= 0 [N s] along `rows` that explain the `jump` of velocity [vx, vy, spin] best, by least squares in the
 * kinetic energy: the same problem, as its solution opens each gap at least as fast as the jump does.
 */
export function impulsesBehind(rows, body, [x, y, turn]) {
  return impulsesFor(rows, body, rows.map(({ nx, ny, moment }) => nx * x + ny * y + moment * turn));
}
