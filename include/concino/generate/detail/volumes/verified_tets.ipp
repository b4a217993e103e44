// Bodies of verified_tets.hpp: what tetrahedralize() returns is verified here: positive tets, the surface as their
// boundary, the enclosed volume.
#pragma once

#include <concino/core/error.hpp>
#include <concino/generate/detail/volumes/tet_complex.hpp>
#include <concino/generate/detail/volumes/verified_tets.hpp>
#include <concino/geometry/bounding_tree.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/trimesh.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace concino::detail {

/// The result without the tets that are dropped, and without verts that no tet has. `region`, unless empty, has a
/// number for each tet.
inline verified_tets kept_tets(tet_complex& c, std::size_t num_given, const std::vector<unsigned char>& dropped,
                               const std::vector<std::uint32_t>& region) {
  verified_tets result;
  tetmesh& all = c.mesh();
  std::vector<std::uint32_t> number(num_verts(all), verified_tets::no_vert);
  std::size_t used = 0, kept = 0;
  for (const poly_id p : polys(all)) {
    if (dropped[p.raw()]) continue;
    ++kept;
    for (const vert_id v : adj_p2v(all, p)) used += std::exchange(number[v.raw()], 0) == verified_tets::no_vert;
    if (!region.empty()) result.region_of_poly.push_back(region[p.raw()]);
  }
  if (kept == 0) throw invalid_argument("tetrahedralize: holes leave no tet");
  std::uint32_t next = 0;
  for (std::uint32_t& n : number)
    if (n != verified_tets::no_vert) n = next++;
  if (kept == num_polys(all) && used == num_verts(all)) {
    result.mesh = std::move(all);
    for (const face_id f : faces(result.mesh)) result.triangle_of_face.push_back(c.triangle(f));
  } else {
    cell_arrays a;
    a.points.resize(used);
    a.verts.reserve(4 * kept);
    for (const vert_id v : verts(all))
      if (number[v.raw()] != verified_tets::no_vert) a.points[number[v.raw()]] = point(all, v);
    for (const poly_id p : polys(all))
      if (!dropped[p.raw()])
        for (const vert_id v : adj_p2v(all, p)) a.verts.push_back(vert_id{number[v.raw()]});
    result.mesh = tetmesh(std::move(a));
    result.triangle_of_face.assign(face_index_bound(result.mesh), verified_tets::no_triangle);
    std::uint32_t copy = 0;
    for (const poly_id p : polys(all)) {
      if (dropped[p.raw()]) continue;
      auto f = adj_p2f(result.mesh, poly_id{copy++}).begin();  // the faces of a tet have the order that its corners
                                                               // give
      for (const face_id old : adj_p2f(all, p)) result.triangle_of_face[(*f++).raw()] = c.triangle(old);
    }
  }
  number.resize(num_given);
  result.vert_of_point = std::move(number);
  return result;
}

CONCINO_INLINE verified_tets verified(const closed_surface& surface, tetrahedralize_output output,
                                      const tetrahedralize_options& o, const char* back_end) {
  tet_complex c(surface, std::move(output), back_end);
  const tetmesh& m = c.mesh();
  c.check_boundary(o.keep_boundary);
  const std::vector<int> winding = c.winding_numbers();
  double volume = 0, size = 0;
  std::vector<unsigned char> dropped(num_polys(m), 0);
  for (const poly_id p : polys(m)) {
    vec3 q[4];
    std::size_t n = 0;
    for (const vert_id v : adj_p2v(m, p)) q[n++] = point(m, v);
    const double measure = winding[p.raw()] * dot(q[1] - q[0], cross(q[2] - q[0], q[3] - q[0])) / 6;
    volume += measure;
    size += std::abs(measure);
    dropped[p.raw()] = winding[p.raw()] == 0;
  }
  if (!(std::abs(volume - surface.volume) <= 1e-9 * size))
    c.throw_broken("tets that do not have the volume that the surface encloses");
  const auto part_at = [&](const char* what, std::size_t k, const vec3& q) {
    std::vector<poly_id> part = c.part_at(q);
    if (part.empty() || winding[part[0].raw()] == 0)
      core::throw_joined<invalid_argument>({"tetrahedralize: the point of ", what, k, " is not inside of the surface"});
    return part;
  };
  for (std::size_t k = 0; k < o.holes.size(); ++k)
    for (const poly_id p : part_at("hole ", k, o.holes[k])) dropped[p.raw()] = 1;
  std::vector<std::uint32_t> region(o.regions.empty() ? 0 : num_polys(m), verified_tets::no_region);
  for (std::uint32_t k = 0; k < o.regions.size(); ++k)
    for (const poly_id p : part_at("region ", k, o.regions[k].inside)) region[p.raw()] = k;
  return kept_tets(c, surface.input.points.size(), dropped, region);
}

CONCINO_INLINE verified_tets verified_approximation(const closed_surface& surface, tetrahedralize_output output,
                                                    double distance, const char* back_end) {
  tet_complex c(surface, std::move(output), back_end, false);
  const std::vector<vec3>& given = surface.input.points;
  surface_arrays a;
  a.points = given;
  a.arity = 3;
  double area = 0;
  for (const auto& t : surface.input.triangles) {
    for (const std::uint32_t v : t) a.verts.push_back(vert_id{v});
    area += norm(cross(given[t[1]] - given[t[0]], given[t[2]] - given[t[0]])) / 2;
  }
  if (!(std::abs(total_measure(c.mesh()) - std::abs(surface.volume)) <= area * distance))
    c.throw_broken("tets whose volume is too far from the enclosed one");
  const trimesh triangles(std::move(a));
  const auto tree = bounding_tree(triangles);
  verified_tets result;
  result.triangle_of_face.assign(face_index_bound(c.mesh()), verified_tets::no_triangle);
  for (const face_id f : faces(c.mesh())) {
    if (!is_boundary(c.mesh(), f)) continue;
    for (const vert_id v : adj_f2v(c.mesh(), f))
      if (!(tree.closest(point(c.mesh(), v)).distance <= distance))
        c.throw_broken("a boundary too far from the surface");
    result.triangle_of_face[f.raw()] = tree.closest(centroid(c.mesh(), f)).poly.raw();
  }
  const auto key = [](const vec3& p) { return std::array<double, 3>{p.x, p.y, p.z}; };
  std::vector<std::pair<std::array<double, 3>, std::uint32_t>> places;
  for (const vert_id v : verts(c.mesh())) places.push_back({key(point(c.mesh(), v)), v.raw()});
  std::sort(places.begin(), places.end());
  for (const vec3& p : given) {
    const auto at = std::lower_bound(places.begin(), places.end(), std::pair(key(p), std::uint32_t{0}));
    result.vert_of_point.push_back(at != places.end() && at->first == key(p) ? at->second : verified_tets::no_vert);
  }
  result.mesh = std::move(c.mesh());
  return result;
}

}  // namespace concino::detail
