// vert_split: counts, corners and winding of the new polys; that it is the inverse of edge_collapse; refusals.
#include <concino/edit/edge_collapse.hpp>
#include <concino/edit/vert_split.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh.hpp>

#include <support/simplex_edits.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <random>

namespace cn = concino;
using cn::testing::element_counts;
using cn::testing::equals_rebuilt;
using cn::testing::keeps_all_laws;
using cn::testing::raw;
using cn::testing::topology;

namespace {

using some_polys = std::vector<cn::poly_id>;

/// The polys with their orientation: corners sorted, and whether that took an odd number of exchanges.
template<class M>
std::multiset<std::pair<std::vector<unsigned>, bool>> oriented_polys(const M& m, unsigned rename = ~0u, unsigned as = ~0u) {
  std::multiset<std::pair<std::vector<unsigned>, bool>> all;
  for (const auto p : cn::polys(m)) {
    std::vector<unsigned> v = raw(cn::adj_p2v(m, p));
    std::replace(v.begin(), v.end(), rename, as);
    bool is_odd = false;
    for (std::size_t i = 0; i < v.size(); ++i)
      for (std::size_t k = i + 1; k < v.size(); ++k) is_odd ^= v[k] < v[i];
    std::sort(v.begin(), v.end());
    all.insert({v, is_odd});
  }
  return all;
}

template<class M>
void is_refused_split(M m, unsigned v, const some_polys& moved, cn::refusal reason) {
  const auto before = cn::testing::whole(m);
  CHECK(cn::can_vert_split(m, cn::vert_id{v}, moved, {1, 2, 3}).reason == reason);
  const auto made = cn::vert_split(m, cn::vert_id{v}, moved, {1, 2, 3}, {.kept_point = cn::vec3{5, 5, 5}});
  CHECK(made.reason == reason);
  CHECK_FALSE(made.why.empty());
  CHECK(cn::testing::whole(m) == before);
}

}  // namespace

TEST_CASE("vert_split: the centre of a hexagon") {
  std::vector<cn::vec3> x{{0, 0, 0}};
  std::vector<std::vector<unsigned>> fan;
  for (unsigned i = 0; i < 6; ++i) x.push_back({std::cos(i * 1.0471975512), std::sin(i * 1.0471975512), 0}), fan.push_back({0, i + 1, (i + 1) % 6 + 1});
  cn::trimesh m(x, fan);
  const double area = cn::total_measure(m);
  const auto made = cn::vert_split(m, cn::vert_id{0}, some_polys{cn::poly_id{0}, cn::poly_id{1}}, {0.1, 0.2, 0}, {.kept_point = cn::vec3{-0.1, -0.2, 0}});
  REQUIRE(made);
  CHECK(made.vert == cn::vert_id{7});
  CHECK(cn::to_vec3(cn::point(m, cn::vert_id{0})) == cn::vec3{-0.1, -0.2, 0});
  CHECK(element_counts(m) == std::vector<std::ptrdiff_t>{8, 15, 8});
  CHECK(raw(cn::adj_p2v(m, cn::poly_id{1})) == std::vector<unsigned>{7, 2, 3});
  CHECK(cn::testing::raw_set(cn::adj_p2v(m, cn::poly_id{6})) == std::set<unsigned>{0, 1, 7});
  CHECK(cn::testing::raw_set(cn::adj_p2v(m, cn::poly_id{7})) == std::set<unsigned>{0, 3, 7});
  CHECK(cn::total_measure(m) == doctest::Approx(area));
  CHECK(cn::validate(m).is_clean());
  keeps_all_laws(m);
}

TEST_CASE_TEMPLATE("vert_split: undoes edge_collapse", M, cn::trimesh, cn::tetmesh, cn::polygonmesh) {
  std::mt19937 random(3);
  M m = [&] {
    if constexpr (cn::dimension_v<M> == 3) return cn::testing::grid<M>(3);
    else return M(cn::testing::grid_arrays<cn::trimesh>(6));
  }();
  unsigned done = 0;
  for (unsigned i = 0; i < 100; ++i) {
    const std::vector<unsigned> all = raw(cn::edges(m));
    const cn::edge_id e{all[random() % all.size()]};
    const auto ends = cn::end_verts(m, e);
    const cn::vec3 x = cn::to_vec3(cn::point(m, ends.first)), y = cn::to_vec3(cn::point(m, ends.second));
    const auto undo = cn::inverse_of_collapse(m, e);
    const auto polys = oriented_polys(m);
    const auto counts = element_counts(m), before = topology(m);
    const double measure = cn::total_measure(m);
    if (!cn::edge_collapse(m, e)) continue;
    REQUIRE(cn::can_vert_split(m, ends.first, undo.moved, y, {.opened = undo.opened}));
    const auto made = cn::vert_split(m, ends.first, undo.moved, y, {.kept_point = x, .opened = undo.opened});
    REQUIRE(made);
    CHECK(oriented_polys(m, made.vert.raw(), ends.second.raw()) == polys);
    CHECK(element_counts(m) == counts);
    CHECK(topology(m) == before);
    CHECK(cn::total_measure(m) == doctest::Approx(measure));
    ++done;
  }
  CHECK(done > 20);
  keeps_all_laws(m);
  equals_rebuilt(m);
}

TEST_CASE_TEMPLATE("vert_split: random sets of polys, of which a collapse restores the mesh", M, cn::trimesh, cn::tetmesh) {
  std::mt19937 random(8);
  unsigned done = 0;
  for (unsigned round = 0; round < 30; ++round) {
    M m = round % 2 ? cn::testing::random_soup<M>(random, 9, 14).mesh() : cn::testing::grid<M>(2);
    const auto before = topology(m);
    for (unsigned i = 0; i < 20; ++i) {
      const std::vector<unsigned> all = raw(cn::verts(m));
      const cn::vert_id v{all[random() % all.size()]};
      some_polys moved;
      for (const auto p : cn::adj_v2p(m, v))
        if (random() % 2) moved.push_back(p);
      const auto polys = oriented_polys(m);
      const auto old = cn::testing::whole(m);
      const auto made = cn::vert_split(m, v, moved, {0.5, 0.6, 0.7});
      if (!made) {
        CHECK(cn::testing::whole(m) == old);
        continue;
      }
      ++done;
      CHECK(topology(m) == before);
      M again = m;
      const auto e = cn::testing::edge_between_verts(again, v.raw(), made.vert.raw());
      const bool is_first = cn::end_verts(again, e).first == v;
      REQUIRE(cn::edge_collapse(again, e));
      CHECK(oriented_polys(again, made.vert.raw(), is_first ? made.vert.raw() : v.raw()) == polys);
    }
    keeps_all_laws(m);
    equals_rebuilt(m);
  }
  CHECK(done > 30);
}

TEST_CASE("vert_split: what is refused") {
  using cn::poly_id, cn::refusal;
  const cn::trimesh m = cn::testing::grid<cn::trimesh>(2);  // vert 4 is inside
  some_polys at, not_at;
  for (const auto p : cn::polys(m)) (cn::testing::raw_set(cn::adj_p2v(m, p)).count(4) ? at : not_at).push_back(p);
  is_refused_split(m, 4, {}, refusal::wrong_set);
  is_refused_split(m, 4, at, refusal::wrong_set);
  is_refused_split(m, 4, {at[0], at[0]}, refusal::wrong_set);
  is_refused_split(m, 4, {at[0], not_at[0]}, refusal::wrong_set);
  // every second triangle around a vert: they would only touch at the new vert
  std::vector<std::vector<unsigned>> fan;
  for (unsigned i = 0; i < 6; ++i) fan.push_back({0, i + 1, (i + 1) % 6 + 1});
  is_refused_split(cn::trimesh(std::vector<cn::vec3>(7), fan), 0, {poly_id{0}, poly_id{2}, poly_id{4}}, refusal::link_condition);
  // two fans that share only the vert
  is_refused_split(cn::trimesh(std::vector<cn::vec3>(5), std::vector<std::vector<unsigned>>{{0, 1, 2}, {0, 3, 4}}), 0, {poly_id{0}}, refusal::wrong_set);
  const cn::quadmesh q = cn::testing::grid<cn::quadmesh>(2);
  is_refused_split(q, 4, {poly_id{0}}, refusal::not_simplices);

  cn::trimesh copy = m;
  CHECK_THROWS_WITH_AS(cn::vert_split(copy, cn::vert_id{99}, at, {}), "vert_split: vert 99 is not a vert of the mesh", cn::invalid_mesh);
  CHECK_THROWS_WITH_AS(cn::vert_split(copy, cn::vert_id{4}, some_polys{poly_id{99}}, {}), "vert_split: poly 99 is not a poly of the mesh", cn::invalid_mesh);
  CHECK_THROWS_AS(cn::can_vert_split(copy, cn::vert_id{99}, at, {}), cn::invalid_mesh);
  const cn::vec3 infinite{0, 0, std::numeric_limits<double>::infinity()};
  CHECK_THROWS_AS(cn::vert_split(copy, cn::vert_id{4}, some_polys{at[0]}, infinite), cn::invalid_argument);
  CHECK_THROWS_AS(cn::vert_split(copy, cn::vert_id{4}, some_polys{at[0]}, {}, {.kept_point = infinite}), cn::invalid_argument);
  CHECK(cn::testing::whole(copy) == cn::testing::whole(m));
}
