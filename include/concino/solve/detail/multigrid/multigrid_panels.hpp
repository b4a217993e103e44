// Cycles of multigrid for the columns of a block of vectors.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/solve/detail/eigen/vector_block.hpp>
#include <concino/solve/detail/multigrid/multigrid_levels.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace concino::detail {

/// Applies cycles of multigrid to many vectors, eight at once, in several threads.
class multigrid_panels {
  struct worker {
    std::vector<double> b, x, y;
    multigrid_levels::workspace work;
  };
  const multigrid_levels& levels_;
  std::vector<worker> workers_;

 public:
  multigrid_panels(const multigrid_levels& levels, Eigen::Index columns)
      : levels_(levels), workers_(std::min(core::num_threads(), static_cast<std::size_t>(num_panels(columns)))) {
    for (worker& w : workers_) {
      w.b.resize(static_cast<std::size_t>(levels.finest().cols() * panel_width));
      w.x.resize(w.b.size());
      w.y.resize(w.b.size());
      w.work = levels.make_workspace(panel_width);
    }
  }

  /// y = T x for the columns of x with these numbers.
  void apply(const column_range& x, const std::vector<Eigen::Index>& column, const column_range& y) {
    const auto panels = static_cast<std::size_t>(num_panels(static_cast<Eigen::Index>(column.size())));
    core::for_each_chunk(workers_.size(), [&](std::size_t k) {
      for (std::size_t panel = k; panel < panels; panel += workers_.size())
        apply_panel(workers_[k], x, column, panel * panel_width, y);
    });
  }

 private:
  void apply_panel(worker& w, const column_range& x, const std::vector<Eigen::Index>& column, std::size_t from,
                   const column_range& y) {
    const auto n = static_cast<int>(levels_.finest().cols());
    const std::size_t width = std::min<std::size_t>(panel_width, column.size() - from);
    for (int i = 0; i < n; ++i)
      for (std::size_t l = 0; l < width; ++l) row_of<panel_width>(w.b.data(), i)[l] = x.row(i)[column[from + l]];
    levels_.cycle<panel_width>(0, w.b.data(), w.x.data(), w.y.data(), w.work);
    for (int i = 0; i < n; ++i)
      for (std::size_t l = 0; l < width; ++l) y.row(i)[from + l] = row_of<panel_width>(w.x.data(), i)[l];
  }
};

}  // namespace concino::detail
