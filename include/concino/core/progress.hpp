// How long work says how far it is, and is asked to stop.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/function_ref.hpp>

#include <string>

namespace concino {

/// Called now and then with the fraction done, in [0, 1] and never falling within one label, and a label of what is being done.
/// Returning false stops the work: it throws `cancelled` and leaves its targets as they were. Empty: nobody is told.
using progress = function_ref<bool(double fraction, const char* label)>;

namespace detail {

inline void report_progress(const progress& p, double fraction, const char* label) {
  if (p && !p(fraction, label)) core::throw_joined<cancelled>({"stopped by the progress callback while ", label});
}

}  // namespace detail

}  // namespace concino
