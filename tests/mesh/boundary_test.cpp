// boundary(m) is the surface of all faces with one poly, oriented outward.
#include <concino/concepts/archetypes.hpp>
#include <concino/mesh/boundary.hpp>
#include <concino/mesh/submesh.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/models.hpp>
#include <support/user_mesh.hpp>
#include <support/kinds.hpp>
#include <support/soups.hpp>

#include <doctest/doctest.h>

#include <vector>

namespace cn = concino;

namespace {

template<class M>
void keeps_all_laws(const M& m) {
  const auto found = cn::check_laws(m);
  for (const auto& b : found) MESSAGE(b.law << ": " << b.what << " [" << b.witness << "]");
  CHECK(found.empty());
}

/// The volume inside a closed surface with planar polygons, positive if it is oriented outward.
template<class S>
double inside(const S& s) {
  double six = 0;
  for (auto p : cn::polys(s)) {
    std::vector<cn::vec3> x;
    for (auto v : cn::adj_p2v(s, p)) x.push_back(cn::to_vec3(cn::point(s, v)));
    for (std::size_t i = 2; i < x.size(); ++i) six += dot(x[0], cross(x[i - 1], x[i]));
  }
  return six / 6;
}

const user_mesh::volume w = user_mesh::volume_example();
using cn::testing::models_in_all_forms;
static_assert(models_in_all_forms<decltype(cn::boundary(w))>(cn::testing::surface | cn::testing::embedded));
static_assert(models_in_all_forms<decltype(cn::boundary(cn::only_mesh(w)))>(cn::testing::surface));
static_assert(cn::TriMesh<decltype(cn::boundary(std::declval<const cn::tetmesh&>()))> &&
              cn::QuadMesh<decltype(cn::boundary(std::declval<const cn::hexmesh&>()))>);
static_assert(std::same_as<cn::poly_t<decltype(cn::boundary(w))>, user_mesh::facet>);
template<class M> concept takes_temporary = requires(M&& m) { cn::boundary(static_cast<M&&>(m)); };
static_assert(!takes_temporary<user_mesh::volume> && takes_temporary<const user_mesh::volume&> && !takes_temporary<const user_mesh::surface&>);

}  // namespace

TEST_CASE("boundary: is right for a cube and a pyramid that share a face") {
  const auto b = cn::boundary(w);
  keeps_all_laws(b);
  CHECK(cn::num_polys(b) == 9);
  CHECK(cn::num_verts(b) == 9);
  CHECK(cn::num_edges(b) == 16);
  CHECK_FALSE(cn::contains(b, user_mesh::facet{1}));
  CHECK_FALSE(cn::contains(b, user_mesh::vertex{9}));
  CHECK(inside(b) == doctest::Approx(1 + 1.0 / 3));
}

TEST_CASE("boundary: faces that are clockwise in the mesh are reversed") {
  user_mesh::volume turned = w;
  for (int f : {0, 3, 7}) {
    auto& ring = turned.facets[std::size_t(f)];
    ring = user_mesh::polygon(ring.rbegin(), ring.rend());
    for (auto& c : turned.cells)
      for (auto& [face, outward] : c) if (face == f) outward = !outward;
  }
  const auto b = cn::boundary(turned);
  keeps_all_laws(b);
  CHECK(inside(b) == doctest::Approx(1 + 1.0 / 3));
  keeps_all_laws(cn::boundary(cn::only_embedded_mesh(turned)));
}

TEST_CASE_TEMPLATE("boundary: of a grid is a closed box", M, CONCINO_VOLUME_KINDS) {
  const M m = cn::testing::grid<M>(3);
  const auto b = cn::boundary(m);
  keeps_all_laws(b);
  CHECK(cn::num_verts(b) + cn::num_polys(b) == cn::num_edges(b) + 2);
  CHECK(inside(b) == doctest::Approx(1));
  for (auto e : cn::edges(b)) {
    int n = 0;
    for ([[maybe_unused]] auto p : cn::adj_e2p(b, e)) ++n;
    CHECK(n == 2);
  }
  // The boundary of a part, and a part of the boundary.
  keeps_all_laws(cn::boundary(cn::submesh(m, [&](auto p) { return cn::index_of(m, p) % 2 == 0; })));
  keeps_all_laws(cn::submesh(b, [&](auto f) { return cn::index_of(m, f) % 2 == 0; }));
  const M empty;
  keeps_all_laws(cn::boundary(empty));
}

TEST_CASE_TEMPLATE("boundary: non-manifold volumes have one too", M, CONCINO_VOLUME_KINDS) {
  std::mt19937 random(11);
  for (int round = 0; round < 30; ++round) {
    const M m = cn::testing::random_soup<M>(random, 9, 1 + unsigned(round) / 2).mesh();
    const auto b = cn::boundary(m);
    keeps_all_laws(b);
    std::size_t n = 0;
    for (auto f : cn::faces(m)) {
      int sides = 0;
      for ([[maybe_unused]] auto p : cn::adj_f2p(m, f)) ++sides;
      n += sides == 1;
      CHECK(cn::contains(b, f) == (sides == 1));
    }
    CHECK(cn::num_polys(b) == n);
  }
}
