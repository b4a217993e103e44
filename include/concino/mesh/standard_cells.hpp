// The cells that have a name: how their faces are made of their verts, telling them by their faces, and general polyhedra made of them.
#pragma once

#include <concino/geometry/vec3.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/shapes.hpp>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace concino::detail {

enum class cell_shape : std::uint8_t { tet, hex, prism, pyramid, general };

/// One standard cell. Verts are in the order of VTK and MEDIT; faces run counter-clockwise seen from outside where the cell's volume is positive.
struct standard_cell {
  const char* name;
  unsigned num_verts, num_faces;
  std::uint8_t face_size[6];
  std::uint8_t face_vert[6][4];
  std::uint8_t mirrored[8];  // the verts of the mirror image: a cell of negative volume, read in this order, has a positive one
};

inline constexpr standard_cell standard_cells[] = {
    {"tet", 4, 4, {3, 3, 3, 3}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}, {0, 1, 3, 2}},
    {"hex", 8, 6, {4, 4, 4, 4, 4, 4}, {{0, 3, 2, 1}, {1, 2, 6, 5}, {4, 5, 6, 7}, {3, 0, 4, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}}, {0, 3, 2, 1, 4, 7, 6, 5}},
    {"prism", 6, 5, {3, 3, 4, 4, 4}, {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}, {0, 2, 1, 3, 5, 4}},
    {"pyramid", 5, 5, {4, 3, 3, 3, 3}, {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}, {0, 3, 2, 1, 4}},
};
inline constexpr const standard_cell& table_of(cell_shape s) { return standard_cells[static_cast<unsigned>(s)]; }

/// The volume under one face seen from `apex`, six times: the triangles from the face's mean point to its edges, positive if they turn
/// away from the apex. point(i) is the i-th of the n verts.
template<class Point>
double six_volumes_under(std::size_t n, const Point& point, const vec3& apex) {
  vec3 middle;
  for (std::size_t i = 0; i < n; ++i) middle += point(i) - apex;
  middle /= static_cast<double>(n);
  double sum = 0;
  vec3 a = point(n - 1) - apex;
  for (std::size_t i = 0; i < n; ++i) {
    const vec3 b = point(i) - apex;
    sum += dot(middle, cross(a, b));
    a = b;
  }
  return sum;
}

/// Six times the signed volume of a standard cell, each face a fan about its mean point.
inline double six_volumes(cell_shape s, const vert_id* v, const std::vector<vec3>& points) {
  const auto at = [&](unsigned i) -> const vec3& { return points[v[i].raw()]; };
  if (s == cell_shape::tet) return dot(at(1) - at(0), cross(at(2) - at(0), at(3) - at(0)));
  const standard_cell& t = table_of(s);
  double sum = 0;
  for (unsigned f = 0; f < t.num_faces; ++f)
    sum += six_volumes_under(t.face_size[f], [&](std::size_t i) -> const vec3& { return at(t.face_vert[f][i]); }, at(0));
  return sum;
}

/// Puts the verts of a cell of negative volume into the standard order. Returns whether it did.
inline bool make_positive(cell_shape s, vert_id* v, const std::vector<vec3>& points) {
  if (!(six_volumes(s, v, points) < 0)) return false;
  vert_id was[8];
  const standard_cell& t = table_of(s);
  std::copy_n(v, t.num_verts, was);
  for (unsigned i = 0; i < t.num_verts; ++i) v[i] = was[t.mirrored[i]];
  return true;
}

/// Whether a and b are one cycle, walked the same way (1) or opposite ways (-1), or are not (0). Verts are not repeated.
inline int compare_cycles(const vert_id* a, const vert_id* b, std::size_t n) {
  const auto k = static_cast<std::size_t>(std::find(b, b + n, a[0]) - b);
  if (k == n) return 0;
  bool same = true, opposite = true;
  for (std::size_t i = 0; i < n && (same || opposite); ++i) {
    same = same && a[i] == b[(k + i) % n];
    opposite = opposite && a[i] == b[(k + n - i) % n];
  }
  return same ? 1 : opposite ? -1 : 0;
}

/// Makes polyhedra of lists of verts face by face: equal faces become one, seen from its two sides.
/// Faces are numbered as they are first met, and are outward for the poly that has them first. Linear time but for the sorting of the few faces
/// that have the same smallest vert.
struct face_soup {
  std::vector<std::uint32_t> face_offsets{0};  // of the faces of all polys, one after another, common ones twice
  std::vector<vert_id> face_verts;
  std::vector<std::uint32_t> poly_offsets{0};

  void add_cell(cell_shape s, const vert_id* v) {
    const standard_cell& t = table_of(s);
    for (unsigned f = 0; f < t.num_faces; ++f) {
      for (unsigned i = 0; i < t.face_size[f]; ++i) face_verts.push_back(v[t.face_vert[f][i]]);
      face_offsets.push_back(static_cast<std::uint32_t>(face_verts.size()));
    }
    poly_offsets.push_back(static_cast<std::uint32_t>(face_offsets.size() - 1));
  }

  polyhedra_arrays unite(std::vector<vec3> points) && {
    struct entry {
      std::uint64_t others;  // the second and third smallest verts
      std::uint32_t face;
    };
    const std::size_t n = face_offsets.size() - 1;
    const auto size = [&](std::size_t f) { return face_offsets[f + 1] - face_offsets[f]; };
    const auto first = [&](std::size_t f) { return face_verts.data() + face_offsets[f]; };
    const auto smallest = [&](std::size_t f) { return std::min_element(first(f), first(f) + size(f))->raw(); };

    std::vector<std::uint32_t> where(points.size() + 1, 0);
    for (std::size_t f = 0; f < n; ++f) ++where[smallest(f) + 1];
    std::partial_sum(where.begin(), where.end(), where.begin());
    std::vector<entry> entries(n);
    for (std::size_t f = 0; f < n; ++f) {
      std::uint32_t low[3] = {~0u, ~0u, ~0u};
      for (const vert_id *v = first(f), *last = v + size(f); v != last; ++v) {
        const std::uint32_t x = v->raw();
        if (x < low[0]) low[2] = low[1], low[1] = low[0], low[0] = x;
        else if (x < low[1]) low[2] = low[1], low[1] = x;
        else if (x < low[2]) low[2] = x;
      }
      entries[where[low[0]]++] = {std::uint64_t{low[1]} << 32 | low[2], static_cast<std::uint32_t>(f)};
    }

    // twin[f]: the first face equal to f, and whether f runs the other way
    std::vector<std::uint32_t> twin(n);
    std::vector<std::uint8_t> outward(n, 1);
    for (std::size_t v = 0, from = 0; v < points.size(); from = where[v++]) {
      const auto b = entries.begin() + static_cast<std::ptrdiff_t>(from), e = entries.begin() + where[v];
      std::sort(b, e, [](const entry& x, const entry& y) { return x.others != y.others ? x.others < y.others : x.face < y.face; });
      auto run = b;
      for (auto i = b; i != e; ++i) {
        if (i->others != run->others) run = i;
        twin[i->face] = i->face;
        for (auto j = run; j != i; ++j) {
          if (twin[j->face] != j->face || size(j->face) != size(i->face)) continue;
          if (const int way = compare_cycles(first(j->face), first(i->face), size(i->face))) {
            twin[i->face] = j->face;
            outward[i->face] = way > 0;
            break;
          }
        }
      }
    }
    entries = {};
    where = {};

    polyhedra_arrays out;
    out.points = std::move(points);
    out.poly_offsets = std::move(poly_offsets);
    out.poly_faces.resize(n);
    out.outward = std::move(outward);
    out.face_offsets.push_back(0);
    std::uint32_t corners = 0, faces = 0;
    // In place: a kept face moves to the front, over what has been read; twin becomes the new number.
    for (std::size_t f = 0; f < n; ++f) {
      if (twin[f] == f) {
        const std::uint32_t k = size(f);
        std::copy_n(first(f), k, face_verts.data() + corners);
        out.face_offsets.push_back(corners += k);
        out.poly_faces[f] = face_id{faces++};
      } else {
        out.poly_faces[f] = out.poly_faces[twin[f]];
      }
    }
    face_verts.resize(corners);
    face_verts.shrink_to_fit();
    out.face_verts = std::move(face_verts);
    return out;
  }
};

/// The same volume as general polyhedra; polys keep their order.
inline polyhedra_arrays to_polyhedra(cell_arrays&& cells) {
  const cell_shape s = cells.arity == 4 ? cell_shape::tet : cell_shape::hex;
  const standard_cell& t = table_of(s);
  const std::size_t n = cells.num_polys();
  face_soup soup;
  soup.face_offsets.reserve(n * t.num_faces + 1);
  soup.face_verts.reserve(n * (s == cell_shape::tet ? 12 : 24));
  soup.poly_offsets.reserve(n + 1);
  for (std::size_t c = 0; c < n; ++c) soup.add_cell(s, cells.verts.data() + c * t.num_verts);
  std::vector<vert_id>().swap(cells.verts);
  return std::move(soup).unite(std::move(cells.points));
}

/// Tells a standard cell by its faces alone and lists its verts in the standard order, so that the faces as given run as they do in
/// the table. face(k) is the verts of the k-th of n faces, turned outward. General if it is none.
class cell_recogniser {
  struct span_of_face {
    std::uint32_t begin, size;
  };
  std::vector<vert_id> verts_;
  std::vector<span_of_face> faces_;

 public:
  vert_id cell[8];

  void clear() {
    verts_.clear();
    faces_.clear();
  }
  void begin_face() { faces_.push_back({static_cast<std::uint32_t>(verts_.size()), 0}); }
  void push(vert_id v) {
    verts_.push_back(v);
    ++faces_.back().size;
  }
  /// Walks the face just pushed the other way.
  void reverse_face() { std::reverse(verts_.end() - faces_.back().size, verts_.end()); }

  cell_shape recognise() {
    unsigned triangles = 0, quads = 0;
    for (const span_of_face& f : faces_) {
      triangles += f.size == 3;
      quads += f.size == 4;
    }
    if (triangles + quads != faces_.size()) return cell_shape::general;
    cell_shape s = cell_shape::general;
    if (triangles == 4 && quads == 0) s = cell_shape::tet;
    if (triangles == 0 && quads == 6) s = cell_shape::hex;
    if (triangles == 2 && quads == 3) s = cell_shape::prism;
    if (triangles == 4 && quads == 1) s = cell_shape::pyramid;
    if (s == cell_shape::general) return s;

    // The base is the face of its table's first size that comes first; it is listed outward there, so reading it backwards gives
    // the verts from 0 on. The others stand over them.
    const standard_cell& t = table_of(s);
    const auto base = *std::find_if(faces_.begin(), faces_.end(), [&](const span_of_face& f) { return f.size == t.face_size[0]; });
    const unsigned b = base.size;
    for (unsigned i = 0; i < b; ++i) cell[t.face_vert[0][i]] = verts_[base.begin + i];
    for (unsigned i = b; i < t.num_verts; ++i) {
      const vert_id under = cell[i - b];
      cell[i] = s == cell_shape::tet || s == cell_shape::pyramid ? apex(b) : over(under, b);
      if (cell[i].is_none()) return cell_shape::general;
    }
    return matches(t) ? s : cell_shape::general;
  }

 private:
  bool in_base(vert_id v, unsigned b) const { return std::find(cell, cell + b, v) != cell + b; }
  vert_id apex(unsigned b) const {
    for (vert_id v : verts_)
      if (!in_base(v, b)) return v;
    return {};
  }
  /// The vert next to a base vert that is not in the base.
  vert_id over(vert_id under, unsigned b) const {
    for (const span_of_face& f : faces_)
      for (std::uint32_t i = 0; i < f.size; ++i) {
        const vert_id v = verts_[f.begin + i], next = verts_[f.begin + (i + 1) % f.size];
        if (v == under && !in_base(next, b)) return next;
        if (next == under && !in_base(v, b)) return v;
      }
    return {};
  }
  bool matches(const standard_cell& t) const {
    for (unsigned i = 0; i < t.num_verts; ++i)
      for (unsigned j = 0; j < i; ++j)
        if (cell[i] == cell[j]) return false;
    unsigned used = 0;
    for (unsigned f = 0; f < t.num_faces; ++f) {
      vert_id want[4];
      for (unsigned i = 0; i < t.face_size[f]; ++i) want[i] = cell[t.face_vert[f][i]];
      unsigned k = 0;
      while (k < faces_.size() && ((used >> k & 1) || faces_[k].size != t.face_size[f] || compare_cycles(want, verts_.data() + faces_[k].begin, faces_[k].size) == 0)) ++k;
      if (k == faces_.size()) return false;
      used |= 1u << k;
    }
    return true;
  }
};

}  // namespace concino::detail
