#pragma once

#include "bench/report/json/values.hpp"
#include "bench/report/record.hpp"
#include "bench/report/report.hpp"

// The members of all that a run leaves, as fields.hpp has those of a report.

namespace tautline::bench {

template <class Visitor>
void fields(Visitor& visit, RunKey& key) {
  visit("case", key.the_case);
  visit("engine", key.engine);
  visit("model", key.model);
  visit("step", key.step);
}

template <class Visitor>
void fields(Visitor& visit, SetupKey& key) {
  visit("engine", key.engine);
  visit("model", key.model);
  visit("step", key.step);
}

template <class Visitor>
void fields(Visitor& visit, GridColumn& column) {
  visit.means("numbers on a grid: the n-th is start + scale * (the sum of the first n of steps)");
  visit("start", column.start, "the first number");
  visit("scale", column.scale, above(0));
  visit("steps", column.steps, "one for each number; the first is 0");
}

template <class Visitor>
void fields(Visitor& visit, TautColumns& cable) {
  visit.means(
      "when the cable is taut: of the exact motion from its events, of a run where the recorded "
      "gap stays below 1e-4 of its length for a sixtieth of a second");
  visit("times", cable.times, "from, until, from, until, ...: taut in between, else slack [s]");
  visit("gap_times", cable.gap_times, "inside the long ones of these stretches [s]");
  visit("gap", cable.gap,
        "as it was recorded then: the least and the largest of a part of the stretch [m]");
  visit.unless_missing("tension", cable.tension, [](auto& inside, Line& tension) {
    inside(
        "tension", tension,
        "in space, where the exact motion has a taut cable: of a run its mean over a step, where "
        "the engine tells it [N]");
  });
}

template <class Visitor>
void fields(Visitor& visit, BodyPath& path) {
  constexpr std::array names = {"x", "y", "z", "qw", "qx", "qy", "qz"};
  visit.means(
      "of a body in space: x, y, z of its centre of mass [m], and its orientation, the quaternion "
      "qw + qx i + qy j + qz k, to be normalised; pieces as those of the plane");
  visit("error", path.error,
        at_least(0, "by which the centre and what is drawn of the body are off, at most [m]"));
  visit("time", path.time, "of the knots, rising [s]");
  for (std::size_t k = 0; k < names.size(); ++k) {
    visit(names[k], path.places[k]);
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    visit(std::string(names[k]) + "_bends", path.bends[k], "two for each piece");
  }
}

template <class Visitor>
void fields(Visitor& visit, Line& line) {
  visit.means("a number over time: straight between two knots; a jump is two knots at one time");
  visit("time", line.time, "[s]");
  visit("value", line.value);
}

template <class Visitor>
void fields(Visitor& visit, Path& path) {
  visit.means(
      "a motion as it is drawn: pieces between knots, each a cubic. At the part s of its way from "
      "a knot a to the next b a coordinate is a + s (b - a) + 3 s (1 - s) ((1 - s) p + s q), where "
      "p and q are its two bends; its velocity is (b - a + 3 p) / T at the start and (b - a - 3 q) "
      "/ T at the end of the piece, which lasts T");
  visit("error", path.error,
        at_least(
            0, "by which the centre and every attachment are off what was recorded, at most [m]"));
  visit(
      "spacing", path.spacing,
      at_least(
          0,
          "between two recorded samples, between which nothing is known; 0: the exact motion [s]"));
  visit("time", path.time, "of the knots, rising [s]");
  visit("x", path.x, "of the centre of mass [m]");
  visit("y", path.y, "[m]");
  visit("angle", path.angle, "[rad]");
  visit("x_bends", path.x_bends, "two for each piece [m]");
  visit("y_bends", path.y_bends, "[m]");
  visit("angle_bends", path.angle_bends, "[rad]");
  visit("energy_error", path.energy_error,
        at_least(0, "by which the energy is off what was recorded, at most [J]"));
  visit("energy_time", path.energy_time, "a jump is two knots at one time [s]");
  visit("energy", path.energy, "kinetic and potential; straight between two knots [J]");
  visit("cables", path.cables);
  visit.unless_missing("bodies", path.bodies, [](auto& inside, std::vector<BodyPath>& bodies) {
    inside("bodies", bodies, "of a system in space, whose columns of the plane are empty");
  });
}

template <class Visitor>
void fields(Visitor& visit, ImpactColumns& impacts) {
  static_assert(most_impacts == 5000, "the description says so");
  visit.means(
      "the counted impacts of a run in rising time, a column each; of more than 5000 the fastest");
  visit("time", impacts.time, or_null("[s]"));
  visit("cable", impacts.cable);
  visit("requested", impacts.requested, or_null("the cable's restitution at that speed"));
  visit("rate_before", impacts.rate_before, or_null("gap rate, negative when closing [m/s]"));
  visit("rate_after", impacts.rate_after,
        or_null("effective restitution: -rate_after / rate_before [m/s]"));
  visit("arm", impacts.arm,
        or_null("lever arm of the cable's pull about the centre of mass, > 0 where it turns the "
                "body anticlockwise [m]"));
  visit("tangential_error", impacts.tangential_error,
        or_null("change of momentum across the cable that no cable's impulse and no gravity "
                "explains [N s]"));
  visit("angular_error", impacts.angular_error,
        or_null("change of angular momentum about the centre of mass less arm times impulse of "
                "every cable [N m s]"));
  visit("steps", impacts.steps,
        "consecutive steps with an impulse; 0 if the engine located the impact");
  visit("left_out", impacts.left_out,
        "counted impacts that are not here, all slower than those that are");
}

template <class Visitor>
void fields(Visitor& visit, RunDetails::OfWindow& window) {
  visit("until", window.until, "end of the window [s]");
  visit("covered", window.covered, "the run's last sample in the window [s]; 0 without one");
  visit("exact", window.exact, "counted impacts of the exact motion");
  visit("found", window.found, "counted impacts of the run");
  visit("matched", window.matched, "pairs, one to one");
}

template <class Visitor>
void fields(Visitor& visit, LastImpactMatch& last) {
  visit("speed", last.speed, "impacts that close faster than this [m/s]");
  visit("exact", last.exact, "time of the exact motion's last [s]; null if that does not lock");
  visit("found", last.found,
        "time of the run's last [s]; null too if the run stopped before the exact one");
}

template <class Visitor>
void fields(Visitor& visit, ExactAndFound& both) {
  visit("exact", both.exact);
  visit("found", both.found);
}

template <class Visitor>
void fields(Visitor& visit, ContactMatch& contacts) {
  visit.means(
      "contacts of elastic cables up to the horizon, counted if they begin faster than 0.01 m/s or "
      "with the motion; the errors are the worst of the pairs, null without a pair to compare");
  visit("exact", contacts.exact, "counted contacts of the exact motion");
  visit("found", contacts.found, "counted contacts of the run");
  visit("matched", contacts.matched, "pairs, one to one");
  visit("peak", contacts.peak,
        "the largest tension [N], the run's a mean over a step; null without a pair to compare");
  visit("peak_error", contacts.peak_error,
        "of a contact's largest tension [%], ended or not, if the exact peak is by the horizon");
  visit("impulse_error", contacts.impulse_error,
        "of a contact's impulse [%], of pairs that have ended on both sides, the exact contact by "
        "the horizon");
  visit("time_error", contacts.time_error, "of the time that a contact lasts [%], of these pairs");
  visit("restitution_error", contacts.restitution_error,
        "of a contact's exit speed over its entry speed [-], of these pairs; not of one that a cut "
        "ends, or that begins no faster than 0.01 m/s");
}

template <class Visitor>
void fields(Visitor& visit, SwingMatch& swing) {
  visit("from", swing.from, "[s]");
  visit("until", swing.until, "one period of the exact swing later [s]");
  visit("energy", swing.energy, "above the exact equilibrium, mean over the run's samples [J]");
  visit("amplitude", swing.amplitude, "half the range of the angle over the run's samples [rad]");
}

/// Its worst error is a metric of the list.
template <class Visitor>
void fields(Visitor& visit, MeasuredRestitution& measured) {
  visit("count", measured.count);
  visit("smallest", measured.smallest, or_null());
  visit("mean", measured.mean, or_null());
  visit("largest", measured.largest, or_null());
}

template <class Visitor>
void fields(Visitor& visit, RunDetails& details) {
  visit.means(
      "what the comparison with the exact motion says besides the metrics; null exactly where "
      "these are");
  visit("early", details.of_windows[0]);
  visit("horizon", details.of_windows[1]);
  visit("whole", details.of_windows[2]);
  visit("last_impacts", details.last_impacts);
  visit("swing", details.swing,
        "over the last period of the run; null if the exact motion has no lasting swing or the run "
        "not a period of it");
  visit("restitution", details.restitution,
        "measured at each counted impact of a single step, up to the exact lock; null without one");
  visit("rest_tension", details.rest_tension,
        "of the cable that is off most [N]; null if the exact motion does not end at rest, statics "
        "do not determine it, or the engine does not tell its tensions");
  visit("largest_tension", details.largest_tension,
        "the largest mean over a step of a taut phase, up to the horizon [N]; null if there is "
        "none, or the engine does not tell its tensions");
  visit("first_impulse", details.first_impulse,
        "of the first counted impact [N s]; null without one, or if several cables share it");
  visit.unless_missing("contacts", details.contacts, [](auto& inside, ContactMatch& contacts) {
    inside("contacts", contacts, "of elastic cables, where a case has one");
  });
  visit("stride", details.stride, at_least(1, "every stride-th step was compared"));
  visit("recorded_impacts", details.recorded_impacts);
  visit("slow_impacts", details.slow_impacts, "slower than 1e-3, only counted: chatter");
}

template <class Visitor>
void fields(Visitor& visit, Ladder& ladder) {
  visit("cable", ladder.cable);
  visit("exact_ratio", ladder.exact_ratio, "of one height to the next: e^2");
  visit("heights", ladder.heights, "h_n / h_0, n = 1, 2, ...");
  visit("exact", ladder.exact, "e^(2n)");
}

template <class Visitor>
void fields(Visitor& visit, Rebounds& rebounds) {
  visit("word", rebounds.word);
  visit("readable", rebounds.readable, "impacts whose restitution the steps leave to be read");
  visit("off", rebounds.off, "of them, by more than their steps explain");
  visit("asked", rebounds.asked, "the restitution; null where it is not the same for all");
  visit("slowest", rebounds.slowest, "of the readable ones [m/s]");
  visit("deviation", rebounds.deviation, "median of the restitution got less that asked for [-]");
  visit("speed", rebounds.speed,
        "up to it rebounds are lost; or of the impact after which a cable stays taut [m/s]");
  visit("stays_taut", rebounds.stays_taut);
  visit("steps", rebounds.steps, "that an impact takes, median");
}

template <class Visitor>
void fields(Visitor& visit, Following& following) {
  visit("ratio", following.ratio,
        "largest error of the position over what a scheme of this step may be off by; null where "
        "nothing can be told");
  visit("time", following.time, "of that [s]");
  visit("error", following.error, "the error then [m]");
  visit("until", following.until, "of what is judged [s]");
  visit("located", following.located, "the run names the instants of all of its impacts itself");
  visit("rounding", following.rounding,
        "error over what rounding explains up to the first taut cable, of a run that locates its "
        "impacts; null of others");
}

template <class Visitor>
void fields(Visitor& visit, Expected& impacts) {
  visit("due", impacts.due, "impacts of the exact motion that a run of this step cannot miss");
  visit("missed", impacts.missed, "of them");
}

template <class Visitor>
void fields(Visitor& visit, Judgement& judgement) {
  visit.means("what is said of the run from the exact motion of its case alone");
  visit("restitution", judgement.rebounds);
  visit("position", judgement.following);
  visit("impacts", judgement.impacts);
  visit("overstretch", judgement.overstretch, "the largest, in units of what a step explains");
  visit("energy", judgement.energy,
        "the largest rise outside contacts, in units of mass acceleration speed step");
  visit(
      "flight", judgement.flight,
      "how far the acceleration in flight is off, as a part of gravity, or without gravity of the "
      "largest acceleration");
  visit.unless_missing("rotation", judgement.rotation, [](auto& inside, double& rotation) {
    inside("rotation", rotation,
           "what a flight changes of an angular momentum that nothing changes, in units of what a "
           "scheme of first order explains: of systems");
  });
}

template <class Visitor>
void fields(Visitor& visit, SoftParts& soft) {
  visit("model", soft.model, "what springs and dampers do in place of the cables of the case");
  visit("step", soft.step, "what else the engine does: its steps, and what it does not tell");
}

template <class Visitor>
void fields(Visitor& visit, Attribution& attribution) {
  visit.means("where the deviation comes from; null if nothing was recorded");
  visit("until", attribution.until, "the instant of the deviation [s]");
  visit(
      "covered", attribution.covered,
      in_range(0, 1,
               "that instant as a part of the horizon, or of an exact motion that ends before it"));
  visit("deviation", attribution.deviation, "distance from the exact position then [m]");
  visit("parts", attribution.parts,
        "signed, along the deviation [m]; null where `reason` says why");
  visit("remainder", attribution.remainder, "the deviation minus its parts [m]");
  visit("arcs", attribution.arcs, "flights and taut stretches up to then");
  visit("impacts", attribution.impacts, "impact segments up to then");
  visit.unless_missing("soft", attribution.soft, [](auto& inside, SoftParts& soft) {
    inside(
        "soft", soft,
        "of an engine that tells the springs and dampers that its cables are: the deviation once "
        "more, in two parts, signed, along it [m]; left out where `reason` says why");
  });
  visit("reason", attribution.reason,
        "why there are no parts, why the instant is before the horizon, or why `soft` is left out");
}

template <class Visitor>
void fields(Visitor& visit, Problem& problem) {
  visit("kind", problem.kind,
        "restitution, position, events, missed-impacts, overstretch, energy, flight, rotation, "
        "failure, "
        "or the kind of a finding of the audit");
  visit("sentence", problem.sentence);
  visit("value", problem.value, "of the kind: a ratio, a deviation or a count");
  visit("listed", problem.listed, "among those that a person has listed");
  visit("reason", problem.reason, "why it is there; \"\" where it is not");
}

template <class Visitor>
void fields(Visitor& visit, Verdict& verdict) {
  visit.means("what is wrong with the run; null without verdicts");
  visit("word", verdict.word);
  visit("problems", verdict.problems);
}

template <class Visitor>
void fields(Visitor& visit, RunRow& row, RunReplay& replay) {
  fields(visit, row.key);
  visit("status", row.status);
  visit("reason", row.reason, "of any status but finished");
  visit("output_tail", row.output_tail, "the last a failed engine printed");
  ByMetric<decltype(row.metrics)> metrics{row.metrics};
  visit("metrics", metrics,
        "of every metric its value, or null where it could not be measured; null where "
        "there is nothing to compare");
  visit("details", row.details);
  visit("path", replay.path, "null in a report: it is in the case's `motions`");
  visit("impacts", replay.impacts);
  visit.group("audit", "", [&](auto& inside) {
    inside("ladder", row.ladder,
           "heights of consecutive bounces on one cable through the centre of mass, as parts of "
           "the first fall; null where the run has none");
  });
  visit("judgement", row.judgement);
  visit("attribution", row.attribution);
  visit("verdict", row.verdict);
}

template <class Visitor>
void fields(Visitor& visit, Spread& spread) {
  visit.means("how far numbers lie about their median: the smallest and the quartiles");
  visit("smallest", spread.smallest);
  visit("lower", spread.lower);
  visit("upper", spread.upper);
}

template <class Visitor>
void fields(Visitor& visit, TimingRow& row) {
  fields(visit, row.key);
  visit("memory", row.memory, "the most the worker held at once [bytes]");
  visit("step_cost", row.step_cost, "processor time of one step [s]");
  visit("reference_cost", row.reference_cost, "of one closed-form flight and its gaps [s]");
  visit("cost_ratio", row.cost_ratio);
  visit("second_cost", row.second_cost,
        "processor time of one simulated second, median over repetitions of the first second of "
        "the motion [s]");
  visit("second_spread", row.second_spread, "of that over the repetitions [s]");
  visit("repetitions", row.repetitions, at_least(1));
}

template <class Visitor>
void fields(Visitor& visit, AuditedImpact& impact) {
  visit("speed", impact.speed);
  visit("requested", impact.requested);
  visit("effective", impact.effective);
  visit("arm", impact.arm);
  visit("across", impact.across);
  visit("turning", impact.turning);
  visit("rate_floor", impact.rate_floor);
  visit("steps", impact.steps);
}

template <class Visitor>
void fields(Visitor& visit, Freeze& freeze) {
  visit("moving", freeze.moving);
  visit("time", freeze.time);
  visit("lost", freeze.lost);
}

template <class Visitor>
void fields(Visitor& visit, RunAudit& audit) {
  visit("ladder", audit.ladder);
  visit("impacts", audit.impacts);
  visit("freeze", audit.freeze);
}

template <class Visitor>
void fields(Visitor& visit, RunRecord& record) {
  visit.group("row", "", [&](auto& inside) { fields(inside, record.row, record.replay); });
  visit("timing", record.timing);
  visit("audit", record.audit);
}

}  // namespace tautline::bench
