// Four plots under the replay on one axis of time: gap of a cable, energy, angle and impact speed,
// with a cursor at the shown time and everything after the horizon grey.
(() => {
  'use strict';
  const { axis, logAxis, mark, chart, make } = tautline;
  /// Points drawn between two knots, as a gap is curved there.
  const finer = 8;

  const fourths = [[0.79, 1], [0.53, 0.74], [0.27, 0.48], [0, 0.21]];

  /// The title of the third panel.
  const turnTitle = ({ system, body }) => (tautline.motions.inSpace(system) ? window.tautlineSpace.turnTitle(system, body) : 'angle [rad]');

  function lines(state, motion, colours) {
    const { path } = motion;
    const fine = motion.instants(finer);
    const { colour, symbol, dash } = motion.reference
      ? { colour: colours.ink, symbol: 'circle', dash: 'solid' } : mark(motion.engine, motion.model);
    const line = { color: colour, dash, width: motion.reference ? 2 : 1.4 };
    const trace = (yaxis, y, unit, more = {}) => ({ type: 'scatter', mode: 'lines', name: motion.name, x: fine, y,
      yaxis, line, hovertemplate: `<b>%{fullData.name}</b><br>%{x:.4g} s: %{y:.4g} ${unit}<extra></extra>`,
      ...more });
    const free = motion.gapCurve(state.cable, fine);
    return [
      trace('y', free.y, 'm', { x: free.x }),
      trace('y2', path.energy, 'J', { x: path.energy_time }),
      trace('y3', fine.map((at) => motion.turn(state.body, at)), /\[(.*)\]/.exec(turnTitle(state))[1]),
      trace('y4', motion.impacts.map((impact) => impact.speed), 'm/s', { mode: 'markers',
        x: motion.impacts.map((impact) => impact.time),
        marker: { color: colour, symbol, size: motion.reference ? 4 : 6,
          line: { color: colour, width: 1 } } })];
  }

  /// From the slowest impact that is counted to the fastest, as powers of ten: near an accumulation
  /// there are slower ones without end.
  function speeds(state) {
    const all = state.motions.flatMap((one) => one.impacts.map((impact) => impact.speed || 0));
    const slowest = Math.log10(tautline.report.options.count_speed);
    return [slowest - 0.3, Math.max(slowest + 1, Math.log10(Math.max(0, ...all)) + 0.3)];
  }

  function build(state) {
    return (colours) => {
      const { system } = state;
      const { path } = state.motions[0];
      const { end } = state.motions[0];
      // the exact one's energy and angle set the scale: a run that blows up must not flatten it
      const range = (values) => {
        const [low, high] = [Math.min(...values), Math.max(...values)];
        const room = Math.max(0.12 * (high - low), 1e-6);
        return [low - room, high + room];
      };
      const panel = (title, i, more) => axis(colours, { title: { text: title, font: { size: 12 } },
        domain: fourths[i], nticks: 4, ...more });
      return {
        system,
        // the exact one last, on top
        data: [...state.motions].reverse().flatMap((motion) => lines(state, motion, colours)),
        layout: { height: 640, margin: { l: 64, r: 12, t: 10, b: 46 },
          xaxis: axis(colours, { title: { text: 'time [s]' }, range: [0, end], anchor: 'y4' }),
          yaxis: panel(`gap ${state.cable} [m]`, 0),
          yaxis2: panel('energy [J]', 1, { range: range(path.energy) }),
          yaxis3: panel(turnTitle(state), 2, { range: range(path.angle ?? state.motions[0].instants(finer).map((at) => state.motions[0].turn(state.body, at))) }),
          yaxis4: logAxis(colours, { title: { text: 'impact [m/s]', font: { size: 12 } },
            domain: fourths[3], range: speeds(state) }),
          shapes: system.horizon < end ? [
            { type: 'rect', yref: 'paper', x0: system.horizon, x1: end, y0: 0, y1: 1, layer: 'below',
              line: { width: 0 }, fillcolor: colours.muted, opacity: 0.16 },
            { type: 'line', yref: 'paper', x0: system.horizon, x1: system.horizon, y0: 0, y1: 1,
              line: { color: colours.ink, width: 1.2, dash: 'dash' } }] : [],
          annotations: system.horizon < end ? [{ x: system.horizon, y: 1, yref: 'paper', xanchor: 'left',
            yanchor: 'top', text: 'horizon', showarrow: false,
            font: { color: colours.ink, size: 11 } }] : [] } };
    };
  }

  /// The plots in `element`, of `state` {system, motions, cable}; `cursor(time)` moves the line.
  function plots(element, state) {
    const made = chart(element, build(state));
    const line = make('div', { class: 'time-cursor', 'aria-hidden': 'true' });
    element.append(line);
    let now = 0;
    function cursor(time) {
      now = time;
      const layout = made.body._fullLayout;
      if (!layout) {
        return;
      }
      const { xaxis } = layout;
      const x = xaxis.l2p(time);
      line.hidden = x < 0 || x > xaxis._length;
      line.style.transform = `translateX(${xaxis._offset + x}px)`;
      Object.assign(line.style, { top: `${layout._size.t}px`, height: `${layout._size.h}px` });
    }
    const update = async () => {
      await made.update();
      if (made.body.on && !made.listens) {
        made.listens = true;
        made.body.on('plotly_afterplot', () => cursor(now));
      }
      cursor(now);
    };
    const show = made.show;
    made.show = async () => { await show(); await update(); };
    return { update, cursor };
  }

  tautline.plots = plots;
})();
