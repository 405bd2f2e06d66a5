#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tautline {

/// A case has 1 to this many cables.
inline constexpr std::size_t max_cables = 8;

/// A set of cables of one case, by index. Iterating gives the indices in rising order.
class CableSet {
 public:
  /// Forward iteration over the indices in the set.
  class Iterator {
   public:
    explicit constexpr Iterator(unsigned bits) : bits_(bits) {}
    constexpr std::size_t operator*() const {
      return static_cast<std::size_t>(std::countr_zero(bits_));
    }
    constexpr Iterator& operator++() {
      bits_ &= bits_ - 1U;  // drops the lowest set bit
      return *this;
    }
    constexpr bool operator==(const Iterator&) const = default;

   private:
    unsigned bits_;
  };

  constexpr CableSet() = default;

  /// The set {index}; index < max_cables.
  static constexpr CableSet of(std::size_t index) { return CableSet(1U << index); }

  /// The first `count` cables of a case; count <= max_cables.
  static constexpr CableSet first(std::size_t count) { return CableSet((1U << count) - 1U); }

  constexpr void insert(std::size_t index) { bits_ |= 1U << index; }  // also where it is in already
  constexpr void erase(std::size_t index) { bits_ &= ~(1U << index); }  // also where it is not in
  /// Whether the cable of this index is in.
  [[nodiscard]] constexpr bool contains(std::size_t index) const {
    return ((bits_ >> index) & 1U) != 0;
  }
  [[nodiscard]] constexpr bool empty() const { return bits_ == 0; }  // whether none is in
  /// How many cables are in.
  [[nodiscard]] constexpr std::size_t size() const {
    std::size_t count = 0;  // of at most eight: a call of a function costs more
    for (unsigned left = bits_; left != 0; left &= left - 1U) {
      ++count;
    }
    return count;
  }
  [[nodiscard]] constexpr Iterator begin() const { return Iterator(bits_); }  // in rising order
  [[nodiscard]] constexpr Iterator end() const { return Iterator(0); }        // past the last
  /// The indices in rising order.
  [[nodiscard]] std::vector<std::size_t> indices() const {
    std::vector<std::size_t> result;
    for (const std::size_t index : *this) {
      result.push_back(index);
    }
    return result;
  }

  constexpr bool operator==(const CableSet&) const = default;  // the same cables
  /// Those of a that are not in b.
  friend constexpr CableSet operator-(CableSet a, CableSet b) {
    return CableSet(a.bits_ & ~b.bits_);
  }
  /// Those of either.
  friend constexpr CableSet operator|(CableSet a, CableSet b) {
    return CableSet(a.bits_ | b.bits_);
  }
  /// Those of both.
  friend constexpr CableSet operator&(CableSet a, CableSet b) {
    return CableSet(a.bits_ & b.bits_);
  }

 private:
  explicit constexpr CableSet(unsigned bits) : bits_(bits) {}
  unsigned bits_ = 0;
};

}  // namespace tautline
