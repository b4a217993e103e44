// The options of tetrahedralize(), checked; its times; and the tets that miss what was asked for.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/generate/tetrahedralize_options.hpp>
#include <concino/mesh/tetmesh.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>

namespace concino::detail {

/// Reports progress and measures the time of each step.
class tetrahedralize_steps {
  using clock = std::chrono::steady_clock;
  const tetrahedralize_options& options_;
  clock::time_point start_ = clock::now(), checked_ = {}, filled_ = {};

 public:
  /// Errors: invalid_argument if a number among the options is out of its range.
  explicit tetrahedralize_steps(const tetrahedralize_options& options);
  void end_of_check();
  void end_of_back_end();
  void end_of_verification(tetrahedralize_report& report);
};

/// Lists the tets whose shape or volume misses the options by more than rounding errors. `regions`, unless empty, has
/// the region of each poly, if it has one.
void list_poor_tets(const tetmesh& m, std::span<const std::uint32_t> regions, const tetrahedralize_options& options,
                    tetrahedralize_report& report);

/// Sets report.not_met from its lists.
void describe_missed_bounds(std::size_t num_tets, bool is_boundary_kept, tetrahedralize_report& report);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/volumes/tetrahedralize_steps.ipp>
#endif
