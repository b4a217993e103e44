// What a reader of OBJ files does not store in the mesh, counted for the report.
#pragma once

#include <concino/core/message.hpp>
#include <concino/io/options.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace concino::detail {

struct obj_skipped {
  std::uint64_t num_extra = 0, num_lines = 0, num_smooth = 0, num_other = 0;
  std::uint64_t num_zero = 0, num_bad_colors = 0;
  std::uint64_t num_third = 0, num_invalid = 0;  // texture coordinates with a third number; those and normals that are
                                                 // not finite numbers
  std::uint64_t num_textures = 0, num_normals = 0;  // that no corner has
  std::size_t first_other = 0, first_invalid = 0;   // positions in the file
  std::string other;

  /// line_at(position): the number of the line there.
  template<class Line>
  void report(load_report& to, const Line& line_at) const {
    const auto skipped = [&](std::uint64_t n, const char* what) {
      if (n) to.skipped.push_back(core::joined({n, " ", what}));
    };
    skipped(num_third, "texture coordinates with a third number other than 0: the number");
    skipped(num_textures, "texture coordinates (vt) that no corner has");
    skipped(num_normals, "normals (vn) that no corner has");
    if (num_invalid)
      to.notes.push_back(core::joined(
          {num_invalid,
           " texture coordinates (vt) or normals (vn) are not finite numbers, so that their corners have no value; the first on line ",
           line_at(first_invalid)}));
    skipped(num_bad_colors, "colours of verts with a number that is not finite");
    if (num_zero)
      to.notes.push_back(
          core::joined({num_zero, " indices of texture coordinates or normals are 0: the corners have none"}));
    skipped(num_extra, "weights of verts, or other numbers after x y z that are not r g b");
    skipped(num_lines, "points and lines (p, l)");
    skipped(num_smooth, "smoothing groups (s)");
    if (num_other)
      to.skipped.push_back(core::joined({num_other, " lines with other keywords, the first '", other, "' on line ",
                                         line_at(first_other)}));
  }
};

}  // namespace concino::detail
