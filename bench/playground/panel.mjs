// The controls: sliders, the engine, the fog, every number of the case, and the ways to take it along.

import { APART, endOf, LAWS, MOST_CABLES, RATES, spell, startOf } from "./case.mjs";
import { gyration, reach } from "./scene.mjs";
import { short } from "./words.mjs";

/// An element with attributes and children; a function is a listener.
export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (value !== undefined && value !== false) element.setAttribute(name, value);
  }
  element.append(...children.filter((one) => one !== undefined));
  return element;
}

/// The presets, each with its address.
const PRESETS = [["standard case", "case=breakwater/1910121100"], ["bouncing ball", "case=bouncing-ball"],
  ["elastic for ever", "name=elastic for ever&duration=30&gravity=0,-1&body=1,0.01&start=0,0.3,0,0.2,-0.1,0&cable=-1,1.2,-0.1,0,1.5,1&cable=1,1.2,0.1,0,1.5,1"],
  ["caught at once", "case=level-beam"], ["plate on four cables", "case=plate-four-cables"], ["crane", "case=crane-load"]];

const range = (values) => {
  const low = Math.min(...values), high = Math.max(...values);
  return low === high ? short(low) : `${short(low)} to ${short(high)}`;
};

/// The sliders. `set(case, value, picture of the case when it was loaded)`.
const SLIDERS = [
  { label: "restitution", limits: () => [0, 1, 0.01], get: ({ cables }) => cables[0].restitution,
    text: ({ cables }) => (cables.some((one) => one.restitution_table || one.capture_speed) ? "by speed" : range(cables.map((one) => one.restitution))),
    set(one, value) {
      for (const cable of one.cables) {
        cable.restitution = value;
        delete cable.restitution_table;
        delete cable.capture_speed;
      }
    } },
  { label: "length of the cables", unit: "m", limits: ({ cables: [{ length }] }) => [0.5 * length, 2 * length, 0.01 * roundedDown(length)],
    get: ({ cables }) => cables[0].length, text: ({ cables }) => range(cables.map((one) => one.length)),
    set(one, value) {
      const [{ length: before }] = one.cables;
      for (const cable of one.cables) {
        cable.length = cable.length === before ? value : Number((cable.length * (value / before)).toPrecision(12));
        delete cable.taut;
      }
    } },
  { label: "inertia", unit: "kg m²", limits: (one) => [0, 2 * Math.max(gyration(one), reach(one), 0.05 * one.cables[0].length), "any"], get: gyration,
    text: ({ body: { inertia } }) => (inertia === 0 ? "point mass" : short(inertia)),
    set(one, radius) { one.body.inertia = Number((one.body.mass * radius * radius).toPrecision(4)); } },
];
const roundedDown = (value) => 10 ** Math.floor(Math.log10(value));

/// The numbers of a case outside its cables: label, unit, and how they are read and written.
const pairOf = (get, place) => ({ get: (one) => get(one)[place], set: (one, value) => { get(one)[place] = value; } });
const memberOf = (get, key) => ({ get: (one) => get(one)[key], set: (one, value) => { get(one)[key] = value; } });
const start = (one) => one.initial, position = (one) => one.initial.position, velocity = (one) => one.initial.velocity;
const moves = (field) => ({ ...field, set(one, value) { field.set(one, value); one.cables.forEach((cable) => delete cable.taut); } });
const NUMBERS = [
  ["Start", [["x", "m", moves(pairOf(position, 0))], ["y", "m", moves(pairOf(position, 1))], ["angle", "rad", moves(memberOf(start, "angle"))],
    ["vx", "m/s", pairOf(velocity, 0)], ["vy", "m/s", pairOf(velocity, 1)], ["spin", "rad/s", memberOf(start, "spin")]]],
  ["Body and world", [["mass", "kg", memberOf((one) => one.body, "mass")], ["inertia", "kg m²", memberOf((one) => one.body, "inertia")],
    ["duration", "s", memberOf((one) => one, "duration")], ["gravity x", "m/s²", pairOf((one) => one.gravity, 0)], ["gravity y", "m/s²", pairOf((one) => one.gravity, 1)]]],
];
const numbersOfCable = (i) => {
  const cable = (one) => one.cables[i];
  const plain = (key) => ({ get: (one) => cable(one)[key] ?? 0, set(one, value) { cable(one)[key] = value; } });
  return [["anchor x", "m", moves(pairOf((one) => cable(one).anchor, 0))], ["anchor y", "m", moves(pairOf((one) => cable(one).anchor, 1))],
    ["attachment x", "m", moves(pairOf((one) => cable(one).attachment, 0))], ["attachment y", "m", moves(pairOf((one) => cable(one).attachment, 1))],
    ["length", "m", moves(plain("length"))],
    ["restitution", "", { get: plain("restitution").get, set(one, value) { plain("restitution").set(one, value); delete cable(one).restitution_table; } }],
    ["capture speed", "m/s", plain("capture_speed")]];
};

/// A further cable: slack, from the centre of the body against gravity, next to those that are there.
function addCable(one) {
  const [x, y] = startOf(one), [gx, gy] = one.gravity, g = Math.hypot(gx, gy);
  const lengths = one.cables.map(({ anchor, ...cable }) => Math.hypot(...endOf(cable, startOf(one)).map((at, k) => at - anchor[k])));
  const length = lengths.reduce((sum, each) => sum + each, 0) / lengths.length, turned = 0.35 * (one.cables.length - 1.5);
  const [ux, uy] = g === 0 ? [0, 1] : [-gx / g, -gy / g];
  const anchor = [x + length * (Math.cos(turned) * ux - Math.sin(turned) * uy), y + length * (Math.sin(turned) * ux + Math.cos(turned) * uy)];
  one.cables.push({ anchor: anchor.map((at) => Number(at.toFixed(3))), attachment: [0, 0], length: Number((1.1 * length).toPrecision(3)),
    restitution: one.cables[0].restitution });
}

function makePoint(one) {
  one.body.inertia = 0;
  [one.initial.angle, one.initial.spin] = [0, 0];
  for (const cable of one.cables) cable.attachment = [0, 0];
}

/// `page`: state, shipped, engines, address(), units(unit), change(edit, options), set(values), open(file), exports(), say(text).
export class Panel {
  #page;
  #sliders;
  #groups;
  #fields = [];
  #cables = make("div");
  #count = 0;
  #engine = make("select", { id: "engine" });
  #rate = make("select", { id: "rate" }, ...RATES.map((rate) => make("option", { value: rate }, `1/${rate} s`)));
  #sentence = make("p", { class: "note" });
  #law = make("select", { id: "law" }, ...LAWS.map((law) => make("option", {}, law)));
  #fog = make("input", { type: "checkbox", id: "fog" });
  #apart = make("select", { id: "apart", "aria-label": "how far the starts are apart" }, ...APART.map((apart) => make("option", { value: apart }, apart.toExponential(0))));
  #out = make("textarea", { id: "export", readonly: "", rows: 9, spellcheck: "false", "aria-label": "the chosen form of this case" });
  #every = make("details", { toggle: () => this.#showNumbers(this.#page.state.the_case, this.#page.units) });
  #take = make("details", { id: "take", toggle: () => this.showExport() });
  #form = "case file";
  #presets;

  constructor(box, page) {
    this.#page = page;
    this.#sliders = SLIDERS.map((slider) => this.#slider(slider));
    this.#groups = NUMBERS.map(([name, fields]) => make("fieldset", {}, make("legend", {}, name), make("div", { class: "numbers" }, ...fields.map((one) => this.#number(this.#fields, ...one)))));
    const link = ([text, address]) => make("a", { href: `#${encodeURI(address)}`, class: "chip" }, text);
    this.#presets = PRESETS.map(link);
    const set = (key, of) => ({ target }) => page.set({ [key]: of(target) });
    this.#engine.addEventListener("change", set("engineModel", ({ value }) => value));
    this.#rate.addEventListener("change", set("rate", ({ value }) => Number(value)));
    this.#law.addEventListener("change", set("law", ({ value }) => value));
    this.#fog.addEventListener("change", set("fog", ({ checked }) => checked));
    this.#apart.addEventListener("change", set("apart", ({ value }) => Number(value)));
    const file = make("input", { type: "file", accept: ".toml,.json", hidden: "", change: async ({ target }) => {
      const [chosen] = target.files;
      if (chosen) page.open(await chosen.text(), chosen.name);
      target.value = "";
    } });
    box.replaceChildren(
      make("nav", { "aria-label": "cases" }, make("h2", {}, "Begin with"), make("div", { class: "chips" }, ...this.#presets),
        make("details", {}, make("summary", {}, `All ${page.shipped.length} shipped cases`),
          make("ul", { class: "cases" }, ...page.shipped.map(({ name }) => make("li", {}, make("a", { href: `#case=${name}` }, name))))),
        make("button", { type: "button", class: "plain", click: () => file.click() }, "Open a case file…"), file),
      make("section", {}, make("h2", {}, "Change it"), ...this.#sliders.map(({ row }) => row),
        make("label", { class: "row", for: "law" }, make("span", {}, "law for several cables at once"), this.#law)),
      make("section", {}, make("h2", {}, "The fog"),
        make("div", { class: "row" }, make("label", { class: "check" }, this.#fog, make("span", {}, "150 exact futures of starts that differ by up to")), this.#apart)),
      make("section", {}, make("h2", {}, "An engine on the same start"),
        make("div", { class: "pair" }, make("label", {}, make("span", {}, "model"), this.#engine), make("label", {}, make("span", {}, "step"), this.#rate)), this.#sentence),
      this.#every,
      this.#take);
    this.#every.append(make("summary", {}, "Every number"), ...this.#groups, this.#cables,
      make("div", { class: "chips" }, make("button", { type: "button", class: "chip", id: "add", click: () => page.change(addCable) }, "Add a cable"),
        make("button", { type: "button", class: "chip", id: "point", click: () => page.change(makePoint) }, "Make it a point mass")));
    this.#take.append(make("summary", {}, "Take it with you"), this.#forms(), this.#out,
      make("div", { class: "chips" }, make("button", { type: "button", class: "chip", click: () => this.#copy() }, "Copy"),
        make("button", { type: "button", class: "chip", click: () => this.#save() }, "Save as a file")));
  }

  #slider({ label, get, set, text, limits, unit }) {
    const input = make("input", { type: "range", "aria-label": label }), told = make("output");
    input.addEventListener("input", () => this.#page.change((one) => set(one, input.valueAsNumber), { moving: true }));
    input.addEventListener("change", () => this.#page.drop());
    const row = make("label", { class: "slider" }, make("span", {}, label), told, input);
    return { row, show: (one, units, fresh) => {
      if (fresh) [input.min, input.max, input.step] = limits(one);
      if (input !== document.activeElement || fresh) input.value = get(one);
      told.textContent = `${text(one)}${/\d$/.test(text(one)) && unit ? units(unit) : ""}`;
      input.setAttribute("aria-valuetext", told.textContent);
    } };
  }

  /// A field for a number, which is shown to its last digit.
  #number(list, label, unit, { get, set }) {
    const input = make("input", { type: "number", step: "any", "aria-label": label });
    const unitOf = make("i");
    input.addEventListener("input", () => {
      if (Number.isFinite(input.valueAsNumber)) this.#page.change((one) => set(one, input.valueAsNumber));
    });
    list.push((one, units) => {
      if (input !== document.activeElement && input.value !== spell(get(one))) input.value = spell(get(one));
      unitOf.textContent = unit ? units(unit) : "";
    });
    return make("label", {}, make("span", {}, label, unitOf), input);
  }

  #forms() {
    const names = Object.keys(this.#page.forms);
    return make("div", { class: "chips", role: "radiogroup", "aria-label": "form" }, ...names.map((name) => make("label", { class: "chip" },
      make("input", { type: "radio", name: "form", value: name, ...(name === this.#form && { checked: "" }), change: () => {
        this.#form = name;
        this.showExport();
      } }), name)));
  }

  /// Writes the chosen form; while a hand moves there is none.
  showExport() {
    const text = this.#take.open ? this.#page.forms[this.#form].text() : "";
    if (text) this.#out.value = text;
  }

  async #copy() {
    try {
      await navigator.clipboard.writeText(this.#out.value);
    } catch { // not allowed: the old way
      this.#out.select();
      document.execCommand("copy");
    }
    this.#page.say("Copied.");
  }

  #save() {
    const address = URL.createObjectURL(new Blob([this.#out.value], { type: "text/plain" }));
    make("a", { href: address, download: this.#page.forms[this.#form].file() }).click();
    setTimeout(() => URL.revokeObjectURL(address), 1000);
  }

  #showNumbers(the_case, units) {
    for (const show of [...this.#fields, ...this.#ofCables]) show(the_case, units);
  }

  /// The models that are here, once the worker has said so.
  engines(engines) {
    this.#engine.replaceChildren(make("option", { value: "" }, "none"), ...engines.map(({ name, version, models }) => make("optgroup", { label: `${name} ${version}` },
      ...models.map((model) => make("option", { value: `${name}/${model.name}` }, `${name} ${model.name}`)))));
  }

  /// `fresh`: another case, whose sliders have other ends.
  show(state, units, fresh) {
    const { the_case } = state;
    for (const slider of this.#sliders) slider.show(the_case, units, fresh);
    if (the_case.cables.length !== this.#count) this.#makeCables(the_case.cables.length);
    if (this.#every.open) this.#showNumbers(the_case, units);
    this.#law.value = state.law;
    this.#law.disabled = the_case.cables.length === 1;
    this.#fog.checked = state.fog;
    this.#apart.value = state.apart;
    this.#engine.value = state.model === "" ? "" : `${state.engine}/${state.model}`;
    this.#rate.value = state.rate;
    this.#rate.disabled = state.model === "";
    const model = this.#page.engines.find(({ name }) => name === state.engine)?.models.find(({ name }) => name === state.model);
    this.#sentence.textContent = state.model === "" ? "" : model?.sentence ?? (this.#page.engines.length > 0 ? `This page has no ${state.engine} ${state.model}.` : "");
    for (const one of this.#presets) {
      if (one.getAttribute("href") === `#${this.#page.address()}`) one.setAttribute("aria-current", "true");
      else one.removeAttribute("aria-current");
    }
    this.showExport();
  }

  #ofCables = [];
  #makeCables(count) {
    this.#count = count;
    this.#ofCables = [];
    this.#cables.replaceChildren(...Array.from({ length: count }, (_, i) => make("fieldset", {}, make("legend", {}, `Cable ${i}`),
      make("div", { class: "numbers" }, ...numbersOfCable(i).map((one) => this.#number(this.#ofCables, ...one))),
      ...(count > 1 ? [make("button", { type: "button", class: "plain", click: () => this.#page.change((one) => { one.cables.splice(i, 1); }) }, `Remove cable ${i}`)] : []))));
    document.getElementById("add")?.toggleAttribute("disabled", count >= MOST_CABLES);
  }
}
