// The picture of a system in space: with WebGL on a stage that a reader turns (replay_three.mjs), else from the front
// and from the side. Either shows the same points and lines, and lies on the canvas of the replay.
Object.assign(window.tautlineSpace, (() => {
  'use strict';
  const { vectors, turned, pointOf, endsOf, lengthOf, acts, gap, upOf, shapeOf } = window.tautlineSpace;
  const { plus, minus, dot, norm, scaled, unit, cross } = vectors;

  /// The trail shows this part of the whole motion [-]; a flash lasts so long on the screen [s].
  const [trailPart, flashTime] = [0.2, 0.35];
  const fov = 28; // [degrees], of the height
  /// How the stage is looked at: turned about the vertical and from above [rad], and how much nearer [-].
  const first = { azimuth: 0.5, elevation: 0.28, zoom: 1 };
  const steepest = 1.5; // [rad]
  const view = { ...first, flat: matchMedia('(prefers-reduced-data: reduce)').matches };

  let theStage; // undefined until it is needed, null where there is none
  let redraw = () => {};
  const lost = () => tautline.replay.load(); // whose controls turn the picture no longer
  const stage = () => {
    if (view.flat || !window.tautlineThree) {
      return null;
    }
    if (theStage === undefined) {
      theStage = window.tautlineThree.stage(() => { theStage = null; redraw(); lost(); });
    }
    return theStage;
  };

  const channels = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));
  /// `part` of the colour `b`, the rest of `a`.
  const mixed = (a, b, part) => `#${channels(a).map((one, k) => Math.round(one + part * (channels(b)[k] - one))
    .toString(16).padStart(2, '0')).join('')}`;
  /// The colours of tensions, from none to the largest of the exact motion.
  const ramp = (dark) => (dark ? ['#5fb0f5', '#c9a0ef', '#ff7a70'] : ['#2878bd', '#7d4fa3', '#c0262d']);
  const rampColour = (dark, part) => {
    const [low, middle, high] = ramp(dark);
    return part < 0.5 ? mixed(low, middle, 2 * part) : mixed(middle, high, Math.min(1, 2 * part - 1));
  };

  /// The axes of a case's picture: up, to the right, and towards who looks from the front.
  function axesOf(system) {
    const up = upOf(system);
    const across = Math.abs(up[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
    const right = unit(plus(across, up, -dot(across, up)));
    return { up, right, toward: cross(right, up) };
  }

  /// The middle of what the exact motion covers; how far it reaches from there to all sides and up; its floor [m].
  function extent(system, exact, shapes, up) {
    const reach = shapes.map((shape, i) => Math.max(shape.ball ?? norm(shape.box), ...system.cables.flatMap(endsOf)
      .filter((end) => end.body === i).map((end) => norm(end.at))));
    const points = exact.way.flatMap((pose) => [...pose.bodies.map(({ p }, i) => [p, reach[i]]),
      ...system.cables.flatMap(endsOf).filter((end) => end.body === null).map((end) => [pointOf(end, pose), 0])]);
    const side = (k, sign) => sign * points.reduce((most, [p, by]) => Math.max(most, sign * p[k] + by), -Infinity);
    const centre = [0, 1, 2].map((k) => 0.5 * (side(k, 1) + side(k, -1)));
    const most = (value) => points.reduce((largest, [p, by]) => Math.max(largest, value(minus(p, centre)) + by), 1e-9);
    const [radius, high] = [most((off) => norm(plus(off, up, -dot(off, up)))), most((off) => Math.abs(dot(off, up)))];
    return { centre, radius: Math.max(radius, 0.3 * high), high: Math.max(high, 0.2 * radius),
      floor: points.reduce((least, [p, by]) => Math.min(least, dot(up, p) - by), Infinity) };
  }

  /// A length of 1, 2 or 5 times a power of ten, at most `most`.
  function round(most) {
    const power = 10 ** Math.floor(Math.log10(most));
    return [5, 2, 1].find((one) => one * power <= most) * power;
  }

  /// A line from `a` to `b` that is `length` long and hangs down: a parabola, by bisection of its depth.
  function hanging(a, b, length, down) {
    const control = (depth) => plus(scaled(plus(a, b), 0.5), down, depth);
    const curve = (depth) => Array.from({ length: 25 }, (_, i) => {
      const [s, c] = [i / 24, control(depth)];
      return plus(plus(scaled(a, (1 - s) ** 2), c, 2 * s * (1 - s)), b, s * s);
    });
    const measure = (points) => points.slice(1).reduce((sum, point, i) => sum + norm(minus(point, points[i])), 0);
    let [low, high] = [0, 2 * length];
    for (let i = 0; i < 20; ++i) {
      const half = 0.5 * (low + high);
      [low, high] = measure(curve(half)) < length ? [half, high] : [low, half];
    }
    return curve(low);
  }

  /// The points of a cable from piece to piece; what is slack hangs in the longest.
  function courseOf(cable, pose, free, down) {
    const points = endsOf(cable).map((end) => pointOf(end, pose));
    const distances = points.slice(1).map((point, i) => norm(minus(point, points[i])));
    const longest = distances.indexOf(Math.max(...distances));
    return points.slice(1).map((point, i) => (free > 0 && i === longest
      ? hanging(points[i], point, distances[i] + free, down) : [points[i], point]));
  }

  /// Dashes along `points`, about `size` long and as far apart.
  function dashes(points, size) {
    const along = [0];
    points.slice(1).forEach((point, i) => along.push(along[i] + norm(minus(point, points[i]))));
    const count = 2 * Math.min(100, Math.max(1, Math.round(along.at(-1) / size / 2))) - 1;
    const at = (part) => {
      const i = Math.min(points.length - 2, Math.max(0, along.findLastIndex((one) => one <= part * along.at(-1))));
      return plus(points[i], minus(points[i + 1], points[i]), (part * along.at(-1) - along[i]) / Math.max(1e-300, along[i + 1] - along[i]));
    };
    return Array.from({ length: (count + 1) / 2 }, (_, i) => [2 * i, 2 * i + 0.5, 2 * i + 1].map((k) => at(k / count)));
  }

  /// A circle about `centre` across `along`.
  function ring(centre, along, radius) {
    const across = unit(cross(along, Math.abs(along[0]) < 0.9 * norm(along) ? [1, 0, 0] : [0, 1, 0]));
    const other = unit(cross(along, across));
    return Array.from({ length: 17 }, (_, i) => plus(plus(centre, across, radius * Math.cos(i * Math.PI / 8)), other,
      radius * Math.sin(i * Math.PI / 8)));
  }

  /// A scene on `canvas`, in the size that it has on the page or in `size` [px], which has no stage.
  function scene(canvas, the_case, motions, size) {
    const { system } = the_case;
    const context = canvas.getContext('2d');
    const exact = motions.find((one) => one.reference);
    const { up, right, toward } = axesOf(system);
    const guess = the_case.extent;
    const shapes = system.bodies.map((body) => shapeOf(body, 0.012 * guess));
    const area = extent(system, exact, shapes, up);
    const alone = motions.length === 1;
    const bodies = motions.flatMap((motion) => shapes.map((shape, body) => ({ motion, body, shape, solid: motion === motions[alone ? 0 : 1],
      arms: system.cables.flatMap(endsOf).filter((end) => end.body === body && norm(end.at) > 0).map((end) => [[0, 0, 0], end.at]) })));
    const largest = Math.max(0, ...exact.path.cables.flatMap((cable) => cable.tension?.value ?? []));
    if (!size && stage()) {
      stage().build(bodies);
    }
    let [width, height, colours] = [1, 1, {}];
    let shown = [];

    function fit() {
      const ratio = size ? 2 : window.devicePixelRatio || 1;
      [width, height] = size ?? [canvas.clientWidth, canvas.clientHeight];
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
      colours = tautline.theme();
      return ratio;
    }

    /// The camera of the stage.
    function camera() {
      const slope = Math.tan(fov * Math.PI / 360);
      const [flat, steep] = [Math.cos(view.elevation), Math.abs(Math.sin(view.elevation))];
      const depth = area.radius * flat + area.high * steep;
      const upright = area.high * flat + area.radius * steep;
      const distance = (1.1 * Math.max(upright / slope, area.radius * height / width / slope) + 0.6 * depth) / view.zoom;
      const level = plus(scaled(right, Math.sin(view.azimuth)), toward, Math.cos(view.azimuth));
      const eye = plus(plus(area.centre, level, distance * Math.cos(view.elevation)), up, distance * Math.sin(view.elevation));
      return { eye, target: area.centre, up, fov, near: 0.04 * distance, far: distance + 30 * (area.radius + area.high), distance };
    }

    /// The panes of the picture: `place` gives the pixel of a point, null behind the viewer.
    function panes() {
      if (!size && stage()) {
        const { eye, target } = camera();
        const ahead = unit(minus(target, eye));
        const aside = unit(cross(ahead, up));
        const above = cross(aside, ahead);
        const scale = 0.5 * height / Math.tan(fov * Math.PI / 360);
        return [{ place: (p) => {
          const [x, y, z] = [aside, above, ahead].map((axis) => dot(axis, minus(p, eye)));
          return z > 0 ? [0.5 * width + scale * x / z, 0.5 * height - scale * y / z] : null;
        } }];
      }
      const beside = width > height;
      const [w, h] = beside ? [0.5 * width, height] : [width, 0.5 * height];
      const scale = 0.46 * Math.min(w / area.radius, h / area.high);
      return [['front', right], ['side', scaled(toward, -1)]].map(([name, axis], i) => {
        const [left, top] = beside ? [i * w, 0] : [0, i * h];
        return { name, left, top, w, h, scale, axis, place: (p) => [left + 0.5 * w + scale * dot(axis, minus(p, area.centre)),
          top + 0.5 * h - scale * dot(up, minus(p, area.centre))] };
      });
    }

    const styleOf = (motion, time) => {
      if (motion.reference) {
        return { colour: colours.ink, faces: mixed(colours.paper, colours.ink, 0.25) };
      }
      const { colour } = time > the_case.horizon ? { colour: colours.muted } : tautline.mark(motion.engine, motion.model);
      return { colour, faces: mixed(colour, colours.paper, 0.35) };
    };

    const isTaut = (motion, i, time) => tautline.motions.isTaut(motion.path, i, time);

    /// The cables of a motion as lines.
    function cables(motion, pose) {
      const width = motion.reference && !alone ? 1.6 : 2.6;
      return system.cables.flatMap((cable, i) => {
        if (!acts(cable, pose.time)) {
          return [];
        }
        const tension = motion.tension(i, pose.time);
        if (isTaut(motion, i, pose.time)) {
          const colour = tension === null || !(largest > 0) ? colours.accent : rampColour(colours.dark, tension / largest);
          return courseOf(cable, pose, 0).map((points) => ({ points, colour, width }));
        }
        const free = Math.max(0, gap(cable, pose));
        return courseOf(cable, pose, free, scaled(up, -1)).flatMap((points) => (points.length > 2
          ? dashes(points, 0.035 * (area.radius + area.high)).map((dash) => ({ points: dash, colour: colours.muted, width: 1.4 }))
          : [{ points, colour: colours.muted, width: 1.4 }]));
      });
    }

    /// Anchors as small crosses, rings as circles.
    function marks(pose) {
      const by = 0.022 * area.radius;
      return system.cables.flatMap((cable) => {
        const points = endsOf(cable).map((end) => pointOf(end, pose));
        return endsOf(cable).flatMap((end, i) => {
          const inside = i > 0 && i + 1 < points.length;
          const lines = inside ? [ring(points[i], minus(points[i + 1], points[i - 1]), by)]
            : end.body === null ? [right, up, toward].map((axis) => [plus(points[i], axis, -by), plus(points[i], axis, by)]) : [];
          return lines.map((line) => ({ points: line, colour: colours.ink, width: 2 }));
        });
      });
    }

    const trail = (motion, time, body, colour) => {
      const from = time - trailPart * exact.end;
      return { colour: mixed(colours.paper, colour, 0.5), width: 1, points: [...motion.way.filter((one) => one.time >= from
        && one.time < time), motion.pose(time)].map((pose) => pose.bodies[body].p) };
    };

    const onFloor = (p) => plus(p, up, area.floor - dot(up, p));
    const grid = round(0.45 * area.radius);
    /// The floor as a grid, with the world's axes at its corner.
    function ground() {
      const lines = [];
      const middle = [right, toward].map((axis) => grid * Math.round(dot(axis, area.centre) / grid));
      const count = Math.round(area.radius / grid);
      const at = (a, b) => plus(plus(scaled(up, area.floor), right, middle[0] + a * grid), toward, middle[1] + b * grid);
      for (let k = -count; k <= count; ++k) {
        lines.push([at(k, -count), at(k, count)], [at(-count, k), at(count, k)]);
      }
      const corner = at(-count, count);
      const axes = [0, 1, 2].map((k) => [corner, plus(corner, [0, 1, 2].map((one) => (one === k ? grid : 0)))]);
      return { axes, lines: [...lines.map((points) => ({ points, colour: colours.line, width: 1 })),
        ...axes.map((points) => ({ points, colour: colours.muted, width: 2 }))] };
    }

    /// A line from each body down to its point of the floor.
    const plumbs = (pose) => pose.bodies.flatMap(({ p }) => [{ points: [p, onFloor(p)], colour: colours.line, width: 1 },
      { points: ring(onFloor(p), up, 0.02 * area.radius), colour: colours.muted, width: 1 }]);

    function stroke(pane, { points, colour, width: line }) {
      const places = points.map(pane.place);
      if (places.includes(null)) {
        return;
      }
      context.beginPath();
      places.forEach((place, i) => context[i ? 'lineTo' : 'moveTo'](...place));
      Object.assign(context, { strokeStyle: colour, lineWidth: line, lineJoin: 'round' });
      context.stroke();
    }

    /// Rays around the end of a cable that has just become taut, and the cable thick.
    function flash(pane, motion, pose, speed, colour) {
      for (const impact of motion.impacts) {
        const age = (pose.time - impact.time) / (flashTime * speed);
        if (age > -1e-6 && age < 1) {
          context.globalAlpha = 1 - Math.max(0, age);
          for (const cable of impact.cables.map((i) => system.cables[i]).filter(Boolean)) {
            courseOf(cable, pose, 0).forEach((points) => stroke(pane, { points, colour, width: 4 }));
            const end = pane.place(pointOf(cable.to.body === null ? cable.from : cable.to, pose));
            for (let ray = 0; end && ray < 8; ++ray) {
              const [c, s] = [Math.cos(ray * Math.PI / 4 + 0.2), Math.sin(ray * Math.PI / 4 + 0.2)];
              context.beginPath();
              context.moveTo(end[0] + 8 * c, end[1] + 8 * s);
              context.lineTo(end[0] + 18 * c, end[1] + 18 * s);
              Object.assign(context, { strokeStyle: colours.flag, lineWidth: 2.4 });
              context.stroke();
            }
          }
          context.globalAlpha = 1;
        }
      }
    }

    function write(text, place, more = {}) {
      Object.assign(context, { font: `12px ${colours.font}`, fillStyle: colours.muted, textAlign: 'left', textBaseline: 'middle', ...more });
      context.fillText(text, ...place);
    }

    /// A body in a pane of the projections: its lines, and a light face under them.
    function drawFlat(pane, { shape, arms, solid }, { p, q }, { colour, faces }) {
      const placed = (points) => points.map((point) => plus(p, turned(q, point)));
      if (shape.ball) {
        context.beginPath();
        context.arc(...pane.place(p), pane.scale * shape.ball, 0, 2 * Math.PI);
        Object.assign(context, { fillStyle: faces, strokeStyle: colour, lineWidth: 1.6 });
        context.globalAlpha = solid ? 0.5 : 0;
        context.fill();
        context.globalAlpha = 1;
        context.stroke();
      }
      [...shape.lines, ...arms].forEach((points) => stroke(pane, { points: placed(points), colour, width: shape.ball ? 1 : 1.6 }));
    }

    function draw(time, speed) {
      const ratio = fit();
      context.clearRect(0, 0, width, height);
      const drawn = [...motions].reverse().map((motion) => ({ motion, pose: motion.pose(time), style: styleOf(motion, time) }))
        .filter(({ pose }) => pose.bodies.every(({ p }) => p.every(Number.isFinite)));
      shown = bodies.map((one) => ({ ...one, ...drawn.find(({ motion }) => motion === one.motion) })).filter((one) => one.pose);
      const floor = ground();
      const lines = [...floor.lines, ...plumbs(exact.pose(time)), ...drawn.flatMap(({ motion, pose, style }) => [
        ...pose.bodies.map((_, i) => trail(motion, time, i, style.colour)), ...cables(motion, pose)]), ...marks(exact.pose(time))];
      const on = size ? null : stage();
      if (on) {
        bodies.forEach((one, i) => {
          const found = shown.find((other) => other.motion === one.motion && other.body === one.body);
          on.place(i, found.pose.bodies[one.body], found.style.faces, found.style.colour);
        });
        on.draw(lines);
        context.drawImage(on.render(camera(), width, height, ratio), 0, 0, width, height);
      }
      for (const pane of panes()) {
        if (!on) {
          context.save();
          context.beginPath();
          context.rect(pane.left, pane.top, pane.w, pane.h);
          context.clip();
          [...floor.lines.slice(0, -3).map((line) => ({ ...line, points: line.points.map(onFloor) })),
            ...lines.slice(floor.lines.length)].forEach((line) => stroke(pane, line));
          shown.forEach((one) => drawFlat(pane, one, one.pose.bodies[one.body], one.style));
        }
        drawn.forEach(({ motion, pose, style }) => flash(pane, motion, pose, speed, style.colour));
        if (on) {
          floor.axes.forEach(([, end], k) => pane.place(end) && write('xyz'[k], plus(pane.place(end), [6, 0]), { fillStyle: colours.ink }));
        } else {
          context.restore();
          write(pane.name, [pane.left + 8, pane.top + 14], { fillStyle: colours.ink });
          context.strokeStyle = colours.line;
          context.strokeRect(pane.left, pane.top, pane.w, pane.h);
        }
      }
      const [length] = on ? [0] : panes().map((pane) => Math.min(pane.scale * grid, pane.w - 20));
      if (length > 0) {
        Object.assign(context, { fillStyle: colours.muted });
        context.fillRect(8, height - 13, length, 2);
      }
      write(tautline.inUnits(`${on ? 'grid ' : ''}${tautline.number(grid)} m`, the_case), [on ? 8 : 14 + length, height - 12]);
    }

    /// Each cable of the exact motion in words. The drawn gap is off by as much as the path.
    const words = (time) => system.cables.map((cable, i) => {
      const least = exact.path.error;
      const free = gap(cable, exact.pose(time));
      const tension = exact.tension(i, time);
      return `cable ${i} ${free === null ? (time < (cable.from_time ?? 0) ? 'not yet hooked up' : 'cut')
        : isTaut(exact, i, time) ? `taut${tension === null ? '' : ` with ${tautline.number(tension, 2)} N`}`
          : `slack by ${free > least ? tautline.number(free, 2) : `less than ${tautline.number(least, 1)}`} m`}`;
    }).join(', ');

    /// The size of a pixel in the middle of the picture [m].
    const pixel = () => (!size && stage() ? 2 * camera().distance * Math.tan(fov * Math.PI / 360) / height : 1 / panes()[0].scale);

    /// For tests: how it is looked at, and where the centre and the ends of the axes of each body, `lever` [m] long, are
    /// in the picture [px], as the stage has them.
    function seen() {
      const lever = 0.1 * area.radius;
      const tips = [[0, 0, 0], [lever, 0, 0], [0, lever, 0], [0, 0, lever]];
      const on = stage();
      const places = (pane, { pose, body }) => tips.map((tip) => pane.place(plus(pose.bodies[body].p, turned(pose.bodies[body].q, tip))));
      return { stage: Boolean(on), camera: camera(), width, height, lever, largest,
        panes: on ? [] : panes().map(({ place, ...pane }) => ({ ...pane, up, centre: area.centre })),
        bodies: shown.map((one, i) => ({ name: one.motion.name, body: one.body,
          at: on ? [on.seen(bodies.findIndex((other) => other.motion === one.motion && other.body === one.body), tips, width, height)]
            : panes().map((pane) => places(pane, one)) })) };
    }

    return { draw, words, pixel, seen, largest };
  }

  /// The controls that turn the picture on `canvas`; `again` draws it. `show` fits them to a case.
  function install(canvas, again) {
    const { make, select } = tautline;
    redraw = again;
    const look = (change) => {
      Object.assign(view, change);
      view.elevation = Math.min(steepest, Math.max(-steepest, view.elevation));
      view.zoom = Math.min(20, Math.max(0.3, view.zoom));
      again();
    };
    const turn = (right, above) => look({ azimuth: view.azimuth - right, elevation: view.elevation + above });
    const zoom = (by) => look({ zoom: view.zoom * by });
    let active = false;
    const turns = () => active && stage();

    const fingers = new Map();
    canvas.addEventListener('pointerdown', (event) => {
      if (turns() && event.button === 0) {
        fingers.set(event.pointerId, event);
        canvas.setPointerCapture(event.pointerId);
      }
    });
    canvas.addEventListener('pointermove', (event) => {
      const before = fingers.get(event.pointerId);
      if (!before) {
        return;
      }
      const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
      const [x, y] = [event.clientX - before.clientX, event.clientY - before.clientY];
      fingers.set(event.pointerId, event);
      if (other) {
        const apart = (one) => Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY);
        view.zoom *= apart(event) / Math.max(1, apart(before));
        turn(0.004 * x, 0.004 * y);
      } else {
        turn(0.008 * x, 0.008 * y);
      }
    });
    ['pointerup', 'pointercancel', 'lostpointercapture'].forEach((name) => canvas.addEventListener(name, (event) => fingers.delete(event.pointerId)));
    canvas.addEventListener('wheel', (event) => {
      if (turns() && (event.ctrlKey || event.metaKey)) {
        event.preventDefault();
        zoom(Math.exp(-0.002 * event.deltaY));
      }
    }, { passive: false });
    const step = 0.1; // [rad]
    const keys = { a: () => turn(step, 0), d: () => turn(-step, 0), w: () => turn(0, step), s: () => turn(0, -step),
      '+': () => zoom(1.15), '=': () => zoom(1.15), '-': () => zoom(1 / 1.15), 0: () => look(first) };
    canvas.addEventListener('keydown', (event) => {
      const own = keys[event.key.toLowerCase()];
      if (own && turns() && !event.ctrlKey && !event.altKey && !event.metaKey) {
        event.preventDefault();
        own();
      }
    });

    const button = (text, label, change) => make('button', { type: 'button', 'aria-label': label, title: label,
      on: { click: () => look(change) } }, text);
    const buttons = make('span', { class: 'controls' }, button('Front', 'look from the front', { azimuth: 0, elevation: 0 }),
      button('Side', 'look from the side', { azimuth: Math.PI / 2, elevation: 0 }),
      button('Above', 'look from above', { azimuth: 0, elevation: steepest }), button('As at first', 'look as at first (0)', first));
    const picture = select('Picture', [['space', 'in space'], ['flat', 'front and side']], view.flat ? 'flat' : 'space', (value) => {
      view.flat = value === 'flat';
      tautline.replay.load();
    });
    const keyWords = [['W', 'A', 'S', 'D'], ['+', '\u2212'], ['0']].map((list) => list.flatMap((key) => [' ', make('kbd', {}, key)]));
    const help = make('p', { class: 'replay-keys', id: 'replay-turn' }, 'In the picture: drag it to turn it; zoom by Ctrl and the wheel, or '
      + 'with two fingers. Where it has the focus,', ...keyWords[0], ' turn it,', ...keyWords[1], ' zoom,', ...keyWords[2], ' looks as at first.');
    const legend = make('div', { class: 'keys replay-cables' });

    function show(the_case, motions, { largest }) {
      active = Boolean(the_case.system);
      const on = turns();
      const none = !window.tautlineThree || theStage === null;
      picture.element.hidden = !active || none;
      buttons.hidden = help.hidden = !on;
      legend.hidden = !active;
      canvas.classList.toggle('turns', Boolean(on));
      canvas.setAttribute('aria-label', active ? `the moving bodies in space, ${on ? 'from where you look' : 'from the front and from the side'}`
        : 'the moving body');
      canvas[on ? 'setAttribute' : 'removeAttribute']('aria-describedby', 'replay-turn');
      if (!active) {
        return;
      }
      const { dark, accent } = tautline.theme();
      const untold = motions.filter((one) => one.path.cables.length > 0 && one.path.cables.every((cable) => !cable.tension));
      const key = (style, text) => make('span', { class: 'key' }, make('span', { class: 'sample', style, 'aria-hidden': 'true' }), text);
      legend.replaceChildren(
        ...(largest > 0 ? [key(`background: linear-gradient(to right, ${ramp(dark).join(', ')})`,
          tautline.inUnits(`taut, tension 0 to ${tautline.number(largest)} N`, the_case))] : []),
        ...(untold.length > 0 ? [key(`background: ${accent}`, largest > 0 ? `taut, tension not told: ${untold.map((one) => one.name).join('; ')}` : 'taut')] : []),
        key('border-top: 2px dashed var(--muted); height: 0', 'slack'),
        ...(none && !view.flat ? [make('span', { class: 'key' }, `Without ${window.tautlineThree ? 'WebGL in this browser' : 'three.js in this page'}: from the front and from the side.`)] : []));
    }

    return { buttons: [picture.element, buttons], help, legend, show };
  }

  return { scene, install, mixed };
})());
