// Checks of subdivided meshes that do not depend on the scheme.
#pragma once

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/subdivide_options.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/property.hpp>

#include <support/generated.hpp>
#include <support/same_mesh.hpp>

#include <doctest/doctest.h>

namespace concino::testing {

/// The volume inside a closed surface.
template<SurfaceMesh M>
double enclosed_volume(const M& m) {
  double sum = 0;
  for (const poly_t<M> p : polys(m)) {
    std::vector<vec3> x;
    for (const vert_t<M> v : adj_p2v(m, p)) x.push_back(to_vec3(point(m, v)));
    for (std::size_t k = 1; k + 1 < x.size(); ++k) sum += dot(x[0], cross(x[k], x[k + 1])) / 6;
  }
  return sum;
}

/// Gives m a property of each kind that shows how values are transferred.
template<class M>
void add_properties(M& m) {
  const auto place = vert_property<vec3>(m, "place");
  for (const vert_t<M> v : verts(m)) place[v] = to_vec3(point(m, v));
  const auto name = poly_property<int>(m, "name");
  for (const poly_t<M> p : polys(m)) name[p] = 10 + static_cast<int>(p.raw());
  const auto mass = poly_property<double>(m, "mass");
  set_property_rule(m, element_kind::poly, "mass", property_rule::sum);
  for (const poly_t<M> p : polys(m)) mass[p] = measure(m, p);
  const auto crease = edge_property<int>(m, "crease");
  for (const edge_t<M> e : edges(m)) crease[e] = 1 + static_cast<int>(e.raw());
}

/// Checks the properties, the correspondence, repetition and the archetype for a subdivision: subdivide(mesh, options). keeps_edges: each edge of m is one of the
/// result, or several in a row. needs_arity: the concept is TetMesh or HexMesh.
template<bool needs_arity = false, class M, class Subdivide>
void check_subdivision(M m, const Subdivide& subdivide, bool keeps_edges = true) {
  add_properties(m);
  correspondence c;
  const auto s = subdivide(m, subdivide_options{.correspondence = &c});
  using S = std::remove_cvref_t<decltype(s)>;
  CHECK(check_laws(s).empty());
  // The points and a property with the values of the points follow by the same weights.
  const auto place = find_vert_property<vec3>(s, "place");
  REQUIRE(place);
  for (const vert_id v : verts(s)) CHECK(norm(place[v] - point(s, v)) < 1e-14);
  const auto name = find_poly_property<int>(s, "name");
  const auto mass = find_poly_property<double>(s, "mass");
  double whole = 0, parts = 0;
  for (const poly_t<M> p : polys(m)) whole += find_poly_property<double>(m, "mass")[p];
  for (const poly_id p : polys(s)) {
    parts += mass[p];
    REQUIRE(!c.polys[p.raw()].empty());
    bool is_of_name = false;
    for (const origin x : c.polys[p.raw()]) is_of_name = is_of_name || name[p] == 10 + static_cast<int>(x.index);
    CHECK(is_of_name);
  }
  CHECK(parts == doctest::Approx(whole).epsilon(1e-12));
  // Each edge of m is made into edges whose parts of it add up to 1.
  auto part = make_edge_map<double>(m, 0.0);
  for (std::size_t i = 0; i < c.edges.size(); ++i)
    for (const origin x : c.edges[i]) part[edge_t<M>{x.index}] += x.weight;
  for (const edge_t<M> e : edges(m)) CHECK((part[e] == doctest::Approx(1).epsilon(1e-14) || !keeps_edges));
  const auto crease = find_edge_property<int>(s, "crease");
  for (const edge_id e : edges(s)) CHECK(crease[e] == (c.edges[e.raw()].empty() ? 0 : 1 + static_cast<int>(c.edges[e.raw()][0].index)));

  const auto bare = [&] {
    if constexpr (needs_arity) return only_fixed_arity_mesh(m);
    else return only_embedded_mesh(m);
  }();
  correspondence of_bare;
  const auto b = subdivide(bare, subdivide_options{.correspondence = &of_bare});
  const auto plain = subdivide(m, subdivide_options{.properties = false});
  CHECK(record_of(b) == record_of(plain));
  CHECK(of_bare.verts.size() == c.verts.size());
  CHECK(record_of(subdivide(bare, subdivide_options{})) == record_of(plain));

  const S empty = subdivide(M(), subdivide_options{.times = 2});
  CHECK(num_verts(empty) == 0);
  CHECK(num_polys(empty) == 0);
  CHECK_THROWS_WITH_AS(subdivide(m, subdivide_options{.times = 0}), doctest::Contains("times is 0; it must be at least 1"), invalid_argument);
  CHECK_THROWS_WITH_AS(subdivide(m, subdivide_options{.times = 40}), doctest::Contains("times asks for"), invalid_argument);

  // Twice at once is the same as twice in turn, and so is what is known of the elements.
  correspondence twice, second;
  const auto at_once = subdivide(m, subdivide_options{.times = 2, .correspondence = &twice});
  REQUIRE(twice.polys.size() == num_polys(at_once));
  const auto place_at_once = find_vert_property<vec3>(at_once, "place");
  for (const vert_id v : verts(at_once)) {
    vec3 x;
    double sum = 0;
    for (const origin o : twice.verts[v.raw()]) x += o.weight * to_vec3(point(m, vert_t<M>{o.index})), sum += o.weight;
    CHECK(sum == doctest::Approx(1).epsilon(1e-14));
    CHECK(norm(x - point(at_once, v)) < 1e-14);
    CHECK(norm(place_at_once[v] - point(at_once, v)) < 1e-14);
  }
}

}  // namespace concino::testing
