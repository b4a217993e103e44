// Checks of the connectivity of a surface, and of the boundary of a volume, which is a surface too.
#pragma once

#include <concino/core/message.hpp>
#include <concino/graph/disjoint_sets.hpp>
#include <concino/validate/detail/oriented_edge_walker.hpp>
#include <concino/validate/detail/windings.hpp>

namespace concino::detail {

/// How defects of a surface S are reported for the mesh M. S is M itself, or the boundary of M, whose polys are faces
/// of M.
template<class M, class S>
struct surface_scope {
  static constexpr bool is_boundary = !std::same_as<M, S>;
  const std::vector<std::uint8_t>* reported_edges = nullptr;  // by edge index, not 0: another defect was reported for
                                                              // this edge; null: for none

  bool is_reported(std::size_t edge_index) const { return reported_edges && (*reported_edges)[edge_index]; }
  static const char* where() { return is_boundary ? " of the boundary" : ""; }
};

template<class M>
void check_edge_ends(const M& m, const edge_t<M>& e, defect_log<M>& log) {
  std::size_t end[2] = {0, 1};
  int k = 0;
  for (const vert_t<M> v : adj_e2v(m, e))
    if (k < 2) end[k++] = index_of(m, v);
  if (end[0] != end[1]) return;
  if (defect<M>* d = log.add(defect_kind::degenerate_element, e))
    d->what = core::joined({log.edge_name(e), " is a loop; the ends of an edge differ"});
}

/// Checks one surface. Corners of polygons are united through common edges; the sets at a vert are its fans, and a
/// manifold has one per vert.
template<class M, SurfaceMesh S>
class surface_checker {
  static constexpr bool is_boundary = surface_scope<M, S>::is_boundary;
  /// The corners of the first poly at an edge, at the two ends of the edge.
  struct corner_pair {
    std::uint32_t a, b;
  };

  const S& s_;
  const surface_scope<M, S>& scope_;
  defect_log<M>& log_;
  disjoint_sets fans_;    // of corners, numbered in the order of polys
  disjoint_sets pieces_;  // of verts connected by polys
  disjoint_sets loops_;   // of verts connected by border edges
  std::vector<shared_by> edge_use_;
  std::vector<std::uint8_t> on_border_;  // by vert index
  mesh_facts facts_;

  static std::size_t count_corners(const S& s) {
    std::size_t count = 0;
    for (const poly_t<S> p : polys(s))
      for ([[maybe_unused]] const vert_t<S> v : adj_p2v(s, p)) ++count;
    return count;
  }

  /// Visits each poly once: unites its corners with those of the first poly at each edge, and its verts into one
  /// component.
  void join_polys() {
    std::vector<corner_pair> first_corners(edge_index_bound(s_));
    oriented_edge_walker<S> edge_walker(s_);
    std::uint32_t first = 0;
    for (const poly_t<S> p : polys(s_)) {
      log_.step();
      const std::size_t poly_index = index_of(s_, p);
      std::size_t anchor = ~std::size_t{0};
      const auto cycle = edge_walker.walk(
          s_, adj_p2v(s_, p), adj_p2e(s_, p),
          [&](const vert_t<S>&, std::size_t i) {
            if (anchor == ~std::size_t{0}) anchor = i;
            else pieces_.unite(anchor, i);
          },
          [&](const edge_t<S>& e, std::uint32_t a, std::uint32_t b, bool forward) {
            const std::size_t i = index_of(s_, e);
            if (edge_use_[i].polys == 0) first_corners[i] = {first + a, first + b};
            else {
              fans_.unite(first_corners[i].a, first + a);
              fans_.unite(first_corners[i].b, first + b);
            }
            edge_use_[i].add(poly_index, forward);
          });
      if constexpr (!is_boundary)
        if (cycle.is_degenerate()) add_degenerate_poly(p, cycle);
      first += cycle.verts;
    }
  }

  void add_degenerate_poly(const poly_t<S>& p, const typename oriented_edge_walker<S>::summary& cycle) {
    if (defect<M>* d = log_.add(defect_kind::degenerate_element, p))
      d->what = cycle.repeats ? core::joined({log_.name(p), " has a vert twice"})
                              : core::joined({log_.name(p), " has ", cycle.verts, " verts; a polygon has at least 3"});
  }

  /// Finds the border, and edges of more than two polys.
  void check_edges() {
    for (const edge_t<S> e : edges(s_)) {
      log_.step();
      const std::size_t i = index_of(s_, e);
      const std::uint32_t poly_count = edge_use_[i].polys;
      facts_.euler_characteristic -= poly_count > 0;
      if constexpr (!is_boundary) check_edge_ends(s_, e, log_);
      if (poly_count == 1) add_to_border(e);
      else if (poly_count > 2) {
        facts_.manifold = false;
        if (!scope_.is_reported(i)) add_non_manifold_edge(e, poly_count);
      }
    }
  }

  void add_to_border(const edge_t<S>& e) {
    std::size_t end[2] = {0, 0};
    int k = 0;
    for (const vert_t<S> v : adj_e2v(s_, e))
      if (k < 2) end[k++] = index_of(s_, v);
    facts_.closed = false;
    loops_.unite(end[0], end[1]);
    on_border_[end[0]] = on_border_[end[1]] = 1;
  }

  void add_non_manifold_edge(const edge_t<S>& e, std::uint32_t poly_count) {
    if (defect<M>* d = log_.add(defect_kind::non_manifold_edge, e)) {
      const std::string list = log_.list(*d, adj_e2p(s_, e));
      d->what = core::joined({log_.edge_name(e), scope_.where(), " has ", poly_count,
                              is_boundary ? " faces there (" : " polys (", list, "); a manifold has at most 2"});
    }
  }

  /// Result: the number of fans by vert index, 0 at verts without polys.
  std::vector<std::uint32_t> count_fans() {
    std::vector<std::uint32_t> fans_at(vert_index_bound(s_));
    std::size_t corner = 0;
    for (const poly_t<S> p : polys(s_)) {
      ++facts_.euler_characteristic;
      for (const vert_t<S> v : adj_p2v(s_, p)) {
        fans_at[index_of(s_, v)] += fans_.root(corner) == corner;
        ++corner;
      }
    }
    return fans_at;
  }

  /// Counts components and border loops by their roots, and finds verts without a fan or with several.
  void check_verts() {
    const std::vector<std::uint32_t> fans_at = count_fans();
    for (const vert_t<S> v : verts(s_)) {
      const std::size_t i = index_of(s_, v);
      if (fans_at[i] == 0) {
        if constexpr (!is_boundary)
          if (defect<M>* d = log_.add(defect_kind::isolated_vert, v))
            d->what = core::joined({log_.name(v), " belongs to no poly"});
        continue;
      }
      ++facts_.euler_characteristic;
      facts_.components += pieces_.root(i) == i;
      facts_.boundary_loops += on_border_[i] && loops_.root(i) == i;
      if (fans_at[i] < 2) continue;
      facts_.manifold = false;
      add_non_manifold_vert(v, fans_at[i]);
    }
  }

  void add_non_manifold_vert(const vert_t<S>& v, std::uint32_t fan_count) {
    if (defect<M>* d = log_.add(defect_kind::non_manifold_vert, v)) {
      const std::string list = log_.list(*d, adj_v2p(s_, v));
      d->what =
          core::joined({log_.name(v), scope_.where(), " joins ", core::number_text(fan_count), " fans of ",
                        is_boundary ? "faces (" : "polys (", list, ") that share no edge there; a manifold has one"});
    }
  }

  /// Checks orientability. Reports inconsistent windings of a surface; those of the boundary of a volume are reported
  /// at its faces.
  bool check_orientability() {
    if constexpr (is_boundary) {
      bool orientable = true;
      parity_sets orientation(poly_index_bound(s_));
      for (const shared_by& use : edge_use_)
        if (use.polys == 2 && !orientation.join(use.poly[0], use.poly[1], use.clashes())) orientable = false;
      return orientable;
    } else {
      return check_windings(
          s_, edges(s_), [&](const edge_t<S>& e) -> decltype(auto) { return adj_e2p(s_, e); }, edge_use_,
          poly_index_bound(s_), " run in the same sense along ", log_);
    }
  }

  /// The sum over components of (2 - loops - chi) / 2.
  std::size_t genus() const {
    return static_cast<std::size_t>((2 * static_cast<std::ptrdiff_t>(facts_.components) -
                                     static_cast<std::ptrdiff_t>(facts_.boundary_loops) - facts_.euler_characteristic) /
                                    2);
  }

 public:
  surface_checker(const S& s, const surface_scope<M, S>& scope, defect_log<M>& log)
      : s_(s), scope_(scope), log_(log), fans_(count_corners(s)), pieces_(vert_index_bound(s)),
        loops_(vert_index_bound(s)), edge_use_(edge_index_bound(s)), on_border_(vert_index_bound(s)) {}

  mesh_facts check() {
    log_.begin_stage(is_boundary ? 0.55 : 0.3, num_polys(s_) + num_edges(s_));
    join_polys();
    check_edges();
    check_verts();
    facts_.orientable = check_orientability();
    if (facts_.manifold && facts_.orientable) facts_.genus = genus();
    return facts_;
  }
};

/// Result: the facts about the surface.
template<class M, SurfaceMesh S>
mesh_facts check_surface(const S& s, const surface_scope<M, S>& scope, defect_log<M>& log) {
  return surface_checker<M, S>(s, scope, log).check();
}

}  // namespace concino::detail
