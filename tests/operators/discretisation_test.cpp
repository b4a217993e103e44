// Discretisations of the library, the meshes that each supports, and discretisations of users.
#include <concino/operators/discretisation.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/views.hpp>
#include <concino/fields/harmonic_map.hpp>
#include <concino/fields/heat_flow.hpp>
#include <concino/fields/heat_geodesics.hpp>
#include <concino/fields/poisson.hpp>
#include <concino/fields/smooth.hpp>
#include <concino/operators/de_goes.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/operators/virtual_refinement.hpp>
#include <concino/solve/auto_solver.hpp>

#include <support/kinds.hpp>
#include <support/stiffness.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <Eigen/Core>

using namespace concino;
using namespace concino::testing;

namespace {

/// Discretisations of the library, implemented by each of the members that a discretisation may have.
struct counted_neighbours {
  template<class M> auto neighbour_weights(const M&) const {
    return [](const auto&, const auto&) { return 1; };
  }
  template<class M> auto masses(const M& m) const { return make_vert_map<float>(m, 1); }
};
struct counted_edges {
  template<AnyMesh M> auto edge_weights(const M& m) const { return make_edge_map<double>(m, 1); }
  template<class M> auto masses(const M& m) const { return make_vert_map<double>(m, 1); }
};
struct counted_polys {  // of triangles: each poly has half a weight for each of its edges, so interior edges have weight 1
  template<AnyMesh M> auto poly_matrices(const M& m) const {
    return [&m](const poly_t<M>& p, local_matrix<vert_t<M>>& k) {
      k.verts.clear();
      for (const auto v : adj_p2v(m, p)) k.verts.push_back(v);
      k.entries.assign({1, -0.5, 1, -0.5, -0.5, 1});
    };
  }
  template<class M> auto masses(const M& m) const { return make_vert_map<double>(m, 1); }
};
struct given_masses {  // the masses are those of the mesh, so problems are solved at the scale of the mesh
  template<class M> auto poly_matrices(const M& m) const { return virtual_elements.poly_matrices(m); }
  template<class M> auto masses(const M& m) const { return vert_masses(m); }
};
struct of_quads_alone {
  auto poly_matrices(const quadmesh& m) const { return virtual_elements.poly_matrices(m); }
};
struct dependent_on_places {
  bool* within;
  template<EmbeddedMesh M> auto poly_matrices(const M& m) const {
    for (const auto v : verts(m))
      for (std::size_t k = 0; k < 3; ++k) {
        const double x = to_vec3(point(m, v))[k];
        if (x != 0 && x != 20 && x != 40) *within = false;
      }
    return virtual_elements.poly_matrices(m);
  }
};
struct without_mass : counted_neighbours {
  template<class M> auto masses(const M& m) const { return make_vert_map<double>(m, 0); }
};

template<class M> concept has_default_laplacian = requires(const M& m) { laplacian(m); };
template<class M> concept has_cotangents = requires(const M& m) { laplacian(m, cotangent); };
template<class M, class D> concept maps_by = requires(const M& m, const D& d) { harmonic_map(m, {{verts(m).begin().operator*(), 0.0}}, d); };

using graph = decltype(only_primal_graph(std::declval<const trimesh&>()));
using surface_without_points = decltype(only_surface_mesh(std::declval<const trimesh&>()));
static_assert(has_default_laplacian<trimesh> && has_default_laplacian<polyhedralmesh>);
static_assert(!has_default_laplacian<graph> && !has_default_laplacian<surface_without_points>);
static_assert(!has_default_laplacian<views::primal_view<trimesh>>);  // f(m) equals f(primal(m)) if both are allowed
static_assert(has_cotangents<trimesh> && has_cotangents<polygonmesh> && has_cotangents<tetmesh> && has_cotangents<polyhedralmesh>);
static_assert(!has_cotangents<quadmesh> && !has_cotangents<hexmesh> && !has_cotangents<graph>);
static_assert(Discretisation<uniform_t, graph> && Discretisation<const uniform_t&, const graph&> && Discretisation<counted_neighbours, graph>);
static_assert(!Discretisation<virtual_elements_t, graph> && !Discretisation<counted_edges, graph>);
static_assert(Discretisation<de_goes_t, quadmesh> && !Discretisation<de_goes_t, hexmesh> && Discretisation<virtual_refinement_t, hexmesh>);
static_assert(!Discretisation<harmonic_map_options, trimesh> && !Discretisation<auto_solver, trimesh> && !Discretisation<int, trimesh>);
static_assert(Discretisation<of_quads_alone, quadmesh> && !Discretisation<of_quads_alone, trimesh>);

/// The largest difference of two maps over the verts of one mesh, or of two matrices.
template<class A, class B>
double difference(const A& a, const B& b) {
  if constexpr (requires { a.values(); }) {
    double worst = 0;
    for (std::size_t i = 0; i < a.values().size(); ++i) worst = std::max(worst, std::abs(a.values()[i] - b.values()[i]));
    return worst;
  } else {
    return (Eigen::MatrixXd(a) - Eigen::MatrixXd(b)).cwiseAbs().maxCoeff();
  }
}

}  // namespace

TEST_CASE("explain_discretisation compiles for discretisations") {
  explain_discretisation<uniform_t, graph>();
  explain_discretisation<const of_quads_alone&, quadmesh>();
}

TEST_CASE_TEMPLATE("discretisations: de_goes and virtual_refinement equal minus the sum of local stiffness matrices", M, polygonmesh, polyhedralmesh) {
  const M m(jittered(grid_arrays<M>(2), 0.03, VolumeMesh<M>));
  const Eigen::MatrixXd refined = laplacian(m, virtual_refinement);
  CHECK((refined + stiffness<concino::detail::virtual_refinement_element<M>>(m)).cwiseAbs().maxCoeff() < 1e-13);
  if constexpr (SurfaceMesh<M>) {
    const Eigen::MatrixXd found = laplacian(m, de_goes);
    CHECK((found + stiffness<concino::detail::de_goes_element<M>>(m)).cwiseAbs().maxCoeff() < 1e-13);
  }
}

TEST_CASE_TEMPLATE("discretisations: a user's discretisation by weights of neighbours or edges equals the library's", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.03));
  CHECK(difference(laplacian(m, counted_neighbours{}), laplacian(m, uniform)) == 0);
  CHECK(difference(laplacian(m, counted_edges{}), laplacian(m, uniform)) == 0);
  const vert_id a{0}, b{3};
  const auto f = make_vert_map<double>(m, 0.25);
  const auto check = [&](const auto& own) {
    for (const int n : {1, 2}) {
      CHECK(difference(harmonic_map(m, {{a, 0}, {b, 1}}, own, {.exponent = n}), harmonic_map(m, {{a, 0}, {b, 1}}, uniform, {.exponent = n})) == 0);
      CHECK(difference(prepare_harmonic_map(m, {a, b}, own, {.exponent = n}).with_values({{a, 0}, {b, 1}}),
                       harmonic_map(m, {{a, 0}, {b, 1}}, uniform, {.exponent = n})) == 0);
      CHECK(difference(smooth(m, f, 0.3, own, {.fixed = {a}, .exponent = n}), smooth(m, f, 0.3, uniform, {.fixed = {a}, .exponent = n})) == 0);
    }
    CHECK(difference(heat_flow(m, f, 0.3, own), heat_flow(m, f, 0.3, uniform)) == 0);
    CHECK(difference(poisson(m, f, own, {.values = {{a, 0}}}), poisson(m, f, uniform, {.values = {{a, 0}}})) == 0);
    CHECK(difference(heat_geodesics(m, a, own), heat_geodesics(m, a, uniform)) == 0);
  };
  check(counted_neighbours{});
  check(counted_edges{});
}

TEST_CASE("discretisations: a user's discretisation may have a matrix for each poly") {
  const trimesh m(jittered(triangle_grid(3), 0.04));
  const Eigen::MatrixXd l = laplacian(m, counted_polys{});
  for (const auto e : edges(m)) {
    double polys_at_e = 0;
    for ([[maybe_unused]] const auto p : adj_e2p(m, e)) polys_at_e += 1;
    std::vector<Eigen::Index> ends;
    for (const auto v : adj_e2v(m, e)) ends.push_back(static_cast<Eigen::Index>(index_of(m, v)));
    CHECK(l(ends[0], ends[1]) == 0.5 * polys_at_e);
  }
  const auto u = harmonic_map(m, {{vert_id{0}, 0.0}, {vert_id{5}, 1.0}}, counted_polys{}, {.exponent = 2});
  CHECK(u[vert_id{5}] == 1);
}

TEST_CASE("discretisations: a user's discretisation with the masses of the mesh is the same up to rounding") {
  auto arrays = jittered(grid_arrays<quadmesh>(3), 0.04);
  for (vec3& x : arrays.points) x *= 40;
  const quadmesh m(arrays);
  const vert_id a{0}, b{7};
  auto f = make_vert_map<double>(m, 1.0);
  f[b] = 3;
  const auto check = [&](const auto& own) {
    CHECK(difference(laplacian(m, own), laplacian(m)) == 0);
    for (const int n : {1, 2}) CHECK(difference(harmonic_map(m, {{a, 0}, {b, 1}}, own, {.exponent = n}), harmonic_map(m, {{a, 0}, {b, 1}}, {.exponent = n})) < 1e-10);
    CHECK(difference(smooth(m, f, 20, own), smooth(m, f, 20)) < 1e-12);
    CHECK(difference(heat_flow(m, f, 20, own, {.lumped = true}), heat_flow(m, f, 20, {.lumped = true})) < 1e-12);
    CHECK(difference(poisson(m, f, own, {.values = {{a, 0}}}), poisson(m, f, {.values = {{a, 0}}})) < 1e-9);
  };
  check(given_masses{});
  check(of_quads_alone{});
  CHECK(difference(heat_geodesics(m, a, of_quads_alone{}), heat_geodesics(m, a)) < 1e-9);
}

TEST_CASE_TEMPLATE("discretisations: one that depends on position gets the mesh at its true position and scale", M, trimesh, hexmesh) {
  auto arrays = grid_arrays<M>(2);
  for (vec3& x : arrays.points) x *= 40;
  const M m(arrays);
  const vert_id a{0}, b{3};
  const auto f = make_vert_map<double>(m, 0.25);
  bool within = true;
  const dependent_on_places own{&within};
  CHECK(difference(laplacian(m, own), laplacian(m)) < 1e-12);
  CHECK(difference(harmonic_map(m, {{a, 0}, {b, 1}}, own), harmonic_map(m, {{a, 0}, {b, 1}})) < 1e-10);
  CHECK(difference(smooth(m, f, 9, own, {.fixed = {a}}), smooth(m, f, 9, {.fixed = {a}})) < 1e-10);
  CHECK(difference(heat_flow(m, f, 9, own), heat_flow(m, f, 9)) < 1e-10);
  CHECK(difference(heat_geodesics(m, a, own), heat_geodesics(m, a)) < 1e-8);
  CHECK(within);
}

TEST_CASE("discretisations: a mass that is not positive throws") {
  const auto m = grid<trimesh>(2);
  CHECK_THROWS_WITH_AS(smooth(m, make_vert_map<double>(m), 1, without_mass{}),
                       "smooth: the discretisation gives vert 0 the mass 0; masses must be positive and finite", invalid_argument);
}

TEST_CASE_TEMPLATE("discretisations: with uniform a mesh equals its primal graph", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.03));
  const auto g = primal(m);
  const vert_id a{0}, b{3};
  CHECK(difference(laplacian(g, uniform), laplacian(m, uniform)) == 0);
  CHECK(difference(harmonic_map(g, {{a, 0}, {b, 1}}, uniform), harmonic_map(m, {{a, 0}, {b, 1}}, uniform)) == 0);
  const auto f = make_vert_map<double>(m, 0.25);
  CHECK(difference(smooth(g, f, 0.3, uniform), smooth(m, f, 0.3, uniform)) == 0);
  CHECK(difference(heat_flow(g, f, 0.3, uniform), heat_flow(m, f, 0.3, uniform)) == 0);
}
