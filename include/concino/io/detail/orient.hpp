// Orients the faces of polyhedra outward.
#pragma once

#include <concino/io/detail/oriented_faces.hpp>
#include <concino/mesh/cell_recogniser.hpp>

#include <algorithm>
#include <bit>
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

/// Checks whether the faces of a polyhedron are consistently oriented at every edge that two of them share. This is fast, for the majority that
/// needs no repair. The edges of one polyhedron are in a small hash table with open addressing, at most a quarter full; entries of earlier ones are
/// recognised by their stamp.
template<class Vert>  // vert_id, as in face_merger
class winding_check {
  enum : std::uint32_t { down, up, agreeing, opposed, many };  // the one face, the two faces or the more faces of an edge
  struct entry {
    std::uint64_t edge;
    std::uint32_t stamp, faces;
  };
  static constexpr int max_probes = 1000;
  double six_times_volume_ = 0;
  std::uint32_t stamp_ = 0;
  std::vector<entry> table_;

 public:
  /// Six times the volume of the faces that were checked last; 0 if they are not consistently oriented, if they do not close the poly, so that two of them
  /// have each edge, or if coordinates are not moderate.
  double six_times_volume() const { return six_times_volume_; }

  /// True if the faces are consistently oriented; false if they are not or if it is not known. Computes the volume in the same loop, which takes much
  /// less time than another loop over the verts of each face.
  bool operator()(const oriented_faces& p, std::span<const vec3> points) {
    const std::size_t num_corners = p.num_corners();
    if (++stamp_ == 0 || table_.size() < 2 * num_corners) {
      table_.assign(std::max(table_.size(), std::bit_ceil(4 * num_corners)), {0, 0, many});
      stamp_ = 1;
    }
    const std::uint64_t mask = table_.size() - 1;
    std::size_t num_agreeing = 0, num_opposed = 0;  // edges of two faces
    bool is_known = true;
    const auto add = [&](std::uint32_t a, std::uint32_t b, bool is_up) {
      const std::uint64_t edge = std::uint64_t{a} << 32 | b;
      std::uint64_t at = (edge * 0x9e3779b97f4a7c15u >> 32) & mask;
      for (int probes = 0; table_[at].stamp == stamp_ && table_[at].edge != edge; at = (at + 1) & mask)
        if (++probes == max_probes) return is_known = false;  // the edges collide on purpose: face_orienter takes n log n
      entry& e = table_[at];
      if (e.stamp != stamp_) {
        e = {edge, stamp_, is_up ? up : down};
      } else if (e.faces <= up) {
        const bool agree = e.faces != (is_up ? up : down);
        (agree ? num_agreeing : num_opposed) += 1;
        e.faces = agree ? agreeing : opposed;
      } else if (e.faces != many) {
        (e.faces == agreeing ? num_agreeing : num_opposed) -= 1;
        e.faces = many;
      }
      return true;
    };
    double sum = 0;
    bool is_certain = true;
    const vec3 apex = p.size ? points[p.verts[p.offsets[0]].raw()] : vec3();
    for (std::uint32_t k = 0; k < p.size && is_known; ++k) {
      const bool is_outward = p.outward[k] != 0;
      std::uint32_t from = p.verts[p.offsets[k + 1] - 1].raw();
      vec3 a = points[from] - apex;
      volume_under_face volume;
      for (std::uint32_t i = p.offsets[k]; i < p.offsets[k + 1]; ++i) {
        const std::uint32_t to = p.verts[i].raw();
        const vec3 b = points[to] - apex;
        volume.add_edge(a, b);
        is_certain = is_certain && has_moderate_coordinates(points[to]);
        if (!add(std::min(from, to), std::max(from, to), (from < to) == is_outward)) break;
        from = to;
        a = b;
      }
      const double one = volume.six_times(p.offsets[k + 1] - p.offsets[k]);
      sum += is_outward ? one : -one;
    }
    const bool is_closed = is_known && 2 * num_agreeing == num_corners;
    six_times_volume_ = is_closed && is_certain ? sum : 0;
    return is_known && num_opposed == 0;
  }
};

/// Orients the faces of one poly at a time consistently, by a search from face to face through the edges that two of them share.
/// It is not `bfs`, because there is no mesh yet, only the arrays of a file.
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
  std::vector<std::uint32_t> first_link_;  // the links of face f end before first_link_[f], and those of f + 1 begin there
  std::vector<std::uint32_t> component_, queue_;
  std::vector<link> links_;
  std::vector<std::uint8_t> flip_;

  void list_incidences(const oriented_faces& p) {
    incidences_.clear();
    p.for_each_edge([&](std::uint32_t a, std::uint32_t b, bool up, std::uint32_t k) {
      incidences_.push_back({std::uint64_t{a} << 32 | b, k, up});
      return true;
    });
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

/// Orients the faces of polys consistently, and outward, so that the volume is positive. Polys that are already oriented so, or that are
/// consistent and have no volume, are not changed.      Cost: O(n log n) in the edges of a poly; O(n) if it is oriented consistently.
template<class Vert>  // vert_id, as in face_merger
class poly_orienter {
  std::span<const vec3> points_;
  winding_check<Vert> wound_well_;
  face_orienter<Vert> orient_;

 public:
  explicit poly_orienter(std::span<const vec3> points) : points_(points) {}

  /// Result: whether the poly changed.
  bool operator()(const oriented_faces& p) {
    const bool changed = !wound_well_(p, points_) && orient_(p);
    if (!has_negative_volume(p, points_, wound_well_.six_times_volume())) return changed;
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
