#include <gtest/gtest.h>

#include "support.hpp"
#include "system/spatial_truths.hpp"

namespace tautline::test {
namespace {

TEST(InSpace, MotionsAreThoseOfTheirClosedForms) {
  for (const Difference& one : Differences<double>().all()) {
    expect_within(one.of, one.size, 1e-12);
  }
}

}  // namespace
}  // namespace tautline::test
