#include <concino/edit/elements.hpp>
#include <concino/mesh/corner_property.hpp>
#include <concino/mesh/property.hpp>
#include <concino/render/inspected_mesh.hpp>
#include <concino/render/make_drawable.hpp>
#include <concino/render/slicing.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace concino;

namespace {

/// What a drawable with mesh_look::inspect keeps.
template<class M>
inspected_mesh kept_of(const M& m, mesh_look<M> look = {}) {
  look.inspect = true;
  const drawable d = make_drawable(m, look);
  REQUIRE(d.inspected);
  return *d.inspected;
}

const inspected_values* find(const inspected_mesh& m, const std::string& name) {
  for (const inspected_values& v : m.values)
    if (v.name == name) return &v;
  return nullptr;
}

}  // namespace

TEST_CASE_TEMPLATE("inspected_mesh: all elements by their indices", M, CONCINO_ALL_KINDS) {
  const M m = testing::grid<M>(2);
  const inspected_mesh kept = kept_of(m);
  CHECK(kept.is_volume == VolumeMesh<M>);
  REQUIRE(kept.points.size() == vert_index_bound(m));
  for (const auto v : verts(m)) CHECK(kept.points[index_of(m, v)] == to_vec3(point(m, v)));
  REQUIRE(kept.edge_verts.size() == 2 * edge_index_bound(m));
  for (const auto e : edges(m)) {
    const auto [a, b] = end_verts(m, e);
    CHECK(kept.edge_verts[2 * index_of(m, e)] == index_of(m, a));
    CHECK(kept.edge_verts[2 * index_of(m, e) + 1] == index_of(m, b));
  }
  const auto check_polygon = [&](std::size_t i, const auto& ring) {
    std::size_t c = kept.polygon_offsets[i];
    for (const vert_t<M> v : ring) CHECK(kept.polygon_verts[c++] == index_of(m, v));
    CHECK(c == kept.polygon_offsets[i + 1]);
  };
  if constexpr (VolumeMesh<M>) {
    for (const auto f : faces(m)) check_polygon(index_of(m, f), adj_f2v(m, f));
    for (const auto p : polys(m)) {
      std::size_t k = kept.poly_offsets[index_of(m, p)];
      for (const auto f : adj_p2f(m, p)) CHECK(kept.poly_faces[k++] == 2 * index_of(m, f) + !face_is_outward(m, p, f));
      CHECK(k == kept.poly_offsets[index_of(m, p) + 1]);
    }
  } else {
    for (const auto p : polys(m)) check_polygon(index_of(m, p), adj_p2v(m, p));
    CHECK(kept.poly_offsets.empty());
  }
  for (const auto p : polys(m)) CHECK(kept.centroids[index_of(m, p)] == centroid(m, p));

  // The triangles of a polygon have its vector area.
  std::vector<vec3> areas(kept.polygon_offsets.size()), sums(kept.polygon_offsets.size());
  std::vector<std::size_t> polygon_of(kept.polygon_verts.size());
  const auto at = [&](std::size_t c) { return kept.points[kept.polygon_verts[c]]; };
  for (std::size_t p = 0; p + 1 < kept.polygon_offsets.size(); ++p)
    for (std::size_t c = kept.polygon_offsets[p], first = c; c < kept.polygon_offsets[p + 1]; ++c) {
      polygon_of[c] = p;
      if (c >= first + 2) areas[p] += cross(at(c - 1) - at(first), at(c) - at(first));
    }
  for (std::size_t t = 0; t < kept.triangles.size(); t += 3) {
    const std::size_t a = kept.triangles[t], b = kept.triangles[t + 1], c = kept.triangles[t + 2];
    CHECK(polygon_of[a] == polygon_of[c]);
    sums[polygon_of[a]] += cross(at(b) - at(a), at(c) - at(a));
  }
  if (!kept.triangles.empty())
    for (std::size_t p = 0; p < areas.size(); ++p) CHECK(norm(areas[p] - sums[p]) < 1e-12);
}

TEST_CASE_TEMPLATE("inspected_mesh: the field first, then all named properties", M, CONCINO_ALL_KINDS) {
  M m = testing::grid<M>(2);
  auto text = vert_property<std::string>(m, "text");
  auto flow = vert_property<vec3>(m, "flow");
  auto pair = poly_property<std::array<float, 2>>(m, "pair");
  auto flag = edge_property<bool>(m, "flag");
  mesh_property<double>(m, "time");
  poly_property<std::vector<int>>(m, "unknown");
  auto u = make_poly_map<int>(m, 0);
  for (const auto v : verts(m)) text[v] = "vert " + std::to_string(index_of(m, v)), flow[v] = to_vec3(point(m, v));
  for (const auto p : polys(m)) pair[p] = {static_cast<float>(index_of(m, p)), 0.5f}, u[p] = static_cast<int>(index_of(m, p));
  for (const auto e : edges(m)) flag[e] = index_of(m, e) % 2 == 0;

  const inspected_mesh kept = kept_of(m, {.labels = u});
  REQUIRE(kept.values.size() == 6);
  CHECK(kept.has_field);
  CHECK(kept.values[0].name == "labels");
  CHECK(kept.values[0].at == element_kind::poly);
  for (const auto p : polys(m)) CHECK(kept.values[0].numbers[index_of(m, p)] == u[p]);
  for (const auto v : verts(m)) {
    CHECK(find(kept, "text")->texts[index_of(m, v)] == text[v]);
    for (std::size_t k = 0; k < 3; ++k) CHECK(find(kept, "flow")->numbers[3 * index_of(m, v) + k] == flow[v][k]);
  }
  CHECK(find(kept, "pair")->width == 2);
  for (const auto p : polys(m)) CHECK(find(kept, "pair")->numbers[2 * index_of(m, p)] == pair[p][0]);
  for (const auto e : edges(m)) CHECK(find(kept, "flag")->numbers[index_of(m, e)] == flag[e]);
  CHECK(find(kept, "time")->at == element_kind::mesh);
  CHECK(!find(kept, "unknown"));
  CHECK(!kept_of(m).has_field);
}

TEST_CASE_TEMPLATE("inspected_mesh: hidden polys, polygons laid bare, and colours", M, CONCINO_ALL_KINDS) {
  const M m = testing::grid<M>(2);
  const auto visible = visible_polys(m, below('x', 0.5));
  auto colors = make_poly_map<rgb>(m);
  for (const auto p : polys(m)) colors[p] = {static_cast<float>(index_of(m, p)), 0, 0};
  const inspected_mesh kept = kept_of(m, {.colors = colors, .visible = visible});
  CHECK(kept.colors_at == element_kind::poly);
  for (const auto p : polys(m)) {
    CHECK(kept.visible[index_of(m, p)] == visible[p]);
    CHECK(kept.colors[index_of(m, p)] == colors[p]);
  }
  CHECK(kept.exposed.empty());
  CHECK(kept_of(m).visible.empty());
  CHECK(!make_drawable(m).inspected);
}

TEST_CASE_TEMPLATE("inspected_mesh: values, colours and texture coordinates at corners", M, CONCINO_ALL_KINDS) {
  M m = testing::grid<M>(2);
  remove_poly(m, poly_id{1});  // leaves a gap in the numbers of corners
  auto uv = corner_property<std::array<double, 2>>(m, "uv");
  auto text = corner_property<std::string>(m, "text");
  auto colors = make_corner_map<rgb>(m);
  const auto for_each_corner = [&m](const auto& f) {
    for (const auto p : polys(m)) {
      std::uint32_t k = 0;
      for (const auto v : adj_p2v(m, p)) f(corner<M>{p, k++}, v);
    }
  };
  for_each_corner([&](const corner<M>& c, const vert_t<M>& v) {
    uv[c] = {static_cast<double>(index_of(m, c.poly)), static_cast<double>(index_of(m, v))};
    text[c] = std::to_string(c.k);
    colors[c] = {static_cast<float>(c.k), 0, 0};
  });
  const inspected_mesh kept = kept_of(m, {.colors = colors, .texture = texture::checkerboard(2), .texture_coordinates = uv});
  CHECK(kept.colors_at == element_kind::corner);
  REQUIRE(kept.has_texture);
  const inspected_values& points = kept.values.back();
  CHECK(points.at == element_kind::corner);
  CHECK(points.numbers == find(kept, "uv")->numbers);
  const auto& offsets = kept.is_volume ? kept.corner_offsets : kept.polygon_offsets;
  for_each_corner([&](const corner<M>& c, const vert_t<M>& v) {
    const std::size_t at = offsets[index_of(m, c.poly)] + c.k;
    CHECK((kept.is_volume ? kept.corner_verts : kept.polygon_verts)[at] == index_of(m, v));
    CHECK(points.numbers[2 * at] == uv[c][0]);
    CHECK(points.numbers[2 * at + 1] == uv[c][1]);
    CHECK(find(kept, "text")->texts[at] == text[c]);
    CHECK(kept.colors[at] == colors[c]);
  });
  CHECK(kept_of(m).values.size() == 2);
  CHECK(!kept_of(m).has_texture);
}
