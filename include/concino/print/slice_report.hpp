// What functions on slices changed or left out: contours by layer and number.
#pragma once

#include <concino/core/compiled.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace concino {

/// The lists of lines in a slice_layer.
enum class slice_lines_kind : std::uint8_t { outer, inner, open, hatches };

enum class contour_change : std::uint8_t {
  dropped,    // it has no area, or as a line no radius
  closed,     // it repeated its first point
  turned,     // it ran in the other direction
  crossing,   // it crosses or touches itself; filled is what it winds around
  left_open   // it is an open line where the mesh is open
};

namespace detail {

/// The layer of a call that takes a single layer: messages do not name it.
inline constexpr std::size_t single_layer = static_cast<std::size_t>(-1);

/// The name of a contour or line in messages and reports.
std::string contour_name(std::size_t layer, slice_lines_kind kind, std::size_t contour);

}  // namespace detail

/// One changed contour or line: its layer, and its number in a list of that layer.
struct contour_note {
  std::size_t layer = 0;
  slice_lines_kind kind = slice_lines_kind::outer;
  std::size_t contour = 0;
  contour_change change = contour_change::dropped;

  /// As a sentence: "layer 3: outer contour 2 was turned".
  std::string text() const;

  friend bool operator==(const contour_note&, const contour_note&) = default;
};

struct slice_report {
  std::vector<contour_note> notes;  // layer by layer

  std::size_t count(contour_change change) const {
    std::size_t n = 0;
    for (const contour_note& x : notes) n += x.change == change;
    return n;
  }
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/print/detail/slices/slice_report.ipp>
#endif
