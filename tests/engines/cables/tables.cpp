#include "tables.hpp"

namespace tautline::test {
void print_tables(double /*rate*/) {}
}  // namespace tautline::test
