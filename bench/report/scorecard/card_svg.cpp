#include <fmt/format.h>

#include <algorithm>

#include "bench/base/text.hpp"
#include "bench/cases/catalogue.hpp"
#include "bench/plot/svg.hpp"
#include "bench/report/scorecard/pull_request.hpp"
#include "bench/report/scorecard/scorecards_table.hpp"
#include "bench/report/tables/columns.hpp"
#include "bench/report/words.hpp"

namespace tautline::bench {
namespace {

// Both schemes in one file: what shows it decides. The colours are the page's.
constexpr const char* card_style =
    "<style>.b{fill:#fdfcf9;stroke:#d6d1c7}.i{fill:#1c1b19}.m{fill:#66625b}.pass{fill:#2c6144}"
    ".breaks-a-limit{fill:#9c3a14}.known-deviation{fill:#7a5200}.not-judged{fill:#66625b}"
    "text{font-family:'Helvetica Neue',Arial,'Liberation Sans',sans-serif}"
    "@media (prefers-color-scheme:dark){.b{fill:#17181a;stroke:#3d3e41}.i{fill:#e4e1da}"
    ".m{fill:#a09b91}.pass{fill:#86c5a0}.breaks-a-limit{fill:#eb9468}"
    ".known-deviation{fill:#e0b643}.not-judged{fill:#a09b91}}</style>\n";

/// Names longer than this leave the card [bytes].
constexpr std::size_t longest_name = 24;
constexpr std::size_t longest_model = 21;

std::string name_of(const std::string& text) { return xml_text(printable(text, longest_name)); }

std::string line(int y, int size, const char* look, const std::string& xml, int x = 16) {
  return fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" class=\"{}\">{}</text>\n", x, y,
                     size, look, xml);
}

/// A number with its meaning in two lines below, in one of three columns.
std::string number(int column, const std::string& value, const std::string& meaning,
                   const std::string& more) {
  const int x = 16 + 128 * column;
  return line(112, 20, "i", value, x) + line(132, 11, "m", meaning, x) +
         line(147, 11, "m", more, x);
}

/// What the card speaks of: what is shipped, or else what comes first.
const MakerCard* spoken_of(const Scorecard& card) {
  return card.makers.empty() ? nullptr : &card.makers.front();
}

std::string numbers(const Report& report, const MakerCard& card) {
  const auto right = std::count_if(card.models.begin(), card.models.end(),
                                   [](const ModelCard& model) { return model.rebounds_rightly(); });
  std::string out = number(0, fmt::format("{} of {}", right, card.models.size()), "models rebound",
                           std::string("rightly, ") + words_of(card.maker));
  const std::string unit = is_nondimensional(report) ? "unit of time" : "simulated s";
  if (!card.use || !card.use->off) {
    return out + number(1, dash, "no error", "was measured");
  }
  const Setup& use = *card.use;
  out += number(1, percent_text(*use.off), "of a cable’s length off,",
                fmt::format("step {:g}", use.step));
  return out + number(2, use.cost ? fmt::format("{:.2g} ms", 1e3 * use.cost->second_cost) : dash,
                      "a " + unit + ", with", xml_text(printable(use.model, longest_model)));
}

}  // namespace

std::string card_svg(const Report& report, const std::string& engine) {
  const Scorecard card = scorecard(report, engine);
  const std::string verdict = tally_text(card.verdicts);
  std::string out = svg_start(
      400, 176, fmt::format(" aria-label=\"{}: {}\"", name_of(engine), xml_text(verdict)));
  out += card_style;
  out += "<rect class=\"b\" x=\"0.5\" y=\"0.5\" width=\"399\" height=\"175\" rx=\"4\"/>\n";
  out += line(34, 22, "i", name_of(engine));
  out += line(52, 12, "m", name_of(card.version) + ", " + name_of(card.precision));
  const bool all = card.verdicts.of(card.verdicts.worst()) == card.verdicts.runs();
  out += line(76, 15, word_look(card.verdicts.worst()).c_str(),
              xml_text(verdict) + (all ? "" : " runs"));
  if (const MakerCard* const of = spoken_of(card)) {
    out += numbers(report, *of);
  }
  out += line(167, 10, "m",
              fmt::format("slack cables, {}, against the exact motion by tautline {}",
                          counted(report.cases.size(), "case"), name_of(report.version)));
  return out + "</svg>\n";
}

std::string card_name(const std::string& engine) {
  std::string name = folder_name(engine).string();
  std::replace(name.begin(), name.end(), '/', '-');
  return "card-" + name + ".svg";
}

}  // namespace tautline::bench
