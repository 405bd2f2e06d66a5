// What the docs say of mass ratios and cost, measured beside the engine's own joints.

#pragma once

namespace tautline::test {

/// Prints both tables as Markdown; `rate` steps a second.
void print_tables(double rate);

}  // namespace tautline::test
