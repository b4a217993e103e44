// Defines layer_cells.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/number_text.hpp>
#include <concino/print/detail/regions/layer_cells.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

CONCINO_INLINE lattice lattice_of(const char* caller, const slices& s, const layer_options& options, int bits) {
  const auto check = [&](const char* name, double x) {
    if (!(x >= 0) || !std::isfinite(x))
      core::throw_joined<invalid_argument>(
          {caller, ": ", name, " is ", core::number_text(x), "; it must be finite and 0 or more"});
  };
  check("thicken", options.thicken);
  check("thicken_hatches", options.thicken_hatches);
  check("chord_error", options.chord_error);
  planar_box around;
  for (std::size_t i = 0; i < s.layers.size(); ++i) {
    if (!std::isfinite(s.layers[i].z))
      core::throw_joined<invalid_argument>({caller, ": the height of layer ", i, " is not finite"});
    add_layer(caller, s.layers[i], i, around);
  }
  return lattice(caller, around, std::max(options.thicken, options.thicken_hatches), bits);
}

// Steps that count the regions of each kind at a place.
inline constexpr std::int64_t kind_steps[3] = {1, std::int64_t{1} << 20, std::int64_t{1} << 40};

/// The first kind that is there, or -1.
inline int kind_of(std::int64_t value) {
  for (int k = 0; k < 3; ++k) {
    const std::int64_t count = value % kind_steps[1];
    if (count > 0) return k;
    value = (value - count) / kind_steps[1];
  }
  return -1;
}

CONCINO_INLINE layer_cells cells_of_layer(const char* caller, const slice_layer& layer, const lattice& to,
                                          const layer_options& options, const polygon_clipper& back_end,
                                          const rounding& round, std::size_t index, slice_report& report) {
  contour_reader read(to, back_end, index, report.notes);
  lattice_paths kinds[3];
  kinds[0] = read.regions(layer).paths;
  kinds[1] = read.thickened(layer.open, slice_lines_kind::open, options.thicken, options.chord_error, kinds[0]).paths;
  lattice_paths before = kinds[0];
  for (std::size_t i = 0; i < kinds[1].size(); ++i) before.push_back(kinds[1][i]);
  kinds[2] =
      read.thickened(layer.hatches, slice_lines_kind::hatches, options.thicken_hatches, options.chord_error, before)
          .paths;
  stepped_segments all;
  for (std::size_t k = 0; k < 3; ++k) all.add_paths(kinds[k], {kind_steps[k], 0});
  for (snapped_point& p : all.points)
    for (std::int64_t& x : p)
      x = static_cast<std::int64_t>(
          std::ldexp(std::nearbyint(std::ldexp(static_cast<double>(x), -round.coarser)), round.finer));
  planar_arrangement cut = arrange(caller, all);
  cell_triangles found = triangulate_cells(cut);
  layer_cells result;
  result.points = std::move(cut.points);
  // without gaps that rounding has left
  std::vector<std::uint32_t> number(found.triangles.size(), cell_triangles::none);
  for (std::size_t t = 0; t < found.triangles.size(); ++t) {
    const int kind = kind_of(found.values[t][0]);
    if (kind < 0) continue;
    number[t] = static_cast<std::uint32_t>(result.kinds.size());
    result.kinds.push_back(kind);
    result.cells.triangles.push_back(found.triangles[t]);
    result.cells.neighbours.push_back(found.neighbours[t]);
  }
  for (auto& next : result.cells.neighbours)
    for (std::uint32_t& t : next)
      if (t != cell_triangles::none) t = number[t];
  return result;
}

/// Grows a polygon triangle by triangle, as long as it passes no point twice.
class polygon_grower {
  struct link {
    std::uint32_t from, triangle, k;  // side k of the triangle, which is in the polygon
    std::uint32_t next;               // side
  };
  const layer_cells& layer_;
  std::vector<std::uint8_t> is_taken_;
  std::vector<std::uint32_t> polygon_of_;  // by point: the last polygon that passes it, plus 1
  std::vector<link> cycle_;
  std::vector<std::uint32_t> open_;

 public:
  merged_polygons result;

  explicit polygon_grower(const layer_cells& layer)
      : layer_(layer), is_taken_(layer.kinds.size(), 0), polygon_of_(layer.points.size(), 0) {}

  void grow_from(std::uint32_t first) {
    if (is_taken_[first]) return;
    const auto name = static_cast<std::uint32_t>(result.ends.size() + 1);
    cycle_.clear();
    open_.clear();
    is_taken_[first] = 1;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t p = layer_.cells.triangles[first][k];
      polygon_of_[p] = name;
      cycle_.push_back({p, first, k, (k + 1) % 3});
      open_.push_back(k);
    }
    for (std::size_t i = 0; i < open_.size(); ++i) {  // breadth first, so that polygons are compact
      const std::uint32_t s = open_[i], t = layer_.cells.neighbours[cycle_[s].triangle][cycle_[s].k];
      if (t == cell_triangles::none || is_taken_[t] || layer_.kinds[t] != layer_.kinds[first]) continue;
      const auto& corners = layer_.cells.triangles[t];
      std::uint32_t k = 0;  // of the corner that is not on this side; the side after `from` leads to it
      while (layer_.cells.neighbours[t][k] != cycle_[s].triangle || corners[(k + 1) % 3] != cycle_[s].from) ++k;
      const std::uint32_t apex = corners[(k + 2) % 3];
      if (polygon_of_[apex] == name) continue;
      polygon_of_[apex] = name;
      is_taken_[t] = 1;
      const auto added = static_cast<std::uint32_t>(cycle_.size());
      cycle_.push_back({apex, t, (k + 2) % 3, cycle_[s].next});
      cycle_[s] = {cycle_[s].from, t, (k + 1) % 3, added};
      open_.push_back(s);
      open_.push_back(added);
    }
    std::uint32_t s = 0;
    do {
      result.points.push_back(cycle_[s].from);
      s = cycle_[s].next;
    } while (s != 0);
    result.ends.push_back(result.points.size());
    result.kinds.push_back(layer_.kinds[first]);
  }
};

CONCINO_INLINE merged_polygons merge_triangles(const layer_cells& layer) {
  polygon_grower grower(layer);
  for (std::uint32_t t = 0; t < layer.kinds.size(); ++t) grower.grow_from(t);
  return std::move(grower.result);
}

}  // namespace concino::detail
