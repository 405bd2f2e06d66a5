// A cable is a constraint of our own, as DART's joint limits are: it acts while the cable is
// overstretched when a step starts (`row`), or already when the step would overstretch it
// (`early`). DART solves the rows by pivoting, so that nothing is left to tune. `spring` pulls
// elastic cables by forces, and leaves the others to these rows.

#include "adapter/row_model.hpp"
#include "adapter/spring_model.hpp"
#include "models.hpp"
#include "world.hpp"

namespace tautline::dart_engine {
namespace {

/// The rows learn it before gravity acts: DART asks them after it.
template <class Base>
class Told : public Base {
 public:
  using Base::Base;

  template <class Look>
  void advance(double dt, const Look& look) {
    look();
    Base::advance(dt);
  }
};

class RowWorld : public Told<World> {
 public:
  using InSpace = Told<SystemWorld>;
  using Told<World>::Told;
};

}  // namespace

std::vector<ModelEntry> row_models() {
  std::vector<ModelEntry> result = row_and_early<RowWorld>({}, {}, system_settings());
  result.push_back(spring_model<RowSimulation<RowWorld::InSpace, SpatialSystem>>(
      result.front(), {}, Activation::overstretched));
  return result;
}

}  // namespace tautline::dart_engine
