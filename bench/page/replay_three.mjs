// The stage of a system in space, drawn with three.js where the browser has WebGL: bodies, and lines between points.
// bench/page/CMakeLists.txt bundles it with three.js into one script for pages with such a system.
import { BoxGeometry, Color, DirectionalLight, Group, HemisphereLight, Mesh, MeshLambertMaterial, PerspectiveCamera, Scene,
  SphereGeometry, Vector3, WebGLRenderer } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

/// The segments of a polyline, one after the other, as numbers.
const segments = (points) => points.slice(1).flatMap((point, i) => [...points[i], ...point]);

function geometryOf(lines) {
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(lines.flatMap(segments));
  return geometry;
}

/// A stage; none where the browser has no WebGL. `lost()` is called where it loses it.
export function stage(lost) {
  const element = document.createElement('canvas');
  if (!document.createElement('canvas').getContext('webgl2')) {
    return null;
  }
  let renderer;
  try {
    renderer = new WebGLRenderer({ canvas: element, antialias: true, alpha: true });
  } catch {
    return null;
  }
  element.addEventListener('webglcontextlost', lost);
  const scene = new Scene();
  const camera = new PerspectiveCamera();
  const light = new DirectionalLight('#ffffff', 1.6);
  scene.add(new HemisphereLight('#ffffff', '#888888', 1.9), light, light.target);
  let bodies = [];
  let strokes = [];
  let size = [];
  const inks = new Map(); // materials of lines, by width

  const free = (object) => {
    object.traverse((one) => { one.geometry?.dispose(); one.material?.dispose(); });
    scene.remove(object);
  };

  /// Puts `list` on the stage in place of the bodies before: {shape, arms, solid}; `arms` are lines in its axes.
  function build(list) {
    bodies.forEach(free);
    bodies = list.map(({ shape, arms, solid }) => {
      const group = new Group();
      const edges = new LineSegments2(geometryOf([...shape.lines, ...arms]), new LineMaterial({ linewidth: 1.6 }));
      const faces = new Mesh(shape.ball ? new SphereGeometry(shape.ball, 48, 32) : new BoxGeometry(...shape.box.map((side) => 2 * side)),
        new MeshLambertMaterial({ polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }));
      faces.visible = solid;
      group.add(edges, faces);
      scene.add(group);
      return group;
    });
  }

  /// Puts body `i` at a place, in its colours.
  function place(i, { p, q }, faces, edges) {
    const group = bodies[i];
    group.position.set(...p);
    group.quaternion.set(q[1], q[2], q[3], q[0]);
    group.children[0].material.color.set(edges);
    group.children[1].material.color.set(faces);
  }

  /// Draws polylines {points, colour, width} in place of those before.
  function draw(lines) {
    for (const stroke of strokes) {
      stroke.geometry.dispose();
      scene.remove(stroke);
    }
    const colour = new Color();
    strokes = [...new Set(lines.map((line) => line.width))].map((width) => {
      const own = lines.filter((line) => line.width === width && line.points.length > 1);
      const geometry = geometryOf(own.map((line) => line.points));
      geometry.setColors(own.flatMap((line) => {
        const { r, g, b } = colour.set(line.colour);
        return Array((line.points.length - 1) * 2).fill([r, g, b]).flat();
      }));
      if (!inks.has(width)) { // kept: a material that goes takes its program with it
        inks.set(width, new LineMaterial({ linewidth: width, vertexColors: true }));
      }
      const stroke = new LineSegments2(geometry, inks.get(width));
      stroke.frustumCulled = false;
      scene.add(stroke);
      return stroke;
    });
  }

  /// The picture, as a canvas of `width` times `height` pixels of the page.
  function render({ eye, target, up, fov, near, far }, width, height, ratio) {
    Object.assign(camera, { fov, near, far, aspect: width / height });
    camera.up.set(...up);
    camera.position.set(...eye);
    camera.lookAt(...target);
    camera.updateProjectionMatrix();
    light.position.set(...eye).addScaledVector(camera.up, near);
    light.target.position.set(...target);
    if (size.join() !== [width, height, ratio].join()) {
      size = [width, height, ratio];
      renderer.setPixelRatio(ratio);
      renderer.setSize(width, height, false);
    }
    scene.traverse((one) => one.material?.resolution?.set(width, height));
    renderer.render(scene, camera);
    return element;
  }

  /// The places of points of body `i`, in its axes, in the picture that was rendered [px].
  const seen = (i, points, width, height) => points.map((point) => {
    const { x, y } = bodies[i].localToWorld(new Vector3(...point)).project(camera);
    return [0.5 * width * (1 + x), 0.5 * height * (1 - y)];
  });

  return { build, place, draw, render, seen };
}
