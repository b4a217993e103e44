// Defines layer_columns.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/print/detail/slices/layer_columns.hpp>

#include <algorithm>

namespace concino::detail {

CONCINO_INLINE std::vector<column_builder::wall> column_builder::walls_of(const layer_cells& layer) {
  std::vector<wall> walls;
  for (std::uint32_t t = 0; t < layer.kinds.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (const std::uint32_t other = layer.cells.neighbours[t][k]; other == cell_triangles::none || t < other)
        walls.push_back({layer.cells.triangles[t][k], layer.cells.triangles[t][(k + 1) % 3], t, other});
  return walls;
}

CONCINO_INLINE column_builder::interface column_builder::between(const layer_cells& below, const layer_cells& above,
                                                                 double z) {
  interface result;
  stepped_segments all;
  for (const layer_cells* const layer : {&below, &above}) {
    const auto first = static_cast<std::uint32_t>(all.points.size());
    const std::size_t channel = layer == &below ? 0 : 1;
    all.points.insert(all.points.end(), layer->points.begin(), layer->points.end());
    for (const wall& w : walls_of(*layer)) {
      std::array<std::int64_t, 2> step = {0, 0};
      step[channel] = static_cast<std::int64_t>(w.left) -
                      (w.right == cell_triangles::none ? -1 : static_cast<std::int64_t>(w.right));
      all.segments.push_back({first + w.from, first + w.to, step});
    }
    if (channel == 0) result.first_segment_above = all.segments.size();
  }
  result.lines = arrange(caller_, all);
  result.cells = triangulate_cells(result.lines);

  result.verts.assign(result.lines.points.size(), cell_triangles::none);
  const auto number = [&](std::uint32_t p) {
    if (result.verts[p] == cell_triangles::none) {
      result.verts[p] = static_cast<std::uint32_t>(arrays.points.size());
      const slice_point x = lattice_(result.lines.points[p]);
      arrays.points.push_back({x[0], x[1], z});
    }
    return result.verts[p];
  };
  for (const std::uint32_t p : result.lines.chain_points) number(p);
  for (const auto& t : result.cells.triangles) {
    result.faces.push_back(num_faces());
    add_face(std::array{number(t[0]), number(t[1]), number(t[2])});
  }
  return result;
}

CONCINO_INLINE void column_builder::add_face(std::span<const std::uint32_t> verts) {
  if (arrays.face_offsets.empty()) arrays.face_offsets.push_back(0);
  for (const std::uint32_t v : verts) arrays.face_verts.push_back(vert_id{v});
  arrays.face_offsets.push_back(static_cast<std::uint32_t>(arrays.face_verts.size()));
}

CONCINO_INLINE void column_builder::add_wall(const std::vector<std::uint32_t>& low,
                                             const std::vector<std::uint32_t>& high) {
  if (low.size() == 2 && high.size() == 2) return add_face(std::array{low[0], low[1], high[1], high[0]});
  const vec3 from = arrays.points[low[0]], step = arrays.points[low.back()] - from;
  const auto along = [&](std::uint32_t v) { return dot(arrays.points[v] - from, step); };
  for (std::size_t i = 0, k = 0; i + 1 < low.size() || k + 1 < high.size();) {
    if (k + 1 == high.size() || (i + 1 < low.size() && along(low[i + 1]) <= along(high[k + 1]))) {
      add_face(std::array{low[i], low[i + 1], high[k]});
      ++i;
    } else {
      add_face(std::array{low[i], high[k + 1], high[k]});
      ++k;
    }
  }
}

CONCINO_INLINE void column_builder::add(const layer_cells& layer, const layer_cells& next, double z, int index) {
  interface above = between(layer, next, z);
  struct side {
    std::uint32_t column, face;
    std::uint8_t outward;
  };
  std::vector<side> sides;
  const auto add_sides = [&](const interface& at, std::size_t channel) {
    for (std::size_t t = 0; t < at.cells.triangles.size(); ++t) {
      const std::int64_t column = at.cells.values[t][channel] - 1;
      if (column >= static_cast<std::int64_t>(layer.kinds.size()) || column < -1)
        core::throw_joined<unsupported>({caller_, ": layer ", index, " has parts that are too thin"});
      if (column >= 0)
        sides.push_back({static_cast<std::uint32_t>(column), at.faces[t], static_cast<std::uint8_t>(channel == 0)});
    }
  };
  add_sides(below_, 1);
  add_sides(above, 0);
  std::vector<std::uint32_t> low, high;
  std::size_t segment = 0;
  for (const wall& w : walls_of(layer)) {
    low.clear();
    high.clear();
    for (const std::uint32_t p : below_.lines.chain(below_.first_segment_above + segment))
      low.push_back(below_.verts[p]);
    for (const std::uint32_t p : above.lines.chain(segment)) high.push_back(above.verts[p]);
    ++segment;
    const std::uint32_t first = num_faces();
    add_wall(low, high);
    for (std::uint32_t f = first; f < num_faces(); ++f) {
      sides.push_back({w.left, f, 1});
      if (w.right != cell_triangles::none) sides.push_back({w.right, f, 0});
    }
  }
  std::stable_sort(sides.begin(), sides.end(), [](const side& a, const side& b) { return a.column < b.column; });
  if (arrays.poly_offsets.empty()) arrays.poly_offsets.push_back(0);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    arrays.poly_faces.push_back(face_id{sides[i].face});
    arrays.outward.push_back(sides[i].outward);
    if (i + 1 < sides.size() && sides[i + 1].column == sides[i].column) continue;
    arrays.poly_offsets.push_back(static_cast<std::uint32_t>(arrays.poly_faces.size()));
    layers.push_back(index);
    kinds.push_back(layer.kinds[sides[i].column]);
  }
  below_ = std::move(above);
}

}  // namespace concino::detail
