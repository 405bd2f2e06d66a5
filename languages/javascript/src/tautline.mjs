// The exact motion of rigid bodies on slack cables: the C interface of tautline (tautline.h), compiled to WebAssembly.
// tautline.d.ts describes every function and its units. Needs nothing but a runtime: node 18 or later, a browser, a worker.

const OK = 0, BAD_OPTION = 4, BAD_TIME = 5, UNKNOWN_NAME = 7; // of tautline_status
const TOML = 0, JSON_TEXT = 1; // of tautline_format

/** The memory that the rows of one call may take [bytes]. Longer tables are asked in pieces, so that the module stays small. */
const ROOM = 1 << 22;

// The structs of tautline.h: int32 first, then doubles.
const OPTIONS = { law: 4, completion_error: 8, completion_speed: 16, completion_margin: 24, max_events: 32, max_steps: 36,
  until_locked: 40, swing_ahead: 44 }; // and where each member is [bytes]
const OPTIONS_SIZE = 48;
const SUMMARY = {
  integers: ["size", "status", "ending", "taut", "events", "impacts", "arcs", "accumulations"],
  doubles: ["end_time", "start_energy", "end_energy", "repeat_start", "repeat_period", "repeat_turn"],
};
const SETTLING = {
  integers: ["size", "cables", "permanent", "rests", "swings", "goes_round", "angle_of_cable", "reserved"],
  doubles: ["time", "uncertainty", "last_impact_speed", "", "last_impact_time", "", "swing_energy", "swing_period", "swing_least",
    "swing_largest", "swing_amplitude", "swing_tension"], // "": the second of two
};
const size_of = ({ integers, doubles }) => 4 * integers.length + 8 * doubles.length;

/** The cables of a set, in rising order. */
export function cables_of(set) {
  const found = [];
  for (let cable = 0; set >> cable !== 0; ++cable) if ((set >> cable) & 1) found.push(cable);
  return found;
}

const or_null = (number) => (Number.isNaN(number) ? null : number);

// ---- Numbers as the C++ library writes them, which the module asks for

/** The digits and the power of ten of `size` to as many `digits`. A tie goes to the even one; toExponential rounds it up. */
function rounded(size, digits) {
  const [exact, power] = size.toExponential(99).split("e"), all = exact.replace(".", ""); // a tie has at most 18 digits
  const is_down = all[digits - 1] % 2 === 0 && /^50*$/.test(all.slice(digits));
  const [mantissa, raised] = is_down ? [all.slice(0, digits), power] : size.toExponential(digits - 1).split("e");
  return [mantissa.replace(".", "").replace(/(?!^)0+$/, ""), Number(raised)];
}

/** The shorter of 12.5 and 1.25e+01, or the form of printf's %g where the `digits` are given. */
function number_text(value, digits) {
  if (!Number.isFinite(value)) return Number.isNaN(value) ? "nan" : value < 0 ? "-inf" : "inf";
  const size = Math.abs(value), sign = value < 0 || Object.is(value, -0) ? "-" : "";
  const [shortest, power] = size.toExponential().split("e");
  const [all, exponent] = digits > 0 ? rounded(size, digits) : [shortest.replace(".", ""), Number(power)];
  const mantissa = all.length > 1 ? `${all[0]}.${all.slice(1)}` : all;
  const scientific = `${mantissa}e${exponent < 0 ? "-" : "+"}${String(Math.abs(exponent)).padStart(2, "0")}`;
  const whole = () => (size >= 2 ** 53 && !(digits > 0) ? String(BigInt(size)) : all.padEnd(exponent + 1, "0"));
  const fixed = () => (exponent < 0 ? `0.${"0".repeat(-exponent - 1)}${all}`
    : all.length > exponent + 1 ? `${all.slice(0, exponent + 1)}.${all.slice(exponent + 1)}` : whole());
  const is_fixed = digits > 0 ? exponent >= -4 && exponent < digits : fixed().length <= scientific.length;
  return sign + (is_fixed ? fixed() : scientific);
}

// ---- Cases as text

/** A value in a sentence. */
function shown(value) {
  if (typeof value === "string") return JSON.stringify(value);
  if (typeof value === "bigint") return `${value}n`;
  if (typeof value === "function" || typeof value === "symbol") return `(a ${typeof value})`;
  return typeof value !== "object" || value === null ? String(value) : Array.isArray(value) || ArrayBuffer.isView(value) ? "(an array)" : "(an object)";
}
const is_object = (value) => typeof value === "object" && value !== null && !Array.isArray(value) && !ArrayBuffer.isView(value);

/**
 * A value as JSON with the bits of its numbers: JSON.stringify makes null of NaN, and 0 of -0. Adds sentences to `wrong`.
 * `around` are the objects that the value is in.
 */
function json(value, place, wrong, around = []) {
  const refuse = (what) => (wrong.push(`${place || "the case"}: ${what}`), "null");
  const quoted = (text) => (LONE_SURROGATE.test(text) ? refuse(`${JSON.stringify(text)} has half of a pair of UTF-16 (a lone surrogate), which is no character`)
    : JSON.stringify(text));
  switch (typeof value) {
    case "number":
      return Number.isFinite(value) ? (Object.is(value, -0) ? "-0.0" : String(value)) : refuse(`is ${value}, must be a finite number`);
    case "string":
      return quoted(value);
    case "boolean":
      return String(value);
    case "object":
      break;
    default:
      return refuse(`is a ${typeof value}, must be a number, text, a flag, an array or an object`);
  }
  if (value === null) return refuse("is null, leave the key out instead");
  if (around.includes(value)) return refuse("contains itself");
  if (around.length === DEEPEST) return refuse(`is in ${DEEPEST} arrays and objects, deeper than anything of a case`);
  const within = [...around, value];
  if (!is_object(value)) return `[${Array.from(value, (entry, index) => json(entry, `${place}[${index}]`, wrong, within)).join(",")}]`;
  const members = Object.entries(value).filter(([, member]) => member !== undefined);
  return `{${members.map(([key, member]) => `${quoted(key)}:${json(member, place ? `${place}.${key}` : key, wrong, within)}`).join(",")}}`;
}
const LONE_SURROGATE = /\p{Surrogate}/u;
const DEEPEST = 8;

/** A Float64Array of what a caller gave as `name`. */
function doubles_of(given, name) {
  if (given instanceof Float64Array) return given;
  const is_list = typeof given === "object" && given !== null && (typeof given.length === "number" || Symbol.iterator in given);
  if (!is_list) throw new TypeError(`${name} ${shown(given)} must be an array of numbers`);
  return Float64Array.from(Array.from(given), (entry, index) => {
    if (typeof entry !== "number") throw new TypeError(`${name}[${index}] ${shown(entry)} must be a number`);
    return entry;
  });
}

// ---- The module

async function compiled(source) {
  if (source instanceof WebAssembly.Module) return source;
  if (!(source instanceof URL || typeof source === "string")) return WebAssembly.compile(source);
  const address = String(source);
  if (globalThis.process?.versions?.node && !/^(https?|data|blob):/.test(address)) {
    const files = "node:fs/promises"; // not a literal, so that bundlers for browsers leave it alone
    const { readFile } = await import(/* @vite-ignore */ /* webpackIgnore: true */ files);
    return WebAssembly.compile(await readFile(address.startsWith("file:") ? new URL(address) : address));
  }
  const response = await fetch(source);
  if (!response.ok) throw new Error(`${address}: ${response.status} ${response.statusText}`);
  return WebAssembly.compile(await response.arrayBuffer());
}

/** Loads the module, from next to this file unless `source` says otherwise. */
export async function load(source = new URL("./tautline.wasm", import.meta.url)) {
  const module = await compiled(source);
  const decoder = new TextDecoder(), encoder = new TextEncoder();
  let C; // what the module exports
  const bytes = (at, length) => new Uint8Array(C.memory.buffer, at, length); // memory that grows makes old views useless
  const imports = { tautline: {
    write_number(value, digits, to) {
      const text = encoder.encode(number_text(value, digits));
      bytes(to, text.length).set(text);
      return text.length;
    },
    read_number(from, length) {
      const text = decoder.decode(bytes(from, length));
      return Number(text.replace(/^([+-]?)inf$/, "$1Infinity"));
    },
  } };
  for (const { module: space, name } of WebAssembly.Module.imports(module)) {
    (imports[space] ??= {})[name] ??= () => { throw new Error(`tautline: ${name} is not there`); };
  }
  const { exports } = await WebAssembly.instantiate(module, imports);
  // A function that does not return, as at a trap or where JavaScript's own stack ends, leaves what it has put on the stack.
  const top = exports.__stack_pointer;
  C = Object.fromEntries(Object.entries(exports).map(([name, thing]) => [name, typeof thing !== "function" ? thing : (...words) => {
    const before = top.value;
    try {
      return thing(...words);
    } catch (error) {
      top.value = before;
      if (!(error instanceof WebAssembly.RuntimeError)) throw error;
      throw new Error(`tautline: ${name} has failed (${error.message}); this is a mistake in tautline, which goes on without this answer`, { cause: error });
    }
  }]));
  C._initialize();

  /** Calls `act` with a function that finds room in the module: for `count` numbers of a type of array, or a copy of an array. */
  function with_room(act) {
    const taken = [];
    const room = (type, count) => {
      const at = C.malloc(Math.max(8, count * type.BYTES_PER_ELEMENT)) >>> 0;
      if (at === 0) throw new RangeError("memory is missing");
      taken.push(at);
      return at;
    };
    const copy = (array) => {
      const at = room(array.constructor, array.length);
      new array.constructor(C.memory.buffer, at, array.length).set(array);
      return at;
    };
    try {
      return act(room, copy);
    } finally {
      for (const at of taken) C.free(at);
    }
  }
  const copy_of = (type, at, count) => new type(C.memory.buffer, at, count).slice();
  const integer_at = (at) => new Int32Array(C.memory.buffer, at, 1)[0];

  /** Constant text. */
  function text_at(at) {
    const memory = new Uint8Array(C.memory.buffer);
    return decoder.decode(memory.subarray(at, memory.indexOf(0, at)));
  }
  /** The text that a function writes to the caller's room. */
  const text_of = (ask) => with_room((room) => {
    const length = ask(0, 0), at = room(Uint8Array, length + 1);
    ask(at, length + 1);
    return decoder.decode(bytes(at, length));
  });
  const sentences = (ask) => text_of(ask).split("\n").filter(Boolean);
  const check = (status) => {
    if (status !== OK) throw new Error(`tautline: ${text_at(C.tautline_status_text(status))}`);
  };
  /** The names of the values of an enumeration. */
  function names(name_of) {
    const found = [];
    for (let at; (at = name_of(found.length)) !== 0; ) found.push(text_at(at));
    return found;
  }
  const LAWS = names(C.tautline_law_name), KINDS = names(C.tautline_event_kind_name), ENDINGS = names(C.tautline_ending_name);

  /**
   * A table of `count` rows: one array for each column. A column is [type of array, entries in a row]; null is left out.
   * `ask` gets the first row, how many rows, the addresses of their columns, and the two functions of `with_room`.
   */
  function table(count, columns, ask) {
    const found = columns.map((column) => column && new column[0](count * column[1]));
    const bytes_of_row = columns.reduce((sum, column) => sum + (column ? column[0].BYTES_PER_ELEMENT * column[1] : 0), 8);
    const rows = Math.max(1, Math.floor(ROOM / bytes_of_row));
    for (let first = 0; first < count; first += rows) {
      const some = Math.min(rows, count - first);
      with_room((room, copy) => {
        const at = columns.map((column) => (column ? room(column[0], some * column[1]) : 0));
        ask(first, some, at, room, copy);
        columns.forEach((column, k) => {
          if (column) found[k].set(new column[0](C.memory.buffer, at[k], some * column[1]), first * column[1]);
        });
      });
    }
    return found;
  }
  /** The rows of one column. */
  const row = (column, width, index) => column.slice(index * width, (index + 1) * width);

  /** Structs as columns by name. */
  function columns_of({ integers, doubles }, structs) {
    const size = size_of({ integers, doubles }), count = structs.length / size;
    const view = new DataView(structs.buffer, structs.byteOffset, structs.byteLength), found = {};
    integers.forEach((name, k) => {
      found[name] = Int32Array.from({ length: count }, (_, i) => view.getInt32(i * size + 4 * k, true));
    });
    doubles.forEach((name, k) => {
      if (!name) return;
      const width = doubles[k + 1] === "" ? 2 : 1;
      found[name] = Float64Array.from({ length: count * width }, (_, i) =>
        view.getFloat64(Math.floor(i / width) * size + 4 * integers.length + 8 * (k + (i % width)), true));
    });
    return found;
  }
  /** One struct that a function fills. */
  const struct_of = (form, ask) => with_room((room, copy) => {
    const at = copy(Int32Array.of(size_of(form), ...new Array(size_of(form) / 4 - 1).fill(0)));
    check(ask(at));
    return columns_of(form, copy_of(Uint8Array, at, size_of(form)));
  });

  /** Calls `act` with the module's copy of a case, which it keeps for the next call: most ask for the same case again. */
  function with_case(text, name, act) {
    if (kept.text !== text || kept.name !== name) {
      const handle = with_room((room, copy) => {
        const form = encoder.encode(text);
        return C.tautline_case_from_text(copy(form), form.length, copy(encoder.encode(`${name}\0`)));
      });
      C.tautline_case_free(kept.handle);
      kept = { text, name, handle };
    }
    return act(kept.handle);
  }
  let kept = { handle: 0 };
  const refuse = (wrong) => {
    if (wrong.length > 0) throw new RangeError(wrong.join("\n"));
  };
  const without_name = (all) => all.map((sentence) => sentence.replace(/^case: /, ""));
  const problems_of = (handle) => sentences((to, room) => C.tautline_problems(handle, to, room));

  /** Calls `act` with the module's copy of a case, or with what is wrong with it. */
  function with_object(the_case, act) {
    const wrong = [], text = is_object(the_case) ? json(the_case, "", wrong) : "{}";
    if (text === "{}") {
      const is_array = Array.isArray(the_case) || ArrayBuffer.isView(the_case);
      wrong.push(`the case: ${is_array ? "is an array, " : ""}must be an object with the keys of a case file`);
    }
    return wrong.length > 0 ? act(0, wrong) : with_case(text, "case", (handle) => act(handle, without_name(problems_of(handle))));
  }
  /** The same where it must be right. */
  const with_sound = (the_case, act) => with_object(the_case, (handle, wrong) => (refuse(wrong), act(handle)));

  /** The address of options in the module. */
  function options_at(options, copy) {
    if (!is_object(options)) refuse([`options ${shown(options)} must be an object`]);
    const struct = new DataView(new ArrayBuffer(OPTIONS_SIZE)), wrong = [];
    struct.setInt32(0, OPTIONS_SIZE, true);
    for (const [name, value] of Object.entries(options)) {
      if (value === undefined) continue;
      const must = (right) => wrong.push(`${name} ${shown(value)} must be ${right}`);
      if (!Object.hasOwn(OPTIONS, name)) {
        wrong.push(`option ${name} is unknown: must be one of ${Object.keys(OPTIONS).join(", ")}`);
      } else if (name === "law") {
        LAWS.includes(value) ? struct.setInt32(OPTIONS.law, LAWS.indexOf(value), true) : must(`one of ${LAWS.join(", ")}`);
      } else if (name.startsWith("completion")) {
        typeof value === "number" && value > 0 ? struct.setFloat64(OPTIONS[name], value, true) : must("a number above 0");
      } else if (name.startsWith("max")) {
        const is_count = Number.isInteger(value) && value > 0 && value < 2 ** 31;
        is_count ? struct.setInt32(OPTIONS[name], value, true) : must("an integer above 0");
      } else {
        typeof value === "boolean" ? struct.setInt32(OPTIONS[name], Number(value), true) : must("true or false");
      }
    }
    const at = copy(new Uint8Array(struct.buffer));
    refuse([...wrong, ...sentences((to, room) => C.tautline_option_problems(at, to, room))]);
    return at;
  }

  const coordinates = with_object({
    name: "any", duration: 1, gravity: [0, 0], body: { mass: 1, inertia: 1 }, initial: { position: [0, 0] },
    cables: [{ anchor: [0, 0], attachment: [0, 0], length: 1, restitution: 1 }],
  }, (handle) => Object.freeze(Array.from({ length: C.tautline_coordinates(handle) }, (_, k) => Object.freeze({
    name: text_at(C.tautline_coordinate_name(handle, k)), unit: text_at(C.tautline_coordinate_unit(handle, k)),
  }))));
  const WIDTH = coordinates.length;

  const unused = new FinalizationRegistry((motion) => C.tautline_motion_free(motion));
  const frozen = (list) => Object.freeze(list.map(Object.freeze));

  class Motion {
    #motion; // its address in the module; 0: disposed
    #cables;
    #summary;
    #settling;
    #events;
    #horizon;

    constructor(motion, cables) {
      this.#motion = motion;
      this.#cables = cables;
      unused.register(this, motion, this);
    }

    get #alive() {
      if (this.#motion === 0) throw new Error("this motion has been disposed");
      return this.#motion;
    }
    dispose() {
      unused.unregister(this);
      C.tautline_motion_free(this.#motion);
      this.#motion = 0;
    }
    [Symbol.dispose ?? Symbol("dispose")]() { this.dispose(); }

    get ending() { return this.summary.ending; }
    get end_time() { return this.summary.end_time; }
    get summary() {
      if (!this.#summary) {
        const one = struct_of(SUMMARY, (to) => C.tautline_summarise(this.#alive, to));
        const [start] = one.repeat_start, [period] = one.repeat_period, [turn] = one.repeat_turn;
        this.#summary = Object.freeze({
          ending: ENDINGS[one.ending[0]], end_time: one.end_time[0], taut: Object.freeze(cables_of(one.taut[0])),
          events: one.events[0], impacts: one.impacts[0], arcs: one.arcs[0], accumulations: one.accumulations[0],
          start_energy: one.start_energy[0], end_energy: one.end_energy[0],
          repetition: Number.isNaN(start) ? null : Object.freeze({ start, period, turn }),
        });
      }
      return this.#summary;
    }
    get settling() {
      if (!this.#settling) {
        const one = struct_of(SETTLING, (to) => C.tautline_settle(this.#alive, to));
        this.#settling = Object.freeze({
          time: or_null(one.time[0]), uncertainty: or_null(one.uncertainty[0]), cables: Object.freeze(cables_of(one.cables[0])),
          permanent: one.permanent[0] !== 0, rests: one.rests[0] !== 0,
          swing: one.swings[0] === 0 ? null : Object.freeze({
            energy: one.swing_energy[0], period: one.swing_period[0], goes_round: one.goes_round[0] !== 0,
            angle_of: one.angle_of_cable[0] !== 0 ? "cable" : "body", least: or_null(one.swing_least[0]),
            largest: or_null(one.swing_largest[0]), amplitude: or_null(one.swing_amplitude[0]),
            tension: or_null(one.swing_tension[0]),
          }),
          last_impacts: frozen([...one.last_impact_speed].map((speed, k) => ({ speed, time: or_null(one.last_impact_time[k]) }))
            .filter(({ speed }) => !Number.isNaN(speed))),
        });
      }
      return this.#settling;
    }

    /** Rows of columns of the motion, from the first on. */
    #rows(count, columns, ask) {
      return table(count, columns, (first, some, at) => check(ask(this.#alive, first, some, ...at)));
    }
    get events() {
      if (!this.#events) {
        const count = this.summary.events, cables = this.#cables;
        const [time, kind, sets, before, after, impulses] = this.#rows(count, [[Float64Array, 1], [Int32Array, 1],
          [Int32Array, 1], [Float64Array, WIDTH], [Float64Array, WIDTH], [Float64Array, cables]], C.tautline_events);
        this.#events = frozen(Array.from(time, (at, k) => ({
          time: at, kind: KINDS[kind[k]], cables: Object.freeze(cables_of(sets[k])), before: row(before, WIDTH, k),
          after: row(after, WIDTH, k), impulses: row(impulses, cables, k),
        })));
      }
      return this.#events;
    }
    get arcs() {
      const [start, end, taut] = this.#rows(this.summary.arcs, [[Float64Array, 1], [Float64Array, 1], [Int32Array, 1]],
        C.tautline_arcs);
      return Array.from(start, (at, k) => ({ start: at, end: end[k], taut: cables_of(taut[k]) }));
    }
    get accumulations() {
      const [start, limit, uncertainty, sets, lost] = this.#rows(this.summary.accumulations, [[Float64Array, 1],
        [Float64Array, 1], [Float64Array, 1], [Int32Array, 1], [Float64Array, 1]], C.tautline_accumulations);
      return Array.from(start, (at, k) => ({
        start: at, limit: limit[k], uncertainty: uncertainty[k], cables: cables_of(sets[k]), energy_lost: lost[k],
      }));
    }

    /** Columns at times. */
    #at(times, columns, ask) {
      const all = doubles_of(times, "times");
      return table(all.length, columns, (first, some, at, room, copy) => {
        const wrong = room(Int32Array, 1);
        const status = ask(this.#alive, copy(all.subarray(first, first + some)), some, ...at, wrong);
        if (status === BAD_TIME) {
          const index = first + integer_at(wrong);
          throw new RangeError(`times[${index}] = ${all[index]} is outside of the motion, which lasts from 0 to ${this.end_time} s`);
        }
        check(status);
      });
    }
    states(times) { return this.#at(times, [[Float64Array, WIDTH], null], C.tautline_states)[0]; }
    taut(times) { return this.#at(times, [null, [Int32Array, 1]], C.tautline_states)[1]; }
    tensions(times) { return this.#at(times, [[Float64Array, this.#cables]], C.tautline_tensions)[0]; }
    energy(times) {
      const one = [Float64Array, 1], [kinetic, potential, total] = this.#at(times, [one, one, one], C.tautline_energy);
      return { kinetic, potential, total };
    }
    state_errors(times) { return this.#at(times, [[Float64Array, WIDTH], null], C.tautline_state_errors)[0]; }
    energy_errors(times) { return this.#at(times, [null, [Float64Array, 1]], C.tautline_state_errors)[1]; }

    get #sure() {
      this.#horizon ??= with_room((room) => {
        const horizon = room(Float64Array, 1), lock = room(Float64Array, 1), unsure = room(Int32Array, 1);
        check(C.tautline_horizon(this.#alive, horizon, lock, unsure));
        return { horizon: copy_of(Float64Array, horizon, 1)[0], lock: copy_of(Float64Array, lock, 1)[0], unsure: integer_at(unsure) };
      });
      return this.#horizon;
    }
    get horizon() { return this.#sure.horizon; }
    get lock_error() { return or_null(this.#sure.lock); }
    get unsure() {
      const [from, until, kind, sets] = this.#rows(this.#sure.unsure, [[Float64Array, 1], [Float64Array, 1], [Int32Array, 1],
        [Int32Array, 1]], C.tautline_unsure);
      return Array.from(from, (at, k) => ({
        from: at, until: until[k], tie: kind[k] < 0 ? null : { kind: KINDS[kind[k]], cables: cables_of(sets[k]) },
      }));
    }
    event_errors() {
      const cables = this.#cables;
      const [time, rate, before, after, impulses, sets] = this.#rows(this.summary.events, [[Float64Array, 1], [Float64Array, 1],
        [Float64Array, WIDTH], [Float64Array, WIDTH], [Float64Array, cables], [Int32Array, 1]], C.tautline_event_errors);
      return Array.from(time, (at, k) => ({
        time: at, rate: rate[k], before: row(before, WIDTH, k), after: row(after, WIDTH, k), impulses: row(impulses, cables, k),
        indeterminate: cables_of(sets[k]),
      }));
    }
  }

  return Object.freeze({
    version: text_at(C.tautline_version()),
    coordinates,

    read(text, name = "case") {
      refuse(LONE_SURROGATE.test(String(text)) ? [`${name}: has half of a pair of UTF-16 (a lone surrogate), which is no character`] : []);
      return with_case(String(text), String(name), (handle) => {
        refuse(problems_of(handle));
        return JSON.parse(case_text(handle, JSON_TEXT));
      });
    },
    write(the_case, format = "toml") {
      if (format !== "toml" && format !== "json") throw new RangeError(`format ${shown(format)} must be "toml" or "json"`);
      return with_sound(the_case, (handle) => case_text(handle, format === "toml" ? TOML : JSON_TEXT));
    },
    problems: (the_case) => with_object(the_case, (_, wrong) => wrong),
    notes: (the_case) => with_sound(the_case, (handle) =>
      without_name(sentences((to, room) => C.tautline_notes(handle, to, room)))),

    solve: (the_case, options = {}) => with_sound(the_case, (handle) => with_room((room, copy) => {
      const to = room(Int32Array, 1);
      check(C.tautline_solve(handle, options_at(options, copy), to));
      return new Motion(integer_at(to) >>> 0, C.tautline_cables(handle));
    })),

    sweep: (the_case, values, all_options = {}) => with_sound(the_case, (handle) => {
      if (!is_object(values)) throw new TypeError(`values ${shown(values)} must be an object with an array for each quantity`);
      if (!is_object(all_options)) refuse([`options ${shown(all_options)} must be an object`]);
      const { times = [], settling = false, ...options } = all_options;
      if (typeof settling !== "boolean") refuse([`settling ${shown(settling)} must be true or false`]);
      const quantities = Object.keys(values), arrays = quantities.map((name) => doubles_of(values[name], name));
      const count = arrays.length > 0 ? arrays[0].length : 1;
      arrays.forEach((array, k) => {
        if (array.length === count) return;
        throw new RangeError(`${quantities[k]} has ${array.length} values, ${quantities[0]} has ${count}: all must have as many`);
      });
      for (const name of quantities) {
        const [, index] = /^restitution(?:_(\d+))?$/.exec(name) ?? [null, -1], has_table = ({ restitution_table }) => restitution_table?.length > 0;
        if (index !== -1 && the_case.cables.filter((_, k) => index === undefined || k === Number(index)).some(has_table)) {
          throw new RangeError(`${name}: a cable has a restitution_table, which replaces it`);
        }
      }
      const at_times = doubles_of(times, "times"), width = at_times.length * WIDTH;
      const [summaries, settlings, states] = table(count, [[Uint8Array, size_of(SUMMARY)],
        settling ? [Uint8Array, size_of(SETTLING)] : null, width > 0 ? [Float64Array, width] : null],
      (first, some, [summary, settled, to], room, copy) => {
        const rows = new Float64Array(some * arrays.length), wrong = room(Int32Array, 1);
        arrays.forEach((array, k) => { for (let i = 0; i < some; ++i) rows[i * arrays.length + k] = array[first + i]; });
        const named = copy(Uint32Array.from(quantities, (name) => copy(encoder.encode(`${name}\0`))));
        const how = options_at(options, copy), from = copy(rows), asked = copy(at_times);
        new Int32Array(C.memory.buffer, summary, 1)[0] = size_of(SUMMARY);
        if (settling) new Int32Array(C.memory.buffer, settled, 1)[0] = size_of(SETTLING);
        const status = C.tautline_sweep_varied(handle, named, arrays.length, from, some, how, 1, asked, at_times.length,
          summary, settled, to, wrong);
        const index = integer_at(wrong);
        if (status === UNKNOWN_NAME) throw new RangeError(`${quantities[index]}: no number of the case has this name`);
        if (status === BAD_TIME) throw new RangeError(`times[${index}] = ${at_times[index]} must be at least 0 and finite`);
        check(status);
      });
      const { size, status, ending, ...numbers } = columns_of(SUMMARY, summaries);
      const solved = Uint8Array.from(status, (one) => Number(one === OK));
      const found = { count, solved, ending: Array.from(ending, (one, k) => (solved[k] ? ENDINGS[one] : "")), ...numbers };
      if (settling) {
        const { size: _, reserved, ...columns } = columns_of(SETTLING, settlings);
        found.settlings = columns;
      }
      if (states) found.states = states;
      return found;
    }),
  });

  function case_text(handle, format) {
    return text_of((to, room) => with_room((more) => {
      const length = more(Int32Array, 1);
      check(C.tautline_case_text(handle, format, to, room, length));
      return integer_at(length);
    }));
  }
}
