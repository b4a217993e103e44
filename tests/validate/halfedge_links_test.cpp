// check_laws and assert_halfedge_links name the cause if half-edges cannot represent a mesh, whatever the links return.
#include <concino/concepts/halfedge_kernel.hpp>
#include <concino/validate/check_laws.hpp>
#include <concino/validate/halfedge_links.hpp>

#include <doctest/doctest.h>

#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace cn = concino;

namespace {

/// The opposite of a half-edge at the boundary: a border half-edge, none (-1), or the half-edge itself.
enum class border { halfedges, none, itself };

/// Half-edges constructed by a map from pairs of verts, as students write them. Entries with equal keys overwrite each other. Invalid half-edges throw.
struct student {
  struct half { int next = -1, opposite = -1, target = -1, poly = -1, edge = -1; };
  std::vector<half> halves;
  std::vector<int> of_vert, of_edge, of_poly;

  student(int verts, const std::vector<std::vector<int>>& polys, border b = border::halfedges) : of_vert(std::size_t(verts), -1) {
    std::map<std::pair<int, int>, int> at;
    for (const auto& poly : polys) {
      const int first = int(halves.size()), n = int(poly.size());
      for (int i = 0; i < n; ++i) {
        const int from = poly[std::size_t(i)], to = poly[std::size_t((i + 1) % n)], h = first + i;
        halves.push_back({first + (i + 1) % n, -1, to, int(of_poly.size()), -1});
        at[{from, to}] = of_vert[std::size_t(from)] = h;
      }
      of_poly.push_back(first);
    }
    const int inner = int(halves.size());
    std::map<int, int> border_from;
    for (int h = 0; h < inner; ++h) {
      half& x = halves[std::size_t(h)];
      const int to = x.target, from = [&] { int g = h; while (halves[std::size_t(g)].next != h) g = halves[std::size_t(g)].next; return halves[std::size_t(g)].target; }();
      if (const auto other = at.find({to, from}); other != at.end()) {
        x.opposite = other->second;
      } else if (b == border::itself) {
        x.opposite = h;
      } else if (b == border::halfedges) {
        x.opposite = int(halves.size());
        border_from[to] = x.opposite;
        halves.push_back({-1, h, from, -1, -1});
      }
    }
    for (std::size_t h = std::size_t(inner); h < halves.size(); ++h) halves[h].next = border_from.at(halves[h].target);
    for (int h = 0; h < int(halves.size()); ++h) {
      if (halves[std::size_t(h)].edge >= 0) continue;
      const int o = halves[std::size_t(h)].opposite;
      halves[std::size_t(h)].edge = int(of_edge.size());
      if (o >= 0) halves[std::size_t(o)].edge = int(of_edge.size());
      of_edge.push_back(h);
    }
  }
  const half& at(int h) const { return halves.at(std::size_t(h)); }
};

struct student_links {
  using vert = cn::vert_id;
  using edge = cn::edge_id;
  using poly = cn::poly_id;
  using halfedge = int;
  static int next(const student& m, int h) { return m.at(h).next; }
  static int opposite(const student& m, int h) { return m.at(h).opposite; }
  static vert target(const student& m, int h) { return vert(m.at(h).target); }
  static bool is_border(const student& m, int h) { return m.at(h).poly < 0; }
  static poly poly_of(const student& m, int h) { return poly(m.at(h).poly); }
  static edge edge_of(const student& m, int h) { return edge(m.at(h).edge); }
  static bool is_isolated(const student& m, vert v) { return m.of_vert[v.raw()] < 0; }
  static int halfedge_of(const student& m, vert v) { return m.of_vert[v.raw()]; }
  static int halfedge_of(const student& m, edge e) { return m.of_edge[e.raw()]; }
  static int halfedge_of(const student& m, poly p) { return m.of_poly[p.raw()]; }
  static std::size_t num_verts(const student& m) { return m.of_vert.size(); }
  static std::size_t num_edges(const student& m) { return m.of_edge.size(); }
  static std::size_t num_polys(const student& m) { return m.of_poly.size(); }
};

/// The same mesh without border half-edges, with and without `previous`.
struct open_student : student {
  open_student(int verts, const std::vector<std::vector<int>>& polys) : student(verts, polys, border::none) {}
};
struct open_links : student_links {
  static constexpr bool has_border_halfedges = false;
  static bool has_opposite(const student& m, int h) { return m.at(h).opposite >= 0; }
};
struct quick_student : open_student {
  using open_student::open_student;
};
struct quick_links : open_links {
  static int previous(const student& m, int h) {
    for (int g = h;; g = m.at(g).next)
      if (m.at(g).next == h) return g;
  }
};

struct miscounting : student {
  using student::student;
};
struct miscounting_links : student_links {
  static auto edges(const student& m) { return cn::id_range<edge>(m.of_edge.size()); }
  static std::size_t num_edges(const student& m) { return m.of_edge.size() + 1; }
};

}  // namespace

template<> struct concino::mesh_traits<miscounting> : halfedge_kernel<miscounting, miscounting_links> {};
template<> struct concino::mesh_traits<student> : halfedge_kernel<student, student_links> {};
template<> struct concino::mesh_traits<open_student> : halfedge_kernel<open_student, open_links> {};
template<> struct concino::mesh_traits<quick_student> : halfedge_kernel<quick_student, quick_links> {};
static_assert(cn::SurfaceMesh<student> && cn::SurfaceMesh<open_student> && cn::SurfaceMesh<quick_student>);

namespace {

template<class M>
std::string cause(const M& m) {
  try {
    cn::assert_halfedge_links(m);
    return "";
  } catch (const cn::invalid_mesh& e) {
    return e.what();
  }
}

/// Checks that check_laws reports the same cause, and none of its consequences.
template<class M>
void refused(const M& m, const std::string& law, const std::string& what) {
  CHECK(cause(m) == "half-edges: " + what);
  const auto broken = cn::check_laws(m);
  REQUIRE(!broken.empty());
  CHECK(broken.front().what == what);
  for (const auto& b : broken) CHECK(b.law == law);
}

using lists = std::vector<std::vector<int>>;
const lists two_fans = {{0, 1, 2}, {0, 3, 4}};
const lists three_at_an_edge = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
const lists disagreeing = {{0, 1, 2}, {0, 1, 3}};
const lists strip = {{0, 1, 2}, {0, 2, 3}, {3, 2, 4, 5, 6}};
const lists tetrahedron = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

}  // namespace

TEST_CASE("half-edge links: manifold surfaces pass") {
  for (const lists& polys : {strip, tetrahedron, lists{}, lists{{0, 1, 2, 3}}}) {
    CHECK(cause(student(7, polys)) == "");
    CHECK(cn::check_laws(student(7, polys)).empty());
    CHECK(cause(open_student(7, polys)) == "");
    CHECK(cn::check_laws(open_student(7, polys)).empty());
    CHECK(cn::check_laws(quick_student(7, polys)).empty());
  }
}

TEST_CASE("half-edge links: the cause is a vert with several fans") {
  const std::string remedy = " fans of polys: use indexed_surface, or link the border half-edges from one fan to the next";
  refused(student(5, two_fans), "HE4", "vert 0 has two" + remedy);
  refused(open_student(5, two_fans), "HE4", "vert 0 has two" + remedy);
  refused(open_student(7, {{0, 1, 2}, {0, 3, 4}, {0, 5, 6}}), "HE4", "vert 0 has three" + remedy);
  refused(open_student(11, {{0, 1, 2}, {0, 3, 4}, {0, 5, 6}, {0, 7, 8}, {0, 9, 10}}), "HE4", "vert 0 has 5" + remedy);
  refused(student(8, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {3, 5, 4}, {3, 4, 6}, {3, 6, 5}, {4, 5, 6}}), "HE4", "vert 3 has two" + remedy);
}

TEST_CASE("half-edge links: the cause is an edge with three polys") {
  const std::string what = "the edge from vert 0 to vert 1 has 3 polys (p0, p1, p2): half-edges cannot represent that, use indexed_surface";
  refused(student(5, three_at_an_edge), "HE2", what);
  refused(student(5, three_at_an_edge, border::none), "HE2", what);
  refused(open_student(5, three_at_an_edge), "HE2", what);
  refused(open_student(3, lists(7, {0, 1, 2})), "HE2",
          "the edge from vert 0 to vert 1 has 7 polys (p0, p1, p2, p3, ...): half-edges cannot represent that, use indexed_surface");
}

TEST_CASE("half-edge links: the cause is inconsistent orientation, or a poly adjacent to itself") {
  const std::string what = "poly 0 and poly 1 both run from vert 0 to vert 1, so their orientations disagree: reverse one of them, or use indexed_surface";
  for (const border b : {border::halfedges, border::none, border::itself}) refused(student(4, disagreeing, b), "HE2", what);
  refused(open_student(4, disagreeing), "HE2", what);
  refused(open_student(4, {{0, 1, 2, 0, 1, 3}}), "HE2", "poly 0 runs from vert 0 to vert 1 twice: half-edges cannot represent that, use indexed_surface");
  refused(open_student(4, {{0, 0, 1}}), "HE2", "poly 0 runs from vert 0 to itself");
}

TEST_CASE("half-edge links: the cause is a missing border half-edge") {
  const auto what = [](const char* gives) {
    return std::string("lies at the border, and opposite gives ") + gives +
           ": border half-edges must exist, or the links say static constexpr bool has_border_halfedges = false";
  };
  refused(student(7, strip, border::none), "HE3", "the edge from vert 3 to vert 0 " + what("another border edge the same half-edge"));
  refused(student(7, strip, border::itself), "HE3", "the edge from vert 0 to vert 1 " + what("the half-edge itself"));
}

TEST_CASE("half-edge links: the cause is a wrong link") {
  const auto wrong = [](const char* law, const std::string& what, auto change) {
    student m(7, strip);
    change(m);
    refused(m, law, what);
  };
  wrong("HE1", "the half-edges of poly 0: next does not come back to halfedge_of", [](student& m) { m.halves[2].next = 1; });
  wrong("HE1", "the half-edges of poly 0: next leads to one whose poly_of is another poly", [](student& m) { m.halves[1].next = 5; });
  wrong("HE1", "the half-edges of poly 1: poly_of(halfedge_of) is another poly", [](student& m) { m.of_poly[1] = 0; });
  wrong("HE1", "the half-edges of poly 0: next leads to one at the border", [](student& m) { m.halves[1].next = m.halves[1].opposite; });
  wrong("HE1", "the half-edges of poly 2: halfedge_of is at the border", [](student& m) { m.of_poly[2] = 11; });
  wrong("HE1", "the half-edges of poly 0: the target of one of them is not a vert of the mesh", [](student& m) { m.halves[1].target = 70; });
  wrong("HE3", "the half-edges from vert 2 to vert 0 of poly 0 and from vert 0 to vert 2 of poly 1 are not opposite to each other",
        [](student& m) { m.halves[2].opposite = m.halves[0].opposite; });
  wrong("HE3", "the half-edge from vert 0 to vert 1 of poly 0: its opposite belongs to a poly that does not run the other way",
        [](student& m) { m.halves[0].opposite = 4; });
  wrong("HE3", "the half-edge from vert 1 to vert 2 of poly 0: opposite of its opposite is another half-edge",
        [](student& m) { m.halves[std::size_t(m.halves[1].opposite)].opposite = 0; });
  wrong("HE3", "the half-edge from vert 0 to vert 1 of poly 0: its opposite does not lead to vert 0",
        [](student& m) { m.halves[std::size_t(m.halves[0].opposite)].target = 5; });
  wrong("HE3", "edge 1: edge_of(halfedge_of(e)) and of its opposite must be e, and the two be opposite to each other",
        [](student& m) { m.of_edge[1] = m.of_edge[0]; });
  wrong("HE4", "vert 4: is_isolated is true, but half-edges leave it", [](student& m) { m.of_vert[4] = -1; });
  wrong("HE4", "vert 4: stepping from halfedge_of to next(opposite(h)) leads to a half-edge that leaves another vert", [](student& m) { m.of_vert[4] = 0; });
  wrong("HE1", "a function of the half-edges throws: vector::_M_range_check: __n (which is 18446744073709551615) >= this->size() (which is " +
                   std::to_string(student(7, strip).halves.size()) + ")",
        [](student& m) { m.halves[1].next = -1; });
}

TEST_CASE("half-edge links: assert_halfedge_links throws for invalid elements too") {
  CHECK(cause(miscounting(3, {{0, 1, 2}})) == "half-edges: the range of edges has 3, but num_edges is 4");
  student m(3, {{0, 1, 2}});
  m.of_vert.push_back(0);
  CHECK(cause(m) == "half-edges: vert 3: is_isolated is false, but no half-edge leaves it");
}

TEST_CASE("half-edge links: the cause is a border that leads into a poly") {
  student m(7, strip);
  const int into = [&] { for (int h = 0;; ++h) if (m.at(h).poly < 0 && m.at(h).target == 0) return h; }();
  m.halves[std::size_t(into)].next = 3;
  CHECK(cause(m) == "half-edges: edge 0: next leads from its half-edge at the border into a poly");
}
