// A correspondence transfers properties and values to a new mesh, by each rule, on each kind of mesh.
#include <concino/mesh/correspondence.hpp>

#include <concino/core/rgba.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/element_map.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <Eigen/Core>

#include <array>
#include <complex>
#include <numeric>
#include <random>
#include <string>

using namespace concino;

namespace {

constexpr std::uint32_t none = element_origins::none;

/// The correspondence that maps every element to the one with the same index.
template<class M>
correspondence identity(const M& m) {
  const auto same = [](std::size_t n) {
    std::vector<std::uint32_t> all(n);
    std::iota(all.begin(), all.end(), 0u);
    return element_origins(std::move(all));
  };
  correspondence c{same(vert_index_bound(m)), same(edge_index_bound(m)), {}, same(poly_index_bound(m))};
  if constexpr (VolumeMesh<M>) c.faces = same(face_index_bound(m));
  return c;
}

template<class M>
property_rule rule_of(const M& m, std::string_view name) {
  for (const property_info& p : property_list(m))
    if (p.name == name) return p.rule;
  FAIL("no such property");
  return {};
}

/// The copy constructor counts `left` down, and throws where it is 0.
struct throwing {
  static inline int left = 1 << 30;
  int value = 0;
  throwing() = default;
  throwing(const throwing& o) : value(o.value) {
    if (left-- == 0) throw 7;
  }
  throwing& operator=(const throwing&) = default;
};

}  // namespace

TEST_CASE_TEMPLATE("correspondence: the rule of a property depends on its type, and can be set", M, CONCINO_KINDS) {
  M m = testing::grid<M>(2);
  vert_property<double>(m, "double");
  vert_property<float>(m, "float");
  vert_property<vec3>(m, "vec3");
  vert_property<rgba>(m, "rgba");
  vert_property<std::array<double, 2>>(m, "texture");
  vert_property<Eigen::Vector2d>(m, "eigen");
  vert_property<std::complex<double>>(m, "complex");
  for (const char* name : {"double", "float", "vec3", "rgba", "texture", "eigen", "complex"}) {
    CHECK(rule_of(m, name) == property_rule::interpolate);
    set_property_rule(m, element_kind::vert, name, property_rule::sum);
    CHECK(rule_of(m, name) == property_rule::sum);
    set_property_rule(m, element_kind::vert, name, property_rule::copy);
    CHECK(rule_of(m, name) == property_rule::copy);
  }
  edge_property<int>(m, "int");
  edge_property<unsigned char>(m, "byte");
  for (const char* name : {"int", "byte"}) {
    CHECK(rule_of(m, name) == property_rule::copy);
    set_property_rule(m, element_kind::edge, name, property_rule::sum);
    CHECK(rule_of(m, name) == property_rule::sum);
    CHECK_THROWS_AS(set_property_rule(m, element_kind::edge, name, property_rule::interpolate), invalid_argument);
    CHECK(rule_of(m, name) == property_rule::sum);
  }
  poly_property<bool>(m, "bool");
  poly_property<std::string>(m, "string");
  poly_property<std::array<int, 2>>(m, "pair");
  for (const char* name : {"bool", "string", "pair"}) {
    CHECK(rule_of(m, name) == property_rule::copy);
    CHECK_THROWS_AS(set_property_rule(m, element_kind::poly, name, property_rule::interpolate), invalid_argument);
    CHECK_THROWS_AS(set_property_rule(m, element_kind::poly, name, property_rule::sum), invalid_argument);
    set_property_rule(m, element_kind::poly, name, property_rule::copy);
  }
  CHECK_THROWS_WITH_AS(set_property_rule(m, element_kind::poly, "int", property_rule::sum), "set_property_rule: the mesh has no poly property \"int\"", invalid_argument);
  CHECK_THROWS_AS(set_property_rule(m, element_kind::edge, "none", property_rule::sum), invalid_argument);
  const M copy = m;
  CHECK(rule_of(copy, "int") == property_rule::sum);
  CHECK(to_string(property_rule::sum) == "sum");
  CHECK(to_string(property_rule::copy) == "copy");
  CHECK(to_string(property_rule::interpolate) == "interpolate");
}

TEST_CASE_TEMPLATE("correspondence: copies are exact for every kind of elements", M, CONCINO_KINDS) {
  M m = testing::grid<M>(2);
  const auto u = vert_property<double>(m, "u");
  const auto w = edge_property<float>(m, "w");
  const auto x = poly_property<vec3>(m, "x");
  set_property_rule(m, element_kind::poly, "x", property_rule::sum);
  std::mt19937 random(5);
  const auto number = [&] { return 1e-3 * static_cast<double>(random()); };
  for (const auto v : verts(m)) u[v] = number();
  for (const auto e : edges(m)) w[e] = static_cast<float>(number());
  for (const auto p : polys(m)) x[p] = {number(), number(), number()};
  if constexpr (VolumeMesh<M>) {
    const auto f = face_property<std::string>(m, "f");
    for (const auto a : faces(m)) f[a] = std::to_string(a.raw());
  }
  *mesh_property<std::string>(m, "title") = "a grid";
  for (const bool edges_follow : {false, true}) {
    M to = testing::grid<M>(2);
    const auto replaced = vert_property<int>(to, "u");  // a property of another type is replaced
    poly_property<int>(to, "kept");
    correspondence c = identity(m);
    if (edges_follow) c.edges = c.faces = {};
    transfer_properties(m, to, c);
    CHECK(property_list(to).size() == property_list(m).size() + 1);
    CHECK(find_poly_property<int>(to, "kept"));
    CHECK(replaced[vert_id{0}] == 0);
    CHECK(rule_of(to, "x") == property_rule::sum);
    for (const auto v : verts(m)) CHECK(find_vert_property<double>(to, "u")[v] == u[v]);
    for (const auto e : edges(m)) CHECK(find_edge_property<float>(to, "w")[e] == w[e]);
    for (const auto p : polys(m)) CHECK(find_poly_property<vec3>(to, "x")[p] == x[p]);
    if constexpr (VolumeMesh<M>)
      for (const auto f : faces(m)) CHECK(find_face_property<std::string>(to, "f")[f] == std::to_string(f.raw()));
    CHECK(*find_mesh_property<std::string>(to, "title") == "a grid");
  }
}

TEST_CASE_TEMPLATE("correspondence: inserted, split, merged and new elements follow each rule", M, CONCINO_KINDS) {
  M m = testing::grid<M>(2);
  const auto u = vert_property<double>(m, "u");
  const auto color = vert_property<rgba>(m, "color");
  const auto name = vert_property<std::string>(m, "name");
  const auto mass = poly_property<double>(m, "mass");
  const auto texture = vert_property<std::array<double, 2>>(m, "texture");
  const auto count = poly_property<int>(m, "count");
  set_property_rule(m, element_kind::poly, "mass", property_rule::sum);
  set_property_rule(m, element_kind::poly, "count", property_rule::sum);
  const vert_id a{0}, b{1}, c{2}, d{3};
  u[a] = 8, u[b] = 16, u[c] = -1;
  color[a] = {1, 0, 0, 1}, color[b] = {0, 1, 0, 0};
  texture[a] = {0, 4}, texture[b] = {8, 0};
  name[a] = "first", name[b] = "second";
  mass[poly_id{0}] = 12, mass[poly_id{1}] = 3;
  count[poly_id{0}] = 5, count[poly_id{1}] = 7;

  M to = testing::grid<M>(2);
  correspondence k;
  k.verts.add({{0, 3}, {1, 1}});  // a is nearer to the first; weights need not sum to 1
  k.verts.add({{0, 2}, {1, 2}});
  k.verts.add(none);
  k.verts.add({{0, 0}, {1, 0}});  // weights of 0: both count equally
  while (k.verts.size() < num_verts(m)) k.verts.add(2);
  k.polys.add({{0, 1}});  // poly 0 is split in the ratio 1 : 3, the larger part is merged with poly 1
  k.polys.add({{0, 3}, {1, 2}});
  while (k.polys.size() < num_polys(m)) k.polys.add(none);
  transfer_properties(m, to, k);

  const auto new_u = find_vert_property<double>(to, "u");
  CHECK(new_u[a] == 10);
  CHECK(new_u[b] == 12);
  CHECK(new_u[c] == 0);
  CHECK(new_u[d] == 12);
  CHECK(new_u[vert_id{4}] == -1);
  CHECK(find_vert_property<rgba>(to, "color")[a] == rgba{0.75f, 0.25f, 0, 0.75f});
  CHECK(find_vert_property<rgba>(to, "color")[c] == rgba{});
  CHECK(find_vert_property<std::array<double, 2>>(to, "texture")[a] == std::array<double, 2>{2, 3});
  const auto new_name = find_vert_property<std::string>(to, "name");
  CHECK(new_name[a] == "first");
  CHECK(new_name[b] == "first");  // of two equal weights the first
  CHECK(new_name[c].empty());
  const auto new_mass = find_poly_property<double>(to, "mass");
  CHECK(new_mass[poly_id{0}] == 3);
  CHECK(new_mass[poly_id{1}] == 12);
  const auto new_count = find_poly_property<int>(to, "count");  // integers are not split: the larger part gets all
  CHECK(new_count[poly_id{0}] == 0);
  CHECK(new_count[poly_id{1}] == 12);

  k.verts = element_origins(std::vector<std::uint32_t>(num_verts(m), 1));
  set_property_rule(m, element_kind::vert, "u", property_rule::copy);
  set_property_rule(m, element_kind::poly, "mass", property_rule::interpolate);
  transfer_properties(m, to, k);
  CHECK(find_vert_property<double>(to, "u")[c] == 16);
  CHECK(find_poly_property<double>(to, "mass")[poly_id{0}] == 12);
  CHECK(find_poly_property<double>(to, "mass")[poly_id{1}] == doctest::Approx((3 * 12 + 2 * 3) / 5.0).epsilon(1e-15));
}

TEST_CASE("correspondence: splitting and merging preserves sums, and means are in range") {
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    const std::size_t before = 1 + random() % 20, after = before + random() % 20;
    element_origins o;
    std::vector<std::vector<origin>> list(after);
    for (std::uint32_t i = 0; i < before; ++i) list[i].push_back({i, 1.0 + static_cast<double>(random() % 5)});  // each old element has a new one
    for (std::size_t n = random() % 60; n > 0; --n) {
      const auto i = static_cast<std::uint32_t>(random() % before);
      auto& at = list[random() % after];
      if (std::none_of(at.begin(), at.end(), [&](const origin& x) { return x.index == i; })) at.push_back({i, static_cast<double>(random() % 4)});
    }
    for (const auto& at : list) o.add(at);
    std::vector<double> mass;
    std::vector<int> count;
    for (std::size_t i = 0; i < before; ++i) mass.push_back(static_cast<double>(random() % 1000) - 300), count.push_back(static_cast<int>(random() % 100) - 30);
    const auto sum = [](const auto& values) { return std::accumulate(values.begin(), values.end(), 0.0); };
    CHECK(sum(transfer_values(o, std::span(mass), property_rule::sum)) == doctest::Approx(sum(mass)).epsilon(1e-12));
    CHECK(sum(transfer_values(o, std::span(count), property_rule::sum)) == sum(count));
    const auto means = transfer_values(o, std::span(mass), property_rule::interpolate);
    const auto copies = transfer_values(o, std::span(mass), property_rule::copy);
    for (std::size_t i = 0; i < after; ++i) {
      if (list[i].empty()) {
        CHECK(means[i] == 0);
        continue;
      }
      double low = 1e9, high = -1e9, largest = -1, expected = 0;
      for (const origin& x : list[i]) {
        low = std::min(low, mass[x.index]), high = std::max(high, mass[x.index]);
        if (x.weight > largest) largest = x.weight, expected = mass[x.index];
      }
      CHECK(means[i] >= low - 1e-9);
      CHECK(means[i] <= high + 1e-9);
      CHECK(copies[i] == expected);
    }
  }
}

TEST_CASE("correspondence: transfers maps, and throws if they do not fit") {
  const auto m = testing::grid<quadmesh>(2);
  auto heat = make_vert_map<double>(m, 2.5);
  const auto c = identity(m);
  const auto taken = transfer_values(c.verts, heat.values(), property_rule::interpolate);
  CHECK(taken == std::vector<double>(num_verts(m), 2.5));
  const std::vector<std::string> words = {"one", "two"};
  CHECK(transfer_values(element_origins({1, 1, none}), std::span(words), property_rule::copy) == std::vector<std::string>{"two", "two", ""});
  CHECK_THROWS_AS(transfer_values(element_origins({1}), std::span(words), property_rule::sum), invalid_argument);
  CHECK_THROWS_AS(transfer_values(element_origins({2}), std::span(words), property_rule::copy), invalid_argument);
  CHECK(transfer_values(element_origins(), std::span(words), property_rule::copy).empty());
}

TEST_CASE_TEMPLATE("correspondence: an error leaves the mesh unchanged", M, CONCINO_KINDS) {
  M m = testing::grid<M>(2), to = testing::grid<M>(2);
  vert_property<double>(m, "u");
  const auto u = vert_property<double>(to, "u");
  u[vert_id{0}] = 4;
  const auto is_unchanged = [&] {
    CHECK(property_list(to).size() == 1);
    CHECK(find_vert_property<double>(to, "u")[vert_id{0}] == 4);
  };
  correspondence few = identity(m), beyond = identity(m);
  few.verts = element_origins(std::vector<std::uint32_t>{0, 1});
  beyond.verts = element_origins(std::vector<std::uint32_t>(num_verts(m), static_cast<std::uint32_t>(num_verts(m))));
  CHECK_THROWS_AS(transfer_properties(m, to, few), invalid_argument);
  CHECK_THROWS_AS(transfer_properties(m, to, beyond), invalid_argument);
  CHECK_THROWS_AS(transfer_properties(m, to, correspondence()), invalid_argument);
  is_unchanged();
  edge_property<int>(m, "e");
  few.edges = beyond.edges = {};
  CHECK_THROWS_AS(match_edges_and_faces(m, to, beyond), invalid_argument);
  CHECK_THROWS_AS(transfer_properties(m, to, few), invalid_argument);
  CHECK_THROWS_AS(match_edges_and_faces(m, to, few), invalid_argument);
  is_unchanged();
  poly_property<throwing>(m, "p");
  throwing::left = 2;
  CHECK_THROWS_AS(transfer_properties(m, to, identity(m)), int);
  throwing::left = 1 << 30;
  is_unchanged();
  transfer_properties(m, to, identity(m));
  CHECK(property_list(to).size() == 3);
}

TEST_CASE("correspondence: is right for a triangle split at the middles of its edges") {
  trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  trimesh four({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0, 0}, {0.5, 0.5, 0}, {0, 0.5, 0}}, {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}});
  const auto length = edge_property<double>(m, "length");
  const auto crease = edge_property<int>(m, "crease");
  set_property_rule(m, element_kind::edge, "length", property_rule::sum);
  for (const auto e : edges(m)) length[e] = 10.0 * (e.raw() + 1), crease[e] = 1 + static_cast<int>(e.raw());
  const auto x = vert_property<vec3>(m, "x");
  for (const auto v : verts(m)) x[v] = to_vec3(point(m, v));
  correspondence c;
  for (const std::uint32_t v : {0u, 1u, 2u}) c.verts.add(v);
  c.verts.add({{0, 1}, {1, 1}}), c.verts.add({{1, 1}, {2, 1}}), c.verts.add({{2, 1}, {0, 1}});
  for (int p = 0; p < 4; ++p) c.polys.add({{0, 0.125}});
  transfer_properties(m, four, c);
  for (const auto v : verts(four)) CHECK(find_vert_property<vec3>(four, "x")[v] == to_vec3(point(four, v)));
  std::size_t halves = 0;
  for (const auto e : edges(four)) {
    const auto ends = end_verts(four, e);
    const bool is_inside = ends.first.raw() > 2 && ends.second.raw() > 2;
    CHECK((find_edge_property<int>(four, "crease")[e] == 0) == is_inside);
    CHECK(find_edge_property<double>(four, "length")[e] == (is_inside ? 0 : 5.0 * find_edge_property<int>(four, "crease")[e]));
    halves += !is_inside;
  }
  CHECK(halves == 6);
}

TEST_CASE("correspondence: is right for a tet split at an edge") {
  tetmesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}});
  tetmesh two({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.25, 0, 0}}, {{0, 4, 2, 3}, {4, 1, 2, 3}});
  const auto load = edge_property<double>(m, "load");
  set_property_rule(m, element_kind::edge, "load", property_rule::sum);
  const auto wall = face_property<int>(m, "wall");
  const auto wind = face_property<double>(m, "wind");
  set_property_rule(m, element_kind::face, "wind", property_rule::sum);
  for (const auto e : edges(m)) load[e] = 8;
  for (const auto f : faces(m)) wall[f] = 1 + static_cast<int>(f.raw()), wind[f] = 2;
  correspondence c;
  for (const std::uint32_t v : {0u, 1u, 2u, 3u}) c.verts.add(v);
  c.verts.add({{0, 0.75}, {1, 0.25}});
  c.polys.add({{0, 0.25}}), c.polys.add({{0, 0.75}});
  transfer_properties(m, two, c);
  const auto has = [&](const auto& list, unsigned v) { return std::find(list.begin(), list.end(), vert_id{v}) != list.end(); };
  double total_load = 0, total_wind = 0;
  for (const auto e : edges(two)) {
    std::vector<vert_id> ends;
    for (const auto v : adj_e2v(two, e)) ends.push_back(v);
    const double found = find_edge_property<double>(two, "load")[e];
    total_load += found;
    CHECK(found == (!has(ends, 4) ? 8 : has(ends, 0) ? 2 : has(ends, 1) ? 6 : 0));
  }
  CHECK(total_load == 48);
  for (const auto f : faces(two)) {
    std::vector<vert_id> ring;
    for (const auto v : adj_f2v(two, f)) ring.push_back(v);
    const bool is_inside = has(ring, 2) && has(ring, 3) && has(ring, 4);
    CHECK((find_face_property<int>(two, "wall")[f] == 0) == is_inside);
    const bool is_half = has(ring, 4) && !is_inside;
    CHECK(find_face_property<double>(two, "wind")[f] == (is_inside ? 0 : is_half ? 1 : 2));
    total_wind += find_face_property<double>(two, "wind")[f];
  }
  CHECK(total_wind == 8);
}
