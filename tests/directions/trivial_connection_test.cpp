// trivial_connection: given singularities and generators come out, directions follow the connection, bad input.
#include <concino/directions/trivial_connection.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/end_verts.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/geometry/normals.hpp>

#include <support/closed_surfaces.hpp>
#include <support/corpus_meshes.hpp>
#include <support/uv_disks.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class W>
double error_of_indices(const W& w, const std::vector<std::pair<vert_id, int>>& wanted) {
  double worst = 0;
  for (const auto v : verts(w.mesh())) {
    double index = 0;
    for (const auto& [x, k] : wanted)
      if (x == v) index = k;
    worst = std::max(worst, std::abs(w.index(v) - index));
  }
  return worst;
}

/// The largest difference of the directions of two polys at an edge from those that the connection carries there, as parts of the angle between
/// directions. The polys are laid flat along the edge.
template<class W>
double error_of_directions(const W& w) {
  double worst = 0;
  const auto& m = w.mesh();
  for (const auto e : edges(m)) {
    const auto [a, b] = end_verts(m, e);
    const vec3 along = to_vec3(point(m, b)) - to_vec3(point(m, a));
    double angle[2] = {0, 0};
    std::size_t k = 0;
    for (const auto p : adj_e2p(m, e)) {
      const vec3 n = normal(m, p), flat = along - dot(along, n) * n, d = w.direction(p);
      if (k < 2) angle[k++] = std::atan2(dot(d, cross(n, flat)), dot(d, flat));
    }
    const double turns = (angle[1] - angle[0] - w.turn(e)) * w.symmetry() / (2 * std::numbers::pi);
    worst = std::max(worst, std::abs(turns - std::round(turns)));
  }
  return worst;
}

}  // namespace

TEST_CASE("trivial_connection: two singularities of a sphere") {
  const auto m = icosphere(2);
  const vert_id v{0}, u{11};
  const auto w = trivial_connection(m, {{v, 1}, {u, 1}});
  CHECK(error_of_indices(w, {{v, 1}, {u, 1}}) < 1e-10);
  CHECK(error_of_directions(w) < 1e-10);
  const auto found = singularities(w);
  REQUIRE(found.size() == 2);
  CHECK(found[0].element == v);
  CHECK(found[0].index == 1);
  CHECK(found[1].element == u);
  for (const auto p : polys(m)) {
    CHECK(norm(w.direction(p)) == doctest::Approx(1));
    CHECK(std::abs(dot(w.direction(p), normal(m, p))) < 1e-12);
    CHECK(w.directions(p).size() == 1);
  }
  const poly_id first{7};
  const auto [a, b, c] = [&] {
    std::array<vec3, 3> x;
    std::size_t k = 0;
    for (const auto t : adj_p2v(m, first)) x[k++] = point(m, t);
    return x;
  }();
  const auto given = trivial_connection(m, {{v, 2}}, {.start = std::pair(first, b - a + 0.2 * (c - a))});
  const vec3 d = b - a + 0.2 * (c - a);
  CHECK(norm(given.direction(first) - d / norm(d)) < 1e-12);
  CHECK(error_of_indices(given, {{v, 2}}) < 1e-10);
}

TEST_CASE_TEMPLATE("trivial_connection: indices and generators of surfaces of any genus", M, CONCINO_ALL_SURFACE_KINDS) {
  for (const int genus : {0, 1, 2, 5, 8}) {
    CAPTURE(genus);
    const M m = from_quads<M>(holed_board(genus));
    const int n = 4, chi = 2 - 2 * genus;
    const std::vector<std::pair<vert_id, int>> wanted{{vert_id{0}, n * chi - 3}, {vert_id{5}, 5}, {vert_id{7}, -2}};
    const auto w = trivial_connection(m, wanted, {.symmetry = n});
    CHECK(error_of_indices(w, wanted) < 1e-10);
    CHECK(error_of_directions(w) < 1e-10);
    const auto& turns = w.generator_indices();
    CHECK(turns.size() == static_cast<std::size_t>(2 * genus));
    for (const double x : turns) CHECK(std::abs(x - std::round(x)) < 1e-10);
    std::vector<int> generators;
    for (std::size_t k = 0; k < turns.size(); ++k) generators.push_back(static_cast<int>(std::lround(turns[k])) + static_cast<int>(k % 3) - 1);
    const auto other = trivial_connection(m, wanted, {.symmetry = n, .generators = generators});
    CHECK(error_of_indices(other, wanted) < 1e-10);
    CHECK(error_of_directions(other) < 1e-10);
    for (std::size_t k = 0; k < turns.size(); ++k) CHECK(std::abs(other.generator_indices()[k] - generators[k]) < 1e-10);
  }
}

TEST_CASE("trivial_connection: several components, polys oriented against each other, an archetype") {
  auto two = triangulated(beside(holed_board(0), holed_board(1)));
  for (std::size_t p = 3; p < two.verts.size(); p += 6) std::swap(two.verts[p], two.verts[p + 1]);
  const trimesh m(two);
  const vert_id last{two.points.size() - 1};
  const std::vector<std::pair<vert_id, int>> wanted{{vert_id{0}, 2}, {last, 1}, {vert_id{two.points.size() - 2}, -1}};
  const auto w = trivial_connection(m, wanted);
  CHECK(error_of_indices(w, wanted) < 1e-10);
  CHECK_THROWS_WITH_AS((void)trivial_connection(m, {{vert_id{0}, 3}, {last, -1}}),
                       "trivial_connection: the indices of component 0 sum to 3; they must sum to the symmetry times its Euler characteristic, 2", invalid_argument);
  const polygonmesh board(from_quads<polygonmesh>(holed_board(1)));
  const auto only = only_embedded_mesh(board);
  const std::vector<std::pair<vert_t<decltype(only)>, int>> none;
  const auto smooth = trivial_connection(only, none);
  CHECK(singularities(smooth).empty());
}

TEST_CASE("trivial_connection: closed surfaces of the corpus") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  for (const corpus_row& row : rows) {
    const auto is = [&](const char* name, const char* value) { return row.column.count(name) && row.column.at(name) == value; };
    if (!is("boundary_loops", "0") || !is("manifold", "yes") || !is("orientable", "True") || !is("components", "1")) continue;
    if (!long_run() && std::filesystem::file_size(row.file) > 300'000) continue;
    CAPTURE(row.name);
    const auto any = load_any(row.file.string());
    std::visit(
        [&](const auto& m) {
          if constexpr (dimension_v<decltype(m)> == 2) {
            const int chi = std::stoi(row.column.at("euler_chi"));
            vert_id first, last;
            for (const auto v : verts(m))
              if (num_elements(adj_v2e(m, v)) > 0) last = v;
            for (const auto v : adj_p2v(m, *polys(m).begin())) first = v;
            const std::vector<std::pair<vert_id, int>> wanted{{first, 2 * chi + 1}, {last, -1}};
            if (first == last) return;
            const auto w = trivial_connection(m, wanted, {.symmetry = 2});
            CHECK(error_of_indices(w, wanted) < 1e-10);
          }
        },
        any);
  }
}

TEST_CASE("trivial_connection: bad input") {
  const auto m = icosphere(1);
  const vert_id v{0}, u{1};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS((void)trivial_connection(m, {{v, 1}}), invalid_argument);
  CHECK_THROWS_AS((void)trivial_connection(m, {{v, 1}, {v, 1}}), invalid_argument);
  CHECK_THROWS_AS((void)trivial_connection(m, {{v, 1}, {vert_id{999}, 1}}), invalid_mesh);
  CHECK_THROWS_AS((void)trivial_connection(m, {{v, 1}, {u, 1}}, {.symmetry = 0}), invalid_argument);
  CHECK_THROWS_AS((void)trivial_connection(m, {{v, 1}, {u, 1}}, {.generators = {1}}), invalid_argument);
  CHECK_THROWS_AS((void)trivial_connection(m, {{v, 1}, {u, 1}}, {.start = std::pair(poly_id{0}, vec3{0, 0, 0})}), invalid_argument);
  CHECK_THROWS_AS((void)trivial_connection(m, {{v, 1}, {u, 1}}, {.start = std::pair(poly_id{0}, vec3{nan, 0, 0})}), invalid_argument);
  CHECK_THROWS_AS((void)trivial_connection(m, {{v, 1}, {u, 1}}, {.start = std::pair(poly_id{999}, vec3{1, 0, 0})}), invalid_mesh);
  CHECK_THROWS_AS((void)trivial_connection(m, {{v, 1}, {u, 1}}, {.progress = [](double, const char*) { return false; }}), cancelled);
  const auto open = grid_on<trimesh>(3, on_hill);
  CHECK_THROWS_AS((void)trivial_connection(open, {{v, 1}}), invalid_mesh);
  const trimesh projective(projective_plane());
  CHECK_THROWS_AS((void)trivial_connection(projective, {{v, 1}}), unsupported);
  const polygonmesh none;
  CHECK_THROWS_AS((void)trivial_connection(none, {{v, 1}}), invalid_mesh);
}
