// Poisson's equation with Neumann boundary conditions.
#include <concino/fields/poisson.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/solve/ldlt.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M> using fluxes = std::vector<std::pair<facet_t<M>, double>>;
template<class M> using values = std::vector<std::pair<vert_t<M>, double>>;

/// A grid with moved verts. Those on an edge of the square or a face of the cube stay on it.
template<class M>
M moved_grid(unsigned n, double amount) {
  auto a = grid_arrays<M>(n);
  const auto b = jittered(a, amount / n, VolumeMesh<M>, 3);
  for (std::size_t i = 0; i < a.points.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (a.points[i][k] != 0 && a.points[i][k] != 1) a.points[i][k] = b.points[i][k];
  return M(a);
}

/// Calls f(facet, mean of its verts, outward direction) for each facet on the boundary of the square or cube.
template<class M, class F>
void for_each_boundary_facet(const M& m, const F& f) {
  const auto visit = [&](const auto& x, const auto& polys, const auto& around) {
    int n = 0;
    for ([[maybe_unused]] const auto p : polys) ++n;
    if (n != 1) return;
    vec3 low{1, 1, 1}, high, sum;
    double count = 0;
    for (const auto v : around) {
      const vec3 at = to_vec3(point(m, v));
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], at[k]);
        high[k] = std::max(high[k], at[k]);
      }
      sum += at;
      count += 1;
    }
    vec3 out;
    for (std::size_t k = 0; k < dimension_v<M>; ++k) out[k] = high[k] == 0 ? -1 : low[k] == 1 ? 1 : 0;
    f(x, sum / count, out);
  };
  if constexpr (SurfaceMesh<M>)
    for (const auto e : edges(m)) visit(e, adj_e2p(m, e), adj_e2v(m, e));
  else
    for (const auto x : faces(m)) visit(x, adj_f2p(m, x), adj_f2v(m, x));
}

struct constant {
  double value;
  template<class V>
  double operator[](const V&) const { return value; }
};

/// The error for u = cos(pi x + 1) e^y (times z + 1 in volumes), with prescribed values where x = 0 and prescribed derivatives elsewhere.
template<class M>
double mixed_error(const M& m) {
  constexpr double pi = 3.14159265358979323846;
  const auto u_at = [](const vec3& x) { return std::cos(pi * x.x + 1) * std::exp(x.y) * (VolumeMesh<M> ? x.z + 1 : 1); };
  auto f = make_vert_map<double>(m);
  values<M> given;
  for (const auto v : verts(m)) {
    const vec3 x = to_vec3(point(m, v));
    f[v] = (pi * pi - 1) * u_at(x);
    if (x.x == 0) given.push_back({v, u_at(x)});
  }
  fluxes<M> across;
  for_each_boundary_facet(m, [&](const facet_t<M>& e, const vec3& x, const vec3& out) {
    const vec3 gradient{-pi * std::tan(pi * x.x + 1) * u_at(x), u_at(x), VolumeMesh<M> ? u_at(x) / (x.z + 1) : 0};
    across.push_back({e, dot(gradient, out)});
  });
  const auto u = poisson(m, f, {.values = given, .fluxes = across});
  const auto mass = vert_masses(m);
  double sum = 0;
  for (const auto v : verts(m)) {
    const double e = u[v] - u_at(to_vec3(point(m, v)));
    sum += mass[v] * e * e;
  }
  return std::sqrt(sum);
}

}  // namespace

TEST_CASE_TEMPLATE("poisson: reproduces linear functions from their fluxes and one value", M, CONCINO_KINDS) {
  const M m = moved_grid<M>(3, 0.2);
  const vec3 slope{2, -3, VolumeMesh<M> ? 5 : 0};
  fluxes<M> across;
  for_each_boundary_facet(m, [&](const facet_t<M>& e, const vec3&, const vec3& out) { across.push_back({e, dot(slope, out)}); });
  const vert_id a{3};
  const auto u = poisson(m, constant{0}, {.values = {{a, 1.0}}, .fluxes = across});
  for (const auto v : verts(m)) CHECK(u[v] == doctest::Approx(1 + dot(slope, to_vec3(point(m, v)) - to_vec3(point(m, a)))).epsilon(1e-12).scale(1));
}

TEST_CASE_TEMPLATE("poisson: the loads of facets sum to their measure and first moment", M, CONCINO_KINDS) {
  const M m = moved_grid<M>(2, 0.2);
  double boundary = 0;
  for_each_boundary_facet(m, [&](const facet_t<M>& e, const vec3&, const vec3&) {
    double sum = 0, size = 0;
    vec3 first, centre;
    concino::detail::integrate_over(m, e, [&](const vert_id& v, double x) {
      sum += x;
      first += x * to_vec3(point(m, v));
    });
    if constexpr (SurfaceMesh<M>) {
      size = edge_length(m, e);
      for (const auto v : adj_e2v(m, e)) centre += 0.5 * to_vec3(point(m, v));
    } else {
      size = area(m, e);
      centre = centroid(m, e);
    }
    CHECK(sum == doctest::Approx(size).epsilon(1e-14));
    CHECK(norm(first / sum - centre) < 1e-14);
    boundary += sum;
  });
  CHECK(boundary == doctest::Approx(VolumeMesh<M> ? 6 : 4).epsilon(1e-14));
}

TEST_CASE_TEMPLATE("poisson: fluxes through facets of size 1 and size 0 are right", M, quadmesh, hexmesh) {
  auto arrays = grid_arrays<M>(1);
  const auto check_sums = [](const M& m, double size) {
    for_each_boundary_facet(m, [&](const facet_t<M>& e, const vec3&, const vec3&) {
      double sum = 0;
      concino::detail::integrate_over(m, e, [&](const vert_id&, double x) { sum += x; });
      CHECK(sum == doctest::Approx(size));
    });
  };
  check_sums(M(arrays), 1);
  for (vec3& x : arrays.points) x = {};
  check_sums(M(arrays), 0);
}

TEST_CASE_TEMPLATE("poisson: mixed boundary conditions converge with second order", M, CONCINO_KINDS) {
  const unsigned n = VolumeMesh<M> ? 3 : 5;
  const double coarse = mixed_error(moved_grid<M>(n, 0.1)), fine = mixed_error(moved_grid<M>(2 * n, 0.1));
  CHECK(std::log2(coarse / fine) >= 1.8);
  CHECK(fine < 0.15);
}

TEST_CASE_TEMPLATE("poisson: load and outflow balance at the constrained verts", M, CONCINO_KINDS) {
  const M m = moved_grid<M>(2, 0.1);
  fluxes<M> across;
  for_each_boundary_facet(m, [&](const facet_t<M>& e, const vec3&, const vec3&) { across.push_back({e, -(VolumeMesh<M> ? 1 / 6. : 1 / 4.)}); });
  const auto u = poisson(m, constant{1}, {.values = {{vert_id{0}, 2.0}}, .fluxes = across});  // load and fluxes are in balance, so nothing flows out at vert 0
  Eigen::VectorXd x(static_cast<Eigen::Index>(vert_index_bound(m)));
  for (const auto v : verts(m)) x[static_cast<Eigen::Index>(index_of(m, v))] = u[v];
  const Eigen::VectorXd l = laplacian(m) * x, load = mass_matrix(m, {.lumped = false}) * Eigen::VectorXd::Ones(x.size());
  double out = 0;
  for (const auto& [e, flux] : across)
    concino::detail::integrate_over(m, e, [&, flux = flux](const vert_id& v, double size) { out += index_of(m, v) == 0 ? size * flux : 0; });
  CHECK(-l[0] == doctest::Approx(load[0] + out).epsilon(1e-10));
}

TEST_CASE_TEMPLATE("poisson: all forms of a call have the same result", M, quadmesh, tetmesh) {
  const M m = grid<M>(2);
  const vert_id a{0};
  facet_t<M> e{};
  for_each_boundary_facet(m, [&](const facet_t<M>& x, const vec3&, const vec3&) { e = x; });
  const auto same = [&](const auto& u, const auto& w) {
    for (const auto v : verts(m)) CHECK(u[v] == w[v]);
  };
  const constant f{1};
  const auto u = poisson(m, f, {.values = {{a, 0.0}}});
  poisson_options<M> options{.values = {{a, 0.0}}};
  same(u, poisson(m, f, {.values = {{a, 0.0}}}, ldlt{}));
  same(u, poisson(m, f, {.values = {{a, 0.0}}}, {}));
  same(u, poisson(m, f, options));
  same(u, poisson(m, f, options, ldlt{}));
  same(u, poisson(m, f, virtual_elements, options));
  same(u, poisson(m, f, virtual_elements, {.values = {{a, 0.0}}}, ldlt{}));
  same(u, poisson(m, f, {.values = {{a, 0.0}}, .isolated_value = 3}, ldlt{}));
  same(u, poisson(m, f, {.values = {{a, 0.0}}, .fluxes = fluxes<M>{}}));
  const std::map<vert_id, double> by_map{{a, 0.0}};
  same(u, poisson(m, f, {.values = {by_map.begin(), by_map.end()}}));
  const auto w = poisson(m, f, {.values = {{a, 0.0}}, .fluxes = {{e, 2.0}}});
  same(w, poisson(m, f, {.values = {{a, 0.0}}, .fluxes = {{e, 2.0}}, .isolated_value = 3}));
  same(w, poisson(m, f, {.values = {{a, 0.0}}, .fluxes = {{e, 2}, {e, 2}}}, ldlt{}));
  options.fluxes = {{e, 2}};
  same(w, poisson(m, f, options, ldlt{}));
  ldlt solver;
  same(w, poisson(m, f, {.values = {{a, 0.0}}, .fluxes = {{e, 2}}}, solver));
  same(w, poisson(m, f, virtual_elements, {.values = {{a, 0.0}}, .fluxes = {{e, 2}}}, solver));
}

TEST_CASE_TEMPLATE("poisson: fluxes work on an archetype, and for vectors", M, polygonmesh, polyhedralmesh) {
  const M m = moved_grid<M>(2, 0.1);
  fluxes<M> across;
  std::vector<std::pair<facet_t<M>, vec3>> to_space;
  for_each_boundary_facet(m, [&](const facet_t<M>& e, const vec3& x, const vec3&) {
    across.push_back({e, x.y});
    to_space.push_back({e, {0, x.y, 2 * x.y}});
  });
  const auto u = poisson(m, constant{1}, {.values = {{vert_id{0}, 0.5}}, .fluxes = across});
  const auto weak = only_embedded_mesh(m);
  using weak_mesh = std::remove_const_t<decltype(weak)>;
  fluxes<weak_mesh> weakly;
  for (const auto& [e, flux] : across) {
    if constexpr (SurfaceMesh<M>) weakly.push_back({weak.edge(e), flux});
    else weakly.push_back({weak.face(e), flux});
  }
  const auto same = poisson(weak, constant{1}, {.values = {{weak.vert(vert_id{0}), 0.5}}, .fluxes = weakly});
  for (const auto v : verts(weak)) CHECK(same[v] == doctest::Approx(u[weak.base(v)]).epsilon(1e-12));
  const auto load = make_vert_map<vec3>(m, vec3{0, 1, 2});
  const auto x = poisson(m, load, {.values = {{vert_id{0}, {7, 0.5, 1}}}, .fluxes = to_space});
  for (const auto v : verts(m)) {
    CHECK(x[v].x == doctest::Approx(7).epsilon(1e-12));
    CHECK(x[v].y == doctest::Approx(u[v]).epsilon(1e-12));
    CHECK(x[v].z == doctest::Approx(2 * u[v]).epsilon(1e-12));
  }
}

TEST_CASE_TEMPLATE("poisson: scaling mesh, load and fluxes by powers of two changes nothing", M, trimesh, polyhedralmesh) {
  const auto solution = [](double scale) {
    auto arrays = jittered(grid_arrays<M>(2), 0.05, VolumeMesh<M>);
    for (vec3& x : arrays.points) x *= scale;
    const M m(arrays);
    fluxes<M> across;
    for_each_boundary_facet(m, [&](const facet_t<M>& e, const vec3&, const vec3&) { across.push_back({e, 0.7 / scale}); });
    const auto u = poisson(m, constant{1.3 / scale / scale}, {.values = {{vert_id{0}, 0.5}}, .fluxes = across});
    return std::vector<double>(u.values().begin(), u.values().end());
  };
  const auto u = solution(1);
  CHECK(solution(0x1p20) == u);
  CHECK(solution(0x1p-20) == u);
}

TEST_CASE_TEMPLATE("poisson: throws if a flux is invalid", M, CONCINO_KINDS) {
  const M m = grid<M>(2);
  const vert_id a{0};
  const facet_t<M> none{1000000};
  facet_t<M> outer{}, inner{};
  const auto look = [&](const auto& all, const auto& polys_of) {
    for (const auto e : all) {
      int n = 0;
      for ([[maybe_unused]] const auto p : polys_of(m, e)) ++n;
      (n == 1 ? outer : inner) = e;
    }
  };
  if constexpr (SurfaceMesh<M>) look(edges(m), adj_e2p);
  else look(faces(m), adj_f2p);
  const char* const word = SurfaceMesh<M> ? "edge " : "face ";
  const auto named = [&](const facet_t<M>& e) { return word + std::to_string(e.raw()); };
  const constant f{1};
  const std::string unknown = "poisson: a flux is given at something that is not " + std::string(SurfaceMesh<M> ? "an edge" : "a face") + " of the mesh";
  CHECK_THROWS_WITH_AS(poisson(m, f, {.values = {{a, 0.0}}, .fluxes = {{none, 1.0}}}), doctest::Contains(unknown.c_str()), invalid_mesh);
  CHECK_THROWS_WITH_AS(poisson(m, f, {.values = {{a, 0.0}}, .fluxes = {{inner, 1.0}}}),
                       doctest::Contains(("poisson: a flux is given at " + named(inner) + ", which has 2 polys; give fluxes on").c_str()),
                       invalid_mesh);
  CHECK_THROWS_WITH_AS(poisson(m, f, {.values = {{a, 0.0}}, .fluxes = {{outer, INFINITY}}}), ("poisson: the flux given at " + named(outer) + " is not finite").c_str(),
                       invalid_argument);
  CHECK_THROWS_AS(poisson(m, f, {.values = {{a, 0.0}}, .fluxes = {{outer, NAN}}}), invalid_argument);
  CHECK_THROWS_AS(poisson(m, make_vert_map<vec3>(m), {.values = {{a, {0, 0, 0}}}, .fluxes = {{outer, {0, INFINITY, 0}}}}), invalid_argument);
  CHECK_THROWS_WITH_AS(poisson(m, f, {.values = {{a, 0.0}}, .fluxes = {{outer, 1.0}, {outer, 2.0}}}),
                       ("poisson: the flux given at " + named(outer) + " differs from another one given there; keep one").c_str(), invalid_argument);
  CHECK_THROWS_WITH_AS(poisson(m, f, {.fluxes = {{outer, 1.0}}}), doctest::Contains("has no prescribed value"), solver_error);
}
