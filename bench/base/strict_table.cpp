#include "bench/base/strict_table.hpp"

#include <algorithm>
#include <cmath>

#include "bench/base/text.hpp"
#include "bench/base/value.hpp"

namespace tautline::bench {
namespace {

std::string with_unit(std::string_view right, std::string_view unit) {
  return "must be " + std::string(right) + (unit.empty() ? "" : " ") + std::string(unit);
}

bool has_key(const toml::table* table, std::string_view key) {
  return table != nullptr && table->contains(key);
}

/// The form of a point, or of a quaternion, in a sentence.
const char* coordinates_of(std::size_t count) {
  return count == 2 ? "[x, y]" : count == 3 ? "[x, y, z]" : "[w, x, y, z]";
}

/// "two numbers [x, y]" in a sentence.
std::string so_many_numbers(std::size_t count, std::string_view form) {
  return (count == 2   ? "two numbers "
          : count == 3 ? "three numbers "
                       : "four numbers ") +
         std::string(form);
}

/// Makes `form` an array of `count` numbers.
Form form_of_numbers(Form form, std::size_t count, const Range& range) {
  form.kind = Form::Kind::array;
  form.least = count;
  form.most = count;
  form.inside.push_back({.kind = Form::Kind::number, .range = range});
  return form;
}

}  // namespace

const Range any_number = {"a finite number", 0.0};
const Range above_zero = {"a finite number above 0", 1.0, 0.0, {}, true};
const Range zero_or_above = {"a finite number, 0 or above", 0.0, 0.0};
const Range zero_to_one = {"in [0, 1]", 0.0, 0.0, 1.0};

bool Range::holds(double number) const {
  const bool low = least && (above ? number <= *least : number < *least);
  const bool high = most && number > *most;
  // whole: exactly, as it is an integer
  return std::isfinite(number) && !low && !high && (!whole || number == std::floor(number));
}

StrictTable::StrictTable(const toml::table* table, std::string path, FileProblems& wrong)
    : table_(table), path_(std::move(path)), wrong_(&wrong) {}

std::string StrictTable::text(const Key& key, const std::vector<std::string>& words) {
  std::string value = text_or_empty(key, "must be a string that is not empty");
  if (form_ != nullptr) {
    form_->inside.back().not_empty = true;
    form_->inside.back().words = words;
  }
  const toml::node* node = find(key.name);
  if (node != nullptr && node->is_string() && value.empty()) {
    refuse(*node, full_name(key.name), "must be a string that is not empty");
  }
  return value;
}

std::string StrictTable::text_or_empty(const Key& key, const std::string& right) {
  note(Form::Kind::text, key);
  const toml::node* node = find_required(key.name, right);
  if (node == nullptr) {
    return "";
  }
  const auto* value = node->as_string();
  if (value == nullptr) {
    refuse(*node, full_name(key.name), "is " + type_name(*node) + ", " + right);
    return "";
  }
  return value->get();
}

std::optional<std::string> StrictTable::optional_text(const Key& key) {
  return if_there(key, [&] { return text(key); });
}

std::string StrictTable::one_of(const Key& key, const std::vector<std::string>& words) {
  if (Form* const form = note(Form::Kind::text, key)) {
    form->words = words;
  }
  const toml::node* node = find_required(key.name, "must be " + joined(words, "or"));
  if (node == nullptr) {
    return "";
  }
  const auto* value = node->as_string();
  const std::string word = value != nullptr ? value->get() : "";
  if (std::find(words.begin(), words.end(), word) == words.end()) {
    refuse(*node, full_name(key.name),
           "must be " + joined(words, "or") + suggestion(printable(word), words));
    return "";
  }
  return word;
}

std::optional<std::string> StrictTable::optional_one_of(const Key& key,
                                                        const std::vector<std::string>& words) {
  return if_there(key, [&] { return one_of(key, words); });
}

bool StrictTable::flag(const Key& key) {
  if (Form* const form = note(Form::Kind::flag, key)) {
    form->required = false;
  }
  const toml::node* node = find(key.name);
  if (node != nullptr && !node->is_boolean()) {
    refuse(*node, full_name(key.name), "is " + type_name(*node) + ", must be true or false");
  }
  return node != nullptr && node->value_or(false);
}

std::vector<std::string> StrictTable::texts(const Key& key, const std::string& right,
                                            const std::vector<std::string>& words) {
  if (Form* const form = note(Form::Kind::array, key)) {
    form->least = 1;
    form->inside.push_back({.kind = Form::Kind::text, .not_empty = true, .words = words});
  }
  std::vector<std::string> result;
  const toml::node* node = find_required(key.name, right);
  const toml::array* array = node != nullptr ? node->as_array() : nullptr;
  if (node != nullptr && (array == nullptr || array->empty())) {
    refuse(*node, full_name(key.name), right);
  }
  for (std::size_t index = 0; array != nullptr && index < array->size(); ++index) {
    const toml::node& entry = *array->get(index);
    if (const auto* value = entry.as_string(); value != nullptr && !value->get().empty()) {
      result.push_back(value->get());
    } else {
      refuse(entry, full_name(key.name) + "[" + std::to_string(index) + "]",
             "must be a string that is not empty");
    }
  }
  return result;
}

std::optional<std::vector<std::string>> StrictTable::optional_texts(const Key& key,
                                                                    const std::string& right) {
  return if_there(key, [&] { return texts(key, right); });
}

double StrictTable::number(const Key& key, const Range& range, std::string_view unit) {
  if (Form* const form = note(Form::Kind::number, key, unit)) {
    form->range = range;
  }
  const toml::node* node = find_required(key.name, with_unit(range.right, unit));
  return node != nullptr ? checked(*node, full_name(key.name), range, unit) : range.otherwise;
}

std::optional<double> StrictTable::optional_number(const Key& key, const Range& range,
                                                   std::string_view unit) {
  return if_there(key, [&] { return number(key, range, unit); });
}

std::vector<double> StrictTable::numbers(const Key& key, std::string_view unit, const Range& range,
                                         bool required) {
  if (Form* const form = note(Form::Kind::array, key, unit)) {
    form->required = form->required && required;
    form->least = 1;
    form->inside.push_back({.kind = Form::Kind::number, .range = range});
  }
  std::vector<double> result;
  const std::string right = with_unit("an array of at least one number", unit);
  const toml::node* node = required ? find_required(key.name, right) : find(key.name);
  const toml::array* array = node != nullptr ? node->as_array() : nullptr;
  if (node != nullptr && (array == nullptr || array->empty())) {
    refuse(*node, full_name(key.name), right);
  }
  for (std::size_t index = 0; array != nullptr && index < array->size(); ++index) {
    const std::string name = full_name(key.name) + "[" + std::to_string(index) + "]";
    result.push_back(checked(*array->get(index), name, range, unit));
  }
  return result;
}

std::vector<double> StrictTable::number_or_numbers(const Key& key, const Range& range,
                                                   std::string_view unit) {
  const toml::node* node = find(key.name);
  if (form_ == nullptr && node != nullptr && node->is_array()) {
    return numbers(key, unit);
  }
  std::vector<double> result;
  if (const auto one = optional_number(key, range, unit)) {
    result = {*one};
  }
  if (form_ != nullptr) {
    Form several{.kind = Form::Kind::array, .least = 1};
    several.inside.push_back({.kind = Form::Kind::number});
    form_->inside.back().also = {several};
  }
  return result;
}

std::vector<double> StrictTable::numbers_of(const Key& key, std::size_t count,
                                            std::string_view unit, const Range& range) {
  if (Form* const form = note(Form::Kind::array, key, unit)) {
    *form = form_of_numbers(std::move(*form), count, range);
  }
  const toml::node* node =
      find_required(key.name, with_unit(so_many_numbers(count, coordinates_of(count)), unit));
  return node != nullptr ? checked_numbers(*node, full_name(key.name), count, coordinates_of(count),
                                           unit, range)
                         : std::vector<double>(count, 0.0);
}

std::vector<double> StrictTable::all_numbers_of(const Key& key, std::size_t count,
                                                std::string_view form, std::string_view unit,
                                                bool required) {
  const std::string what(form.empty() ? coordinates_of(count) : form);
  if (Form* const notes = note(Form::Kind::array, key, unit)) {
    notes->required = notes->required && required;
    notes->least = 1;
    notes->inside.push_back(form_of_numbers({.meaning = what}, count, any_number));
  }
  std::vector<double> result;
  const std::string right =
      with_unit("an array of " + std::string(count == 2 ? "pairs " : "points ") + what, unit);
  const toml::node* node = required ? find_required(key.name, right) : find(key.name);
  if (node == nullptr) {
    return result;
  }
  const toml::array* array = node->as_array();
  if (array == nullptr || array->empty()) {
    refuse(
        *node, full_name(key.name),
        (array == nullptr ? "is " + type_name(*node) : std::string("none given")) + ", " + right);
    return result;
  }
  for (std::size_t index = 0; index < array->size(); ++index) {
    const std::string name = full_name(key.name) + "[" + std::to_string(index) + "]";
    const std::vector<double> one = checked_numbers(*array->get(index), name, count, what, unit);
    result.insert(result.end(), one.begin(), one.end());
  }
  return result;
}

StrictTable StrictTable::table(const Key& key) {
  if (Form* const form = note(Form::Kind::table, key)) {
    return StrictTable(*form);
  }
  const toml::node* node = find(key.name);
  if (node != nullptr && !node->is_table()) {
    refuse(*node, full_name(key.name), "is " + type_name(*node) + ", must be a table");
  }
  return {node != nullptr ? node->as_table() : nullptr, full_name(key.name), *wrong_};
}

StrictTable StrictTable::table_or(const Key& key, std::string_view inside, bool required,
                                  const Range& range) {
  if (Form* const form = note(Form::Kind::table, key)) {
    form->required = form->required && required;
    form->instead = inside;
    form->range = range;
    return StrictTable(*form);
  }
  return table_or_value(find(key.name), full_name(key.name), inside);
}

StrictTable StrictTable::table_or_value(const toml::node* node, std::string name,
                                        std::string_view inside) {
  const toml::table* table = node != nullptr ? node->as_table() : nullptr;
  StrictTable result(table, std::move(name), *wrong_);
  if (table == nullptr) {
    result.short_ = inside;
    result.value_ = node;
    result.around_ = path_.empty() ? nullptr : table_;
  }
  return result;
}

std::vector<StrictTable> StrictTable::tables(const Key& key, std::size_t most,
                                             const std::string& right, std::string_view inside,
                                             std::size_t count) {
  if (Form* const form = note(Form::Kind::array, key)) {
    form->least = 1;
    if (most != no_most) {
      form->most = most;
    }
    Form& entry = form->inside.emplace_back();
    entry.instead = inside;
    return {StrictTable(entry)};
  }
  std::vector<StrictTable> result;
  const toml::node* node = find_required(key.name, right);
  const toml::array* array = node != nullptr ? node->as_array() : nullptr;
  if (node != nullptr && array == nullptr) {
    refuse(*node, full_name(key.name), "is " + type_name(*node) + ", " + right);
  }
  if (array == nullptr) {
    return result;
  }
  if (array->empty()) {
    refuse(*node, full_name(key.name), "none given, " + right);
  }
  if (array->size() > most) {
    refuse(*array->get(most), full_name(key.name),
           std::to_string(array->size()) + " given, " + right);
  }
  for (std::size_t index = 0; index < std::min(most, array->size()); ++index) {
    const toml::node& entry = *array->get(index);
    const std::string name = full_name(key.name) + "[" + std::to_string(index) + "]";
    if (const toml::table* table = entry.as_table()) {
      result.emplace_back(table, name, *wrong_);
    } else if (!inside.empty() && entry.is_array()) {
      result.push_back(table_or_value(&entry, name, inside));
    } else {
      refuse(entry, name,
             "is " + type_name(entry) + ", must be a table" +
                 (inside.empty() ? "" : " or " + so_many_numbers(count, coordinates_of(count))));
    }
  }
  return result;
}

std::vector<StrictTable> StrictTable::optional_tables(const Key& key, std::size_t most,
                                                      const std::string& right,
                                                      std::string_view inside, std::size_t count) {
  if (form_ != nullptr) {
    std::vector<StrictTable> described = tables(key, most, right, inside, count);
    form_->inside.back().required = false;
    return described;
  }
  return find(key.name) != nullptr ? tables(key, most, right, inside, count)
                                   : std::vector<StrictTable>();
}

std::vector<StrictTable> StrictTable::each(std::size_t most) {
  if (form_ != nullptr) {
    form_->each = most;
  }
  if (find("each") == nullptr) {
    return {*this};
  }
  std::vector<StrictTable> entries =
      tables({"each", ""}, most, "must be tables, each with what tells it from the others");
  for (StrictTable& entry : entries) {
    entry.common_ = table_;
    entry.common_path_ = path_;
  }
  for (const auto& [key, node] : *table_) {
    const auto has_own = [&, name = key.str()](const StrictTable& entry) {
      return has_key(entry.table_, name);
    };
    if (!entries.empty() && std::all_of(entries.begin(), entries.end(), has_own)) {
      refuse(node, full_name(printable(key.str())),
             "every entry of each has its own, leave it out");
    }
  }
  return entries;
}

void StrictTable::refuse_value(std::string_view key, const std::string& why) {
  if (has_key(table_, key) || has_key(common_, key)) {
    refuse(*find(key), full_name(key), why);
  }
}

bool StrictTable::refuse_other_than_array(const std::string& right) {
  if (!is_short() || (value_ != nullptr && value_->is_array())) {
    return false;
  }
  if (find_required(short_, right) != nullptr) {
    refuse(*value_, path_, "is " + type_name(*value_) + ", " + right);
  }
  return true;
}

void StrictTable::refuse_empty(const std::string& right) {
  if (form_ != nullptr) {
    form_->least = 1;
  }
  if (table_ != nullptr && table_->empty()) {
    refuse(*table_, path_, "is empty, " + right);
  }
}

void StrictTable::refuse_unknown_keys() {
  if (table_ != nullptr) {
    refuse_unknown_keys(*table_);
  }
  if (common_ != nullptr) {
    refuse_unknown_keys(*common_);
  }
}

void StrictTable::refuse_unknown_keys(const toml::table& table) {
  for (const auto& [key, node] : table) {
    const bool is_each = &table == common_ && key.str() == "each";
    if (is_each || std::find(known_.begin(), known_.end(), key.str()) != known_.end()) {
      continue;
    }
    const std::string near = suggestion(key.str(), known_);
    wrong_->add(key.source().begin.line,
                full_name(printable(key.str())) + quoted_value(node) + ": unknown key" +
                    (near.empty() ? ", must be " + joined(known_, "or") : near));
  }
}

void StrictTable::note_rule(std::string_view key, Keys Form::*rule, const Keys& others) {
  if (describes()) {
    for (Form& form : form_->inside) {
      if (form.key == key) {
        form.*rule = others;
      }
    }
  }
}

void StrictTable::refuse_beside(std::string_view key, const Keys& others,
                                const std::string& right) {
  note_rule(key, &Form::not_beside, others);
  for (const std::string& other : others) {
    if (!describes() && has(other)) {
      return refuse_value(key, "is there with " + other + ", " + right);
    }
  }
}

std::size_t StrictTable::count(const std::vector<std::string>& keys) {
  if (form_ != nullptr) {
    form_->either = keys;
    return 1;
  }
  return static_cast<std::size_t>(std::count_if(
      keys.begin(), keys.end(), [&](const std::string& key) { return find(key) != nullptr; }));
}

Form* StrictTable::note(Form::Kind kind, const Key& key, std::string_view unit) {
  if (form_ == nullptr) {
    return nullptr;
  }
  Form& form = form_->inside.emplace_back();
  form.kind = kind;
  form.key = key.name;
  form.meaning = std::string(key.meaning) + (unit.empty() ? "" : " ") + std::string(unit);
  form.required = key.name != with_;
  form.with = form.required ? with_ : "";
  return &form;
}

void StrictTable::may_be_missing() {
  if (form_ != nullptr) {
    form_->inside.back().required = false;
  }
}

template <class Ask>
auto StrictTable::if_there(const Key& key, const Ask& ask) -> std::optional<decltype(ask())> {
  if (form_ != nullptr) {
    static_cast<void>(ask());
    form_->inside.back().required = false;
    return std::nullopt;
  }
  return find(key.name) != nullptr ? std::optional(ask()) : std::nullopt;
}

const toml::node* StrictTable::find(std::string_view key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) {
    known_.emplace_back(key);
  }
  if (!short_.empty()) {
    return key == short_ ? value_ : nullptr;
  }
  const toml::table* holder = has_key(table_, key) ? table_ : common_;
  return holder != nullptr ? holder->get(key) : nullptr;
}

const toml::node* StrictTable::find_required(std::string_view key, const std::string& right) {
  const toml::node* node = find(key);
  if (node == nullptr && form_ == nullptr) {
    // the file itself has no line to point at
    wrong_->add(path_.empty() ? 0 : line_of(is_short() ? around_ : table_),
                full_name(key) + ": is missing, " + right);
  }
  return node;
}

double StrictTable::checked(const toml::node& node, const std::string& name, const Range& range,
                            std::string_view unit) {
  const std::optional<double> value = as_number(node);
  if (!value) {
    refuse(node, name, "is " + type_name(node) + ", " + with_unit(range.right, unit));
    return range.otherwise;
  }
  if (!range.holds(*value)) {
    refuse(node, name, with_unit(range.right, unit));
    return range.otherwise;  // nothing is made of a number that is out of range
  }
  return *value;
}

std::vector<double> StrictTable::checked_numbers(const toml::node& node, const std::string& name,
                                                 std::size_t count, std::string_view form,
                                                 std::string_view unit, const Range& range) {
  std::vector<double> result(count, 0.0);
  const toml::array* array = node.as_array();
  const std::string right = with_unit(so_many_numbers(count, form), unit);
  if (array == nullptr) {
    refuse(node, name, "is " + type_name(node) + ", " + right);
  } else if (array->size() != count) {
    refuse(node, name, "is an array of length " + std::to_string(array->size()) + ", " + right);
  } else {
    for (std::size_t index = 0; index < count; ++index) {
      result[index] =
          checked(*array->get(index), name + "[" + std::to_string(index) + "]", range, unit);
    }
  }
  return result;
}

void StrictTable::refuse(const toml::node& node, const std::string& name, const std::string& why) {
  wrong_->add(line_of(&node), name + quoted_value(node) + ": " + why);
}

std::string StrictTable::full_name(std::string_view key) const {
  if (is_short() && key == short_) {
    return path_;
  }
  const bool is_common = has_key(common_, key) && !has_key(table_, key);
  const std::string& path = is_common ? common_path_ : path_;
  return path.empty() ? std::string(key) : path + "." + std::string(key);
}

}  // namespace tautline::bench
