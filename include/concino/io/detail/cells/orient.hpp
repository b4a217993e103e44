// Orients the faces of polyhedra outward.
#pragma once

#include <concino/io/detail/cells/oriented_faces.hpp>
#include <concino/mesh/support/cell_recogniser.hpp>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <span>
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

/// Orients the faces of one poly at a time consistently, by a search from face to face through the edges that two of
/// them share. It is not `bfs`, because there is no mesh yet, only the arrays of a file.
/// The faces of a poly are numbered by their positions in its list.
template<class Vert>  // vert_id, as in face_merger
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
  std::vector<std::uint32_t> first_link_;  // the links of face f end before first_link_[f], and those of f + 1 begin
                                           // there
  std::vector<std::uint32_t> component_, queue_;
  std::vector<link> links_;
  std::vector<std::uint8_t> flip_;

  void list_incidences(const oriented_faces& p) {
    incidences_.clear();
    p.for_each_edge([&](std::uint32_t a, std::uint32_t b, bool up, std::uint32_t k) {
      incidences_.push_back({std::uint64_t{a} << 32 | b, k, up});
    });
    std::sort(incidences_.begin(), incidences_.end(), [](const incidence& x, const incidence& y) {
      return x.edge != y.edge ? x.edge < y.edge : x.face < y.face;
    });
  }

  /// Calls use for the two faces of each edge. They agree if one runs up and the other down. Edges with one face, or
  /// more than two, are ignored.
  template<class Use>
  void for_each_pair(const Use& use) const {
    for (std::size_t i = 0, j; i < incidences_.size(); i = j) {
      for (j = i + 1; j < incidences_.size() && incidences_[j].edge == incidences_[i].edge;) ++j;
      if (j - i == 2 && incidences_[i].face != incidences_[i + 1].face) use(incidences_[i], incidences_[i + 1]);
    }
  }

  void link_faces(std::uint32_t n) {
    first_link_.assign(n + 1, 0);
    for_each_pair(
        [&](const incidence& x, const incidence& y) { ++first_link_[x.face + 1], ++first_link_[y.face + 1]; });
    for (std::size_t i = 1; i < first_link_.size(); ++i) first_link_[i] += first_link_[i - 1];
    links_.resize(first_link_[n]);
    for_each_pair([&](const incidence& x, const incidence& y) {
      links_[first_link_[x.face]++] = {y.face, x.up != y.up};
      links_[first_link_[y.face]++] = {x.face, x.up != y.up};
    });
  }

  /// Finds the faces to flip in the component of `seed`, so that all agree with the majority. The sign of the volume is
  /// corrected later.
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
  bool operator()(const oriented_faces& p) {
    list_incidences(p);
    link_faces(p.size);
    flip_.assign(p.size, 0);
    component_.assign(p.size, ~0u);
    for (std::uint32_t seed = 0; seed < p.size; ++seed)
      if (component_[seed] == ~0u) orient_component(seed);
    bool any = false;
    for (std::uint32_t k = 0; k < p.size; ++k) {
      p.outward[k] ^= flip_[k];
      any = any || flip_[k];
    }
    return any;
  }
};

/// Orients the faces of polys consistently, and outward, so that the volume is positive. Polys that are already
/// oriented so, or that are consistent and have no volume, are not changed.      Cost: O(n log n) in the edges of a
/// poly.
template<class Vert>  // vert_id, as in face_merger
class poly_orienter {
  std::span<const vec3> points_;
  face_orienter<Vert> orient_;

 public:
  explicit poly_orienter(std::span<const vec3> points) : points_(points) {}

  /// Result: whether the poly changed.
  bool operator()(const oriented_faces& p) {
    const bool changed = orient_(p);
    if (!has_negative_volume(p, points_)) return changed;
    for (std::uint32_t k = 0; k < p.size; ++k) p.outward[k] ^= 1;
    return true;
  }
};

/// Orients all polys.   Result: how many polys changed.
template<std::same_as<polyhedra_arrays> Arrays>  // a template only so that programs without volumes need not compile it
std::size_t orient_polyhedra(Arrays& m) {
  poly_orienter<vert_id> orient(m.points);
  face_lister<vert_id> faces_of;
  std::size_t changed = 0;
  for (std::size_t p = 0; p < m.num_polys(); ++p) changed += orient(faces_of(m, p));
  return changed;
}

}  // namespace concino::detail
