// The common part of dual meshes of surfaces and volumes: a vert for each poly, a vert for each facet that needs one,
// and loops around centres.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/facets.hpp>
#include <concino/generate/detail/dual/read_sectors.hpp>
#include <concino/generate/dual_mesh_options.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/circumcentre.hpp>

#include <array>

namespace concino::detail {

/// The verts of a dual mesh and its loops around centres. Centres are the verts of a surface and the edges of a volume.
/// The polys around a centre give a loop of dual verts: a dual polygon, or a face of dual polyhedra.
template<class M>
class dual_parts {
  static constexpr bool is_surface = SurfaceMesh<M>;

 public:
  static constexpr std::uint32_t none = ~0u;

  std::vector<vec3> points;  // of the dual verts: those of polys come first, in the order of polys(m)

  /// For a volume, the last argument is the oriented_edge_table of its faces.
  template<class... OrientedEdges>
  dual_parts(const M& m, bool clipped, dual_points where, const OrientedEdges&... oriented)
      : m_(m), where_(where), polys_at_(facet_index_bound(m), {none, none}), fans_(centre_bound()) {
    read_polys();
    read_sectors(m, [&](const poly_t<M>& p) { return number_of(p); }, fans_, oriented...);
    add_facet_verts(clipped);
  }

  /// The position of poly p in polys(m), which is the number of its dual vert.
  std::uint32_t number_of(const poly_t<M>& p) const { return poly_number_[index_of(m_, p)]; }
  /// The numbers of the polys of a facet, or `none`; whether it has any poly; and whether it has exactly one.
  const std::array<std::uint32_t, 2>& polys_of(std::size_t facet) const { return polys_at_[facet]; }
  bool is_used(std::size_t facet) const { return polys_at_[facet][0] != none; }
  bool is_border(std::size_t facet) const { return is_used(facet) && polys_at_[facet][1] == none; }
  /// Whether a centre has polys around it, and whether it is on the boundary.
  bool has_polys(std::size_t centre) { return !fans_[centre].empty(); }
  bool is_border_centre(std::size_t centre) {
    for (const sector& w : fans_[centre])
      if (is_border(w.in) || is_border(w.out)) return true;
    return false;
  }
  /// The total number of verts of all loops, without the verts of facets and centres.
  std::size_t num_corners() const { return fans_.size(); }

  std::uint32_t add_vert(const vec3& x) {
    points.push_back(x);
    return static_cast<std::uint32_t>(points.size() - 1);
  }
  std::uint32_t facet_vert(std::size_t facet) const { return facet_vert_[facet]; }
  /// By index of the poly or facet; `none` where there is no dual vert.
  const std::vector<std::uint32_t>& vert_of_poly() const { return poly_number_; }
  const std::vector<std::uint32_t>& vert_of_facet() const { return facet_vert_; }

  /// Appends the loop around a centre to `loop`, counter-clockwise. On the boundary it ends with centre_vert, unless
  /// that is `none`.
  /// Errors: invalid_mesh if the polys around the centre are not one fan.
  void add_loop(std::size_t centre, std::uint32_t centre_vert, std::vector<vert_id>& loop) {
    const fan_kind kind = fans_.arrange(centre, [&](std::uint32_t f) { return is_border(f); });
    if (kind == fan_kind::broken)
      throw_no_dual(is_surface ? "the polys around vert " : "the polys around edge ", centre,
                    " do not form a single fan");
    for (const sector& w : fans_[centre]) {
      if (facet_vert_[w.in] != none) loop.push_back(vert_id{facet_vert_[w.in]});
      loop.push_back(vert_id{w.poly});
    }
    if (kind == fan_kind::open) {
      loop.push_back(vert_id{facet_vert_[fans_[centre].back().out]});
      if (centre_vert != none) loop.push_back(vert_id{centre_vert});
    }
  }

 private:
  const M& m_;
  dual_points where_;
  std::vector<std::uint32_t> poly_number_;                   // by index
  core::flat_array<std::array<std::uint32_t, 2>> polys_at_;        // by facet
  std::vector<std::uint32_t> facet_vert_;
  sector_fans fans_;

  std::size_t centre_bound() const {
    if constexpr (is_surface) return vert_index_bound(m_);  // centres are where facets meet: verts of a surface, edges
                                                            // of a volume
    else return edge_index_bound(m_);
  }

  void read_polys() {
    poly_number_.assign(poly_index_bound(m_), none);
    points.reserve(num_polys(m_));
    for (const poly_t<M> p : polys(m_)) {
      const vec3 x = centre_of(p);
      if (!is_finite(x))
        throw_no_dual("poly ", index_of(m_, p),
                      where_ == dual_points::centroids ? " has a vert whose point is not finite"
                                                       : " is flat or not finite: it has no circumcentre");
      const std::uint32_t n = poly_number_[index_of(m_, p)] = add_vert(x);
      for (const facet_t<M> f : adj_p2facet(m_, p)) {
        auto& [first, second] = polys_at_[index_of(m_, f)];
        if (second != none) throw_no_dual(is_surface ? "edge " : "face ", index_of(m_, f), " has more than two polys");
        (first == none ? first : second) = n;
      }
    }
  }

  /// Adds a dual vert for each boundary facet if cells are clipped there. If two polys share more than one facet, each
  /// of these gets a dual vert too: without it dual edges would coincide.
  void add_facet_verts(bool clipped) {
    std::vector<std::uint32_t> seen_from(points.size(), none), seen_through(points.size(), none);
    facet_vert_.assign(facet_index_bound(m_), none);
    constexpr std::uint32_t wanted = 0;
    for (const poly_t<M> p : polys(m_)) {
      const std::uint32_t n = number_of(p);
      for (const facet_t<M> f : adj_p2facet(m_, p)) {
        const std::size_t i = index_of(m_, f);
        const auto [first, second] = polys_at_[i];
        if (second == none) {
          if (clipped) facet_vert_[i] = wanted;
          continue;
        }
        const std::uint32_t other = first == n ? second : first;
        if (seen_from[other] == n) facet_vert_[i] = facet_vert_[seen_through[other]] = wanted;
        seen_from[other] = n;
        seen_through[other] = static_cast<std::uint32_t>(i);
      }
    }
    for (const facet_t<M> f : facets(m_))
      if (std::uint32_t& v = facet_vert_[index_of(m_, f)]; v == wanted) v = add_vert(centre_of(f));
  }

  vec3 centre_of(const poly_t<M>& p) const {
    if (where_ == dual_points::circumcentres) return circumcentre(m_, p);
    return TriMesh<M> || TetMesh<M> ? vert_mean(m_, p) : centroid(m_, p);
  }
  vec3 centre_of(const facet_t<M>& x) const {
    if constexpr (is_surface) {  // an edge has a midpoint; centroid() is for polygons and polyhedra
      const auto [a, b] = end_verts(m_, x);
      return 0.5 * to_vec3(point(m_, a)) + 0.5 * to_vec3(point(m_, b));
    } else {
      return where_ == dual_points::circumcentres ? circumcentre(m_, x) : centroid(m_, x);
    }
  }
};

}  // namespace concino::detail
