// Isotropic remeshing: triangles of about equal edges for the same surface.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/convert/convert.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/geometry/hausdorff_distance.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/remesh/detail/remesher.hpp>

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

struct remesh_options {
  double edge_length = 0;         // the length that edges shall have; unless sizes are given
  double feature_angle_deg = 40;  // edges at which the surface turns by more than this are kept, as are boundaries and
                                  // non-manifold edges
  unsigned max_rounds = 10;       // it ends sooner where a round changes hardly anything
  bool measure_error = true;      // computes the error of the result
  concino::progress progress = {};  // called with "remeshing"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

struct remeshing {
  unsigned num_rounds = 0;
  std::size_t num_splits = 0, num_collapses = 0, num_flips = 0;
  double share_of_lengths = 1;  // of the edges off feature lines, the part whose lengths are within a factor of 4/3 of
                                // what they shall be
  double error = std::numeric_limits<double>::quiet_NaN();  // how far the result and the input are apart: an upper
                                                            // bound of hausdorff_distance
};

namespace detail {

inline void check_remeshing(const remesh_options& options, bool has_sizes) {
  const auto fail = [](const char* what) { core::throw_joined<invalid_argument>({"remesh: ", what}); };
  if (has_sizes && options.edge_length != 0) fail("both sizes and options.edge_length are given");
  if (!has_sizes && !(options.edge_length > 0 && std::isfinite(options.edge_length)))
    fail("options.edge_length must be finite and above 0");
  if (!(options.feature_angle_deg >= 0))
    fail("options.feature_angle_deg is negative or not a number; it must be at least 0");
}

/// The sizes of the verts of m, in their order.
template<class M, class S>
std::vector<double> checked_sizes(const M& m, const S& sizes) {
  std::vector<double> all;
  all.reserve(num_verts(m));
  for (const vert_t<M> v : verts(m)) {
    const double x = sizes[v];
    if (!(x > 0 && std::isfinite(x)))
      core::throw_joined<invalid_argument>({"remesh: the size of vert ", index_of(m, v), " is not finite and above 0"});
    all.push_back(x);
  }
  return all;
}

/// sizes: of the verts of m, in their order; none if all edges shall have the length of the options.
template<class M, class F>
remeshing remesh(M& m, std::vector<double> sizes, const remesh_options& input_options, const F& is_feature) {
  const core::profiled_options profiled(input_options, "remesh");
  const remesh_options& options = *profiled;
  remeshing result;
  const unit_points unit(m, "remesh");
  if (num_polys(m) == 0) return result;
  const polygonmesh before = options.measure_error ? convert<polygonmesh>(m) : polygonmesh();
  const surface_sizes input(m, unit, std::move(sizes), options.edge_length);
  remesher<M> r(m, unit, input, is_feature);
  if (!(r.num_wanted() < 2e9))
    core::throw_joined<invalid_argument>(
        {"remesh: these lengths ask for more than 2,000,000,000 triangles; meshes cannot have so many"});
  r.begin(unit, options.feature_angle_deg);
  const auto report = [&](unsigned part) {
    report_progress(options.progress, (result.num_rounds + 0.25 * part) / options.max_rounds, "remeshing");
  };
  while (result.num_rounds < options.max_rounds) {
    const std::size_t edits = r.num_splits + r.num_collapses + r.num_flips;
    report(0), r.split_long_edges();
    report(1), r.collapse_short_edges();
    report(2), r.flip_edges();
    report(3), r.move_verts();
    ++result.num_rounds;
    const std::size_t changes = r.num_splits + r.num_collapses + r.num_flips - edits;
    if (r.allows_longer || r.share_of_lengths() >= 0.9) {
      if (changes <= num_edges(m) / 500) break;
    } else {
      r.allows_longer = changes <= num_edges(m) / 20;
    }
  }
  report_progress(options.progress, 1, "remeshing");
  result.num_splits = r.num_splits, result.num_collapses = r.num_collapses, result.num_flips = r.num_flips;
  result.share_of_lengths = r.share_of_lengths();
  if (options.measure_error) result.error = hausdorff_distance(before, m).upper;
  return result;
}

}  // namespace detail

/// Replaces the triangles of m by others whose edges have about the wanted lengths: options.edge_length, or near each
/// vert v of m sizes[v].
/// Needs:  EditableSurfaceMesh; of any topology. Polys that are no triangles stay as they are. sizes: a map of lengths,
///         such as that of adaptive_size; it is read before m changes. is_feature(e) names edges to keep besides
///         boundaries, non-manifold edges and those sharper than the angle.
/// Result: the numbers of edits and how good the lengths are. The topology remains. Feature lines are kept: their verts
///         lie on those of the input, their sharp bends and ends stay. Other verts lie on the input. No change turns a
///         triangle by more than 60 degrees, or moves it away from the input by more than 0.3 times its size, as
///         measured at its centre and the middles of its edges. Triangles that are flatter than a thousandth of their
///         size vanish first, unless this would change the topology or move a line. Named properties follow by their
///         rules. Removed elements leave gaps in the indices, which garbage_collect closes.
/// Cost:   in each round, a few edits for each edge that is too long or too short, and a closest point of the input for
///         each vert, in parallel. Splits make as many triangles as the lengths ask for: about 2.3 times the area
///         divided by the square of the length.
/// Errors: invalid_argument if an option or a size is out of its range, both are given, or the lengths ask for more
///         than 2e9 triangles; invalid_mesh if a point is not finite; m is unchanged then. cancelled, and if memory
///         runs out: m is valid and remeshed in part; open a transaction to have the input back.
/// Source: Botsch and Kobbelt 2004, "A remeshing approach to multiresolution modeling"; sizes: Dunyach, Vanderhaeghe,
///         Barthe, Botsch 2013, "Adaptive remeshing for real-time mesh deformation".
template<EditableSurfaceMesh M, class F>
  requires std::is_invocable_r_v<bool, const F&, edge_t<M>>
remeshing remesh(M& m, const remesh_options& options, const F& is_feature) {
  detail::check_remeshing(options, false);
  return detail::remesh(m, {}, options, is_feature);
}
template<EditableSurfaceMesh M>
remeshing remesh(M& m, const remesh_options& options) {
  return remesh(m, options, [](const edge_t<M>&) { return false; });
}
template<EditableSurfaceMesh M, ReadableMap<vert_t<M>> S, class F>
  requires std::is_invocable_r_v<bool, const F&, edge_t<M>>
remeshing remesh(M& m, const S& sizes, const remesh_options& options, const F& is_feature) {
  detail::check_remeshing(options, true);
  return detail::remesh(m, detail::checked_sizes(m, sizes), options, is_feature);
}
template<EditableSurfaceMesh M, ReadableMap<vert_t<M>> S>
remeshing remesh(M& m, const S& sizes, const remesh_options& options = {}) {
  return remesh(m, sizes, options, [](const edge_t<M>&) { return false; });
}

// What to write instead of calls that cannot compile.
template<class... T> void remesh(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()

}  // namespace concino
