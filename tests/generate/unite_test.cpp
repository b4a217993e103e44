#include <concino/generate/unite.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/mesh/property.hpp>

#include <support/generated.hpp>
#include <support/kinds.hpp>
#include <support/same_mesh.hpp>

#include <limits>
#include <string>

using namespace concino;
using namespace concino::testing;

namespace {

/// A grid moved along x.
template<class M>
M moved(unsigned n, double by) {
  M m = grid<M>(n);
  for (const auto v : verts(m)) set_point(m, v, to_vec3(point(m, v)) + vec3{by, 0, 0});
  return m;
}

/// The same grid, mirrored at x = 1, so that its verts, edges and faces there are those of the first.
template<class M>
M mirrored(unsigned n) {
  auto a = grid_arrays<M>(n);
  for (vec3& x : a.points) x.x = 2 - x.x;
  if constexpr (requires { a.outward; }) {
    for (auto& o : a.outward) o = !o;
  } else if constexpr (arity_v<M> > 0) {
    for (std::size_t i = 0; i < a.verts.size(); i += arity_v<M>) {
      std::swap(a.verts[i + 1], a.verts[i + (arity_v<M> == 3 ? 2 : 3)]);
      if (arity_v<M> == 8) std::swap(a.verts[i + 5], a.verts[i + 7]);
    }
  } else {
    for (std::size_t p = 0; p < a.num_polys(); ++p) std::reverse(a.verts.begin() + a.offsets[p], a.verts.begin() + a.offsets[p + 1]);
  }
  return M(a);
}

template<class M>
std::size_t num_at_x1(const M& m) {
  std::size_t n = 0;
  for (const auto v : verts(m)) n += to_vec3(point(m, v)).x == 1;
  return n;
}

}  // namespace

TEST_CASE_TEMPLATE("unite: two blocks share verts, edges and faces", M, CONCINO_ALL_KINDS) {
  const M a = grid<M>(2), b = mirrored<M>(2);
  const auto u = unite(a, b);
  static_assert(std::is_same_v<std::remove_cvref_t<decltype(u)>, M>);
  CHECK(num_verts(u) == 2 * num_verts(a) - num_at_x1(a));
  check_sound(u, 1);
  CHECK(total_measure(u) == doctest::Approx(2));
  std::size_t shared = 0;
  for (const auto f : facets(u)) shared += num_elements(adj_facet2p(u, f)) == 2;
  std::size_t inner = 0, at_x1 = 0;
  for (const auto f : facets(a)) {
    inner += num_elements(adj_facet2p(a, f)) == 2;
    bool is_there = true;
    for (const auto v : adj_facet2v(a, f)) is_there = is_there && to_vec3(point(a, v)).x == 1;
    at_x1 += is_there;
  }
  CHECK(shared == 2 * inner + at_x1);
  CHECK(num_verts(unite(only_embedded_mesh(a), only_embedded_mesh(b))) == num_verts(u));
  CHECK(record_of(unite(M(), a)) == record_of(a));
  CHECK(record_of(unite(a, M())) == record_of(a));
  const auto apart = unite(a, moved<M>(2, 3));
  CHECK(num_verts(apart) == 2 * num_verts(a));
  CHECK(check_laws(apart).empty());
}

TEST_CASE_TEMPLATE("unite: the tolerance is a distance, and the points of the first mesh remain", M, trimesh, tetmesh) {
  const M a = grid<M>(3);
  M b = mirrored<M>(3);
  for (const auto v : verts(b)) set_point(b, v, to_vec3(point(b, v)) + vec3{3e-4, 4e-4, 0});
  CHECK(num_verts(unite(a, b)) == 2 * num_verts(a));
  CHECK(num_verts(unite(a, b, {.tolerance = 4.9e-4})) == 2 * num_verts(a));
  const M u = unite(a, b, {.tolerance = 5.1e-4});
  CHECK(num_verts(u) == 2 * num_verts(a) - num_at_x1(a));
  for (const auto v : verts(a)) CHECK(point(u, v) == point(a, v));
  for (const double scale : {1e-200, 1e200, 1e307}) {
    M x = a, y = b;
    for (const auto v : verts(x)) set_point(x, v, scale * to_vec3(point(x, v)));
    for (const auto v : verts(y)) set_point(y, v, scale * to_vec3(point(y, v)));
    CHECK(num_verts(unite(x, y, {.tolerance = 5.1e-4 * scale})) == num_verts(u));
    CHECK(num_verts(unite(x, y, {.tolerance = 4.9e-4 * scale})) == 2 * num_verts(a));
  }
}

TEST_CASE("unite: the nearest vert within the tolerance, found as by trying all") {
  std::vector<vec3> p, q;
  unsigned long long state = 1;
  const auto random = [&] { return static_cast<double>((state = state * 6364136223846793005u + 1442695040888963407u) >> 40) / 16777216.0; };
  for (std::size_t i = 0; i < 300; ++i) p.push_back({random(), random(), 0.1 * random()}), q.push_back({random(), random(), 0.1 * random()});
  for (std::size_t i = 0; i < 20; ++i) p.push_back(p[i]), q.push_back(p[2 * i]);
  q.push_back({std::nan(""), 0, 0}), p.push_back({0, std::nan(""), 0}), q.push_back({-0.0, 1e308, -1e308});
  for (const double tolerance : {0.0, 0.01, 0.1, 3.0}) {
    const auto found = concino::detail::coincident_points(p, q, tolerance);
    for (std::size_t i = 0; i < q.size(); ++i) {
      std::uint32_t best = ~0u;
      for (std::uint32_t k = 0; k < p.size(); ++k)
        if (distance(p[k], q[i]) <= tolerance && (best == ~0u || distance(p[k], q[i]) < distance(p[best], q[i]))) best = k;
      CHECK(found[i] == best);
    }
  }
  CHECK(concino::detail::coincident_points({}, q, 1) == std::vector<std::uint32_t>(q.size(), ~0u));
}

TEST_CASE_TEMPLATE("unite: correspondence and properties", M, CONCINO_KINDS) {
  M a = grid<M>(1), b = mirrored<M>(1);
  const auto from = [&](M& m, int base) {
    const auto id = vert_property<int>(m, "id");
    for (const auto v : verts(m)) id[v] = base + static_cast<int>(v.raw());
    const auto name = poly_property<std::string>(m, "name");
    for (const auto p : polys(m)) name[p] = "a rather long name of poly " + std::to_string(base + static_cast<int>(p.raw()));
    const auto mark = edge_property<int>(m, "mark");
    for (const auto e : edges(m)) mark[e] = base + static_cast<int>(e.raw());
  };
  from(a, 100), from(b, 200);
  poly_property<int>(b, "only b");
  for (const auto p : polys(b)) poly_property<int>(b, "only b")[p] = 9;
  *mesh_property<int>(b, "version") = 4;
  correspondence of_a, of_b;
  const M u = unite(a, b, {.from_first = &of_a, .from_second = &of_b});
  const auto id = find_vert_property<int>(u, "id");
  for (const auto v : verts(u)) {
    const std::uint32_t i = of_a.verts.only(v.raw()), k = of_b.verts.only(v.raw());
    CHECK((i != element_origins::none || k != element_origins::none));
    if (i != element_origins::none) CHECK(point(a, vert_id{i}) == point(u, v));
    if (k != element_origins::none) CHECK(point(b, vert_id{k}) == point(u, v));
    CHECK((i != element_origins::none && k != element_origins::none) == (to_vec3(point(u, v)).x == 1));
    CHECK(id[v] == (i != element_origins::none ? 100 + static_cast<int>(i) : 200 + static_cast<int>(k)));
  }
  for (const auto p : polys(u)) {
    const bool is_first = p.raw() < num_polys(a);
    CHECK(find_poly_property<int>(u, "only b")[p] == (is_first ? 0 : 9));
    CHECK(find_poly_property<std::string>(u, "name")[p] ==
          "a rather long name of poly " + std::to_string(is_first ? 100 + p.raw() : 200 + p.raw() - num_polys(a)));
    CHECK((is_first ? of_a : of_b).polys.only(p.raw()) == p.raw() - (is_first ? 0 : num_polys(a)));
  }
  for (const auto e : edges(u)) CHECK(find_edge_property<int>(u, "mark")[e] >= 100);
  if constexpr (dimension_v<M> == 3)
    for (const auto f : faces(u)) CHECK((of_a.faces.only(f.raw()) != element_origins::none || of_b.faces.only(f.raw()) != element_origins::none));
  CHECK(*find_mesh_property<int>(u, "version") == 4);
  CHECK(property_list(unite(a, b, {.properties = false})).empty());
  CHECK(property_list(unite(grid<M>(1), b)).size() == property_list(b).size());
  M c = mirrored<M>(1);
  vert_property<double>(c, "id");
  CHECK_THROWS_WITH_AS(unite(a, c), doctest::Contains("the property \"id\" holds values of type "), invalid_argument);
}

TEST_CASE("unite: meshes of different kinds") {
  const auto s = unite(grid<trimesh>(2), mirrored<quadmesh>(2));
  static_assert(std::is_same_v<std::remove_cvref_t<decltype(s)>, polygonmesh>);
  check_sound(s, 1);
  const auto v = unite(grid<hexmesh>(1), moved<tetmesh>(1, 1));
  static_assert(std::is_same_v<std::remove_cvref_t<decltype(v)>, polyhedralmesh>);
  CHECK(check_laws(v).empty());
  CHECK(num_verts(v) == 12);
  CHECK(total_measure(v) == doctest::Approx(2));
}

TEST_CASE("unite: errors name what is wrong") {
  const trimesh a = grid<trimesh>(2);
  CHECK_THROWS_WITH_AS(unite(a, a, {.tolerance = -1}), "unite: tolerance is -1; it must be finite and 0 or more", invalid_argument);
  CHECK_THROWS_WITH_AS(unite(a, a, {.tolerance = std::nan("")}), doctest::Contains("unite: tolerance is "), invalid_argument);
  CHECK_THROWS_WITH_AS(unite(a, a, {.tolerance = std::numeric_limits<double>::infinity()}), doctest::Contains("unite: tolerance is "), invalid_argument);
  const trimesh b(std::vector<vec3>{{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}}, std::vector<std::vector<unsigned>>{{0, 1, 2}});
  CHECK_THROWS_WITH_AS(unite(a, b, {.tolerance = 0.02}), "unite: two verts of poly 0 of the second mesh, among them vert 1, would become one vert of the first; choose a smaller tolerance",
                       invalid_argument);
  CHECK(num_polys(unite(a, a)) == 2 * num_polys(a));  // polys of both are there twice
}
