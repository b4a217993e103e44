#include <concino/fields/hodge_decomposition.hpp>

#include <concino/edit/elements.hpp>
#include <concino/operators/rotated.hpp>

#include <support/closed_surfaces.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string_view>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M>
poly_map<M, vec3> random_field(const M& m, unsigned seed) {
  std::mt19937 random(seed);
  const auto next = [&] { return static_cast<double>(random()) * 0x1p-31 - 1; };
  auto g = make_poly_map<vec3>(m);
  for (const auto p : polys(m)) {
    const double x = next(), y = next(), z = next();
    g[p] = {x, y, z};
  }
  return g;
}

template<class M, class A, class B>
double product(const M& m, const A& a, const B& b) {
  double sum = 0;
  for (const auto p : polys(m)) sum += std::abs(measure(m, p)) * dot(a[p], b[p]);
  return sum;
}

/// The laws of the header for a random field.
template<class M>
hodge_parts<M> check_parts(const M& m, std::size_t dimension) {
  const auto g = random_field(m, 7);
  const auto h = hodge_decomposition(m, g);
  CHECK(h.harmonic_dimension == dimension);
  const double size = product(m, g, g);
  CHECK(std::abs(product(m, h.exact, h.coexact)) < 1e-10 * size);
  CHECK(std::abs(product(m, h.exact, h.harmonic)) < 1e-10 * size);
  CHECK(std::abs(product(m, h.coexact, h.harmonic)) < 1e-10 * size);
  if (dimension > 0) CHECK(product(m, h.harmonic, h.harmonic) > 1e-8 * size);
  const auto exact = gradient(m, h.potential);
  for (const auto p : polys(m)) {
    vec3 whole = g[p];
    if constexpr (SurfaceMesh<M>) whole -= dot(normal(m, p), whole) * normal(m, p);
    CHECK(distance(h.exact[p] + h.coexact[p] + h.harmonic[p], whole) < 1e-12);
    CHECK(distance(exact[p], h.exact[p]) < 1e-10);
  }
  const auto again = hodge_decomposition(m, h.harmonic);
  CHECK(product(m, again.exact, again.exact) + product(m, again.coexact, again.coexact) < 1e-18 * size);
  return h;
}

/// A plate of voxels with holes through it, as triangles.
trimesh plate(unsigned genus) {
  std::set<voxel> voxels;
  for (int i = 0; i < static_cast<int>(2 * genus + 1); ++i)
    for (int j = 0; j < 3; ++j)
      if (!(i % 2 == 1 && j == 1)) voxels.insert({i, j, 0});
  const surface_arrays quads = voxel_skin(voxels);
  surface_arrays triangles{quads.points, {}, {}, 3};
  for (std::size_t k = 0; k < quads.verts.size(); k += 4)
    for (const std::size_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) triangles.verts.push_back(quads.verts[k + corner]);
  return trimesh(triangles);
}

}  // namespace

TEST_CASE("hodge_decomposition: on closed surfaces the harmonic fields have dimension 2 g") {
  for (unsigned genus = 0; genus <= 5; ++genus) check_parts(plate(genus), 2 * genus);
}

TEST_CASE("hodge_decomposition: on surfaces with b boundary loops they have dimension 2 g + b - 1 in each component") {
  for (const unsigned genus : {0u, 2u})
    for (unsigned loops = 1; loops <= 3; ++loops) {
      trimesh m = plate(genus);
      std::set<unsigned> met;  // the triangles removed have no common verts
      for (unsigned k = 0; k < loops; ++k)
        for (const auto p : polys(m)) {
          std::vector<unsigned> corners;
          for (const auto v : adj_p2v(m, p)) corners.push_back(v.raw());
          if (std::any_of(corners.begin(), corners.end(), [&](unsigned v) { return met.count(v) > 0; })) continue;
          met.insert(corners.begin(), corners.end());
          remove_poly(m, p);
          break;
        }
      check_parts(m, 2 * genus + loops - 1);
    }
  check_parts(two_grids<trimesh>(3), 0);
}

TEST_CASE("hodge_decomposition: of tets: 0 in a ball, 1 in a solid torus, 2 with two holes, 0 around a cavity") {
  check_parts(grid<tetmesh>(2), 0);
  const auto with_holes = [](std::vector<unsigned> blocks, unsigned n) {  // six tets for each block
    auto arrays = tet_grid(n);
    auto kept = arrays.verts;
    kept.clear();
    for (unsigned b = 0; b < n * n * n; ++b)
      if (std::find(blocks.begin(), blocks.end(), b) == blocks.end()) kept.insert(kept.end(), arrays.verts.begin() + 24 * b, arrays.verts.begin() + 24 * (b + 1));
    arrays.verts = kept;
    return tetmesh(arrays);
  };
  check_parts(with_holes({13}, 3), 0);
  check_parts(with_holes({4, 13, 22}, 3), 1);
  check_parts(with_holes({10, 14, 12, 4, 22, 13, 16}, 3), 5);  // tunnels along the three axes meet in the middle
}

TEST_CASE("hodge_decomposition: rotated gradients of functions at edges, 0 on the boundary, are coexact; gradients are exact") {
  trimesh m(jittered(triangle_grid(5), 0.02, true));
  remove_poly(m, *polys(m).begin());
  remove_poly(m, poly_id{24});
  std::mt19937 random(3);
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = static_cast<double>(random() % 100);
  const auto g = gradient(m, u);
  const auto exact = hodge_decomposition(m, g);
  for (const auto p : polys(m)) CHECK(distance(exact.exact[p], g[p]) < 1e-9);

  auto at_edges = make_edge_map<double>(m);
  for (const auto e : edges(m)) at_edges[e] = is_boundary(m, e) ? 0 : static_cast<double>(random() % 100);
  auto turned = make_poly_map<vec3>(m);
  simplex_gradients<trimesh> local;
  for (const auto p : polys(m)) {
    local.visit(m, p);
    std::size_t k = 0;
    for (const auto e : adj_p2e(m, p)) turned[p] += -2 * at_edges[e] * local.gradient[(k++ + 2) % 3];  // edge k is opposite to vert k + 2
  }
  turned = rotated(m, turned);
  const auto coexact = hodge_decomposition(m, turned);
  CHECK(coexact.harmonic_dimension == 1);
  for (const auto p : polys(m)) CHECK(distance(coexact.coexact[p], turned[p]) < 1e-9);
}

TEST_CASE("hodge_decomposition: polygons that are triangles, any scale, empty meshes, and errors") {
  const auto triangles = triangle_grid(3);
  const polygonmesh m(with_offsets(triangles));
  check_parts(m, 0);
  for (const int exponent : {-300, 300}) {
    auto arrays = triangles;
    for (vec3& x : arrays.points) x *= std::ldexp(1.0, exponent);
    const trimesh large(arrays), unit(triangles);
    const auto a = hodge_decomposition(large, random_field(large, 1)), b = hodge_decomposition(unit, random_field(unit, 1));
    for (const auto p : polys(unit)) CHECK(a.coexact[p] == b.coexact[p]);
    for (const auto v : verts(unit)) CHECK(a.potential[v] == std::ldexp(b.potential[v], exponent));
  }
  const trimesh none;
  CHECK(hodge_decomposition(none, make_poly_map<vec3>(none)).harmonic_dimension == 0);
  const polygonmesh quads(with_offsets(quad_grid(2)));
  CHECK_THROWS_WITH_AS(hodge_decomposition(quads, make_poly_map<vec3>(quads)), doctest::Contains("poly 0 has 4 verts; all polys must be triangles"), unsupported);
  auto wrong = make_poly_map<vec3>(m);
  wrong[poly_id{4}].y = std::nan("");
  CHECK_THROWS_WITH_AS(hodge_decomposition(m, wrong), doctest::Contains("the vector at poly 4 is not finite"), invalid_argument);
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  CHECK_THROWS_AS(hodge_decomposition(flat, make_poly_map<vec3>(flat)), invalid_mesh);
  hodge_options stop;
  stop.progress = [](double, std::string_view) { return false; };
  CHECK_THROWS_AS(hodge_decomposition(m, make_poly_map<vec3>(m), stop), cancelled);
}
