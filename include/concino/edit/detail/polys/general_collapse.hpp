// The cavity of a collapse of an edge of polys with any number of verts.
#pragma once

#include <concino/edit/detail/link_condition.hpp>
#include <concino/edit/detail/operator_checks.hpp>
#include <concino/edit/detail/polys/general_checks.hpp>
#include <concino/edit/detail/relabelled_origins.hpp>
#include <concino/edit/detail/representable.hpp>

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace concino::detail {

inline constexpr permission collapse_shares_more{
    refusal::link_condition, "two polys would share more than one chain of edges or one disk of faces"};

/// Whether the lists of poly k are the faces of a tet, or a triangle.
template<class M>
bool is_simplex(const general_cavity<M>& c, std::size_t k) {
  const poly_lists& all = c.old_polys();
  constexpr std::size_t num_lists = dimension_v<M> == 2 ? 1 : 4;
  if (all.size_of(k) != num_lists) return false;
  for (std::size_t i = all.first_list(k); i < all.last_list(k); ++i)
    if (all.list(i).size() != 3) return false;
  return sorted_list(all.corners_of(k)).size() == dimension_v<M> + 1;
}

/// The link condition of polys that are divided into simplices: triangles and tets are left as they are, other polys
/// and faces get a vert in their middle. The result of a collapse is again divided so.
template<class M>
class divided_links {
  static constexpr unsigned n = dimension_v<M>;

  const general_cavity<M>& c_;
  const unsigned a_, b_;
  unsigned num_verts_;
  core::local_numbers faces_;  // the numbers of their middles begin at num_face_verts_
  std::vector<unsigned> middle_;
  simplex_list<n> link_a_, link_b_;
  simplex_list<n - 1> link_ab_;

  void add(const unsigned* s) {
    const bool has_a = std::find(s, s + n + 1, a_) != s + n + 1, has_b = std::find(s, s + n + 1, b_) != s + n + 1;
    if (has_a) add_link_simplex<n>(link_a_, s, n + 1, a_, a_);
    if (has_b) add_link_simplex<n>(link_b_, s, n + 1, b_, b_);
    if (has_a && has_b) add_link_simplex<n - 1>(link_ab_, s, n + 1, a_, b_);
  }
  unsigned middle_of(std::size_t list) {
    if constexpr (VolumeMesh<M>) {  // faces are those of several polys
      const unsigned k = faces_.add(index_of(c_.mesh(), c_.face(list)));
      if (k == middle_.size()) middle_.push_back(num_verts_++);
      return middle_[k];
    }
    return 0;
  }
  void add_poly(std::size_t k) {
    const poly_lists& all = c_.old_polys();
    if (is_simplex(c_, k)) {
      const auto corners = sorted_list(all.corners_of(k));
      return add(corners.data());
    }
    const unsigned middle = num_verts_++;
    for (std::size_t i = all.first_list(k); i < all.last_list(k); ++i) {
      const auto list = all.list(i);
      if constexpr (SurfaceMesh<M>) {  // triangles of the polygon, or tets over triangles of its faces
        for_each_edge_of(list, [&](unsigned x, unsigned y) {
          const unsigned s[] = {x, y, middle};
          add(s);
        });
      } else if (list.size() == 3) {
        const unsigned s[] = {list[0], list[1], list[2], middle};
        add(s);
      } else {
        const unsigned of_face = middle_of(i);
        for_each_edge_of(list, [&](unsigned x, unsigned y) {
          const unsigned s[] = {x, y, of_face, middle};
          add(s);
        });
      }
    }
  }

 public:
  divided_links(const general_cavity<M>& c, unsigned a, unsigned b)
      : c_(c), a_(a), b_(b), num_verts_(c.num_verts()) {
    for (std::size_t k = 0; k < c.num_polys(); ++k) add_poly(k);
  }
  bool allow_collapse() { return can_collapse<n>(link_a_, link_b_, link_ab_, num_verts_); }
};

/// Whether two polys, of which one has a and the other b, share a vert that is not joined with a after the collapse by
/// an edge of both.
template<class M>
bool would_share_more(const general_cavity<M>& c, unsigned a, unsigned b) {
  const poly_lists& all = c.old_polys();
  struct entry {
    unsigned vert;
    std::size_t poly;
    bool is_joined;  // to a or b, by an edge of the poly
  };
  std::vector<entry> at_a, at_b;  // by vert
  const auto read = [&](std::size_t k, unsigned end, std::vector<entry>& to) {
    std::vector<unsigned> joined;
    for (std::size_t i = all.first_list(k); i < all.last_list(k); ++i)
      for_each_edge_of(all.list(i), [&](unsigned x, unsigned y) {
        if (x == end) joined.push_back(y);
        if (y == end) joined.push_back(x);
      });
    for (const unsigned v : sorted_list(all.corners_of(k)))
      if (v != end) to.push_back({v, k, std::find(joined.begin(), joined.end(), v) != joined.end()});
  };
  for (std::size_t k = 0; k < c.num_polys(); ++k) {
    const bool has_a = c.has(k, a), has_b = c.has(k, b);
    if (has_a && !has_b) read(k, a, at_a);
    if (has_b && !has_a) read(k, b, at_b);
  }
  std::sort(at_b.begin(), at_b.end(), [](const entry& x, const entry& y) { return x.vert < y.vert; });
  std::vector<std::pair<std::pair<std::size_t, std::size_t>, bool>> shared;  // polys, and whether they share an edge
  for (const entry& x : at_a) {
    auto y = std::lower_bound(at_b.begin(), at_b.end(), x.vert, [](const entry& e, unsigned v) { return e.vert < v; });
    for (; y != at_b.end() && y->vert == x.vert; ++y)
      shared.push_back({{x.poly, y->poly}, x.is_joined && y->is_joined});
  }
  std::sort(shared.begin(), shared.end());
  for (std::size_t i = 0; i < shared.size(); ++i)  // those with an edge come last
    if ((i + 1 == shared.size() || shared[i + 1].first != shared[i].first) && !shared[i].second) return true;
  return false;
}

/// Whether faces become one that are not two faces of a tet that vanishes.
template<class M>
bool has_equal_faces(const general_cavity<M>& c, unsigned a, unsigned b) {
  if constexpr (VolumeMesh<M>) {  // surfaces have no faces
    struct entry {
      std::vector<unsigned> verts;  // after the collapse
      std::size_t face, list;
      bool operator<(const entry& x) const { return std::tie(verts, face) < std::tie(x.verts, x.face); }
    };
    std::vector<entry> faces;
    std::vector<std::pair<std::size_t, std::size_t>> of_tets;  // faces of tets that vanish, ascending
    const poly_lists& all = c.old_polys();
    for (std::size_t k = 0; k < c.num_polys(); ++k) {
      const bool vanishes = is_simplex(c, k) && c.has(k, a) && c.has(k, b);
      std::vector<std::size_t> its_faces;
      for (std::size_t i = all.first_list(k); i < all.last_list(k); ++i) {
        std::vector<unsigned> list(all.list(i).begin(), all.list(i).end());
        std::replace(list.begin(), list.end(), b, a);
        entry x{sorted_list(list), index_of(c.mesh(), c.face(i)), i};
        if (std::find(list.begin(), list.end(), a) == list.end() || x.verts.size() < 3) continue;
        its_faces.push_back(x.face);
        faces.push_back(std::move(x));
      }
      if (vanishes && its_faces.size() == 2)
        of_tets.push_back(std::minmax(its_faces[0], its_faces[1]));
    }
    std::sort(faces.begin(), faces.end());
    std::sort(of_tets.begin(), of_tets.end());
    for (std::size_t i = 1; i < faces.size(); ++i)
      if (faces[i].verts == faces[i - 1].verts && faces[i].face != faces[i - 1].face &&
          !std::binary_search(of_tets.begin(), of_tets.end(), std::pair{faces[i - 1].face, faces[i].face}))
        return true;
  }
  return false;
}

}  // namespace concino::detail
