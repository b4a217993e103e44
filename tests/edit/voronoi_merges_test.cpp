// Voronoi meshes of 1,000 polygons and 300 polyhedra, in long runs of 5,000, are merged to 50 and cut again at random: valid all the time, and linear
// functions stay exact for gradient and Laplacian.
#include <concino/edit.hpp>
#include <concino/generate/voronoi_polygons.hpp>
#include <concino/generate/voronoi_polyhedra.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh.hpp>
#include <concino/operators.hpp>

#include <support/corpus.hpp>
#include <support/random_poly_edits.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace cn = concino;
using namespace cn::testing;

namespace {

template<class M>
void is_valid(const M& m, const std::vector<std::ptrdiff_t>& facts, double size) {
  if (topology(m) != facts) FAIL("the topology changed");
  CHECK(std::abs(cn::total_measure(m) - size) < 1e-12 * size);
}

template<class M>
void linear_functions_are_exact(const M& m) {
  const cn::vec3 slope{0.7, -0.4, cn::VolumeMesh<M> ? 1.1 : 0.0};
  auto u = cn::make_vert_map<double>(m, 0);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(cn::vert_index_bound(m)));
  for (const auto v : cn::verts(m)) x[static_cast<Eigen::Index>(cn::index_of(m, v))] = u[v] = dot(slope, cn::to_vec3(cn::point(m, v))) + 0.3;
  double most = 0;
  const auto gradient = cn::gradient(m, u);
  for (const auto p : cn::polys(m)) most = std::max(most, norm(gradient[p] - slope));
  CHECK(most < 1e-6);
  const auto laplacian = cn::laplacian(m);
  const Eigen::VectorXd y = laplacian * x, scale = laplacian.cwiseAbs() * x.cwiseAbs();
  double inside = 0;
  std::vector<bool> at_boundary(cn::vert_index_bound(m), false);
  for (const auto f : cn::facets(m))
    if (cn::is_boundary(m, f))
      for (const auto v : cn::adj_facet2v(m, f)) at_boundary[cn::index_of(m, v)] = true;
  for (const auto v : cn::verts(m))
    if (const auto i = cn::index_of(m, v); !at_boundary[i]) inside = std::max(inside, std::abs(y[static_cast<Eigen::Index>(i)]) / (1e-300 + scale[static_cast<Eigen::Index>(i)]));
  CHECK(inside < 1e-8);
}

/// The edges around some of the faces of p, which grow from one face.
std::vector<cn::edge_id> some_loop(const cn::polyhedralmesh& m, cn::poly_id p, std::mt19937& random) {
  std::vector<cn::face_id> all, part;
  for (const auto f : cn::adj_p2f(m, p)) all.push_back(f);
  part.push_back(all[random() % all.size()]);
  const std::size_t wanted = 3 + random() % std::min<std::size_t>(all.size(), 60);
  for (std::size_t k = 0; k < part.size() && part.size() < wanted; ++k)
    for (const auto e : cn::adj_f2e(m, part[k]))
      for (const auto f : cn::adj_e2f(m, e))
        if (part.size() < wanted && std::find(all.begin(), all.end(), f) != all.end() && std::find(part.begin(), part.end(), f) == part.end()) part.push_back(f);
  std::vector<cn::edge_id> edges, once;
  for (const auto f : part)
    for (const auto e : cn::adj_f2e(m, f)) edges.push_back(e);
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size(); ++i)
    if ((i == 0 || edges[i - 1] != edges[i]) && (i + 1 == edges.size() || edges[i + 1] != edges[i])) once.push_back(edges[i]);
  return once;
}

template<class M>
void merge_and_cut(M m, std::size_t fewest) {
  std::mt19937 random(57);
  const auto facts = topology(m);
  const double size = cn::total_measure(m);
  const std::size_t before = cn::num_polys(m);
  unsigned done = 0, cuts = 0;
  const auto made = [&](const cn::permission& p) {
    if (p && ++done % 100 == 0) is_valid(m, facts, size);
    return bool(p);
  };
  while (cn::num_polys(m) > fewest) made(cn::merge_polys(m, some_element_of(m, cn::facets(m), cn::facet_index_bound(m), random)));
  CHECK(cn::num_polys(m) == fewest);
  foreign_laws_hold(m), is_valid(m, facts, size), linear_functions_are_exact(m);
  const unsigned tries = long_run() ? 4000 : 400;
  for (unsigned i = 0; i < tries; ++i) {
    const auto p = some_poly(m, random);
    if constexpr (cn::VolumeMesh<M>) {
      cuts += made(cn::poly_cut(m, p, some_loop(m, p, random), {.keep = {cn::no_inversion}}));
    } else {
      std::vector<cn::vert_id> v;
      for (const auto x : cn::adj_p2v(m, p)) v.push_back(x);
      cuts += made(cn::poly_cut(m, p, v[random() % v.size()], v[random() % v.size()], {.keep = {cn::no_inversion}}));
    }
  }
  CHECK(cuts > tries / 40);
  foreign_laws_hold(m), is_valid(m, facts, size), linear_functions_are_exact(m);
  MESSAGE(before << " cells, " << fewest << ", " << cn::num_polys(m) << " after cuts");
}

std::vector<cn::vec3> sites(unsigned n, bool in_space) {
  std::mt19937 random(5);
  std::vector<cn::vec3> x(n);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (auto& p : x) p = {number(), number(), in_space ? number() : 0};
  return x;
}

}  // namespace

TEST_CASE("Voronoi polygons are merged and cut") { merge_and_cut(cn::voronoi_polygons(sites(long_run() ? 5000 : 1000, false), {{0, 0, 0}, {1, 1, 0}}), 50); }
TEST_CASE("Voronoi polyhedra are merged and cut") { merge_and_cut(cn::voronoi_polyhedra(sites(long_run() ? 5000 : 300, true), {{0, 0, 0}, {1, 1, 1}}), 50); }
