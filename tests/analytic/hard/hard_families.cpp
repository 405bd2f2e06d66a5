#include "hard/hard_families.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "tautline/geometry.hpp"

namespace tautline::test {
namespace {

/// The case with every length multiplied by `factor`.
Case scaled(Case the_case, double factor) {
  for (Cable& cable : the_case.cables) {
    cable.anchor *= factor;
    cable.attachment *= factor;
    cable.length *= factor;
  }
  the_case.initial.position *= factor;
  the_case.initial.velocity *= std::sqrt(factor);
  the_case.initial.spin /= std::sqrt(factor);
  the_case.duration *= std::sqrt(factor);
  the_case.body.inertia *= factor * factor;
  return the_case;
}

/// Makes cable `index` start taut along `direction` [rad], whatever it was.
void pull_along(Case& the_case, std::size_t index, double direction) {
  Cable& cable = the_case.cables[index];
  const Vec2 point = attachment_point(the_case.initial, cable);
  cable.anchor = point + cable.length * Vec2(std::cos(direction), std::sin(direction));
  cable.length = (point - cable.anchor).norm();
}

Case light_or_heavy(Random& random, Case the_case) {
  const double arm = attachment_radius(the_case);
  the_case.body.inertia = the_case.body.mass * arm * arm * random.log_uniform(1e-9, 1e9);
  return the_case;
}

Case fast(Random& random, Case the_case) {
  the_case.initial.spin = random.log_uniform(10.0, 1e7);
  return the_case;
}

Case doubled(Random&, Case the_case) {
  const std::size_t count = std::min(the_case.cables.size(), max_cables / 2);
  the_case.cables.resize(count);
  for (std::size_t index = 0; index < count; ++index) {
    the_case.cables.push_back(the_case.cables[index]);
    the_case.cables.back().restitution *= 0.5;
  }
  return the_case;
}

Case wedged(Random& random, Case the_case) {
  double direction = random.uniform(0.0, 6.0);
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    pull_along(the_case, index, direction);
    direction += 2.0 * std::numbers::pi / 3.0 + random.uniform(-0.3, 0.3);
  }
  return the_case;
}

Case near_one_line(Random& random, Case the_case) {
  const double direction = random.uniform(0.0, 6.0);
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    the_case.cables[index].attachment *= random.log_uniform(1e-6, 1.0);
    const double side = random.chance(0.5) ? std::numbers::pi : 0.0;
    pull_along(the_case, index, direction + side + random.log_uniform(1e-9, 1e-2));
  }
  return the_case;
}

Case tiny_or_huge(Random& random, Case the_case) {
  return scaled(std::move(the_case), random.log_uniform(1e-6, 1e6));
}

Case far_away(Random& random, Case the_case) {
  const Vec2 away = random.in_square(1e6);
  for (Cable& cable : the_case.cables) {
    cable.anchor += away;
    const Vec2 point = attachment_point(the_case.initial, cable) + away;
    cable.length = std::max(cable.length, (point - cable.anchor).norm());
  }
  the_case.initial.position += away;
  return the_case;
}

Case elastic_and_plastic(Random& random, Case the_case) {
  for (Cable& cable : the_case.cables) {
    cable.restitution = random.chance(0.5) ? 1.0 : 0.0;
  }
  return the_case;
}

}  // namespace

const std::array<HardFamily, 8>& hard_families() {
  static constexpr std::array families = {HardFamily{"LightOrHeavy", light_or_heavy},
                                          HardFamily{"Fast", fast},
                                          HardFamily{"Doubled", doubled},
                                          HardFamily{"Wedged", wedged},
                                          HardFamily{"NearOneLine", near_one_line},
                                          HardFamily{"TinyOrHuge", tiny_or_huge},
                                          HardFamily{"FarAway", far_away},
                                          HardFamily{"ElasticAndPlastic", elastic_and_plastic}};
  return families;
}

std::optional<HardSystem> hard_system(Random& random, const HardFamily& family, int sample) {
  const auto cables = static_cast<std::size_t>(1 + sample % 8);
  Case the_case = random_case(random, {cables, 0.0, 0.3});
  the_case.duration = 10.0;
  the_case = family.make(random, std::move(the_case));
  if (sample % 3 == 2) {  // two difficulties at once
    const auto& families = hard_families();
    const auto other =
        static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(families.size())));
    the_case = families[other].make(random, std::move(the_case));
  }
  if (!problems(the_case).empty()) {
    return std::nullopt;
  }
  return HardSystem{std::move(the_case),
                    impact_laws[static_cast<std::size_t>(sample) % impact_laws.size()]};
}

}  // namespace tautline::test
