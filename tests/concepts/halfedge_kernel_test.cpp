// A small half-edge mesh of a user becomes a SurfaceMesh by halfedge_kernel, and its rings equal those of a brute-force search.
#include <concino/concepts/halfedge_kernel.hpp>
#include <concino/concepts/views/dual.hpp>
#include <concino/graph/bfs.hpp>
#include <concino/graph/components.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/models.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <iterator>
#include <map>
#include <set>

namespace cn = concino;

namespace {

/// Half-edges 2e and 2e + 1 are opposite. A poly or half-edge of -1 means none.
struct linked {
  std::vector<int> next, target, poly, leaving, along;
};

/// The links of a consistently oriented surface. Border half-edges are linked so that one cycle around a vert visits all of its fans.
linked link(const user_mesh::surface& s) {
  linked m;
  const std::size_t n = 2 * s.es.size();
  m.next.assign(n, -1);
  m.target.assign(n, -1);
  m.poly.assign(n, -1);
  m.leaving.assign(s.points.size(), -1);
  m.along.assign(s.polygons.size(), -1);
  std::map<std::pair<int, int>, int> id;
  for (std::size_t e = 0; e < s.es.size(); ++e) {
    const auto [a, b] = s.es[e];
    id[{a, b}] = static_cast<int>(2 * e);
    id[{b, a}] = static_cast<int>(2 * e + 1);
    m.target[2 * e] = b;
    m.target[2 * e + 1] = a;
    m.leaving[std::size_t(a)] = static_cast<int>(2 * e);
    m.leaving[std::size_t(b)] = static_cast<int>(2 * e + 1);
  }
  for (std::size_t p = 0; p < s.polygons.size(); ++p) {
    const auto& q = s.polygons[p];
    for (std::size_t i = 0; i < q.size(); ++i) {
      const int h = id.at({q[i], q[(i + 1) % q.size()]});
      m.next[std::size_t(h)] = id.at({q[(i + 1) % q.size()], q[(i + 2) % q.size()]});
      m.poly[std::size_t(h)] = static_cast<int>(p);
      m.along[p] = h;
    }
  }
  // At each vert the k-th incoming border half-edge is followed by the border half-edge that leaves at the other end of the next fan.
  for (std::size_t v = 0; v < s.points.size(); ++v) {
    std::vector<int> in, out;
    for (int h = 0; h < static_cast<int>(n); ++h)
      if (m.poly[std::size_t(h)] < 0 && m.target[std::size_t(h)] == static_cast<int>(v)) {
        // Rotate through the fan from the incoming border half-edge to the outgoing one.
        int o = h ^ 1;
        while (m.poly[std::size_t(o)] >= 0) {
          int back = m.next[std::size_t(o)];
          while (m.next[std::size_t(back)] != o) back = m.next[std::size_t(back)];
          o = back ^ 1;
        }
        in.push_back(h);
        out.push_back(o);
      }
    for (std::size_t k = 0; k < in.size(); ++k) m.next[std::size_t(in[k])] = out[(k + 1) % out.size()];
  }
  return m;
}

struct links {
  using vert = cn::vert_id;
  using edge = cn::edge_id;
  using poly = cn::poly_id;
  using halfedge = int;
  static int next(const linked& m, int h) { return m.next[std::size_t(h)]; }
  static int opposite(const linked&, int h) { return h ^ 1; }
  static vert target(const linked& m, int h) { return vert(m.target[std::size_t(h)]); }
  static bool is_border(const linked& m, int h) { return m.poly[std::size_t(h)] < 0; }
  static poly poly_of(const linked& m, int h) { return poly(m.poly[std::size_t(h)]); }
  static edge edge_of(const linked&, int h) { return edge(h / 2); }
  static bool is_isolated(const linked& m, vert v) { return m.leaving[v.raw()] < 0; }
  static int halfedge_of(const linked& m, vert v) { return m.leaving[v.raw()]; }
  static int halfedge_of(const linked&, edge e) { return int(2 * e.raw()); }
  static int halfedge_of(const linked& m, poly p) { return m.along[p.raw()]; }
  static std::size_t num_verts(const linked& m) { return m.leaving.size(); }
  static std::size_t num_edges(const linked& m) { return m.next.size() / 2; }
  static std::size_t num_polys(const linked& m) { return m.along.size(); }
};

/// A descriptor that is explicitly constructed from an integer, also from -1.
template<char Kind>
struct own_handle {
  int i;
  explicit own_handle(int i_ = -1) : i(i_) {}
  friend bool operator==(own_handle, own_handle) = default;
};

/// Links of a mesh with its own descriptors and with deleted verts.
struct own_handles : links {
  using vert = own_handle<'v'>;
  using poly = own_handle<'p'>;
  static vert target(const linked& m, int h) { return vert(m.target[std::size_t(h)]); }
  static poly poly_of(const linked& m, int h) { return poly(m.poly[std::size_t(h)]); }
  static bool is_isolated(const linked& m, vert v) { return m.leaving[std::size_t(v.i)] < 0; }
  static int halfedge_of(const linked& m, vert v) { return m.leaving[std::size_t(v.i)]; }
  static int halfedge_of(const linked& m, edge e) { return links::halfedge_of(m, e); }
  static int halfedge_of(const linked& m, poly p) { return m.along[std::size_t(p.i)]; }
  static std::vector<vert> verts(const linked& m) {
    std::vector<vert> r;
    for (int i = 0; i < static_cast<int>(m.leaving.size()); ++i) if (m.leaving[std::size_t(i)] >= 0) r.push_back(vert(i));
    return r;
  }
  static std::vector<poly> polys(const linked& m) {
    std::vector<poly> r;
    for (int i = 0; i < static_cast<int>(m.along.size()); ++i) r.push_back(poly(i));
    return r;
  }
  static std::size_t num_verts(const linked& m) { return verts(m).size(); }
  static std::size_t vert_index_bound(const linked& m) { return m.leaving.size(); }
  static std::size_t poly_index_bound(const linked& m) { return m.along.size(); }
  static std::size_t index_of(const linked&, vert v) { return std::size_t(v.i); }
  static std::size_t index_of(const linked&, poly p) { return std::size_t(p.i); }
};
struct gappy : linked {};

/// Links that count the calls of opposite.
struct counting_links : links {
  static inline int asked = 0;
  static int opposite(const linked&, int h) {
    ++asked;
    return h ^ 1;
  }
};
struct counting : linked {};

/// The same links as if there were no border half-edges: those are never queried.
struct inner_links : links {
  static constexpr bool has_border_halfedges = false;
  static void is_border(const linked&, int) = delete;
  static bool has_opposite(const linked& m, int h) { return m.poly[std::size_t(h ^ 1)] >= 0; }
  static int inner(const linked& m, int h) { REQUIRE(m.poly[std::size_t(h)] >= 0); return h; }
  static int next(const linked& m, int h) { return m.next[std::size_t(inner(m, h))]; }
  static int opposite(const linked& m, int h) { return inner(m, inner(m, h) ^ 1); }
  static vert target(const linked& m, int h) { return links::target(m, inner(m, h)); }
  static edge edge_of(const linked& m, int h) { return links::edge_of(m, inner(m, h)); }
  static int halfedge_of(const linked& m, vert v) {
    int h = m.leaving[v.raw()];
    while (m.poly[std::size_t(h)] < 0) h = m.next[std::size_t(h ^ 1)];
    return inner(m, h);
  }
  static int halfedge_of(const linked& m, edge e) { return inner(m, m.poly[2 * e.raw()] >= 0 ? int(2 * e.raw()) : int(2 * e.raw() + 1)); }
  static int halfedge_of(const linked& m, poly p) { return inner(m, m.along[p.raw()]); }
};
struct borderless : linked {};
struct incomplete_links : inner_links {
  static void has_opposite(const linked&, int);
};

struct lacking : links {
  static void next(const linked&, int);
};
struct hopeless {};
struct untyped {};
struct no_links {};

}  // namespace

template<> struct concino::mesh_traits<linked> : halfedge_kernel<linked, links> {};
template<> struct concino::mesh_traits<gappy> : halfedge_kernel<gappy, own_handles> {};
template<> struct concino::mesh_traits<borderless> : halfedge_kernel<borderless, inner_links> {};
template<> struct concino::mesh_traits<counting> : halfedge_kernel<counting, counting_links> {};
template<> struct concino::mesh_traits<hopeless> : halfedge_kernel<linked, lacking> {};
template<> struct concino::mesh_traits<untyped> : halfedge_kernel<untyped, no_links> {};

static_assert(cn::testing::models_in_all_forms<linked>(cn::testing::surface));
static_assert(cn::testing::models_in_all_forms<gappy>(cn::testing::surface));
static_assert(cn::testing::models_in_all_forms<borderless>(cn::testing::surface));
static_assert(cn::HalfedgeLinks<inner_links, linked> && !cn::HalfedgeLinks<incomplete_links, linked>);
static_assert(!cn::PrimalGraph<hopeless> && !cn::SurfaceMesh<hopeless>);
static_assert(!cn::PrimalGraph<untyped> && !cn::SurfaceMesh<untyped> && !cn::HalfedgeLinks<no_links, untyped>);
static_assert(cn::HalfedgeLinks<links, linked> && !cn::HalfedgeLinks<lacking, linked> && !cn::HalfedgeLinks<int, linked>);
static_assert(std::forward_iterator<decltype(cn::adj_v2v(linked(), cn::vert_id()).begin())>);
static_assert(std::forward_iterator<decltype(cn::adj_p2p(linked(), cn::poly_id()).begin())>);

namespace {

template<class R>
std::multiset<std::size_t> numbers(const R& r) {
  std::multiset<std::size_t> s;
  for (auto x : r) {
    if constexpr (requires { x.raw(); }) s.insert(x.raw());
    else s.insert(std::size_t(x.i));
  }
  return s;
}

/// Checks that the loop function of a range visits the same elements as its iterators, in the same order.
template<class R>
void same_loop(const R& r) {
  using element = std::remove_cvref_t<decltype(*r.begin())>;
  std::vector<element> called, walked;
  r.for_each([&](const element& x) { called.push_back(x); });
  for (const element x : r) walked.push_back(x);
  CHECK(called == walked);
}

template<class M>
void same_rings_of(const M& m, const user_mesh::surface& s) {
  for (const auto& b : cn::check_laws(m)) MESSAGE(b.law << ": " << b.what);
  CHECK(cn::check_laws(m).empty());
  for (int i = 0; i < static_cast<int>(s.points.size()); ++i) {
    const cn::vert_id v(i);
    const user_mesh::vertex w{i};
    CHECK(numbers(cn::adj_v2v(m, v)) == numbers(cn::adj_v2v(s, w)));
    CHECK(numbers(cn::adj_v2e(m, v)) == numbers(cn::adj_v2e(s, w)));
    CHECK(numbers(cn::adj_v2p(m, v)) == numbers(cn::adj_v2p(s, w)));
    same_loop(cn::adj_v2v(m, v));
    same_loop(cn::adj_v2e(m, v));
    same_loop(cn::adj_v2p(m, v));
  }
  for (int i = 0; i < static_cast<int>(s.es.size()); ++i) {
    CHECK(numbers(cn::adj_e2v(m, cn::edge_id(i))) == numbers(cn::adj_e2v(s, user_mesh::segment{i})));
    CHECK(numbers(cn::adj_e2p(m, cn::edge_id(i))) == numbers(cn::adj_e2p(s, user_mesh::segment{i})));
  }
  for (int i = 0; i < static_cast<int>(s.polygons.size()); ++i) {
    const cn::poly_id p(i);
    CHECK(numbers(cn::adj_p2v(m, p)) == numbers(cn::adj_p2v(s, user_mesh::cell{i})));
    CHECK(numbers(cn::adj_p2e(m, p)) == numbers(cn::adj_p2e(s, user_mesh::cell{i})));
    CHECK(numbers(cn::adj_p2p(m, p)) == numbers(cn::adj_p2p(s, user_mesh::cell{i})));
    same_loop(cn::adj_p2v(m, p));
    same_loop(cn::adj_p2e(m, p));
    same_loop(cn::adj_p2p(m, p));
    std::set<std::size_t> others;
    cn::adj_p2p(m, p).for_each_with_repeats([&](cn::poly_id q) { others.insert(q.raw()); });
    others.erase(p.raw());
    CHECK(std::multiset<std::size_t>(others.begin(), others.end()) == numbers(cn::adj_p2p(m, p)));
  }
}

/// Checks all rings. `fans`: some vert has several fans, which only border half-edges can link.
void same_rings(const user_mesh::surface& s, bool fans = false) {
  const linked m = link(s);
  const gappy g{m};
  same_rings_of(m, s);
  if (!fans) same_rings_of(borderless{m}, s);
  CHECK(cn::check_laws(g).empty());
  for (int i = 0; i < static_cast<int>(s.points.size()); ++i)
    CHECK(numbers(cn::adj_v2v(g, own_handles::vert(i))) == numbers(cn::adj_v2v(s, user_mesh::vertex{i})));
}

using points = std::vector<std::array<double, 3>>;

}  // namespace

TEST_CASE("halfedge_kernel: rings are right on open, closed and disconnected meshes and at isolated verts") {
  same_rings(user_mesh::surface_example());
  same_rings({points(4), {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}});
  same_rings({points(9), {{0, 1, 2}, {3, 4, 5, 6}}});
  same_rings(user_mesh::surface());
}

TEST_CASE("halfedge_kernel: a vert may have several fans") {
  same_rings({points(7), {{0, 1, 2}, {0, 3, 4}, {0, 5, 6}}}, true);
  same_rings({points(8), {{0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {0, 6, 7}}}, true);
}

TEST_CASE("halfedge_kernel: polys that share several edges are neighbours once") {
  // Two polygons with the same verts; and one that encloses another, with further polys in between.
  same_rings({points(6), {{0, 1, 2, 3, 4, 5}, {5, 4, 3, 2, 1, 0}}});
  // Two triangles and two quads with the same verts; a quad that shares two edges with its neighbour.
  same_rings({points(3), {{0, 1, 2}, {2, 1, 0}}});
  same_rings({points(4), {{0, 1, 2, 3}, {3, 2, 1, 0}}});
  same_rings({points(5), {{0, 1, 2, 3}, {3, 2, 1, 4}, {4, 1, 0, 3}}});
  same_rings({points(14),
              {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11},
               {1, 0, 12},
               {2, 1, 13},
               {3, 2, 13},
               {5, 4, 3, 13, 1, 12},
               {7, 6, 5, 12, 0, 11, 10, 9},
               {9, 8, 7}}});
}

TEST_CASE("halfedge_kernel: a poly with both half-edges of an edge is not its own neighbour") {
  // A triangle and an edge that leads from one of its corners into it: the poly has both half-edges of this edge.
  const linked m{{2, 5, 4, 1, 6, 3, 7, 0}, {1, 0, 2, 1, 0, 2, 3, 0}, {0, -1, 0, -1, 0, -1, 0, 0}, {0, 2, 4, 7}, {0}};
  const auto neighbours = cn::adj_p2p(m, cn::poly_id(0));
  CHECK(neighbours.begin() == neighbours.end());
  neighbours.for_each([](cn::poly_id) { FAIL("p itself"); });
  int times = 0;
  neighbours.for_each_with_repeats([&](cn::poly_id q) { times += q == cn::poly_id(0); });
  CHECK(times == 2);
}

TEST_CASE("halfedge_kernel: a search over polys calls opposite once per edge of each poly") {
  // A polygon of 12 edges with a triangle at each.
  std::vector<std::vector<int>> polygons(1);
  for (int i = 0; i < 12; ++i) {
    polygons[0].push_back(i);
    polygons.push_back({(i + 1) % 12, i, 12 + i});
  }
  const counting m{link({points(24), polygons})};
  counting_links::asked = 0;
  CHECK(cn::bfs(cn::dual(m), cn::poly_id(0))[cn::poly_id(7)] == 1);
  CHECK(counting_links::asked == 12 + 12 * 3);
  counting_links::asked = 0;
  CHECK(cn::connected_components(cn::dual(m)).count == 1);
  CHECK(counting_links::asked == 12 + 12 * 3);
}

TEST_CASE("halfedge_kernel: the message names the missing member") { cn::explain_halfedge_links<links, linked>(); }
