// Grids: rectangles and boxes divided into cells of any kind, by make_grid<M>().
#pragma once

#include <concino/core/message.hpp>
#include <concino/generate/detail/common/construct_from_arrays.hpp>

#include <algorithm>
#include <array>

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

inline surface_arrays quad_grid(const grid_options& o) {
  const auto [nx, ny, unused] = o.cells;
  const spaced x("make_grid", "x", o.min.x, o.max.x, nx), y("make_grid", "y", o.min.y, o.max.y, ny);
  surface_arrays a{{}, {}, {}, 4};
  a.points.reserve((nx + 1) * (ny + 1));
  a.verts.reserve(4 * nx * ny);
  for (std::size_t j = 0; j <= ny; ++j)
    for (std::size_t i = 0; i <= nx; ++i) a.points.push_back({x[i], y[j], o.min.z});
  for (std::size_t j = 0; j < ny; ++j)
    for (std::size_t i = 0; i < nx; ++i)
      for (const std::size_t step : {std::size_t{0}, std::size_t{1}, nx + 2, nx + 1})
        a.verts.push_back(vert_id{j * (nx + 1) + i + step});
  return a;
}

/// Rows of hexagons, every other row shifted by half a cell. Zigzag lines separate the rows, and vertical edges connect
/// the lines. The verts of a line are at half cells i = 0 .. 2 nx; row j has its vertical edges at the i with the same
/// parity as j.
inline surface_arrays honeycomb(const grid_options& o) {
  const auto [nx, ny, unused] = o.cells;
  const std::size_t ends = 2 * nx, top = (ny - 1) % 2;  // parity of the vertical edges at the uppermost line
  // Zigzags of a sixth of a row up and down: the hexagons are affine images of regular ones.
  const spaced x("make_grid", "x", o.min.x, o.max.x, ends), y("make_grid", "y", o.min.y, o.max.y, 6 * ny);
  const auto has = [&, cells_up = ny](std::size_t i, std::size_t line) {
    if (line == 0) return i % 2 == 0;
    return line < cells_up || i % 2 == top || i == 0 || i == ends;
  };
  const auto vert = [&, w = nx, h = ny](std::size_t i, std::size_t line) {
    if (line == 0) return i / 2;
    const std::size_t first = w + 1 + (line - 1) * (ends + 1);
    if (line < h) return first + i;
    return first + (top == 0 ? i / 2 : i == ends ? w + 1 : (i + 1) / 2);
  };
  surface_arrays a;
  a.offsets.push_back(0);
  for (std::size_t line = 0; line <= ny; ++line)
    for (std::size_t i = 0; i <= ends; ++i) {
      if (!has(i, line)) continue;
      const bool at_border = line == 0 || line == ny, up = (i + line) % 2 == 0;
      a.points.push_back({x[i], y[at_border ? 6 * line : up ? 6 * line + 1 : 6 * line - 1], o.min.z});
    }
  for (std::size_t row = 0; row < ny; ++row)
    for (std::size_t left = 0; left < ends;) {
      const std::size_t right = std::min(left % 2 == row % 2 ? left + 2 : left + 1, ends);
      for (std::size_t i = left; i <= right; ++i)
        if (has(i, row)) a.verts.push_back(vert_id{vert(i, row)});
      for (std::size_t i = right + 1; i-- > left;)
        if (has(i, row + 1)) a.verts.push_back(vert_id{vert(i, row + 1)});
      a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
      left = right;
    }
  return a;
}

inline cell_arrays hex_grid(const grid_options& o) {
  const auto [nx, ny, nz] = o.cells;
  const spaced x("make_grid", "x", o.min.x, o.max.x, nx), y("make_grid", "y", o.min.y, o.max.y, ny),
      z("make_grid", "z", o.min.z, o.max.z, nz);
  cell_arrays a{{}, {}, 8};
  a.points.reserve((nx + 1) * (ny + 1) * (nz + 1));
  a.verts.reserve(8 * nx * ny * nz);
  for (std::size_t k = 0; k <= nz; ++k)
    for (std::size_t j = 0; j <= ny; ++j)
      for (std::size_t i = 0; i <= nx; ++i) a.points.push_back({x[i], y[j], z[k]});
  const std::size_t row = nx + 1, layer = row * (ny + 1);
  for (std::size_t k = 0; k < nz; ++k)
    for (std::size_t j = 0; j < ny; ++j)
      for (std::size_t i = 0; i < nx; ++i)
        for (const std::size_t v : {k * layer + j * row + i, (k + 1) * layer + j * row + i})
          for (const std::size_t step : {std::size_t{0}, std::size_t{1}, row + 1, row})
            a.verts.push_back(vert_id{v + step});
  return a;
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
  const double x = static_cast<double>(options.cells[0]), y = static_cast<double>(options.cells[1]),
               z = static_cast<double>(options.cells[2]);
  if constexpr (dimension_v<M> == 3) {  // volumes are built of cubes, surfaces of squares
    detail::check_element_counts<M>("make_grid", "cells", (x + 1) * (y + 1) * (z + 1), x * y * z);
    return detail::construct_from_hexes<M>(detail::hex_grid(options));
  } else if constexpr (arity_v<M> > 0) {  // triangles and quads; general polygons are hexagons
    detail::check_element_counts<M>("make_grid", "cells", (x + 1) * (y + 1), x * y);
    return detail::construct_from_quads<M>(detail::quad_grid(options));
  } else {
    detail::check_element_counts<M>("make_grid", "cells", (2 * x + 1) * (y + 1), (x + 1) * y);
    return detail::construct_from_arrays<M>(detail::honeycomb(options));
  }
}

// What to write instead of calls that cannot compile.
template<class M, class R = mistake::remedy<mistake::include_adapter>>
  requires(!requirement::is_adapted<M>)
M make_grid(...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter

}  // namespace concino
