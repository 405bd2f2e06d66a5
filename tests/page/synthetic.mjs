// A report of the page's contract with as many cases, engines, models and steps as a test needs. The
// bodies do move on their cables: a small stepper with Newton impacts, finer for what is called
// exact, so that the pictures make sense. Nothing here is a measurement of any engine.
const bullet = ['row', 'early', 'row-sleeping', 'two-phase', 'contact', 'contact-tuned', 'bounce-limit', 'cable',
  'cable-events', 'event'];
export const modelNames = {
  exact: ['event', 'sampled'], bullet64: bullet, bullet32: bullet,
  ode: ['row', 'early', 'contact', 'cable', 'cable-events', 'event'],
  mujoco: ['tendon-limit', 'tendon-limit-rk4', 'impulse', 'event'], dart: ['row', 'early', 'event'],
  simbody: ['rope', 'event-handler'], siconos: ['moreau-jean', 'moreau-jean-projected', 'event-driven'],
  box2d: ['distance-joint', 'distance-joint-bounce', 'event'],
  chipmunk: ['row', 'early', 'slide-joint', 'slide-joint-bounce', 'event'] };
const six = (value) => Number(value.toPrecision(6));

/// A column of the report: numbers on a grid.
function column(numbers, scale = 1e-6) {
  let place = 0;
  return { start: numbers[0] ?? 0, scale, steps: numbers.map((number) => {
    const step = Math.round((number - numbers[0]) / scale) - place;
    place += step;
    return step;
  }) };
}
/// Samples as a path of the report: straight from one to the next.
function pathOf({ time, x, y, angle, energy }) {
  const straight = column(time.slice(1).flatMap(() => [0, 0]));
  return { error: 1e-3, spacing: 1e-2, time: column(time), x: column(x), y: column(y), angle: column(angle),
    x_bends: straight, y_bends: straight, angle_bends: straight, energy_error: 1e-3, energy_time: column(time),
    energy: column(energy), cables: [0, 1].map(() => ({ times: column([]), gap_times: column([]), gap: [] })) };
}

function system(index) {
  const turn = 0.1 + 0.03 * index;
  const geometry = [-1, 1].map((side) => ({ anchor: [side, 0], attachment: [0.5 * side, 0.2],
    length: 1.2 + 0.02 * index, restitution: 0.9 - 0.02 * index }));
  return { geometry, gravity: [0, -1], body: { mass: 1, inertia: 0.2 },
    start: { x: 0.2 * Math.sin(turn), y: -0.7, angle: turn, vx: 0.3, vy: 0.1, spin: 0.4 } };
}

/// Steps a body and records samples and impacts; `bias` is the size of the flight error per step.
function simulate({ geometry, gravity, body, start }, duration, dt, samples, bias) {
  const s = { ...start };
  const path = { time: [], x: [], y: [], angle: [], energy: [] };
  const hits = [];
  const record = (time) => {
    path.time.push(six(time));
    path.x.push(six(s.x));
    path.y.push(six(s.y));
    path.angle.push(six(s.angle));
    path.energy.push(six(0.5 * body.mass * (s.vx ** 2 + s.vy ** 2) + 0.5 * body.inertia * s.spin ** 2
      - body.mass * gravity[1] * s.y));
  };
  const steps = Math.round(duration / dt);
  const every = Math.max(1, Math.floor(steps / samples));
  record(0);
  for (let i = 1; i <= steps; ++i) {
    s.vy += gravity[1] * dt;
    s.x += s.vx * dt;
    s.y += (s.vy - 0.5 * gravity[1] * dt * (1 - bias)) * dt;
    s.angle += s.spin * dt;
    geometry.forEach((cable, which) => {
      const [c, n] = [Math.cos(s.angle), Math.sin(s.angle)];
      const r = [c * cable.attachment[0] - n * cable.attachment[1], n * cable.attachment[0] + c * cable.attachment[1]];
      const d = [s.x + r[0] - cable.anchor[0], s.y + r[1] - cable.anchor[1]];
      const far = Math.hypot(...d);
      const u = [-d[0] / far, -d[1] / far];
      const arm = r[0] * u[1] - r[1] * u[0];
      const rate = s.vx * u[0] + s.vy * u[1] + arm * s.spin;
      if (far >= cable.length && rate < 0) {
        const inverse = 1 / body.mass + arm ** 2 / body.inertia;
        const e = rate > -0.02 ? 0 : cable.restitution * (1 - bias * 0.1);
        const impulse = -(1 + e) * rate / inverse;
        s.vx += impulse * u[0] / body.mass;
        s.vy += impulse * u[1] / body.mass;
        s.spin += arm * impulse / body.inertia;
        if (rate < -0.02) {
          hits.push({ time: i * dt, cable: which, requested: cable.restitution, rate, after: -e * rate, arm, impulse });
        }
      }
    });
    if (i % every === 0 || i === steps) {
      record(i * dt);
    }
  }
  return { path, hits };
}

/// The columns of impacts, and their names.
const columnNames = ['time', 'cable', 'requested', 'rate_before', 'rate_after', 'arm', 'tangential_error', 'angular_error', 'left_out'];
const impactColumns = (hits, bias) => [hits.map((h) => six(h.time)), hits.map((h) => h.cable), hits.map((h) => h.requested),
  hits.map((h) => six(h.rate)), hits.map((h) => six(h.after)), hits.map((h) => six(h.arm)),
  hits.map((h) => six(1e-6 * bias * h.impulse)), hits.map((h) => six(1e-7 * bias * h.impulse)), 0];

const causes = ['flight_bias', 'event_lag', 'late_rate', 'position_correction', 'threshold',
  'restitution_ignored', 'solver_residual', 'taut_drift', 'amplification'];
const partsOf = (size, seed) => Object.fromEntries(causes.map((cause, i) =>
  [cause, six(size * (1 + Math.sin(3 * seed + 2 * i)) / 8)]));

/// A simulated second: median and quartiles.
function costOf(engine, step) {
  const cost = 1e-6 * (1 + engine.length) / step;
  return [cost, 0.95 * cost, 1.1 * cost];
}

const windowOf = (until, exact, found) => ({ until, covered: until, exact, found, matched: Math.min(exact, found) });

/// Of the metrics, those that the page's scripts read and a few more.
const units = { early_position_error: 'm', horizon_position_error: 'm', whole_position_error: 'm',
  restitution_error: '1', overstretch: 'm', energy_gain: 'J' };
const metricsOf = (error) => ({ early_position_error: six(error), horizon_position_error: six(4 * error),
  whole_position_error: six(20 * error), restitution_error: 0.05, overstretch: six(error / 3),
  energy_gain: six(error / 10) });

function runOf(the, engine, model, step, which, settings) {
  const order = model.startsWith('event') || engine === 'exact' ? 2 : 1;
  const error = engine === 'exact' ? 0 : 0.3 * (1 + which % 5) * step ** order;
  const bias = engine === 'exact' ? 0 : 1 / (1 + which % 5);
  const { path, hits } = simulate(the.system, settings.duration, Math.max(settings.finest, step), settings.samples, bias);
  const parts = partsOf(error, which);
  return { case: the.name, engine, model, step, metrics: metricsOf(error),
    details: { early: windowOf(0.3 * settings.duration, 5, 5), horizon: windowOf(0.6 * settings.duration, 20, hits.length),
      whole: windowOf(settings.duration, 30, hits.length), last_impacts: [], swing: null,
      restitution: { count: hits.length, smallest: 0.8, mean: 0.85, largest: 0.9 }, stride: 1,
      recorded_impacts: hits.length, slow_impacts: 0 },
    impacts: impactColumns(hits, bias),
    audit: { ladder: which % 3 ? null : { cable: 0, exact_ratio: 0.81,
      heights: [0.8, 0.63, 0.5, 0.38].map((h) => six(h * (1 - bias * step))),
      exact: [0.81, 0.6561, 0.531441, 0.430467] },
    scatter: { count: hits.length, mean: 0.85, standard_deviation: 0.01, smallest: 0.8, largest: 0.9 } },
    attribution: error > 0 ? { covered: 0.5, deviation: error, parts: Object.values(parts) } : null,
    cost: costOf(engine, step), e: [which % 3, six(0.912 - 0.1 * (which % 3))] };
}

function caseOf(name, index, settings) {
  const made = system(index);
  const { path, hits } = simulate(made, settings.duration, settings.finest, 2 * settings.samples, 0);
  return { system: made, row: { name, title: 'two cables', cables: 2, duration: settings.duration, ending: 'reached_duration',
    end_time: settings.duration, horizon: 0.6 * settings.duration, counted_impacts: hits.length, start_energy: 0.1,
    end_energy: 0.02, settling: { last_impacts: [], lock: null }, body: made.body, gravity: made.gravity,
    geometry: made.geometry, extent: 3, step_needed: { part: 0.01, until: 3, safe: 0.001, typical: 0.002 }, path: pathOf(path), motions: null, events: { time: hits.map((h) => six(h.time)), kind: hits.map(() => 'impact'),
      cables: hits.map((h) => [h.cable]), rate: hits.map((h) => six(-h.rate)), left_out: 0 } } };
}

/// `cases` names; engines `engines` of the list above, and one that is missing; `steps` [s].
export function synthetic({ cases = ['breakwater/one', 'breakwater/two'], engines = Object.keys(modelNames),
  steps = [1e-2, 1e-3, 1e-4], duration = 10, samples = 88, finest = 2e-3 } = {}) {
  const settings = { duration, samples, finest };
  const made = cases.map((name, i) => ({ name, ...caseOf(name, i, settings) }));
  const models = engines.flatMap((engine) => modelNames[engine].map((model) => ({ engine, model })));
  const runs = made.flatMap((the) => models.flatMap(({ engine, model }, which) =>
    steps.map((step) => runOf(the, engine, model, step, which, settings))));
  const groups = models.flatMap(({ engine, model }, which) => steps.map((step) => ({ engine, model, step, which })));
  return { schema: 5, program: { name: 'tautline', version: 'synthetic' }, complete: true, planned_runs: runs.length,
    options: { steps, law: 'simultaneous', count_speed: 0.01, early_impacts: 5, time_limit: 60, memory_limit: 1e9 },
    metrics: Object.entries(units).map(([name, unit]) => ({ name, unit, meaning: 'Synthetic.' })),
    engines: [...engines.map((name) => ({ name, models: modelNames[name] })), { name: 'absent', models: [] }],
    impact_columns: columnNames,
    cases: made.map((the) => the.row), runs,
    summary: groups.map(({ engine, model, step }) => {
      const { metrics } = runs.find((run) => run.engine === engine && run.model === model && run.step === step);
      return { engine, model, step, cases: cases.length, failed: 0, impacts: { exact: 20, found: 20, matched: 20 },
        settled: { exact: 0, found: 0 }, metrics: Object.fromEntries(Object.entries(metrics).map(([name, value]) =>
          [name, { median: value, worst: value }])) };
    }),
    models: models.map(({ engine, model }) => ({ engine, model, e: [0, 0] })),
    convergence: models.map(({ engine, model }, which) => ({ engine, model, cases: cases.length, cases_at_rounding: 0,
      slope: engine === 'exact' ? null : { smallest: 0.9, median: 1 + (which % 2), largest: 2.1 } })),
    findings: [{ engine: 'bullet64', model: 'row', kind: 'threshold', sentence: 'bounces slower than 0.2 m/s are lost',
      value: 0.2, unit: 'm/s', evidence: { runs: 3, impacts: 30, shown_in: [] } }],
    causes: groups.map(({ engine, model, step, which }) => ({ engine, model, step, cases: cases.length,
      deviation: { median: step, worst: 3 * step }, shares: engine === 'exact' ? null : partsOf(1, which), covered: 0.5, remainder: 0.01 })),
    limits: null,
    context: { command: 'synthetic', started: '2026-01-01T00:00:00Z', elapsed: 1, program_memory: 1, worker_memory: 1,
      kept_runs: 0, processor: 'none', cores: 1, compiler: 'none', build_type: 'none', flags: '', commit: 'unknown',
      costs: groups.map(({ engine, model, step }) => {
        const [cost, lower, upper] = costOf(engine, step);
        return { engine, model, step, cost_ratio: 100, cases: cases.length, second_cost: cost,
          second_spread: { smallest: 0.9 * cost, lower, upper } };
      }), shards: [] } };
}
