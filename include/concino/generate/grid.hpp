// Grids: rectangles and boxes divided into cells of any kind, by make_grid<M>().
#pragma once

#include <concino/core/message.hpp>
#include <concino/generate/detail/common/construct_from_arrays.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino {

struct grid_options {
  std::array<std::size_t, 3> cells = {8, 8, 8};  // along x, y, z, 1 or more; a surface uses the first two
  vec3 min = {0, 0, 0};                          // finite
  vec3 max = {1, 1, 1};                          // finite, above min; a surface lies at z = min.z and uses x and y
};

namespace detail {

/// Equally spaced values from min to max. The first and the last are exact.
class spaced {
  double min_ = 0, max_ = 0, extent_ = 0, n_ = 1;
  std::size_t last_ = 1;

 public:
  /// Errors: invalid_argument if the n + 1 values would not all be different.
  spaced(const char* what, const char* axis, double min, double max, std::size_t n)
      : min_(min), max_(max), extent_(max - min), n_(static_cast<double>(n)), last_(n) {
    if (!std::isfinite(min) || !std::isfinite(max) || !(min < max) || !std::isfinite(extent_))
      core::throw_joined<invalid_argument>({what, ": min.", axis, " is ", core::number_text(min), " and max.", axis,
                                            " is ", core::number_text(max),
                                            "; both must be finite, min below max, and their difference finite"});
    const double far = std::max(std::abs(min), std::abs(max));
    const double spacing = std::max(far - std::nextafter(far, 0), std::numeric_limits<double>::min());
    if (!(extent_ / n_ > 8 * spacing))
      core::throw_joined<invalid_argument>({what, ": ", n, " steps between min.", axis, " and max.", axis,
                                      " are too small for double precision; take fewer cells or a larger box"});
  }
  double operator[](std::size_t i) const { return i == last_ ? max_ : min_ + extent_ * (static_cast<double>(i) / n_); }
};

inline void check_grid(const char* what, const grid_options& o, std::size_t axes) {
  for (std::size_t k = 0; k < axes; ++k) check_at_least(what, core::joined({"cells[", k, "]"}), o.cells[k], 1);
  if (axes == 2 && !std::isfinite(o.min.z)) core::throw_joined<invalid_argument>({what, ": min.z is not finite"});
}

/// The cells begin[k], ..., end[k] - 1 along each axis: all of a grid, or a block of it.
struct grid_block {
  std::array<std::size_t, 3> begin, end;

  std::size_t size(std::size_t axis) const { return end[axis] - begin[axis]; }
};

inline surface_arrays quad_grid(const grid_options& o, const grid_block& b) {
  const spaced x("make_grid", "x", o.min.x, o.max.x, o.cells[0]), y("make_grid", "y", o.min.y, o.max.y, o.cells[1]);
  const std::size_t nx = b.size(0), ny = b.size(1);
  surface_arrays a{{}, {}, {}, 4};
  if (nx == 0 || ny == 0) return a;
  a.points.reserve((nx + 1) * (ny + 1));
  a.verts.reserve(4 * nx * ny);
  for (std::size_t j = b.begin[1]; j <= b.end[1]; ++j)
    for (std::size_t i = b.begin[0]; i <= b.end[0]; ++i) a.points.push_back({x[i], y[j], o.min.z});
  for (std::size_t j = 0; j < ny; ++j)
    for (std::size_t i = 0; i < nx; ++i)
      for (const std::size_t step : {std::size_t{0}, std::size_t{1}, nx + 2, nx + 1})
        a.verts.push_back(vert_id{j * (nx + 1) + i + step});
  return a;
}

/// Rows of hexagons, every other row shifted by half a cell. Zigzag lines separate the rows, and vertical edges connect
/// the lines. The verts of a line are at half cells i = 0 .. 2 nx; row j has its vertical edges at the i with the same
/// parity as j.
class honeycomb {
  std::size_t nx_, ny_, ends_, top_;  // top: parity of the vertical edges at the uppermost line

  bool has(std::size_t i, std::size_t line) const {
    if (line == 0) return i % 2 == 0;
    return line < ny_ || i % 2 == top_ || i == 0 || i == ends_;
  }

 public:
  explicit honeycomb(const grid_options& o)
      : nx_(o.cells[0]), ny_(o.cells[1]), ends_(2 * nx_), top_((ny_ - 1) % 2) {}

  /// The number of the vert at a half cell of a line, and that of the first cell of a row.
  std::size_t vert(std::size_t i, std::size_t line) const {
    if (line == 0) return i / 2;
    const std::size_t first = nx_ + 1 + (line - 1) * (ends_ + 1);
    if (line < ny_) return first + i;
    return first + (top_ == 0 ? i / 2 : i == ends_ ? nx_ + 1 : (i + 1) / 2);
  }
  std::size_t first_cell(std::size_t row) const { return row * nx_ + row / 2; }

  /// Calls f(column, row) for the cells of a block. Shifted rows have one more, which goes with the last column.
  template<class F>
  void for_each_cell(const grid_block& b, F f) const {
    for (std::size_t row = b.begin[1]; row < b.end[1]; ++row) {
      const std::size_t more = row % 2 == 1 && b.size(0) > 0 && b.end[0] == nx_;
      for (std::size_t c = b.begin[0]; c < b.end[0] + more; ++c) f(c, row);
    }
  }
  /// Calls f(i, line) for the verts of a cell, counter-clockwise.
  template<class F>
  void for_each_vert(std::size_t column, std::size_t row, F f) const {
    const std::size_t shift = row % 2, left = std::max(2 * column, shift) - shift,
                      right = std::min(2 * column + 2 - shift, ends_);
    for (std::size_t i = left; i <= right; ++i)
      if (has(i, row)) f(i, row);
    for (std::size_t i = right + 1; i-- > left;)
      if (has(i, row + 1)) f(i, row + 1);
  }
};

inline surface_arrays hexagon_grid(const grid_options& o, const grid_block& b) {
  const honeycomb cells(o);
  // Zigzags of a sixth of a row up and down: the hexagons are affine images of regular ones.
  const spaced x("make_grid", "x", o.min.x, o.max.x, 2 * o.cells[0]),
      y("make_grid", "y", o.min.y, o.max.y, 6 * o.cells[1]);
  const std::size_t left = 2 * b.begin[0] - (b.begin[0] > 0), width = 2 * b.end[0] - left + 1;
  std::vector<std::uint32_t> vert((b.size(1) + 1) * width, 0);  // by line and half cell: 1 if used, then its index
  surface_arrays a;
  a.offsets.push_back(0);
  cells.for_each_cell(b, [&](std::size_t column, std::size_t row) {
    cells.for_each_vert(column, row, [&](std::size_t i, std::size_t line) {
      const std::size_t place = (line - b.begin[1]) * width + i - left;
      vert[place] = 1;
      a.verts.push_back(vert_id{place});
    });
    a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
  });
  for (std::size_t place = 0; place < vert.size(); ++place) {
    if (vert[place] == 0) continue;
    vert[place] = static_cast<std::uint32_t>(a.points.size());
    const std::size_t line = b.begin[1] + place / width, i = left + place % width;
    const bool at_border = line == 0 || line == o.cells[1], up = (i + line) % 2 == 0;
    a.points.push_back({x[i], y[at_border ? 6 * line : up ? 6 * line + 1 : 6 * line - 1], o.min.z});
  }
  for (vert_id& v : a.verts) v = vert_id{vert[v.raw()]};
  return a;
}

inline cell_arrays hex_grid(const grid_options& o, const grid_block& b) {
  const spaced x("make_grid", "x", o.min.x, o.max.x, o.cells[0]), y("make_grid", "y", o.min.y, o.max.y, o.cells[1]),
      z("make_grid", "z", o.min.z, o.max.z, o.cells[2]);
  const std::size_t nx = b.size(0), ny = b.size(1), nz = b.size(2);
  cell_arrays a{{}, {}, 8};
  if (nx == 0 || ny == 0 || nz == 0) return a;
  a.points.reserve((nx + 1) * (ny + 1) * (nz + 1));
  a.verts.reserve(8 * nx * ny * nz);
  for (std::size_t k = b.begin[2]; k <= b.end[2]; ++k)
    for (std::size_t j = b.begin[1]; j <= b.end[1]; ++j)
      for (std::size_t i = b.begin[0]; i <= b.end[0]; ++i) a.points.push_back({x[i], y[j], z[k]});
  const std::size_t row = nx + 1, layer = row * (ny + 1);
  for (std::size_t k = 0; k < nz; ++k)
    for (std::size_t j = 0; j < ny; ++j)
      for (std::size_t i = 0; i < nx; ++i)
        for (const std::size_t v : {k * layer + j * row + i, (k + 1) * layer + j * row + i})
          for (const std::size_t step : {std::size_t{0}, std::size_t{1}, row + 1, row})
            a.verts.push_back(vert_id{v + step});
  return a;
}

/// A block of the grid, as a mesh of its own: polys and verts in the order of the whole grid.
/// Errors: invalid_argument, as make_grid.
template<class M>
M make_grid_block(const grid_options& options, const grid_block& b) {
  const double x = static_cast<double>(b.size(0)), y = static_cast<double>(b.size(1)),
               z = static_cast<double>(b.size(2));
  if constexpr (dimension_v<M> == 3) {  // volumes are built of cubes, surfaces of squares
    check_element_counts<M>("make_grid", "cells", (x + 1) * (y + 1) * (z + 1), x * y * z);
    return construct_from_hexes<M>(hex_grid(options, b));
  } else if constexpr (arity_v<M> > 0) {  // triangles and quads; general polygons are hexagons
    check_element_counts<M>("make_grid", "cells", (x + 1) * (y + 1), x * y);
    return construct_from_quads<M>(quad_grid(options, b));
  } else {
    check_element_counts<M>("make_grid", "cells", (2 * x + 1) * (y + 1), (x + 1) * y);
    return construct_from_arrays<M>(hexagon_grid(options, b));
  }
}

}  // namespace detail

/// A rectangle in the plane z = min.z, or a box, divided into cells of the kind of M.
/// Needs:  M is one of the six native meshes, or a mesh that can add verts and polys.
/// Result: surfaces are oriented upward. Quads: cells[0] x cells[1]; triangles: two per quad; polygons of any size:
///         cells[1] rows of hexagons, every other row shifted by half a cell and ending in halves, cut straight at the
///         border (quads, pentagons, hexagons). Volumes: hexes; six tets per cube around its diagonal (Kuhn); or the
///         hexes as polyhedra. Verts are numbered row by row, x fastest.
/// Cost:   O(cells) time and memory.
/// Errors: invalid_argument that names the field: no cells, more cells than 32-bit descriptors, a box that is not
///         finite, is empty or is so thin that rounding makes verts coincide. unsupported if a mesh of another library
///         refuses a poly.
/// Source: Kuhn 1960 (six tets).
template<requirement::can_be_generated M>
M make_grid(const grid_options& options = {}) {
  detail::check_grid("make_grid", options, dimension_v<M>);
  return detail::make_grid_block<M>(options, {{0, 0, 0}, options.cells});
}

// What to write instead of calls that cannot compile.
template<class M, class R = mistake::remedy<mistake::include_adapter>>
  requires(!requirement::is_adapted<M>)
M make_grid(...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter

}  // namespace concino
