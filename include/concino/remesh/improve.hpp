// Improvement of tets: larger dihedral angles, by flips, moves of verts, collapses and new verts.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/remesh/detail/tet_improver.hpp>

#include <limits>

namespace concino {

struct improve_options {
  double min_dihedral_deg = 15;  // tets with a smaller dihedral angle shall become better; below 70.53, that of the
                                 // regular tet
  unsigned max_rounds = 30;      // it ends sooner where a round changes nothing
  bool adds_verts = true;        // whether there may be new verts
  concino::progress progress = {};  // called with "improving"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// Why an improvement has ended.
enum class improvement_end : unsigned char {
  target,      // no dihedral angle is smaller than the target
  boundary,    // the tets at `edge` have equal shares of the dihedral angle between faces that are kept, or there is
               // only one
  no_edit,     // no flip, move, collapse or new vert makes the worst tets better
  max_rounds,  // there may be more to gain
};

template<class M>
struct improvement {
  double least_before = std::numeric_limits<double>::quiet_NaN();  // dihedral angle of the tets, in degrees; negative
                                                                   // if one is inverted
  double least_after = std::numeric_limits<double>::quiet_NaN();
  poly_t<M> poly{};  // that has the least dihedral angle afterwards
  edge_t<M> edge{};  // at which it has this angle
  improvement_end stopped_by = improvement_end::target;
  unsigned num_rounds = 0;
  std::size_t num_flips = 0, num_moves = 0, num_collapses = 0, num_new_verts = 0;
};

namespace detail {

inline void check_improvement(const improve_options& options) {
  if (!(options.min_dihedral_deg > 0 && options.min_dihedral_deg < 70.53))
    core::throw_joined<invalid_argument>({"improve: options.min_dihedral_deg is ",
                                          core::number_text(options.min_dihedral_deg),
                                          "; it must be between 0 and 70.53, the dihedral angle of the regular tet"});
}

/// The dihedral angle of p at e, as tet_quality.
template<class M>
double quality_at_edge(const improvable_tets<M>& tets, const poly_t<M>& p, const edge_t<M>& e) {
  const tet_corners<M> t = tets.corners(p);
  const tet_faces of(tets.at(t.verts[0]), tets.at(t.verts[1]), tets.at(t.verts[2]), tets.at(t.verts[3]));
  const auto ends = end_verts(tets.mesh, e);
  const unsigned a = t.place_of(ends.first), b = t.place_of(ends.second);
  unsigned other[2] = {}, n = 0;
  for (unsigned i = 0; i < 4; ++i)
    if (i != a && i != b && n < 2) other[n++] = i;
  return of.signed_quality(of.between(other[0], other[1]));
}

/// Whether the tets that lie around e between two fixed faces, p among them, all have the same angle there: then none
/// can have a larger one.
template<class M>
bool shares_angle_evenly(const improvable_tets<M>& tets, const poly_t<M>& p, const edge_t<M>& e) {
  const M& m = tets.mesh;
  const double angle = angle_of_quality(quality_at_edge(tets, p, e));
  for (const face_t<M> begin : adj_p2f(m, p)) {
    face_t<M> across = begin;
    poly_t<M> at = p;
    const auto has_edge = [&](const face_t<M>& f) {
      for (const edge_t<M> x : adj_f2e(m, f))
        if (x == e) return true;
      return false;
    };
    if (!has_edge(across)) continue;
    while (!tets.fixed.has(m, across)) {
      for (const poly_t<M> next : adj_f2p(m, across))
        if (next != at) {
          at = next;
          break;
        }
      if (at == p || angle_of_quality(quality_at_edge(tets, at, e)) > angle + 1e-5) return false;
      for (const face_t<M> f : adj_p2f(m, at))
        if (!(f == across) && has_edge(f)) {
          across = f;
          break;
        }
    }
  }
  return true;
}

/// Finds the least dihedral angle. Returns whether the boundary causes it: of equal angles, one of these is named.
template<class M>
bool find_worst_edge(const improvable_tets<M>& tets, improvement<M>& result) {
  const M& m = tets.mesh;
  double least = 2;
  for (const poly_t<M> p : polys(m))
    if (const double q = tets.quality(p); q < least) least = q, result.poly = p;
  result.least_after = angle_of_quality(least);
  const auto is_least = [&](double q) { return angle_of_quality(q) <= result.least_after + 1e-5; };
  bool has_edge = false;
  for (const poly_t<M> p : polys(m)) {
    if (!is_least(tets.quality(p))) continue;
    for (const edge_t<M> e : adj_p2e(m, p)) {
      if (!is_least(quality_at_edge(tets, p, e))) continue;
      const bool is_caused = tets.fixed.has(m, e) && shares_angle_evenly(tets, p, e);
      if (is_caused || !has_edge) result.poly = p, result.edge = e, has_edge = true;
      if (is_caused) return true;
    }
  }
  return false;
}

template<class M, class F>
improvement<M> improve(M& m, const improve_options& input_options, const F& label) {
  const core::profiled_options profiled(input_options, "improve");
  const improve_options& options = *profiled;
  improvement<M> result;
  const unit_points unit(m, "improve");
  if (num_polys(m) == 0) return result;
  improvable_tets<M> tets(m, unit, label);
  const double target = quality_of_angle(options.min_dihedral_deg);
  bool is_boundary = find_worst_edge(tets, result);
  result.least_before = result.least_after;
  tet_improver<M> improver(tets, target);
  bool has_ended = result.least_before >= options.min_dihedral_deg;
  while (!has_ended && result.num_rounds < options.max_rounds) {
    const std::size_t edits = improver.num_edits();
    const auto report = [&](double begin, double done) {
      report_progress(options.progress, (result.num_rounds + begin + 0.5 * done) / options.max_rounds, "improving");
    };
    improver.flip_and_move([&](double done) { report(0, done); });
    const bool is_slow = improver.num_edits() - edits <= num_polys(m) / 1000;
    if (is_slow || result.num_rounds % 3 == 2)
      improver.collapse_and_insert(options.adds_verts, [&](double done) { report(0.5, done); });
    ++result.num_rounds;
    ++tets.round;
    has_ended = improver.num_edits() == edits;
  }
  report_progress(options.progress, 1, "improving");
  is_boundary = find_worst_edge(tets, result);
  result.stopped_by = result.least_after >= options.min_dihedral_deg ? improvement_end::target
                      : is_boundary                                   ? improvement_end::boundary
                      : has_ended                                     ? improvement_end::no_edit
                                                                      : improvement_end::max_rounds;
  result.num_flips = improver.num_flips, result.num_moves = improver.num_moves,
  result.num_collapses = improver.num_collapses, result.num_new_verts = improver.num_new_verts;
  return result;
}

}  // namespace detail

/// Makes the least dihedral angles of tets larger, those of the worst tets first: by flips of faces and of edges with
/// any number of tets, by moves of verts, by collapses and by new verts.
/// Needs:  EditableVolumeMesh of tets. labels: a map of polys, or a function of polys, to anything with ==, such as
///         materials. It is asked again for new polys, so let it be a named property that is copied.
/// Result: the least angle before and after, where it is, and why it did not become larger. Each change makes the worst
///         of the tets that it concerns better, so the least angle never becomes smaller, and no tet is inverted that
///         was not. Faces of the boundary and between labels are kept, with their verts and descriptors; so are the
///         regions of labels. Inverted tets are turned back where a way is found. Named properties follow by their
///         rules; values at verts do not change when verts move. Removed elements leave gaps in the indices, which
///         garbage_collect closes.
/// Cost:   in each round O(polys), and some hundred microseconds for each tet with a small angle near which something
///         has changed.
/// Errors: invalid_argument if min_dihedral_deg is not between 0 and 70.53; invalid_mesh if a point is not finite; m is
///         unchanged then. cancelled, and if memory runs out: m is valid and improved in part; open a transaction to
///         have the input back.
/// Source: Freitag and Ollivier-Gooch 1997, "Tetrahedral mesh improvement using swapping and smoothing"; Klingner and
///         Shewchuk 2008, "Aggressive tetrahedral mesh improvement"; the triangulations of rings: Klincsek 1980,
///         "Minimal triangulations of polygonal domains".
template<EditableVolumeMesh M, class F>
  requires(arity_v<M> == 4)
improvement<M> improve(M& m, const improve_options& options, const F& labels) {
  detail::check_improvement(options);
  return detail::improve(m, options, [&](const poly_t<M>& p) -> decltype(auto) {
    if constexpr (requires { labels[p]; }) return labels[p];  // a map
    else return labels(p);
  });
}
template<EditableVolumeMesh M>
  requires(arity_v<M> == 4)
improvement<M> improve(M& m, const improve_options& options = {}) {
  return improve(m, options, [](const poly_t<M>&) { return 0; });
}

// What to write instead of calls that cannot compile.
template<class... T> void improve(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()

}  // namespace concino
