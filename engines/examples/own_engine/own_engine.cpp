// An engine of one's own on the bench. `Toy` stands for your engine: a planar body, semi-implicit
// Euler, constraint rows solved by projected Gauss-Seidel. The rest is what tautline wants to know
// of it: where the body is, how it steps, and how a cable is modelled in it. Here it is modelled in
// two ways: `row`, as a user of the engine would, and `event`, in which tautline finds the impacts.

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "tautline/cable_row.hpp"     // a cable at a pose, as a constraint row
#include "tautline/event_driver.hpp"  // the `event` model of any engine
#include "tautline/model_table.hpp"   // an engine is a table of models
#include "tautline/plugin.hpp"        // TAUTLINE_PLUGIN

namespace {

using namespace tautline;

/// The engine. Yours is bigger and knows nothing of tautline.
struct Toy {
  struct Row {  // J v >= wanted, impulse >= 0
    Vec2 direction;
    double moment;
    double wanted;         // [m/s]
    double impulse = 0.0;  // [N s]
  };

  Body body;
  Vec2 gravity;
  State now;
  std::vector<Row> rows;

  void step(double dt) {
    now.velocity += dt * gravity;
    solve();
    now.position += dt * now.velocity;
    now.angle += dt * now.spin;
  }

  /// Sweeps over the rows until none of them changes a rate by more than rounding.
  void solve() {
    const double rounding = 1e-15 * (now.velocity.norm() + std::abs(now.spin));
    bool changed = true;
    for (int sweep = 0; sweep < 10'000 && changed; ++sweep) {
      changed = false;
      for (Row& row : rows) {
        const double turn = body.inertia > 0.0 ? row.moment / body.inertia : 0.0;
        const double response = 1.0 / body.mass + turn * row.moment;
        const double rate = row.direction.dot(now.velocity) + row.moment * now.spin;
        const double before = row.impulse;
        row.impulse = std::max(0.0, before + (row.wanted - rate) / response);
        now.velocity += (row.impulse - before) / body.mass * row.direction;
        now.spin += (row.impulse - before) * turn;
        changed = changed || std::abs(row.impulse - before) * response > rounding;
      }
    }
  }
};

/// Fixed steps: a cable has a row in a step that starts with it overstretched.
class RowSimulation final : public SteppedSimulation {
 public:
  RowSimulation(const Case& the_case, const RunSettings& run)
      : case_(the_case),
        toy_{the_case.body, the_case.gravity, the_case.initial, {}},
        correction_(usual_correction / run.step),
        impulses_(the_case.cables.size()) {}

  [[nodiscard]] State state() const override { return toy_.now; }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }

  void step(double dt) override {
    toy_.rows.clear();
    std::vector<std::size_t> acting;
    for (std::size_t index = 0; index < case_.cables.size(); ++index) {
      const Cable& cable = case_.cables[index];
      const CableRow row = cable_row(cable, toy_.now);
      if (acts(row, Activation::overstretched, dt)) {
        // the larger of the bounce and the correction; their sum would gain energy, and a faster
        // correction would throw a body back that has hit its cable
        const double wanted = wanted_rate(row, restitution(cable, row.rate), correction_,
                                          change_in_step(case_, index, toy_.now, dt));
        toy_.rows.push_back({row.towards, row.moment, wanted});
        acting.push_back(index);
      }
    }
    toy_.step(dt);
    // what the rows leave of the overstretch goes out without a change of velocity
    toy_.now = out_of_overstretch(case_, toy_.now, correction_, dt).value_or(toy_.now);
    std::fill(impulses_.begin(), impulses_.end(), 0.0);
    for (std::size_t row = 0; row < acting.size(); ++row) {
      impulses_[acting[row]] = toy_.rows[row].impulse;
    }
  }

 private:
  const Case case_;
  Toy toy_;
  double correction_;  // [1/s], part of the overstretch
  std::vector<double> impulses_;
};

/// Four functions of the engine, and the driver does the rest.
class ToyAdapter final : public EventAdapter {
 public:
  explicit ToyAdapter(const Case& the_case)
      : case_(the_case), toy_{the_case.body, the_case.gravity, the_case.initial, {}} {}

  [[nodiscard]] State state() const override { return toy_.now; }
  void place(const State& state) override { toy_.now = state; }

  /// Half of gravity's impulse less before the step and more after it make semi-implicit Euler fly
  /// the exact parabola.
  void fly(double dt) override {
    toy_.rows.clear();
    toy_.now.velocity -= 0.5 * dt * case_.gravity;
    toy_.step(dt);
    toy_.now.velocity += 0.5 * dt * case_.gravity;
  }

  [[nodiscard]] CableVector solve(CableSet cables, const CableVector& rates) override {
    toy_.rows.clear();
    for (const std::size_t index : cables) {
      const CableRow row = cable_row(case_.cables[index], toy_.now);
      const auto position = static_cast<Eigen::Index>(toy_.rows.size());
      toy_.rows.push_back({row.towards, row.moment, rates[position]});
    }
    toy_.solve();
    CableVector impulses(rates.size());
    std::transform(toy_.rows.begin(), toy_.rows.end(), impulses.begin(),
                   [](const Toy::Row& row) { return row.impulse; });
    return impulses;
  }

 private:
  const Case case_;
  Toy toy_;
};

/// What `tautline engines` prints and every report holds. Name every setting of your engine that is
/// not its default, and say why.
EngineTable own_engine() {
  return {
      .name = "own-engine",
      .version = "1.0",
      .precision = precision_of<double>,
      .families = {
          {{.model = {.name = "row",
                      .sentence = "A one-sided row in the steps that start with the cable "
                                  "overstretched.",
                      .settings = {}},
            .start = makes<RowSimulation>(),
            .follows_speed = true},
           event_model<ToyAdapter>(
               "The engine flies and solves, tautline finds the instants of the impacts.", {})}}};
}

}  // namespace

TAUTLINE_PLUGIN(EngineOf<own_engine>)
