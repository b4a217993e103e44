// Steps of curves that cancel; see cancelling_steps.hpp.
#pragma once

#include <concino/level_sets/detail/lines/cancelling_steps.hpp>

#include <algorithm>
#include <utility>

namespace concino::detail {

CONCINO_INLINE std::vector<cancelling_step> find_cancelling_steps(const std::vector<vert_step>& steps) {
  std::vector<vert_step> all = steps;
  const auto low = [](const vert_step& x) { return std::min(x.from, x.to); };
  const auto high = [](const vert_step& x) { return std::max(x.from, x.to); };
  std::stable_sort(all.begin(), all.end(), [&](const vert_step& a, const vert_step& b) {
    return low(a) != low(b) ? low(a) < low(b) : high(a) != high(b) ? high(a) < high(b) : a.from < b.from;
  });
  std::vector<std::pair<vert_step, vert_step>> pairs;
  for (std::size_t first = 0, last = 0; first < all.size(); first = last) {
    while (last < all.size() && low(all[first]) == low(all[last]) && high(all[first]) == high(all[last])) ++last;
    std::size_t turned = first;
    while (turned < last && all[turned].from == low(all[turned])) ++turned;
    for (std::size_t i = first, j = turned; i < turned && j < last; ++i, ++j) pairs.push_back({all[i], all[j]});
  }
  std::vector<cancelling_step> found;
  for (const auto& [a, b] : pairs) found.insert(found.end(), {{a.curve, a.step, 0}, {b.curve, b.step, 0}});
  const auto before = [](const cancelling_step& a, const cancelling_step& b) {
    return a.curve != b.curve ? a.curve < b.curve : a.step < b.step;
  };
  std::sort(found.begin(), found.end(), before);
  const auto position = [&](const vert_step& x) {
    return static_cast<std::size_t>(
        std::lower_bound(found.begin(), found.end(), cancelling_step{x.curve, x.step, 0}, before) - found.begin());
  };
  for (const auto& [a, b] : pairs) {
    found[position(a)].other = position(b);
    found[position(b)].other = position(a);
  }
  return found;
}

}  // namespace concino::detail
