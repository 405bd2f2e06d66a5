// A cable is a contact joint without friction (ODE manual, "Contact"), made while the cable is
// overstretched when a step starts (`row`, `contact`), or already when the step would overstretch
// it (`early`). ODE takes the larger of the bounce and the push out of the overstretch, and the
// bounce from the velocity before gravity's part of the step. `spring` pulls elastic cables by
// forces, and leaves the others to the contacts of `row`.

#include <type_traits>
#include <utility>

#include "adapter/spring_model.hpp"
#include "models.hpp"
#include "tautline/clock.hpp"
#include "world.hpp"

namespace tautline::ode {
namespace {

/// Who takes out the overstretch.
enum class Push {
  by_ode,         // ODE, 0.2 of it per step
  by_ode_slowly,  // the same, at most as fast as `most_correction`
  by_rule,        // the rule of the rows of other engines
};

/// The most that ODE may correct with in a step, of what gravity gives in it [-]: a load that goes
/// round a full circle hangs with six times its weight at the lowest point. A slower correction
/// brakes such a swing, a faster one throws back what should not rebound.
constexpr double most_correction = 6.0;

/// What the models set otherwise.
struct Choice {
  Activation activation;
  Rotation rotation;
  double bounce_vel;          // [m/s], a slower contact does not bounce
  std::optional<double> cfm;  // none: ODE's own, and so in all systems
  Push push;
};

constexpr Choice row{Activation::overstretched, Rotation::finite, 0.0, 0.0, Push::by_rule};
constexpr Choice early{Activation::crossing, Rotation::finite, 0.0, 0.0, Push::by_rule};
/// ODE ships no bounce_vel; its demos (demo_boxstack) have 0.1.
constexpr Choice contact{Activation::overstretched, Rotation::infinitesimal, 0.1, {}, Push::by_ode};
constexpr Choice tuned{Activation::overstretched, Rotation::finite, 0.0, 0.0, Push::by_ode_slowly};

/// TheCase is Case or SpatialSystem.
template <class TheCase, class TheWorld>
class FixedStepSimulation final : public BasicSteppedSimulation<TheCase> {
 public:
  FixedStepSimulation(const TheCase& the_case, const RunSettings& run, const Choice& choice)
      : case_(the_case), choice_(choice), run_(run), world_(the_case, choice.rotation) {
    check_contacts(the_case);
    if (choice.cfm && std::is_same_v<TheCase, Case>) {
      dWorldSetCFM(world_.id(), *choice.cfm);
    }
    const double gravity = weight(the_case);
    if (choice.push == Push::by_ode_slowly && gravity > 0.0) {
      dWorldSetContactMaxCorrectingVel(world_.id(), most_correction * gravity * run.step);
    }
  }

  [[nodiscard]] StateOf<TheCase> state() const override { return world_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return world_.impulses(); }

  /// Adds these to the loads of the next step.
  void pull(const std::vector<BodyLoad>& loads) {
    pulls_ = loads;
    world_.add(loads);
  }

  void step(double dt) override {
    const StateOf<TheCase> start = at_time_of_step(world_.state(), clock_);
    for (std::size_t index = 0; index < case_.cables.size(); ++index) {
      const auto& cable = case_.cables[index];
      const auto row_now = row_in_step(cable, start, dt);
      if (acts(row_now, choice_.activation, dt)) {
        dSurfaceParameters made =
            surface(parameter_of(run_, "bounce", restitution(cable, row_now.rate)),
                    erp(row_now, change_in_step(case_, index, start, dt, pulls_), dt));
        if (const double moving = rate_of_bodies(row_now, 0.0); moving != 0.0) {
          made.mode |= dContactMotionN;
          made.motionN = moving;
        }
        world_.pull(index, row_now, made);
      }
    }
    world_.advance(dt);
    clock_.advance(dt);
    if (choice_.push != Push::by_rule) {
      return;
    }
    if (const auto moved = out_of_overstretch(case_, world_.state(), correction(), dt, pulls_)) {
      world_.place(*moved);
    }
  }

 private:
  [[nodiscard]] static double weight(const Case& the_case) { return the_case.gravity.norm(); }
  [[nodiscard]] static double weight(const SpatialSystem& system) {
    return system.gravity.at(0.0).norm();
  }

  [[nodiscard]] double correction() const { return usual_correction / run_.step; }  // [1/s]

  /// The part of the overstretch of `row_now` that ODE takes out in a step of `dt` [s] [-]; by the
  /// rule at the rate `most` [m/s] at most.
  template <class Row>
  [[nodiscard]] double erp(const Row& row_now, double most, double dt) const {
    if (choice_.push != Push::by_rule || row_now.gap >= 0.0) {
      return correction_in_step(dt, run_.step);
    }
    return push_rate(row_now, correction(), most) * dt / -row_now.gap;
  }

  [[nodiscard]] dSurfaceParameters surface(double bounce, double soft_erp) const {
    dSurfaceParameters result{};
    result.mode = dContactBounce | dContactSoftERP;
    result.bounce = bounce;
    result.bounce_vel = parameter_of(run_, "bounce-vel", choice_.bounce_vel);
    result.soft_erp = soft_erp;
    return result;
  }

  const TheCase case_;
  Choice choice_;
  RunSettings run_;
  TheWorld world_;
  Clock clock_;
  std::vector<BodyLoad> pulls_;  // of the step; empty: none
};

/// What the surface of the joint is given in all models.
std::vector<Setting> surface_settings(const Choice& choice) {
  const bool bounces_always = choice.bounce_vel == 0.0;  // exactly: a constant from above
  return {{"dContactBounce, bounce", "the cable's restitution",
           "Without the flag a contact does not bounce."},
          {"bounce_vel", bounces_always ? "0" : "0.1",
           bounces_always
               ? "ODE ships no default, only the 0.1 m/s of its demos, which swallows slower "
                 "rebounds."
               : "ODE ships no default; its demos have 0.1 m/s (demo_boxstack), and slower hits do "
                 "not rebound.",
           bounces_always ? Origin::ours : Origin::engine_demo},
          {"dContactSoftERP, soft_erp",
           choice.push != Push::by_rule
               ? "0.2; less in a shorter last step, in proportion"
               : "0.2, or less: as much as gravity and swing undo in the step; the rest is a move",
           choice.push != Push::by_rule
               ? "0.2 is ODE's own ERP; kept in a tiny last step it would turn a small overstretch "
                 "into a large speed."
               : "After a fast hit 0.2 of the overstretch in one step throws the body back.",
           choice.push != Push::by_rule ? Origin::engine_default : Origin::ours}};
}

ModelEntry entry(std::string name, std::string sentence, const std::vector<Setting>& own,
                 const Choice& choice, Maker maker = Maker::by_hand) {
  return {.model = {.name = std::move(name),
                    .sentence = std::move(sentence),
                    .settings = joined({world_settings(), surface_settings(choice), own}),
                    .maker = maker,
                    .in_space = joined(
                        {system_settings(),
                         {{"dWorldSetCFM in space", "ODE's own 1e-10, not 0",
                           "With 0 its solver may give up where a row is satisfied exactly: a load "
                           "on a light body then falls through both cables."}}})},
          .start = makes<FixedStepSimulation<Case, World>>(choice),
          .start_system = makes<FixedStepSimulation<SpatialSystem, SystemWorld>>(choice),
          .follows_speed = true};
}

std::vector<Setting> exact_row_settings() {
  return {{"dWorldSetCFM", "0", "ODE's 1e-10 softens every row a little."},
          {"dBodySetFiniteRotationMode", "1",
           "The default turns the body to first order only and renormalises."}};
}

std::vector<Setting> settings_that_suit_a_cable() {
  return joined(
      {exact_row_settings(),
       {{"dWorldSetContactMaxCorrectingVel", "6 times what gravity gives in a step",
         "ODE's infinity throws a body that should not rebound back with up to 0.2 of its "
         "speed; less would brake a load that swings round a full circle."}}});
}

/// A contact of ODE's own, whose surface a run may set.
ModelEntry contact_entry(std::string name, std::string sentence, const std::vector<Setting>& own,
                         const Choice& choice) {
  ModelEntry result = entry(std::move(name), std::move(sentence), own, choice, Maker::engine);
  result.model.parameters = {{.name = "bounce", .low = 0.0, .high = 1.0},
                             {.name = "bounce-vel", .low = 0.0, .high = 0.2}};
  result.model.code =
      "contact.surface.bounce = {bounce}; contact.surface.bounce_vel = {bounce-vel};";
  return result;
}

}  // namespace

std::vector<ModelEntry> fixed_step_models() {
  const ModelEntry rows = entry(
      "row",
      "A contact joint from the step after the cable is overstretched; it asks for the bounce, and "
      "takes 0.2 of the overstretch out per step without throwing the body back.",
      exact_row_settings(), row);
  return {rows,
          entry("early",
                "The same joint already in the step that would overstretch the cable: the bounce "
                "comes up to one step early.",
                exact_row_settings(), early),
          contact_entry("contact",
                        "The same joint with ODE's own CFM, rotation and push out of the "
                        "overstretch, and the bounce_vel of its demos: what one tries first.",
                        {}, contact),
          contact_entry("contact-tuned",
                        "The same contact with the settings that suit a bouncing cable.",
                        settings_that_suit_a_cable(), tuned),
          spring_model<FixedStepSimulation<SpatialSystem, SystemWorld>>(rows, {}, row)};
}

}  // namespace tautline::ode
