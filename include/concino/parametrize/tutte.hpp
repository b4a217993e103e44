// tutte(m): a disk of any polys as a convex polygon of the plane, without flips.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/parametrize/detail/disk_embedding.hpp>
#include <concino/parametrize/detail/read_polys.hpp>

#include <array>
#include <initializer_list>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

struct tutte_options {
  concino::progress progress = nullptr;   // called with "tutte"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// Verts that two others separate from the boundary: the map has them all on the segment between these two.
template<class M>
struct attached_piece {
  std::array<vert_t<M>, 2> at;   // the two verts that separate the piece
  std::vector<vert_t<M>> verts;  // of the piece, without these two
};

template<class M>
struct tutte_result {
  uv_map<M> uv;
  std::vector<attached_piece<M>> attached;  // empty: no poly is flipped, up to rounding
};

namespace detail {

/// Weights of 1, without a map.
struct equal_weights {};

template<class M, class D, class W>
tutte_result<M> tutte_of(const M& m, const D& boundary, const W& weights, const tutte_options& input_options) {
  const core::profiled_options profiled(input_options, "tutte");
  report_progress(profiled->progress, 0, "tutte");
  const auto disk = read_disk(m, "tutte");
  std::vector<double> by_edge;
  if constexpr (!std::is_same_v<W, equal_weights>) {
    by_edge.assign(disk.flat.edges.size(), 0);
    for (const edge_t<M> e : edges(m)) {
      std::array<std::uint32_t, 2> ends{};
      std::size_t k = 0;
      for (const vert_t<M> v : adj_e2v(m, e)) ends[k++ & 1] = disk.number[index_of(m, v)];
      set_edge_weight(disk.flat, ends, static_cast<double>(weights[e]), by_edge);
    }
  }
  const disk_embedding found = embed_disk(disk.flat, disk.positions(m, boundary, "tutte"), by_edge);
  tutte_result<M> result{disk.map_of(m, found.uv), {}};
  for (const auto& piece : found.attached) {
    result.attached.push_back({{disk.verts[piece.at[0]], disk.verts[piece.at[1]]}, {}});
    for (const std::uint32_t v : piece.verts) result.attached.back().verts.push_back(disk.verts[v]);
  }
  report_progress(profiled->progress, 1, "tutte");
  return result;
}

}  // namespace detail

/// The map of a disk to a convex polygon in which each interior vert is the weighted mean of its neighbours. By default
/// the boundary is on the unit circle, at distances in proportion to the lengths of its edges, and weights are equal.
/// Needs:  SurfaceMesh M, Embedded, no temporary, with polys of any number of verts. boundary: pairs of a boundary vert
///         and a point of the plane, in braces or a container: all of them, in convex position and counter-clockwise;
///         they may be on straight lines. Empty: the circle, where the vert that is farthest from the centre of the
///         boundary is at (1, 0). weights: a map with a number above 0 for each edge.
/// Result: `uv`, without flips: polys are convex, if no vert or piece is attached to the rest at two verts only, and
///         none has two edges on one straight line of the boundary. `attached` names the pieces without boundary verts
///         that are, such as verts of two edges, which are on the segment between these two; one may be part of
///         another. Verts of no poly are at the origin. Far from the boundary, polys may become smaller than rounding
///         errors: ask map_distortion for flips.
/// Cost:   one factorisation of a matrix with a row for each interior vert. Pieces: O(corners) if there are none but
///         verts of two edges, else O(corners) for each.
/// Errors: invalid_mesh if the surface is no disk, which says why and what to do; if a point is not finite, or an edge
///         of the boundary has no length where that is needed. invalid_argument if positions are not finite, missing,
///         or in no convex position, a vert has two, or a weight is not positive and finite. solver_error; cancelled.
/// Source: Tutte 1963, "How to draw a graph"; Floater 1997, "Parametrization and smooth approximation of surface
///         triangulations".
template<class M>
  requires detail::can_be_mapped<M>
tutte_result<std::remove_cvref_t<M>> tutte(M&& m, const tutte_options& options = {}) {
  using mesh = std::remove_cvref_t<M>;
  const std::vector<std::pair<vert_t<mesh>, uv_point>> circle;
  return detail::tutte_of<mesh>(m, circle, detail::equal_weights{}, options);
}
template<class M, class D = std::initializer_list<std::pair<vert_t<M>, uv_point>>>
  requires detail::can_be_mapped<M> && detail::gives_positions<D, M>
tutte_result<std::remove_cvref_t<M>> tutte(M&& m, const D& boundary, const tutte_options& options = {}) {
  return detail::tutte_of<std::remove_cvref_t<M>>(m, boundary, detail::equal_weights{}, options);
}
template<class M, class W, class D = std::initializer_list<std::pair<vert_t<M>, uv_point>>>
  requires detail::can_be_mapped<M> && detail::gives_positions<D, M> && requirement::gives_numbers<W, edge_t<M>>
tutte_result<std::remove_cvref_t<M>> tutte(M&& m, const D& boundary, const W& weights,
                                           const tutte_options& options = {}) {
  return detail::tutte_of<std::remove_cvref_t<M>>(m, boundary, weights, options);
}

// What to write instead of calls that cannot compile.
template<class... T> void tutte(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void tutte(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void tutte(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino
