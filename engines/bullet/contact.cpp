// A cable is a contact: a manifold of one point at the attachment, whose normal points to the
// anchor and whose distance is the gap, made while the cable is overstretched when a step starts. A
// user reaches this through a custom collision algorithm (Bullet manual, "Collision Detection").

#include <algorithm>

#include "models.hpp"
#include "tautline/cable_row.hpp"
#include "world.hpp"

namespace tautline::bullet {
namespace {

/// A persistent manifold between the body and one anchor, of at most one point.
class CableContact {
 public:
  CableContact(World& world, btRigidBody& anchor)
      : dispatcher_(world.dispatcher()),
        body_(world.body()),
        manifold_(dispatcher_.getNewManifold(&body_, &anchor)) {}
  CableContact(const CableContact&) = delete;
  CableContact& operator=(const CableContact&) = delete;
  ~CableContact() { dispatcher_.releaseManifold(manifold_); }

  /// Makes the contact, or updates it as Bullet does: the impulse of the last step stays with it.
  void touch(const CableRow& row, const Vec2& anchor, double restitution) {
    const btVector3 world_point = vector(row.point);
    btManifoldPoint point(body_.getCenterOfMassTransform().invXform(world_point),
                          world_point - vector(anchor), vector(row.towards),
                          static_cast<btScalar>(row.gap));
    point.m_positionWorldOnA = world_point;
    point.m_positionWorldOnB = world_point;
    point.m_combinedRestitution = static_cast<btScalar>(restitution);
    point.m_combinedFriction = 0;
    if (manifold_->getNumContacts() == 0) {
      manifold_->addManifoldPoint(point);
    } else {
      manifold_->replaceContactPoint(point, 0);
    }
  }

  void part() { manifold_->clearManifold(); }

  [[nodiscard]] double impulse() const {
    return manifold_->getNumContacts() == 0 ? 0.0 : manifold_->getContactPoint(0).m_appliedImpulse;
  }

 private:
  btDispatcher& dispatcher_;
  btRigidBody& body_;
  btPersistentManifold* manifold_;
};

/// What the two models set otherwise.
enum class Tuning { as_shipped, best };

class ContactSimulation final : public SteppedSimulation {
 public:
  ContactSimulation(const Case& the_case, const RunSettings& run, Tuning tuning)
      : case_(the_case), run_(run), world_(the_case), impulses_(the_case.cables.size()) {
    if (tuning == Tuning::best) {
      world_.solver_info().m_restitutionVelocityThreshold = 0;
      world_.solver_info().m_splitImpulsePenetrationThreshold = 0;
      world_.solver_info().m_warmstartingFactor = 0;
    }
    for (const Cable& cable : case_.cables) {
      contacts_.push_back(
          std::make_unique<CableContact>(world_, world_.add_fixed_body(vector(cable.anchor))));
    }
  }

  [[nodiscard]] State state() const override { return world_.state(); }
  [[nodiscard]] std::span<const double> impulses() const override { return impulses_; }

  void step(double dt) override {
    const State start = world_.state();
    for (std::size_t index = 0; index < contacts_.size(); ++index) {
      const Cable& cable = case_.cables[index];
      const CableRow row = cable_row(cable, start);
      if (acts(row, Activation::overstretched, dt)) {
        contacts_[index]->touch(row, cable.anchor,
                                parameter_of(run_, "restitution", restitution(cable, row.rate)));
      } else {
        contacts_[index]->part();
      }
    }
    world_.solver_info().m_erp2 = static_cast<btScalar>(correction_in_step(dt, run_.step));
    world_.advance(dt);
    std::transform(contacts_.begin(), contacts_.end(), impulses_.begin(),
                   [](const auto& contact) { return contact->impulse(); });
  }

 private:
  const Case case_;
  RunSettings run_;
  World world_;
  std::vector<std::unique_ptr<CableContact>> contacts_;
  std::vector<double> impulses_;
};

std::vector<Parameter> contact_parameters() {
  return {{.name = "restitution", .low = 0.0, .high = 1.0}};
}

constexpr const char* contact_code = "point.m_combinedRestitution = {restitution};";

/// The settings of both models, and those of one.
std::vector<Setting> contact_settings(const std::vector<Setting>& own) {
  return joined({world_settings(),
                 {{"m_combinedRestitution", "the cable's restitution",
                   "Bullet's contact does not bounce by default."},
                  {"m_erp2", "0.2; less in a shorter last step, in proportion",
                   "0.2 is Bullet's own; kept in a tiny last step it would turn a small "
                   "overstretch into a large speed.",
                   Origin::engine_default}},
                 own});
}

std::vector<Setting> settings_that_suit_a_cable() {
  return {
      {"m_restitutionVelocityThreshold", "0", "Bullet's 0.2 m/s swallows every slower rebound."},
      {"m_splitImpulsePenetrationThreshold", "0",
       "With Bullet's -0.04 m a shallow overstretch is pushed out by velocity on top of the "
       "bounce, which gains energy."},
      {"m_warmstartingFactor", "0", "The impulse of a bounce is no guess for the step after it."}};
}

}  // namespace

std::vector<ModelEntry> contact_models() {
  return {{.model = {.name = "contact",
                     .sentence = "A contact without friction from the step after the cable is "
                                 "overstretched, with Bullet's own settings: what one tries first.",
                     .settings = contact_settings({}),
                     .maker = Maker::engine,
                     .parameters = contact_parameters(),
                     .code = contact_code},
           .start = makes<ContactSimulation>(Tuning::as_shipped),
           .follows_speed = true},
          {.model = {.name = "contact-tuned",
                     .sentence = "The same contact with the settings that suit a bouncing cable.",
                     .settings = contact_settings(settings_that_suit_a_cable()),
                     .maker = Maker::engine,
                     .parameters = contact_parameters(),
                     .code = contact_code},
           .start = makes<ContactSimulation>(Tuning::best),
           .follows_speed = true}};
}

}  // namespace tautline::bullet
