// Maps of disks without flips: developable surfaces, energies that fall, starts, fixed boundaries, all disks of the corpus, bad input.
#include <concino/parametrize/injective_map.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/parametrize/arap_map.hpp>
#include <concino/parametrize/detail/dirichlet_density.hpp>
#include <concino/parametrize/map_distortion.hpp>
#include <concino/parametrize/tutte.hpp>

#include <support/motions.hpp>
#include <support/uv_disks.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

void check_falls(const std::vector<double>& energies) {
  for (std::size_t i = 1; i < energies.size(); ++i) CHECK(energies[i] < energies[i - 1]);
  CHECK(energies.back() >= 4 * (1 - 1e-12));
}

}  // namespace

TEST_CASE("injective_map: derivatives of the energy are those of differences") {
  const detail::plane_matrix j{1.3, 0.4, -0.2, 0.7};
  const auto energy = [](const detail::plane_matrix& x) {
    const double square = x.xx * x.xx + x.xy * x.xy + x.yx * x.yx + x.yy * x.yy, det = x.determinant();
    return square * (1 + 1 / (det * det));
  };
  const auto moved = [&](std::size_t k, double d) {
    detail::plane_matrix x = j;
    (k == 0 ? x.xx : k == 1 ? x.xy : k == 2 ? x.yx : x.yy) += d;
    return x;
  };
  const detail::dirichlet_density d(j);
  const double h = 1e-5;
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(d.first[k] == doctest::Approx((energy(moved(k, h)) - energy(moved(k, -h))) / (2 * h)).epsilon(1e-6));
    // stretched enough that turns have a positive eigenvalue, so that nothing is replaced
    const detail::plane_matrix large{3 * j.xx, 3 * j.xy, 3 * j.yx, 3 * j.yy};
    detail::plane_matrix a = large, b = large;
    (k == 0 ? a.xx : k == 1 ? a.xy : k == 2 ? a.yx : a.yy) += h;
    (k == 0 ? b.xx : k == 1 ? b.xy : k == 2 ? b.yx : b.yy) -= h;
    const auto more = detail::dirichlet_density(a).first, less = detail::dirichlet_density(b).first;
    const auto second = detail::dirichlet_density(large).second[k];
    for (std::size_t l = 0; l < 4; ++l) CHECK(second[l] == doctest::Approx((more[l] - less[l]) / (2 * h)).epsilon(1e-6).scale(1));
  }
}

TEST_CASE_TEMPLATE("injective_map: no flips, energies fall, developable surfaces are mapped by an isometry", M, CONCINO_ALL_SURFACE_KINDS) {
  if constexpr (!std::is_same_v<M, polygonmesh>) {  // these have verts of two edges
    for (const bool is_cone : {false, true}) {
      const M m = grid_on<M>(8, is_cone ? on_cone : on_cylinder);
      const auto r = injective_map(m, {.tolerance = 1e-12});
      CHECK(map_distortion(m, r.uv).max_stretch == doctest::Approx(1).epsilon(1e-5));
      CHECK(r.energies.back() == doctest::Approx(4).epsilon(1e-9));
      CHECK(r.has_converged);
      check_falls(r.energies);
    }
    const M m = grid_on<M>(8, on_hill);
    const auto r = injective_map(m);
    CHECK(r.has_converged);
    CHECK(map_distortion(m, r.uv).flipped == 0);
    check_falls(r.energies);
    const auto only = only_embedded_mesh(m);
    CHECK(injective_map(only).energies == r.energies);
    CHECK(injective_map(m, {.max_iterations = 2}).energies.size() == 3);
  } else {
    const M m = grid_on<M>(4, on_hill);
    CHECK_THROWS_AS((void)injective_map(m), solver_error);
    auto flat = make_vert_map<uv_point>(m);
    const M plane = grid<M>(4);
    for (const auto v : verts(plane)) flat[v] = {point(plane, v).x, point(plane, v).y};
    const auto r = injective_map(m, flat);
    CHECK(map_distortion(m, r.uv).flipped == 0);
    check_falls(r.energies);
  }
}

TEST_CASE("injective_map: random polygons, and all disks of the corpus") {
  for (unsigned seed = 0; seed < 10; ++seed) {
    CAPTURE(seed);
    const auto m = random_polygons(seed, 10 + 20 * seed);
    const auto r = injective_map(m);
    CHECK(map_distortion(m, r.uv).flipped == 0);
    check_falls(r.energies);
    CHECK(r.has_converged);
  }
  for_each_corpus_disk([](const std::string& name, const auto& m) {
    CAPTURE(name);
    const auto r = injective_map(m, {.max_iterations = long_run() ? 300 : 15});
    CHECK(map_distortion(m, r.uv).flipped == 0);
    check_falls(r.energies);
  });
}

TEST_CASE("injective_map: rotations, scales and numbers of verts do not matter") {
  check_motions_and_numbers([](const trimesh& m) { return injective_map(m, {.tolerance = 1e-12}); }, 1e-5);
}

TEST_CASE("injective_map: starts, fixed boundaries, and bad input") {
  const auto m = grid_on<trimesh>(6, on_hill);
  const auto start = arap_map(m).uv;
  const auto r = injective_map(m, start), fixed = injective_map(m, start, {.fixed_boundary = true});
  CHECK(r.energies.front() < injective_map(m).energies.front());
  CHECK(r.energies.back() == doctest::Approx(injective_map(m).energies.back()).epsilon(1e-3));
  check_falls(fixed.energies);
  for (const auto e : edges(m))
    if (is_boundary(m, e))
      for (const auto v : adj_e2v(m, e)) CHECK(fixed.uv[v] == start[v]);
  CHECK(map_distortion(m, injective_map(m, {.fixed_boundary = true}).uv).flipped == 0);
  auto bad = start;
  bad[vert_id{24}] = {100, 100};
  CHECK_THROWS_AS((void)injective_map(m, bad), invalid_argument);
  bad[vert_id{24}] = {std::numeric_limits<double>::quiet_NaN(), 0};
  CHECK_THROWS_AS((void)injective_map(m, bad), invalid_argument);
  CHECK_THROWS_AS((void)injective_map(m, {.max_iterations = -1}), invalid_argument);
  CHECK_THROWS_AS((void)injective_map(m, {.tolerance = 2}), invalid_argument);
  CHECK_THROWS_AS((void)injective_map(m, {.progress = [](double, const char*) { return false; }}), cancelled);
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  CHECK_THROWS_AS((void)injective_map(flat), invalid_mesh);
  const polygonmesh none;
  CHECK_THROWS_AS((void)injective_map(none), invalid_mesh);
}
