// What a hand takes hold of: the body, how it is turned, its velocity, and both ends of each cable. A handle is a button
// over the picture, so that a mouse, a finger and the keyboard reach the same ones.

import { endOf, startOf } from "./case.mjs";
import { gyration, knobOf, tipOf, toScreen, toWorld, velocityOf } from "./scene.mjs";

/// Attachments that are nearer to the centre of the body leave it to the hand [px].
const NEAR = 26;

/// A moved body is no longer on a cable that began taut.
const slackened = (one) => one.cables.forEach((cable) => delete cable.taut);

/// `place(picture)` is where a handle is in the world, `move(case, place, picture)` puts it elsewhere, `nudge(case, [dx, dy])`
/// moves it by a little, `more` turns or lengthens, `round(case, to)` rounds what these changed. `always`: also seen while the
/// body moves.
const body = {
  name: () => "body", always: true,
  place: ({ the_case, motion, time }) => (time > 0 && motion ? motion.at(time) : startOf(the_case)),
  move(one, place) { one.initial.position = place; slackened(one); },
  nudge(one, [dx, dy]) { this.move(one, [one.initial.position[0] + dx, one.initial.position[1] + dy]); },
  more(one, by) { turn.more(one, by); },
  round({ initial }, to) { initial.position = initial.position.map(to); },
  says: ({ initial: { position: [x, y] } }) => `at ${x}, ${y}. Arrow keys move it, plus and minus turn it`,
};

const turn = {
  name: () => "turn",
  place: ({ the_case, view }) => knobOf(the_case, view),
  move(one, [x, y]) {
    const [bx, by] = one.initial.position, { angle } = one.initial, to = Math.atan2(x - bx, by - y);
    one.initial.angle = angle + Math.atan2(Math.sin(to - angle), Math.cos(to - angle)); // no jump by a turn
    slackened(one);
  },
  nudge(one, [dx, dy]) { one.initial.angle += dx + dy; slackened(one); },
  more(one, by) {
    this.nudge(one, [by, 0]);
    this.round(one, tidy);
  },
  round({ initial }, to) { initial.angle = to(initial.angle); },
  says: ({ initial: { angle } }) => `angle ${angle}. Arrow keys turn the body`,
};

const velocity = {
  name: () => "velocity",
  place: ({ the_case, view }) => tipOf(the_case, view),
  move(one, place, { view }) { one.initial.velocity = velocityOf(one, place, view); },
  nudge(one, [dx, dy]) { one.initial.velocity = [one.initial.velocity[0] + dx, one.initial.velocity[1] + dy]; },
  more(one, by) { one.initial.spin = tidy(one.initial.spin + by); },
  round({ initial }, to) { initial.velocity = initial.velocity.map(to); },
  says: ({ initial: { velocity: [vx, vy], spin } }) => `${vx}, ${vy}, spin ${spin}. Arrow keys change it, plus and minus change the spin`,
};

function lengthen(cable, by) {
  cable.length = tidy(cable.length + by);
  delete cable.taut;
}

const anchor = (cable) => ({
  cable,
  name: () => `anchor of cable ${cable}`, always: true,
  place: ({ the_case }) => the_case.cables[cable].anchor,
  move(one, place) { one.cables[cable].anchor = place; slackened(one); },
  nudge(one, [dx, dy]) { this.move(one, [one.cables[cable].anchor[0] + dx, one.cables[cable].anchor[1] + dy]); },
  more: (one, by) => lengthen(one.cables[cable], by),
  round({ cables }, to) { cables[cable].anchor = cables[cable].anchor.map(to); },
  says: ({ cables }) => `at ${cables[cable].anchor.join(", ")}. Arrow keys move it, plus and minus change the length of the cable`,
});

const attachment = (cable) => ({
  cable, onBody: true,
  name: () => `attachment of cable ${cable}`,
  place: ({ the_case }) => endOf(the_case.cables[cable], startOf(the_case)),
  move(one, [x, y]) {
    const { position: [bx, by], angle } = one.initial, c = Math.cos(angle), s = Math.sin(angle);
    one.cables[cable].attachment = [c * (x - bx) + s * (y - by), c * (y - by) - s * (x - bx)];
    slackened(one);
  },
  nudge(one, [dx, dy]) {
    const [x, y] = endOf(one.cables[cable], startOf(one));
    this.move(one, [x + dx, y + dy]);
  },
  more: (one, by) => lengthen(one.cables[cable], by),
  round({ cables }, to) { cables[cable].attachment = cables[cable].attachment.map(to); },
  says: ({ cables }) => `at ${cables[cable].attachment.join(", ")} on the body. Arrow keys move it, plus and minus change the length of the cable`,
});

const handlesOf = ({ cables, body: { inertia } }) => [
  body, ...(inertia > 0 ? [turn] : []), velocity,
  // several cables at the centre of a body: its own handle is there
  ...(inertia > 0 ? cables.flatMap(({ attachment: at }, cable) => (Math.hypot(...at) > 0 ? [attachment(cable)] : [])) : []),
  ...cables.map((_, cable) => anchor(cable)),
];

/// A number to the digits that a pixel shows.
const rounded = (view) => {
  const digits = Math.min(15, Math.max(0, Math.ceil(Math.log10(view.scale))));
  return (value) => Number(value.toFixed(digits));
};
const tidy = (value) => Number(value.toPrecision(12));

/// Puts handles into `box`. `page`: picture(), grab(), change(edit, {moving}), drop(), cancel().
export class Handles {
  #box;
  #page;
  #made = [];
  #shape = "";
  #pressed; // where, until it has moved
  #held; // from the pointer to the handle, in the world

  constructor(box, page) {
    this.#box = box;
    this.#page = page;
  }

  /// Whether these handles repeat others: then they are for the hand alone.
  repeat(yes) {
    this.#box.toggleAttribute("data-repeats", yes);
    if (yes) this.#box.setAttribute("aria-hidden", "true");
    else this.#box.removeAttribute("aria-hidden");
    for (const { button } of this.#made) button.tabIndex = yes ? -1 : 0;
  }

  /// Brings the buttons to where they belong in a box of this size [px].
  place(picture, [width, height]) {
    const { the_case, time, view } = picture, atStart = time === 0;
    const shape = the_case.cables.map(({ attachment: at }) => (Math.hypot(...at) > 0 ? 1 : 0)).join("") + (the_case.body.inertia > 0);
    if (shape !== this.#shape && !this.#held) {
      this.#shape = shape;
      this.#make(the_case);
    }
    const to = toScreen(view, width, height);
    for (const { handle, button } of this.#made) {
      const [x, y] = handle.cable >= the_case.cables.length ? [NaN, NaN] : to(handle.place(picture));
      const seen = (handle.always || atStart) && (Boolean(this.#held) || (x >= 0 && x <= width && y >= 0 && y <= height));
      if (button.hidden === seen) button.hidden = !seen;
      if (!seen) continue;
      if (handle.onBody) { // a finger that is to reach the body must not hit these; keys and the close view still reach them
        const [bx, by] = to(the_case.initial.position);
        button.style.pointerEvents = Math.hypot(x - bx, y - by) < NEAR ? "none" : "";
      }
      if (handle === body) button.style.setProperty("--size", `${Math.max(52, 2 * gyration(the_case) * view.scale).toFixed(0)}px`);
      button.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
      if (!this.#held && document.activeElement === button) button.setAttribute("aria-label", `${handle.name()}, ${handle.says(the_case)}`);
    }
  }

  #make(the_case) {
    const focused = this.#made.find(({ button }) => button === document.activeElement)?.handle.name();
    this.#made = handlesOf(the_case).map((handle) => {
      const button = document.createElement("button");
      button.type = "button";
      button.className = `handle ${handle.name().split(" ")[0]}`;
      button.setAttribute("aria-label", `${handle.name()}, ${handle.says(the_case)}`);
      button.title = handle.name();
      button.addEventListener("focus", () => button.setAttribute("aria-label", `${handle.name()}, ${handle.says(this.#page.picture().the_case)}`));
      button.addEventListener("pointerdown", (event) => this.#grab(event, button));
      button.addEventListener("pointermove", (event) => this.#move(event, handle));
      button.addEventListener("pointerup", () => this.#drop());
      button.addEventListener("pointercancel", () => this.#cancel());
      button.addEventListener("keydown", (event) => this.#key(event, handle));
      return { handle, button };
    });
    this.#box.replaceChildren(...this.#made.map(({ button }) => button));
    this.repeat(this.#box.hasAttribute("data-repeats"));
    this.#made.find(({ handle }) => handle.name() === focused)?.button.focus();
  }

  #at(event) {
    const box = this.#box.getBoundingClientRect(), { view } = this.#page.picture();
    return toWorld(view, box.width, box.height)([event.clientX - box.left, event.clientY - box.top]);
  }

  #grab(event, button) {
    if (event.button !== 0) return;
    button.setPointerCapture(event.pointerId);
    this.#pressed = [event.clientX, event.clientY];
  }

  #move(event, handle) {
    const since = performance.now();
    if (!this.#held) {
      if (!this.#pressed || Math.hypot(event.clientX - this.#pressed[0], event.clientY - this.#pressed[1]) < 3) return; // a click
      const [clientX, clientY] = this.#pressed, [x, y] = this.#at({ clientX, clientY }), [hx, hy] = handle.place(this.#page.picture());
      this.#held = [hx - x, hy - y];
      this.#page.grab(handle === body);
    }
    const [x, y] = this.#at(event), [dx, dy] = this.#held, picture = this.#page.picture(), round = rounded(picture.view);
    this.#page.change((one) => {
      handle.move(one, [x + dx, y + dy], picture);
      handle.round(one, round);
    }, { moving: true, since });
  }

  #drop() {
    this.#pressed = undefined;
    if (!this.#held) return;
    this.#held = undefined;
    this.#page.drop();
  }

  #cancel() {
    this.#pressed = undefined;
    if (!this.#held) return;
    this.#held = undefined;
    this.#page.cancel();
  }

  #key(event, handle) {
    if (event.key === "Escape" && this.#held) return this.#cancel();
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    const more = { "+": 1, "=": 1, "-": -1, _: -1 }[event.key];
    if ((!arrows && !more) || event.ctrlKey || event.altKey || event.metaKey) return undefined;
    event.preventDefault();
    event.stopPropagation();
    // a step is a few pixels, with Shift a tenth of that
    const fine = event.shiftKey && arrows ? 0.1 : 1, step = fine * 10 ** Math.round(Math.log10(4 / this.#page.picture().view.scale));
    this.#page.grab(handle === body);
    this.#page.change((one) => {
      if (more) {
        handle.more(one, more * (handle === body || handle === turn ? 0.01 : step));
      } else {
        handle.nudge(one, arrows.map((part) => part * (handle === turn ? 0.01 * fine : step)));
        handle.round(one, tidy);
      }
    }, { nudge: true });
    return undefined;
  }
}
