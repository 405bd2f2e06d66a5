#pragma once

#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/base/strict_table.hpp"
#include "tautline/elasticity.hpp"

// How a file says that a cable is elastic.

namespace tautline::bench {

/// Reads what a cable loses in a contact.
inline void read_damping(StrictTable& table, Elasticity& law) {
  law.damping = table
                    .optional_number({"damping",
                                      "the force per speed at which the cable is stretched; "
                                      "default 0"},
                                     zero_or_above, "[N s/m]")
                    .value_or(0.0);
  law.damping_ratio =
      table
          .optional_number(
              {"damping_ratio", "instead of damping: the share of critical damping at each entry"},
              zero_or_above, "")
          .value_or(0.0);
}

/// Reads the force of its spring over the stretch, or over the strain.
inline void read_force(StrictTable& table, Elasticity& law) {
  const auto read = [&](const Key& key, std::string_view right, std::string_view unit) {
    table.with(key.name, [&] {
      const auto found = table.number_or_numbers(key, {right, 1.0, 0.0, {}, true}, unit);
      law.stiffness = law.stiffness.empty() ? found : law.stiffness;
    });
  };
  read({"stiffness",
        "makes the cable elastic: the force per stretch s, or k1, k2, ... for the force k1 s + k2 "
        "s^2 + ..."},
       "a finite number above 0, or an array of numbers k1, k2, ... for k1 s + k2 s^2 + ...",
       "[N/m, N/m^2, ...]");
  read({"EA",
        "instead of stiffness: the force per strain x, the stretch over the length of the time, or "
        "k1, k2, ... for the force k1 x + k2 x^2 + ..."},
       "a finite number above 0, or an array of numbers k1, k2, ... for k1 x + k2 x^2 + ... of the "
       "strain x",
       "[N]");
  table.refuse_beside("EA", {"stiffness"}, "must be one of the two");
  const Key corners = {"corners",
                       "where the slope of the force changes: pairs of a stretch and the stiffness "
                       "from there on, in rising stretch; with EA of a strain and the EA"};
  const std::string form = law.of_strain ? "[strain, EA]" : "[stretch, stiffness]";
  for (const Numbers<2>& corner :
       table.vectors<2>(corners, law.of_strain ? "[-, N]" : "[m, N/m]", false, form)) {
    law.corners.push_back({corner.x(), corner.y()});
  }
}

/// The words for where it ceases to pull, in the order of `ElasticCut`.
inline constexpr const char* cut_words[] = {"force", "stretch", "never"};

/// Reads where it ceases to pull.
inline void read_cut(StrictTable& table, Elasticity& law) {
  const std::vector<std::string> words(std::begin(cut_words), std::end(cut_words));
  const auto word = table.optional_one_of(
      {"cut",
       "where the cable ceases to pull: where its tension is 0, or where it is no longer "
       "stretched, "
       "which lets its damper push; or never, and its damper acts while it is slack, too; default "
       "force"},
      words);
  for (std::size_t i = 0; word && i < words.size(); ++i) {
    law.cut = words[i] == *word ? static_cast<ElasticCut>(i) : law.cut;
  }
}

/// Refuses what an elastic cable would say twice, and what it has not, once all keys are asked for.
inline void refuse_beside_elasticity(StrictTable& table) {
  const std::string one = "must be one of damping, damping_ratio and restitution";
  table.refuse_beside("damping_ratio", {"damping"}, one);
  table.refuse_beside("restitution", {"damping", "damping_ratio"}, one);
  for (const char* const key : {"capture_speed", "restitution_table"}) {
    table.refuse_beside(key, {"stiffness", "EA"},
                        "must be left out: an elastic cable has no impacts");
  }
}

/// Reads how a cable pulls where it is longer than its length; none if it has no stiffness. With a
/// stiffness, `restitution` is a third way to say the damping.
inline std::optional<Elasticity> read_elasticity(StrictTable& table) {
  const bool by_stretch = table.has("stiffness");
  const bool by_strain = table.has("EA");
  const bool is_elastic = by_stretch || by_strain;
  Elasticity law;
  law.of_strain = by_strain && !by_stretch;
  if (is_elastic || table.describes()) {
    read_force(table, law);
    read_damping(table, law);
    read_cut(table, law);
  }
  for (const char* const key : {"damping", "damping_ratio", "corners", "cut"}) {
    table.note_rule(key, &Form::needs, {"stiffness", "EA"});
    if (!is_elastic) {
      table.refuse_value(key, "is for an elastic cable, must be there with stiffness or EA");
    }
  }
  if (!is_elastic) {
    return std::nullopt;
  }
  const Range with_loss = {"in [1e-40, 1], for no damping takes all speed", 1e-40, 1e-40, 1.0};
  if (const auto share = table.optional_number({"restitution", ""}, with_loss, "")) {
    law.damping_ratio = damping_ratio_of(*share);
    if (law.cut != ElasticCut::force) {
      table.refuse_value("restitution",
                         "is of contacts that end where the tension is 0, must be left out with "
                         "this cut");
    }
  }
  return law;
}

}  // namespace tautline::bench
