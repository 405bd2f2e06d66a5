/// <reference lib="esnext.disposable" />
/**
 * The exact motion of rigid bodies on slack cables.
 *
 * Names and units are those of case files. A state is a row of numbers, whose names and units `coordinates` has: x, y [m],
 * angle [rad], vx, vy [m/s] and spin [rad/s], anticlockwise. A set of cables in a typed array is an integer with bit i for
 * cable i; `cables_of` lists them.
 */

/** Two numbers: x and y, or a speed and its restitution. */
export type Pair = readonly number[] | Float64Array;

/** A massless inextensible line from a point of the world to a point of the body. */
export interface Cable {
  /** [m], in the world */
  anchor: Pair;
  /** [m], in the body's frame, from its centre of mass */
  attachment: Pair;
  /** [m], > 0 */
  length: number;
  /** [-], Newton's coefficient, 0 to 1 */
  restitution: number;
  /** Replaces `restitution`: pairs of speed [m/s] and restitution, in rising speed. */
  restitution_table?: readonly Pair[];
  /** [m/s], >= 0: a slower impact does not rebound. Default: 0 */
  capture_speed?: number;
  /** The cable starts taut, and the start is moved onto it as far as needed. Default: false */
  taut?: boolean;
}

/** One system, its start and its duration: the keys of a case file. */
export interface Case {
  name: string;
  /** [s], > 0: the motion ends there */
  duration: number;
  /** [m/s^2] */
  gravity: Pair;
  /** [rad], > 0: the motion ends where |angle| reaches it */
  angle_limit?: number;
  /** [m]: the motion ends where an attachment rises to it */
  ceiling?: number;
  body: {
    /** [kg], > 0 */
    mass: number;
    /** [kg m^2] about the centre of mass; 0 only for a point mass */
    inertia: number;
  };
  /** 1 to 8 */
  cables: readonly Cable[];
  initial: {
    /** [m], of the centre of mass */
    position: Pair;
    /** [rad], anticlockwise. Default: 0 */
    angle?: number;
    /** [m/s]. Default: [0, 0] */
    velocity?: Pair;
    /** [rad/s], anticlockwise. Default: 0 */
    spin?: number;
  };
}

/** How impacts on several cables are resolved. */
export type Law = "simultaneous" | "poisson" | "sequential" | "energetic";

/** How a case is solved. */
export interface Options {
  /** Default: "simultaneous", Moreau's form of Newton's law */
  law?: Law;
  /** The motion ends where nothing but one swing on taut cables can follow. */
  until_locked?: boolean;
  /** With `until_locked`: it ends at the lock already, if that is certain. */
  swing_ahead?: boolean;
  /** [-], > 0: error of the velocities by completing infinitely many bounces. Default: 1e-16 */
  completion_error?: number;
  /** [m/s], > 0: instead, bounces up to this speed are completed. */
  completion_speed?: number;
  /** [-], > 0: how far a derivative may grow while they last. Default: 20 */
  completion_margin?: number;
  /** > 0: the motion ends there. Default: 200000, about a second of work */
  max_events?: number;
  /** > 0: of taut motion; the motion ends there. Default: 200000, about a second of work */
  max_steps?: number;
}

/** What a number of a state is called, and its unit. */
export interface Coordinate {
  readonly name: string;
  readonly unit: string;
}

/** impact: a velocity jump. taut: cables at zero gap stay there. slack: the tension of a cable fell to zero. */
export type EventKind = "impact" | "taut" | "slack";

/** Why a motion ends. */
export type Ending =
  | "reached_duration"
  | "rest"
  | "unstable_rest"
  | "locked"
  | "angle_limit"
  | "ceiling"
  | "singular"
  | "event_limit"
  | "step_limit"
  | "no_progress"
  | "overflow";

export interface Event {
  /** [s] */
  readonly time: number;
  readonly kind: EventKind;
  /** The cables that take part, in rising order. */
  readonly cables: readonly number[];
  /** The state before the event. */
  readonly before: Float64Array;
  /** The state after it. */
  readonly after: Float64Array;
  /** [N s], one of each cable of the case; below 0 only at a completed accumulation: gravity does that part. */
  readonly impulses: Float64Array;
}

/** Bounds of the errors of an event; NaN where nothing is sure. */
export interface EventErrors {
  /** [s]; of a completed accumulation: of its limit */
  readonly time: number;
  /** [m/s], of the fastest closing rate */
  readonly rate: number;
  readonly before: Float64Array;
  readonly after: Float64Array;
  /** [N s], one of each cable of the case */
  readonly impulses: Float64Array;
  /** Cables among which the impulse can be split in several ways; the event has the split of smallest size. */
  readonly indeterminate: readonly number[];
}

/** A stretch without events. */
export interface Arc {
  /** [s] */
  readonly start: number;
  /** [s] */
  readonly end: number;
  /** The cables that are taut. */
  readonly taut: readonly number[];
}

/** Infinitely many impacts in a finite time. */
export interface Accumulation {
  /** [s], of the event that completes them */
  readonly start: number;
  /** [s], of the times of the impacts */
  readonly limit: number;
  /** [s]: by how much `limit` may be wrong */
  readonly uncertainty: number;
  /** The cables that are taut from then on. */
  readonly cables: readonly number[];
  /** [J], by the impacts after `start` */
  readonly energy_lost: number;
}

/** A stretch in which nothing is sure. */
export interface Unsure {
  /** [s] */
  readonly from: number;
  /** [s]; Infinity: to the end */
  readonly until: number;
  /** What rounding decides at `from`, if it decides between two motions there; null: errors have grown. */
  readonly tie: { readonly kind: EventKind; readonly cables: readonly number[] } | null;
}

/** A motion in short. */
export interface Summary {
  readonly ending: Ending;
  /** [s]: states are known from 0 to there */
  readonly end_time: number;
  /** The cables that are taut at the end. */
  readonly taut: readonly number[];
  /** How many there are of each. */
  readonly events: number;
  readonly impacts: number;
  readonly arcs: number;
  readonly accumulations: number;
  /** [J], kinetic and potential; zero potential at the origin of the world */
  readonly start_energy: number;
  /** [J] */
  readonly end_energy: number;
  /** From `start` [s] the motion repeats itself every `period` [s], turning by `turn` [rad]; null: it does not. */
  readonly repetition: { readonly start: number; readonly period: number; readonly turn: number } | null;
}

/** How a body swings on its final cables. */
export interface Swing {
  /** [J], above the equilibrium that it swings about */
  readonly energy: number;
  /** [s] */
  readonly period: number;
  /** It has no turning points; then the three angles are null. */
  readonly goes_round: boolean;
  /** The angles are those of the first cable that pulls, from gravity's direction, or those of the body. */
  readonly angle_of: "cable" | "body";
  /** [rad], the smaller of the angles at the turning points */
  readonly least: number | null;
  /** [rad], the larger one */
  readonly largest: number | null;
  /** [rad], half the difference */
  readonly amplitude: number | null;
  /** [N], the largest of one cable; null without `swing_ahead` */
  readonly tension: number | null;
}

/** How a motion settles. */
export interface Settling {
  /** [s], from which on `cables` are taut; null: the motion ends without a final set */
  readonly time: number | null;
  /** [s], of `time` */
  readonly uncertainty: number | null;
  /** The final set of taut cables. */
  readonly cables: readonly number[];
  /** No tension falls to zero ever after. False: not so, or not known */
  readonly permanent: boolean;
  /** Nothing is left to swing. */
  readonly rests: boolean;
  readonly swing: Swing | null;
  /** The time [s] of the last impact that is faster than `speed` [m/s]; null: there is none. */
  readonly last_impacts: readonly { readonly speed: number; readonly time: number | null }[];
}

/**
 * The exact motion of a case. Times [s] are in any order, all from 0 to `end_time`; others are a RangeError. At an event a
 * motion gives what is after it. Arrays have a row for each time, one after the other. A motion holds memory of the module
 * until `dispose` is called, or until it is collected as garbage.
 */
export interface Motion {
  readonly ending: Ending;
  /** [s]: states are known from 0 to there */
  readonly end_time: number;
  readonly summary: Summary;
  /** Looks past the end of the motion if its swing is not known by then. */
  readonly settling: Settling;
  /** In order of time. */
  readonly events: readonly Event[];
  readonly arcs: readonly Arc[];
  readonly accumulations: readonly Accumulation[];
  /** Rows of `coordinates`. */
  states(times: ArrayLike<number>): Float64Array;
  /** The set of taut cables at each time. */
  taut(times: ArrayLike<number>): Int32Array;
  /** [N], rows of one number for each cable, 0 of a slack one */
  tensions(times: ArrayLike<number>): Float64Array;
  /** [J]; zero potential at the origin of the world */
  energy(times: ArrayLike<number>): { kinetic: Float64Array; potential: Float64Array; total: Float64Array };

  // How far the numbers can be trusted. The first of these takes about as long as the solution.

  /** [s], the first instant at which nothing is sure any more; Infinity: there is none */
  readonly horizon: number;
  /** [s], a bound of the error of the last event, if cables stay taut from there on; null: not known */
  readonly lock_error: number | null;
  readonly unsure: readonly Unsure[];
  /** One for each event. */
  event_errors(): EventErrors[];
  /** Bounds of the errors of `states`, in the same rows; NaN where nothing is sure. */
  state_errors(times: ArrayLike<number>): Float64Array;
  /** [J]: bounds of the errors of the total energy; NaN where nothing is sure. */
  energy_errors(times: ArrayLike<number>): Float64Array;

  /** Gives back the memory of the motion. After that it answers nothing more. */
  dispose(): void;
  /** `using motion = tautline.solve(the_case)` calls it at the end of its block. */
  [Symbol.dispose](): void;
}

/** What is swept over. */
export interface SweepOptions extends Options {
  /** [s], >= 0: `states` has the states at them. */
  times?: ArrayLike<number>;
  /** Also says how each motion settles, which takes half as long again. */
  settling?: boolean;
}

/** Many motions in short, one entry of each array for each motion. Numbers that do not apply are NaN. */
export interface Sweep {
  /** How many motions. */
  readonly count: number;
  /** 1; 0 where the case has problems, such as a start beyond the end of a cable: all else is then NaN, 0 and "". */
  readonly solved: Uint8Array;
  readonly ending: (Ending | "")[];
  /** The set of cables that are taut at the end. */
  readonly taut: Int32Array;
  readonly events: Int32Array;
  readonly impacts: Int32Array;
  readonly arcs: Int32Array;
  readonly accumulations: Int32Array;
  /** [s] */
  readonly end_time: Float64Array;
  /** [J] */
  readonly start_energy: Float64Array;
  /** [J] */
  readonly end_energy: Float64Array;
  /** [s] */
  readonly repeat_start: Float64Array;
  /** [s] */
  readonly repeat_period: Float64Array;
  /** [rad] */
  readonly repeat_turn: Float64Array;
  /** With `times`: for each motion and time a row of `coordinates`; NaN after the end of the motion. */
  readonly states?: Float64Array;
  /** With `settling`: in the meaning and units of `Settling` and `Swing`. */
  readonly settlings?: SweptSettlings;
}

export interface SweptSettlings {
  /** Sets of cables. */
  readonly cables: Int32Array;
  readonly permanent: Int32Array;
  readonly rests: Int32Array;
  readonly swings: Int32Array;
  readonly goes_round: Int32Array;
  readonly angle_of_cable: Int32Array;
  readonly time: Float64Array;
  readonly uncertainty: Float64Array;
  /** Two for each motion: the last impact that is faster than 0.01 m/s, and 0.001 m/s */
  readonly last_impact_speed: Float64Array;
  readonly last_impact_time: Float64Array;
  readonly swing_energy: Float64Array;
  readonly swing_period: Float64Array;
  readonly swing_least: Float64Array;
  readonly swing_largest: Float64Array;
  readonly swing_amplitude: Float64Array;
  readonly swing_tension: Float64Array;
}

/**
 * The solver. A wrong case or option is a RangeError with all that is wrong, a sentence a line. What must be an array and is
 * none is a TypeError. An Error with a WebAssembly.RuntimeError as its `cause` is a mistake in tautline: other calls go on, and
 * motions stay as they are.
 */
export interface Tautline {
  readonly version: string;
  /** The columns of a state. */
  readonly coordinates: readonly Coordinate[];
  /** A case from the text of a case file, TOML or JSON. `name` names the text in sentences. */
  read(text: string, name?: string): Case;
  /** The text of a case file that reads back as the same case, bit for bit. A start on taut cables is written as moved. */
  write(the_case: Case, format?: "toml" | "json"): string;
  /** A sentence for each thing that is wrong with a case; empty: `solve` accepts it. */
  problems(the_case: Case): string[];
  /** How the start is changed for cables that start taut, in sentences; usually empty. */
  notes(the_case: Case): string[];
  /** The exact motion of a case. */
  solve(the_case: Case, options?: Options): Motion;
  /**
   * The exact motions of many variations of a case, with the bits that `solve` gives one by one. `values` has an array for
   * each quantity that varies, all of one length: a coordinate of the start ("x", "vx"), "mass", "inertia", "gravity_x",
   * "gravity_y", or "restitution", "length", "capture_speed" of all cables, or of one, as in "length_0".
   */
  sweep(the_case: Case, values: Readonly<Record<string, ArrayLike<number>>>, options?: SweepOptions): Sweep;
}

/** A compiled WebAssembly.Module, where the compiler knows one: TypeScript's library dom has it. */
export type CompiledModule = typeof globalThis extends { WebAssembly: { Module: new (bytes: never) => infer Module } } ? Module : never;

/**
 * Loads the module: tautline.wasm next to this file, unless `source` is its address, its bytes or the compiled module. In a
 * worker without a network, pass a WebAssembly.Module from the page by postMessage.
 */
export function load(source?: string | { readonly href: string } | ArrayBuffer | ArrayBufferView | CompiledModule): Promise<Tautline>;

/** The cables of a set, in rising order. */
export function cables_of(set: number): number[];
