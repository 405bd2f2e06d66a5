#include "bench/suite/report_of.hpp"

#include <fmt/format.h>

#include "bench/base/atomic_file.hpp"
#include "bench/cases/catalogue.hpp"
#include "bench/report/json/json.hpp"

namespace tautline::bench {

std::string motion_file(const std::string& case_name) {
  return ("motions" / folder_name(case_name)).generic_string() + ".js";
}

void write_motions(const std::filesystem::path& out, const Report& report, const Replay& replay) {
  for (const CaseRow& row : report.cases) {
    if (row.motions) {
      // the file's name stands for the case: it needs no quoting
      write_file(out / *row.motions,
                 fmt::format("tautline.motionsCame(\"{}\", {});\n", *row.motions,
                             motions_json(report, replay, row.name)));
    }
  }
}

}  // namespace tautline::bench
