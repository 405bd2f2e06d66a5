// Which cables hang on a body: those that share one are solved together. Bullet has no such list
// (btRigidBody::getConstraintRef lists constraints whose bodies do not collide).

#ifndef TAUTLINE_BT_CABLES_ON_BODY_H
#define TAUTLINE_BT_CABLES_ON_BODY_H

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

class btCableInSolver;

/// The cables of one body, in the order they were made. Cables enter when they are made and leave
/// when they are destroyed, from any thread; while the body's world is stepped nobody writes.
class btCablesOnBody {
 public:
  /// The list of `body`, shared by all its cables; it ends with the last of them.
  static std::shared_ptr<btCablesOnBody> enter(const btRigidBody& body, btCableInSolver* cable) {
    const std::lock_guard<std::mutex> lock(mutex());
    std::weak_ptr<btCablesOnBody>& known = lists()[&body];
    std::shared_ptr<btCablesOnBody> list = known.lock();
    if (!list) {
      known = list = std::make_shared<btCablesOnBody>();
    }
    list->m_cables.push_back(cable);
    return list;
  }
  static void leave(const btRigidBody& body, std::shared_ptr<btCablesOnBody>& list,
                    btCableInSolver* cable) {
    const std::lock_guard<std::mutex> lock(mutex());
    std::vector<btCableInSolver*>& cables = list->m_cables;
    cables.erase(std::find(cables.begin(), cables.end(), cable));
    if (cables.empty()) {
      lists().erase(&body);
    }
    list.reset();
  }

  const std::vector<btCableInSolver*>& cables() const { return m_cables; }

 private:
  static std::mutex& mutex() {
    static std::mutex one;
    return one;
  }
  static std::unordered_map<const btRigidBody*, std::weak_ptr<btCablesOnBody>>& lists() {
    static std::unordered_map<const btRigidBody*, std::weak_ptr<btCablesOnBody>> all;
    return all;
  }

  std::vector<btCableInSolver*> m_cables;
};

// NOLINTEND(modernize-use-nodiscard)

#endif
