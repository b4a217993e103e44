// Reads the contours and lines of layers to a lattice, and reports what it changes.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/slice_layer.hpp>
#include <concino/print/detail/regions/lattice.hpp>
#include <concino/print/polygon_clipper.hpp>
#include <concino/print/slice_report.hpp>

#include <vector>

namespace concino::detail {

/// Checks the points of a layer and adds them to a box.
/// Errors: invalid_argument that names a contour with a point that is not finite, or a group of hatches with an odd
///         number of points.
void add_layer(const char* caller, const slice_layer& layer, std::size_t index, planar_box& to);

class contour_reader {
  const lattice& to_;
  const polygon_clipper& back_end_;
  std::size_t layer_;
  std::vector<contour_note>& notes_;

 public:
  contour_reader(const lattice& to, const polygon_clipper& back_end, std::size_t layer,
                 std::vector<contour_note>& notes)
      : to_(to), back_end_(back_end), layer_(layer), notes_(notes) {}

  /// The regions of contours by the rule of layer_regions.
  lattice_regions regions(const slice_layer& layer);
  /// What is nearer to lines than a radius, less `without`; nothing, which is reported, if the radius is 0.
  lattice_regions thickened(const slice_lines& lines, slice_lines_kind kind, double radius, double chord_error,
                            const lattice_paths& without);

 private:
  void note(slice_lines_kind kind, std::size_t contour, contour_change change) {
    notes_.push_back({layer_ == single_layer ? 0 : layer_, kind, contour, change});
  }
  void add_contours(const slice_lines& lines, slice_lines_kind kind, lattice_paths& paths);
};

/// A list of lines of a layer.
const slice_lines& lines_of(const slice_layer& layer, slice_lines_kind kind);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/print/detail/regions/contour_reader.ipp>
#endif
