// Adapter for reading picture files through stb: PNG, JPEG, BMP and TGA. save_png of <concino/render/png.hpp> writes
// them.
// Needs: stb (Debian: libstb-dev), and the library of concino::stb: CMake builds it; others compile
//        adapters/concino/adapters/detail/stb_image.cpp.
#pragma once

#include <concino/adapters/detail/stb_image_functions.hpp>
#include <concino/adapters/detail/stb_memory.hpp>
#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/io/file_text.hpp>
#include <concino/render/image.hpp>

#include <climits>
#include <cstddef>
#include <string>
#include <string_view>

namespace concino::detail {

/// Whether no Huffman table of a JPEG file is longer than the 256 codes that there are. stb_image 2.27 would write
/// beyond the end of its own table. Before the first scan, segments are found by their lengths; behind it wherever
/// their mark stands, which is there in no other place.
inline bool has_valid_huffman_tables(std::string_view jpeg) {
  const auto byte = [&](std::size_t i) { return i < jpeg.size() ? static_cast<unsigned char>(jpeg[i]) : 0u; };
  const auto is_valid = [&](std::size_t at, std::size_t end) {  // the tables from a position on
    while (at < end) {
      std::size_t codes = 0;
      for (std::size_t k = 1; k <= 16; ++k) codes += byte(at + k);
      if (codes > 256) return false;
      at += 17 + codes;
    }
    return true;
  };
  // of the segment whose mark is here
  const auto length = [&](std::size_t at) { return std::size_t{256} * byte(at + 2) + byte(at + 3); };
  std::size_t at = 2;
  for (; at < jpeg.size() && byte(at + 1) != 0xda; at += byte(at) == 0xff && byte(at + 1) != 0xff ? 2 + length(at) : 1)
    if (byte(at) == 0xff && byte(at + 1) == 0xc4 && !is_valid(at + 4, at + 2 + length(at))) return false;
  for (; at < jpeg.size(); ++at)
    if (byte(at) == 0xff && byte(at + 1) == 0xc4 && !is_valid(at + 4, at + 2 + length(at))) return false;
  return true;
}

/// Why stb_image failed last in this thread. It quotes the names of chunks of PNG files, which may be any bytes; these
/// are left out.
inline std::string_view stb_failure() {
  const char* const reason = stb_failure_reason();
  const std::string_view text = reason ? reason : "";
  return text.size() < 5 || text.ends_with("PNG chunk not known") ? "a PNG chunk that is not known" : text;
}

}  // namespace concino::detail

namespace concino {

/// Reads a picture file, for example for a texture.
/// Needs:  a PNG, JPEG (baseline or progressive), BMP or TGA file; its content decides, not its name. Components of 16
///         bits are rounded to 8.
/// Result: a picture of up to 65,535 x 65,535 pixels; it has opacities if the file has a channel of them.
/// Cost:   O(pixels) time and memory, in the calling thread.
/// Errors: io_error if the file cannot be read; parse_error with the reason if it is no such file, or damaged so that
///         it cannot be decoded; unsupported if it has more than 2^27 pixels, or 2 GiB.
inline image read_image(const std::string& path) {
  const file_text file(path);
  const std::string_view text = file.text();
  const auto* const bytes = reinterpret_cast<const unsigned char*>(text.data());
  if (text.size() > INT_MAX) core::throw_joined<unsupported>({"read_image: ", path, ": the file has more than 2 GiB"});
  const int size = static_cast<int>(text.size());
  const auto refuse = [&](std::string_view reason) {
    throw parse_error(path, 1, "a PNG, JPEG, BMP or TGA file", core::joined({"'", reason, "'"}));
  };
  const detail::stb_memory memory;
  int width = 0, height = 0, channels = 0;
  const bool is_jpeg = text.starts_with("\xff\xd8");
  if (is_jpeg && !detail::has_valid_huffman_tables(text)) refuse("a Huffman table with more than 256 codes");
  if (size == 0) refuse("no bytes");
  if (!detail::stb_info(bytes, size, width, height, channels)) refuse(detail::stb_failure());
  if (static_cast<long long>(width) * height > 1 << 27)
    core::throw_joined<unsupported>({"read_image: ", path, ": ", width, " x ", height, " pixels are more than 2^27"});
  const bool has_opacity = channels == 2 || channels == 4;
  const int wanted = has_opacity ? 4 : 3;
  const unsigned char* const pixels = detail::stb_load(bytes, size, width, height, channels, wanted);
  if (!pixels) refuse(detail::stb_failure());
  image picture(static_cast<std::size_t>(width), static_cast<std::size_t>(height));
  if (has_opacity) picture.add_opacity();
  const unsigned char* next = pixels;
  for (std::size_t y = 0; y < picture.height(); ++y)
    for (std::size_t x = 0; x < picture.width(); ++x, next += wanted) {
      const auto part = [&](int i) { return static_cast<float>(next[i]) / 255; };
      picture(x, y) = srgb(part(0), part(1), part(2));
      if (has_opacity) picture.opacity(x, y) = part(3);
    }
  return picture;
}

}  // namespace concino
