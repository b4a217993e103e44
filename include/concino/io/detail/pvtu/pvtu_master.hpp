// Writes .pvtu files, which name the pieces of a mesh and the arrays that they have.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/vtk/vtk_numbers.hpp>
#include <concino/io/options.hpp>
#include <concino/io/text_sink.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace concino::detail {

/// The arrays of a piece.
struct piece_arrays {
  struct array {
    std::string name;
    vtk_number type = vtk_number::none;
    std::uint64_t components = 1;
    bool operator==(const array&) const = default;
  };
  std::vector<array> of_points, of_cells;
  vtk_number coordinates = vtk_number::float64;
  std::string active_of_points, active_of_cells;  // the attributes of the tags around them
};

void write_pvtu(text_sink& out, const piece_arrays& arrays, std::span<const std::string> pieces);

/// Writes the .pvtu file of pieces that are there; see save_pvtu.
void save_pvtu_of_pieces(std::span<const std::string> pieces, const std::string& path, const file_options& options);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/pvtu/pvtu_master.ipp>
#endif
