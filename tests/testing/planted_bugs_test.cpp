// The conformance kit finds each planted bug under the right law. All are common bugs of adapters.
#include <concino/convert/convert.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/mesh/property.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/testing/conformance.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace cn = concino;

namespace {

enum class bug {
  none,
  counts_deleted_polys,
  index_at_the_bound,
  bound_too_small,
  two_verts_of_one_index,
  one_sided_neighbour,
  own_neighbour,
  poly_its_own_neighbour,
  stale_polys_across,
  corners_not_in_cyclic_order,
  edge_with_one_end,
  edge_forgets_a_poly,
  polys_across_verts_too,
  point_not_a_number,
  one_buffer_for_all_ranges,
  iterators_share_their_place,
  writes_while_read,
  set_point_moves_the_next,
  points_drift,
  edge_of_no_poly,
  swaps_with_the_last,
  add_poly_loses_a_corner,
  deleted_still_contained,
  // bugs of rewire
  rewire_swaps_coordinates,
  rewire_forgets_points,
  rewire_moves_another_vert,
  rewire_swaps_corners,
  rewire_forgets_a_poly,
  rewire_keeps_removed_verts,
  rewire_keeps_no_descriptor,
  rewire_changes_values,
  rewire_checks_nothing,
  rewire_is_half_done,
  // bugs of operators
  split_forgets_its_point,
  flip_says_that_it_did_nothing,
  collapse_keeps_the_point,
  // bugs of volumes
  face_turned,
  cells_in_another_order,
  face_of_one_poly_too_few,
  face_lists_no_cycle,
  polys_turned_inside_out,
  poly_turned_inside_out,
};

/// A native mesh with a planted bug. Every ring is a vector of its own, unless the bug is that they are not.
template<class Inner>
struct planted {
  Inner inner;
  bug mistake = bug::none;
  std::thread::id maker = std::this_thread::get_id();
  mutable std::vector<cn::vert_id> buffer;
  mutable int asked = 0;
  std::vector<std::vector<cn::poly_id>> across_as_made;

  void keep_in_buffer(const std::vector<cn::vert_id>& ring) const {
    buffer.reserve(1000);  // so that old ranges refer to valid memory, with other values
    buffer.assign(ring.begin(), ring.end());
  }
};

template<class R>
auto copied(const R& range) {
  std::vector<std::remove_cvref_t<decltype(*range.begin())>> all;
  for (const auto x : range) all.push_back(x);
  return all;
}

/// A range whose iterators are independent, unless the bug is that they share their position.
struct places {
  std::vector<cn::poly_id> values;
  bool shared = false;
  mutable std::size_t common = 0;
  struct iterator {
    const places* range = nullptr;
    std::size_t own = 0;
    bool end = false;
    std::size_t at() const { return end ? range->values.size() : range->shared ? range->common : own; }
    cn::poly_id operator*() const { return range->values[at()]; }
    iterator& operator++() {
      ++(range->shared ? range->common : own);
      return *this;
    }
    bool operator==(const iterator& o) const { return at() == o.at(); }
  };
  iterator begin() const {
    common = 0;
    return {this, 0, false};
  }
  iterator end() const { return {this, 0, true}; }
};

template<class Inner>
struct planted_traits {
  using M = planted<Inner>;
  using T = cn::mesh_traits<Inner>;
  using vert = cn::vert_id;
  using edge = cn::edge_id;
  using poly = cn::poly_id;
  static constexpr int dimension = T::dimension;

  // An additional edge between the isolated vert and the first one.
  static edge loose(const M& m) { return edge{T::edge_index_bound(m.inner)}; }
  static bool is_loose(const M& m, edge e) { return m.mistake == bug::edge_of_no_poly && e == loose(m); }

  static auto verts(const M& m) { return T::verts(m.inner); }
  static auto edges(const M& m) {
    auto all = copied(T::edges(m.inner));
    if (m.mistake == bug::edge_of_no_poly) all.push_back(loose(m));
    return all;
  }
  static auto polys(const M& m) { return T::polys(m.inner); }
  static std::size_t num_verts(const M& m) { return T::num_verts(m.inner); }
  static std::size_t num_edges(const M& m) { return T::num_edges(m.inner) + (m.mistake == bug::edge_of_no_poly); }
  static std::size_t num_polys(const M& m) { return m.mistake == bug::counts_deleted_polys ? T::poly_index_bound(m.inner) : T::num_polys(m.inner); }
  static std::size_t vert_index_bound(const M& m) { return T::vert_index_bound(m.inner) - (m.mistake == bug::bound_too_small); }
  static std::size_t edge_index_bound(const M& m) { return T::edge_index_bound(m.inner) + (m.mistake == bug::edge_of_no_poly); }
  static std::size_t poly_index_bound(const M& m) { return T::poly_index_bound(m.inner); }
  static std::size_t index_of(const M& m, vert v) {
    if (m.mistake == bug::two_verts_of_one_index && v.raw() == 5) return 4;
    return v.raw() + (m.mistake == bug::index_at_the_bound);
  }
  static std::size_t index_of(const M&, edge e) { return e.raw(); }
  static std::size_t index_of(const M&, poly p) { return p.raw(); }
  static bool contains(const M& m, vert v) { return T::contains(m.inner, v); }
  static bool contains(const M& m, edge e) { return T::contains(m.inner, e) || is_loose(m, e); }
  static bool contains(const M& m, poly p) { return m.mistake == bug::deleted_still_contained ? p.raw() < poly_index_bound(m) : T::contains(m.inner, p); }

  static auto adj_v2v(const M& m, vert v) {
    auto ring = copied(T::adj_v2v(m.inner, v));
    if (m.mistake == bug::one_sided_neighbour && v.raw() == 3) ring.pop_back();
    if (m.mistake == bug::edge_of_no_poly && (v.raw() == 0 || v.raw() == 16)) ring.push_back(vert{16 - v.raw()});
    if (m.mistake == bug::own_neighbour && v.raw() == 3) ring.push_back(v);
    if (m.mistake == bug::writes_while_read && std::this_thread::get_id() != m.maker && ring.size() > 1) std::swap(ring.front(), ring.back());
    return ring;
  }
  static auto adj_v2e(const M& m, vert v) {
    auto ring = copied(T::adj_v2e(m.inner, v));
    if (m.mistake == bug::edge_of_no_poly && (v.raw() == 0 || v.raw() == 16)) ring.push_back(loose(m));
    return ring;
  }
  static auto adj_v2p(const M& m, vert v) { return copied(T::adj_v2p(m.inner, v)); }
  static auto adj_e2v(const M& m, edge e) {
    if (is_loose(m, e)) return std::vector<vert>{vert{0}, vert{16}};
    auto ring = copied(T::adj_e2v(m.inner, e));
    if (m.mistake == bug::edge_with_one_end && e.raw() == 2) ring[1] = ring[0];
    return ring;
  }
  static auto adj_e2p(const M& m, edge e) {
    if (is_loose(m, e)) return std::vector<poly>();
    auto ring = copied(T::adj_e2p(m.inner, e));
    if (m.mistake == bug::edge_forgets_a_poly && ring.size() == 2) ring.pop_back();
    return ring;
  }
  static cn::id_span<vert> adj_p2v(const M& m, poly p) {
    if (m.mistake == bug::one_buffer_for_all_ranges) {
      m.keep_in_buffer(copied(T::adj_p2v(m.inner, p)));
      return {m.buffer.data(), m.buffer.data() + m.buffer.size()};
    }
    if (p.raw() == 0 && (m.mistake == bug::corners_not_in_cyclic_order || m.mistake == bug::cells_in_another_order)) {
      m.keep_in_buffer(copied(T::adj_p2v(m.inner, p)));
      std::swap(m.buffer[1], m.buffer[2]);
      return {m.buffer.data(), m.buffer.data() + m.buffer.size()};
    }
    return T::adj_p2v(m.inner, p);
  }
  static auto adj_p2e(const M& m, poly p) { return copied(T::adj_p2e(m.inner, p)); }
  static places adj_p2p(const M& m, poly p) {
    std::vector<poly> ring = copied(T::adj_p2p(m.inner, p));
    if (m.mistake == bug::poly_its_own_neighbour && p.raw() == 1) ring.push_back(p);
    if (m.mistake == bug::stale_polys_across && p.raw() < m.across_as_made.size()) ring = m.across_as_made[p.raw()];
    if (m.mistake == bug::polys_across_verts_too)
      for (const vert v : T::adj_p2v(m.inner, p))
        for (const poly q : T::adj_v2p(m.inner, v))
          if (q != p && std::find(ring.begin(), ring.end(), q) == ring.end()) ring.push_back(q);
    return {std::move(ring), m.mistake == bug::iterators_share_their_place};
  }
  static auto point(const M& m, vert v) {
    cn::vec3 x = T::point(m.inner, v);
    if (m.mistake == bug::point_not_a_number && v.raw() == 6) x.y = std::numeric_limits<double>::quiet_NaN();
    if (m.mistake == bug::points_drift) x.x *= 1 + 1e-4 * ++m.asked;
    return x;
  }
  template<class X>
  static void set_point(M& m, vert v, const X& x) {
    const vert to{m.mistake == bug::set_point_moves_the_next ? (v.raw() + 1) % T::vert_index_bound(m.inner) : v.raw()};
    T::set_point(m.inner, to, x);
  }

  static const cn::property_set& properties(const M& m) { return T::properties(m.inner); }
  static cn::property_set& properties(M& m) { return T::properties(m.inner); }
  static void rewire(M& m, const cn::cavity_of<vert, poly>& cavity, const cn::cavity_result_of<vert, poly>& made) {
    cn::cavity_of<vert, poly> c = cavity;
    std::vector<cn::vec3> points = copied(c.points);
    for (cn::vec3& x : points) {
      if (m.mistake == bug::rewire_swaps_coordinates) std::swap(x.x, x.y);
      if (m.mistake == bug::rewire_forgets_points) x = {};
    }
    c.points = {points.data(), points.data() + points.size()};
    std::vector<unsigned> corners = copied(c.corners);
    if (m.mistake == bug::rewire_swaps_corners) std::swap(corners[0], corners[1]);
    if (m.mistake == bug::rewire_checks_nothing && corners[0] == corners[1]) corners[1] = 2;  // the number that is missing
    c.corners = {corners.data(), corners.data() + corners.size()};
    if (m.mistake == bug::rewire_keeps_removed_verts) c.removed = 0;
    if (m.mistake == bug::rewire_keeps_no_descriptor) c.kept = 0;
    if (m.mistake == bug::rewire_is_half_done) T::set_point(m.inner, *c.verts.begin(), cn::vec3{7, 8, 9});
    T::rewire(m.inner, c, made);
    if (m.mistake == bug::rewire_forgets_a_poly) T::remove_poly(m.inner, *T::polys(m.inner).begin());
    if (m.mistake == bug::rewire_moves_another_vert) T::set_point(m.inner, vert{0}, cn::vec3{7, 8, 9});
    if (m.mistake == bug::rewire_changes_values)
      for (const auto& x : cn::property_list(m.inner)) cn::vert_property<double>(m.inner, x.name)[vert{0}] = 99;
  }

  static std::optional<vert> split_edge(M& m, edge e, const cn::vec3& x)
    requires requires { T::split_edge(m.inner, e, x); }
  {
    return T::split_edge(m.inner, e, m.mistake == bug::split_forgets_its_point ? cn::vec3{} : x);
  }
  static bool flip_edge(M& m, edge e)
    requires requires { T::flip_edge(m.inner, e); }
  {
    return T::flip_edge(m.inner, e) && m.mistake != bug::flip_says_that_it_did_nothing;
  }
  static bool collapse_edge(M& m, edge e, const cn::vec3& x)
    requires requires { T::collapse_edge(m.inner, e, x); }
  {
    return T::collapse_edge(m.inner, e, m.mistake == bug::collapse_keeps_the_point ? T::point(m.inner, *T::adj_e2v(m.inner, e).begin()) : x);
  }

  static vert add_vert(M& m, const cn::vec3& x) { return T::add_vert(m.inner, x); }
  static poly add_poly(M& m, std::span<const vert> corners) {
    return T::add_poly(m.inner, m.mistake == bug::add_poly_loses_a_corner ? std::vector<vert>{corners[0], corners[1], *T::verts(m.inner).begin()} : copied(corners));
  }
  static void remove_poly(M& m, poly p) {
    if (m.mistake == bug::swaps_with_the_last) {
      poly last = p;
      for (const poly q : T::polys(m.inner)) last = q;
      p = last;
    }
    T::remove_poly(m.inner, p);
  }
};

}  // namespace

template<>
struct concino::mesh_traits<planted<cn::polygonmesh>> : planted_traits<cn::polygonmesh> {};
template<>
struct concino::mesh_traits<planted<cn::trimesh>> : planted_traits<cn::trimesh> {
  static constexpr int arity = 3;
};

/// The same with a type that declares triangles.
struct promised : planted<cn::polygonmesh> {};
template<>
struct concino::mesh_traits<promised> : planted_traits<cn::polygonmesh> {
  static constexpr int arity = 3;
};

namespace {

template<class Inner>
struct planted_volume_traits : planted_traits<Inner> {
  using base = planted_traits<Inner>;
  using typename base::M;
  using typename base::T;
  using typename base::vert;
  using typename base::edge;
  using typename base::poly;
  using face = cn::face_id;
  using base::contains;
  using base::index_of;
  static auto faces(const M& m) { return T::faces(m.inner); }
  static std::size_t num_faces(const M& m) { return T::num_faces(m.inner); }
  static std::size_t face_index_bound(const M& m) { return T::face_index_bound(m.inner); }
  static std::size_t index_of(const M&, face f) { return f.raw(); }
  static auto adj_v2f(const M& m, vert v) { return copied(T::adj_v2f(m.inner, v)); }
  static auto adj_e2f(const M& m, edge e) { return copied(T::adj_e2f(m.inner, e)); }
  static auto adj_f2v(const M& m, face f) {
    auto ring = copied(T::adj_f2v(m.inner, f));
    if (m.mistake == bug::face_lists_no_cycle && f.raw() == 1) ring[2] = ring[0];
    return ring;
  }
  static auto adj_f2e(const M& m, face f) { return copied(T::adj_f2e(m.inner, f)); }
  static auto adj_f2p(const M& m, face f) {
    auto ring = copied(T::adj_f2p(m.inner, f));
    if (m.mistake == bug::face_of_one_poly_too_few && ring.size() == 2) ring.pop_back();
    return ring;
  }
  static auto adj_p2f(const M& m, poly p) { return copied(T::adj_p2f(m.inner, p)); }
  static bool face_is_outward(const M& m, poly p, face f) {
    const bool is_wrong = m.mistake == bug::polys_turned_inside_out || (m.mistake == bug::poly_turned_inside_out && p.raw() == 1) ||
                          (m.mistake == bug::face_turned && p.raw() == 0 && f.raw() == 0);
    return T::face_is_outward(m.inner, p, f) != is_wrong;
  }
};

}  // namespace

template<>
struct concino::mesh_traits<planted<cn::tetmesh>> : planted_volume_traits<cn::tetmesh> {
  static constexpr int arity = 4;
  static poly add_poly(M& m, std::span<const vert> corners) { return T::add_poly(m.inner, corners); }
};
template<>
struct concino::mesh_traits<planted<cn::polyhedralmesh>> : planted_volume_traits<cn::polyhedralmesh> {
  static poly add_poly(M& m, std::span<const vert> corners) = delete;
};

namespace {

template<class M = planted<cn::polygonmesh>>
M surface(bug mistake) {
  M m;
  // three by three squares, the middle one divided into two triangles, and an isolated vert
  std::vector<cn::vec3> points;
  std::vector<std::vector<unsigned>> polys;
  for (unsigned i = 0; i < 16; ++i) points.push_back({double(i % 4), double(i / 4), 0.1 * (i % 3)});
  points.push_back({9, 9, 9});
  for (unsigned y = 0; y < 3; ++y)
    for (unsigned x = 0; x < 3; ++x) {
      const unsigned a = 4 * y + x;
      if (x == 1 && y == 1) polys.insert(polys.end(), {{a, a + 1, a + 5}, {a, a + 5, a + 4}});
      else polys.push_back({a, a + 1, a + 5, a + 4});
    }
  m.inner = cn::polygonmesh(points, polys);
  m.mistake = mistake;
  for (const auto p : cn::polys(m.inner)) m.across_as_made.push_back(copied(cn::adj_p2p(m.inner, p)));
  return m;
}

planted<cn::tetmesh> volume(bug mistake) {
  planted<cn::tetmesh> m;
  m.inner = cn::tetmesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {5, 5, 5}}, {{0, 1, 2, 3}, {1, 4, 2, 3}});
  m.mistake = mistake;
  for (const auto p : cn::polys(m.inner)) m.across_as_made.push_back(copied(cn::adj_p2p(m.inner, p)));
  return m;
}

planted<cn::polyhedralmesh> polyhedra(bug mistake) {
  planted<cn::polyhedralmesh> m;
  m.inner = cn::convert<cn::polyhedralmesh>(volume(bug::none).inner);
  m.mistake = mistake;
  return m;
}

template<class Make>
void found(const Make& make, const char* law) {
  const cn::conformance_report report = cn::conformance(make);
  INFO(report.text());
  REQUIRE_FALSE(report.ok());
  CHECK(report.findings[0].law == law);
  CHECK(report.findings[0].what.size() > 20);
}

}  // namespace

TEST_CASE("conformance: without a planted bug nothing is found") {
  CHECK(cn::conformance([] { return surface(bug::none); }).text() ==
        "models: PrimalGraph DualGraph SurfaceMesh AnyMesh Embedded MutablePoints EditableSurfaceMesh\n"
        "states: as constructed, after all points were moved, after every third poly was removed, after a poly was added, after polys were rewired\n"
        "all laws hold\n");
  const auto report = cn::conformance([] { return volume(bug::none); });
  CHECK_MESSAGE(report.ok(), report.text());
  const auto of_polyhedra = cn::conformance([] { return polyhedra(bug::none); });
  CHECK_MESSAGE(of_polyhedra.ok(), of_polyhedra.text());
}

TEST_CASE("conformance: finds wrong rewiring") {
  const auto found_in_all = [](bug mistake, const char* law) {
    found([mistake] { return surface(mistake); }, law);
    found([mistake] { return volume(mistake); }, law);
    if (mistake != bug::rewire_swaps_corners) found([mistake] { return polyhedra(mistake); }, law);
  };
  found_in_all(bug::rewire_swaps_coordinates, "ED1");
  found_in_all(bug::rewire_forgets_points, "ED1");
  found_in_all(bug::rewire_moves_another_vert, "ED2");
  found_in_all(bug::rewire_swaps_corners, "ED1");
  found_in_all(bug::rewire_forgets_a_poly, "ED1");
  found_in_all(bug::rewire_keeps_removed_verts, "ED1");
  found_in_all(bug::rewire_keeps_no_descriptor, "ED5");
  found_in_all(bug::rewire_changes_values, "ED2");
  found_in_all(bug::rewire_checks_nothing, "ED4");
  found_in_all(bug::rewire_is_half_done, "ED2");
}

TEST_CASE("conformance: finds operators that do not make what rewire makes") {
  const auto sphere = [](bug mistake) {
    return [mistake] {
      planted<cn::trimesh> m;
      m.inner = cn::icosphere(1);
      m.mistake = mistake;
      for (const auto p : cn::polys(m.inner)) m.across_as_made.push_back(copied(cn::adj_p2p(m.inner, p)));
      return m;
    };
  };
  for (const bug mistake : {bug::split_forgets_its_point, bug::flip_says_that_it_did_nothing, bug::collapse_keeps_the_point}) found(sphere(mistake), "ED6");
  const auto report = cn::conformance(sphere(bug::none));
  CHECK_MESSAGE(report.ok(), report.text());
}

TEST_CASE("conformance: finds polyhedra that are turned inside out, unless the data may have some") {
  found([] { return polyhedra(bug::polys_turned_inside_out); }, "KIT7");
  found([] { return polyhedra(bug::poly_turned_inside_out); }, "KIT7");
  const auto report = cn::conformance([] { return polyhedra(bug::poly_turned_inside_out); }, {.turned_polys = true});
  CHECK_MESSAGE(report.ok(), report.text());
}

TEST_CASE("conformance: finds wrong counts and indices") {
  found([] { return surface(bug::counts_deleted_polys); }, "KIT6");
  found([] { return surface(bug::index_at_the_bound); }, "PG1");
  found([] { return surface(bug::bound_too_small); }, "PG1");
  found([] { return surface(bug::two_verts_of_one_index); }, "PG1");
}

TEST_CASE("conformance: finds wrong adjacencies") {
  found([] { return surface(bug::one_sided_neighbour); }, "PG3");
  found([] { return surface(bug::own_neighbour); }, "PG4");
  found([] { return surface(bug::poly_its_own_neighbour); }, "DG4");
  found([] { return surface(bug::stale_polys_across); }, "DG4");
  found([] { return surface(bug::corners_not_in_cyclic_order); }, "SM3");
  found([] { return surface(bug::edge_with_one_end); }, "SM2");
  found([] { return surface(bug::edge_forgets_a_poly); }, "SM4");
  found([] { return surface(bug::polys_across_verts_too); }, "SM5");
  found([] { return surface<promised>(bug::none); }, "SM6");
}

TEST_CASE("conformance: finds wrong points") {
  found([] { return surface(bug::point_not_a_number); }, "EM1");
  found([] { return surface(bug::set_point_moves_the_next); }, "KIT4");
  found([] { return surface(bug::points_drift); }, "KIT3");
}

TEST_CASE("conformance: finds bugs that only algorithms reveal") { found([] { return surface(bug::edge_of_no_poly); }, "KIT5"); }

TEST_CASE("conformance: finds wrong ranges") {
  found([] { return surface(bug::one_buffer_for_all_ranges); }, "KIT2");
  found([] { return surface(bug::iterators_share_their_place); }, "KIT2");
  found([] { return surface(bug::writes_while_read); }, "KIT3");
}

TEST_CASE("conformance: finds wrong editing") {
  found([] { return surface(bug::swaps_with_the_last); }, "KIT6");
  found([] { return surface(bug::add_poly_loses_a_corner); }, "KIT6");
  found([] { return surface(bug::deleted_still_contained); }, "KIT6");
}

TEST_CASE("conformance: finds bugs in volumes") {
  found([] { return volume(bug::face_turned); }, "VM6");
  found([] { return volume(bug::cells_in_another_order); }, "VM7");
  found([] { return volume(bug::face_of_one_poly_too_few); }, "VM3");
  found([] { return volume(bug::face_lists_no_cycle); }, "VM2");
}
