// Defines slice_report.hpp.
#pragma once

#include <concino/core/message.hpp>
#include <concino/print/slice_report.hpp>

namespace concino::detail {

CONCINO_INLINE std::string contour_name(std::size_t layer, slice_lines_kind kind, std::size_t contour) {
  const char* what = "outer contour ";
  if (kind == slice_lines_kind::inner) what = "inner contour ";
  if (kind == slice_lines_kind::open) what = "open line ";
  if (kind == slice_lines_kind::hatches) what = "group of hatches ";
  if (layer == single_layer) return core::joined({what, contour});
  return core::joined({"layer ", layer, ": ", what, contour});
}

}  // namespace concino::detail

namespace concino {

CONCINO_INLINE std::string contour_note::text() const {
  const char* what = "was dropped";
  if (change == contour_change::closed) what = "was closed";
  if (change == contour_change::turned) what = "was turned";
  if (change == contour_change::crossing) what = "crosses or touches itself";
  if (change == contour_change::left_open) what = "is open";
  return core::joined({detail::contour_name(layer, kind, contour), " ", what});
}

}  // namespace concino
