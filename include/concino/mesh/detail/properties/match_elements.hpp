// Finds the origins of edges, faces and corners from those of their verts and polys.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/mesh/corner_property.hpp>
#include <concino/mesh/element_origins.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace concino::detail {

/// All old verts that are origins of some new verts, each listed once.
struct joint_origins {
  std::vector<std::uint32_t> verts;

  void add(const element_origins::range& origins) {
    for (const origin x : origins)
      if (std::find(verts.begin(), verts.end(), x.index) == verts.end()) verts.push_back(x.index);
  }
};

/// The fraction of an element that has origin i. Weights that are all 0 count equally.
inline double part_of(const element_origins::range& origins, std::uint32_t i) {
  double total = 0, part = 0, times = 0;
  for (const origin x : origins) {
    total += x.weight;
    if (x.index == i) part += x.weight, ++times;
  }
  return total > 0 ? part / total : times / static_cast<double>(origins.size());
}

/// The elements of a mesh by index. Indices of removed elements have none.
template<class X>
struct elements_by_index {
  std::vector<X> elements;
  std::vector<unsigned char> exists;

  template<class M, class Range>
  elements_by_index(const M& m, const Range& all, std::size_t bound) : elements(bound), exists(bound) {
    for (const X x : all) {
      elements[index_of(m, x)] = x;
      exists[index_of(m, x)] = 1;
    }
  }
};

/// The edge of m between the verts with indices a and b; `none` if there is none.
template<class M>
std::uint32_t find_edge(const M& m, const elements_by_index<vert_t<M>>& by_index, std::uint32_t a, std::uint32_t b) {
  if (!by_index.exists[a]) return element_origins::none;
  for (const edge_t<M> e : adj_v2e(m, by_index.elements[a])) {
    const auto ends = end_verts(m, e);
    if (index_of(m, ends.first) == b || index_of(m, ends.second) == b)
      return static_cast<std::uint32_t>(index_of(m, e));
  }
  return element_origins::none;
}

/// A face of m that has all of these verts, at least three; if possible, one that has no others.
template<class M>
std::uint32_t face_around(const M& m, const elements_by_index<vert_t<M>>& by_index,
                          const std::vector<std::uint32_t>& wanted) {
  std::uint32_t found = element_origins::none;
  if (!by_index.exists[wanted[0]]) return found;
  for (const face_t<M> f : adj_v2f(m, by_index.elements[wanted[0]])) {
    std::size_t size = 0, common = 0;
    for (const vert_t<M> v : adj_f2v(m, f)) {
      ++size;
      common += std::find(wanted.begin(), wanted.end(), index_of(m, v)) != wanted.end();
    }
    if (common != wanted.size()) continue;
    if (size == common) return static_cast<std::uint32_t>(index_of(m, f));
    if (found == element_origins::none) found = static_cast<std::uint32_t>(index_of(m, f));
  }
  return found;
}

/// The origin of an edge of m between the origins of its ends; `none` if there is no such edge.
template<class From, class To>
origin match_edge(const From& before, const To& m, const element_origins& of_verts,
                  const elements_by_index<vert_t<From>>& by_index, const edge_t<To>& e) {
  const auto ends = end_verts(m, e);
  const auto first = of_verts[index_of(m, ends.first)], second = of_verts[index_of(m, ends.second)];
  joint_origins joint;
  joint.add(first), joint.add(second);
  if (first.empty() || second.empty() || joint.verts.size() != 2) return {element_origins::none, 0};
  const std::uint32_t a = joint.verts[0], b = joint.verts[1];
  const double length = part_of(first, a) - part_of(second, a);  // of the old edge, as a fraction of it
  return {find_edge(before, by_index, a, b), length < 0 ? -length : length};
}

/// Collects the origin of each element of one kind, of which it has at most one, in any order of their indices.
class single_origins {
  std::vector<std::uint32_t> index_;
  std::vector<std::pair<std::uint32_t, origin>> weighted_;  // those with a weight other than 1

 public:
  explicit single_origins(std::size_t bound) : index_(bound, element_origins::none) {}

  void set(std::size_t i, std::uint32_t index) { index_[i] = index; }
  void set(std::size_t i, const origin& x) {
    index_[i] = x.index;
    if (x.index != element_origins::none && x.weight != 1) weighted_.push_back({static_cast<std::uint32_t>(i), x});
  }
  bool is_set(std::size_t i) const { return index_[i] != element_origins::none; }

  element_origins collect() && {
    element_origins origins(std::move(index_));
    for (const auto& [i, x] : weighted_) origins.set(i, std::span<const origin>(&x, 1));
    return origins;
  }
};

template<class From, class To>
element_origins match_edges(const From& before, const To& m, const element_origins& of_verts,
                            const elements_by_index<vert_t<From>>& by_index) {
  single_origins found(edge_index_bound(m));
  for (const edge_t<To> e : edges(m)) found.set(index_of(m, e), match_edge(before, m, of_verts, by_index, e));
  return std::move(found).collect();
}

template<class From, class To>
element_origins match_faces(const From& before, const To& m, const element_origins& of_verts,
                            const elements_by_index<vert_t<From>>& by_index) {
  std::vector<std::uint32_t> found(face_index_bound(m), element_origins::none);
  for (const face_t<To> f : faces(m)) {
    joint_origins joint;
    bool is_known = true;
    for (const vert_t<To> v : adj_f2v(m, f)) {
      const auto origins = of_verts[index_of(m, v)];
      is_known = is_known && !origins.empty();
      joint.add(origins);
    }
    if (is_known && joint.verts.size() > 2) found[index_of(m, f)] = face_around(before, by_index, joint.verts);
  }
  return element_origins(std::move(found));
}

/// Finds the origins of a corner. They are corners of the origins of its poly, at the origins of its vert.
template<NumbersCorners From, NumbersCorners To>
element_origins match_corners(const From& before, const To& m, const element_origins& of_verts,
                              const element_origins& of_polys) {
  const elements_by_index<poly_t<From>> by_index(before, polys(before), poly_index_bound(before));
  std::vector<std::size_t> first, last;  // of the origins of each corner, by corner number, in `found`
  first.resize(traits<To>::corner_index_bound(m)), last.resize(first.size());
  std::vector<origin> found;
  for (const poly_t<To> p : polys(m)) {
    std::size_t corner = traits<To>::first_corner(m, p);
    for (const vert_t<To> v : adj_p2v(m, p)) {
      first[corner] = found.size();
      for (const origin of_poly : of_polys[index_of(m, p)]) {
        if (!by_index.exists[of_poly.index]) continue;
        std::size_t number = traits<From>::first_corner(before, by_index.elements[of_poly.index]);
        for (const vert_t<From> w : adj_p2v(before, by_index.elements[of_poly.index])) {
          for (const origin of_vert : of_verts[index_of(m, v)])
            if (of_vert.index == index_of(before, w))
              found.push_back({static_cast<std::uint32_t>(number), of_poly.weight * of_vert.weight});
          ++number;
        }
      }
      last[corner++] = found.size();
    }
  }
  element_origins origins;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const std::span<const origin> of(found.data() + first[i], found.data() + last[i]);
    if (of.empty() || (of.size() == 1 && of[0].weight == 1))
      origins.add(of.empty() ? element_origins::none : of[0].index);
    else origins.add(of);
  }
  return origins;
}

}  // namespace concino::detail
