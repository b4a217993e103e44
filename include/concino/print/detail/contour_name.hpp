// The name of a contour in messages and reports.
#pragma once

#include <concino/core/message.hpp>
#include <concino/print/slice_report.hpp>

namespace concino::detail {

/// The layer of a call that takes a single layer: messages do not name it.
inline constexpr std::size_t single_layer = static_cast<std::size_t>(-1);

inline std::string contour_name(std::size_t layer, slice_lines_kind kind, std::size_t contour) {
  const char* what = "outer contour ";
  if (kind == slice_lines_kind::inner) what = "inner contour ";
  if (kind == slice_lines_kind::open) what = "open line ";
  if (kind == slice_lines_kind::hatches) what = "group of hatches ";
  if (layer == single_layer) return core::joined({what, contour});
  return core::joined({"layer ", layer, ": ", what, contour});
}

}  // namespace concino::detail
