// split_vert_fans: each fan of polys at a vert gets a vert of its own, in all kinds of mesh; merge_verts is the inverse.
#include <concino/edit.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh.hpp>
#include <concino/validate/validate.hpp>

#include <support/kinds.hpp>
#include <support/rebuilt.hpp>
#include <support/soups.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <map>
#include <random>

namespace cn = concino;
using cn::testing::equals_rebuilt;
using cn::testing::keeps_all_laws;
using cn::testing::raw;
using cn::testing::whole;

namespace {

using list = std::vector<unsigned>;

/// The number of fans at v: polys are joined until no facet at v has polys of different fans.
template<class M>
std::size_t num_fans(const M& m, cn::vert_id v) {
  std::map<unsigned, unsigned> fan;
  for (const auto p : cn::adj_v2p(m, v)) fan[p.raw()] = p.raw();
  const auto join = [&](unsigned a, unsigned b) {
    const unsigned from = fan[b], to = fan[a];
    for (auto& [p, f] : fan)
      if (f == from) f = to;
  };
  for (const auto f : cn::facets(m)) {
    const list corners = raw(cn::adj_facet2v(m, f)), polys = raw(cn::adj_facet2p(m, f));
    if (std::find(corners.begin(), corners.end(), v.raw()) == corners.end()) continue;
    for (const unsigned p : polys) join(polys[0], p);
  }
  std::set<unsigned> different;
  for (const auto& [p, f] : fan) different.insert(f);
  return different.size();
}

template<class M>
std::vector<std::vector<unsigned>> lists_of_polys(const M& m) {
  std::vector<std::vector<unsigned>> all;
  for (const auto p : cn::polys(m)) all.push_back(raw(cn::adj_p2v(m, p)));
  return all;
}

}  // namespace

TEST_CASE_TEMPLATE("split_vert_fans: soups get one fan at each vert, and merging restores them", M, CONCINO_ALL_KINDS) {
  std::mt19937 random(12);
  std::size_t made_in_all = 0;
  for (unsigned round = 0; round < 6; ++round) {
    M m = round == 0 ? M() : cn::testing::random_soup<M>(random, 12, 4 + 2 * round).mesh();
    const M before = m;
    std::size_t expected = 0;
    for (const auto v : cn::verts(m)) expected += std::max<std::size_t>(num_fans(m, v), 1) - 1;
    const auto made = cn::split_vert_fans(m);
    made_in_all += made.size();
    CHECK(made.size() == expected);
    CHECK(cn::num_verts(m) == cn::num_verts(before) + expected);
    CHECK(cn::num_polys(m) == cn::num_polys(before));
    for (const auto v : cn::verts(m)) CHECK(num_fans(m, v) <= 1);
    keeps_all_laws(m);
    if constexpr (!std::same_as<M, cn::polyhedralmesh>) equals_rebuilt(m);
    std::map<unsigned, unsigned> origin;
    for (const auto& x : made) {
      origin[x.vert.raw()] = x.origin.raw();
      CHECK(cn::point(m, x.vert) == cn::point(m, x.origin));
    }
    auto lists = lists_of_polys(m);
    for (auto& one : lists)
      for (unsigned& v : one) v = origin.count(v) ? origin[v] : v;
    const auto lists_before = lists_of_polys(before);
    if constexpr (!std::same_as<M, cn::polyhedralmesh>) CHECK(lists == lists_before);  // those of polyhedra are in another order
    CHECK(cn::split_vert_fans(m).empty());
    bool is_merged = true;
    for (const auto& x : made) is_merged = is_merged && cn::merge_verts(m, x.origin, {x.vert});
    if (!is_merged) continue;  // polys on the same verts
    CHECK(cn::num_edges(m) == cn::num_edges(before));
    if constexpr (!std::same_as<M, cn::polyhedralmesh>) CHECK(lists_of_polys(m) == lists_before);
    keeps_all_laws(m);
  }
  CHECK(made_in_all > 10);
}

TEST_CASE_TEMPLATE("split_vert_fans: grids stay as they are; two that touch at a vert come apart", M, CONCINO_ALL_KINDS) {
  M m = cn::testing::two_grids<M>(2);
  const auto a = cn::vert_property<double>(m, "a");
  for (const auto v : cn::verts(m)) a[v] = v.raw();
  cn::corner_property<int>(m, "g");
  cn::edge_property<int>(m, "h");
  const auto before = whole(m);
  CHECK(cn::split_vert_fans(m).empty());
  CHECK(whole(m) == before);
  cn::vert_id last, first;
  for (const auto v : cn::verts(m)) {
    if (cn::point(m, v) == cn::vec3{1, 0, 0}) first = v;
    if (cn::point(m, v) == cn::vec3{2, 0, 0}) last = v;
  }
  REQUIRE(cn::merge_verts(m, first, {last}));
  const double size = cn::total_measure(m);
  const auto touching = whole(m);
  {
    cn::transaction t(m);
    CHECK(cn::split_vert_fans(m).size() == 1);
    CHECK(whole(m) != touching);
  }
  CHECK(whole(m) == touching);
  for (const auto v : cn::verts(m))
    if (v != first) CHECK(cn::split_vert_fans(m, v).empty());
  const auto made = cn::split_vert_fans(m, first);
  REQUIRE(made.size() == 1);
  CHECK(made[0].origin == first);
  CHECK(a[made[0].vert] == first.raw());
  CHECK(cn::total_measure(m) == size);
  keeps_all_laws(m);
  CHECK_THROWS_WITH_AS(cn::split_vert_fans(m, cn::vert_id{1000}), doctest::Contains("split_vert_fans: vert 1000"), cn::invalid_mesh);
}

TEST_CASE("split_vert_fans: tets that share an edge, and values") {
  // an edge with two fans of tets: {0, 1, 2, 3} and {0, 1, 4, 5}
  cn::tetmesh m({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 2, 3, 1}, {0, 4, 5, 1}});
  const auto mass = cn::vert_property<double>(m, "mass");
  const auto length = cn::edge_property<double>(m, "length");
  const auto corner = cn::corner_property<int>(m, "corner");
  const auto area = cn::face_property<int>(m, "area");
  cn::set_property_rule(m, cn::element_kind::vert, "mass", cn::property_rule::sum);
  cn::set_property_rule(m, cn::element_kind::edge, "length", cn::property_rule::sum);
  for (const auto v : cn::verts(m)) mass[v] = 2;
  for (const auto e : cn::edges(m)) length[e] = 4;
  for (const auto f : cn::faces(m)) area[f] = 7;
  for (const auto p : cn::polys(m))
    for (std::uint32_t k = 0; k < 4; ++k) corner[{p, k}] = static_cast<int>(10 * p.raw() + k);
  CHECK(cn::num_edges(m) == 11);
  const auto one = cn::split_vert_fans(m, cn::vert_id{0});
  REQUIRE(one.size() == 1);
  CHECK(one[0].vert == cn::vert_id{6});
  CHECK(cn::num_edges(m) == 12);
  CHECK(mass[cn::vert_id{0}] == 1);
  CHECK(mass[one[0].vert] == 1);
  const auto other = cn::split_vert_fans(m);
  REQUIRE(other.size() == 1);
  CHECK(other[0].origin == cn::vert_id{1});
  CHECK(cn::validate(m).facts.components == 2);
  double sum = 0;
  for (const auto e : cn::edges(m)) sum += length[e];
  CHECK(sum == 44);
  for (const auto e : cn::edges(m)) CHECK(length[e] >= 2);
  for (const auto f : cn::faces(m)) CHECK(area[f] == 7);
  for (const auto p : cn::polys(m))
    for (std::uint32_t k = 0; k < 4; ++k) CHECK(corner[{p, k}] == static_cast<int>(10 * p.raw() + k));
}

TEST_CASE("split_vert_fans: a vert with three fans, and an edge with three triangles") {
  cn::trimesh m(std::vector<cn::vec3>(8), std::vector<list>{{0, 1, 2}, {0, 3, 4}, {0, 5, 6}, {0, 2, 7}});
  const auto made = cn::split_vert_fans(m, cn::vert_id{0});
  REQUIRE(made.size() == 2);
  CHECK(raw(cn::adj_p2v(m, cn::poly_id{3})) == list{0, 2, 7});
  CHECK(raw(cn::adj_p2v(m, cn::poly_id{1})) == list{8, 3, 4});
  CHECK(raw(cn::adj_p2v(m, cn::poly_id{2})) == list{9, 5, 6});
  cn::trimesh book(std::vector<cn::vec3>(5), std::vector<list>{{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  CHECK(cn::split_vert_fans(book).empty());  // the common edge connects them
}
