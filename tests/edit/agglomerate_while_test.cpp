// agglomerate_while, and the invariants on edits of polygons and polyhedra: min_stability, min_quality, no_inversion, labels, protected edges and faces.
#include <concino/edit.hpp>
#include <concino/edit/min_stability.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh.hpp>
#include <concino/operators/stability.hpp>
#include <concino/quality/poly_quality.hpp>

#include <support/random_poly_edits.hpp>
#include <support/simplex_edits.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace cn = concino;
using namespace cn::testing;
using lists = std::vector<std::vector<unsigned>>;

namespace {

cn::polygonmesh polygon(const std::vector<cn::vec3>& x) {
  std::vector<unsigned> all;
  for (unsigned i = 0; i < x.size(); ++i) all.push_back(i);
  return cn::polygonmesh(x, lists{all});
}
std::vector<cn::vec3> regular(unsigned n, double size) {
  std::vector<cn::vec3> x;
  for (unsigned i = 0; i < n; ++i) x.push_back({size * std::cos(2 * std::numbers::pi * i / n), size * std::sin(2 * std::numbers::pi * i / n), 0});
  return x;
}

}  // namespace

TEST_CASE("stability: 1 for regular polygons of any size and cubes, small for bad shapes") {
  for (unsigned n = 3; n < 40; ++n)
    for (const double size : {1e-100, 1.0, 1e100}) CHECK(cn::stability(polygon(regular(n, size)), cn::poly_id{0}) == doctest::Approx(1));
  CHECK(cn::hexagon_eigenvalue_ratio == 1);
  CHECK(cn::stability(grid<cn::hexmesh>(1), cn::poly_id{0}) == doctest::Approx(1));
  CHECK(cn::stability(cn::polyhedralmesh(extrude(quad_grid(1), 1)), cn::poly_id{0}) == doctest::Approx(1));
  CHECK(cn::stability(grid<cn::tetmesh>(1), cn::poly_id{0}) > 0.1);
  CHECK(cn::stability(polygon({{0, 0, 0}, {1, 0, 0}, {1, 0.01, 0}, {0, 0.01, 0}}), cn::poly_id{0}) < 0.05);
  CHECK(cn::stability(polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), cn::poly_id{0}) == 0);
  CHECK(cn::stability(polygon({{0, 0, 0}, {1, 0, 0}, {std::nan(""), 1, 0}}), cn::poly_id{0}) == 0);
}

TEST_CASE_TEMPLATE("min_stability and min_quality: the new polys keep the limit, and a merge that would break it is refused", M, cn::polygonmesh, cn::polyhedralmesh) {
  std::mt19937 random(3);
  const M start = [] {
    if constexpr (cn::VolumeMesh<M>) return M(jittered(extrude(quad_grid(3), 3), 0.01));
    else return M(jittered(with_offsets(quad_grid(6)), 0.05, false));
  }();
  for (unsigned kind = 0; kind < (cn::VolumeMesh<M> ? 2u : 3u); ++kind) {  // corners of merged boxes are flat
    M m = start;
    unsigned done = 0, refused = 0;
    const auto value = [&](cn::poly_id p) {
      return kind == 0 ? cn::stability(m, p) : kind == 1 ? cn::star_shapedness(m, p) : cn::scaled_jacobian(m, p);
    };
    const double limit = kind == 0 ? 0.3 : kind == 1 ? (cn::VolumeMesh<M> ? 0.3 : 0.8) : 0.3;
    const cn::invariant keep = kind == 0 ? cn::invariant(cn::min_stability(limit)) : cn::invariant(cn::min_quality(limit, kind == 1 ? cn::metric::star_shapedness : cn::metric::scaled_jacobian));
    for (unsigned i = 0; i < 150 && cn::num_polys(m) > 2; ++i) {
      const auto f = some_element_of(m, cn::facets(m), cn::facet_index_bound(m), random);
      M copy = m;
      const auto free = cn::merge_polys(copy, f);
      const auto r = cn::merge_polys(m, f, {.keep = {keep}});
      if (r) {
        ++done;
        CHECK(value(r.poly) >= limit);
      } else if (free) {
        ++refused;
        CHECK(r.reason == cn::refusal::invariant);
        std::swap(m, copy);
        CHECK(value(free.poly) < limit);
        std::swap(m, copy);
      }
    }
    CHECK_MESSAGE(done > 0, kind);
    CHECK_MESSAGE(refused > 0, kind);
  }
}

TEST_CASE("no_inversion: edits of polygons and polyhedra that would turn a poly") {
  // the chord lies outside the concave polygon
  cn::polygonmesh m({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 0.2, 0}, {0, 2, 0}}, {{0, 1, 2, 3, 4}});
  CHECK(cn::can_poly_cut(m, cn::poly_id{0}, cn::vert_id{2}, cn::vert_id{4}));
  CHECK(cn::can_poly_cut(m, cn::poly_id{0}, cn::vert_id{2}, cn::vert_id{4}, {.keep = {cn::no_inversion}}).reason == cn::refusal::invariant);
  CHECK(cn::can_poly_cut(m, cn::poly_id{0}, cn::vert_id{0}, cn::vert_id{3}, {.keep = {cn::no_inversion}}));
  CHECK(cn::can_poly_cut(m, cn::poly_id{0}, cn::vert_id{1}, cn::vert_id{4}, {.keep = {cn::no_inversion}}).reason == cn::refusal::none);
  std::mt19937 random(8);
  cn::polyhedralmesh v(extrude(quad_grid(3), 3));
  unsigned done = 0;
  for (unsigned i = 0; i < 300 && cn::num_polys(v) > 5; ++i) {
    const auto e = some_edge(v, random);
    const auto at = [&] { return 4 * static_cast<double>(random() % 1000) / 1000 - 1.5; };
    if (cn::edge_collapse(v, e, {.keep = {cn::no_inversion}, .point = cn::vec3{at(), at(), at()}})) {
      ++done;
      for (const auto p : cn::polys(v)) REQUIRE(cn::measure(v, p) > 0);
    }
  }
  CHECK(done > 3);
}

TEST_CASE("keep_labels, protect_edges and protect_faces: edits of polygons and polyhedra") {
  auto m = grid<cn::polygonmesh>(3);
  const auto label = [](cn::poly_id p) { return p.raw() % 2; };
  const auto shape = [](const cn::polygonmesh& x, cn::edge_id e) { return cn::num_elements(cn::adj_e2p(x, e)) == 2; };
  unsigned of_labels = 0, of_edges = 0;
  for (const auto e : cn::edges(m)) {
    if (!shape(m, e) || !cn::can_merge_polys(m, e)) continue;
    bool same = true;
    unsigned first = 2;
    for (const auto p : cn::adj_e2p(m, e)) same = same && (first == 2 || first == label(p)), first = label(p);
    CHECK(bool(cn::can_merge_polys(m, e, {.keep = {cn::keep_labels(m, label)}})) == same);
    of_labels += !same;
    const auto is_this = [&](cn::edge_id x) { return x == e; };
    CHECK(cn::can_merge_polys(m, e, {.keep = {cn::protect_edges(m, is_this)}}).reason == cn::refusal::invariant);
    CHECK(cn::can_edge_split(m, e, 0.5, {.keep = {cn::protect_edges(m, is_this)}}).reason == cn::refusal::invariant);
    CHECK(cn::can_merge_polys(m, e, {.keep = {cn::protect_edges(m, [](cn::edge_id) { return false; })}}));
    ++of_edges;
  }
  CHECK(of_labels > 0);
  CHECK(of_edges > 0);
  cn::polyhedralmesh v(extrude(quad_grid(2), 2));
  for (const auto f : cn::faces(v)) {
    if (!cn::can_merge_polys(v, f)) continue;
    CHECK(cn::can_merge_polys(v, f, {.keep = {cn::protect_faces(v, [&](cn::face_id x) { return x == f; })}}).reason == cn::refusal::invariant);
    CHECK(cn::can_merge_polys(v, f, {.keep = {cn::protect_faces(v, [](cn::face_id) { return false; })}}));
  }
  for (const auto e : cn::edges(v)) {
    if (!cn::can_edge_collapse(v, e)) continue;
    CHECK(cn::can_edge_collapse(v, e, {.keep = {cn::protect_edges(v, [&](cn::edge_id x) { return x == e; })}}).reason == cn::refusal::invariant);
    CHECK(cn::can_edge_collapse(v, e, {.keep = {cn::keep_labels(v, [](cn::poly_id) { return 1; })}}));
  }
  cn::polygonmesh other = m;
  cn::edge_id inside;
  for (const auto e : cn::edges(m))
    if (cn::can_merge_polys(m, e)) inside = e;
  CHECK_THROWS_AS(cn::can_merge_polys(other, inside, {.keep = {cn::keep_labels(m, label)}}), cn::invalid_argument);
}

TEST_CASE_TEMPLATE("agglomerate_while: to a target, and as far as the invariant allows", M, cn::polygonmesh, cn::polyhedralmesh) {
  const M start = [] {
    if constexpr (cn::VolumeMesh<M>) return M(jittered(extrude(quad_grid(5), 5), 0.03));
    else return M(jittered(with_offsets(quad_grid(12)), 0.02, false));
  }();
  const double size = cn::total_measure(start);
  const auto facts = topology(start);
  M m = start;
  const auto all = [](const cn::proposed_edit&) { return cn::permission{}; };
  const auto r = cn::agglomerate_while(m, all, {.target = 20});
  CHECK(r.reached_target);
  CHECK(r.last_refusal);
  CHECK(cn::num_polys(m) == 20);
  CHECK(r.num_merges == cn::num_polys(start) - 20);
  CHECK(std::abs(cn::total_measure(m) - size) < 1e-12 * size);
  CHECK(topology(m) == facts);
  keeps_all_laws(m), equals_rebuilt(m);

  M stable = start;
  const auto limit = 0.35;
  const auto s = cn::agglomerate_while(stable, cn::min_stability(limit), {.target = 1});
  CHECK_FALSE(s.reached_target);
  CHECK(s.last_refusal.reason != cn::refusal::none);
  CHECK(cn::num_polys(stable) > 1);
  CHECK(cn::num_polys(stable) == cn::num_polys(start) - s.num_merges);
  for (const auto p : cn::polys(stable))
    if (cn::num_elements(cn::adj_p2v(stable, p)) > (cn::VolumeMesh<M> ? 8u : 4u)) CHECK(cn::stability(stable, p) >= limit);
  keeps_all_laws(stable), equals_rebuilt(stable);
  MESSAGE(cn::num_polys(start) << " polys, " << cn::num_polys(stable) << " with a stability of " << limit);

  M again = start;
  CHECK(cn::agglomerate_while(again, cn::min_stability(limit)).num_merges == s.num_merges);  // the same each time
  CHECK(whole(again) == whole(stable));
  CHECK(cn::agglomerate_while(again, all, {.target = cn::num_polys(again) + 3}).num_merges == 0);
  M none;
  CHECK(cn::agglomerate_while(none, all).reached_target);
  M stopped = start;
  CHECK_THROWS_AS(cn::agglomerate_while(stopped, all, {.progress = [](double, const char*) { return false; }}), cn::cancelled);
  CHECK(whole(stopped) == whole(start));
}
