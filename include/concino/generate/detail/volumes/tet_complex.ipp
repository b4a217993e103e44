// Bodies of tet_complex.hpp: the tets that a back end returned: the parts into which the surface and the facets divide
// them, and whether they keep what was promised.
#pragma once

#include <concino/core/error.hpp>
#include <concino/generate/detail/volumes/tet_complex.hpp>
#include <concino/geometry/orientation.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace concino::detail {

CONCINO_INLINE tet_complex::tet_complex(const closed_surface& surface, tetrahedralize_output output,
                                        const char* back_end, bool keeps_points)
    : surface_(surface), back_end_(back_end) {
  const std::vector<vec3>& given = surface.input.points;
  if (keeps_points &&
      (output.points.size() < given.size() || !std::equal(given.begin(), given.end(), output.points.begin())))
    throw_broken("other points than it was given");
  if (output.tets.empty()) throw_broken("no tets");
  take_tets(output);
  find_facets(output);
}

CONCINO_INLINE void tet_complex::throw_broken(const char* what) const {
  core::throw_joined<unsupported>(
      {"tetrahedralize: ", back_end_, " returned ", what, "; keep_boundary = false or another back end may help"});
}

CONCINO_INLINE void tet_complex::take_tets(tetrahedralize_output& output) {
  cell_arrays a;
  a.points = std::move(output.points);
  a.verts.reserve(4 * output.tets.size());
  const std::vector<vec3>& p = a.points;
  for (auto& t : output.tets) {
    for (const std::uint32_t v : t)
      if (v >= p.size()) throw_broken("a tet with a point that does not exist");
    const int sign = orient3d(p[t[0]], p[t[1]], p[t[2]], p[t[3]]);
    if (sign == 0) throw_broken("a tet without volume");
    if (sign < 0) std::swap(t[2], t[3]);
    for (const std::uint32_t v : t) a.verts.push_back(vert_id{v});
  }
  mesh_ = tetmesh(std::move(a));
  for (const face_id f : faces(mesh_))
    if (adj_f2p(mesh_, f).size() > 2) throw_broken("a face of more than two tets");
}

CONCINO_INLINE void tet_complex::find_facets(const tetrahedralize_output& output) {
  if (output.facets.size() != output.triangle_of_facet.size()) throw_broken("facets without triangles");
  triangle_of_face_.assign(face_index_bound(mesh_), none);
  const auto sorted = [](std::array<std::uint32_t, 3> f) {
    std::sort(f.begin(), f.end());
    return f;
  };
  for (std::size_t i = 0; i < output.facets.size(); ++i) {
    const auto wanted = sorted(output.facets[i]);
    if (wanted[2] >= num_verts(mesh_) || output.triangle_of_facet[i] >= surface_.input.triangles.size())
      throw_broken("a facet with a point or a triangle that does not exist");
    for (const face_id f : adj_v2f(mesh_, vert_id{wanted[0]})) {
      std::array<std::uint32_t, 3> corners;
      std::size_t n = 0;
      for (const vert_id v : adj_f2v(mesh_, f)) corners[n++] = v.raw();
      if (sorted(corners) == wanted) triangle_of_face_[f.raw()] = output.triangle_of_facet[i];
    }  // facets that are no faces lie outside of the hull
  }
}

// 1 if the triangle of the surface that contains face f is counter-clockwise seen from outside of tet p, otherwise -1.
CONCINO_INLINE int tet_complex::change_inwards(poly_id p, face_id f) const {
  const auto& t = surface_.input.triangles[triangle(f)];
  const std::vector<vec3>& q = surface_.input.points;
  vec3 corners[3];
  std::size_t n = 0;
  for (const vert_id v : adj_f2v(mesh_, f)) corners[n++] = point(mesh_, v);
  const bool alike =
      dot(cross(corners[1] - corners[0], corners[2] - corners[0]), cross(q[t[1]] - q[t[0]], q[t[2]] - q[t[0]])) > 0;
  return alike == face_is_outward(mesh_, p, f) ? 1 : -1;
}

CONCINO_INLINE std::vector<int> tet_complex::winding_numbers() const {
  constexpr int unknown = 1 << 30;
  std::vector<int> winding(num_polys(mesh_), unknown);
  std::vector<poly_id> queue;
  const auto reach = [&](poly_id p, int w) {
    if (winding[p.raw()] == unknown) queue.push_back(p), winding[p.raw()] = w;
    else if (winding[p.raw()] != w) throw_broken("tets on a side of the surface where they cannot be");
  };
  for (const face_id f : faces(mesh_)) {
    const auto beside = adj_f2p(mesh_, f);
    if (beside.size() != 1) continue;
    if (!is_of_surface(f)) throw_broken("a boundary that is not the surface");
    reach(*beside.begin(), change_inwards(*beside.begin(), f));
    while (!queue.empty()) {
      const poly_id p = queue.back();
      queue.pop_back();
      for (const face_id g : adj_p2f(mesh_, p))
        for (const poly_id other : adj_f2p(mesh_, g))
          if (other != p) reach(other, winding[p.raw()] - (is_of_surface(g) ? change_inwards(p, g) : 0));
    }
  }
  return winding;
}

CONCINO_INLINE std::vector<poly_id> tet_complex::part_at(const vec3& q) const {
  std::vector<poly_id> part;
  for (const poly_id p : polys(mesh_)) {
    vec3 corners[4];
    std::size_t n = 0;
    for (const vert_id v : adj_p2v(mesh_, p)) corners[n++] = point(mesh_, v);
    const auto &[a, b, c, d] = corners;
    if (orient3d(q, b, c, d) >= 0 && orient3d(a, q, c, d) >= 0 && orient3d(a, b, q, d) >= 0 &&
        orient3d(a, b, c, q) >= 0) {
      part.push_back(p);
      break;
    }
  }
  std::vector<unsigned char> seen(num_polys(mesh_), 0);
  if (!part.empty()) seen[part[0].raw()] = 1;
  for (std::size_t k = 0; k < part.size(); ++k) {
    const poly_id p = part[k];
    for (const face_id f : adj_p2f(mesh_, p))
      for (const poly_id other : adj_f2p(mesh_, f))
        if (triangle(f) == none && !seen[other.raw()]) seen[other.raw()] = 1, part.push_back(other);
  }
  return part;
}

CONCINO_INLINE void tet_complex::check_boundary(bool keep) const {
  const std::vector<vec3>& q = surface_.input.points;
  std::vector<double> area(surface_.input.surface_triangles, 0);
  std::vector<std::uint32_t> count(area.size(), 0);
  for (const face_id f : faces(mesh_)) {
    if (!is_of_surface(f)) continue;
    const auto& t = surface_.input.triangles[triangle(f)];
    vec3 corners[3];
    std::size_t n = 0, shared = 0;
    for (const vert_id v : adj_f2v(mesh_, f)) {
      corners[n++] = point(mesh_, v);
      shared += std::count(t.begin(), t.end(), v.raw()) == 1;
    }
    area[triangle(f)] += norm(cross(corners[1] - corners[0], corners[2] - corners[0]));
    count[triangle(f)] += keep && shared < 3 ? 2 : 1;
  }
  for (std::size_t i = 0; i < area.size(); ++i) {
    const auto& t = surface_.input.triangles[i];
    const vec3 u = q[t[1]] - q[t[0]], v = q[t[2]] - q[t[0]];
    const double longest = std::max({dot(u, u), dot(v, v), dot(u - v, u - v)});
    if (count[i] == 0 || (keep && count[i] != 1) || !(std::abs(area[i] - norm(cross(u, v))) <= 1e-9 * longest))
      throw_broken("a boundary that is not the surface");
  }
}

}  // namespace concino::detail
