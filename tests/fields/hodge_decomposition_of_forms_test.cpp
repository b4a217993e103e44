#include <concino/fields/hodge_decomposition_of_forms.hpp>

#include <concino/generate/torus.hpp>

#include <support/closed_surfaces.hpp>
#include <support/kinds.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <set>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M>
edge_map<M, double> random_form(const M& m, unsigned seed) {
  std::mt19937 random(seed);
  auto a = make_edge_map<double>(m);
  for (const auto e : edges(m)) a[e] = static_cast<double>(random()) * 0x1p-31 - 1;
  return a;
}

/// The inner product of the header, from the vectors and what they leave over.
template<class M, class A, class B>
double product(const M& m, const A& a, const B& b) {
  const auto u = form_vectors(m, a), w = form_vectors(m, b);
  double sum = 0;
  for (const auto p : polys(m)) {
    sum += measure(m, p) * dot(u[p], w[p]);
    for (const auto e : adj_p2e(m, p)) {
      const auto ends = end_verts(m, e);
      const vec3 step = to_vec3(point(m, ends.second)) - to_vec3(point(m, ends.first));  // vectors lie in the plane of the poly
      sum += (a[e] - dot(step, u[p])) * (b[e] - dot(step, w[p]));
    }
  }
  return sum;
}

/// The greatest sum around a poly.
template<class M, class A>
double curl(const M& m, const A& a) {
  double largest = 0;
  for (const auto p : polys(m)) {
    double sum = 0;
    auto it = adj_p2v(m, p).begin();
    for (const auto e : adj_p2e(m, p)) {
      sum += end_verts(m, e).first == *it ? a[e] : -a[e];
      ++it;
    }
    largest = std::max(largest, std::abs(sum));
  }
  return largest;
}

template<class M>
void check_parts(const M& m, std::size_t dimension) {
  const auto a = random_form(m, 5);
  const auto h = hodge_decomposition(m, a);
  CHECK(h.harmonic_dimension == dimension);
  const double size = product(m, a, a);
  CHECK(std::abs(product(m, h.exact, h.coexact)) < 1e-10 * size);
  CHECK(std::abs(product(m, h.exact, h.harmonic)) < 1e-10 * size);
  CHECK(std::abs(product(m, h.coexact, h.harmonic)) < 1e-10 * size);
  CHECK(product(m, h.exact, h.exact) + product(m, h.coexact, h.coexact) + product(m, h.harmonic, h.harmonic) == doctest::Approx(size));
  CHECK(curl(m, h.exact) < 1e-12);
  CHECK(curl(m, h.harmonic) < 1e-9);
  for (const auto e : edges(m)) {
    const auto ends = end_verts(m, e);
    CHECK(std::abs(h.exact[e] + h.coexact[e] + h.harmonic[e] - a[e]) < 1e-12);
    CHECK(std::abs(h.potential[ends.second] - h.potential[ends.first] - h.exact[e]) < 1e-12);
  }
  const auto again = hodge_decomposition(m, h.coexact);
  CHECK(product(m, again.exact, again.exact) + product(m, again.harmonic, again.harmonic) < 1e-18 * size);
}

}  // namespace

TEST_CASE("hodge_decomposition of forms: on closed surfaces of quads the harmonic forms have dimension 2 g") {
  for (unsigned genus = 0; genus <= 5; ++genus) {
    std::set<voxel> voxels;  // a plate with holes
    for (int i = 0; i < static_cast<int>(2 * genus + 1); ++i)
      for (int j = 0; j < 3; ++j)
        if (!(i % 2 == 1 && j == 1)) voxels.insert({i, j, 0});
    check_parts(quadmesh(voxel_skin(voxels)), 2 * genus);
  }
  check_parts(quadmesh(jittered(voxel_skin({{0, 0, 0}, {1, 0, 0}}), 0.1, true)), 0);  // quads that are not planar
}

TEST_CASE("hodge_decomposition of forms: concave polygons, open surfaces, triangles; integrals of constant fields give the fields back") {
  const polygonmesh m(polygon_grid(3));
  check_parts(m, 0);
  auto ring = with_offsets(quad_grid(3));
  ring.verts.erase(ring.verts.begin() + 16, ring.verts.begin() + 20);  // without the quad in the middle
  ring.offsets.pop_back();
  check_parts(polygonmesh(ring), 1);
  const polygonmesh triangles(with_offsets(triangle_grid(3)));
  check_parts(triangles, 0);
  auto form = make_edge_map<double>(m);
  const vec3 field{2, -3, 0};
  for (const auto e : edges(m)) {
    const auto ends = end_verts(m, e);
    form[e] = dot(field, to_vec3(point(m, ends.second)) - to_vec3(point(m, ends.first)));
  }
  const auto vectors = form_vectors(m, form);
  for (const auto p : polys(m)) CHECK(distance(vectors[p], field) < 1e-12);
  const auto parts = hodge_decomposition(m, form);
  for (const auto e : edges(m)) CHECK(std::abs(parts.exact[e] - form[e]) < 1e-11);
}

TEST_CASE("hodge_decomposition of forms: any scale, empty meshes, and errors") {
  const auto quads = quad_grid(3);
  for (const int exponent : {-300, 300}) {
    auto arrays = quads;
    for (vec3& x : arrays.points) x *= std::ldexp(1.0, exponent);
    const quadmesh large(arrays), unit(quads);
    const auto a = hodge_decomposition(large, random_form(large, 1)), b = hodge_decomposition(unit, random_form(unit, 1));
    for (const auto e : edges(unit)) CHECK(a.coexact[e] == b.coexact[e]);
  }
  const quadmesh none;
  CHECK(hodge_decomposition(none, make_edge_map<double>(none)).harmonic_dimension == 0);
  CHECK(form_vectors(none, make_edge_map<double>(none)).values().empty());
  const quadmesh m(quads);
  auto wrong = make_edge_map<double>(m);
  wrong[edge_id{4}] = std::nan("");
  CHECK_THROWS_WITH_AS(hodge_decomposition(m, wrong), doctest::Contains("the value at edge 4 is not finite"), invalid_argument);
  const quadmesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 1, 2, 3}});
  CHECK_THROWS_AS(hodge_decomposition(flat, make_edge_map<double>(flat)), invalid_mesh);
  CHECK_THROWS_WITH_AS(form_vectors(flat, make_edge_map<double>(flat)), doctest::Contains("form_vectors: poly 0 has no area"), invalid_mesh);
}

TEST_CASE("hodge_decomposition of forms: edges of no poly, and ranges that own their elements") {
  auto m = user_mesh::surface_example();
  m.es.push_back({0, 7});
  auto differences = make_edge_map<double>(m, 0.0);
  for (const auto e : edges(m)) {
    const auto [a, b] = end_verts(m, e);
    differences[e] = point(m, b)[0] - point(m, a)[0];
  }
  const auto parts = hodge_decomposition(m, differences);
  for (const auto e : edges(m))
    if (num_elements(adj_e2p(m, e)) > 0) CHECK(parts.exact[e] == doctest::Approx(differences[e]));
}
