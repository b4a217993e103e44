// Defines slice_report.hpp.
#pragma once

#include <concino/core/message.hpp>
#include <concino/print/detail/contour_name.hpp>
#include <concino/print/slice_report.hpp>

namespace concino {

CONCINO_INLINE std::string contour_note::text() const {
  const char* what = "was dropped";
  if (change == contour_change::closed) what = "was closed";
  if (change == contour_change::turned) what = "was turned";
  if (change == contour_change::crossing) what = "crosses or touches itself";
  return core::joined({detail::contour_name(layer, kind, contour), " ", what});
}

}  // namespace concino
