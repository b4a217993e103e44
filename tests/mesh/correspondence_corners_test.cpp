// The origins of corners follow from those of their polys and verts, when polys are split, merged, renumbered or new.
#include <concino/mesh/corner_property.hpp>
#include <concino/mesh/correspondence.hpp>

#include <concino/edit.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <span>
#include <string>
#include <utility>
#include <vector>

using namespace concino;

namespace {

/// Two squares side by side: 0 1 2 3 and 1 4 5 2.
polygonmesh two_squares() {
  return polygonmesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}}, {{0, 1, 2, 3}, {1, 4, 5, 2}});
}

/// Two copies of the triangle 0 1 2, and the origins: poly 0 with these weights in the one and the other.
struct split_triangle {
  trimesh before{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  trimesh after{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
  correspondence c;

  split_triangle(double first, double second) {
    c.verts = element_origins({0, 1, 2});
    c.polys.add({{0, first}}), c.polys.add({{0, second}});
    const auto u = corner_property<double>(before, "u");
    for (std::uint32_t k = 0; k < 3; ++k) u[{poly_id{0}, k}] = 8.0 * (k + 1);
  }
};

}  // namespace

TEST_CASE("origins of corners: sums are split as the poly is, and each part of a split poly has the mean of its own corners") {
  for (const auto& [first, second, share] : {std::array{0.25, 0.75, 0.25}, {2.0, 6.0, 0.25}, {0.0, 1.0, 0.0}, {1.0, 1.0, 0.5}, {0.0, 0.0, 0.5}}) {
    split_triangle s(first, second);
    transfer_properties(s.before, s.after, s.c);
    const auto means = find_corner_property<double>(s.after, "u");
    for (std::uint32_t k = 0; k < 3; ++k) {
      CHECK(means[{poly_id{0}, k}] == 8.0 * (k + 1));
      CHECK(means[{poly_id{1}, k}] == 8.0 * ((3 - k) % 3 + 1));
    }
    set_property_rule(s.before, element_kind::corner, "u", property_rule::sum);
    transfer_properties(s.before, s.after, s.c);
    const auto sums = find_corner_property<double>(s.after, "u");
    for (std::uint32_t k = 0; k < 3; ++k) {
      CHECK(sums[{poly_id{0}, k}] == share * 8.0 * (k + 1));
      CHECK(sums[{poly_id{1}, k}] == (1 - share) * 8.0 * ((3 - k) % 3 + 1));
    }
  }
}

TEST_CASE("origins of corners: a corner at a quarter of an edge has a quarter and three quarters of the values at its ends") {
  trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  trimesh split({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0, 0}}, {{0, 3, 2}, {3, 1, 2}});
  const auto u = corner_property<double>(m, "u");
  for (std::uint32_t k = 0; k < 3; ++k) u[{poly_id{0}, k}] = 16.0 * k;
  for (const double weight : {0.5, 1.0, 3.0}) {
    correspondence c;
    for (const std::uint32_t v : {0u, 1u, 2u}) c.verts.add(v);
    c.verts.add({{0, 0.75}, {1, 0.25}});
    c.polys.add({{0, weight}}), c.polys.add({{0, 3 * weight}});
    transfer_properties(m, split, c);
    const auto found = find_corner_property<double>(split, "u");
    CHECK(found[{poly_id{0}, 0}] == 0);
    CHECK(found[{poly_id{0}, 1}] == doctest::Approx(4).epsilon(1e-14));
    CHECK(found[{poly_id{0}, 2}] == 32);
    CHECK(found[{poly_id{1}, 0}] == doctest::Approx(4).epsilon(1e-14));
    CHECK(found[{poly_id{1}, 1}] == 16);
    CHECK(found[{poly_id{1}, 2}] == 32);
  }
}

TEST_CASE("origins of corners: a merged poly has the mean of the corners at each vert, weighted by its polys") {
  polygonmesh m = two_squares();
  const auto u = corner_property<double>(m, "u");
  for (std::uint32_t k = 0; k < 4; ++k) u[{poly_id{0}, k}] = 16.0 * k, u[{poly_id{1}, k}] = 100 + 16.0 * k;
  polygonmesh one({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}}, {{5, 2, 3, 0, 1, 4}});
  for (const auto& [first, second] : {std::pair{1.0, 1.0}, {1.0, 3.0}, {3.0, 1.0}, {6.0, 2.0}}) {
    correspondence c;
    c.verts = element_origins({0, 1, 2, 3, 4, 5});
    c.polys.add({{0, first}, {1, second}});
    transfer_properties(m, one, c);
    const auto mean = [&, a = first, b = second](double x, double y) { return doctest::Approx((a * x + b * y) / (a + b)).epsilon(1e-14); };
    const auto found = find_corner_property<double>(one, "u").of(poly_id{0});
    REQUIRE(found.size() == 6);
    CHECK(found[0] == 132);
    CHECK(found[1] == mean(32, 148));
    CHECK(found[2] == 48);
    CHECK(found[3] == 0);
    CHECK(found[4] == mean(16, 100));
    CHECK(found[5] == 116);
  }
}

TEST_CASE("origins of corners: corners without origin have default values, and so have those whose vert is not in the poly before") {
  polygonmesh m = two_squares(), next = two_squares();
  const auto u = corner_property<std::string>(m, "u");
  for (const poly_id p : polys(m))
    for (std::uint32_t k = 0; k < 4; ++k) u[{p, k}] = std::to_string(10 * p.raw() + k);
  const auto found = [&](const element_origins& of_verts, const element_origins& of_polys) {
    correspondence c;
    c.verts = of_verts, c.polys = of_polys;
    transfer_properties(m, next, c);
    std::vector<std::string> values;
    for (const poly_id p : polys(next))
      for (const std::string& x : find_corner_property<std::string>(next, "u").of(p)) values.push_back(x);
    return values;
  };
  using words = std::vector<std::string>;
  constexpr std::uint32_t no = element_origins::none;
  CHECK(found(element_origins({0, 1, 2, 3, 4, 5}), element_origins({0, no})) == words{"0", "1", "2", "3", "", "", "", ""});
  CHECK(found(element_origins({0, 1, 2, 3, 4, 5}), element_origins({no, 1})) == words{"", "", "", "", "10", "11", "12", "13"});
  CHECK(found(element_origins({0, no, 2, 3, 4, 5}), element_origins({0, 1})) == words{"0", "", "2", "3", "", "11", "12", "13"});
  CHECK(found(element_origins({0, 1, 2, 3, 4, 5}), element_origins({1, 0})) == words{"", "10", "13", "", "1", "", "", "2"});
}

TEST_CASE_TEMPLATE("origins of corners: follow removed and renumbered polys", M, CONCINO_KINDS) {
  M m = testing::grid<M>(2);
  const auto u = corner_property<double>(m, "u");
  const auto value = [](poly_id p, vert_id v) { return 1000.0 * p.raw() + v.raw() + 1; };
  for (const poly_id p : polys(m)) {
    std::uint32_t k = 0;
    for (const vert_id v : adj_p2v(m, p)) u[{p, k++}] = value(p, v);
  }
  M to = testing::grid<M>(2);
  correspondence c;
  for (const vert_id v : verts(m)) c.verts.add(v.raw());
  for (const poly_id p : polys(m)) c.polys.add(p.raw());
  remove_poly(to, poly_id{0});
  transfer_properties(m, to, c);
  for (const poly_id p : polys(to)) {
    std::uint32_t k = 0;
    for (const vert_id v : adj_p2v(to, p)) CHECK(find_corner_property<double>(to, "u")[{p, k++}] == value(p, v));
  }
}

TEST_CASE_TEMPLATE("origins of corners: given ones are used as they are, and checked", M, CONCINO_KINDS) {
  M m = testing::grid<M>(1), to = testing::grid<M>(1);
  const std::size_t n = traits<M>::corner_index_bound(m);
  const auto u = corner_property<double>(m, "u");
  for (const poly_id p : polys(m))
    for (double& x : u.of(p)) x = static_cast<double>(&x - u.of(poly_id{0}).data());
  correspondence c;
  std::vector<std::uint32_t> reversed;
  for (std::size_t i = 0; i < n; ++i) reversed.push_back(static_cast<std::uint32_t>(n - 1 - i));
  c.corners = element_origins(reversed);
  transfer_properties(m, to, c);  // no other kind is needed
  const auto found = find_corner_property<double>(to, "u");
  for (const poly_id p : polys(to))
    for (std::uint32_t k = 0; k < found.of(p).size(); ++k) CHECK(found[{p, k}] == static_cast<double>(n - 1 - corner_index(to, {p, k})));
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<std::uint32_t> beyond = reversed;
    beyond[i] = static_cast<std::uint32_t>(n);
    c.corners = element_origins(beyond);
    CHECK_THROWS_AS(transfer_properties(m, to, c), invalid_argument);
  }
  reversed.pop_back();
  c.corners = element_origins(reversed);
  CHECK_THROWS_AS(transfer_properties(m, to, c), invalid_argument);
  // Verts and edges are given too: the corners stay as they are.
  M of_edges = m;
  edge_property<int>(of_edges, "e");
  reversed.push_back(0);
  c.corners = element_origins(reversed);
  for (const vert_id v : verts(m)) c.verts.add(v.raw());
  for (const poly_id p : polys(m)) c.polys.add(p.raw());
  transfer_properties(of_edges, to, c);
  CHECK(find_edge_property<int>(to, "e"));
  CHECK(find_corner_property<double>(to, "u").of(poly_id{0})[0] == static_cast<double>(n - 1));
}

TEST_CASE_TEMPLATE("correspondence: corners of removed polys are no origins", M, CONCINO_KINDS) {
  const M whole = testing::grid<M>(2);
  M m = whole, to = whole;
  const auto u = corner_property<double>(m, "u");
  for (const poly_id p : polys(m))
    for (double& x : u.of(p)) x = 1;
  remove_poly(m, poly_id{0});
  correspondence c;
  for (const vert_id v : verts(to)) c.verts.add(v.raw());
  for (const poly_id p : polys(to)) c.polys.add(p.raw());
  transfer_properties(m, to, c);
  for (const poly_id p : polys(to))
    for (const double x : find_corner_property<double>(to, "u").of(p)) CHECK(x == (p == poly_id{0} ? 0 : 1));
}
