// What the dual of a surface and that of a volume are made of alike: a vert for each poly, one for each facet that needs it, and loops around hubs.
#pragma once

#include <concino/error.hpp>
#include <concino/generate/detail/wedge_fans.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/graph/detail/sides.hpp>

#include <array>

namespace concino::detail {

/// The centre of mass of a polygon, seen along its vector area; the mean of its verts where it has no area.
template<class M, class Loop>
vec3 loop_centroid(const M& m, const Loop& loop) {
  const polygon_shape s = shape_of(m, loop);
  moments sum;
  for_each_fan_side(m, loop, [&](const vec3& a, const vec3& b) {
    sum.add(dot(cross(a - s.mean, b - s.mean), s.area), ((a - s.mean) + (b - s.mean)) / 3);
  });
  return std::abs(sum.total) > 1e-12 * sum.size ? s.mean + sum.first / sum.total : s.mean;
}

/// Facets are the edges of a surface and the faces of a volume; hubs are the verts of a surface and the edges of a volume. The polys around a hub give a
/// loop of dual verts: a dual polygon, or a face of dual polyhedra.
template<class M>
class dual_parts {
 public:
  static constexpr std::uint32_t none = ~0u;

  std::vector<vec3> points;  // of dual verts: those of polys come first, in the order of polys(m)

  dual_parts(const M& m, bool clipped)
      : m_(m), clipped_(clipped), polys_at_(facet_bound()), facet_vert_(facet_bound(), none), hub_vert_(hub_bound(), none), fans_(hub_bound()) {
    read_polys();
    read_wedges();
    add_facet_verts();
  }

  /// Whether a facet has one poly only.
  bool is_border(std::uint32_t facet) const { return polys_at_[facet].count == 1; }
  bool is_used(std::uint32_t facet) const { return polys_at_[facet].count > 0; }
  /// Whether a hub has polys around it.
  bool has_polys(std::size_t hub) { return !fans_[hub].empty(); }
  bool is_border_hub(std::size_t hub) {
    for (const wedge& w : fans_[hub])
      if (is_border(w.in) || is_border(w.out)) return true;
    return false;
  }
  std::uint32_t facet_vert(std::size_t facet) const { return facet_vert_[facet]; }
  std::uint32_t hub_vert(std::size_t hub) const { return hub_vert_[hub]; }
  void add_hub_vert(std::size_t hub, const vec3& x) { hub_vert_[hub] = add_vert(x); }
  std::uint32_t add_vert(const vec3& x) {
    points.push_back(x);
    return static_cast<std::uint32_t>(points.size() - 1);
  }
  /// The polys of a facet by number, the second `none` at the border.
  std::array<std::uint32_t, 2> polys_of(std::uint32_t facet) const { return polys_at_[facet].poly; }
  /// Whether the first poly of a face sees it run counter-clockwise from outside.
  bool is_outward(std::uint32_t facet) const { return polys_at_[facet].outward; }
  std::uint32_t number_of(const poly_t<M>& p) const { return poly_number_[index_of(m_, p)]; }

  /// Adds the loop around a hub to `loop`, counter-clockwise. At the border it ends with the vert of the hub.
  /// Errors: invalid_mesh if the polys are no fan.
  void add_loop(std::size_t hub, std::vector<vert_id>& loop) {
    const fan_kind kind = fans_.arrange(hub, [&](std::uint32_t f) { return is_border(f); });
    if (kind == fan_kind::broken) refuse(dimension_v<M> == 2 ? "the polys around vert " : "the polys around edge ", hub, " are no single fan");
    for (const wedge& w : fans_[hub]) {
      if (facet_vert_[w.in] != none) loop.push_back(vert_id{facet_vert_[w.in]});
      loop.push_back(vert_id{w.poly});
    }
    if (kind == fan_kind::open) {
      loop.push_back(vert_id{facet_vert_[fans_[hub].back().out]});
      loop.push_back(vert_id{hub_vert_[hub]});
    }
  }

  template<class... Pieces>
  [[noreturn]] static void refuse(const Pieces&... pieces) {
    throw_joined<invalid_mesh>({"dual_mesh: ", pieces..., "; validate() lists what is wrong with the mesh"});
  }

  /// The sides of a face, by index: it runs from `from` along `edge`.
  struct face_side {
    std::uint32_t from, edge;
    bool forward;  // from the first end of the edge to the second
  };
  std::span<const face_side> sides(std::size_t face) const { return {sides_.data() + first_side_[face], sides_.data() + first_side_[face + 1]}; }
  std::uint32_t second_end(std::size_t edge) const { return second_end_[edge]; }

 private:
  struct facet_polys {
    std::array<std::uint32_t, 2> poly{none, none};
    std::uint8_t count = 0;
    bool outward = true;  // for the first
  };

  const M& m_;
  bool clipped_;
  std::vector<std::uint32_t> poly_number_;
  std::vector<facet_polys> polys_at_;
  std::vector<std::uint32_t> facet_vert_, hub_vert_;
  wedge_fans fans_;
  std::vector<face_side> sides_;            // volumes: of all faces, one after another
  std::vector<std::uint32_t> first_side_;   // by face
  std::vector<std::uint32_t> second_end_;   // by edge

  std::size_t facet_bound() const {
    if constexpr (SurfaceMesh<M>) return edge_index_bound(m_);
    else return face_index_bound(m_);
  }
  std::size_t hub_bound() const {
    if constexpr (SurfaceMesh<M>) return vert_index_bound(m_);
    else return edge_index_bound(m_);
  }
  decltype(auto) facets_of(const poly_t<M>& p) const {
    if constexpr (SurfaceMesh<M>) return adj_p2e(m_, p);
    else return adj_p2f(m_, p);
  }

  void read_polys() {
    poly_number_.assign(poly_index_bound(m_), none);
    points.reserve(num_polys(m_));
    for (const poly_t<M> p : polys(m_)) {
      if constexpr (arity_v<M> == 3 || (VolumeMesh<M> && arity_v<M> == 4)) points.push_back(vert_mean(m_, p));
      else points.push_back(centroid(m_, p));
      const auto n = static_cast<std::uint32_t>(points.size() - 1);
      if (!is_finite(points.back())) refuse("poly ", index_of(m_, p), " has a vert that is not at a finite point");
      poly_number_[index_of(m_, p)] = n;
      for (const auto f : facets_of(p)) {
        facet_polys& at = polys_at_[index_of(m_, f)];
        if (at.count == 2) refuse(dimension_v<M> == 2 ? "edge " : "face ", index_of(m_, f), " has more than two polys");
        if constexpr (VolumeMesh<M>)
          if (at.count == 0) at.outward = face_is_outward(m_, p, f);
        at.poly[at.count++] = n;
      }
    }
  }

  /// Facets at the border have a dual vert of their own, and so have all facets that two polys share if they share more than one: without them dual edges
  /// would coincide.
  void add_facet_verts() {
    std::vector<std::uint32_t> seen_from(points.size(), none), seen_through(points.size(), none);
    std::vector<unsigned char> wanted(facet_bound());
    for (const poly_t<M> p : polys(m_)) {
      const std::uint32_t n = number_of(p);
      for (const auto f : facets_of(p)) {
        const std::size_t i = index_of(m_, f);
        const facet_polys& at = polys_at_[i];
        if (at.count == 1) wanted[i] = clipped_;
        if (at.count < 2) continue;
        const std::uint32_t other = at.poly[0] == n ? at.poly[1] : at.poly[0];
        if (seen_from[other] == n) wanted[i] = wanted[seen_through[other]] = 1;
        seen_from[other] = n;
        seen_through[other] = static_cast<std::uint32_t>(i);
      }
    }
    const auto add = [&](const auto& all, const auto& centre) {
      for (const auto f : all)
        if (wanted[index_of(m_, f)]) facet_vert_[index_of(m_, f)] = add_vert(centre(f));
    };
    if constexpr (SurfaceMesh<M>) {
      add(edges(m_), [&](const edge_t<M>& e) {
        vec3 sum;
        for (const vert_t<M> v : adj_e2v(m_, e)) sum += 0.5 * to_vec3(point(m_, v));
        return sum;
      });
    } else {
      add(faces(m_), [&](const face_t<M>& f) { return loop_centroid(m_, adj_f2v(m_, f)); });
    }
  }

  void read_wedges()
    requires SurfaceMesh<M>
  {
    for (const poly_t<M> p : polys(m_))
      for (const vert_t<M> v : adj_p2v(m_, p)) fans_.count(index_of(m_, v));
    fans_.end_counting();
    side_walker<M> walker(m_);
    for (const poly_t<M> p : polys(m_)) {
      walker.read(p);
      const std::uint32_t n = number_of(p);
      walker.for_each_side(p, [&](const edge_t<M>& e, std::size_t i, std::size_t j) {
        const auto facet = static_cast<std::uint32_t>(index_of(m_, e));
        fans_.at(index_of(m_, walker.ring()[i]), n).in = facet;
        fans_.at(index_of(m_, walker.ring()[j]), n).out = facet;
      });
    }
  }

  void read_wedges()
    requires VolumeMesh<M>
  {
    read_sides();
    for (const poly_t<M> p : polys(m_))
      for (const edge_t<M> e : adj_p2e(m_, p)) fans_.count(index_of(m_, e));
    fans_.end_counting();
    for (const poly_t<M> p : polys(m_)) {
      const std::uint32_t n = number_of(p);
      for (const face_t<M> f : adj_p2f(m_, p)) {
        const auto facet = static_cast<std::uint32_t>(index_of(m_, f));
        const bool outward = polys_at_[facet].poly[0] == n ? polys_at_[facet].outward : face_is_outward(m_, p, f);
        for (const face_side& s : sides(facet)) {
          wedge& w = fans_.at(s.edge, n);
          std::uint32_t& side = s.forward == outward ? w.out : w.in;  // the face that runs along the edge is the one after it
          if (side != none) refuse("poly ", index_of(m_, p), " has more than two faces at edge ", std::size_t{s.edge});
          side = facet;
        }
      }
      for (const edge_t<M> e : adj_p2e(m_, p))
        if (const wedge& w = fans_.at(index_of(m_, e), n); w.in == none || w.out == none)
          refuse("poly ", index_of(m_, p), " is not closed at edge ", index_of(m_, e));
    }
  }

  void read_sides() {
    second_end_.assign(edge_index_bound(m_), none);
    std::vector<std::uint32_t> first_end(edge_index_bound(m_), none);
    for (const edge_t<M> e : edges(m_))
      for (const vert_t<M> v : adj_e2v(m_, e)) (first_end[index_of(m_, e)] == none ? first_end : second_end_)[index_of(m_, e)] = static_cast<std::uint32_t>(index_of(m_, v));
    first_side_.assign(face_index_bound(m_) + 1, 0);
    for (const face_t<M> f : faces(m_))
      for ([[maybe_unused]] const vert_t<M> v : adj_f2v(m_, f)) ++first_side_[index_of(m_, f) + 1];
    for (std::size_t i = 1; i < first_side_.size(); ++i) first_side_[i] += first_side_[i - 1];
    sides_.resize(first_side_.back());
    std::vector<std::uint32_t> place(vert_index_bound(m_));  // of a vert in the face at hand
    for (const face_t<M> f : faces(m_)) {
      face_side* const side = sides_.data() + first_side_[index_of(m_, f)];
      std::uint32_t n = 0;
      for (const vert_t<M> v : adj_f2v(m_, f)) {
        side[n].from = static_cast<std::uint32_t>(index_of(m_, v));
        place[index_of(m_, v)] = n++;
      }
      for (const edge_t<M> e : adj_f2e(m_, f)) {
        const std::size_t i = index_of(m_, e);
        const std::uint32_t a = place[first_end[i]], b = place[second_end_[i]];
        const bool forward = (a + 1) % n == b;
        side[forward ? a : b].edge = static_cast<std::uint32_t>(i);
        side[forward ? a : b].forward = forward;
      }
    }
  }
};

}  // namespace concino::detail
