// Each law that is broken on purpose is reported under its own number with a witness; the correct mesh breaks none.
#include <concino/concepts/archetypes.hpp>
#include <concino/mesh/boundary.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/faulty_mesh.hpp>
#include <support/meshes.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <random>
#include <stdexcept>

namespace cn = concino;

namespace {

using surface = user_mesh::faulty_mesh<user_mesh::surface>;
using volume = user_mesh::faulty_mesh<user_mesh::volume>;
static_assert(cn::SurfaceMesh<surface> && !cn::VolumeMesh<surface> && cn::VolumeMesh<volume> && cn::Embedded<volume>);

surface example(const surface*) { return surface(user_mesh::surface_example()); }
volume example(const volume*) { return volume(user_mesh::volume_example()); }

std::string list(const std::vector<cn::broken_law>& found) {
  std::string s;
  for (const auto& b : found) s += b.law + ": " + b.what + " [" + b.witness + "]\n";
  return s;
}
bool names(const std::vector<cn::broken_law>& found, std::string_view law, std::string_view witness) {
  for (const auto& b : found)
    if (b.law == law && b.witness == witness && !b.what.empty()) return true;
  return false;
}

/// The broken laws if the ring of `verb` at `a` is replaced.
template<class M>
std::vector<cn::broken_law> with_ring(const char* verb, int a, std::vector<int> instead) {
  M m = example(static_cast<M*>(nullptr));
  m.ring = [=](std::string_view asked, int x, std::vector<int>& ring) { if (asked == verb && x == a) ring = instead; };
  auto found = cn::check_laws(m);
  INFO(list(found));
  CHECK_FALSE(found.empty());
  return found;
}
template<class M>
std::vector<cn::broken_law> with_number(const char* verb, int a, std::size_t instead, int b = -1) {
  M m = example(static_cast<M*>(nullptr));
  m.number = [=](std::string_view asked, int x, int y, std::size_t n) { return asked == verb && x == a && y == b ? instead : n; };
  auto found = cn::check_laws(m);
  INFO(list(found));
  CHECK_FALSE(found.empty());
  return found;
}
template<class M>
void law_by_ring(const char* law, const char* witness, const char* verb, int a, std::vector<int> instead) {
  const auto found = with_ring<M>(verb, a, instead);
  INFO(std::string(verb) << " " << a << "\n" << list(found));
  CHECK(names(found, law, witness));
}
template<class M>
void law_by_number(const char* law, const char* witness, const char* verb, int a, std::size_t instead, int b = -1) {
  const auto found = with_number<M>(verb, a, instead, b);
  INFO(std::string(verb) << " " << a << "\n" << list(found));
  CHECK(names(found, law, witness));
}
/// Checks that only this law is broken.
void only(const std::vector<cn::broken_law>& found, std::string_view law) {
  INFO(list(found));
  for (const auto& b : found) CHECK(b.law == law);
}

}  // namespace

TEST_CASE("check_laws: correct meshes and their archetypes break no law") {
  const surface s(user_mesh::surface_example());
  const volume w(user_mesh::volume_example());
  CHECK(cn::check_laws(s).empty());
  CHECK(cn::check_laws(w).empty());
  CHECK(cn::check_laws(user_mesh::surface()).empty());
  CHECK(cn::check_laws(user_mesh::volume()).empty());
  CHECK(cn::check_laws(cn::only_primal_graph(w)).empty());
  CHECK(cn::check_laws(cn::only_embedded_graph(s)).empty());
  CHECK(cn::check_laws(cn::only_dual_graph(w)).empty());
  CHECK(cn::check_laws(cn::only_graphs(s)).empty());
  CHECK(cn::check_laws(cn::only_mesh(s)).empty());
  CHECK(cn::check_laws(cn::only_embedded_mesh(w)).empty());
  CHECK(cn::check_laws(cn::archetypes::owner<decltype(cn::only_embedded_mesh(w))>(w)).empty());
}

TEST_CASE_TEMPLATE("check_laws: each broken law of graphs is found", M, surface, volume) {
  law_by_number<M>("PG1", "v99", "index_of v", 3, 99);
  law_by_number<M>("PG1", "v2", "index_of v", 3, 2);
  law_by_number<M>("PG1", "v7", "vert_index_bound", -1, 7);
  law_by_number<M>("PG2", "", "num_verts", -1, 99);
  law_by_ring<M>("PG2", "v1", "verts", -1, {0, 1, 1, 2, 3, 4, 5, 6});
  law_by_ring<M>("PG4", "v1 v2", "adj_v2v", 1, {0, 2, 2, 5});
  law_by_ring<M>("PG4", "v1", "adj_v2v", 1, {0, 2, 1});
  law_by_ring<M>("PG4", "v1 v1234", "adj_v2v", 1, {0, 2, 1234});
  law_by_ring<M>("PG3", "v2 v1", "adj_v2v", 1, {0});
  law_by_number<M>("DG1", "p99", "index_of p", 1, 99);
  law_by_number<M>("DG1", "p0", "index_of p", 1, 0);
  law_by_number<M>("DG2", "", "num_polys", -1, 99);
  law_by_ring<M>("DG2", "p0", "polys", -1, {0, 0});
  law_by_ring<M>("DG4", "p0 p1", "adj_p2p", 0, {1, 1});
  law_by_ring<M>("DG4", "p0", "adj_p2p", 0, {0, 1});
  law_by_ring<M>("DG4", "p0 p1234", "adj_p2p", 0, {1234, 1});
  law_by_ring<M>("DG3", "p1 p0", "adj_p2p", 0, {});
}

TEST_CASE_TEMPLATE("check_laws: an element that is listed many times is reported as that, and what is listed behind it is not missing", M, surface, volume) {
  const M m = example(static_cast<M*>(nullptr));
  std::vector<int> ring(30, 0);
  for (const auto v : cn::verts(m))
    if (cn::index_of(m, v) == 1)
      for (const auto w : cn::adj_v2v(m, v)) ring.push_back(static_cast<int>(cn::index_of(m, w)));
  const auto found = with_ring<M>("adj_v2v", 1, ring);
  REQUIRE(found.size() == 1);
  CHECK(found[0].what == "adj_v2v(v1) holds v0 twice");
}

TEST_CASE_TEMPLATE("check_laws: each broken law of edges and points is found", M, surface, volume) {
  law_by_number<M>("SM1", "e99", "index_of e", 3, 99);
  law_by_number<M>("SM1", "e2", "index_of e", 3, 2);
  law_by_number<M>("SM1", "", "num_edges", -1, 3);
  law_by_ring<M>("SM2", "e0", "adj_e2v", 0, {0});
  law_by_ring<M>("SM2", "e0 v0", "adj_e2v", 0, {0, 0});
  law_by_ring<M>("SM2", "e0 v99", "adj_e2v", 0, {0, 99});
  law_by_ring<M>("SM2", "e0 v0", "adj_v2e", 0, {1});
  law_by_ring<M>("SM2", "v0 v3", "adj_v2v", 0, {});
  M m = example(static_cast<M*>(nullptr));
  m.points[4][1] = std::numeric_limits<double>::quiet_NaN();
  CHECK(names(cn::check_laws(m), "EM1", "v4"));
  only(cn::check_laws(m), "EM1");
}

TEST_CASE("check_laws: each broken law of surfaces is found") {
  law_by_ring<surface>("SM3", "p0", "adj_p2v", 0, {0, 1});
  law_by_ring<surface>("SM3", "p3 v4 v6", "adj_p2v", 3, {0, 4, 6, 5});
  law_by_ring<surface>("SM3", "p0 e5", "adj_p2e", 0, {0, 1, 5});
  law_by_ring<surface>("SM3", "p0 v1", "adj_p2v", 0, {0, 1, 1, 2});
  law_by_ring<surface>("SM4", "p0 e0", "adj_e2p", 0, {});
  law_by_ring<surface>("SM4", "v1 p3", "adj_v2p", 1, {0, 3});
  law_by_ring<surface>("SM5", "p0 p3", "adj_p2p", 0, {1, 3});
  only(with_ring<surface>("adj_v2p", 1, {0, 3}), "SM4");
  only(with_ring<surface>("adj_v2p", 1, {0, 0}), "SM4");
  only(with_ring<surface>("adj_p2v", 3, {0, 4, 6, 5}), "SM3");
}

TEST_CASE("check_laws: each broken law of volumes is found") {
  law_by_number<volume>("VM1", "f99", "index_of f", 3, 99);
  law_by_number<volume>("VM1", "f2", "index_of f", 3, 2);
  law_by_number<volume>("VM1", "", "num_faces", -1, 11);
  law_by_ring<volume>("VM2", "f0", "adj_f2v", 0, {0, 3, 2});
  law_by_ring<volume>("VM2", "f0 v2 v0", "adj_f2v", 0, {0, 3, 1, 2});
  law_by_ring<volume>("VM2", "f0 e10", "adj_f2e", 0, {0, 1, 2, 10});
  law_by_ring<volume>("VM3", "f0 e0", "adj_e2f", 0, {});
  law_by_ring<volume>("VM3", "f6 v8", "adj_v2f", 8, {7, 8, 9});
  law_by_ring<volume>("VM3", "p0 f1", "adj_f2p", 1, {1});
  law_by_ring<volume>("VM4", "p1 v0", "adj_p2v", 1, {4, 5, 6, 7, 8, 0});
  law_by_ring<volume>("VM4", "p1 v8", "adj_p2v", 1, {4, 5, 6, 7});
  law_by_ring<volume>("VM4", "p0 v0", "adj_v2p", 0, {});
  law_by_ring<volume>("VM4", "p0 e0", "adj_e2p", 0, {});
  law_by_ring<volume>("VM5", "p0 p1 f1", "adj_p2p", 0, {});
  law_by_number<volume>("VM6", "p1 e4", "face_is_outward", 1, 1, 1);
  only(with_number<volume>("face_is_outward", 1, 1, 1), "VM6");
  only(with_ring<volume>("adj_v2f", 8, {7, 8, 9}), "VM3");
}

namespace {

/// The broken laws if a ring changes while the mesh is checked: call number `call` (from 1) of `verb` at `a` returns another ring.
template<class M>
std::vector<cn::broken_law> with_ring_at_call(const char* verb, int a, int call, std::vector<int> instead) {
  M m = example(static_cast<M*>(nullptr));
  int calls = 0;
  m.ring = [&](std::string_view asked, int x, std::vector<int>& ring) { if (asked == verb && x == a && ++calls == call) ring = instead; };
  auto found = cn::check_laws(m);
  INFO(list(found));
  CHECK_FALSE(found.empty());
  return found;
}
/// Facet 1 has two polys in both examples. Its polys are queried first for a law of the mesh, then for FC2, twice for FC3, and for FC4.
template<class M>
void law_by_ring_at_call(const char* law, const char* witness, const char* verb, int a, int call, std::vector<int> instead) {
  const auto found = with_ring_at_call<M>(verb, a, call, instead);
  INFO(std::string(verb) << " " << a << " call " << call << "\n" << list(found));
  CHECK(names(found, law, witness));
  only(found, law);
}

/// A model that stores the results of adj_p2facet and adj_facet2p in the same buffer: each is right until the other is called.
template<class M>
struct one_buffer : M {
  explicit one_buffer(const M& m) : M(m) {}
  mutable std::vector<int> buffer;

  template<class X> struct range {
    const std::vector<int>* buffer;
    struct iterator {
      const std::vector<int>* buffer;
      std::size_t i;
      X operator*() const { return {i < buffer->size() ? (*buffer)[i] : 0}; }
      iterator& operator++() {
        ++i;
        return *this;
      }
      bool operator!=(const range&) const { return i < buffer->size(); }
    };
    iterator begin() const { return {buffer, 0}; }
    const range& end() const { return *this; }
  };
  template<class X>
  range<X> kept(const std::vector<X>& list) const {
    buffer.clear();
    for (const X x : list) buffer.push_back(x.i);
    return {&buffer};
  }
};

/// A volume that declares tets or hexes; adj_p2v returns the verts in their order.
template<int Arity>
struct shaped : user_mesh::volume {
  std::vector<int> order;
};

}  // namespace

template<>
struct concino::mesh_traits<one_buffer<user_mesh::surface>> : mesh_traits<user_mesh::surface> {
  using B = one_buffer<user_mesh::surface>;
  static auto adj_p2e(const B& m, poly p) { return m.kept(mesh_traits<user_mesh::surface>::adj_p2e(m, p)); }
  static auto adj_e2p(const B& m, edge e) { return m.kept(mesh_traits<user_mesh::surface>::adj_e2p(m, e)); }
};
template<>
struct concino::mesh_traits<one_buffer<user_mesh::volume>> : mesh_traits<user_mesh::volume> {
  using B = one_buffer<user_mesh::volume>;
  static auto adj_p2f(const B& m, poly p) { return m.kept(mesh_traits<user_mesh::volume>::adj_p2f(m, p)); }
  static auto adj_f2p(const B& m, face f) { return m.kept(mesh_traits<user_mesh::volume>::adj_f2p(m, f)); }
};

TEST_CASE("check_laws: facets: results that change while the mesh is read are found") {
  law_by_ring_at_call<surface>("FC1", "", "edges", -1, 2, {0, 1, 2, 3});
  law_by_ring_at_call<volume>("FC1", "", "faces", -1, 2, {0, 1, 2, 3});
  law_by_ring_at_call<surface>("FC1", "e2", "edges", -1, 2, {0, 1, 2, 2, 3, 4, 5, 6, 7, 8, 9});
  law_by_ring_at_call<surface>("FC2", "p0 e2", "adj_e2p", 2, 2, {1});
  law_by_ring_at_call<volume>("FC2", "p0 f1", "adj_f2p", 1, 2, {1});
  law_by_ring_at_call<surface>("FC2", "e2 p0", "adj_e2p", 2, 2, {0, 0, 1});
  law_by_ring_at_call<volume>("FC2", "f1 v8 p0", "adj_f2v", 1, 2, {4, 5, 6, 8});
  for (const int walk : {3, 4}) {
    const std::string s = walk == 3 ? "p0 e2" : "p1 e2", w = walk == 3 ? "p0 f1" : "p1 f1";
    law_by_ring_at_call<surface>("FC3", s.c_str(), "adj_e2p", 2, walk, {});
    law_by_ring_at_call<surface>("FC3", s.c_str(), "adj_e2p", 2, walk, {0, 1, 2});
    law_by_ring_at_call<volume>("FC3", w.c_str(), "adj_f2p", 1, walk, {});
  }
  law_by_ring_at_call<volume>("FC2", "f1 v0 p1", "adj_f2v", 1, 2, {4, 5, 6, 0});
  law_by_ring_at_call<surface>("FC3", "p0 e2", "adj_e2p", 2, 3, {0, 3});
  law_by_ring_at_call<volume>("FC3", "p0", "adj_p2f", 0, 3, {0, 1, 2, 3, 4, 5, 6});
  law_by_ring_at_call<volume>("FC3", "p0", "adj_p2f", 0, 3, {0, 1});
  law_by_ring_at_call<volume>("FC3", "p0", "adj_p2f", 0, 3, {1, 0, 2, 3, 4, 5});
  law_by_ring_at_call<surface>("FC4", "e2", "adj_e2p", 2, 5, {1});
  law_by_ring_at_call<volume>("FC4", "f1", "adj_f2p", 1, 5, {0});
  law_by_ring_at_call<surface>("FC4", "p0", "adj_p2e", 0, 4, {2});
  law_by_ring_at_call<volume>("FC4", "p0", "adj_p2f", 0, 4, {1});
  law_by_ring_at_call<surface>("FC4", "v1", "adj_v2e", 1, 2, {});
  law_by_ring_at_call<volume>("FC4", "v8", "adj_v2f", 8, 2, {});
  law_by_ring_at_call<volume>("FC4", "e0", "adj_e2f", 0, 2, {});
}

TEST_CASE("check_laws: facets: a wrong boundary and a missing one are found") {
  const auto none = with_ring_at_call<surface>("adj_e2p", 2, 5, {1}), unseen = with_ring_at_call<surface>("adj_v2e", 1, 2, {});
  REQUIRE(none.size() == 1);
  CHECK(none[0].what == "is_boundary(e2) is true, but it has no facet of one poly");
  REQUIRE(unseen.size() == 1);
  CHECK(unseen[0].what == "is_boundary(v1) is false, but it has a facet of one poly");
}

TEST_CASE("check_laws: facets: a wrong poly before a right one at a facet is found") {
  surface m(user_mesh::surface({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}));
  CHECK(cn::check_laws(m).empty());
  int calls = 0;
  m.ring = [&](std::string_view asked, int x, std::vector<int>& ring) { if (asked == "adj_e2p" && x == 0 && ++calls == 3) ring = {0, 2, 2}; };
  const auto found = cn::check_laws(m);
  INFO(list(found));
  CHECK(names(found, "FC3", "p0 e0"));
}

TEST_CASE("check_laws: facets: wrong verts of an edge are found") {
  surface m = example(static_cast<surface*>(nullptr));
  int walks = 0;  // iterations over all edges: first as edges, then as facets
  m.ring = [&](std::string_view asked, int x, std::vector<int>& ring) {
    if (asked == "edges") ++walks;
    if (walks == 2 && asked == "adj_e2v" && x == 2) ring = {0, 7};
  };
  const auto found = cn::check_laws(m);
  INFO(list(found));
  CHECK(names(found, "FC2", "e2 v7 p0"));
  only(found, "FC2");
}

TEST_CASE_TEMPLATE("check_laws: facets: a model that throws at a repeated query is reported", M, surface, volume) {
  for (const int call : {3, 5}) {
    M m = example(static_cast<M*>(nullptr));
    int calls = 0;
    m.ring = [&](std::string_view asked, int x, std::vector<int>&) {
      if (asked == (cn::dimension_v<M> == 2 ? "adj_e2p" : "adj_f2p") && x == (cn::dimension_v<M> == 2 ? 2 : 1) && ++calls == call) throw std::out_of_range("asked again");
    };
    const auto found = cn::check_laws(m);
    only(found, call == 3 ? "FC3" : "FC4");
    CHECK_FALSE(found.empty());
  }
}

TEST_CASE("check_laws: facets: one buffer for polys at facets and facets of polys breaks no other law") {
  const one_buffer<user_mesh::surface> s(user_mesh::surface_example());
  const one_buffer<user_mesh::volume> w(user_mesh::volume_example());
  static_assert(cn::SurfaceMesh<one_buffer<user_mesh::surface>> && cn::VolumeMesh<one_buffer<user_mesh::volume>>);
  const auto of_surface = cn::check_laws(s), of_volume = cn::check_laws(w);
  CHECK(names(of_surface, "FC3", "p0"));
  CHECK(names(of_volume, "FC3", "p0"));
  for (const auto& b : of_surface) CHECK(b.law.starts_with("FC"));
  for (const auto& b : of_volume) CHECK(b.law.starts_with("FC"));
}

template<int Arity>
struct concino::mesh_traits<shaped<Arity>> : mesh_traits<user_mesh::volume> {
  static constexpr int arity = Arity;
  static std::vector<vert> adj_p2v(const shaped<Arity>& m, poly) {
    std::vector<vert> r;
    for (int i : m.order) r.push_back(vert{i});
    return r;
  }
};

TEST_CASE("check_laws: a wrong order of the verts of tets and hexes is found") {
  const user_mesh::volume one_tet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {2, 3, 0}, {1, 2, 3}},
                             {{{0, true}, {1, true}, {2, false}, {3, true}}});
  user_mesh::volume tet(one_tet);
  tet.facets[2] = {0, 2, 3};  // stored with inward orientation
  static_assert(cn::TetMesh<shaped<4>> && cn::HexMesh<shaped<8>>);
  CHECK(cn::check_laws(shaped<4>{tet, {0, 1, 2, 3}}).empty());
  CHECK(cn::check_laws(shaped<4>{tet, {1, 2, 0, 3}}).empty());
  for (const std::vector<int>& order : {std::vector<int>{0, 1, 3, 2}, {1, 0, 2, 3}, {0, 1, 2}})
    CHECK(names(cn::check_laws(shaped<4>{tet, order}), "VM7", "p0"));

  const user_mesh::volume hex({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                         {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}},
                         {{{0, true}, {1, true}, {2, true}, {3, true}, {4, true}, {5, true}}});
  CHECK(cn::check_laws(shaped<8>{hex, {0, 1, 2, 3, 4, 5, 6, 7}}).empty());
  CHECK(cn::check_laws(shaped<8>{hex, {1, 2, 3, 0, 5, 6, 7, 4}}).empty());
  CHECK(names(cn::check_laws(shaped<8>{hex, {0, 1, 3, 2, 4, 5, 7, 6}}), "VM7", "p0"));
  CHECK(names(cn::check_laws(shaped<8>{hex, {4, 5, 6, 7, 0, 1, 2, 3}}), "VM7", "p0"));
}

namespace {
/// A surface that declares triangles, whatever its polys are.
struct so_called_triangles : user_mesh::surface {};
}  // namespace
template<>
struct concino::mesh_traits<so_called_triangles> : mesh_traits<user_mesh::surface> {
  static constexpr int arity = 3;
};

TEST_CASE("check_laws: a wrong arity of a surface is found") {
  const auto found = cn::check_laws(so_called_triangles{user_mesh::surface_example()});
  CHECK(found.size() == 1);
  CHECK(names(found, "SM6", "p3"));
}

namespace {
/// A mesh that lists the edges of polys and faces in reverse; SaysSo: it declares edges_in_order = false.
template<class M, bool SaysSo = false>
struct backwards : M {
  using M::M;
};
template<class R>
std::vector<cn::edge_id> reversed(const R& edges) {
  std::vector<cn::edge_id> ring;
  for (const cn::edge_id e : edges) ring.insert(ring.begin(), e);
  return ring;
}
}  // namespace
template<class M, bool SaysSo>
struct concino::mesh_traits<backwards<M, SaysSo>> : mesh_traits<M> {
  static constexpr bool edges_in_order = !SaysSo;
  static std::vector<edge_id> adj_p2e(const M& m, poly_id p) { return reversed(mesh_traits<M>::adj_p2e(m, p)); }
  static std::vector<edge_id> adj_f2e(const M& m, face_id f) { return reversed(mesh_traits<M>::adj_f2e(m, f)); }
};

namespace {
/// Tets that list their faces in reverse.
struct faces_backwards : cn::tetmesh {
  using cn::tetmesh::tetmesh;
};
}  // namespace
template<>
struct concino::mesh_traits<faces_backwards> : mesh_traits<tetmesh> {
  static std::vector<face_id> adj_p2f(const tetmesh& m, poly_id p) {
    const auto in_order = mesh_traits<tetmesh>::adj_p2f(m, p);
    return {in_order[3], in_order[2], in_order[1], in_order[0]};
  }
};

TEST_CASE("check_laws: the faces of tets may be listed in any order") {
  CHECK(cn::check_laws(faces_backwards({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}})).empty());
}

TEST_CASE("check_laws: a wrong order of edges is found, unless the type declares another order") {
  const backwards<cn::trimesh> triangle({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const auto of_triangle = cn::check_laws(triangle);
  CHECK(of_triangle.size() == 2);  // the edge in the middle is at its place
  CHECK(names(of_triangle, "SM7", "p0 e0"));
  const backwards<cn::polygonmesh> square({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  CHECK(cn::check_laws(square).size() == 4);
  const backwards<cn::tetmesh> tet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}});
  const auto of_tet = cn::check_laws(tet);
  CHECK(of_tet.size() == 4);  // the largest number of reports per law
  for (const auto& b : of_tet) CHECK(b.law == "VM8");
  const backwards<cn::polyhedralmesh> prism(cn::testing::polyhedra_grid(1));
  const auto of_prism = cn::check_laws(prism);
  CHECK_FALSE(of_prism.empty());
  for (const auto& b : of_prism) CHECK(b.law == "VM8");

  const backwards<cn::polygonmesh, true> sorted_square({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  const backwards<cn::tetmesh, true> sorted_tet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}});
  const backwards<cn::polyhedralmesh, true> sorted_prism(cn::testing::polyhedra_grid(1));
  CHECK(cn::check_laws(sorted_square).empty());
  CHECK(cn::check_laws(sorted_tet).empty());
  CHECK(cn::check_laws(sorted_prism).empty());
  CHECK(cn::check_laws(cn::only_mesh(sorted_square)).empty());
  CHECK(cn::check_laws(cn::only_fixed_arity_mesh(sorted_tet)).empty());
  CHECK(cn::check_laws(cn::only_mesh(sorted_prism)).empty());
  CHECK(cn::check_laws(cn::boundary(sorted_prism)).empty());
}

TEST_CASE_TEMPLATE("check_laws: meshes that throw or return nonsense are reported, at most four times per law", M, surface, volume) {
  M m = example(static_cast<M*>(nullptr));
  for (const char* verb : {"verts", "edges", "faces", "polys", "adj_v2v", "adj_v2e", "adj_v2f", "adj_v2p", "adj_e2v", "adj_e2f", "adj_e2p",
                           "adj_f2v", "adj_f2e", "adj_f2p", "adj_p2v", "adj_p2e", "adj_p2f", "adj_p2p"}) {
    if (cn::dimension_v<M> == 2 && std::string_view(verb).find('f') != std::string_view::npos) continue;
    INFO(std::string(verb));
    m.ring = [&](std::string_view asked, int, std::vector<int>&) { if (asked == verb) throw std::out_of_range("no such element"); };
    CHECK_FALSE(cn::check_laws(m).empty());
    for (const std::vector<int>& nonsense : {std::vector<int>{}, {-1}, {1 << 30}, {0, 0, 0}, {7, 6, 5, 4, 3, 2, 1, 0, 2000, 2001}}) {
      m.ring = [&](std::string_view asked, int, std::vector<int>& ring) { if (asked == verb) ring = nonsense; };
      CHECK_FALSE(cn::check_laws(m).empty());
    }
  }
  m.ring = [](std::string_view, int, std::vector<int>& ring) { ring = {1, 2, 3, 1}; };
  const auto found = cn::check_laws(m);
  for (const auto& b : found) CHECK(std::count_if(found.begin(), found.end(), [&](const auto& o) { return o.law == b.law; }) <= 4);
  m.ring = [](auto, auto, auto&) {};
  for (const std::size_t n : {std::size_t{0}, std::size_t{1}, std::numeric_limits<std::size_t>::max()}) {
    m.number = [&](std::string_view, int, int, std::size_t) { return n; };
    CHECK_FALSE(cn::check_laws(m).empty());
    m.number = [&](std::string_view verb, int, int, std::size_t real) { return verb.starts_with("index_of") ? real : n; };
    CHECK_FALSE(cn::check_laws(m).empty());
    m.number = [&](std::string_view verb, int, int, std::size_t real) { return verb.ends_with("bound") ? n : real; };
    CHECK(cn::check_laws(m).empty() == (n > 1));  // a bound may be too large
  }
  for (const char* verb : {"vert_index_bound", "edge_index_bound", "poly_index_bound", "num_verts", "num_edges", "num_polys"}) {
    m.number = [&](std::string_view asked, int, int, std::size_t real) { return asked == verb ? throw std::out_of_range("no numbers") : real; };
    CHECK_FALSE(cn::check_laws(m).empty());
  }
}

TEST_CASE_TEMPLATE("check_laws: any wrong, missing or additional element in a ring is found", M, surface, volume) {
  M m = example(static_cast<M*>(nullptr));
  // Record all rings that check_laws queries.
  std::vector<std::pair<std::string, int>> asked;
  m.ring = [&](std::string_view verb, int a, std::vector<int>&) { asked.emplace_back(verb, a); };
  cn::check_laws(m);
  std::mt19937 random(3);
  for (int lie = 0; lie < 400; ++lie) {
    const auto& call = asked[random() % asked.size()];
    const std::string verb = call.first;
    const int at = call.second;
    const auto what = random() % 3, where = random() % 8;
    bool lied = false;
    m.ring = [&](std::string_view v, int a, std::vector<int>& ring) {
      if (v != verb || a != at) return;
      if (what == 0 && !ring.empty()) ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(where % ring.size()));
      else if (what == 1 && !ring.empty()) ring[where % ring.size()] = ring[where % ring.size()] == 0 ? 1 : 0;
      else ring.push_back(static_cast<int>(where));
      lied = true;
    };
    INFO(verb << " " << at << " kind " << what << " number " << where);
    const auto found = cn::check_laws(m);
    CHECK(lied);
    CHECK_FALSE(found.empty());
    for (const auto& b : found) CHECK_FALSE(b.what.empty());
  }
}

TEST_CASE("check_laws: every face with the wrong orientation is found") {
  volume m(user_mesh::volume_example());
  for (auto p : cn::polys(m))
    for (auto f : cn::adj_p2f(m, p)) {
      m.number = [=](std::string_view verb, int a, int b, std::size_t n) {
        return verb == "face_is_outward" && a == p.i && b == f.i ? 1 - n : n;
      };
      const auto found = cn::check_laws(m);
      CHECK_FALSE(found.empty());
      only(found, "VM6");
      m.number = [](auto, auto, auto, std::size_t n) { return n; };
    }
}

namespace {
/// Ranges that never end, and that are different each time.
struct endless {
  mutable int calls = 0;
};
struct no_end {};
struct endless_range {
  const endless* m;
  struct iterator {
    const endless* m;
    int i;
    user_mesh::vertex operator*() const { return {i % 5}; }
    iterator& operator++() { ++i; return *this; }
    bool operator!=(no_end) const { return true; }
  };
  iterator begin() const { return {m, m->calls++}; }
  no_end end() const { return {}; }
};
}  // namespace
template<>
struct concino::mesh_traits<endless> {
  using vert = user_mesh::vertex;
  static endless_range verts(const endless& m) { return {&m}; }
  static std::size_t num_verts(const endless&) { return 5; }
  static std::size_t vert_index_bound(const endless&) { return 5; }
  static std::size_t index_of(const endless&, vert v) { return static_cast<std::size_t>(v.i); }
  static endless_range adj_v2v(const endless& m, vert) { return {&m}; }
};
static_assert(cn::PrimalGraph<endless>);

TEST_CASE("check_laws: ranges that never end are read up to a limit and reported") {
  const auto found = cn::check_laws(endless{});
  CHECK(names(found, "PG2", "v0"));
  CHECK(found.size() > 1);
}
