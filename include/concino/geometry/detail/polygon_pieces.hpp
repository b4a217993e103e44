// The triangles of the polys of a surface, as items of a tree.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/geometry/detail/ranked_polys.hpp>
#include <concino/geometry/detail/triangle_tests.hpp>
#include <concino/geometry/triangulate_polygon.hpp>

#include <vector>

namespace concino::detail {

/// Triangles as items: item i is a triangle of the poly with rank owner(i).
template<SurfaceMesh M>
class polygon_pieces : public simplex_pieces<M, 3> {
  using base = simplex_pieces<M, 3>;
  using base::corners_, base::owners_, base::points_;

  std::vector<unsigned char> polygon_edges_;  // bit k: the side from corner k to the next is an edge of the poly; empty
                                              // if all are

  void cut_into_triangles(const std::vector<std::size_t>& begins, const std::vector<corner_index>& rings) {
    constexpr std::size_t chunk = 1024;
    std::vector<std::size_t> first(this->num_ranks() + 1, 0);
    for (std::size_t r = 0; r < this->num_ranks(); ++r)
      first[r + 1] = first[r] + std::max<std::size_t>(begins[r + 1] - begins[r], 2) - 2;
    corners_.resize(first.back());
    owners_.resize(first.back());
    polygon_edges_.resize(first.back());
    parallel_for((this->num_ranks() + chunk - 1) / chunk, [&](std::size_t c) {
      polygon_triangulator cut;
      std::vector<vec3> polygon;
      for (std::size_t r = c * chunk; r < std::min((c + 1) * chunk, this->num_ranks()); ++r) {
        const std::size_t begin = begins[r], n = begins[r + 1] - begin;
        polygon.clear();
        for (std::size_t i = 0; i < n; ++i) polygon.push_back(points_[rings[begin + i]]);
        std::size_t at = first[r];
        for (const polygon_triangle& t : cut(polygon)) {
          unsigned edge_bits = 0;
          for (std::size_t k = 0; k < 3; ++k) {
            corners_[at][k] = rings[begin + t[k]];
            const std::size_t from = t[k], to = t[k < 2 ? k + 1 : 0];
            if (to == (from + 1 < n ? from + 1 : 0) || from == (to + 1 < n ? to + 1 : 0)) edge_bits |= 1u << k;
          }
          owners_[at] = static_cast<std::uint32_t>(r);
          polygon_edges_[at++] = static_cast<unsigned char>(edge_bits);
        }
      }
    }, 1);
  }

 public:
  static constexpr std::uint32_t leaf_size = 4;
  static constexpr bool are_solid = false;

  explicit polygon_pieces(const M& m) : base(m) {
    if constexpr (TriMesh<M>) {  // a triangle is one item
      this->add_polys(m);
    } else {
      std::vector<std::size_t> begins{0};
      std::vector<corner_index> rings;
      for (std::size_t r = 0; r < this->num_ranks(); ++r) {
        for (const vert_t<M> v : adj_p2v(m, this->poly(r))) {
          rings.push_back(static_cast<corner_index>(index_of(m, v)));
          this->see(m, this->poly(r), rings.back());
        }
        begins.push_back(rings.size());
      }
      this->scale();
      cut_into_triangles(begins, rings);
    }
  }

  triangle_points triangle(std::size_t i) const { return {this->corner(i, 0), this->corner(i, 1), this->corner(i, 2)}; }
  bool is_polygon_edge(std::size_t i, std::size_t k) const {
    return polygon_edges_.empty() || (polygon_edges_[i] >> k & 1u);
  }

  template<class F>
  void for_each_triangle(std::size_t i, F&& f) const {
    f(this->corner(i, 0), this->corner(i, 1), this->corner(i, 2));
  }
  void arrange(const std::vector<std::uint32_t>& order) {
    if (!polygon_edges_.empty()) detail::arrange(polygon_edges_, order);
    base::arrange(order);
  }
};

}  // namespace concino::detail
