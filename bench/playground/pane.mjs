// A view of the motion, with handles over it: from afar with the anchors, or close to the path.

import { Handles } from "./handles.mjs";
import { extent, fitted, Scene, sizeOf, watch } from "./scene.mjs";

/// A view moves to another one in this time [ms].
const GLIDE = 220;
/// It stays as it is while the path fills between these parts of it, and its middle is no farther off [-, -, px].
const [LOOSE, TIGHT, OFF] = [1.35, 0.98, 40];

export class Pane {
  #box;
  #canvas;
  #scene;
  #handles;
  #close;
  #page;
  #view;

  /// In `box`, which has a canvas and a place for handles. `page` is that of Handles, and has draw().
  constructor(box, close, page) {
    [this.#box, this.#close, this.#page] = [box, close, page];
    this.#canvas = box.querySelector("canvas");
    this.#scene = new Scene(this.#canvas);
    this.#handles = new Handles(box.querySelector(".handles"), { ...page, picture: () => ({ ...page.picture(), view: this.#view ?? this.#fitted() }) });
    watch(this.#canvas, () => {
      this.fit();
      page.draw();
    });
  }

  get seen() { return sizeOf(this.#canvas)[0] > 0; }

  /// Handles that only repeat those of another pane are left out of what is read and stepped through.
  repeat(yes) { this.#handles.repeat(yes); }

  draw(picture, the_case) {
    if (!this.seen) return;
    this.#view ??= this.#fitted();
    this.#scene.draw({ ...picture, view: this.#view });
    this.#handles.place({ ...picture, the_case, view: this.#view }, sizeOf(this.#canvas));
  }

  #fitted() {
    const { the_case, motion, impossible } = this.#page.picture();
    return fitted(extent(motion && !impossible ? motion.the_case : the_case, motion, this.#close), ...sizeOf(this.#canvas).map((one) => Math.max(one, 1)));
  }

  /// Shows all of the motion at once.
  fit() { this.#view = undefined; }

  /// Moves the view where the path has left it or fills little of it. `still`: in one step.
  glide(still) {
    if (!this.seen || !this.#view) return;
    const from = this.#view, to = this.#fitted(), factor = to.scale / from.scale;
    if (factor > TIGHT && factor < LOOSE && Math.hypot(to.x - from.x, to.y - from.y) * from.scale < OFF) return;
    const began = performance.now();
    let last = from;
    const step = (now) => {
      if (this.#view !== last) return; // another hand has moved it
      const part = still ? 1 : Math.min(1, Math.max(0, now - began) / GLIDE), eased = part * part * (3 - 2 * part);
      const between = (key) => from[key] + (to[key] - from[key]) * eased;
      last = this.#view = { x: between("x"), y: between("y"), scale: between("scale") };
      this.#page.draw();
      if (part < 1) requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  /// The view stays where it is, such as while a hand moves.
  hold() { this.#view &&= { ...this.#view }; }
}
