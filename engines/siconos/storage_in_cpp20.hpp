#pragma once

// Included before any header of Siconos' simulations. A class of theirs has a uBLAS array of
// pointers, whose constructor asks its allocator for `construct`. C++20 took that out of
// std::allocator, and Boost 1.74 still asks; here is the constructor for this one array.

#include <SiconosFwd.hpp>

#include <boost/numeric/ublas/storage.hpp>
#include <memory>

class NonSmoothLaw;

namespace boost::numeric::ublas {

template <>
inline unbounded_array<std::shared_ptr<NonSmoothLaw>>::unbounded_array(
    size_type size, const std::allocator<std::shared_ptr<NonSmoothLaw>>& allocator)
    : alloc_(allocator), size_(size), data_(size > 0 ? alloc_.allocate(size) : nullptr) {
  std::uninitialized_value_construct_n(data_, size_);
}

}  // namespace boost::numeric::ublas
