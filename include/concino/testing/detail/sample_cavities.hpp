// Cavities that every editable mesh can be given: a poly that is turned, one that is divided at new verts, and the
// parts that are joined again.
#pragma once

#include <concino/concepts/editable.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/support/standard_cells.hpp>
#include <concino/testing/detail/described_mesh.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace concino::testing::detail {

/// A cavity with its arrays.
template<class M>
struct built_cavity {
  std::vector<poly_t<M>> polys;
  std::vector<vert_t<M>> verts;
  std::vector<vec3> points;
  std::vector<unsigned> corners, ends, poly_ends;
  std::size_t kept = 0, removed = 0;
  std::vector<vert_t<M>> new_verts;
  std::vector<poly_t<M>> new_polys;

  /// The number of a vert, which is added if it is new to the cavity.
  unsigned number(const vert_t<M>& v) {
    const auto at = std::find(verts.begin(), verts.end(), v);
    const auto i = static_cast<unsigned>(at - verts.begin());
    if (at == verts.end()) verts.push_back(v);
    return i;
  }
  unsigned first_point() const { return static_cast<unsigned>(verts.size()); }
  /// Adds the corners of a poly, or of a face of a general polyhedron.
  void add_loop(const std::vector<unsigned>& loop) {
    corners.insert(corners.end(), loop.begin(), loop.end());
    ends.push_back(static_cast<unsigned>(corners.size()));
  }
  void end_poly() {
    if constexpr (has_general_polyhedra<M>) poly_ends.push_back(static_cast<unsigned>(ends.size()));
  }
  std::size_t num_new() const { return has_general_polyhedra<M> ? poly_ends.size() : ends.size(); }

  /// The lists of corners of new poly i.
  std::vector<std::vector<unsigned>> loops_of(std::size_t i) const {
    std::size_t first = i, last = i + 1;
    if constexpr (has_general_polyhedra<M>) first = i == 0 ? 0 : poly_ends[i - 1], last = poly_ends[i];
    std::vector<std::vector<unsigned>> loops;
    for (std::size_t k = first; k < last; ++k)
      loops.emplace_back(corners.begin() + (k == 0 ? 0 : ends[k - 1]), corners.begin() + ends[k]);
    return loops;
  }

  cavity<M> lists() const {
    const auto all = [](const auto& x) {
      return id_span<typename std::remove_cvref_t<decltype(x)>::value_type>(x.data(), x.data() + x.size());
    };
    return {all(polys), all(verts), all(points), all(corners), all(ends), all(poly_ends), kept, removed};
  }
  void apply(M& m) {
    new_verts.resize(points.size());
    new_polys.resize(num_new());
    rewire(m, lists(), {new_verts.data(), new_polys.data()});
  }
};

/// The lists of corners of p: one, or those of the faces of a general polyhedron, counter-clockwise seen from outside.
template<class M>
std::vector<std::vector<unsigned>> loops_of(const M& m, const poly_t<M>& p, built_cavity<M>& c) {
  std::vector<std::vector<unsigned>> loops;
  if constexpr (has_general_polyhedra<M>) {
    for (const face_t<M> f : adj_p2f(m, p)) {
      loops.emplace_back();
      for (const vert_t<M> v : adj_f2v(m, f)) loops.back().push_back(c.number(v));
      if (!face_is_outward(m, p, f)) std::reverse(loops.back().begin(), loops.back().end());
    }
  } else {
    loops.emplace_back();
    for (const vert_t<M> v : adj_p2v(m, p)) loops.back().push_back(c.number(v));
  }
  return loops;
}

/// The poly p again, with its descriptor; its corners start one later, of tets and hexes it is turned.
template<EditableMesh M>
built_cavity<M> turned_poly(const M& m, const poly_t<M>& p) {
  built_cavity<M> c;
  c.polys = {p};
  c.kept = 1;
  for (auto& loop : loops_of(m, p, c)) {
    // a rotation of the standard order
    if constexpr (dimension_v<M> == 3 && arity_v<M> == 4) loop = {loop[1], loop[2], loop[0], loop[3]};
    // about the vertical axis
    else if constexpr (arity_v<M> == 8) loop = {loop[1], loop[2], loop[3], loop[0], loop[5], loop[6], loop[7], loop[4]};
    else std::rotate(loop.begin(), loop.begin() + 1, loop.end());
    c.add_loop(loop);
  }
  c.end_poly();
  return c;
}

/// A point inside the corners, nearer to the later ones; floats represent it, so that every mesh can store it.
template<class M>
vec3 inner_point(const M& m, const std::vector<vert_t<M>>& corners, std::size_t near) {
  vec3 sum;
  double total = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const double weight = k == near ? 3.0 * static_cast<double>(corners.size()) : 1 + static_cast<double>(k) / 4;
    sum += weight * to_vec3(point(m, corners[k]));
    total += weight;
  }
  const auto rounded = [&](double x) { return static_cast<double>(static_cast<float>(x / total)); };
  return {rounded(sum.x), rounded(sum.y), rounded(sum.z)};
}

/// The facets of a poly without general polyhedra as numbers of corners, counter-clockwise seen from outside.
template<class M>
std::vector<std::vector<unsigned>> facets_of_corners([[maybe_unused]] unsigned n) {
  std::vector<std::vector<unsigned>> all;
  if constexpr (dimension_v<M> == 2) {  // facets have different names in both dimensions
    for (unsigned k = 0; k < n; ++k) all.push_back({k, (k + 1) % n});
  } else {
    const standard_cell& cell = standard_cell_of(arity_v<M> == 4 ? cell_shape::tet : cell_shape::hex);
    for (unsigned f = 0; f < cell.num_faces; ++f)
      all.emplace_back(cell.face_vert[f], cell.face_vert[f] + cell.face_size[f]);
  }
  return all;
}

/// Divides p: into one poly for each facet, which joins it to a new vert or, of quads and hexes, to a facet of a
/// smaller copy of p inside, which remains.
template<EditableMesh M>
built_cavity<M> divided_poly(const M& m, const poly_t<M>& p) {
  constexpr bool has_copy = (dimension_v<M> == 2 && arity_v<M> == 4) || arity_v<M> == 8;
  if constexpr (dimension_v<M> == 2 && arity_v<M> > 4) return {};  // no division has polys of this arity only
  built_cavity<M> c;
  c.polys = {p};
  c.kept = 1;
  const auto loops = loops_of(m, p, c);
  const unsigned top = c.first_point();
  for (std::size_t k = 0; k < (has_copy ? c.verts.size() : 1); ++k)
    c.points.push_back(inner_point(m, c.verts, has_copy ? k : c.verts.size()));
  if constexpr (has_general_polyhedra<M>) {
    for (const auto& base : loops) {
      c.add_loop(base);
      for (std::size_t k = 0; k < base.size(); ++k) c.add_loop({base[(k + 1) % base.size()], base[k], top});
      c.end_poly();
    }
  } else {
    const auto& loop = loops[0];
    const auto inner = [&](unsigned k) { return has_copy ? top + loop[k] : top; };
    std::vector<unsigned> corners;
    for (unsigned k = 0; has_copy && k < loop.size(); ++k) corners.push_back(inner(k));
    if (has_copy) c.add_loop(corners);
    for (const auto& facet : facets_of_corners<M>(static_cast<unsigned>(loop.size()))) {
      corners.clear();
      if constexpr (arity_v<M> == 8) {  // the facet of the copy is the bottom
        for (const unsigned k : facet) corners.push_back(inner(k));
        for (const unsigned k : facet) corners.push_back(loop[k]);
      } else {
        for (const unsigned k : facet) corners.push_back(loop[k]);
        // seen from the new vert, the facet runs the other way
        if constexpr (dimension_v<M> == 3) std::swap(corners[1], corners[2]);
        corners.push_back(inner(facet.back()));
        if (has_copy) corners.push_back(inner(facet.front()));
      }
      c.add_loop(corners);
    }
  }
  return c;
}

/// The parts of a poly again as one, as `whole` lists it; the new verts of the parts are removed.
template<EditableMesh M>
built_cavity<M> joined_parts(const M&, const built_cavity<M>& parts, const built_cavity<M>& whole) {
  built_cavity<M> c = whole;
  c.polys = parts.new_polys;
  c.kept = 1;
  c.verts.insert(c.verts.end(), parts.new_verts.begin(), parts.new_verts.end());
  c.removed = parts.new_verts.size();
  return c;
}

}  // namespace concino::testing::detail
