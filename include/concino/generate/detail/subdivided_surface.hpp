// The polys of surfaces subdivided at the midpoints of edges: triangles in four, or a quad at each vert of a polygon.
#pragma once

#include <concino/concepts/oriented_edges.hpp>
#include <concino/generate/detail/subdivision.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/trimesh.hpp>

namespace concino::detail {

/// Splits each triangle into one at each vert and one in the middle.
template<class M, class Creases, class Rule>
subdivided<trimesh> subdivide_in_four(const char* caller, const M& m, const Creases& creases, const Rule& rule, const subdivide_options& o) {
  check_element_counts<trimesh>(caller, "times", static_cast<double>(num_verts(m) + num_edges(m)), 2.0 * static_cast<double>(num_polys(m)));
  const refined_verts<M, refined_kinds{.edges = true}> refined(m);
  surface_arrays a{{}, {}, {}, 3};
  a.verts = core::large_vector(12 * num_polys(m), vert_id{});
  vert_id* next = a.verts.data();
  for (const poly_t<M> p : polys(m)) {
    const triangle_parts<M> t(caller, m, p);
    const vert_id v[] = {refined[t.verts[0]], refined[t.verts[1]], refined[t.verts[2]]};
    const vert_id e[] = {refined[t.edges[0]], refined[t.edges[1]], refined[t.edges[2]]};
    for (const vert_id x : {v[0], e[0], e[2], e[0], v[1], e[1], e[2], e[1], v[2], e[0], e[1], e[2]}) *next++ = x;
  }
  a.points = refined_points(refined, rule);
  subdivided<trimesh> result{trimesh(std::move(a))};
  if (wants_origins(m, o)) {
    result.from.polys = repeated_polys(m, 4);
    set_origins(refined, rule, o, result);
  }
  result.has_crease = halved_creases(refined, creases, result.mesh);
  return result;
}

/// Splits each polygon into a quad at each of its verts.
template<class M, class Creases, class Rule>
subdivided<quadmesh> subdivide_in_quads(const char* caller, const M& m, const Creases& creases, const Rule& rule, const subdivide_options& o) {
  std::size_t corners = 0;
  for (const poly_t<M> p : polys(m)) corners += num_elements(adj_p2v(m, p));
  check_element_counts<quadmesh>(caller, "times", static_cast<double>(num_verts(m) + num_edges(m) + num_polys(m)), static_cast<double>(corners));
  const refined_verts<M, refined_kinds{.edges = true, .polys = true}> refined(m);
  surface_arrays a{{}, {}, {}, 4};
  a.verts = core::large_vector(4 * corners, vert_id{});
  vert_id* next = a.verts.data();
  for (const poly_t<M> p : polys(m)) {
    const vert_id centre = refined[p];
    vert_id* const first = next;
    vert_id before{};
    for (const auto& [e, from, to] : oriented_edges(m, p)) {
      const vert_id middle = refined[e];
      next[0] = refined[from], next[1] = middle, next[2] = centre, next[3] = before;
      before = middle;
      next += 4;
    }
    if (next != first) first[3] = before;
  }
  a.points = refined_points(refined, rule);
  subdivided<quadmesh> result{quadmesh(std::move(a))};
  if (wants_origins(m, o)) {
    result.from.polys = polys_of_corners(m, 1);
    set_origins(refined, rule, o, result);
  }
  result.has_crease = halved_creases(refined, creases, result.mesh);
  return result;
}

}  // namespace concino::detail
