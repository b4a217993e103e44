// The block of a grid that one process makes, with the numbers that its verts and polys have in the whole grid.
#pragma once

#include <concino/adapters/detail/distributed/distributed_records.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/generate/grid.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino::detail {

/// Divides the cells of a grid into as many blocks as there are processes: each prime factor of their number, from the
/// largest, divides the axis along which blocks are longest.
class grid_division {
  std::array<std::size_t, 3> cells_, blocks_ = {1, 1, 1};

 public:
  grid_division(const std::array<std::size_t, 3>& cells, std::size_t axes, std::size_t processes) : cells_(cells) {
    std::vector<std::size_t> factors;
    for (std::size_t f = 2; processes > 1; ++f)
      for (; processes % f == 0; processes /= f) factors.push_back(f);
    for (; !factors.empty(); factors.pop_back()) {
      std::size_t longest = 0;
      for (std::size_t k = 1; k < axes; ++k)
        if (cells[k] / blocks_[k] > cells[longest] / blocks_[longest]) longest = k;
      blocks_[longest] *= factors.back();
    }
  }

  grid_block block(std::size_t process) const {
    grid_block b{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = process % blocks_[k];
      process /= blocks_[k];
      b.begin[k] = part_of_axis(k, i);
      b.end[k] = part_of_axis(k, i + 1);
    }
    return b;
  }

 private:
  /// cells * i / blocks, without overflow.
  std::size_t part_of_axis(std::size_t k, std::size_t i) const {
    return cells_[k] / blocks_[k] * i + cells_[k] % blocks_[k] * i / blocks_[k];
  }
};

/// A bound of the numbers of verts.
template<class M>
std::uint64_t num_grid_verts(const grid_options& o) {
  const std::uint64_t of_layer = (o.cells[0] + 1) * (o.cells[1] + 1);
  if constexpr (dimension_v<M> == 3) return of_layer * (o.cells[2] + 1);  // surfaces have one layer
  else if constexpr (arity_v<M> > 0) return of_layer;                     // general polygons are hexagons
  else return honeycomb(o).vert(2 * o.cells[0], o.cells[1]) + 1;
}

/// Numbers, in the whole grid, of the polys of a block and of the verts of its mesh.
struct grid_numbers {
  std::vector<std::uint64_t> verts, polys;
};

/// Numbers of squares or cubes; a surface has one layer.
inline grid_numbers numbers_of_cells(const grid_options& o, const grid_block& b, std::size_t axes,
                                     std::size_t polys_per_cell) {
  grid_numbers r;
  const std::size_t first_layer = axes == 3 ? b.begin[2] : 0, end_layer = axes == 3 ? b.end[2] : 1;
  if (b.size(0) == 0 || b.size(1) == 0 || first_layer == end_layer) return r;
  const std::uint64_t nx = o.cells[0], ny = o.cells[1];
  for (std::uint64_t k = first_layer; k < end_layer + (axes == 3); ++k)
    for (std::uint64_t j = b.begin[1]; j <= b.end[1]; ++j)
      for (std::uint64_t i = b.begin[0]; i <= b.end[0]; ++i) r.verts.push_back((k * (ny + 1) + j) * (nx + 1) + i);
  for (std::uint64_t k = first_layer; k < end_layer; ++k)
    for (std::uint64_t j = b.begin[1]; j < b.end[1]; ++j)
      for (std::uint64_t i = b.begin[0]; i < b.end[0]; ++i)
        for (std::size_t p = 0; p < polys_per_cell; ++p)
          r.polys.push_back(((k * ny + j) * nx + i) * polys_per_cell + p);
  return r;
}

/// Numbers of hexagons.
template<class M>
grid_numbers numbers_of_hexagons(const grid_options& o, const grid_block& b, const M& m) {
  const honeycomb cells(o);
  grid_numbers r;
  r.verts.resize(num_verts(m));
  cells.for_each_cell(b, [&](std::size_t column, std::size_t row) {
    const auto around = adj_p2v(m, poly_t<M>{static_cast<unsigned>(r.polys.size())});
    auto v = around.begin();
    cells.for_each_vert(column, row, [&](std::size_t i, std::size_t line) {
      r.verts[index_of(m, *v)] = cells.vert(i, line);
      ++v;
    });
    r.polys.push_back(cells.first_cell(row) + column);
  });
  return r;
}

/// The polys of a block, without ghosts.
template<class M>
poly_records grid_records(const grid_options& o, const grid_block& b) {
  const M block = make_grid_block<M>(o, b);
  grid_numbers numbers;
  constexpr bool is_volume = dimension_v<M> == 3;
  constexpr std::size_t polys_per_cell = arity_v<M> == 3 ? 2 : is_volume && arity_v<M> == 4 ? 6 : 1;
  if constexpr (is_volume || arity_v<M> > 0)  // general polygons are hexagons
    numbers = numbers_of_cells(o, b, dimension_v<M>, polys_per_cell);
  else numbers = numbers_of_hexagons(o, b, block);
  return records_of(block, std::move(numbers.verts), std::move(numbers.polys));
}

}  // namespace concino::detail
