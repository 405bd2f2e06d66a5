// What the motion does, in sentences: for the head of the page, and for who hears it.

import { inUnits } from "./case.mjs";

/// A number to `digits` digits, without zeros at its end.
export const short = (value, digits = 4) => String(+Number(value).toPrecision(digits));

const and = (words) => (words.length < 2 ? words.join("") : `${words.slice(0, -1).join(", ")} and ${words.at(-1)}`);
export const cablesIn = (cables, all) => (all > 1 && cables.length === all ? (all === 2 ? "both cables" : `all ${all} cables`)
  : `cable${cables.length > 1 ? "s" : ""} ${and(cables.map(String))}`);
const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);

/// How a motion ends, if that is not with its duration.
const ENDINGS = {
  rest: (t) => `The body comes to rest at t = ${t}.`,
  unstable_rest: (t) => `The body comes to rest at t = ${t} on a balance that any push would end.`,
  angle_limit: (t) => `The motion ends at t = ${t}: the body has turned to the limit of the case.`,
  ceiling: (t) => `The motion ends at t = ${t}: an attachment has risen to the ceiling.`,
  singular: (t) => `The motion ends at t = ${t}: touching cables have come into one line, where no tension is known.`,
  event_limit: (t) => `The page stops at t = ${t}, after 20,000 events; the program goes on.`,
  step_limit: (t) => `The page stops at t = ${t}, after 20,000 steps on taut cables; the program goes on.`,
  no_progress: (t) => `The motion stops at t = ${t}: one event follows another there, and time does not advance.`,
  overflow: (t) => `The motion ends at t = ${t}: its numbers are too large for doubles.`,
};

/// How the cables end, where the worker was asked.
function settles({ settling, ending, isSure: sure }, the_case, t) {
  if (!settling || settling.time === null || ending === "rest" || ending === "unstable_rest") return "";
  const { cables, time, swing, permanent } = settling, who = cablesIn(cables, the_case.cables.length);
  const are = permanent ? (cables.length > 1 ? "stay" : "stays") : (cables.length > 1 ? "are" : "is");
  const taut = `${!sure(time) ? `In this one ${who}` : capital(who)} ${are} taut from t = ${t(time)}${permanent ? " on" : " to the end"}`;
  if (!swing) return `${taut}.`;
  return swing.goes_round ? `${taut}, and the body goes round every ${t(swing.period)}.` : `${taut}, and the body swings with a period of ${t(swing.period)}.`;
}

/// How far the motion can be known.
function isSure({ horizon, unsure, end, settling }, t) {
  if (!settling) return ""; // the worker was not asked
  if (horizon === Infinity) return "Every digit drawn is sure.";
  const last = unsure.at(-1).until, more = unsure.length > 1 ? ", with pauses," : "";
  return last < end ? `From t = ${t(horizon)} to ${t(last)}${more} this is one of many motions that begin alike.`
    : `Up to t = ${t(horizon)} every digit drawn is sure; from there on${more} this is one of many motions that begin alike.`;
}

/// Sentences on a motion.
export function sentences(motion) {
  const { the_case, impacts, events, ending, end_time, end } = motion, t = (value) => `${short(value)}${inUnits(the_case, "s")}`;
  const count = impacts.length === 0 ? "No cable is hit" : `${impacts.length.toLocaleString("en")} impact${impacts.length > 1 ? "s" : ""}`;
  return [`${count} in ${t(end)}.`, isSure(motion, t), settles(motion, the_case, t), ENDINGS[ending]?.(t(/rest/.test(ending) && events.count > 0 ? events.time[events.count - 1] : end_time))].filter(Boolean);
}

/// What happens at an instant, for who steps from event to event.
export function atInstant(motion, time) {
  const { the_case, events } = motion, t = `t = ${short(time, 5)}${inUnits(the_case, "s")}`;
  const names = { impact: "impact on", taut: "now taut:", slack: "now slack:" };
  const here = [];
  for (let i = 0; i < events.count && here.length < 3; ++i) {
    if (Math.abs(events.time[i] - time) > 1e-9 * Math.max(1, time)) continue;
    const cables = [...Array(8).keys()].filter((one) => (events.cables[i] >> one) & 1);
    here.push(`${names[events.kind[i]]} ${cablesIn(cables, the_case.cables.length)}`);
  }
  return `${t}${here.length > 0 ? `: ${here.join("; ")}` : ""}`;
}
