#include "tautline/detail/series.hpp"

#include "instantiate.hpp"
#include "tautline/detail/series_impl.hpp"

namespace tautline {

template class TautSeries<Instance>;

}  // namespace tautline
