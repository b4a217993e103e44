// end_verts returns the verts of adj_e2v, on users' meshes and on archetypes.
#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/end_verts.hpp>

#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

namespace cn = concino;

namespace {

template<class M> concept has_end_verts = requires(const M& m, cn::edge_t<M> e) { cn::end_verts(m, e); };
static_assert(has_end_verts<user_mesh::surface> && has_end_verts<user_mesh::volume> && !has_end_verts<int>);
using graph = decltype(cn::only_primal_graph(std::declval<const user_mesh::surface&>()));
static_assert(!has_end_verts<graph>);

template<class M>
void names_both(const M& m) {
  for (const cn::edge_t<M> e : cn::edges(m)) {
    const auto [a, b] = cn::end_verts(m, e);
    std::size_t k = 0;
    for (const cn::vert_t<M> v : cn::adj_e2v(m, e)) CHECK(v == (k++ == 0 ? a : b));
    CHECK(k == 2);
    CHECK_FALSE(a == b);
    CHECK(cn::end_verts(m, e) == cn::end_verts(m, e));
    CHECK_FALSE(cn::end_verts(m, e) == cn::edge_ends<cn::vert_t<M>>{b, a});
  }
}

}  // namespace

TEST_CASE("end_verts returns the verts of adj_e2v") {
  const auto s = user_mesh::surface_example();
  const auto w = user_mesh::volume_example();
  names_both(s);
  names_both(w);
  names_both(cn::only_mesh(s));
  names_both(cn::only_mesh(w));
}
