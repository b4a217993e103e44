#include <concino/level_sets/embed_path.hpp>

#include <concino/core/error.hpp>
#include <concino/edit/transaction.hpp>
#include <concino/fields/exact_geodesics.hpp>
#include <concino/generate/grid.hpp>
#include <concino/geometry/edge_length.hpp>
#include <concino/level_sets/isolines.hpp>
#include <concino/validate/check_laws.hpp>
#include <concino/validate/validate.hpp>

#include <support/corpus.hpp>
#include <support/generated.hpp>
#include <support/level_sets.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M>
double length_of_edges(const M& m, const embedded_path<M>& path) {
  double sum = 0;
  for (const auto e : path.edges) sum += edge_length(m, e);
  return sum;
}

/// Checks that the edges lead from each point to the next one.
template<class M>
void check_follows(const M& m, const embedded_path<M>& path, bool closed) {
  if (path.verts.empty()) return;
  auto at = path.verts.front();
  std::size_t next = 1;
  while (next < path.verts.size() && path.verts[next] == at) ++next;
  for (const auto e : path.edges) {
    const auto ends = end_verts(m, e);
    REQUIRE((ends.first == at || ends.second == at));
    at = ends.first == at ? ends.second : ends.first;
    while (next < path.verts.size() && path.verts[next] == at) ++next;
  }
  CHECK(next >= path.verts.size());
  if (closed) CHECK(at == path.verts.front());
}

/// The sum of the vector areas, which stays if lines across concave polygons leave them, too.
template<class M>
vec3 sum_of_area_vectors(const M& m) {
  vec3 sum;
  for (const auto p : polys(m)) sum += area_vector(m, p);
  return sum;
}

template<class M>
double smallest_area(const M& m) {
  double least = 1e300;
  for (const auto p : polys(m)) least = std::min(least, area(m, p));
  return least;
}

/// A walk over the surface: each point is at a vert or on an edge of a poly of the one before.
template<class M>
std::vector<mesh_point<M>> random_walk(const M& m, std::mt19937& random, int n) {
  std::uniform_real_distribution<double> unit(0.05, 0.95);
  const auto pick = [&](const auto& range) {
    const auto k = std::uniform_int_distribution<std::ptrdiff_t>(0, std::distance(range.begin(), range.end()) - 1)(random);
    return *std::next(range.begin(), k);
  };
  std::vector<mesh_point<M>> walk;
  auto p = pick(polys(m));
  for (int i = 0; i < n; ++i) {
    if (random() % 4 == 0) {
      const auto v = pick(adj_p2v(m, p));
      walk.push_back({v, point(m, v)});
      p = pick(adj_v2p(m, v));
    } else {
      const auto e = pick(adj_p2e(m, p));
      walk.push_back({edge_point<M>{e, random() % 3 == 0 ? 0.5 : unit(random)}, {}});
      p = pick(adj_e2p(m, e));
    }
  }
  return walk;
}

}  // namespace

TEST_CASE_TEMPLATE("embed_path: an iso-line becomes edges", M, trimesh, polygonmesh) {
  std::mt19937 random(1);
  for (int i = 0; i < 60; ++i) {
    M m = mesh_to_cut<M>(random);
    if constexpr (arity_v<M> == 0) m = make_grid<M>({.cells = {5, 4, 1}});  // lines of other polygons have points inside them
    const auto u = vert_property<double>(m, "u");
    const auto values = random_values(m, random, i % 3 == 0);
    for (const auto v : verts(m)) u[v] = values[v];
    const auto lines = isolines(m, u, 1.0);
    if (lines.empty()) continue;
    INFO("mesh " << i);
    const auto& line = lines[random() % lines.size()];
    const double whole = total_measure(m);
    const auto chi = euler(m);
    const auto r = embed_path(m, line.places, {.closed = line.closed});
    CHECK(length_of_edges(m, r) == doctest::Approx(length_of(line)).epsilon(1e-12));
    check_follows(m, r, line.closed);
    for (const auto v : r.verts) CHECK(u[v] == doctest::Approx(1).epsilon(1e-12));
    for (std::size_t k = 0; k < r.verts.size(); ++k) CHECK(norm(point(m, r.verts[k]) - line.points[k]) <= 1e-15);
    CHECK(std::abs(total_measure(m) - whole) <= 1e-12 * whole);
    CHECK(euler(m) == chi);
    CHECK(check_laws(m).empty());
  }
}

TEST_CASE("embed_path: geodesics become edges") {
  std::mt19937 random(2);
  for (int i = 0; i < 20; ++i) {
    auto m = mesh_to_cut<trimesh>(random);
    const auto all = verts(m);
    const vert_id source = *all.begin();
    const auto distances = prepare_exact_geodesics(m).paths_from({source});
    for (const vert_t<trimesh> target : all) {
      auto cut = m;
      const auto path = distances.path_to(target);
      if (path.points.empty()) continue;
      const auto r = embed_path(cut, path.points);
      CHECK(length_of_edges(cut, r) == doctest::Approx(path.length).epsilon(1e-9));
      check_follows(cut, r, false);
      CHECK(r.verts.front() == source);
      CHECK(r.verts.back() == target);
      CHECK(euler(cut) == euler(m));
    }
  }
}

TEST_CASE_TEMPLATE("embed_path: random walks are cut without flat parts, or refused as a whole", M, trimesh, polygonmesh) {
  std::mt19937 random(3);
  int cut = 0, refused = 0;
  for (int i = 0; i < (long_run() ? 5000 : 200); ++i) {
    M m = mesh_to_cut<M>(random);
    if (i % 2 == 0) give_properties(m);
    const auto number = poly_property<int>(m, "number");
    for (const auto p : polys(m)) number[p] = static_cast<int>(p.raw()) + 1;
    const auto before = whole(m);
    const M old = m;
    const double whole_area = total_measure(m);
    const vec3 area_before = sum_of_area_vectors(m);
    const double least = smallest_area(m);
    const auto chi = euler(m);
    const auto walk = random_walk(m, random, 1 + i % 9);
    INFO("mesh " << i);
    try {
      const auto r = embed_path(m, walk);
      ++cut;
      check_follows(m, r, false);
      if (arity_v<M> == 3) CHECK(std::abs(total_measure(m) - whole_area) <= 1e-12 * whole_area);
      CHECK(norm(sum_of_area_vectors(m) - area_before) <= 1e-12 * whole_area);
      CHECK(euler(m) == chi);
      if (arity_v<M> == 3) CHECK(smallest_area(m) > 1e-6 * least);
      CHECK(num_verts(m) == num_verts(old) + r.new_verts.size());
      if (i < 40) CHECK(check_laws(m).empty());
      std::vector<double> areas(poly_index_bound(old) + 1);
      for (const auto p : polys(m)) areas[static_cast<std::size_t>(number[p])] += area(m, p);
      for (const auto p : polys(old)) CHECK((contains(m, p) && number[p] == number[poly_id{p.raw()}]));
      if (arity_v<M> == 3)
        for (const auto p : polys(old)) CHECK(areas[p.raw() + 1] == doctest::Approx(area(old, p)));
    } catch (const invalid_argument&) {  // it crosses itself
      ++refused;
      CHECK(whole(m) == before);
    }
  }
  CHECK(cut > 50);
  CHECK(refused > 5);
}

TEST_CASE_TEMPLATE("embed_path: points on edges and at verts", M, trimesh, polygonmesh) {
  M m = make_grid<M>({.cells = {2, 2, 1}});
  const std::size_t nv = num_verts(m), np = num_polys(m);
  const edge_id e = *edges(m).begin();
  const auto ends = end_verts(m, e);
  const auto before = whole(m);

  CHECK(embed_path(m, std::vector<vert_id>{}).edges.empty());
  const auto single = embed_path(m, std::vector{ends.first});
  CHECK(single.edges.empty());
  CHECK(single.verts == std::vector{ends.first});
  const auto along = embed_path(m, std::vector<edge_point<M>>{{e, 0}, {e, 1}}, {.closed = true});  // an edge that is there
  CHECK(along.edges == std::vector{e});
  CHECK(along.verts == std::vector{ends.first, ends.second});
  CHECK(whole(m) == before);

  // Along one edge, there and back: the points in between become verts once.
  const auto r = embed_path(m, std::vector<edge_point<M>>{{e, 0.25}, {e, 0.75}, {e, 0.5}, {e, 0.25}, {e, 0}});
  CHECK(r.new_verts.size() == 3);
  CHECK(num_verts(m) == nv + 3);
  CHECK(r.edges.size() == 2 + 1 + 1 + 1);
  CHECK(r.verts[0] == r.verts[3]);
  CHECK(r.verts[4] == ends.first);
  if (arity_v<M> == 0) CHECK(num_polys(m) == np);
  CHECK(total_measure(m) == doctest::Approx(1));
  CHECK(validate(m).facts.manifold);
  CHECK(check_laws(m).empty());
}

TEST_CASE_TEMPLATE("embed_path: what is wrong is named, and changes nothing", M, trimesh, polygonmesh) {
  M m = make_grid<M>({.cells = {4, 4, 1}});
  give_properties(m);
  const auto before = whole(m);
  const auto message = [&](const std::vector<mesh_point<M>>& points) -> std::string {
    try {
      embed_path(m, points);
    } catch (const invalid_argument& x) {
      CHECK(whole(m) == before);
      return x.what();
    }
    return "";
  };
  const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  const edge_id e = *edges(m).begin();
  const auto last = *std::next(verts(m).begin(), static_cast<std::ptrdiff_t>(num_verts(m)) - 1);
  const auto p = *polys(m).begin();
  const auto on = [](edge_id x, double t) { return mesh_point<M>{edge_point<M>{x, t}, {}}; };
  for (const double t : {std::nan(""), -0.1, 1.1, double{INFINITY}}) CHECK(has(message({on(e, 0.5), on(e, t)}), "point 1 has the parameter"));
  CHECK(has(message({on(e, 0.5), {last, {}}}), "no poly has both point 0 and point 1"));
  CHECK(has(message({on(e, 0.5), {p, {}}}), "point 1 is inside a poly"));
  std::vector<mesh_point<M>> cross;  // two diagonals between the edges of one poly
  for (const auto x : adj_p2e(m, p)) cross.push_back(on(x, 0.3));
  if (cross.size() == 3) cross = {on(*adj_p2e(m, p).begin(), 0.3), cross[1], cross[2], on(*adj_p2e(m, p).begin(), 0.6), cross[1], cross[2], on(*adj_p2e(m, p).begin(), 0.2), cross[1]};
  else cross = {cross[0], cross[2], cross[3], cross[1]};
  const std::string text = message(cross);
  CHECK((text.empty() || has(text, "crosses itself inside poly 0")));
  if (arity_v<M> == 0) CHECK(!text.empty());
}

TEST_CASE_TEMPLATE("embed_path: in a transaction it is undone", M, trimesh, polygonmesh) {
  std::mt19937 random(4);
  M m = make_grid<M>({.cells = {4, 4, 1}});
  const auto number = poly_property<int>(m, "number");
  for (const auto p : polys(m)) number[p] = 7;
  const auto before = whole(m);
  const auto walk = random_walk(m, random, 3);
  transaction t(m);
  embed_path(m, walk);
  CHECK(whole(m) != before);
  auto edits = t.commit();
  edits.undo();
  CHECK(whole(m) == before);
}
