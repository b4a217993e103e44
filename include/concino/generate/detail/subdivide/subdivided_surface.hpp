// The polys of surfaces subdivided at the midpoints of edges: triangles in four, or a quad at each vert of a polygon.
#pragma once

#include <concino/concepts/oriented_edges.hpp>
#include <concino/generate/detail/subdivide/subdivision.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/trimesh.hpp>

namespace concino::detail {

/// Splits each triangle into one at each vert and one in the middle.
template<class M, class Creases, class Rule>
subdivided<trimesh> subdivide_in_four(const char* caller, const M& m, const Creases& creases, const Rule& rule,
                                      const subdivide_options& o) {
  using new_verts = refined_verts<M, refined_kinds{.edges = true}>;
  check_subdivided_counts<trimesh>(caller, new_verts::expected_size(m), 4.0 * static_cast<double>(num_polys(m)));
  const new_verts refined(m);
  surface_arrays a{{}, {}, {}, 3};
  a.verts.reserve(12 * num_polys(m));
  for (const poly_t<M> p : polys(m)) {
    const triangle_elements<M> parts(caller, m, p);
    const vert_id middles[] = {refined[parts.edges[0]], refined[parts.edges[1]], refined[parts.edges[2]]};
    for (unsigned k = 0; k < 3; ++k)
      a.verts.insert(a.verts.end(), {refined[parts.verts[k]], middles[k], middles[(k + 2) % 3]});
    a.verts.insert(a.verts.end(), middles, middles + 3);
  }
  a.points = refined_points(refined, rule);
  auto result = with_origins(trimesh(std::move(a)), refined, rule, o, [&] { return repeated_polys(m, 4); });
  result.has_crease = halved_creases(refined, creases, result.mesh);
  return result;
}

/// Splits each polygon into a quad at each of its verts.
template<class M, class Creases, class Rule>
subdivided<quadmesh> subdivide_in_quads(const char* caller, const M& m, const Creases& creases, const Rule& rule,
                                        const subdivide_options& o) {
  using new_verts = refined_verts<M, refined_kinds{.edges = true, .polys = true}>;
  const std::size_t corners = num_poly_corners(m);
  check_subdivided_counts<quadmesh>(caller, new_verts::expected_size(m), static_cast<double>(corners));
  const new_verts refined(m);
  surface_arrays a{{}, {}, {}, 4};
  a.verts.resize(4 * corners);
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
  auto result = with_origins(quadmesh(std::move(a)), refined, rule, o, [&] { return polys_of_corners(m, 1); });
  result.has_crease = halved_creases(refined, creases, result.mesh);
  return result;
}

}  // namespace concino::detail
