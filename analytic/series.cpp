#include "tautline/series.hpp"

#include "instantiate.hpp"
#include "tautline/series_impl.hpp"

namespace tautline {

template class TautSeries<Instance>;

}  // namespace tautline
