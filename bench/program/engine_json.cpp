#include "bench/program/engine_json.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/base/text.hpp"
#include "bench/check/claims.hpp"
#include "bench/report/json/fields.hpp"
#include "bench/report/words.hpp"
#include "tautline/elasticity.hpp"

namespace tautline::bench {

/// Of a model, what a run may set.
struct Tuning {
  std::vector<Parameter> parameters;
  std::string code;
};
struct ListedModel {
  Model model;
  std::optional<Tuning> tuning;
};
struct ListedEngine {
  RegisteredEngine engine;
  std::optional<std::vector<ListedModel>> models;  // none: it has not answered
};
struct Engines {
  std::vector<ListedEngine> engines;
};

/// A claim that does not apply to a model.
struct NotApplying {
  std::string claim;
  std::string reason;
};
struct CheckedEngine {
  RegisteredEngine engine;
  std::vector<CheckedModel> models;
};
struct CalibratedEngine {
  RegisteredEngine engine;
  CalibrationRequest request;
  Calibration found;
};

template <class Visitor>
void fields(Visitor& visit, Parameter& one) {
  visit("name", one.name);
  visit("low", one.low);
  visit("high", one.high);
  visit("scale", std::string(one.logarithmic ? "log" : "linear"), one_of({"log", "linear"}));
  visit("step_power", one.step_power, "the bounds are these numbers times this power of the step");
}

template <class Visitor>
void fields(Visitor& visit, ListedModel& row) {
  fields(visit, row.model);
  visit.unless_missing("parameters", row.tuning, [](auto& inside, Tuning& tuning) {
    inside("parameters", tuning.parameters, "that a run may set");
    inside("code", tuning.code, "sets them in a user's program, {name} where a value stands");
  });
}

template <class Visitor>
void fields(Visitor& visit, ListedEngine& row) {
  RegisteredEngine& engine = row.engine;
  visit("name", engine.info ? engine.info->name : engine.name);
  visit.unless_missing("version", row.models, [&](auto& inside, auto& models) {
    const EngineInfo info = engine.info.value_or(EngineInfo{});
    inside("version", info.version);
    inside("precision", info.precision, one_of({"float64", "float32"}));
    inside("models", models);
  });
  visit("plugin", engine.plugin.string(), "its file; empty if there is none");
  visit("failure", printable(engine.failure), "why it does not answer, or empty");
  visit("missing", engine.missing, "what is missing, or empty");
  visit("package", engine.package, "what brings it, if known");
}

template <class Visitor>
void fields(Visitor& visit, Engines& row) {
  schema_field(visit, 1);
  visit("engines", row.engines);
}

template <class Visitor>
void fields(Visitor& visit, SettledClaim& settled) {
  const Claim* const claim = find_claim(settled.claim);
  visit("claim", settled.claim);
  visit("found", settled.found,
        or_null("what is compared with the limit; the smaller the better. null: not measured, or "
                "not finite"));
  visit("limit", settled.limit, or_null("null: not finite"));
  visit("holds", settled.holds);
  visit("sentence", printable(settled.sentence, longest_sentence),
        "what was found; where the claim does not hold, what seems to be wrong");
  visit("claimed", std::string(claim != nullptr ? claim->sentence : quiet_sentence),
        "what is claimed");
  visit("reason", std::string(claim != nullptr ? claim->reason : quiet_reason),
        "why the limit is what it is");
  std::optional<std::string> known;
  if (!settled.known.empty()) {
    known = printable(settled.known, longest_sentence);
  }
  visit.unless_missing("known", known, [](auto& inside, std::string& text) {
    inside("known", text, "why the claim does not hold, from the contract.toml of the engine");
  });
}

template <class Visitor>
void fields(Visitor& visit, NotApplying& one) {
  visit("claim", one.claim);
  visit("reason", printable(one.reason, longest_sentence), "what the model cannot run");
}

template <class Visitor>
void fields(Visitor& visit, CheckedModel& model) {
  std::vector<SettledClaim> found;
  std::vector<NotApplying> others;
  for (const SettledClaim& one : model.claims) {
    if (one.applies) {
      found.push_back(one);
    } else {
      others.push_back({one.claim, one.sentence});
    }
  }
  visit("model", model.name);
  visit("holds", broken_claims(model.claims).empty(),
        "every claim holds for it, except the listed violations; these do not");
  visit("findings", found,
        Says("in the order of measuring; after a crash or a time-out the rest is missing")
            .not_empty());
  visit("not_applying", others, "claims on systems in space that the model does not run");
}

template <class Visitor>
void fields(Visitor& visit, CheckedEngine& row) {
  const EngineInfo info = row.engine.info.value_or(EngineInfo{});
  schema_field(visit, 1);
  visit.group("engine", "", [&](auto& inside) {
    inside("name", info.name);
    inside("version", info.version);
    inside("precision", info.precision, one_of({"float64", "float32"}));
    inside("plugin", row.engine.plugin.string(), "the file that was loaded");
  });
  visit("holds",
        std::all_of(row.models.begin(), row.models.end(),
                    [](const CheckedModel& model) { return broken_claims(model.claims).empty(); }),
        "every claim holds for every model that was checked, except the listed violations");
  visit("models", row.models, Says().not_empty());
}

template <class Visitor>
void fields(Visitor& visit, HeldOut& one) {
  visit("speed", one.strike.speed, above(0, "with which the cable closes"));
  visit("arm", one.strike.arm,
        at_least(0, "from the centre of mass of 1 kg to the line of the cable"));
  visit("inertia", one.strike.inertia, above(0, "in kg m^2"));
  visit("spin_part", one.strike.spin_part,
        "the part of the speed that the body's spin brings, its centre the rest");
  visit("restitution", one.restitution, or_null("found"));
}

template <class Visitor>
void fields(Visitor& visit, SoftRow& law) {
  // the schema is described by a law without numbers
  const double ratio = law.stiffness > 0.0 ? damping_ratio_of(law) : 0.0;
  visit("stiffness", law.stiffness,
        above(0, "of the spring, over the mass that the cable feels [1/s^2]"));
  visit("damping", law.damping, at_least(0, "of the damper, over that mass [1/s]"));
  visit("load", law.load, in_range(0, 1, "the part of other forces that the cable takes over"));
  visit("damping_ratio", ratio, at_least(0, "damping / (2 sqrt(stiffness))"));
  visit("restitution", restitution_of(ratio),
        in_range(0, 1, "in short steps, where no other force pulls"));
}

template <class Visitor>
void fields(Visitor& visit, CalibratedEngine& row) {
  const EngineInfo info = row.engine.info.value_or(EngineInfo{});
  CalibrationRequest& request = row.request;
  Calibration& found = row.found;
  std::vector<std::string> fixed;
  for (const auto& [name, value] : request.fixed) {
    fixed.push_back(name);
  }
  schema_field(visit, 1);
  visit.group("engine", "", [&](auto& inside) {
    inside("name", info.name);
    inside("version", info.version);
    inside("plugin", row.engine.plugin.string(), "the file that was loaded");
  });
  visit("model", request.model.name);
  visit("restitution", request.restitution, in_range(0, 1, "wanted"));
  visit("speeds", std::vector<double>{request.slowest, request.fastest},
        above(0, "the slowest and the fastest closing speed").of(2));
  visit("step", request.step, above(0));
  visit("tolerance", request.tolerance, above(0, "of the restitution of every strike"));
  visit("reached", found.reached(request.tolerance), "`worst` is within the tolerance");
  visit("parameters", ByName<double>{{found.parameters.begin(), found.parameters.end()}},
        "the best that was found, by name; those that are fixed too");
  visit("fixed", fixed, "names of the parameters that were not searched");
  visit("code", printable(found.code, longest_sentence), "sets the parameters in a user's program");
  visit.unless_missing("law", found.law, [](auto& inside, SoftRow& law) {
    inside("law", law, "of the cable, where the engine says that it is a spring and a damper");
  });
  visit("worst", found.worst, or_null(at_least(0, "the largest error of the strikes below")));
  visit("mean", found.mean, or_null(at_least(0, "their mean")));
  visit("held_out", found.held_out, Says("strikes that the search did not see").not_empty());
  visit("not_reached", found.why,
        "sentences: where the restitution cannot be had; none if it is reached or the search was "
        "interrupted");
  visit("evaluations", found.evaluations, at_least(1, "settings that were tried"));
  visit("interrupted", found.interrupted,
        "the search did not end by itself, and this is the best so far");
}

std::string engines_json(const std::vector<RegisteredEngine>& engines) {
  Engines row;
  for (const RegisteredEngine& engine : engines) {
    ListedEngine listed{engine, std::nullopt};
    if (engine.info) {
      listed.models.emplace();
      for (const Model& model : engine.info->models) {
        listed.models->push_back(
            {model, model.parameters.empty()
                        ? std::nullopt
                        : std::optional(Tuning{model.parameters, model.code})});
      }
    }
    row.engines.push_back(std::move(listed));
  }
  return text_of(json_of(row));
}

std::string engines_schema_json() {
  return text_of(headed("What `tautline engines --json` writes",
                        "The engines that are known: those that are here with their models.",
                        schema_of(Engines())));
}

std::string check_json(const RegisteredEngine& engine, const std::vector<CheckedModel>& models) {
  return text_of(json_of(CheckedEngine{engine, models}));
}

std::string check_schema_json() {
  return text_of(headed("The verdicts of `tautline check --json`",
                        "Whether each model of one engine keeps what every sound engine keeps. "
                        "Lengths in m, times in s.",
                        schema_of(CheckedEngine())));
}

std::string calibration_json(const RegisteredEngine& engine, const CalibrationRequest& request,
                             const Calibration& found) {
  return text_of(json_of(CalibratedEngine{engine, request, found}));
}

std::string calibration_schema_json() {
  return text_of(headed("What `tautline calibrate --json` found",
                        "The parameters of a model of an engine that give a cable the restitution "
                        "wanted, and what they give on strikes that the search did not see. "
                        "Lengths in m, speeds in m/s, times in s. A number that is null could not "
                        "be measured.",
                        schema_of(CalibratedEngine())));
}

}  // namespace tautline::bench
