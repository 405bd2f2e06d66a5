// The motions that the replay shows, from the columns of the report: the pose at any time, the gap
// of a cable there, and the events to step by.
(() => {
  'use strict';
  /// A gap below this part of the cable's length is drawn taut: the thinned columns between two
  /// samples of a swing are off by no more.
  const tautPart = 2e-3;

  /// The last index with time[index] <= at; 0 before the first.
  function indexAt(time, at) {
    let [low, high] = [0, time.length - 1];
    while (low < high) {
      const half = (low + high + 1) >> 1;
      [low, high] = time[half] <= at ? [half, high] : [low, half - 1];
    }
    return low;
  }

  const endOf = (cable, pose) => [
    pose.x + Math.cos(pose.angle) * cable.attachment[0] - Math.sin(pose.angle) * cable.attachment[1],
    pose.y + Math.sin(pose.angle) * cable.attachment[0] + Math.cos(pose.angle) * cable.attachment[1]];

  /// length - |P - S| [m], at least 0 where admissible.
  function gap(cable, pose) {
    const [x, y] = endOf(cable, pose);
    return cable.length - Math.hypot(x - cable.anchor[0], y - cable.anchor[1]);
  }

  const isTaut = (cable, pose) => gap(cable, pose) < tautPart * cable.length;

  const sample = (path, i) => ({ time: path.time[i], x: path.x[i], y: path.y[i],
    angle: path.angle[i], energy: path.energy[i] });

  /// The pose of `path` at `at` [s]. Between two samples a body on slack cables flies the parabola
  /// p = chord - g (t - a)(b - t) / 2, which is exact; on a taut cable the chord is near enough.
  function pose(system, path, at) {
    const i = indexAt(path.time, at);
    const a = sample(path, i);
    if (i + 1 >= path.time.length || at <= a.time) {
      return { ...a, ended: at > a.time + 1e-9 && i + 1 >= path.time.length };
    }
    const b = sample(path, i + 1);
    const part = (at - a.time) / (b.time - a.time);
    const between = (name) => a[name] + part * (b[name] - a[name]);
    const held = system.geometry.some((cable) => isTaut(cable, a) && isTaut(cable, b));
    const fall = held ? 0 : 0.5 * (at - a.time) * (b.time - at);
    return { time: at, x: between('x') - fall * system.gravity[0],
      y: between('y') - fall * system.gravity[1], angle: between('angle'),
      energy: between('energy') };
  }

  /// Impacts of a motion as {time, cables, speed}: of the exact one from its events, of a run from
  /// its columns.
  function impacts(motion) {
    const { events, columns } = motion;
    if (events) {
      return events.time.map((time, i) => ({ time, kind: events.kind[i], cables: events.cables[i],
        speed: events.rate[i] === null ? null : Math.abs(events.rate[i]) }));
    }
    return columns ? columns.time.map((time, i) => ({ time, kind: 'impact',
      cables: [columns.cable[i]], speed: Math.abs(columns.rate_before[i]) })) : [];
  }

  /// A motion to show: of the exact solution of a case, or of a run of it.
  function motion(system, run) {
    const made = run ? { name: `${run.engine} ${run.model}, step ${tautline.number(run.step)} s`,
      engine: run.engine, model: run.model, path: run.path, columns: run.impacts }
      : { name: 'exact path', engine: 'exact', model: 'event', path: system.path,
        events: system.events, reference: true };
    made.happenings = impacts(made);
    made.impacts = made.happenings.filter((one) => one.kind === 'impact');
    made.pose = (at) => pose(system, made.path, at);
    return made;
  }

  /// The times of every event of the motions, rising, each once [s].
  function eventTimes(motions) {
    const times = motions.flatMap((one) => one.happenings.map((event) => event.time));
    return times.sort((a, b) => a - b).filter((time, i) => i === 0 || time - times[i - 1] > 1e-6);
  }

  tautline.motions = { motion, endOf, gap, isTaut, indexAt, eventTimes };
})();
