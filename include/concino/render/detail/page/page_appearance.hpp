// What things look like in a page: colours, colour maps, materials.
#pragma once

#include <concino/core/rgba.hpp>
#include <concino/core/vec3.hpp>
#include <concino/render/appearance.hpp>
#include <concino/render/colormap.hpp>
#include <concino/render/detail/page/page_writer.hpp>
#include <concino/render/label_colors.hpp>
#include <concino/render/surface_material.hpp>
#include <concino/render/texture.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace concino::detail {

inline std::vector<std::uint8_t> bytes_of_colors(std::span<const rgb> colors) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * colors.size());
  for (const rgb& c : colors)
    for (const std::uint8_t b : srgb_bytes(c)) bytes.push_back(b);
  return bytes;
}

/// A colour map at equal steps.
inline std::vector<std::uint8_t> bytes_of_map(const colormap& map, std::size_t steps) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < steps; ++i)
    for (const float x : map.srgb_at(static_cast<double>(i) / static_cast<double>(steps - 1)))
      bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0.0f, 1.0f))));
  return bytes;
}

inline vec3 numbers_of_color(const rgb& c) { return {c.r, c.g, c.b}; }

inline void write_look(page_writer& out, const appearance& look, bool has_values) {
  out.begin("look", '{');
  out.add("color", numbers_of_color(look.color));
  out.add("exposed_color", numbers_of_color(look.exposed_color));
  out.add("no_value", numbers_of_color(look.no_value));
  out.add("edge_color", numbers_of_color(look.edge_color));
  out.add("labels", look.labels);
  out.add("isobands", static_cast<double>(look.isobands));
  out.add("band_width", look.band_width);
  out.add("band_limit", look.band_limit);
  out.add("isolines", static_cast<double>(look.isolines));
  out.add("edge_width", look.edge_width);
  out.add("opacity", look.opacity);
  out.add("shine", look.shine);
  if (has_values) out.add_bytes("map", bytes_of_map(look.map, 256));
  out.begin("scale", '[');
  for (std::size_t i = 0; i < look.scale.values().size(); ++i) {
    out.begin('[');
    out.add(look.scale.values()[i]);
    out.add(look.scale.positions()[i]);
    out.end(']');
  }
  out.end(']');
  out.end('}');
}

/// The light of a material at 64 x 64 normals, if it has its own.
inline void write_material(page_writer& out, const surface_material& material) {
  if (material.is_daylight()) return;
  std::vector<rgb> ball;
  for (int j = 0; j < 64; ++j)
    for (int i = 0; i < 64; ++i) {
      vec3 n{(i - 31.5) / 31.5, (31.5 - j) / 31.5, 0};
      const double square = dot(n, n);
      if (square > 1) n /= std::sqrt(square);
      else n.z = std::sqrt(1 - square);
      ball.push_back(material(n));
    }
  out.add_bytes("ball", bytes_of_colors(ball));
}

/// Writes what a texture consists of.
struct texture_page {
  static void write(page_writer& out, const texture& t) {
    using kind = texture::kind;
    out.add("kind", t.kind_ == kind::checkerboard ? 1.0 : t.kind_ == kind::isolines ? 2.0 : 3.0);
    out.add("count", t.count_);
    out.add("width", t.width_);
    out.add("first", numbers_of_color(t.first_));
    out.add("second", numbers_of_color(t.second_));
    if (t.kind_ != kind::picture) return;
    const image& picture = t.levels_->front();
    out.add("repeats", t.border_ == texture::outside::repeat);
    out.begin("picture", '{');
    out.add("width", static_cast<double>(picture.width()));
    out.add("height", static_cast<double>(picture.height()));
    out.add_bytes("pixels", srgb_bytes(picture));  // four bytes if it has opacities, else three
    out.end('}');
  }
};

inline void write_maps(page_writer& out) {
  constexpr std::pair<const char*, const colormap*> maps[] = {{"blue to yellow", &colormap::blue_to_yellow},
                                                              {"viridis", &colormap::viridis},
                                                              {"cividis", &colormap::cividis},
                                                              {"turbo", &colormap::turbo},
                                                              {"cool warm", &colormap::cool_warm},
                                                              {"hsv", &colormap::hsv}};
  out.begin("maps", '[');
  for (const auto& [name, map] : maps) {
    out.begin('{');
    out.add("name", name);
    out.add_bytes("colors", bytes_of_map(*map, 64));
    out.end('}');
  }
  out.end(']');
  std::vector<rgb> colors;
  for (std::size_t i = 0; i < num_label_colors; ++i) colors.push_back(label_color(i));
  out.add_bytes("label_colors", bytes_of_colors(colors));
}

}  // namespace concino::detail
