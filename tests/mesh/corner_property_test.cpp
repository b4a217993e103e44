// Properties of corners have unique indices, and follow edits, copies and conversions of the mesh.
#include <concino/mesh/corner_property.hpp>

#include <concino/convert.hpp>
#include <concino/edit.hpp>
#include <concino/generate/agglomerate.hpp>
#include <concino/mesh/submesh.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

using namespace concino;

static_assert(NumbersCorners<trimesh> && NumbersCorners<const polyhedralmesh&> && !NumbersCorners<int>);

namespace {

/// The value at a corner in these tests, made from its poly and vert.
double value_at(poly_id p, vert_id v) { return 1000.0 * p.raw() + v.raw() + 1; }

template<class M>
corner_property_map<M, double> filled(M& m) {
  const auto u = corner_property<double>(m, "u");
  for (const poly_id p : polys(m)) {
    std::uint32_t k = 0;
    for (const vert_id v : adj_p2v(m, p)) u[{p, k++}] = value_at(p, v);
  }
  return u;
}
template<class M>
void check_filled(const M& m) {
  const auto u = find_corner_property<double>(m, "u");
  REQUIRE(u);
  for (const poly_id p : polys(m)) {
    std::uint32_t k = 0;
    for (const vert_id v : adj_p2v(m, p)) {
      CHECK(u[{p, k}] == value_at(p, v));
      CHECK(u.of(p)[k] == value_at(p, v));
      ++k;
    }
    CHECK(u.of(p).size() == k);
  }
}
template<class M>
void check_numbers(const M& m) {
  std::vector<char> met(traits<M>::corner_index_bound(m));
  for (const poly_id p : polys(m))
    for (std::uint32_t k = 0; k < num_elements(adj_p2v(m, p)); ++k) {
      REQUIRE(corner_index(m, {p, k}) < met.size());
      CHECK(met[corner_index(m, {p, k})]++ == 0);
    }
}

}  // namespace

TEST_CASE_TEMPLATE("corner properties: can be created, found, removed and copied", M, CONCINO_KINDS) {
  M m = testing::grid<M>(2);
  CHECK_FALSE(find_corner_property<double>(m, "u"));
  check_numbers(m);
  filled(m);
  check_filled(m);
  CHECK(property_list(m).size() == 1);
  CHECK(to_string(property_list(m)[0].kind) == "corner");
  CHECK(property_list(m)[0].rule == property_rule::interpolate);
  CHECK_THROWS_AS(corner_property<int>(m, "u"), invalid_argument);
  CHECK_THROWS_AS(find_corner_property<int>(m, "u"), invalid_argument);
  M copy = m;
  corner_property<double>(m, "u")[{poly_id{0}, 0}] = -1;
  check_filled(copy);
  CHECK(remove_property(copy, element_kind::corner, "u"));
  CHECK_FALSE(find_corner_property<double>(copy, "u"));
  M none;
  CHECK(corner_property<std::string>(none, "text"));
  CHECK(traits<M>::corner_index_bound(none) == 0);
}

TEST_CASE_TEMPLATE("corner properties: adding and removing polys keeps the values of others", M, CONCINO_KINDS) {
  std::mt19937 random(4);
  M m = testing::grid<M>(2);
  filled(m);
  const auto text = corner_property<std::string>(m, "text");
  const M before = m;
  for (int step = 0; step < 12; ++step) {
    std::vector<poly_id> all;
    for (const poly_id p : polys(m)) all.push_back(p);
    const poly_id gone = all[random() % all.size()];
    if constexpr (requires(const std::vector<vert_id>& c) { add_poly(m, std::span<const vert_id>(c)); }) {
      std::vector<vert_id> corners;
      for (const vert_id v : adj_p2v(m, gone)) corners.push_back(v);
      remove_poly(m, gone);
      const poly_id p = add_poly(m, std::span<const vert_id>(corners));
      CHECK(corner_property<double>(m, "u").of(p).size() == corners.size());
      for (double& x : corner_property<double>(m, "u").of(p)) {
        CHECK(x == 0);
        x = value_at(p, corners[static_cast<std::size_t>(&x - corner_property<double>(m, "u").of(p).data())]);
      }
    } else {
      remove_poly(m, gone);
      if (step % 3 == 0) add_vert(m, {1, 2, 3});
    }
    check_numbers(m);
    check_filled(m);
    if (num_polys(m) == 1) break;
  }
  check_filled(before);
}

TEST_CASE("corner properties: of an added polyhedron can be set") {
  polyhedralmesh m = testing::grid<polyhedralmesh>(1);
  filled(m);
  std::vector<vert_id> v;
  for (const vec3& x : {vec3{5, 0, 0}, vec3{6, 0, 0}, vec3{5, 1, 0}, vec3{5, 0, 1}}) v.push_back(add_vert(m, x));
  std::vector<face_id> f;
  for (const auto& [a, b, c] : {std::array{0, 2, 1}, std::array{0, 1, 3}, std::array{0, 3, 2}, std::array{1, 2, 3}})
    f.push_back(add_face(m, {v[static_cast<std::size_t>(a)], v[static_cast<std::size_t>(b)], v[static_cast<std::size_t>(c)]}));
  const poly_id p = add_poly(m, {{f[0], true}, {f[1], true}, {f[2], true}, {f[3], true}});
  const auto u = corner_property<double>(m, "u");
  CHECK(u.of(p).size() == 4);
  std::uint32_t k = 0;
  for (const vert_id x : adj_p2v(m, p)) {
    CHECK(u[{p, k}] == 0);
    u[{p, k++}] = value_at(p, x);
  }
  check_numbers(m);
  check_filled(m);
}

TEST_CASE_TEMPLATE("corner properties: are transferred by convert, submesh and agglomerate", M, CONCINO_KINDS) {
  using general = std::conditional_t<dimension_v<M> == 2, polygonmesh, polyhedralmesh>;
  M m = testing::grid<M>(2);
  filled(m);
  remove_poly(m, poly_id{1});
  const auto there = convert_with_correspondence<general>(m);
  const auto u = find_corner_property<double>(there.mesh, "u");
  REQUIRE(u);
  for (const poly_id p : polys(m)) {
    std::uint32_t k = 0;
    for (const vert_id w : adj_p2v(there.mesh, there.poly_of(p))) {
      vert_id v;
      for (const vert_id x : adj_p2v(m, p))
        if (there.vert_of(x) == w) v = x;
      CHECK(u[{there.poly_of(p), k++}] == value_at(p, v));
    }
  }
  const auto part = submesh(m, [](const poly_id p) { return p.raw() != 2; });
  const auto of_part = find_corner_property<double>(part, "u");
  for (const poly_id p : polys(part)) CHECK(of_part.of(p)[0] == value_at(p, *adj_p2v(part, p).begin()));
  const auto c = convert_with_correspondence<M>(part);
  for (const poly_id p : polys(part)) {
    const auto kept = find_corner_property<double>(c.mesh, "u").of(c.poly_of(p));
    std::size_t k = 0;
    for (const vert_id v : adj_p2v(part, p)) CHECK(kept[k++] == value_at(p, v));
  }
  // All polys in one: the values at its corners are means of the old ones, weighted by the polys.
  M whole = testing::grid<M>(2);
  const auto same = corner_property<double>(whole, "same");
  const auto by_poly = corner_property<double>(whole, "by poly");
  for (const poly_id p : polys(whole)) {
    std::uint32_t k = 0;
    for (const vert_id v : adj_p2v(whole, p)) same[{p, k}] = v.raw(), by_poly[{p, k++}] = p.raw();
  }
  correspondence of;
  const auto one = agglomerate(whole, make_poly_map<int>(whole, 7), {.correspondence = &of});
  REQUIRE(num_polys(one) == 1);
  const poly_id p{0};
  std::size_t k = 0;
  for (const vert_id v : adj_p2v(one, p)) {
    const vert_id before{of.verts.only(v.raw())};
    CHECK(find_corner_property<double>(one, "same").of(p)[k] == doctest::Approx(before.raw()).epsilon(1e-14));
    double sum = 0, total = 0;
    for (const poly_id q : adj_v2p(whole, before)) sum += measure(whole, q) * q.raw(), total += measure(whole, q);
    CHECK(find_corner_property<double>(one, "by poly").of(p)[k] == doctest::Approx(sum / total).epsilon(1e-12));
    ++k;
  }
}

TEST_CASE("corner properties: of a split triangle come from its own corners") {
  trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}});
  trimesh split({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 0.5, 0}}, {{0, 1, 4}, {0, 4, 2}, {1, 3, 4}, {4, 3, 2}});
  const auto u = corner_property<double>(m, "u");
  for (std::uint32_t k = 0; k < 3; ++k) u[{poly_id{0}, k}] = 10.0 + k, u[{poly_id{1}, k}] = 20.0 + k;
  correspondence c;
  for (const std::uint32_t v : {0u, 1u, 2u, 3u}) c.verts.add(v);
  c.verts.add({{1, 0.5}, {2, 0.5}});
  for (const std::uint32_t p : {0u, 0u, 1u, 1u}) c.polys.add({{p, 0.25}});
  transfer_properties(m, split, c);
  const auto found = find_corner_property<double>(split, "u");
  const std::vector<std::vector<double>> expected = {{10, 11, 11.5}, {10, 11.5, 12}, {20, 21, 21}, {21, 21, 22}};
  for (const poly_id p : polys(split))
    for (std::uint32_t k = 0; k < 3; ++k) CHECK(found[{p, k}] == expected[p.raw()][k]);
  c.polys = {};
  CHECK_THROWS_AS(transfer_properties(m, split, c), invalid_argument);
  c.polys = element_origins({0, 0, 1, 2});
  CHECK_THROWS_AS(transfer_properties(m, split, c), invalid_argument);
}
