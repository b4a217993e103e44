// dual(m) models DualGraph and no other concept.
#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/views/dual.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/models.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

namespace cn = concino;
using cn::testing::models_in_all_forms;

namespace {

const user_mesh::surface s = user_mesh::surface_example();
const user_mesh::volume w = user_mesh::volume_example();

static_assert(models_in_all_forms<decltype(cn::dual(s))>(cn::testing::dual_graph));
static_assert(models_in_all_forms<decltype(cn::dual(w))>(cn::testing::dual_graph));
static_assert(std::same_as<cn::poly_t<decltype(cn::dual(s))>, user_mesh::cell> && cn::is_view_v<decltype(cn::dual(s))>);
template<class M> concept takes_temporary = requires(M&& m) { cn::dual(static_cast<M&&>(m)); };
static_assert(!takes_temporary<user_mesh::surface> && takes_temporary<user_mesh::surface&> && takes_temporary<decltype(cn::dual(s))>);
// A graph of verts has no dual.
static_assert(!takes_temporary<decltype(cn::only_primal_graph(s))>);

}  // namespace

TEST_CASE("dual(m) gives the same results as the mesh") {
  const auto g = cn::dual(s);
  CHECK(cn::num_polys(g) == 4);
  CHECK(cn::adj_p2p(g, user_mesh::cell{1}) == cn::adj_p2p(s, user_mesh::cell{1}));
  CHECK(cn::contains(g, user_mesh::cell{3}));
  CHECK_FALSE(cn::contains(g, user_mesh::cell{4}));
}

TEST_CASE("dual(m) obeys all laws, also for views and the weakest model") {
  CHECK(cn::check_laws(cn::dual(s)).empty());
  CHECK(cn::check_laws(cn::dual(cn::dual(w))).empty());
  CHECK(cn::check_laws(cn::dual(cn::only_dual_graph(w))).empty());
}
