#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/base/form.hpp"
#include "bench/base/problems.hpp"
#include "bench/base/toml.hpp"

namespace tautline::bench {

/// N numbers that a file has as an array.
template <int N>
using Numbers = Eigen::Matrix<double, N, 1>;

/// The most entries of an array of tables that may have any number of them.
inline constexpr std::size_t no_most = std::numeric_limits<std::size_t>::max();

/// One table of a file, asked for its keys one by one. Each question that has no sound answer adds
/// a finding and returns a default; keys nobody asked for are unknown. A table that is made from
/// a form notes there what it is asked for, and answers with defaults. So the code that reads a
/// file also describes it.
class StrictTable {
 public:
  using Keys = std::vector<std::string>;

  /// `path` is the table's full key, "" for the file itself; a `table` that is null lacks every
  /// key.
  StrictTable(const toml::table* table, std::string path, FileProblems& wrong);
  explicit StrictTable(Form& form) : form_(&form) {}

  /// An editor proposes `words`.
  [[nodiscard]] std::string text(const Key& key, const std::vector<std::string>& words = {});
  /// A string that may be empty; `right` ends the sentence on another value.
  [[nodiscard]] std::string text_or_empty(const Key& key,
                                          const std::string& right = "must be a string");
  [[nodiscard]] std::optional<std::string> optional_text(const Key& key);
  /// A string that is one of `words`.
  [[nodiscard]] std::string one_of(const Key& key, const std::vector<std::string>& words);
  [[nodiscard]] std::optional<std::string> optional_one_of(const Key& key,
                                                           const std::vector<std::string>& words);
  /// true or false; false where the key is missing.
  [[nodiscard]] bool flag(const Key& key);
  /// An array of at least one string that is not empty; `right` tells what it should hold. `words`
  /// are those that it may hold, if they are known: the caller refuses others.
  [[nodiscard]] std::vector<std::string> texts(const Key& key, const std::string& right,
                                               const std::vector<std::string>& words = {});
  [[nodiscard]] std::optional<std::vector<std::string>> optional_texts(const Key& key,
                                                                       const std::string& right);
  [[nodiscard]] double number(const Key& key, const Range& range, std::string_view unit);
  [[nodiscard]] std::optional<double> optional_number(const Key& key, const Range& range,
                                                      std::string_view unit);
  /// An array of at least one number; empty where the key is missing, which it may be unless it is
  /// `required`.
  [[nodiscard]] std::vector<double> numbers(const Key& key, std::string_view unit,
                                            const Range& range = any_number, bool required = false);
  /// One number in `range`, or an array of at least one number; empty where the key is missing.
  [[nodiscard]] std::vector<double> number_or_numbers(const Key& key, const Range& range,
                                                      std::string_view unit);
  /// An array of N numbers, 2 to 4: a point or a direction, or a quaternion.
  template <int N>
  [[nodiscard]] Numbers<N> vector(const Key& key, std::string_view unit,
                                  const Range& range = any_number) {
    return Numbers<N>(numbers_of(key, N, unit, range).data());
  }
  template <int N>
  [[nodiscard]] std::optional<Numbers<N>> optional_vector(const Key& key, std::string_view unit,
                                                          const Range& range = any_number) {
    if (!describes() && !has(key.name)) {
      return std::nullopt;
    }
    const Numbers<N> result = vector<N>(key, unit, range);
    if (describes()) {
      may_be_missing();
      return std::nullopt;
    }
    return result;
  }
  [[nodiscard]] StrictTable table(const Key& key);
  /// A table, or the value of its key `inside` may be there instead of the table: 1.5 for
  /// { value = 1.5 }, if 1.5 is in `range`.
  [[nodiscard]] StrictTable table_or(const Key& key, std::string_view inside, bool required,
                                     const Range& range = any_number);
  /// True where that value is there instead of the table, or nothing is.
  [[nodiscard]] bool is_short() const { return !short_.empty(); }
  /// True where questions are noted and no file is read.
  [[nodiscard]] bool describes() const { return form_ != nullptr; }
  /// True where the table has `key`, which is known from now on.
  [[nodiscard]] bool has(std::string_view key) { return find(key) != nullptr; }

  /// Calls `ask` if the table has `key`. The other keys that it asks for go with this one: without
  /// it they are unknown.
  template <class Ask>
  void with(std::string_view key, const Ask& ask) {
    with_ = key;
    if (form_ != nullptr || find(key) != nullptr) {
      ask();
    }
    with_ = "";
  }

  /// Notes a `rule` of a form for `key`, which has been asked for: what `others` are to it.
  void note_rule(std::string_view key, Keys Form::*rule, const Keys& others);

  /// Refuses `key`, which has been asked for, where one of `others` is there; `right` ends the
  /// finding.
  void refuse_beside(std::string_view key, const Keys& others, const std::string& right);

  /// How many of `keys` the table has. It must have one of them: the caller refuses another number.
  [[nodiscard]] std::size_t count(const std::vector<std::string>& keys);

  /// An array of those, such as [[0.0, 0.9], [1.0, 0.5]]; empty where the key is missing, which it
  /// may be unless it is `required`. `form` tells what the numbers are, if not coordinates.
  template <int N>
  [[nodiscard]] std::vector<Numbers<N>> vectors(const Key& key, std::string_view unit,
                                                bool required = false, std::string_view form = "") {
    std::vector<Numbers<N>> result;
    const std::vector<double> numbers = all_numbers_of(key, N, form, unit, required);
    for (std::size_t first = 0; first < numbers.size(); first += N) {
      result.emplace_back(numbers.data() + first);
    }
    return result;
  }

  /// One table for each of the 1 to `most` entries of an array; `right` tells what it should hold.
  /// The `count` coordinates that its key `inside` has may be there instead of a table, unless that
  /// is "".
  [[nodiscard]] std::vector<StrictTable> tables(const Key& key, std::size_t most,
                                                const std::string& right,
                                                std::string_view inside = "",
                                                std::size_t count = 2);

  /// The same; none where the key is missing.
  [[nodiscard]] std::vector<StrictTable> optional_tables(const Key& key, std::size_t most,
                                                         const std::string& right,
                                                         std::string_view inside = "",
                                                         std::size_t count = 2);

  /// A table for each entry of the array `each`: what an entry does not say, this table says for
  /// all of them. This table itself where the key is missing.
  [[nodiscard]] std::vector<StrictTable> each(std::size_t most);

  /// Adds a finding on the value of `key`, if it is there.
  void refuse_value(std::string_view key, const std::string& why);

  /// Adds a finding, and is true, if neither an array nor a table is there; `right` ends it.
  [[nodiscard]] bool refuse_other_than_array(const std::string& right);

  /// Adds a finding if the table has no key at all; `right` tells what it should hold.
  void refuse_empty(const std::string& right);

  /// Adds a finding for each key that no question has named. Ask last.
  void refuse_unknown_keys();

 private:
  /// The note of a question; null where a file is read.
  Form* note(Form::Kind kind, const Key& key, std::string_view unit = "");
  /// The answer of `ask`; none where `key` is missing.
  template <class Ask>
  auto if_there(const Key& key, const Ask& ask) -> std::optional<decltype(ask())>;
  const toml::node* find(std::string_view key);
  const toml::node* find_required(std::string_view key, const std::string& right);
  double checked(const toml::node& node, const std::string& name, const Range& range,
                 std::string_view unit);
  std::vector<double> numbers_of(const Key& key, std::size_t count, std::string_view unit,
                                 const Range& range);
  /// The numbers of all entries, one after the other.
  std::vector<double> all_numbers_of(const Key& key, std::size_t count, std::string_view form,
                                     std::string_view unit, bool required);
  std::vector<double> checked_numbers(const toml::node& node, const std::string& name,
                                      std::size_t count, std::string_view form,
                                      std::string_view unit, const Range& range = any_number);
  void may_be_missing();
  void refuse(const toml::node& node, const std::string& name, const std::string& why);
  [[nodiscard]] std::string full_name(std::string_view key) const;
  void refuse_unknown_keys(const toml::table& table);
  /// The table that `node` is, or the value of `inside` by itself.
  StrictTable table_or_value(const toml::node* node, std::string name, std::string_view inside);

  const toml::table* table_ = nullptr;
  std::string path_;
  const toml::table* common_ = nullptr;  // around an entry of `each`: says what that does not
  std::string common_path_;
  std::string_view short_;               // the key that has `value_`; "" in a table
  const toml::node* value_ = nullptr;    // instead of a table; null: nothing is there
  const toml::table* around_ = nullptr;  // `value_`, and has a line if that has none
  FileProblems* wrong_ = nullptr;
  Form* form_ = nullptr;   // takes notes; null where a file is read
  std::string_view with_;  // the key that the next ones go with
  std::vector<std::string> known_;
};

}  // namespace tautline::bench
