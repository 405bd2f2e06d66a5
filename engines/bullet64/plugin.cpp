// Bullet in double precision (Debian's bullet-float64). Its float build exports the same symbols
// and can never share a process with it.

#include "tautline/plugin.hpp"

#include <string>

#include "models.hpp"
#include "world.hpp"

namespace tautline::bullet {
namespace {

static_assert(sizeof(btScalar) == sizeof(double), "bullet64 needs BT_USE_DOUBLE_PRECISION");

std::string version() {
  const int number = btGetVersion();  // 324 is 3.24; an inline function: the header's version
  return std::to_string(number / 100) + "." + std::to_string(number % 100);
}

class BulletEngine final : public TableEngine {
 public:
  BulletEngine()
      : TableEngine("bullet64", version(), precision_of<btScalar>,
                    {row_models(), contact_models(), bounce_limit_models(), event_models()}) {}
};

}  // namespace
}  // namespace tautline::bullet

TAUTLINE_PLUGIN(tautline::bullet::BulletEngine)
