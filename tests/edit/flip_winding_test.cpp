// flip_winding: measures change their sign, descriptors and properties stay, and two flips give the same mesh.
#include <concino/edit.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/geometry/normals.hpp>
#include <concino/mesh.hpp>

#include <support/kinds.hpp>
#include <support/rebuilt.hpp>
#include <support/soups.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <map>
#include <random>

namespace cn = concino;
using cn::testing::equals_rebuilt;
using cn::testing::keeps_all_laws;
using cn::testing::raw;

namespace {

/// Whether the directed edges or outward faces of p are reversed in `after`.
template<class M>
void is_reversed(const M& before, const M& after, cn::poly_id p) {
  if constexpr (cn::SurfaceMesh<M>) {
    auto old = raw(cn::adj_p2v(before, p));
    std::reverse(old.begin() + 1, old.end());
    CHECK(raw(cn::adj_p2v(after, p)) == old);
  } else {
    for (const auto f : cn::adj_p2f(before, p)) {
      const auto cycle = raw(cn::adj_f2v(before, f)), now = raw(cn::adj_f2v(after, f));
      std::vector<cn::vert_id> a, b;
      for (const unsigned v : cycle) a.push_back(cn::vert_id{v});
      for (const unsigned v : now) b.push_back(cn::vert_id{v});
      const int direction = cn::compare_cycles(a.data(), b.data(), a.size());
      REQUIRE(direction != 0);
      CHECK((cn::face_is_outward(before, p, f) == cn::face_is_outward(after, p, f)) == (direction < 0));
    }
  }
}

template<class M>
void has_same_elements(const M& before, const M& after) {
  for (const auto e : cn::edges(before)) {
    REQUIRE(cn::contains(after, e));
    CHECK(cn::testing::raw_set(cn::adj_e2v(before, e)) == cn::testing::raw_set(cn::adj_e2v(after, e)));
    CHECK(cn::testing::raw_set(cn::adj_e2p(before, e)) == cn::testing::raw_set(cn::adj_e2p(after, e)));
  }
  CHECK(raw(cn::edges(before)) == raw(cn::edges(after)));
  CHECK(raw(cn::polys(before)) == raw(cn::polys(after)));
  CHECK(raw(cn::verts(before)) == raw(cn::verts(after)));
  for (const auto p : cn::polys(before)) CHECK(cn::testing::raw_set(cn::adj_p2e(before, p)) == cn::testing::raw_set(cn::adj_p2e(after, p)));
  if constexpr (cn::VolumeMesh<M>)
    for (const auto p : cn::polys(before)) CHECK(cn::testing::raw_set(cn::adj_p2f(before, p)) == cn::testing::raw_set(cn::adj_p2f(after, p)));
}

/// The value of the corner property "uv" at each vert of each poly.
template<class M>
std::map<std::pair<unsigned, unsigned>, double> corner_values(const M& m) {
  std::map<std::pair<unsigned, unsigned>, double> all;
  const auto uv = cn::find_corner_property<double>(m, "uv");
  for (const auto p : cn::polys(m)) {
    std::uint32_t k = 0;
    for (const auto v : cn::adj_p2v(m, p)) all[{p.raw(), v.raw()}] = uv[{p, k++}];
  }
  return all;
}

}  // namespace

TEST_CASE_TEMPLATE("flip_winding: grids and random soups", M, CONCINO_ALL_KINDS) {
  std::mt19937 random(5);
  for (unsigned round = 0; round < 4; ++round) {
    M m = round == 0 ? M() : round == 1 ? cn::testing::two_grids<M>(2) : cn::testing::random_soup<M>(random, 14, 12).mesh();
    const auto uv = cn::corner_property<double>(m, "uv");
    const auto of_poly = cn::poly_property<int>(m, "id");
    double next = 0;
    for (const auto p : cn::polys(m)) {
      of_poly[p] = static_cast<int>(p.raw());
      for (double& x : uv.of(p)) x = ++next;
    }
    const M before = m;
    const auto values = corner_values(m);
    if (round == 1) {
      const cn::poly_id p = *cn::polys(m).begin();
      cn::flip_winding(m, p);
      is_reversed(before, m, p);
      has_same_elements(before, m);
      CHECK(corner_values(m) == values);
      cn::flip_winding(m, p);
    }
    cn::flip_winding(m);
    for (const auto p : cn::polys(before)) {
      is_reversed(before, m, p);
      CHECK(of_poly[p] == static_cast<int>(p.raw()));
    }
    has_same_elements(before, m);
    CHECK(corner_values(m) == values);
    equals_rebuilt(m);
    cn::flip_winding(m);
    for (const auto p : cn::polys(before)) {
      if (cn::dimension_v<M> == 2 || cn::arity_v<M> > 0) CHECK(raw(cn::adj_p2v(m, p)) == raw(cn::adj_p2v(before, p)));
    }
    CHECK(corner_values(m) == values);
    equals_rebuilt(m);
    keeps_all_laws(m);
  }
}

TEST_CASE("flip_winding: volumes and normals change their sign") {
  auto t = cn::testing::grid<cn::tetmesh>(2);
  auto h = cn::testing::grid<cn::hexmesh>(2);
  cn::flip_winding(t);
  CHECK(cn::total_measure(t) == doctest::Approx(-1));
  cn::flip_winding(h);
  CHECK(cn::total_measure(h) == doctest::Approx(-1));
  auto s = cn::testing::grid<cn::trimesh>(2);
  const cn::vec3 normal = cn::normal(s, cn::poly_id{0});
  cn::flip_winding(s);
  CHECK(cn::normal(s, cn::poly_id{0}) == -1.0 * normal);
}

TEST_CASE_TEMPLATE("flip_winding: points that are not finite; polys of other meshes; a transaction undoes it", M, CONCINO_KINDS) {
  M m = cn::testing::grid<M>(1);
  const auto uv = cn::corner_property<double>(m, "uv");
  for (const auto p : cn::polys(m))
    for (double& x : uv.of(p)) x = p.raw() + 0.5;
  for (const auto v : cn::verts(m)) cn::set_point(m, v, cn::vec3{0, std::numeric_limits<double>::infinity(), 0});
  const auto before = cn::testing::whole(m);
  CHECK_THROWS_WITH_AS(cn::flip_winding(m, cn::poly_id{1000}), doctest::Contains("flip_winding: poly 1000"), cn::invalid_mesh);
  CHECK(cn::testing::whole(m) == before);
  const auto values = corner_values(m);
  {
    cn::transaction t(m);
    cn::flip_winding(m);
    CHECK(cn::testing::whole(m) != before);
  }
  CHECK(cn::testing::whole(m) == before);
  CHECK(corner_values(m) == values);
}
