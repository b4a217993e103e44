// The expected numbers of elements of an OBJ file, from a sample of its lines.
#pragma once

#include <concino/io/detail/text/characters.hpp>
#include <concino/io/detail/text/text_sample.hpp>

#include <cstddef>
#include <string_view>

namespace concino::detail {

struct obj_sizes {
  std::size_t points, corners, textures, normals;
};

/// The expected numbers, with a margin, but 0 where the sample has none.
inline obj_sizes expected_sizes_of_obj(std::string_view text) {
  obj_sizes n{0, 0, 0, 0};
  const double scale = sample_lines(text, [&](const char* line, const char* last) {
    if (last - line < 2) return;
    n.textures += *line == 'v' && line[1] == 't';
    n.normals += *line == 'v' && line[1] == 'n';
    if (!is_blank(line[1])) return;
    if (*line == 'v') ++n.points;
    else if (*line == 'f') n.corners += words_of_line(line, last) - 1;
  });
  const auto expected = [scale](std::size_t k) { return k ? with_margin(scale * static_cast<double>(k)) : 0; };
  return {expected(n.points), expected(n.corners), expected(n.textures), expected(n.normals)};
}

}  // namespace concino::detail
