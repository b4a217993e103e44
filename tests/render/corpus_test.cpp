// The triangles of drawables of every mesh of the corpus cover its planar polygons, and none is flipped.
#include <concino/io/load.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/polyhedralmesh.hpp>
#include <concino/render/make_drawable.hpp>

#include <support/corpus_meshes.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

struct counts {
  std::size_t planar = 0, concave = 0;
};

/// Compares the triangles of each planar polygon with its vector area.
void check_triangles(const drawable& d, counts& found) {
  std::vector<double> area(d.polygons().size(), 0.0), lowest(area.size(), 0.0);
  std::vector<vec3> normals(area.size());
  const auto at = [&](std::size_t corner) { return d.points[d.corners[corner]]; };
  for (std::size_t p = 0; p < area.size(); ++p)
    for (std::size_t c = d.offsets[p] + 2; c < d.offsets[p + 1]; ++c)
      normals[p] += cross(at(c - 1) - at(d.offsets[p]), at(c) - at(d.offsets[p])) / 2;
  for (std::size_t t = 0; t < d.triangles.size(); ++t) {
    const auto [a, b, c] = d.triangles[t];
    const std::size_t p = d.polygon_of[t];
    const vec3 along = cross(at(b) - at(a), at(c) - at(a)) / 2;
    area[p] += norm(along);
    lowest[p] = std::min(lowest[p], dot(along, normals[p]) / std::max(dot(normals[p], normals[p]), 1e-300));
  }
  std::size_t wrong = 0, flipped = 0;
  for (std::size_t p = 0; p < area.size(); ++p) {
    const double whole = norm(normals[p]), size = std::sqrt(whole);
    bool is_planar = whole > 0, is_concave = false;
    for (std::size_t c = d.offsets[p], n = d.offsets[p + 1]; c < n; ++c) {
      const vec3 here = at(c), before = at(c == d.offsets[p] ? n - 1 : c - 1), after = at(c + 1 == n ? d.offsets[p] : c + 1);
      is_planar = is_planar && std::abs(dot(here - at(d.offsets[p]), normals[p])) < 1e-9 * size * whole;
      is_concave = is_concave || dot(cross(here - before, after - here), normals[p]) < -1e-9 * whole * whole;
    }
    if (!is_planar) continue;
    ++found.planar;
    found.concave += is_concave;
    wrong += std::abs(area[p] - whole) > 1e-9 * whole;
    flipped += lowest[p] < -1e-9;
  }
  CHECK(wrong == 0);
  CHECK(flipped == 0);
}

}  // namespace

TEST_CASE("corpus: triangles of planar polygons have their area, and none is flipped") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  counts found;
  for (const auto& row : rows) {
    const std::string kind = row.column.at("kind");
    if (kind == "tri" || kind == "tet" || (std::filesystem::file_size(row.file) > 300000 && !long_run())) continue;
    INFO(row.name);
    if (kind == "quad" || kind == "polygon") check_triangles(make_drawable(load<polygonmesh>(row.file.string())), found);
    else check_triangles(make_drawable(load<polyhedralmesh>(row.file.string())), found);
  }
  CHECK(found.planar > 500);
  CHECK(found.concave > 0);
}
