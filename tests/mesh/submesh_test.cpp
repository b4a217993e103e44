// submesh(m, keep) equals a mesh that has only the kept polys, in laws and elements.
#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/derived.hpp>
#include <concino/mesh/submesh.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/models.hpp>
#include <support/user_mesh.hpp>
#include <support/kinds.hpp>
#include <support/soups.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

namespace cn = concino;

namespace {

template<class M>
void keeps_all_laws(const M& m) {
  const auto found = cn::check_laws(m);
  for (const auto& b : found) MESSAGE(b.law << ": " << b.what << " [" << b.witness << "]");
  CHECK(found.empty());
}

/// Checks that the part breaks no law, except VM6 if m has random orientations.
template<class M, class V>
void keeps_laws_of(const M& m, const V& part) {
  const auto winding = [](const auto& found) {
    return std::any_of(found.begin(), found.end(), [](const auto& b) { return b.law == "VM6"; });
  };
  const bool wound_at_random = winding(cn::check_laws(m));
  for (const auto& b : cn::check_laws(part)) {
    INFO(b.what);
    CHECK((b.law == "VM6" && wound_at_random));
  }
}

const user_mesh::surface s = user_mesh::surface_example();
const user_mesh::volume w = user_mesh::volume_example();
constexpr auto all = [](auto) { return true; };
constexpr auto none = [](auto) { return false; };

using cn::testing::models_in_all_forms;
static_assert(models_in_all_forms<decltype(cn::submesh(s, all))>(cn::testing::surface | cn::testing::embedded));
static_assert(models_in_all_forms<decltype(cn::submesh(w, all))>(cn::testing::volume | cn::testing::embedded));
static_assert(models_in_all_forms<decltype(cn::submesh(cn::only_mesh(s), all))>(cn::testing::surface));
static_assert(cn::HexMesh<decltype(cn::submesh(std::declval<const cn::hexmesh&>(), all))>);
static_assert(std::copyable<decltype(cn::submesh(s, all))> && cn::is_view_v<decltype(cn::submesh(s, all))>);
template<class M> concept takes_temporary = requires(M&& m) { cn::submesh(static_cast<M&&>(m), all); };
static_assert(!takes_temporary<user_mesh::surface> && takes_temporary<const user_mesh::surface&> && takes_temporary<decltype(cn::submesh(w, all))>);

}  // namespace

TEST_CASE("submesh: a part of a surface equals a mesh of its polys") {
  const auto part = cn::submesh(s, [](user_mesh::cell p) { return p.i == 0 || p.i == 3; });
  keeps_all_laws(part);
  CHECK(cn::num_polys(part) == 2);
  CHECK(cn::num_verts(part) == 6);
  CHECK(cn::num_edges(part) == 7);
  CHECK(cn::contains(part, user_mesh::vertex{2}));
  CHECK_FALSE(cn::contains(part, user_mesh::vertex{3}));
  CHECK_FALSE(cn::contains(part, user_mesh::vertex{100}));
  // v0 is adjacent to v1, v2, v4, v6, and the two polys are not neighbours.
  std::set<int> next;
  for (auto v : cn::adj_v2v(part, user_mesh::vertex{0})) next.insert(v.i);
  CHECK(next == std::set<int>{1, 2, 4, 6});
  CHECK_FALSE(cn::adj_p2p(part, user_mesh::cell{0}).begin() != cn::adj_p2p(part, user_mesh::cell{0}).end());
}

TEST_CASE("submesh: a part of a volume equals a mesh of its polys") {
  const auto top = cn::submesh(w, [](user_mesh::cell p) { return p.i == 1; });
  keeps_all_laws(top);
  CHECK(cn::num_polys(top) == 1);
  CHECK(cn::num_verts(top) == 5);
  CHECK(cn::num_edges(top) == 8);
  CHECK(cn::num_faces(top) == 5);
  CHECK(cn::vert_index_bound(top) == cn::vert_index_bound(w));
}

TEST_CASE("submesh: may keep all polys or none") {
  keeps_all_laws(cn::submesh(w, all));
  CHECK(cn::num_faces(cn::submesh(w, all)) == cn::num_faces(w));
  CHECK(cn::num_verts(cn::submesh(w, all)) == 9);  // v9 is used by no poly
  keeps_all_laws(cn::submesh(s, none));
  CHECK(cn::num_verts(cn::submesh(s, none)) == 0);
}

TEST_CASE_TEMPLATE("submesh: works on every kind of mesh, archetypes and views", M, CONCINO_KINDS) {
  const M m = cn::testing::grid<M>(3);
  int asked = 0;
  const auto some = [&](auto p) { return ++asked, cn::index_of(m, p) % 3 != 0; };
  const auto part = cn::submesh(m, some);
  CHECK(asked == int(cn::num_polys(m)));
  keeps_all_laws(part);
  CHECK(cn::arity_v<decltype(part)> == cn::arity_v<M>);
  const auto opaque = cn::only_embedded_mesh(m);
  keeps_all_laws(cn::submesh(opaque, [&](auto p) { return some(opaque.base(p)); }));
  const auto twice = cn::submesh(part, [&](auto p) { return cn::index_of(m, p) % 2 != 0; });
  keeps_all_laws(twice);
  std::size_t n = 0;
  for (auto p : cn::polys(m)) n += cn::index_of(m, p) % 3 != 0 && cn::index_of(m, p) % 2 != 0;
  CHECK(cn::num_polys(twice) == n);
}

TEST_CASE_TEMPLATE("submesh: works on non-manifold meshes", M, CONCINO_KINDS) {
  std::mt19937 random(7);
  for (int round = 0; round < 30; ++round) {
    const M m = cn::testing::random_soup<M>(random, 9, 1 + unsigned(round) / 2).mesh();
    const auto part = cn::submesh(m, [&](auto p) { return cn::index_of(m, p) % 2 == 0; });
    CHECK(cn::num_polys(part) == (cn::num_polys(m) + 1) / 2);
    keeps_laws_of(m, part);
  }
}
