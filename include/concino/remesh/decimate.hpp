// Decimation: fewer triangles that represent about the same surface.
#pragma once

#include <concino/convert/convert.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/geometry/hausdorff_distance.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/remesh/detail/bounded_collapses.hpp>
#include <concino/remesh/detail/collapse_queue.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace concino {

struct decimate_options {
  std::size_t target_polys = 0;  // the mesh shall have at most this many polys
  double max_error = std::numeric_limits<double>::infinity();  // no point of the result is farther than this from the
                                                               // input, and none of the input from the result; the same
                                                               // holds for their boundaries. In units
                                                               // of the mesh, at least 0
  double feature_angle_deg = 60;  // edges at which the surface turns by more than this are held in place, as boundaries
                                  // are
  double boundary_weight = 10;    // how strongly; 0: not at all
  bool memoryless = false;        // measures each collapse against the surface as it is, not against the input: better
                                  // for smooth surfaces, and slower
  bool measure_error = true;      // computes the error of the result, which takes about as long as the rest
  std::vector<invariant> keep = {no_inversion};  // edits that one of these refuses are not made
  concino::progress progress = {};               // called with "decimating"
  concino::profiler* profiler = nullptr;         // measures the call and its steps
};

/// Why a decimation has ended.
enum class decimation_end : unsigned char {
  target,   // there are no more polys than the target
  refused,  // every edge that is left is refused: by the link condition, an invariant or max_error, or its polys are no
            // triangles
};

struct decimation {
  std::size_t num_collapses = 0;
  double error = std::numeric_limits<double>::quiet_NaN();  // how far the result and the input are apart: an upper
                                                            // bound of hausdorff_distance
  decimation_end stopped_by = decimation_end::target;
  permission last_refusal = {};  // if refused: why the last edge was
};

namespace detail {

inline void check_decimation(const decimate_options& options) {
  const auto fail = [](const char* what) { core::throw_joined<invalid_argument>({"decimate: ", what}); };
  if (options.target_polys == 0 && !(options.max_error < std::numeric_limits<double>::infinity()))
    fail("neither options.target_polys nor options.max_error is given");
  if (!(options.max_error >= 0)) fail("options.max_error is negative or not a number; it must be at least 0");
  if (!(options.feature_angle_deg >= 0))
    fail("options.feature_angle_deg is negative or not a number; it must be at least 0");
  if (!(options.boundary_weight >= 0 && options.boundary_weight < std::numeric_limits<double>::infinity()))
    fail("options.boundary_weight must be finite and at least 0");
}

}  // namespace detail

/// Collapses edges, those first that change the surface least, until m has few enough polys.
/// Needs:  EditableSurfaceMesh; of any topology. Polys that are no triangles stay as they are.
/// Result: the number of collapses, why it ended, and how far the result is from the input. The topology remains: the
///         link condition holds at each collapse. Named properties follow by their rules. Removed elements leave gaps
///         in the indices, which garbage_collect closes.
/// Cost:   O(n log n) for n edges, and one bounding tree of the input and one of the result for the error. With
///         max_error, for each edge that is tried, also the distances between its triangles and those of the input near
///         them.
/// Errors: invalid_argument if an option is out of its range or no target is given; invalid_mesh if a point is not
///         finite; m is unchanged then. cancelled, what an invariant throws, and if memory runs out: m is valid and
///         decimated in part; open a transaction to have the input back.
/// Source: Garland and Heckbert 1997, "Surface simplification using quadric error metrics"; memoryless: Hoppe 1999,
///         "New quadric metric for simplifying meshes with appearance attributes".
template<EditableSurfaceMesh M>
decimation decimate(M& m, const decimate_options& input_options) {
  const core::profiled_options profiled(input_options, "decimate");
  const decimate_options& options = *profiled;
  detail::check_decimation(options);
  detail::collapse_queue<M> queue(m, {options.feature_angle_deg, options.boundary_weight, options.memoryless});
  const bool is_limited = options.max_error < std::numeric_limits<double>::infinity();
  polygonmesh input;
  if (options.measure_error) input = convert<polygonmesh>(m);
  std::optional<detail::bounded_collapses<M>> bound;
  edge_collapse_options collapse{options.keep};
  collapse.only_simplices = true;
  if (is_limited) {
    bound.emplace(m, options.max_error, "decimate");
    collapse.keep.push_back([&bound](const proposed_edit& e) { return bound->ask(e); });
  }
  decimation result;
  const std::size_t before = num_polys(m);
  const auto fraction = [&] {
    return before > options.target_polys
               ? static_cast<double>(before - num_polys(m)) / static_cast<double>(before - options.target_polys)
               : 1;
  };
  while (num_polys(m) > options.target_polys) {
    if (result.num_collapses % 1024 == 0)
      detail::report_progress(options.progress, std::min(fraction(), 1.0), "decimating");
    const permission p = queue.collapse_next(m, collapse);
    if (!p) {
      result.stopped_by = decimation_end::refused;
      result.last_refusal = p;
      break;
    }
    if (bound) bound->accept();
    ++result.num_collapses;
  }
  detail::report_progress(options.progress, 1, "decimating");
  if (options.measure_error) result.error = std::min(hausdorff_distance(input, m).upper, options.max_error);
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void decimate(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()

}  // namespace concino
