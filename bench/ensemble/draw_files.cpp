#include "bench/ensemble/draw_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <system_error>

#include "bench/base/input_file.hpp"
#include "bench/base/text.hpp"
#include "bench/cases/catalogue.hpp"
#include "bench/ensemble/statistic.hpp"
#include "tautline/case_file.hpp"

namespace tautline::bench {
namespace {

/// A longer file is none of ours [bytes].
constexpr std::size_t longest_chunk = std::size_t{1} << 24U;

/// The text up to the next `mark`, which is taken from `rest` with it.
std::string_view take(std::string_view& rest, char mark) {
  const std::size_t end = std::min(rest.find(mark), rest.size());
  const std::string_view part = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return part;
}

template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value)
                                                                  : std::nullopt;
}

std::string heading(const EnsembleSpec& spec, std::uint64_t fingerprint) {
  std::string line = fmt::format("# tautline ensemble {:016x}\ndraw,problem", fingerprint);
  for (const Statistic& statistic : statistics_of(spec)) {
    line += "," + statistic.name;
  }
  return line + "\n";
}

/// A sentence in a cell: no commas, which part cells, and no quotes.
std::string cell(const std::string& text) {
  std::string result = printable(text);
  std::replace(result.begin(), result.end(), ',', ';');
  std::replace(result.begin(), result.end(), '"', '\'');
  return result;
}

/// Adds the shortest decimal that reads back as the same number.
template <class Number>
void add_number(std::string& line, Number number) {
  std::array<char, 32> digits{};  // the longest is 24 characters, as in -1.7976931348623157e+308
  const auto [end, error] = std::to_chars(digits.begin(), digits.end(), number);
  line.append(digits.begin(), end);
}

/// A line as a draw; none if it is not one.
std::optional<DrawResult> draw_in(std::string_view line, std::size_t values) {
  const auto draw = number_in<std::size_t>(take(line, ','));
  DrawResult result{draw.value_or(0), std::string(take(line, ',')), {}};
  result.values.reserve(values);
  if (!draw) {
    return std::nullopt;
  }
  for (std::size_t place = 0; place < values && result.problem.empty(); ++place) {
    const std::string_view text = take(line, ',');
    const auto value = number_in<double>(text);
    if (!value && !text.empty()) {
      return std::nullopt;
    }
    result.values.push_back(value);
  }
  return result;
}

}  // namespace

std::uint64_t draws_fingerprint(const EnsembleSpec& spec, const EnsembleSetup& setup,
                                std::uint64_t program) {
  std::string text = written(spec.the_case);
  text += fmt::format("{:016x} {} {} {} {}\n", program, spec.seed, static_cast<int>(spec.sampling),
                      shortest(spec.speeds[0]), shortest(spec.speeds[1]));
  for (const auto& [name, distribution, unit] : spec.varied) {
    text += fmt::format("{} {}", name, static_cast<int>(distribution.kind));
    for (const double number : distribution.numbers) {
      text += " " + shortest(number);
    }
    text += "\n";
  }
  text += fmt::format("{} {} {} {} {} {} {}", to_string(setup.exact.law),
                      setup.exact.seed.value_or(spec.seed), setup.exact.quantity,
                      shortest(setup.exact.factor), shortest(setup.exact.completion), setup.model,
                      shortest(setup.step));
  return stable_hash(text);
}

std::filesystem::path chunk_file(const std::filesystem::path& out, const EnsembleSetup& setup,
                                 std::size_t first) {
  return out / "draws" / folder_name(setup.name) / fmt::format("{:08}.csv", first);
}

std::string chunk_csv(const EnsembleSpec& spec, std::uint64_t fingerprint,
                      const std::vector<DrawResult>& results) {
  std::string csv = heading(spec, fingerprint);
  for (const auto& [draw, problem, values] : results) {
    add_number(csv, draw);
    csv += ',';
    csv += problem.empty() ? problem : cell(problem);
    for (const std::optional<double>& value : values) {
      csv += ',';
      if (value) {
        add_number(csv, *value);
      }
    }
    csv += '\n';
  }
  return csv;
}

std::optional<std::vector<DrawResult>> read_chunk(const std::filesystem::path& file,
                                                  const EnsembleSpec& spec,
                                                  std::uint64_t fingerprint, std::size_t first,
                                                  std::size_t end) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    return std::nullopt;  // at once: a file that should be there is looked for under other names
  }
  const InputFile input = read_input_file(file, longest_chunk);
  const std::string head = heading(spec, fingerprint);
  // a power cut may have left a part
  if (input.problem || !input.content.starts_with(head) || !input.content.ends_with('\n')) {
    return std::nullopt;
  }
  std::string_view rest = std::string_view(input.content).substr(head.size());
  const std::size_t values = statistics_of(spec).size();
  std::vector<DrawResult> results;
  results.reserve(end - first);
  for (std::size_t draw = first; draw < end; ++draw) {
    auto result = draw_in(take(rest, '\n'), values);
    if (!result || result->draw != draw) {
      return std::nullopt;
    }
    results.push_back(std::move(*result));
  }
  return rest.empty() ? std::optional(std::move(results)) : std::nullopt;
}

}  // namespace tautline::bench
