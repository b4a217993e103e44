// Heat geodesics and heat flow by multigrid, whose small values are inaccurate, agree with those by a factorisation.
#include <concino/fields/heat_flow.hpp>
#include <concino/fields/heat_geodesics.hpp>
#include <concino/operators/uniform.hpp>
#include <concino/solve/ldlt.hpp>
#include <concino/solve/multigrid.hpp>

#include <support/geodesic_errors.hpp>
#include <support/values_at_verts.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// Multigrid that counts what it does.
struct counted_multigrid : multigrid {
  struct counts {
    int factorised = 0, solved = 0, cycles = 0;
  };
  counts* count;
  explicit counted_multigrid(counts* where) : multigrid({.tolerance = 1e-10}), count(where) {}
  counted_multigrid(const counted_multigrid& other) : multigrid({.tolerance = 1e-10}), count(other.count) {}
  void factorize(const Eigen::SparseMatrix<double>& a) {
    ++count->factorised;
    multigrid::factorize(a);
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    Eigen::VectorXd x = multigrid::solve(b);
    ++count->solved;
    count->cycles += iterations();
    return x;
  }
};

/// Is iterative up to its first solve.
struct changing_solver : multigrid {
  mutable bool has_solved = false;
  changing_solver() = default;
  changing_solver(const changing_solver&) : multigrid() {}
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    has_solved = true;
    return multigrid::solve(b);
  }
  bool is_iterative() const { return !has_solved; }
};

/// The largest difference of the distances by multigrid from those by ldlt, beside the largest distance.
template<class M, class S>
double difference_by_multigrid(const M& m, const S& sources, const heat_geodesics_options& options = {.clamp = false}) {
  const auto expected = heat_geodesics(m, sources, options, ldlt{}), d = heat_geodesics(m, sources, options, multigrid{});
  double worst = 0, most = 0;
  for (const auto v : verts(m)) {
    if (!std::isfinite(expected[v])) {
      CHECK(d[v] == expected[v]);
      continue;
    }
    worst = std::max(worst, std::abs(d[v] - expected[v]));
    most = std::max(most, std::abs(expected[v]));
  }
  return worst / most;
}

}  // namespace

TEST_CASE_TEMPLATE("heat_geodesics: multigrid gives the distances of a factorisation", M, CONCINO_KINDS) {
  const unsigned n = VolumeMesh<M> ? 5 : 16;
  const M m = square_or_cube<M>(n);
  const vert_id corner{0}, middle = nearest(m, {0.5, 0.5, VolumeMesh<M> ? 0.5 : 0});
  CHECK(difference_by_multigrid(m, corner) < 2e-3);
  CHECK(difference_by_multigrid(m, middle, {}) < 2e-3);
  CHECK(difference_by_multigrid(m, middle, {.boundary = heat_boundary::neumann, .clamp = false}) < 2e-3);
  CHECK(difference_by_multigrid(m, corner, {.boundary = heat_boundary::dirichlet, .clamp = false}) < 2e-3);
  CHECK(difference_by_multigrid(m, std::vector<std::pair<vert_id, double>>{{corner, 0.3}, {middle, 0.0}}) < 2e-3);
  CHECK(difference_by_multigrid(m, middle, {.time = 0.25, .clamp = false}) < 2e-3);  // heat flows over many edges
  const M two = two_grids<M>(3);
  CHECK(difference_by_multigrid(two, std::vector<std::pair<vert_id, double>>{{corner, 0.15}, {nearest(two, {1, 1, 0}), 0.0}}) < 2e-3);
  CHECK(difference_by_multigrid(two, std::vector<vert_id>{corner, nearest(two, {2, 0, 0}), vert_id{static_cast<unsigned>(num_verts(two) - 1)}}) < 2e-3);
}

TEST_CASE_TEMPLATE("heat_geodesics: multigrid gives the distances of a factorisation with gaps in the indices", M, CONCINO_KINDS) {
  M m = square_or_cube<M>(VolumeMesh<M> ? 4 : 8);
  remove_part(m, [](const vec3& x) { return (x.x > 0.5 && x.y > 0.5) || (x.x < 0.25 && x.y < 0.25); });
  REQUIRE(num_verts(m) < vert_index_bound(m));
  const vert_id source = nearest(m, {1, 0, 0});
  CHECK(difference_by_multigrid(m, source) < 2e-3);
  CHECK(difference_by_multigrid(m, source, {}) < 2e-3);
  CHECK(difference_by_multigrid(m, source, {.boundary = heat_boundary::neumann, .clamp = false}) < 2e-3);
  CHECK(difference_by_multigrid(m, source, {.boundary = heat_boundary::dirichlet, .clamp = false}) < 2e-3);
  const auto by = [&](auto&& solver) { return heat_geodesics(m, source, uniform, {.clamp = false}, solver); };
  CHECK(largest_difference(by(ldlt{}), by(multigrid{})) < 2e-3);
  for (const vert_id v : verts(m)) {  // heat is negative there, and flows along edges
    const vec3 x = point(m, v);
    set_point(m, v, vec3{x.x, 0.02 * x.y, x.z});
  }
  CHECK(difference_by_multigrid(m, source) < 2e-3);
}

TEST_CASE("heat_geodesics: a query by multigrid takes one solve on a mesh of even edges, however many") {
  for (const std::size_t cells : {20u, 60u}) {
    const trimesh m = make_torus<trimesh>({.cells = {2 * cells, cells}});
    counted_multigrid::counts counts;
    const auto heat = prepare_heat_geodesics(m, {}, counted_multigrid(&counts));
    CHECK(counts.factorised == 1);
    CHECK(counts.solved == 0);
    heat.distance_from(vert_id{7});
    CHECK(counts.factorised == 1);
    CHECK(counts.solved == 1);
    CHECK(counts.cycles <= 20);
    CHECK(difference_by_multigrid(m, vert_id{7}) < 2e-3);
  }
}

TEST_CASE("heat_geodesics: a solver may change from an iteration to a factor between queries, as auto_solver does") {
  const auto m = square_or_cube<trimesh>(12);
  const auto heat = prepare_heat_geodesics(m, {.clamp = false}, changing_solver{});
  const auto first = heat.distance_from(vert_id{5}), second = heat.distance_from(vert_id{5});
  CHECK(largest_difference(first, second) < 1e-9);
  CHECK(largest_difference(second, heat_geodesics(m, vert_id{5}, {.clamp = false}, ldlt{})) < 2e-3);
}

TEST_CASE("heat_geodesics: multigrid gives the distances of a factorisation on graded meshes") {
  for (const double power : {2.0, 3.0}) {
    auto m = make_grid<trimesh>({.cells = {40, 40}});
    grade(m, {power, power, 1});
    CHECK(difference_by_multigrid(m, vert_id{0}) < 2e-3);
    CHECK(difference_by_multigrid(m, vert_id{800}) < 2e-3);
  }
}

TEST_CASE("heat_geodesics: multigrid gives the distances of a factorisation on obtuse triangles, with one solve for a query") {
  trimesh sheared = make_grid<trimesh>({.cells = {40, 40}});
  for (const auto v : verts(sheared)) {
    const vec3 x = to_vec3(point(sheared, v));
    set_point(sheared, v, vec3{x.x - 1.5 * x.y, 0.7 * x.y, 0});
  }
  for (const trimesh& m : {sheared, make_sphere<trimesh>({.cells = 25}), bumpy_ball(4)}) {
    CHECK(difference_by_multigrid(m, vert_id{7}) < 2e-3);
    counted_multigrid::counts counts;
    const auto heat = prepare_heat_geodesics(m, {}, counted_multigrid(&counts));
    counts = {};
    heat.distance_from(vert_id{7});
    CHECK(counts.factorised == 0);
    CHECK(counts.solved == 1);
  }
}

TEST_CASE("heat_geodesics: where a band with all verts needs a solver, queries share it") {
  auto m = make_grid<trimesh>({.cells = {150, 150}});
  counted_multigrid::counts counts;
  const auto heat = prepare_heat_geodesics(m, {.time = 0.25, .boundary = heat_boundary::neumann}, counted_multigrid(&counts));
  const auto first = heat.distance_from(vert_id{0});
  REQUIRE(counts.factorised == 2);  // of Poisson's equation and of heat
  heat.distance_from(vert_id{800});
  CHECK(largest_difference(heat.distance_from(vert_id{0}), first) == 0);
  CHECK(counts.factorised == 2);
}

TEST_CASE("heat_bands: heat has correct digits where it underflows, whatever the signs of the entries") {
  constexpr int n = 3000;  // a chain, whose solution is a geometric series
  constexpr double decay = 0.5;
  for (const double sign : {1.0, -1.0}) {  // with the other sign heat alternates, as it may beside obtuse angles
    Eigen::SparseMatrix<double> a(n, n);
    std::vector<double> guess, load(n);
    for (int i = 0; i < n; ++i) {
      a.insert(i, i) = i == n - 1 ? 1 / decay : decay + 1 / decay;
      if (i + 1 < n) a.insert(i + 1, i) = -sign;
      guess.push_back(-0.7 * i);
    }
    a.makeCompressed();
    load[0] = 1;
    const auto order = concino::detail::heat_bands::order_by_guess(guess);
    concino::detail::heat_bands bands(a, load, guess, order);
    REQUIRE(bands.run(1e-6, nullptr));
    const auto log_u = bands.log_heat();
    CHECK(bands.num_iterations() < 60);
    double worst = 0;
    for (int i = 0; i < n; i += 2) worst = std::max(worst, std::abs(log_u[static_cast<std::size_t>(i)] - (i + 1) * std::log(decay)));
    CHECK(worst < 1e-3);  // the ends of bands add up, but along the chain only
    CHECK(std::isfinite(log_u[1]) == (sign > 0));
  }
}

TEST_CASE("heat_bands: where another solver has no solution, iterations continue") {
  const auto m = make_grid<trimesh>({.cells = {150, 150}});
  struct failing_solver : multigrid {
    failing_solver() = default;
    failing_solver(const failing_solver&) : multigrid() {}
    void factorize(const Eigen::SparseMatrix<double>& a) {
      if (a.coeff(0, 0) < 0.1) throw solver_error("none");  // heat on a fine mesh: masses are small
      multigrid::factorize(a);
    }
  };
  const heat_geodesics_options options{.time = 0.25, .boundary = heat_boundary::neumann, .clamp = false};
  CHECK(largest_difference(heat_geodesics(m, vert_id{0}, options, failing_solver{}), heat_geodesics(m, vert_id{0}, options, ldlt{})) < 2e-3);
}

TEST_CASE_TEMPLATE("heat_flow: multigrid gives the values of a factorisation, in few cycles", M, CONCINO_KINDS) {
  const M m = square_or_cube<M>(VolumeMesh<M> ? 5 : 16);
  const auto u = random_values(m);
  for (const double time : {1e-4, 0.1}) {
    const heat_flow_options<M> options{.fixed = {vert_id{0}}, .steps = 4};
    const auto expected = heat_flow(m, u, time, options, ldlt{});
    counted_multigrid::counts counts;
    counted_multigrid solver(&counts);
    CHECK(largest_difference(heat_flow(m, u, time, options, solver), expected) < 1e-8);
    CHECK(counts.solved == 8);
    CHECK(counts.cycles <= 20 * counts.solved);
    CHECK(largest_difference(prepare_heat_flow(m, time, options, multigrid{}).advance(u), expected) < 1e-8);
  }
}
