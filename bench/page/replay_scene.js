// The picture of the replay on a canvas: anchors, cables (slack ones sag, taut ones are straight),
// bodies, the way they came, and a flash where a cable has just become taut.
(() => {
  'use strict';
  const { endOf, gap, isTaut } = tautline.motions;

  const dashes = { solid: [], dash: [7, 4], dot: [2, 3], dashdot: [7, 3, 2, 3], longdash: [12, 4],
    longdashdot: [12, 3, 2, 3] };
  /// The trail shows this part of the whole motion [-].
  const trailPart = 0.2;
  /// How long a flash lasts on the screen, whatever the speed [s].
  const flashTime = 0.35;

  /// What the motions cover [m], with room around it.
  function extent(system, motions) {
    const xs = system.geometry.map((cable) => cable.anchor[0]);
    const ys = system.geometry.map((cable) => cable.anchor[1]);
    const reach = Math.max(0, ...system.geometry.map((cable) => Math.hypot(...cable.attachment)));
    // the exact path alone: a run that flies away must not shrink it to a dot
    for (const { way } of motions.filter((one) => one.reference)) {
      for (const { x, y } of way) {
        xs.push(x - reach, x + reach);
        ys.push(y - reach, y + reach);
      }
    }
    const least = (values) => values.reduce((a, b) => Math.min(a, b));
    const largest = (values) => values.reduce((a, b) => Math.max(a, b));
    const [left, right, low, high] = [least(xs), largest(xs), least(ys), largest(ys)];
    const room = 0.07 * Math.max(right - left, high - low, 1e-9);
    return { left: left - room, right: right + room, low: low - room, high: high + room };
  }

  const bezierLength = (a, c, b) => {
    let [sum, x, y] = [0, a[0], a[1]];
    for (let i = 1; i <= 16; ++i) {
      const t = i / 16;
      const u = 1 - t;
      const nx = u * u * a[0] + 2 * u * t * c[0] + t * t * b[0];
      const ny = u * u * a[1] + 2 * u * t * c[1] + t * t * b[1];
      sum += Math.hypot(nx - x, ny - y);
      [x, y] = [nx, ny];
    }
    return sum;
  };

  /// The control point of the sagging curve from `a` to `b` that is `length` long: it hangs towards
  /// gravity, by bisection.
  function sag(a, b, length, gravity) {
    const size = Math.hypot(...gravity) || 1;
    const down = [gravity[0] / size, gravity[1] / size];
    const at = (depth) => [0.5 * (a[0] + b[0]) + depth * down[0], 0.5 * (a[1] + b[1]) + depth * down[1]];
    let [low, high] = [0, 2 * length];
    for (let i = 0; i < 24; ++i) {
      const half = 0.5 * (low + high);
      [low, high] = bezierLength(a, at(half), b) < length ? [half, high] : [low, half];
    }
    return at(low);
  }

  /// A scene on `canvas`, in the size that it has on the page or in `size` [px]; `draw(time, speed)` paints it.
  function scene(canvas, system, motions, size) {
    const context = canvas.getContext('2d');
    const area = extent(system, motions);
    const exact = motions.find((one) => one.reference);
    let place;
    let scale;
    let colours;

    const extentOnPage = () => size ?? [canvas.clientWidth, canvas.clientHeight];

    function fit() {
      const ratio = size ? 2 : window.devicePixelRatio || 1;
      const [width, height] = extentOnPage();
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
      scale = Math.min(width / (area.right - area.left), height / (area.high - area.low));
      const [midX, midY] = [0.5 * (area.left + area.right), 0.5 * (area.low + area.high)];
      place = (x, y) => [0.5 * width + scale * (x - midX), 0.5 * height - scale * (y - midY)];
      colours = tautline.theme();
    }

    function stroke(points, colour, width, dash = []) {
      context.beginPath();
      points.forEach((point, i) => context[i ? 'lineTo' : 'moveTo'](...point));
      Object.assign(context, { strokeStyle: colour, lineWidth: width });
      context.setLineDash(dash);
      context.stroke();
      context.setLineDash([]);
    }

    function drawCable(cable, taut, pose, style) {
      const [from, to] = [place(...cable.anchor), place(...endOf(cable, pose))];
      if (taut) {
        stroke([from, to], style.colour, style.width + 0.6);
        return;
      }
      const control = place(...sag(cable.anchor, endOf(cable, pose), cable.length, system.gravity));
      context.beginPath();
      context.moveTo(...from);
      context.quadraticCurveTo(...control, ...to);
      Object.assign(context, { strokeStyle: style.colour, lineWidth: 1 });
      context.setLineDash([4, 3]);
      context.stroke();
      context.setLineDash([]);
    }

    function drawBody(pose, style) {
      const centre = place(pose.x, pose.y);
      const corners = [...system.geometry].sort((a, b) => Math.atan2(a.attachment[1], a.attachment[0])
        - Math.atan2(b.attachment[1], b.attachment[0])).map((cable) => place(...endOf(cable, pose)));
      stroke(corners.length > 1 ? [...corners, corners[0]] : [centre, ...corners], style.colour,
        style.width + 1.6, style.dash);
      if (corners.length === 2) {
        corners.forEach((corner) => stroke([centre, corner], style.colour, 1));
      }
      context.fillStyle = style.colour;
      for (const [point, radius] of [[centre, 4.5], ...corners.map((corner) => [corner, 2.5])]) {
        context.beginPath();
        context.arc(...point, radius, 0, 2 * Math.PI);
        context.fill();
      }
      if (!style.filled) {
        context.fillStyle = colours.paper;
        context.beginPath();
        context.arc(...centre, 2.2, 0, 2 * Math.PI);
        context.fill();
      }
    }

    /// Rays around the attachment of a cable that has just become taut, and the cable thick.
    function drawFlash(motion, pose, time, speed, style) {
      for (const impact of motion.impacts) {
        const age = (time - impact.time) / (flashTime * speed);
        if (age > -1e-6 && age < 1) {
          for (const cable of impact.cables.map((i) => system.geometry[i]).filter(Boolean)) {
            const [x, y] = place(...endOf(cable, pose));
            context.globalAlpha = 1 - Math.max(0, age);
            stroke([place(...cable.anchor), [x, y]], style.colour, style.width + 3);
            for (let ray = 0; ray < 8; ++ray) {
              const [c, s] = [Math.cos(ray * Math.PI / 4 + 0.2), Math.sin(ray * Math.PI / 4 + 0.2)];
              stroke([[x + 8 * c, y + 8 * s], [x + 18 * c, y + 18 * s]], colours.flag, 2.4);
            }
            context.globalAlpha = 1;
          }
        }
      }
    }

    function drawTrail(motion, time, style) {
      const from = time - trailPart * exact.path.time[exact.path.time.length - 1];
      const points = motion.way.filter((one) => one.time >= from && one.time <= time)
        .map((one) => place(one.x, one.y));
      const now = motion.pose(time);
      context.globalAlpha = 0.45;
      stroke([...points, place(now.x, now.y)], style.colour, 1, style.dash);
      context.globalAlpha = 1;
    }

    const styleOf = (motion) => {
      const { colour, dash } = tautline.mark(motion.engine, motion.model);
      return motion.reference ? { colour: colours.ink, width: 1.8, dash: [], filled: true }
        : { colour, width: 1.2, dash: dashes[dash], filled: false };
    };

    function draw(time, speed) {
      fit();
      context.clearRect(0, 0, ...extentOnPage());
      const late = time > system.horizon;
      // the exact one last, on top; past the horizon the others are pale
      for (const motion of [...motions].sort((a, b) => Boolean(a.reference) - Boolean(b.reference))) {
        const style = styleOf(motion);
        if (late && !motion.reference) {
          style.colour = colours.muted;
        }
        const pose = motion.pose(time);
        if (Number.isFinite(pose.x)) {
          drawTrail(motion, time, style);
          system.geometry.forEach((cable, i) => drawCable(cable, isTaut(motion.path, i, time), pose, style));
          drawBody(pose, style);
          drawFlash(motion, pose, time, speed, style);
        }
      }
      for (const cable of system.geometry) {
        const [x, y] = place(...cable.anchor);
        stroke([[x - 8, y], [x + 8, y]], colours.ink, 2);
        for (let hatch = -6; hatch <= 6; hatch += 4) {
          stroke([[x + hatch - 2, y - 6], [x + hatch + 2, y]], colours.ink, 1);
        }
      }
    }

    /// Each cable of the exact motion as a word: "taut" or "slack by 0.12 m". The drawn gap is off by
    /// as much as the path.
    const words = (time) => system.geometry.map((cable, i) => {
      const free = gap(cable, exact.pose(time));
      const least = exact.path.error;
      return `cable ${i} ${isTaut(exact.path, i, time) ? 'taut'
        : `slack by ${free > least ? tautline.number(free, 2) : `less than ${tautline.number(least, 1)}`} m`}`;
    }).join(', ');

    /// What a pixel of the picture is [m].
    const pixel = () => 1 / scale;

    return { draw, words, pixel };
  }

  tautline.scene = scene;
})();
