// What can be wrong with the connectivity of a surface, and of the boundary of a volume, which is a surface too.
#pragma once

#include <concino/core/message.hpp>
#include <concino/graph/disjoint_sets.hpp>
#include <concino/validate/detail/rim.hpp>
#include <concino/validate/detail/windings.hpp>

namespace concino::detail {

/// How the checks of a surface S are told about the mesh M: S is M itself, or the boundary of M, whose polys are faces of M.
template<class M, class S>
struct surface_scope {
  static constexpr bool is_boundary = !std::same_as<M, S>;
  const std::vector<std::uint8_t>* told_edges = nullptr;  // by index, not 0: something else has been told of this edge; null: of none

  bool is_told(std::size_t edge_index) const { return told_edges && (*told_edges)[edge_index]; }
  static const char* where() { return is_boundary ? " of the boundary" : ""; }
};

template<class M>
void check_edge_ends(const M& m, const edge_t<M>& e, defect_log<M>& log) {
  std::size_t end[2] = {0, 1};
  int k = 0;
  for (const vert_t<M> v : adj_e2v(m, e))
    if (k < 2) end[k++] = index_of(m, v);
  if (end[0] != end[1]) return;
  if (defect<M>* d = log.add(defect_kind::degenerate_element, e)) d->what = core::joined({log.edge_name(e), " is a loop; the ends of an edge differ"});
}

/// One fan per vert: corners of polygons are joined across edges; the sets left at a vert are its fans.
/// Result: facts of the surface. boundary_loops and components by joining verts, in the same walk.
template<class M, SurfaceMesh S>
mesh_facts check_surface(const S& s, const surface_scope<M, S>& scope, defect_log<M>& log) {
  constexpr bool is_boundary = surface_scope<M, S>::is_boundary;
  struct corner_pair {
    std::uint32_t a, b;  // of the first poly at an edge, at the ends of the edge
  };
  std::size_t corner_count = 0;
  for (const poly_t<S> p : polys(s))
    for ([[maybe_unused]] const vert_t<S> v : adj_p2v(s, p)) ++corner_count;
  log.stage(is_boundary ? 0.55 : 0.3, num_polys(s) + num_edges(s));

  mesh_facts facts;
  disjoint_sets fans(corner_count), pieces(vert_index_bound(s)), loops(vert_index_bound(s));
  std::vector<shared_by> edge_use(edge_index_bound(s));
  std::vector<corner_pair> known(edge_index_bound(s));
  rim_walker<S> rims(s);
  std::uint32_t first = 0;
  for (const poly_t<S> p : polys(s)) {
    log.step();
    const std::size_t poly_index = index_of(s, p);
    std::size_t anchor = ~std::size_t{0};
    const auto rim = rims.walk(
        s, adj_p2v(s, p), adj_p2e(s, p),
        [&](const vert_t<S>&, std::size_t i) {
          if (anchor == ~std::size_t{0}) anchor = i;
          else pieces.unite(anchor, i);
        },
        [&](const edge_t<S>& e, std::uint32_t a, std::uint32_t b, bool forward) {
          const std::size_t i = index_of(s, e);
          if (edge_use[i].polys == 0) known[i] = {first + a, first + b};
          else {
            fans.unite(known[i].a, first + a);
            fans.unite(known[i].b, first + b);
          }
          edge_use[i].add(poly_index, forward);
        });
    if (!is_boundary && rim.is_degenerate())
      if (defect<M>* d = log.add(defect_kind::degenerate_element, p))
        d->what = rim.repeats ? core::joined({log.name(p), " has a vert twice"}) : core::joined({log.name(p), " has ", rim.verts, " verts; a polygon has at least 3"});
    first += rim.verts;
  }

  std::vector<std::uint8_t> on_border(vert_index_bound(s));
  std::size_t used_edges = 0, used_polys = 0;
  for (const edge_t<S> e : edges(s)) {
    log.step();
    const std::size_t i = index_of(s, e);
    const shared_by& use = edge_use[i];
    used_edges += use.polys > 0;
    std::size_t end[2] = {0, 0};
    int k = 0;
    for (const vert_t<S> v : adj_e2v(s, e))
      if (k < 2) end[k++] = index_of(s, v);
    if constexpr (!is_boundary) check_edge_ends(s, e, log);
    if (use.polys == 1) {
      facts.closed = false;
      loops.unite(end[0], end[1]);
      on_border[end[0]] = on_border[end[1]] = 1;
    } else if (use.polys > 2) {
      facts.manifold = false;
      if (scope.is_told(i)) continue;
      if (defect<M>* d = log.add(defect_kind::non_manifold_edge, e)) {
        const std::string list = log.list(*d, adj_e2p(s, e));
        d->what = core::joined({log.edge_name(e), scope.where(), " has ", use.polys, is_boundary ? " faces there (" : " polys (", list,
                          "); a manifold has at most 2"});
      }
    }
  }

  std::vector<std::uint32_t> fans_at(vert_index_bound(s));
  std::size_t corner = 0;
  for (const poly_t<S> p : polys(s)) {
    ++used_polys;
    for (const vert_t<S> v : adj_p2v(s, p)) {
      fans_at[index_of(s, v)] += fans.root(corner) == corner;
      ++corner;
    }
  }
  std::size_t used_verts = 0;
  for (const vert_t<S> v : verts(s)) {
    const std::size_t i = index_of(s, v);
    if (fans_at[i] == 0) {
      if constexpr (!is_boundary)
        if (defect<M>* d = log.add(defect_kind::isolated_vert, v)) d->what = core::joined({log.name(v), " belongs to no poly"});
      continue;
    }
    ++used_verts;
    facts.components += pieces.root(i) == i;
    facts.boundary_loops += on_border[i] && loops.root(i) == i;
    if (fans_at[i] < 2) continue;
    facts.manifold = false;
    if (defect<M>* d = log.add(defect_kind::non_manifold_vert, v)) {
      const std::string list = log.list(*d, adj_v2p(s, v));
      d->what = core::joined({log.name(v), scope.where(), " joins ", core::number_text(fans_at[i]), " fans of ", is_boundary ? "faces (" : "polys (", list,
                        ") that share no edge there; a manifold has one"});
    }
  }
  facts.euler_characteristic = static_cast<std::ptrdiff_t>(used_verts + used_polys) - static_cast<std::ptrdiff_t>(used_edges);

  if constexpr (is_boundary) {
    parity_sets sides(poly_index_bound(s));
    for (const shared_by& use : edge_use)
      if (use.polys == 2 && !sides.join(use.poly[0], use.poly[1], use.clashes())) facts.orientable = false;
  } else {
    facts.orientable = check_windings(
        s, edges(s), [&](const edge_t<S>& e) -> decltype(auto) { return adj_e2p(s, e); }, edge_use, poly_index_bound(s), " run in the same sense along ", log);
  }
  if (facts.manifold && facts.orientable)  // sum over pieces of (2 - loops - chi) / 2
    facts.genus = static_cast<std::size_t>((2 * static_cast<std::ptrdiff_t>(facts.components) - static_cast<std::ptrdiff_t>(facts.boundary_loops) - facts.euler_characteristic) / 2);
  return facts;
}

}  // namespace concino::detail
