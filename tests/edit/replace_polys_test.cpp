#include <concino/edit/replace_polys.hpp>

#include <concino/edit/transaction.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/corner_property.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/property.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// Cuts a unit square into two halves, which are made of it, with new verts on two of its edges.
struct halves {
  std::vector<poly_id> old{poly_id(0)};
  std::vector<vert_id> verts{vert_id(0), vert_id(1), vert_id(2), vert_id(3)};
  std::vector<vec3> points{{0.25, 0, 0}, {0.25, 1, 0}};
  std::vector<unsigned> corners{0, 4, 5, 3, 4, 1, 2, 5}, ends{4, 8};
  std::vector<vert_id> new_verts{2};
  std::vector<poly_id> new_polys{2};
  correspondence from;

  halves() {
    new_verts.resize(2), new_polys.resize(2);
    from.verts.add({origin{0, 0.75}, origin{1, 0.25}});
    from.verts.add({origin{3, 0.75}, origin{2, 0.25}});
    from.polys.add(0u);
    from.polys.add(0u);
  }
  template<class T>
  static id_span<T> span(const std::vector<T>& x) { return {x.data(), x.data() + x.size()}; }
  cavity<polygonmesh> lists() const { return {span(old), span(verts), span(points), span(corners), span(ends), {}, 1, 0}; }
  void apply(polygonmesh& m) {
    replace_polys(m, lists(), cavity_result<polygonmesh>{new_verts.data(), new_polys.data()}, from, {}, [] {});
  }
};

polygonmesh square() { return polygonmesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}); }

}  // namespace

TEST_CASE("replace_polys: values of verts are interpolated, those of polys and parts of edges copied, others are default ones") {
  polygonmesh m = square();
  const auto x = vert_property<double>(m, "x");
  const auto label = poly_property<int>(m, "label");
  const auto edge_label = edge_property<int>(m, "edge label");
  const auto corner_x = corner_property<double>(m, "corner x");
  label[poly_id(0)] = 5;
  for (const auto v : verts(m)) x[v] = point(m, v).x;
  for (const auto e : edges(m)) edge_label[e] = static_cast<int>(e.raw()) + 1;
  for (std::uint32_t k = 0; k < 4; ++k) corner_x[corner<polygonmesh>{poly_id(0), k}] = k == 1 || k == 2 ? 1 : 0;
  halves h;
  CHECK(can_replace_polys(m, h.lists()));
  h.apply(m);
  CHECK(check_laws(m).empty());
  CHECK(num_polys(m) == 2);
  CHECK(h.new_polys[0] == poly_id(0));
  for (const auto v : verts(m)) CHECK(x[v] == doctest::Approx(point(m, v).x));
  for (const auto p : polys(m)) {
    CHECK(label[p] == 5);
    std::uint32_t k = 0;
    for (const auto v : adj_p2v(m, p)) CHECK(corner_x[corner<polygonmesh>{p, k++}] == doctest::Approx(point(m, v).x));
  }
  std::vector<int> labels;
  for (const auto e : edges(m)) labels.push_back(edge_label[e]);
  std::sort(labels.begin(), labels.end());
  CHECK(labels.front() == 0);  // the new edge between the halves
  CHECK(std::count(labels.begin(), labels.end(), 0) == 1);
  CHECK(labels.size() == 7);
}

TEST_CASE("replace_polys: in a transaction it is undone") {
  polygonmesh m = square();
  const auto a = vert_property<double>(m, "a");
  const auto d = poly_property<int>(m, "d");
  for (const auto v : verts(m)) a[v] = v.raw() + 0.5;
  d[poly_id(0)] = 3;
  const auto before = whole(m);
  {
    transaction t(m);
    halves h;
    h.apply(m);
    CHECK(num_polys(m) == 2);
    CHECK(d[h.new_polys[1]] == 3);
  }
  CHECK(whole(m) == before);
}

TEST_CASE("replace_polys: without properties it is rewire") {
  polygonmesh m = square();
  halves h;
  h.apply(m);
  CHECK(num_edges(m) == 7);
  CHECK(total_measure(m) == doctest::Approx(1));
}
