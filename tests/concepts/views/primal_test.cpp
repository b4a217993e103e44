// primal(m) models PrimalGraph and no other concept.
#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/views/primal.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/models.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

namespace cn = concino;
using cn::testing::models_in_all_forms;

namespace {

const user_mesh::surface s = user_mesh::surface_example();
const user_mesh::volume w = user_mesh::volume_example();
using bare = decltype(cn::only_graphs(s));

static_assert(models_in_all_forms<decltype(cn::primal(s))>(cn::testing::primal_graph | cn::testing::embedded));
static_assert(models_in_all_forms<decltype(cn::primal(w))>(cn::testing::primal_graph | cn::testing::embedded));
static_assert(models_in_all_forms<decltype(cn::primal(std::declval<bare>()))>(cn::testing::primal_graph));
static_assert(cn::is_view_v<decltype(cn::primal(s))> && std::copyable<decltype(cn::primal(s))> && sizeof(cn::primal(s)) == sizeof(void*));

// Temporary meshes are rejected, temporary views are not.
template<class M> concept takes_temporary = requires(M&& m) { cn::primal(static_cast<M&&>(m)); };
static_assert(!takes_temporary<user_mesh::surface> && !takes_temporary<const user_mesh::surface> && takes_temporary<user_mesh::surface&> &&
              takes_temporary<const user_mesh::surface&>);
static_assert(takes_temporary<decltype(cn::primal(s))> && takes_temporary<decltype(cn::only_mesh(w))>);

}  // namespace

TEST_CASE("primal(m) gives the same results as the mesh") {
  const auto g = cn::primal(s);
  CHECK(cn::num_verts(g) == 8);
  CHECK(cn::adj_v2v(g, user_mesh::vertex{0}) == cn::adj_v2v(s, user_mesh::vertex{0}));
  CHECK(cn::point(g, user_mesh::vertex{2})[1] == 1);
  CHECK(&cn::point(g, user_mesh::vertex{2}) == &cn::point(s, user_mesh::vertex{2}));
  CHECK(cn::contains(g, user_mesh::vertex{7}));
  CHECK_FALSE(cn::contains(g, user_mesh::vertex{8}));
}

TEST_CASE("primal(m) obeys all laws, also for views and the weakest model") {
  CHECK(cn::check_laws(cn::primal(s)).empty());
  CHECK(cn::check_laws(cn::primal(cn::primal(w))).empty());
  CHECK(cn::check_laws(cn::primal(cn::only_primal_graph(w))).empty());
}
