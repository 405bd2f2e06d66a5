// Impulses along cables, found by hand: for engines whose own solver cannot be asked.

/** A planar body has three ways to move: more cables than that share their impulses in more ways than one [-]. */
const mostIndependent = 3;

/** Of a case [-]. */
const mostCables = 8;

/** A pivot below this part of its diagonal is a cable that the others make superfluous [-]. */
const leastPivot = 1e-10;

/** A search for the pulling ones of n cables ends after so many n passes [-]: rounding may let it go round in a circle. */
const mostPasses = 10;

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
export function impulsesFor(rows, rise, respond) {
  const scale = rounding * Math.max(...rise.map(Math.abs));
  const w = rows.map((a) => rows.map((b) => respond(a, b)));
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
 * The same for any number of independent cables: the rows that pull are found one by one, that of the largest miss first, and let go
 * where they would push (Lawson and Hanson 1974, chapter 23). A cable that the others make superfluous takes no part.
 */
export function impulsesOfMany(rows, rise, respond) {
  const w = rows.map((a) => rows.map((b) => respond(a, b))), scale = rounding * Math.max(...rise.map(Math.abs));
  const solve = (set) => solved(set.map((i) => set.map((j) => w[i][j])), set.map((i) => rise[i]));
  const pulls = rows.map(() => 0), useless = new Set();
  let pulling = [];
  for (let pass = 0; pass < mostPasses * rows.length; ++pass) {
    const miss = rise.map((wanted, i) => wanted - pulls.reduce((sum, pull, j) => sum + w[i][j] * pull, 0));
    const next = [...rows.keys()].filter((i) => !pulling.includes(i) && !useless.has(i) && w[i][i] > 0 && miss[i] > scale)
      .reduce((best, i) => (best === undefined || miss[i] > miss[best] ? i : best), undefined);
    if (next === undefined) break;
    pulling.push(next);
    for (let found = solve(pulling); ; found = solve(pulling)) {
      if (!found || !(found.at(-1) > 0 || pulling.at(-1) !== next)) { // it depends on the others
        useless.add(next);
        pulling = pulling.filter((i) => i !== next);
        break;
      }
      // as far towards what is found as no cable pushes
      const part = pulling.reduce((least, i, k) => (found[k] <= 0 ? Math.min(least, pulls[i] / (pulls[i] - found[k])) : least), 1);
      pulling.forEach((i, k) => (pulls[i] = found[k] <= 0 && pulls[i] / (pulls[i] - found[k]) <= part ? 0 : pulls[i] + part * (found[k] - pulls[i])));
      if (part === 1) break;
      pulling = pulling.filter((i) => pulls[i] > 0);
      useless.clear();
    }
  }
  return pulls;
}
