// The motions that the replay shows: columns of the report become curves, which are evaluated as
// bench/replay/path.cpp evaluates them. The exact motion of a case is in the page; those
// of its runs are too in the page of a single case, else in a file beside it.
(() => {
  'use strict';
  const { make } = tautline;

  /// The numbers of a column: each so many grid widths from the one before.
  function numbers({ start, scale, steps }) {
    let place = 0;
    return steps.map((step) => {
      place += step;
      return start + scale * place;
    });
  }

  /// When a cable is taut, and its gap then.
  const taut = (cable) => ({ times: numbers(cable.times), grid: cable.times.scale, gapTimes: numbers(cable.gap_times),
    gapGrid: cable.gap_times.scale, gap: cable.gap });

  /// A path with its columns as numbers.
  function drawn(path) {
    const columns = ['time', 'x', 'y', 'angle', 'x_bends', 'y_bends', 'angle_bends', 'energy_time', 'energy'];
    return { ...path, ...Object.fromEntries(columns.map((name) => [name, numbers(path[name])])),
      cables: path.cables.map(taut) };
  }

  /// The last index with time[index] <= at; 0 before the first.
  function indexAt(time, at) {
    let [low, high] = [0, time.length - 1];
    while (low < high) {
      const half = (low + high + 1) >> 1;
      [low, high] = time[half] <= at ? [half, high] : [low, half - 1];
    }
    return low;
  }

  /// The pose of a drawn `path` at `at` [s]: a cubic between two knots.
  function pose(path, at) {
    const i = indexAt(path.time, at);
    if (i + 1 >= path.time.length || at <= path.time[i]) {
      return { time: at, x: path.x[i], y: path.y[i], angle: path.angle[i] };
    }
    const s = (at - path.time[i]) / (path.time[i + 1] - path.time[i]);
    const value = (name) => {
      const [places, bends] = [path[name], path[`${name}_bends`]];
      return places[i] + s * (places[i + 1] - places[i])
        + 3 * s * (1 - s) * ((1 - s) * bends[2 * i] + s * bends[2 * i + 1]);
    };
    return { time: at, x: value('x'), y: value('y'), angle: value('angle') };
  }

  /// Whether cable number `i` is taut at `at` [s], which the path says: a drawn gap could not.
  function isTaut(path, i, at) {
    const { times, grid } = path.cables[i];
    for (let from = 0; from + 1 < times.length; from += 2) {
      if (at >= times[from] - grid && at <= times[from + 1] + grid) {
        return true;
      }
    }
    return false;
  }

  const endOf = (cable, pose) => [
    pose.x + Math.cos(pose.angle) * cable.attachment[0] - Math.sin(pose.angle) * cable.attachment[1],
    pose.y + Math.sin(pose.angle) * cable.attachment[0] + Math.cos(pose.angle) * cable.attachment[1]];

  /// length - |P - S| [m], at least 0 where admissible.
  function gap(cable, pose) {
    const [x, y] = endOf(cable, pose);
    return cable.length - Math.hypot(x - cable.anchor[0], y - cable.anchor[1]);
  }

  /// Instants that show all of a path: `parts` for each of its pieces.
  const instants = (path, parts) => path.time.flatMap((at, i) => (i + 1 < path.time.length
    ? Array.from({ length: parts }, (_, k) => at + (k / parts) * (path.time[i + 1] - at)) : [at]));

  /// The gap of cable number `i` over time, {x, y}: as it was recorded where the cable is taut, as
  /// the drawn path has it elsewhere: `gapAt` an instant.
  function gapCurve(path, cable, i, fine, gapAt = (at) => gap(cable, pose(path, at))) {
    const { times, gapTimes, gapGrid, gap: recorded } = path.cables[i];
    const [x, y] = [[], []];
    const put = (time, value) => { x.push(time); y.push(value); };
    let next = 0;
    const free = (until) => {
      for (; next < fine.length && fine[next] < until; ++next) {
        put(fine[next], gapAt(fine[next]));
      }
    };
    for (let from = 0; from + 1 < times.length; from += 2) {
      const [start, end] = [times[from], times[from + 1]];
      const inside = gapTimes.map((_, k) => k).filter((k) => gapTimes[k] >= start - gapGrid
        && gapTimes[k] <= end + gapGrid);
      if (inside.length > 0) {
        free(start);
        put(start, recorded[inside[0]]);
        inside.forEach((k) => put(gapTimes[k], recorded[k]));
        put(end, recorded[inside[inside.length - 1]]);
        while (next < fine.length && fine[next] <= end) {
          ++next;
        }
      }
    }
    free(Infinity);
    return { x, y };
  }

  /// What happens in the exact motion, or in a run: {time, kind, cables, speed}.
  const exactHappenings = ({ time, kind, cables, rate }) => time.map((at, i) => ({ time: at, kind: kind[i],
    cables: cables[i], speed: rate[i] === null ? null : Math.abs(rate[i]) }));
  const runHappenings = ({ time, cable, speed }) => time.map((at, i) => ({ time: at, kind: 'impact',
    cables: [cable[i]], speed: speed[i] }));

  /// The motion of `path` in the plane.
  function planar(path, system, more) {
    const drawnPath = drawn(path);
    const at = (time) => pose(drawnPath, time);
    return { ...more, path: drawnPath, pose: at, end: drawnPath.time[drawnPath.time.length - 1],
      instants: (parts) => instants(drawnPath, parts), way: instants(drawnPath, 8).map(at),
      gapCurve: (i, fine) => gapCurve(drawnPath, system.geometry[i], i, fine), turn: (body, time) => at(time).angle };
  }

  /// A case of a system in space: its motions and its pictures are those of replay_space.js.
  const inSpace = (system) => Boolean(system?.system);
  const made = (path, system, happenings, more) => (inSpace(system) ? window.tautlineSpace.motion : planar)(path, system,
    { ...more, happenings, impacts: happenings.filter((one) => one.kind === 'impact') });

  /// The exact motion of a case.
  const exactMotion = (system) => made(system.path, system, exactHappenings(system.events), { name: 'exact path',
    engine: 'exact', model: 'event', reference: true, leftOut: system.events.left_out });

  /// The motion of a run from those of its case.
  const runMotion = (run, system) => made(run.path, system, runHappenings(run.impacts), {
    name: `${run.engine} ${run.model}, step ${tautline.number(run.step)} s`,
    engine: run.engine, model: run.model, leftOut: run.impacts.left_out });

  /// The times of every event of the motions, rising, each once [s].
  function eventTimes(motions) {
    const times = motions.flatMap((one) => one.happenings.map((event) => event.time));
    return times.sort((a, b) => a - b).filter((time, i) => i === 0 || time - times[i - 1] > 1e-6);
  }

  // a page on disk may not read a file, but it may run one: each calls this with what it has
  const came = new Map();
  tautline.motionsCame = (file, runs) => came.set(file, runs);

  /// The motions of all runs of a case, as a promise; it fails where their file is not there.
  function runsOf(system) {
    const file = system.motions;
    if (!file) {
      const own = document.getElementById('motions-data');
      return Promise.resolve(own ? JSON.parse(own.textContent) : []);
    }
    return came.has(file) ? Promise.resolve(came.get(file)) : new Promise((done, fail) => {
      const script = make('script', { src: file, on: { error: fail,
        load: () => (came.has(file) ? done(came.get(file)) : fail()) } });
      document.head.append(script);
    });
  }

  tautline.motions = { numbers, drawn, pose, exactMotion, runMotion, runsOf, endOf, gap, gapCurve, isTaut,
    indexAt, instants, eventTimes, taut, inSpace };
})();
