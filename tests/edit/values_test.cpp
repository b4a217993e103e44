// Named properties follow the topological operators, by their rules.
#include <concino/edit.hpp>
#include <concino/mesh.hpp>

#include <support/simplex_edits.hpp>

#include <doctest/doctest.h>

#include <set>
#include <string>

namespace cn = concino;
using cn::testing::edge_between_verts;
using cn::testing::whole;

namespace {

cn::trimesh square() { return cn::trimesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}); }

template<class M, class T>
T sum_over(const M& m, const cn::property_map<cn::poly_t<M>, T>& u) {
  T sum{};
  for (const auto p : cn::polys(m)) sum += u[p];
  return sum;
}

}  // namespace

TEST_CASE("values: edge_split interpolates at the new vert, copies labels and distributes sums") {
  cn::trimesh m = square();
  const auto u = cn::vert_property<double>(m, "u");
  const auto name = cn::vert_property<std::string>(m, "name");
  for (const auto v : cn::verts(m)) u[v] = 10.0 * v.raw(), name[v] = std::to_string(v.raw());
  const auto label = cn::poly_property<int>(m, "label");
  const auto mass = cn::poly_property<double>(m, "mass");
  cn::set_property_rule(m, cn::element_kind::poly, "mass", cn::property_rule::sum);
  cn::set_property_rule(m, cn::element_kind::poly, "label", cn::property_rule::copy);
  for (const auto p : cn::polys(m)) label[p] = 7 + static_cast<int>(p.raw()), mass[p] = 1 + p.raw();
  const auto sharp = cn::edge_property<int>(m, "sharp");
  sharp[edge_between_verts(m, 0, 2)] = 5;
  sharp[edge_between_verts(m, 0, 1)] = 4;
  const auto length = cn::edge_property<double>(m, "length");
  cn::set_property_rule(m, cn::element_kind::edge, "length", cn::property_rule::sum);
  length[edge_between_verts(m, 0, 2)] = 8;

  const auto made = cn::edge_split(m, edge_between_verts(m, 0, 2), 0.25);
  REQUIRE(made);
  CHECK(u[made.vert] == doctest::Approx(5));
  CHECK(name[made.vert] == "0");
  CHECK(name[cn::vert_id{2}] == "2");
  for (const auto p : cn::polys(m)) CHECK(label[p] == (p.raw() % 2 == 0 ? 7 : 8));
  CHECK(mass[cn::poly_id{0}] == doctest::Approx(0.25));
  CHECK(mass[cn::poly_id{2}] == doctest::Approx(0.75));
  CHECK(sum_over(m, mass) == doctest::Approx(3));
  CHECK(sharp[edge_between_verts(m, 0, 4)] == 5);
  CHECK(sharp[edge_between_verts(m, 2, 4)] == 5);
  CHECK(sharp[edge_between_verts(m, 1, 4)] == 0);
  CHECK(sharp[edge_between_verts(m, 0, 1)] == 4);
  CHECK(length[edge_between_verts(m, 0, 4)] == doctest::Approx(2));
  CHECK(length[edge_between_verts(m, 2, 4)] == doctest::Approx(6));
}

TEST_CASE("values: edge_collapse merges the ends") {
  cn::trimesh m = cn::testing::grid<cn::trimesh>(4);
  const auto u = cn::vert_property<double>(m, "u");
  const auto name = cn::vert_property<std::string>(m, "name");
  for (const auto v : cn::verts(m)) u[v] = v.raw(), name[v] = std::to_string(v.raw());
  const auto mass = cn::poly_property<double>(m, "mass");
  cn::set_property_rule(m, cn::element_kind::poly, "mass", cn::property_rule::sum);
  for (const auto p : cn::polys(m)) mass[p] = 1;
  const auto tag = cn::edge_property<int>(m, "tag");
  for (const auto e : cn::edges(m)) tag[e] = 1;
  cn::edge_id inner;
  for (const auto e : cn::edges(m))
    if (const auto ends = cn::end_verts(m, e); cn::num_elements(cn::adj_v2v(m, ends.first)) == 6 && cn::num_elements(cn::adj_v2v(m, ends.second)) == 6) inner = e;
  const auto ends = cn::end_verts(m, inner);
  const double total = sum_over(m, mass);
  const auto made = cn::edge_collapse(m, inner, {.at = 0.75});
  REQUIRE(made);
  CHECK(u[made.vert] == doctest::Approx(0.25 * ends.first.raw() + 0.75 * ends.second.raw()));
  CHECK(name[made.vert] == std::to_string(ends.second.raw()));
  CHECK(sum_over(m, mass) == doctest::Approx(total));
  for (const auto e : cn::edges(m)) CHECK(tag[e] >= 1);  // every edge was one before, or two
}

TEST_CASE("values: edge_flip mixes by area, and the new edge has none") {
  cn::trimesh m = square();
  const auto u = cn::poly_property<double>(m, "u");
  u[cn::poly_id{0}] = 1, u[cn::poly_id{1}] = 3;
  const auto mass = cn::poly_property<double>(m, "mass");
  cn::set_property_rule(m, cn::element_kind::poly, "mass", cn::property_rule::sum);
  mass[cn::poly_id{0}] = 1, mass[cn::poly_id{1}] = 3;
  const auto tag = cn::edge_property<int>(m, "tag");
  for (const auto e : cn::edges(m)) tag[e] = 9;
  const auto made = cn::edge_flip(m, edge_between_verts(m, 0, 2));
  REQUIRE(made);
  for (const auto p : cn::polys(m)) CHECK(u[p] == doctest::Approx(2));
  CHECK(sum_over(m, mass) == doctest::Approx(4));
  for (const auto e : cn::edges(m)) CHECK(tag[e] == (e == made.edge ? 0 : 9));
}

TEST_CASE("values: corners keep those of the poly from which they come") {
  cn::trimesh m = square();
  const auto uv = cn::corner_property<double>(m, "uv");
  for (const auto p : cn::polys(m)) {
    unsigned k = 0;
    for (double& x : uv.of(p)) x = 100.0 * p.raw() + 10 * k++;
  }
  const auto made = cn::edge_split(m, edge_between_verts(m, 0, 2), 0.5);
  REQUIRE(made);
  // poly 0 was (0, 1, 2) with 0, 10, 20, and is (0, 1, v); poly 2 is (v, 1, 2)
  CHECK(std::vector<double>(uv.of(cn::poly_id{0}).begin(), uv.of(cn::poly_id{0}).end()) == std::vector<double>{0, 10, 10});
  CHECK(std::vector<double>(uv.of(cn::poly_id{2}).begin(), uv.of(cn::poly_id{2}).end()) == std::vector<double>{10, 10, 20});
}

TEST_CASE("values: faces of tets, and what poly_split and face_split make") {
  cn::tetmesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}, {{0, 1, 2, 3}, {1, 2, 3, 4}});
  const auto label = cn::face_property<int>(m, "label");
  for (const auto f : cn::faces(m)) label[f] = 10 + static_cast<int>(f.raw());
  const auto u = cn::vert_property<double>(m, "u");
  for (const auto v : cn::verts(m)) u[v] = v.raw();
  const auto mass = cn::poly_property<double>(m, "mass");
  cn::set_property_rule(m, cn::element_kind::poly, "mass", cn::property_rule::sum);
  for (const auto p : cn::polys(m)) mass[p] = 6;
  const auto face_with = [&](std::set<unsigned> v) {
    for (const auto f : cn::faces(m))
      if (cn::testing::raw_set(cn::adj_f2v(m, f)) == v) return f;
    return cn::face_id{};
  };
  const int outer = label[face_with({0, 1, 2})], inner = label[face_with({1, 2, 3})];
  REQUIRE(cn::edge_split(m, edge_between_verts(m, 1, 2)));
  CHECK(label[face_with({0, 1, 5})] == outer);
  CHECK(label[face_with({0, 2, 5})] == outer);
  CHECK(label[face_with({1, 3, 5})] == inner);
  CHECK(label[face_with({0, 3, 5})] == 0);  // inside the old tet
  CHECK(u[cn::vert_id{5}] == doctest::Approx(1.5));
  CHECK(sum_over(m, mass) == doctest::Approx(12));
  const int half = label[face_with({1, 3, 5})];
  cn::vec3 middle;
  for (const auto v : cn::adj_f2v(m, face_with({1, 3, 5}))) middle += cn::to_vec3(cn::point(m, v)) / 3;
  const auto made = cn::face_split(m, face_with({1, 3, 5}), middle);
  REQUIRE(made);
  CHECK(label[face_with({1, 3, made.vert.raw()})] == half);
  CHECK(u[made.vert] == doctest::Approx((1 + 3 + 1.5) / 3));
  const auto inside = cn::poly_split(m, cn::poly_id{0});
  REQUIRE(inside);
  double mean = 0;
  for (const auto v : cn::adj_v2v(m, inside.vert)) mean += u[v] / 4;
  CHECK(u[inside.vert] == doctest::Approx(mean));
  CHECK(sum_over(m, mass) == doctest::Approx(12));
}

TEST_CASE_TEMPLATE("values: a transaction that is not committed restores them", M, cn::trimesh, cn::tetmesh) {
  M m = cn::testing::grid<M>(3);
  const auto u = cn::vert_property<double>(m, "a");
  const auto d = cn::poly_property<int>(m, "d");
  const auto mass = cn::poly_property<double>(m, "mass");
  cn::set_property_rule(m, cn::element_kind::poly, "mass", cn::property_rule::sum);
  const auto tag = cn::edge_property<int>(m, "tag");
  for (const auto v : cn::verts(m)) u[v] = v.raw();
  for (const auto p : cn::polys(m)) d[p] = static_cast<int>(p.raw()), mass[p] = 1;
  for (const auto e : cn::edges(m)) tag[e] = static_cast<int>(e.raw());
  const auto values = [&] {
    std::vector<double> all = whole(m);
    for (const auto p : cn::polys(m)) all.push_back(mass[p]);
    for (const auto e : cn::edges(m)) all.push_back(tag[e]);
    return all;
  };
  const auto before = values();
  cn::committed_edits<M> edits;
  for (const bool commit : {false, true}) {
    cn::transaction t(m);
    for (unsigned i = 0; i < 30; ++i) {
      const cn::edge_id e{(17 * i) % static_cast<unsigned>(cn::edge_index_bound(m))};
      if (!cn::contains(m, e)) continue;
      if (i % 2) cn::edge_split(m, e, 0.4);
      else cn::edge_collapse(m, e, {.at = 0.5});
    }
    if (commit) edits = t.commit();
    else t.roll_back();
    CHECK((values() == before) == !commit);
  }
  const auto after = values();
  edits.undo();
  CHECK(values() == before);
  edits.redo();
  CHECK(values() == after);
}
