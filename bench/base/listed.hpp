#pragma once

#include <algorithm>
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

/// The first of `values` whose `member` is `wanted`; null if there is none.
template <class Values, class Member, class Wanted>
auto find_by(const Values& values, Member member, const Wanted& wanted) {
  const auto found = std::find_if(values.begin(), values.end(), [&](const auto& value) {
    return std::invoke(member, value) == wanted;
  });
  return found != values.end() ? &*found : nullptr;
}

}  // namespace tautline::bench
