// Draws of the standard case once, for a processor simulated by callgrind: `nothing` reads what is
// asked, `cases` makes their cases, `motions` solves them, `draws` does all that an ensemble does
// with each. Prints how many.

#include <cstdio>
#include <string_view>
#include <vector>

#include "bench/ensemble/draw_files.hpp"
#include "bench/ensemble/draw_table.hpp"
#include "bench/ensemble/spec_file.hpp"
#include "tautline/solve_batch.hpp"

using namespace tautline;         // NOLINT(google-build-using-namespace): a program of one page
using namespace tautline::bench;  // NOLINT(google-build-using-namespace)

int main(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  const SpecReading reading = read_spec_text(
      "case = \"breakwater/1910121100\"\nuntil = 20\n[[vary]]\nquantities = [\"x\", \"y\", "
      "\"angle\", \"velocity_x\", \"velocity_y\", \"spin\"]\nnormal = 1e-3\n",
      "draws.toml");
  EnsembleRequest request{reading.spec.value(), {}, {}, {}};
  request.setups = setups_of(request.spec, {});
  constexpr std::size_t draws = 50;
  std::size_t count = 0;
  if (what == "draws") {
    const auto results = draw_solver(request, request.setups.front())->solve(0, draws);
    DrawTable table(results.front().values.size(), draws, draws);
    for (const DrawResult& result : results) {
      table.put(result);
    }
    count = table.ended() - table.problems();
    std::printf("%zu bytes\n", chunk_csv(request.spec, 0, results).size());
  } else if (what != "nothing") {
    std::vector<Case> cases;
    for (std::size_t draw = 0; draw < draws; ++draw) {
      cases.push_back(std::get<Case>(case_of(request.spec, request.setups.front(), draw)));
    }
    count = cases.size();
    if (what == "motions") {
      count = 0;
      solve_batch(cases, {.until_locked = true, .swing_ahead = true},
                  [&](std::size_t, const Solution& solution) {
                    count += solution.arcs().size() > 1 ? 1U : 0U;
                  });
    }
  }
  std::printf("%zu draws\n", count);
}
