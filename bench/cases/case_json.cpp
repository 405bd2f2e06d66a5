#include "bench/cases/case_json.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "bench/base/text.hpp"

namespace tautline::bench {
namespace {

using Json = nlohmann::ordered_json;

/// A case has three levels. The tables of deeper ones would be taken apart by recursion.
constexpr std::size_t deepest = 16;

/// Makes a toml::table of the values that nlohmann's parser meets. A function returns false to end
/// the parsing.
class TableMaker : public nlohmann::json_sax<Json> {
 public:
  TableMaker(std::string_view text, FileProblems& wrong) : text_(text), wrong_(wrong) {}

  std::optional<toml::table> table() && { return std::move(done_); }

  bool null() override { return refuse(place() + ": is null, leave the key out instead"); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(std::int64_t value) override { return add(value); }
  bool number_unsigned(std::uint64_t value) override {
    constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    return value <= most ? add(static_cast<std::int64_t>(value)) : add(static_cast<double>(value));
  }
  bool number_float(double value, const std::string& /*text*/) override { return add(value); }
  bool string(std::string& value) override { return add(std::move(value)); }
  bool binary(Json::binary_t& /*value*/) override { return false; }  // which JSON does not have

  bool start_object(std::size_t /*count*/) override { return begin(false); }
  bool start_array(std::size_t /*count*/) override { return begin(true); }
  bool end_object() override {
    toml::table ended = std::move(open_.back().table);
    open_.pop_back();
    if (open_.empty()) {
      done_ = std::move(ended);
      return true;
    }
    return add(std::move(ended));
  }
  bool end_array() override {
    toml::array ended = std::move(open_.back().array);
    open_.pop_back();
    return add(std::move(ended));
  }
  bool key(std::string& name) override {
    open_.back().key = std::move(name);
    return !open_.back().table.contains(open_.back().key) || refuse(place() + ": is given twice");
  }

  /// `position`: how many bytes the parser has read.
  bool parse_error(std::size_t position, const std::string& /*token*/,
                   const nlohmann::detail::exception& error) override {
    const std::string_view read = text_.substr(0, std::max<std::size_t>(position, 1) - 1);
    const std::size_t line =
        1 + static_cast<std::size_t>(std::count(read.begin(), read.end(), '\n'));
    const std::size_t column = read.size() - (read.rfind('\n') + 1) + 1;
    // "[json.exception...] parse error at line 1, column 2: what is wrong"
    std::string_view why = error.what();
    why.remove_prefix(std::min(why.find("] ") + 2, why.size()));
    if (why.starts_with("parse error")) {
      why.remove_prefix(std::min(why.find(": ") + 2, why.size()));
    }
    wrong_.add(line, "column " + std::to_string(column) + ": not JSON: " + printable(why));
    return false;
  }

 private:
  struct Open {
    bool is_array;
    toml::table table;
    toml::array array;
    std::string key;  // of the value that comes next
  };

  bool begin(bool is_array) {
    if (open_.size() == deepest) {
      return refuse(place() + ": is nested more than " + std::to_string(deepest) + " levels deep");
    }
    open_.push_back({is_array, {}, {}, {}});
    return true;
  }

  template <class Value>
  bool add(Value&& value) {
    if (open_.back().is_array) {
      open_.back().array.push_back(std::forward<Value>(value));
    } else {
      open_.back().table.insert(open_.back().key, std::forward<Value>(value));
    }
    return true;
  }

  bool refuse(const std::string& sentence) {
    wrong_.add(0, sentence);
    return false;
  }

  /// The value that comes next: "cables[0].length".
  [[nodiscard]] std::string place() const {
    std::string path;
    for (const Open& one : open_) {
      if (one.is_array) {
        path += "[" + std::to_string(one.array.size()) + "]";
      } else {
        path += (path.empty() ? "" : ".") + printable(one.key);
      }
    }
    return path;
  }

  std::string_view text_;
  FileProblems& wrong_;
  std::vector<Open> open_;  // from the outside in
  std::optional<toml::table> done_;
};

}  // namespace

bool is_json(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  text.remove_prefix(text.starts_with(mark) ? mark.size() : 0);
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && text[begin] == '{';
}

std::optional<toml::table> parse_json(std::string_view text, FileProblems& wrong) {
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
    const std::string_view before = text.substr(0, zero);
    wrong.add(1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')),
              "holds a zero byte: must be a text file (JSON)");
    return std::nullopt;
  }
  TableMaker maker(text, wrong);
  const bool right = Json::sax_parse(text, &maker);
  return right ? std::move(maker).table() : std::nullopt;
}

}  // namespace tautline::bench
