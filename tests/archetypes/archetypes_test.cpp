// Archetypes model exactly the concept after which they are named, and give the same results as the mesh to which they refer.
#include <concino/concepts/archetypes.hpp>

#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <iterator>
#include <vector>

namespace cn = concino;

namespace {

template<class T> using made = std::remove_cvref_t<T>;
const user_mesh::surface& s = *new user_mesh::surface(user_mesh::surface_example());
const user_mesh::volume& w = *new user_mesh::volume(user_mesh::volume_example());

template<class A, bool Primal, bool Dual, int Dimension, bool Points>
constexpr bool models_exactly() {
  return cn::PrimalGraph<A> == Primal && cn::DualGraph<A> == Dual && cn::SurfaceMesh<A> == (Dimension == 2) &&
         cn::VolumeMesh<A> == (Dimension == 3) && cn::AnyMesh<A> == (Dimension > 0) && cn::Embedded<A> == Points && !cn::MutablePoints<A> &&
         cn::dimension_v<A> == Dimension;
}
template<class A, bool Primal, bool Dual, int Dimension, bool Points>
constexpr bool in_all_forms =
    models_exactly<A, Primal, Dual, Dimension, Points>() && models_exactly<const A, Primal, Dual, Dimension, Points>() &&
    models_exactly<A&, Primal, Dual, Dimension, Points>() && models_exactly<const A&, Primal, Dual, Dimension, Points>() &&
    models_exactly<cn::archetypes::owner<A>, Primal, Dual, Dimension, Points>();

static_assert(in_all_forms<decltype(cn::only_primal_graph(s)), true, false, 0, false>);
static_assert(in_all_forms<decltype(cn::only_primal_graph(w)), true, false, 0, false>);
static_assert(in_all_forms<decltype(cn::only_embedded_graph(s)), true, false, 0, true>);
static_assert(in_all_forms<decltype(cn::only_dual_graph(s)), false, true, 0, false>);
static_assert(in_all_forms<decltype(cn::only_dual_graph(w)), false, true, 0, false>);
static_assert(in_all_forms<decltype(cn::only_graphs(w)), true, true, 0, false>);
static_assert(in_all_forms<decltype(cn::only_embedded(w)), false, false, 0, true>);
static_assert(in_all_forms<decltype(cn::only_surface_mesh(s)), true, true, 2, false>);
static_assert(in_all_forms<decltype(cn::only_volume_mesh(w)), true, true, 3, false>);
static_assert(in_all_forms<decltype(cn::only_mesh(s)), true, true, 2, false>);
static_assert(in_all_forms<decltype(cn::only_embedded_mesh(s)), true, true, 2, true>);
static_assert(in_all_forms<decltype(cn::only_embedded_mesh(w)), true, true, 3, true>);
// An archetype of an archetype.
static_assert(in_all_forms<cn::archetypes::archetype<decltype(cn::only_mesh(w)), cn::archetypes::primal>, true, false, 0, false>);

template<class M> concept strips_temporary = requires { cn::only_primal_graph(made<M>()); };
template<class M> concept strips_lvalue = requires(const M& m) { cn::only_primal_graph(m); };
static_assert(strips_lvalue<user_mesh::surface> && !strips_temporary<user_mesh::surface>);
template<class M> concept strips_to_volume = requires(const M& m) { cn::only_volume_mesh(m); };
static_assert(strips_to_volume<user_mesh::volume> && !strips_to_volume<user_mesh::surface>);

// Archetypes lack operations that the concepts do not require.
template<class T> concept less_than = requires(const T& a) { a < a; };
template<class T> concept has_size = requires(const T& a) { a.size(); };
template<class T> concept has_subscript = requires(const T& a) { a[0]; };
template<class T> concept post_incremented = requires(T a) { a++; };
template<class A, class B> concept compared = requires(const A& a, const B& b) { a == b; };
template<class T> concept hashed = requires(const T& a) { std::hash<T>()(a); };

using graph = decltype(cn::only_primal_graph(s));
using vert = cn::vert_t<graph>;
using ring = decltype(cn::adj_v2v(std::declval<graph>(), std::declval<vert>()));
using step = decltype(std::declval<const ring&>().begin());
static_assert(std::regular<vert> && !less_than<vert> && !hashed<vert>);
static_assert(!std::convertible_to<vert, int> && !std::convertible_to<int, vert> && !std::constructible_from<vert, int>);
static_assert(!std::constructible_from<vert, user_mesh::vertex> && !compared<vert, user_mesh::vertex>);
static_assert(!compared<vert, cn::poly_t<decltype(cn::only_dual_graph(s))>>);
static_assert(!std::copyable<ring> && !std::movable<ring> && !has_size<ring> && !has_subscript<ring>);
static_assert(!std::same_as<step, decltype(std::declval<const ring&>().end())>);
static_assert(std::copyable<step> && !std::default_initializable<step> && !post_incremented<step> && !compared<step, step>);
static_assert(std::copyable<graph> && cn::is_view_v<graph>);
static_assert(!std::copyable<cn::archetypes::owner<graph>> && !cn::is_view_v<cn::archetypes::owner<graph>>);

template<class A, class R, class Q>
void same(const A& a, const R& stripped, const Q& real) {
  for (int walk = 0; walk < 2; ++walk) {
    auto it = real.begin();
    for (auto x : stripped) {
      REQUIRE(it != real.end());
      CHECK(a.base(x) == *it);
      ++it;
    }
    CHECK_FALSE(it != real.end());
  }
}

}  // namespace

TEST_CASE("graph archetypes give the same results as the mesh") {
  const auto g = cn::only_primal_graph(s);
  CHECK(cn::num_verts(g) == 8);
  CHECK(cn::vert_index_bound(g) == 8);
  same(g, cn::verts(g), cn::verts(s));
  for (auto v : cn::verts(s)) {
    CHECK(cn::index_of(g, g.vert(v)) == cn::index_of(s, v));
    same(g, cn::adj_v2v(g, g.vert(v)), cn::adj_v2v(s, v));
  }
  const auto d = cn::only_dual_graph(w);
  CHECK(cn::num_polys(d) == 2);
  same(d, cn::polys(d), cn::polys(w));
  for (auto p : cn::polys(w)) same(d, cn::adj_p2p(d, d.poly(p)), cn::adj_p2p(w, p));
}

TEST_CASE("mesh archetypes give the same results as the mesh") {
  const auto m = cn::only_embedded_mesh(w);
  same(m, cn::edges(m), cn::edges(w));
  same(m, cn::faces(m), cn::faces(w));
  CHECK(cn::num_edges(m) == cn::num_edges(w));
  CHECK(cn::num_faces(m) == cn::num_faces(w));
  for (auto v : cn::verts(w)) {
    same(m, cn::adj_v2e(m, m.vert(v)), cn::adj_v2e(w, v));
    same(m, cn::adj_v2f(m, m.vert(v)), cn::adj_v2f(w, v));
    same(m, cn::adj_v2p(m, m.vert(v)), cn::adj_v2p(w, v));
    for (int i : {0, 1, 2}) CHECK(double(cn::point(m, m.vert(v))[i]) == cn::point(w, v)[std::size_t(i)]);
  }
  for (auto e : cn::edges(w)) {
    same(m, cn::adj_e2v(m, m.edge(e)), cn::adj_e2v(w, e));
    same(m, cn::adj_e2f(m, m.edge(e)), cn::adj_e2f(w, e));
    same(m, cn::adj_e2p(m, m.edge(e)), cn::adj_e2p(w, e));
  }
  for (auto f : cn::faces(w)) {
    same(m, cn::adj_f2v(m, m.face(f)), cn::adj_f2v(w, f));
    same(m, cn::adj_f2e(m, m.face(f)), cn::adj_f2e(w, f));
    same(m, cn::adj_f2p(m, m.face(f)), cn::adj_f2p(w, f));
  }
  for (auto p : cn::polys(w)) {
    same(m, cn::adj_p2v(m, m.poly(p)), cn::adj_p2v(w, p));
    same(m, cn::adj_p2e(m, m.poly(p)), cn::adj_p2e(w, p));
    same(m, cn::adj_p2f(m, m.poly(p)), cn::adj_p2f(w, p));
    for (auto f : cn::adj_p2f(w, p)) CHECK(cn::face_is_outward(m, m.poly(p), m.face(f)) == cn::face_is_outward(w, p, f));
  }
}

TEST_CASE("an owning archetype can be used but not copied") {
  const cn::archetypes::owner<graph> g(s);
  std::size_t degrees = 0;
  for (auto v : cn::verts(g))
    for (auto u : cn::adj_v2v(g, v)) degrees += u == v ? 0u : 1u;
  CHECK(degrees == 2 * cn::num_edges(s));
  CHECK(cn::contains(g, g.vert(user_mesh::vertex{7})));
  CHECK_FALSE(cn::contains(g, g.vert(user_mesh::vertex{8})));
}
