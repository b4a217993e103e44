// Progress reporting and cancellation for long operations.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/function_ref.hpp>

#include <string>

namespace concino {

class profiler;  // <concino/core/profiler.hpp>

/// A callback with the fraction done, in [0, 1] and never decreasing within one label, and a label for the current
/// step. It is called now and then. Returning false stops the operation: it throws `cancelled` and leaves its targets
/// as they were. Empty: no progress is reported.
using progress = function_ref<bool(double fraction, const char* label)>;

namespace detail {

inline void report_progress(const progress& p, double fraction, const char* label) {
  if (p && !p(fraction, label)) core::throw_joined<cancelled>({label, ": stopped by the progress callback"});
}

}  // namespace detail

}  // namespace concino
