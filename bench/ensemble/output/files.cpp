#include "bench/ensemble/output/output.hpp"

#include <optional>

#include "bench/base/atomic_file.hpp"
#include "bench/ensemble/output/atlas.hpp"
#include "bench/plot/motion.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {
namespace {

/// A picture of the first motion of each cell of the atlas.
void write_pictures(const std::filesystem::path& out, const EnsembleReport& report) {
  const std::optional<Atlas> atlas = atlas_of(report);
  if (!atlas) {
    return;
  }
  const EnsembleSetup& exact = report.request.setups.front();
  for (std::size_t cell = 0; cell < atlas->draws.size(); ++cell) {
    if (atlas->pictured[cell]) {
      const Case the_case = named_case_of(report.request.spec, exact, atlas->draws[cell]);
      write_file(out / picture_name(cell), plot_svg(the_case, solve(the_case, options_of(exact))));
    }
  }
}

}  // namespace

void write_ensemble(const std::filesystem::path& out, const EnsembleReport& report) {
  write_pictures(out, report);
  write_file(out / "ensemble.json", ensemble_json(report));
  write_file(out / "ensemble.md", ensemble_markdown(report));
  write_file(out / "index.html", ensemble_html(report, page_assets()));
}

}  // namespace tautline::bench
