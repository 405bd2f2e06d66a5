#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/base/problems.hpp"
#include "bench/base/toml.hpp"
#include "tautline/case.hpp"

namespace tautline::bench {

/// Which numbers a key takes.
struct Range {
  std::string_view right;  // ends the sentence "must be ..."
  bool (*holds)(double);   // false for what is not finite
  double otherwise;        // a number in it: what a refused one is read as
};
extern const Range any_number;
extern const Range above_zero;
extern const Range zero_or_above;
extern const Range zero_to_one;

/// One table of a file, asked for its keys one by one. Each question that has no sound answer adds
/// a finding and returns a default; keys nobody asked for are unknown.
class StrictTable {
 public:
  /// `path` is the table's full key, "" for the file itself; a `table` that is null lacks every
  /// key.
  StrictTable(const toml::table* table, std::string path, FileProblems& wrong);

  [[nodiscard]] std::string text(std::string_view key);
  /// A string that may be empty; `right` ends the sentence on another value.
  [[nodiscard]] std::string text_or_empty(std::string_view key,
                                          const std::string& right = "must be a string");
  [[nodiscard]] std::optional<std::string> optional_text(std::string_view key);
  /// A string that is one of `words`.
  [[nodiscard]] std::string one_of(std::string_view key, const std::vector<std::string>& words);
  [[nodiscard]] std::optional<std::string> optional_one_of(std::string_view key,
                                                           const std::vector<std::string>& words);
  /// true or false; false where the key is missing.
  [[nodiscard]] bool flag(std::string_view key);
  /// An array of at least one string that is not empty; `right` tells what it should hold.
  [[nodiscard]] std::vector<std::string> texts(std::string_view key, const std::string& right);
  [[nodiscard]] double number(std::string_view key, const Range& range, std::string_view unit);
  [[nodiscard]] std::optional<double> optional_number(std::string_view key, const Range& range,
                                                      std::string_view unit);
  /// An array of numbers; empty where the key is missing.
  [[nodiscard]] std::vector<double> numbers(std::string_view key, std::string_view unit,
                                            const Range& range = any_number);
  [[nodiscard]] Vec2 pair(std::string_view key, std::string_view unit);
  [[nodiscard]] std::optional<Vec2> optional_pair(std::string_view key, std::string_view unit,
                                                  const Range& range = any_number);
  [[nodiscard]] StrictTable table(std::string_view key);
  [[nodiscard]] bool has(std::string_view key) { return find(key) != nullptr; }

  /// An array of pairs, such as [[0.0, 0.9], [1.0, 0.5]]; empty where the key is missing. `form`
  /// tells what the two numbers are.
  [[nodiscard]] std::vector<Vec2> pairs(std::string_view key, std::string_view form,
                                        std::string_view unit);

  /// One table for each of the 1 to `most` entries of an array; `right` tells what it should hold.
  [[nodiscard]] std::vector<StrictTable> tables(std::string_view key, std::size_t most,
                                                const std::string& right);

  /// The same; none where the key is missing.
  [[nodiscard]] std::vector<StrictTable> optional_tables(std::string_view key, std::size_t most,
                                                         const std::string& right);

  /// A table for each entry of the array `each`: what an entry does not say, this table says for
  /// all of them. This table itself where the key is missing.
  [[nodiscard]] std::vector<StrictTable> each(std::size_t most);

  /// Adds a finding on the value of `key`, if it is there.
  void refuse_value(std::string_view key, const std::string& why);

  /// Adds a finding for each key that no question has named. Ask last.
  void refuse_unknown_keys();

 private:
  const toml::node* find(std::string_view key);
  const toml::node* find_required(std::string_view key, const std::string& right);
  double checked(const toml::node& node, const std::string& name, const Range& range,
                 std::string_view unit);
  Vec2 checked_pair(const toml::node& node, const std::string& name, std::string_view form,
                    std::string_view unit, const Range& range = any_number);
  void refuse(const toml::node& node, const std::string& name, const std::string& why);
  [[nodiscard]] std::string full_name(std::string_view key) const;
  void refuse_unknown_keys(const toml::table& table);

  const toml::table* table_;
  std::string path_;
  const toml::table* common_ = nullptr;  // around an entry of `each`: says what that does not
  std::string common_path_;
  FileProblems* wrong_;
  std::vector<std::string> known_;
};

}  // namespace tautline::bench
