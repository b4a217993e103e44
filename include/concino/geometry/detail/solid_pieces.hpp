// The polys of a volume as solids: tets by their corners, others by their faces. Each face of more than three verts is
// a fan about its mean point, as in `volume`. Both polys at a face have the same triangles, so solids tile space if
// their polys do.
#pragma once

#include <concino/geometry/detail/ranked_polys.hpp>
#include <concino/geometry/detail/triangle_tests.hpp>

#include <vector>

namespace concino::detail {

/// Tets as items: item i is the tet with rank owner(i).
template<VolumeMesh M>
class tet_pieces : public simplex_pieces<M, 4> {
  using base = simplex_pieces<M, 4>;
  using base::corner;

 public:
  static constexpr std::uint32_t leaf_size = 2;
  static constexpr bool are_solid = true;

  explicit tet_pieces(const M& m) : base(m) { this->add_polys(m); }

  template<class F>
  void for_each_triangle(std::size_t i, F&& f) const {
    const vec3 &a = corner(i, 0), &b = corner(i, 1), &c = corner(i, 2), &d = corner(i, 3);
    f(a, c, b);
    f(a, b, d);
    f(b, c, d);
    f(a, d, c);
  }
  /// Whether the perturbed x is inside.
  bool holds(std::size_t i, const vec3& x) const {
    return perturbed_inside_tet(corner(i, 0), corner(i, 1), corner(i, 2), corner(i, 3), x);
  }
};

/// Polyhedra as items: item i is the polyhedron with rank owner(i).
template<VolumeMesh M>
class polyhedron_pieces : public ranked_polys<M> {
  using base = ranked_polys<M>;
  using base::points_;

  struct ring {
    std::uint32_t first = 0, size = 0;  // range of corners_
    corner_index mean = 0;              // index in points_, if size > 3
  };
  std::vector<ring> rings_;  // one per face
  std::vector<corner_index> corners_;
  std::vector<std::uint32_t> oriented_rings_;      // twice a ring, plus 1 if it is outward; those of an item are
                                                   // consecutive
  std::vector<std::size_t> first_ring_;  // by item
  std::vector<std::uint32_t> owners_;

  void add_mean(ring& r) {
    vec3 sum;
    const vec3 origin = points_[corners_[r.first]];
    for (std::uint32_t k = 1; k < r.size; ++k) sum += points_[corners_[r.first + k]] - origin;
    r.mean = static_cast<corner_index>(points_.size());
    points_.push_back(origin + sum / static_cast<double>(r.size));  // as in shape_of
  }

 public:
  static constexpr std::uint32_t leaf_size = 1;
  static constexpr bool are_solid = true;

  explicit polyhedron_pieces(const M& m)
      : base(m), rings_(face_index_bound(m)), first_ring_{0}, owners_(this->num_ranks()) {
    oriented_rings_.reserve(2 * rings_.size());  // an estimate, exact if all faces are shared
    corners_.reserve(4 * rings_.size());
    first_ring_.reserve(this->num_ranks() + 1);
    for (std::size_t r = 0; r < this->num_ranks(); ++r) {
      owners_[r] = static_cast<std::uint32_t>(r);
      const poly_t<M> p = this->poly(r);
      for (const face_t<M> f : adj_p2f(m, p)) {
        const std::size_t i = index_of(m, f);
        oriented_rings_.push_back(static_cast<std::uint32_t>(2 * i + (face_is_outward(m, p, f) ? 1 : 0)));
        if (rings_[i].size > 0) continue;
        rings_[i].first = static_cast<std::uint32_t>(corners_.size());
        for (const vert_t<M> v : adj_f2v(m, f)) {
          corners_.push_back(static_cast<corner_index>(index_of(m, v)));
          this->see(m, p, corners_.back());
        }
        rings_[i].size = static_cast<std::uint32_t>(corners_.size()) - rings_[i].first;
      }
      first_ring_.push_back(oriented_rings_.size());
    }
    this->scale();
    points_.reserve(points_.size() + rings_.size());
    for (ring& r : rings_)
      if (r.size > 3) add_mean(r);
  }

  std::size_t size() const { return owners_.size(); }
  std::uint32_t owner(std::size_t i) const { return owners_[i]; }
  box box_of(std::size_t i) const {
    box b;
    for (std::size_t s = first_ring_[i]; s < first_ring_[i + 1]; ++s) {
      const ring& r = rings_[oriented_rings_[s] / 2];
      for (std::uint32_t k = 0; k < r.size; ++k) b.add(points_[corners_[r.first + k]]);
      if (r.size > 3) b.add(points_[r.mean]);  // rounding may put it outside of the others
    }
    return b;
  }
  /// Calls f for each triangle of item i, counter-clockwise seen from outside.
  template<class F>
  void for_each_triangle(std::size_t i, F&& f) const {
    for (std::size_t s = first_ring_[i]; s < first_ring_[i + 1]; ++s) {
      const ring& r = rings_[oriented_rings_[s] / 2];
      const bool outward = oriented_rings_[s] % 2 != 0;
      const corner_index* c = corners_.data() + r.first;
      const auto triangle = [&](const vec3& p, const vec3& q, const vec3& o) { outward ? f(p, q, o) : f(q, p, o); };
      if (r.size == 3) triangle(points_[c[0]], points_[c[1]], points_[c[2]]);
      else
        for (std::uint32_t k = 0; k < r.size; ++k)
          triangle(points_[c[k]], points_[c[k + 1 < r.size ? k + 1 : 0]], points_[r.mean]);
    }
  }
  /// Whether the winding number of the poly around the perturbed x is not 0.
  bool holds(std::size_t i, const vec3& x) const {
    int times = 0;
    for_each_triangle(i, [&](const vec3& p, const vec3& q, const vec3& r) { times += crossing_above(p, q, r, x); });
    return times != 0;
  }
  void arrange(const std::vector<std::uint32_t>& order) {
    first_come_numbers number(points_.size()), ring_number(rings_.size());
    std::vector<std::size_t> first{0};
    std::vector<std::uint32_t> oriented_rings;
    std::vector<corner_index> corners;
    oriented_rings.reserve(oriented_rings_.size());
    corners.reserve(corners_.size());
    first.reserve(first_ring_.size());
    for (const std::uint32_t item : order) {
      for (std::size_t s = first_ring_[item]; s < first_ring_[item + 1]; ++s) {
        const std::uint32_t oriented_ring = oriented_rings_[s];
        ring& r = rings_[oriented_ring / 2];
        if (!ring_number.has(oriented_ring / 2)) {
          const std::uint32_t from = r.first;
          r.first = static_cast<std::uint32_t>(corners.size());
          for (std::uint32_t k = 0; k < r.size; ++k) corners.push_back(number(corners_[from + k]));
          if (r.size > 3) r.mean = number(r.mean);
        }
        oriented_rings.push_back(2 * ring_number(oriented_ring / 2) + oriented_ring % 2);
      }
      first.push_back(oriented_rings.size());
    }
    ring_number.arrange(rings_);
    number.arrange(points_);
    first_ring_ = std::move(first);
    oriented_rings_ = std::move(oriented_rings);
    corners_ = std::move(corners);
    detail::arrange(owners_, order);
  }
};

}  // namespace concino::detail
