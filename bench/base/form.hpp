#pragma once

#include <cstddef>
#include <list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tautline::bench {

/// Which numbers a key takes.
struct Range {
  std::string_view right;            // ends the sentence "must be ..."
  double otherwise;                  // a number in it: what a refused one is read as
  std::optional<double> least = {};  // none: as small as they are
  std::optional<double> most = {};
  bool above = false;  // it begins above `least`
  bool whole = false;  // it has whole numbers alone

  /// False for what is not finite.
  [[nodiscard]] bool holds(double number) const;
};
extern const Range any_number;
extern const Range above_zero;
extern const Range zero_or_above;
extern const Range zero_to_one;

/// A key, and what it means: a sentence for a schema, without the unit.
struct Key {
  std::string_view name;
  std::string_view meaning;
};

/// Among the `words` of a form: names of one thing are right, too, "hook.mass" or "length_3".
inline constexpr const char* names_of_one = "*";

/// The values that a key takes, as its reader asks for them. The schema of a file is made of it.
struct Form {
  enum class Kind { text, flag, number, array, table };
  Kind kind = Kind::table;
  std::string key = {};      // "" for an entry of an array and for the file itself
  std::string meaning = {};  // with the unit
  bool required = false;
  std::string with = {};                     // the key without which this one is unknown, or ""
  std::vector<std::string> needs = {};       // without one of these keys this one is refused
  std::vector<std::string> unless = {};      // with one of these it may be missing
  std::vector<std::string> not_beside = {};  // with one of these it is refused
  bool not_empty = false;                    // a text is not ""
  std::vector<std::string> words = {};       // the only texts, or none: any text
  Range range = any_number;                  // for a number, and for those of `instead`
  std::size_t least = 0;                     // entries of an array, or keys of a table
  std::optional<std::size_t> most = {};      // likewise; none: any number of them
  std::list<Form> inside = {};  // the keys of a table; one form for all entries of an array
  std::vector<std::string> either = {};  // keys, if a table must have exactly one of them
  std::optional<std::size_t> each = {};  // entries at most, if a table may have an array `each`
  std::list<Form> also = {};             // another form that is right, too
  std::string instead = {};  // the key whose value may be there instead of the table, or ""
};

}  // namespace tautline::bench
