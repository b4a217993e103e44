// terminal_progress: progress as one line in a terminal, with the rate and the time left.
//
//   auto u = cn::harmonic_map(m, values, {.progress = cn::terminal_progress()});
#pragma once

#include <concino/core/compiled.hpp>

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace concino {

namespace core {

/// The width of the terminal to which errors are written, in characters; 0 if they go elsewhere, as to a file or a
/// pipe, or if the system is not POSIX.
std::size_t terminal_width();

/// The line of terminal_progress, of at most `width` characters: label, bar, fraction, rate and time left.
/// seconds: since the label began, at fraction `begin`.
std::string progress_line(std::string_view label, double fraction, double begin, double seconds, std::size_t width);

}  // namespace core

/// A progress callback that writes to the standard error stream, if that is a terminal. Else it does nothing.
/// Needs:  lives as long as the call whose progress it shows.
/// Result: one line, written anew at most ten times a second, and for each new label: the label, a bar, the fraction
///         done, how much of the work is done in a second, and the time left if that rate stays. The line is removed
///         at the end. It never cancels.
/// Cost:   a reading of the clock for each call.
/// Errors: std::bad_alloc.
class terminal_progress {
  using clock = std::chrono::steady_clock;
  std::size_t width_;
  std::string label_;
  double begin_ = 0;                    // the fraction at which the label began
  clock::time_point start_, last_;      // of the label; of the last line
  bool has_line_ = false;

 public:
  terminal_progress() : width_(core::terminal_width()) {}
  terminal_progress(const terminal_progress&) = delete;
  terminal_progress& operator=(const terminal_progress&) = delete;
  ~terminal_progress();

  bool operator()(double fraction, const char* label);
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/core/detail/terminal.ipp>
#endif
