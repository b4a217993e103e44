// What text and binary files of the Common Layer Interface have in common: how contours are closed, and numbers in
// units of the file.
#pragma once

#include <concino/io/slice_layer.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace concino::detail {

/// Moves values into memory of their size. What is left in `from` is room for the next values.
template<class T>
std::vector<T> take_exactly(std::vector<T>& from) {
  std::vector<T> exact;
  exact.reserve(from.size());
  exact.insert(exact.end(), from.begin(), from.end());
  from.clear();
  return exact;
}

/// Adds a layer. It takes the memory of the last one, which keeps no more than it uses: memory grows in the first
/// layers only.
inline void begin_layer(slices& s, double z) {
  slice_layer next;
  next.z = z;
  if (!s.layers.empty()) {
    slice_layer& last = s.layers.back();
    for (slice_lines slice_layer::*const lines :
         {&slice_layer::outer, &slice_layer::inner, &slice_layer::open, &slice_layer::hatches}) {
      slice_lines &to = last.*lines, &from = next.*lines;
      std::swap(to, from);
      to = {take_exactly(from.points), take_exactly(from.ends), take_exactly(from.ids)};
    }
  }
  s.layers.push_back(std::move(next));
}

/// Ends the line of all points after those of the last line; drops the last point of a closed contour that repeats the
/// first one.
/// Result: false if it is a closed contour that does not repeat its first point.
inline bool end_line(slice_lines& lines, std::int32_t id, bool closed) {
  const std::size_t first = lines.ends.empty() ? 0 : lines.ends.back();
  const std::size_t n = lines.points.size() - first;
  const bool repeats = n >= 2 && lines.points.back() == lines.points[first];
  if (closed && repeats) lines.points.pop_back();
  lines.ends.push_back(lines.points.size());
  lines.ids.push_back(id);
  return !closed || repeats || n == 0;
}

/// The number of units that gives x mm when it is read; NaN if no double does.
inline double in_units(double x, double units) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double q = x / units;
  if (!std::isfinite(q)) return std::numeric_limits<double>::quiet_NaN();
  if (q * units == x) return q;
  for (const double d : {-infinity, infinity}) {
    const double next = std::nextafter(q, d);
    if (next * units == x) return next;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace concino::detail
