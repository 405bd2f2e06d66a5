#pragma once

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace tautline {

/// Calls `use` with each number of `a` and its like of `b`. What has several numbers lists them in
/// a tuple `members` of pointers, and may be of lanes in one and of one body in the other.
template <class A, class B, class Use>
void each_number(A& a, B& b, const Use& use) {
  if constexpr (requires { std::remove_const_t<A>::members(); }) {
    [&]<class... OfA, class... OfB>(const std::tuple<OfA...>& of_a,
                                    const std::tuple<OfB...>& of_b) {
      [&]<std::size_t... k>(std::index_sequence<k...>) {
        (each_number(a.*std::get<k>(of_a), b.*std::get<k>(of_b), use), ...);
      }
      (std::index_sequence_for<OfA...>{});
    }(std::remove_const_t<A>::members(), std::remove_const_t<B>::members());
  } else {
    use(a, b);
  }
}

/// The size [bytes] of all that the members of T list: that of T, where none is forgotten.
template <class T>
[[nodiscard]] constexpr std::size_t size_listed() {
  if constexpr (requires { T::members(); }) {
    return []<class... Of>(const std::tuple<Of T::*...>&) {
      return (size_listed<Of>() + ...);
    }(T::members());
  } else {
    return sizeof(T);
  }
}

}  // namespace tautline
