#pragma once

#include <functional>
#include <iterator>
#include <type_traits>
#include <vector>

namespace tautline::bench {

/// The list of what `make`, a function or a member, makes of each of `values`; as an `Item` where
/// one is named.
template <class Item = void, class Values, class Make>
auto listed(const Values& values, Make make) {
  using Made = std::decay_t<std::invoke_result_t<Make&, decltype(*std::begin(values))>>;
  std::vector<std::conditional_t<std::is_void_v<Item>, Made, Item>> list;
  list.reserve(std::size(values));
  for (const auto& value : values) {
    list.emplace_back(std::invoke(make, value));
  }
  return list;
}

}  // namespace tautline::bench
