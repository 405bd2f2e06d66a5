#pragma once

namespace tautline::bench {

/// The JSON array of what `make` makes, as JSON, of each of `values`.
template <class Values, class Make>
auto json_list(const Values& values, Make make) {
  auto list = decltype(make(*values.begin()))::array();
  for (const auto& value : values) {
    list.push_back(make(value));
  }
  return list;
}

}  // namespace tautline::bench
