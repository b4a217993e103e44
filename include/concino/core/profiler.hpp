// profiler: how long named parts of a program take, as a table and as a trace that browsers show.
//
//   cn::profiler p;
//   {
//     const auto s = p.scope("solve");                            // ends with its block; scopes in it are nested
//     auto u = cn::harmonic_map(m, values, {.profiler = &p});     // opens scopes of its own
//   }
//   std::puts(p.report().c_str());
//   p.save_trace("trace.json");                                   // for chrome://tracing or https://ui.perfetto.dev
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/progress.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace concino {

/// A row of a profiler's table: all scopes with one name in one outer scope, on all threads.
struct profile_entry {
  std::string name;
  std::size_t depth = 0;  // how many scopes are around it
  std::size_t calls = 0;  // how many such scopes have ended
  double total = 0;       // seconds in them, a sum over threads
  double own = 0;         // seconds in them, but not in scopes inside of them on the same thread
};

/// Measures scopes: the time from a call of scope() to the end of its result's life, by a clock that never goes back.
/// Needs:  the profiler outlives its scopes. A scope ends on the thread on which it began, and the scopes of a thread
///         end in the reverse order of their begins. Several threads may open scopes at the same time; scopes of one
///         thread are never inside of those of another.
/// Result: entries(), report() and save_trace() contain the scopes that have ended. Without a profiler, functions that
///         take one measure nothing.
/// Cost:   two readings of the clock, two locks and 32 bytes for each scope.
/// Errors: std::bad_alloc; io_error of save_trace.
class profiler {
  struct storage;
  struct running;
  std::unique_ptr<storage> storage_;

  std::uint32_t begin(std::string_view name);
  void end(std::uint32_t running) noexcept;

 public:
  /// A part of the program that is measured until the end of this object's life.
  class [[nodiscard]] scope_timer {
    profiler* profiler_;
    std::uint32_t running_ = 0;

   public:
    /// Measures nothing if there is no profiler.
    scope_timer(profiler* p, std::string_view name) : profiler_(p) {
      if (p) running_ = p->begin(name);
    }
    scope_timer(const scope_timer&) = delete;
    scope_timer& operator=(const scope_timer&) = delete;
    ~scope_timer() {
      if (profiler_) profiler_->end(running_);
    }
  };

  profiler();
  profiler(const profiler&) = delete;
  profiler& operator=(const profiler&) = delete;
  ~profiler();

  scope_timer scope(std::string_view name) { return scope_timer(this, name); }

  /// The entries, each before those inside of it, in the order in which they first began.
  std::vector<profile_entry> entries() const;
  /// A table of the entries: calls, seconds in total, own seconds, and the share of all time.
  std::string report() const;
  /// Every scope with its thread and time, in the JSON of Chrome's trace events.
  std::string trace() const;
  /// Writes trace() to a file, which it replaces.
  void save_trace(const std::string& path) const;
};

namespace core {

/// Opens a scope for a function, and in it one for each label that the function reports as progress.
class progress_scopes {
  profiler* profiler_;
  progress next_;
  std::optional<profiler::scope_timer> all_, step_;
  std::string label_;

 public:
  progress_scopes(profiler* p, const progress& next, const char* name);
  bool operator()(double fraction, const char* label);
};

/// The options of a function that takes progress and a profiler. If there is a profiler, progress opens scopes in it.
/// These options have no profiler, so that functions to which they are passed are steps of this one.
/// Needs:  lives as long as the call; `options` has members progress and profiler.
template<class Options>
class profiled_options {
  progress_scopes scopes_;
  Options options_;

 public:
  profiled_options(const Options& options, const char* name)
      : scopes_(options.profiler, options.progress, name), options_(options) {
    if (options.profiler) options_.progress = scopes_;
    options_.profiler = nullptr;
  }
  profiled_options(const profiled_options&) = delete;
  profiled_options& operator=(const profiled_options&) = delete;

  const Options& operator*() const { return options_; }
  const Options* operator->() const { return &options_; }
};

}  // namespace core

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/core/detail/profiler.ipp>
#endif
