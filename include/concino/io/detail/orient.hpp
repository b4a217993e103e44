// Orients the faces of polyhedra outward.
#pragma once

#include <concino/mesh/arrays.hpp>
#include <concino/mesh/cell_recogniser.hpp>

#include <algorithm>
#include <bit>
#include <concepts>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The shape of poly p. Passes the verts of its faces to cell_recogniser, counter-clockwise as seen from outside.
inline cell_shape recognise(const polyhedra_arrays& m, std::size_t p, cell_recogniser& known) {
  known.clear();
  for (std::uint32_t i = m.poly_offsets[p]; i < m.poly_offsets[p + 1]; ++i) {
    const std::uint32_t f = m.poly_faces[i].raw();
    known.begin_face();
    for (std::uint32_t k = m.face_offsets[f]; k < m.face_offsets[f + 1]; ++k) known.push(m.face_verts[k]);
    if (!m.outward[i]) known.reverse_face();
  }
  return known.recognise();
}

struct same_point {
  const vec3& operator()(const vec3& p) const { return p; }
};

/// Six times the volume of poly p: each face is split into triangles at its mean point, with the sign of its outward flag.
/// Points are mapped by `scaled` first. If the faces do not close the poly, the result depends on the point from which volumes are measured: `center`,
/// or the first vert.
template<class Scale = same_point>
double six_times_poly_volume(const polyhedra_arrays& m, std::size_t p, const Scale& scaled = {}, const vec3* center = nullptr) {
  double sum = 0;
  if (m.poly_offsets[p] == m.poly_offsets[p + 1]) return sum;
  const vec3 apex = scaled(center ? *center : m.points[m.face_verts[m.face_offsets[m.poly_faces[m.poly_offsets[p]].raw()]].raw()]);
  for (std::uint32_t i = m.poly_offsets[p]; i < m.poly_offsets[p + 1]; ++i) {
    const std::uint32_t f = m.poly_faces[i].raw(), first = m.face_offsets[f];
    const double one = six_times_volume_under(
        m.face_offsets[f + 1] - first, [&](std::size_t k) -> decltype(auto) { return scaled(m.points[m.face_verts[first + k].raw()]); }, apex);
    sum += m.outward[i] ? one : -one;
  }
  return sum;
}

/// Whether the volume of poly p is negative, by more than rounding errors. If its faces do not close it, volumes are measured from the centre of its
/// box, so that the result does not depend on the order of its verts.
inline bool has_negative_volume(const polyhedra_arrays& m, std::size_t p, bool is_closed) {
  double x = 0;
  if (is_closed) x = six_times_poly_volume(m, p);
  if (x > 1e-100 && x < 1e100) return false;  // nearly all polys
  volume_box box;
  std::size_t num_corners = 0;
  const auto for_each_corner = [&](const auto& f) {
    for (std::uint32_t i = m.poly_offsets[p]; i < m.poly_offsets[p + 1]; ++i)
      for (std::uint32_t k = m.face_offsets[m.poly_faces[i].raw()]; k < m.face_offsets[m.poly_faces[i].raw() + 1]; ++k) f(m.face_verts[k]);
  };
  for_each_corner([&](vert_id v) {
    box.add(m.points[v.raw()]);
    ++num_corners;
  });
  if (num_corners == 0) return false;
  const vec3 center = box.center();
  if (box.is_moderate()) x = six_times_poly_volume(m, p, same_point{}, &center);
  else x = six_times_poly_volume(m, p, [&](const vec3& q) { return box.scaled(q); }, &center);
  return x < -box.error(num_corners);
}

/// Checks whether the faces of a polyhedron are consistently oriented at every edge that two of them share. This is fast, for the majority that
/// needs no repair. The edges of one polyhedron are in a small hash table with open addressing, at most a quarter full.
template<class Arrays>
class winding_check {
  struct entry {
    std::uint64_t edge;
    std::int32_t faces, sum;
  };
  static constexpr int max_probes = 1000;
  bool is_closed_ = false;
  std::vector<entry> table_;
  std::vector<std::uint32_t> used_;

 public:
  /// Whether the faces that were checked last are consistently oriented and close the poly: two of them have each edge.
  bool is_closed() const { return is_closed_; }

  /// True if the faces are consistently oriented; false if they are not or if it is not known.
  bool operator()(const Arrays& m, std::uint32_t begin, std::uint32_t end) {
    is_closed_ = false;
    std::size_t num_corners = 0;
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t f = m.poly_faces[i].raw();
      num_corners += m.face_offsets[f + 1] - m.face_offsets[f];
    }
    if (table_.size() < 2 * num_corners) table_.assign(std::bit_ceil(4 * num_corners), {0, 0, 0});
    const std::uint64_t mask = table_.size() - 1;
    used_.clear();
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t f = m.poly_faces[i].raw();
      std::uint32_t a = m.face_verts[m.face_offsets[f + 1] - 1].raw();
      for (std::uint32_t k = m.face_offsets[f]; k < m.face_offsets[f + 1]; ++k) {
        const std::uint32_t b = m.face_verts[k].raw();
        const std::uint64_t edge = a < b ? std::uint64_t{a} << 32 | b : std::uint64_t{b} << 32 | a;
        std::uint64_t at = (edge * 0x9e3779b97f4a7c15u >> 32) & mask;
        for (int probes = 0; table_[at].faces != 0 && table_[at].edge != edge; at = (at + 1) & mask)
          if (++probes == max_probes) {  // the edges collide on purpose: face_orienter takes n log n
            for (const std::uint32_t u : used_) table_[u] = {0, 0, 0};
            return false;
          }
        if (table_[at].faces++ == 0) {
          table_[at].edge = edge;
          used_.push_back(static_cast<std::uint32_t>(at));
        }
        table_[at].sum += (a < b) == (m.outward[i] != 0) ? 1 : -1;
        a = b;
      }
    }
    bool agree = true;
    is_closed_ = true;
    for (const std::uint32_t at : used_) {
      agree = agree && (table_[at].faces != 2 || table_[at].sum == 0);
      is_closed_ = is_closed_ && table_[at].faces == 2 && table_[at].sum == 0;
      table_[at] = {0, 0, 0};
    }
    return agree;
  }
};

/// Orients the faces of one poly at a time consistently, by a search from face to face through the edges that two of them share.
/// It is not `bfs`, because there is no mesh yet, only the arrays of a file.
/// The faces of a poly are numbered by their positions in its list.
template<class Arrays>
class face_orienter {
  struct incidence {
    std::uint64_t edge;  // smaller vert, larger vert
    std::uint32_t face;
    bool up;  // the outward orientation of the face runs from the smaller vert to the larger
  };
  struct link {
    std::uint32_t to;
    bool agree;
  };
  std::vector<incidence> incidences_;
  std::vector<std::uint32_t> first_link_;  // the links of face f end before first_link_[f], and those of f + 1 begin there
  std::vector<std::uint32_t> component_, queue_;
  std::vector<link> links_;
  std::vector<std::uint8_t> flip_;

  void list_incidences(const Arrays& m, std::uint32_t begin, std::uint32_t end) {
    incidences_.clear();
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t f = m.poly_faces[i].raw();
      std::uint32_t a = m.face_verts[m.face_offsets[f + 1] - 1].raw();
      for (std::uint32_t k = m.face_offsets[f]; k < m.face_offsets[f + 1]; ++k) {
        const std::uint32_t b = m.face_verts[k].raw();
        incidences_.push_back({a < b ? std::uint64_t{a} << 32 | b : std::uint64_t{b} << 32 | a, i - begin, (a < b) == (m.outward[i] != 0)});
        a = b;
      }
    }
    std::sort(incidences_.begin(), incidences_.end(), [](const incidence& x, const incidence& y) { return x.edge != y.edge ? x.edge < y.edge : x.face < y.face; });
  }

  /// Calls use for the two faces of each edge. They agree if one runs up and the other down. Edges with one face, or more than two, are ignored.
  template<class Use>
  void for_each_pair(const Use& use) const {
    for (std::size_t i = 0, j; i < incidences_.size(); i = j) {
      for (j = i + 1; j < incidences_.size() && incidences_[j].edge == incidences_[i].edge;) ++j;
      if (j - i == 2 && incidences_[i].face != incidences_[i + 1].face) use(incidences_[i], incidences_[i + 1]);
    }
  }

  void link_faces(std::uint32_t n) {
    first_link_.assign(n + 1, 0);
    for_each_pair([&](const incidence& x, const incidence& y) { ++first_link_[x.face + 1], ++first_link_[y.face + 1]; });
    for (std::size_t i = 1; i < first_link_.size(); ++i) first_link_[i] += first_link_[i - 1];
    links_.resize(first_link_[n]);
    for_each_pair([&](const incidence& x, const incidence& y) {
      links_[first_link_[x.face]++] = {y.face, x.up != y.up};
      links_[first_link_[y.face]++] = {x.face, x.up != y.up};
    });
  }

  /// Finds the faces to flip in the component of `seed`, so that all agree with the majority. The sign of the volume is corrected later.
  void orient_component(std::uint32_t seed) {
    queue_.assign(1, seed);
    component_[seed] = seed;
    std::size_t flipped = 0;
    for (std::size_t q = 0; q < queue_.size(); ++q) {
      const std::uint32_t f = queue_[q];
      for (std::uint32_t l = f ? first_link_[f - 1] : 0; l < first_link_[f]; ++l) {
        const std::uint32_t g = links_[l].to;
        if (component_[g] != ~0u) continue;
        component_[g] = seed;
        flip_[g] = links_[l].agree ? flip_[f] : !flip_[f];
        flipped += flip_[g];
        queue_.push_back(g);
      }
    }
    if (2 * flipped > queue_.size())
      for (const std::uint32_t f : queue_) flip_[f] = !flip_[f];
  }

 public:
  /// Result: whether a face was flipped.
  bool operator()(Arrays& m, std::uint32_t begin, std::uint32_t end) {
    const std::uint32_t n = end - begin;
    list_incidences(m, begin, end);
    link_faces(n);
    flip_.assign(n, 0);
    component_.assign(n, ~0u);
    for (std::uint32_t seed = 0; seed < n; ++seed)
      if (component_[seed] == ~0u) orient_component(seed);
    bool any = false;
    for (std::uint32_t k = 0; k < n; ++k)
      if (flip_[k]) {
        m.outward[begin + k] = !m.outward[begin + k];
        any = true;
      }
    return any;
  }
};

/// Orients the faces of each poly consistently, and outward, so that its volume is positive. Polys that are already oriented so, or that are
/// consistent and have no volume, are not changed.
/// Result: how many polys changed.   Cost: O(n log n) in the edges of a poly.
template<std::same_as<polyhedra_arrays> Arrays>  // a template only so that programs without volumes need not compile it
std::size_t orient_polyhedra(Arrays& m) {
  winding_check<Arrays> wound_well;
  face_orienter<Arrays> orient;
  std::size_t changed = 0;
  for (std::size_t p = 0; p < m.num_polys(); ++p) {
    const std::uint32_t begin = m.poly_offsets[p], end = m.poly_offsets[p + 1];
    bool touched = !wound_well(m, begin, end) && orient(m, begin, end);
    if (has_negative_volume(m, p, wound_well.is_closed())) {
      for (std::uint32_t i = begin; i < end; ++i) m.outward[i] = !m.outward[i];
      touched = true;
    }
    changed += touched;
  }
  return changed;
}

}  // namespace concino::detail
