// segment_polys and segment_verts on meshes and archetypes, their options, and errors.
#include <concino/graph/segment.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/views.hpp>
#include <concino/edit/elements.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Costs of labels that prefer one third of the elements each, with some that disagree.
constexpr auto thirds = [](std::size_t i, int l) { return static_cast<double>((i / 4 + i % 5 + static_cast<std::size_t>(l)) % 3); };

}  // namespace

TEST_CASE_TEMPLATE("segment_polys, segment_verts: run on meshes and on the archetypes of graphs", M, CONCINO_KINDS) {
  const M m = grid<M>(3);
  const auto g = only_primal_graph(m);
  const auto d = only_dual_graph(m);
  for (const int labels : {1, 2, 3}) {
    for (const label_moves moves : {label_moves::expansion, label_moves::swap}) {
      const segment_options options = {.labels = labels, .smoothness = 0.25, .moves = moves};
      const auto by_polys = segment_polys(m, [](poly_id p, int l) { return thirds(p.raw(), l); }, options);
      const auto bare = segment_polys(d, [&](const auto& p, int l) { return thirds(index_of(d, p), l); }, options);
      const auto by_verts = segment_verts(m, [](vert_id v, int l) { return thirds(v.raw(), l); }, options);
      const auto bare_verts = segment_verts(g, [&](const auto& v, int l) { return thirds(index_of(g, v), l); }, options);
      CHECK(by_polys.energy == bare.energy);
      CHECK(by_verts.energy == bare_verts.energy);
      for (const auto x : polys(d)) CHECK(bare.label[x] == by_polys.label[d.base(x)]);
      for (const auto x : verts(g)) CHECK(bare_verts.label[x] == by_verts.label[g.base(x)]);
      for (const poly_id p : polys(m)) CHECK((by_polys.label[p] >= 0 && by_polys.label[p] < labels));
      CHECK(by_polys.rounds.back() == by_polys.energy);
      CHECK(segment_polys(dual(m), [](poly_id p, int l) { return thirds(p.raw(), l); }, options).energy == by_polys.energy);
    }
  }
}

TEST_CASE("segment_polys: smoothness joins, and labels that are not allowed are not taken") {
  const auto m = grid<quadmesh>(6);
  const auto column = [](poly_id p) { return static_cast<int>(p.raw() % 6); };
  // Each column prefers a label; one poly disagrees.
  const poly_id odd{14};
  const auto cost = [&](poly_id p, int l) { return l == (p == odd ? 2 : column(p) / 3) ? 0.0 : 1.0; };
  const auto rough = segment_polys(m, cost, {.labels = 3, .smoothness = 0});
  for (const poly_id p : polys(m)) CHECK(rough.label[p] == (p == odd ? 2 : column(p) / 3));
  CHECK(rough.energy == 0);
  CHECK(rough.rounds.size() == 1);
  const auto smooth = segment_polys(m, cost, {.labels = 3, .smoothness = 0.5});
  for (const poly_id p : polys(m)) CHECK(smooth.label[p] == column(p) / 3);
  CHECK(smooth.energy == 1 + 6 * 0.5);
  CHECK(smooth.rounds.front() == (6 + 3) * 0.5);
  const auto one = segment_polys(m, cost, {.labels = 3, .smoothness = 50});
  for (const poly_id p : polys(m)) CHECK(one.label[p] == one.label[odd]);
  // The poly that disagrees may have label 2 only.
  for (const label_moves moves : {label_moves::expansion, label_moves::swap}) {
    const auto forced = segment_polys(m, [&](poly_id p, int l) { return p == odd && l != 2 ? infinity : cost(p, l); },
                                      {.labels = 3, .smoothness = 0.5, .moves = moves});
    CHECK(forced.label[odd] == 2);
    CHECK(forced.energy == (6 + 3) * 0.5);
  }
}

TEST_CASE("segment_polys: meshes without polys, isolated polys, gaps in the indices") {
  const quadmesh none;
  const auto empty = segment_polys(none, [](poly_id, int) { return 0; }, {.labels = 3});
  CHECK(empty.energy == 0);
  const auto one = grid<quadmesh>(1);
  CHECK(segment_polys(one, [](poly_id, int l) { return -l; }, {.labels = 4}).energy == -3);
  auto m = grid<quadmesh>(3);
  remove_poly(m, poly_id{4});
  const auto found = segment_polys(m, [](poly_id p, int l) { return p.raw() < 4 ? l : 1 - l; }, {.smoothness = 0.125});
  for (const poly_id p : polys(m)) CHECK(found.label[p] == (p.raw() > 4));
}

TEST_CASE("segment_polys: costs scale, and the order of labels is that of costs") {
  const auto m = grid<trimesh>(5);
  const auto cost = [](double scale) { return [=](poly_id p, int l) { return scale * std::fmod(p.raw() * 0.37 + l * 0.71, 1.0); }; };
  const auto found = segment_polys(m, cost(1), {.labels = 3, .smoothness = 0.2});
  for (const double scale : {0x1p-900, 0x1p900}) {
    const auto scaled = segment_polys(m, cost(scale), {.labels = 3, .smoothness = 0.2 * scale});
    CHECK(scaled.energy == found.energy * scale);
    for (const poly_id p : polys(m)) CHECK(scaled.label[p] == found.label[p]);
  }
}

TEST_CASE("segment_polys: progress and cancellation") {
  const auto m = grid<quadmesh>(3);
  const auto cost = [](poly_id p, int l) { return thirds(p.raw(), l); };
  std::vector<double> fractions;
  const auto count = [&](double f, const char* label) {
    CHECK(label == std::string("segment_polys"));
    fractions.push_back(f);
    return true;
  };
  segment_polys(m, cost, {.labels = 3, .progress = count});
  CHECK(fractions.size() >= 3);
  CHECK(fractions[0] == 0);
  CHECK_THROWS_AS(segment_polys(m, cost, {.labels = 3, .progress = [](double, const char*) { return false; }}), cancelled);
}

TEST_CASE("segment_polys: throws if an argument is invalid") {
  const auto m = grid<quadmesh>(2);
  const auto zero = [](poly_id, int) { return 0.0; };
  CHECK_THROWS_WITH_AS(segment_polys(m, zero, {.labels = 0}), "segment_polys: labels must be 1 or more", invalid_argument);
  for (const double s : {-1.0, std::nan(""), infinity})
    CHECK_THROWS_WITH_AS(segment_polys(m, zero, {.smoothness = s}), "segment_polys: smoothness must be finite and 0 or more", invalid_argument);
  CHECK_THROWS_WITH_AS(segment_polys(m, [](poly_id p, int l) { return p == poly_id{2} && l == 1 ? std::nan("") : 0; }),
                       "segment_polys: the cost of label 1 for poly 2 is not a number; costs must be finite, or +inf for a label that is not allowed", invalid_argument);
  CHECK_THROWS_WITH_AS(segment_polys(m, [](poly_id, int) { return -infinity; }), doctest::Contains("the cost of label 0 for poly 0 is -inf"), invalid_argument);
  CHECK_THROWS_WITH_AS(segment_verts(m, [](vert_id v, int) { return v == vert_id{3} ? infinity : 0; }),
                       "segment_verts: all labels of vert 3 cost +inf; at least one must be finite", invalid_argument);
  CHECK_THROWS_WITH_AS(segment_polys(m, zero, [](auto, auto, int a, int) { return a == 1 ? -2.0 : 0; }),
                       "segment_polys: the pairwise cost of label 1 for poly 0 and label 0 for poly 1 is -2; it must be finite and 0 or more", invalid_argument);
  CHECK_THROWS_WITH_AS(segment_polys(m, zero, [](auto, auto, int, int) { return std::nan(""); }), doctest::Contains("is not a number; it must be finite"), invalid_argument);
  CHECK_THROWS_WITH_AS(segment_polys(m, zero, [](auto, auto, int a, int b) { return a == b ? 1 : 0; }),
                       "segment_polys: the pairwise costs of poly 0 and poly 1 have cost(0, 0) + cost(1, 1) > cost(0, 1) + cost(1, 0); "
                       "equal labels must not cost more than different ones",
                       invalid_argument);
  CHECK_THROWS_WITH_AS(segment_polys(m, zero, [](auto, auto, int a, int b) { return (a - b) * (a - b); }, {.labels = 3}),
                       "segment_polys: the pairwise costs of poly 0 and poly 1 have cost(1, 1) + cost(0, 2) > cost(1, 2) + cost(0, 1); "
                       "expansions need the triangle inequality; label_moves::swap does not",
                       invalid_argument);
}
