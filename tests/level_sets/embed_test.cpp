#include <concino/level_sets/embed.hpp>

#include <concino/core/error.hpp>
#include <concino/edit/transaction.hpp>
#include <concino/generate/grid.hpp>
#include <concino/geometry/edge_length.hpp>
#include <concino/level_sets/isolines.hpp>
#include <concino/level_sets/isosurface.hpp>
#include <concino/mesh/corner_property.hpp>
#include <concino/validate/check_laws.hpp>
#include <concino/validate/validate.hpp>

#include <support/corpus.hpp>
#include <support/generated.hpp>
#include <support/level_sets.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <concepts>
#include <random>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M>
auto embed(M& m, double value, const embed_options& options = {}) {
  if constexpr (dimension_v<M> == 3) return embed_isosurface(m, "u", value, options);
  else return embed_isolines(m, "u", value, options);
}

template<class M>
double size_of_cut(const M& m, const embedded_lines<M>& r) {
  double sum = 0;
  for (const auto e : r.edges) sum += edge_length(m, e);
  return sum;
}
template<class M>
double size_of_cut(const M& m, const embedded_surface<M>& r) {
  double sum = 0;
  for (const auto f : r.faces) sum += area(m, f);
  return sum;
}

template<class M, class U>
double level_measure(const M& m, const U& u, double value) {
  double sum = 0;
  if constexpr (dimension_v<M> == 3) sum = total_measure(isosurface(m, u, value).mesh);
  else
    for (const auto& line : isolines(m, u, value)) sum += length_of(line);
  return sum;
}

template<class M, class U>
std::size_t straddling_edges(const M& m, const U& u, double value) {
  std::size_t n = 0;
  for (const auto e : edges(m)) {
    const auto ends = end_verts(m, e);
    n += (u[ends.first] < value && u[ends.second] > value) || (u[ends.first] > value && u[ends.second] < value);
  }
  return n;
}

/// The property u with random values, and properties of all kinds of elements.
template<class M>
auto give_values(M& m, std::mt19937& random, bool whole_numbers) {
  const auto values = random_values(m, random, whole_numbers);
  const auto u = vert_property<double>(m, "u");
  const auto number = poly_property<int>(m, "number");
  const auto edge_number = edge_property<int>(m, "edge number");
  const auto corner_value = corner_property<double>(m, "corner");
  for (const auto v : verts(m)) u[v] = values[v];
  for (const auto p : polys(m)) {
    number[p] = static_cast<int>(p.raw()) + 1;
    std::size_t k = 0;
    for ([[maybe_unused]] const auto v : adj_p2v(m, p)) corner_value[corner<M>{p, static_cast<std::uint32_t>(k++)}] = 7;
  }
  for (const auto e : edges(m)) edge_number[e] = static_cast<int>(e.raw()) + 1;
  return u;
}

}  // namespace

TEST_CASE_TEMPLATE("embed: the level set is a union of edges or faces, and measure, topology and laws stay", M, trimesh, polygonmesh, tetmesh, polyhedralmesh) {
  std::mt19937 random(1);
  const int count = long_run() ? 10000 / 4 : 60;
  for (int i = 0; i < count; ++i) {
    M m = mesh_to_cut<M>(random);
    const auto u = give_values(m, random, i % 2 == 0);
    INFO("mesh " << i);
    const double whole = total_measure(m), level = level_measure(m, u, 1);
    const int chi = euler(m);
    const auto r = embed(m, 1.0);
    CHECK(std::abs(total_measure(m) - whole) <= 1e-12 * whole);
    CHECK(size_of_cut(m, r) == doctest::Approx(level).epsilon(1e-9));
    CHECK(euler(m) == chi);
    for (const auto v : r.verts) CHECK((u[v] == 1 || std::same_as<M, polyhedralmesh>));  // polyhedra get verts in the middle of faces, too
    if (r.moved_verts.empty()) CHECK(straddling_edges(m, u, 1) == 0);
    if (i < 20) CHECK(check_laws(m).empty());
    if constexpr (dimension_v<M> == 3) {
      for (const auto p : polys(m)) {
        vec3 sum;
        for (const auto f : adj_p2f(m, p)) sum += face_is_outward(m, p, f) ? area_vector(m, f) : -area_vector(m, f);
        CHECK(norm(sum) <= 1e-12);
      }
    }
  }
}

TEST_CASE("embed: two tets with the same verts have no room for a level set between a vert and the others") {
  tetmesh doubled({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}, {0, 2, 1, 3}});
  auto u = make_vert_map<double>(doubled);
  for (const auto v : verts(doubled)) u[v] = v.raw() == 0 ? 0 : 2;
  const auto r = embed_isosurface(doubled, u, 1);
  CHECK(!r.moved_verts.empty());
  CHECK(r.faces.empty());
  CHECK(num_polys(doubled) == 2);
}

TEST_CASE_TEMPLATE("embed: descriptors of elements that are not cut stay, and properties follow", M, trimesh, polygonmesh, tetmesh, polyhedralmesh) {
  std::mt19937 random(2);
  M m = make_grid<M>({.cells = {4, 4, 4}});
  const auto u = give_values(m, random, false);
  for (const auto v : verts(m)) u[v] = point(m, v).x + 0.1 * point(m, v).y;
  const M before = m;
  const auto embedded = embed(m, 0.4);
  CHECK(!embedded.verts.empty());
  std::size_t kept = 0;
  for (const auto p : polys(before)) {
    bool below = false, above = false;
    for (const auto v : adj_p2v(before, p)) (u[v] < 0.4 ? below : above) = true;
    if (below && above) continue;
    REQUIRE(contains(m, p));
    std::vector<vert_id> a, b;
    for (const auto v : adj_p2v(before, p)) a.push_back(v);
    for (const auto v : adj_p2v(m, p)) b.push_back(v);
    CHECK(a == b);
    ++kept;
  }
  CHECK(kept > 0);
  const auto number = find_poly_property<int>(m, "number");
  const auto edge_number = find_edge_property<int>(m, "edge number");
  const auto corners = find_corner_property<double>(m, "corner");
  std::vector<double> sizes(num_polys(before) + 1);
  for (const auto p : polys(m)) {
    REQUIRE(number[p] > 0);
    sizes[static_cast<std::size_t>(number[p])] += measure(m, p);  // the parts of a poly have its value
    std::uint32_t k = 0;
    for ([[maybe_unused]] const auto v : adj_p2v(m, p)) CHECK(corners[corner<M>{p, k++}] == 7);
  }
  for (const auto p : polys(before)) CHECK(sizes[p.raw() + 1] == doctest::Approx(measure(before, p)));
  std::vector<double> lengths(edge_index_bound(before) + 1);
  for (const auto e : edges(m)) lengths[static_cast<std::size_t>(edge_number[e])] += edge_length(m, e);
  for (const auto e : edges(before)) CHECK(lengths[e.raw() + 1] == doctest::Approx(edge_length(before, e)));  // and those of an edge
  for (const auto v : embedded.verts) CHECK(u[v] == 0.4);
  CHECK(validate(m).facts.manifold);
}

TEST_CASE_TEMPLATE("embed: a map gives what a property gives", M, trimesh, tetmesh) {
  std::mt19937 random(4);
  for (int i = 0; i < 5; ++i) {
    M m = mesh_to_cut<M>(random), n = m;
    const auto values = random_values(m, random, i % 2 == 0);
    const auto u = vert_property<double>(m, "u");
    auto w = make_vert_map<double>(n);
    for (const auto v : verts(m)) w[v] = u[v] = values[v];
    embed(m, 1.0, {.snap = 0.2});
    if constexpr (dimension_v<M> == 3) embed_isosurface(n, w, 1.0, {.snap = 0.2});
    else embed_isolines(n, w, 1.0, {.snap = 0.2});
    CHECK(whole(n) == whole(m));
    for (const auto v : verts(m)) CHECK(w[v] == u[v]);
  }
  const M other = make_grid<M>({.cells = {1, 1, 1}});
  M m = other;
  auto w = make_vert_map<double>(other);
  if constexpr (dimension_v<M> == 3) CHECK_THROWS_AS((void)embed_isosurface(m, w, 0.5), invalid_argument);
  else CHECK_THROWS_AS((void)embed_isolines(m, w, 0.5), invalid_argument);
}

TEST_CASE_TEMPLATE("embed: in a transaction it is undone and redone", M, trimesh, polygonmesh, tetmesh, polyhedralmesh) {
  std::mt19937 random(3);
  const auto record = [](const M& m) {
    auto all = whole(m);
    const auto u = find_vert_property<double>(m, "u");
    const auto number = find_poly_property<int>(m, "number");
    const auto edge_number = find_edge_property<int>(m, "edge number");
    for (const auto v : verts(m)) all.push_back(u[v]);
    for (const auto p : polys(m)) all.push_back(number[p]);
    for (const auto e : edges(m)) all.push_back(edge_number[e]);
    return all;
  };
  for (int i = 0; i < 10; ++i) {
    M m = mesh_to_cut<M>(random);
    give_values(m, random, i % 2 == 0);
    const auto before = record(m);
    {
      transaction t(m);
      embed(m, 1.0, {.snap = 0.2});
    }
    CHECK(record(m) == before);
    transaction t(m);
    embed(m, 1.0, {.snap = 0.2});
    const auto after = record(m);
    auto edits = t.commit();
    edits.undo();
    CHECK(record(m) == before);
    edits.redo();
    CHECK(record(m) == after);
  }
}

TEST_CASE("embed: a large cut gives the same mesh whether the lists of verts had room before, and can be undone") {
  tetmesh m = make_grid<tetmesh>({.cells = {12, 12, 12}});
  auto u = vert_property<double>(m, "u");
  for (const vert_id v : verts(m)) u[v] = point(m, v).x;
  tetmesh with_room = m;
  {
    transaction undone(with_room);
    add_vert(with_room, {0, 0, 0});
  }
  const auto before = whole(m);
  CHECK(whole(with_room) == before);
  transaction t(m);
  const auto cut = embed(m, 0.52), cut_with_room = embed(with_room, 0.52);
  CHECK(cut.verts.size() > 300);
  CHECK(cut.faces == cut_with_room.faces);
  CHECK(whole(m) == whole(with_room));
  CHECK(check_laws(m).empty());
  t.commit().undo();
  CHECK(whole(m) == before);
}

TEST_CASE_TEMPLATE("embed: snap sets the value at verts that are near, and moves nothing", M, trimesh, tetmesh, polyhedralmesh) {
  M m = make_grid<M>({.cells = {4, 4, 4}});
  const auto u = vert_property<double>(m, "u");
  for (const auto v : verts(m)) u[v] = point(m, v).x;
  const std::size_t n = num_verts(m);
  const auto r = embed(m, 0.5001, {.snap = 0.01});
  CHECK(r.verts.empty());
  CHECK(num_verts(m) == n);
  CHECK(r.snapped.size() == (dimension_v<M> == 3 ? 25 : 5));
  for (const auto v : r.snapped) CHECK(u[v] == 0.5001);
  CHECK(size_of_cut(m, r) == doctest::Approx(1));
  CHECK(straddling_edges(m, u, 0.5001) == 0);
}

TEST_CASE("embed: nothing is cut where the value is out of range, and errors change nothing") {
  auto m = make_grid<tetmesh>({.cells = {2, 2, 2}});
  CHECK_THROWS_AS((void)embed_isosurface(m, "u", 0.5), invalid_argument);  // no such property
  const auto u = vert_property<double>(m, "u");
  for (const auto v : verts(m)) u[v] = point(m, v).z;
  const auto before = whole(m);
  CHECK(embed_isosurface(m, "u", 2.0).faces.empty());
  CHECK(embed_isosurface(m, "u", 0.0).faces.empty());
  CHECK(embed_isosurface(m, "u", 0.5).faces.size() == 8);  // along faces that are there
  CHECK(whole(m) == before);
  CHECK_THROWS_AS((void)embed_isosurface(m, "u", std::nan("")), invalid_argument);
  for (const double snap : {-0.1, 0.5, std::nan("")}) CHECK_THROWS_AS((void)embed_isosurface(m, "u", 0.3, {.snap = snap}), invalid_argument);
  u[vert_id(1)] = std::nan("");
  CHECK_THROWS_AS((void)embed_isosurface(m, "u", 0.3), invalid_argument);
  CHECK(num_polys(m) == 48);

  auto ring = merged_cubes(3, 3, 1, {0, 0, 0, 0, 1, 0, 0, 0, 0});
  const auto w = vert_property<double>(ring, "u");
  for (const auto v : verts(ring)) w[v] = point(ring, v).x;
  const auto ring_before = whole(ring);
  CHECK_THROWS_AS((void)embed_isosurface(ring, "u", 0.5), unsupported);
  CHECK(whole(ring) == ring_before);
}
