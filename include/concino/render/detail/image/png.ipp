// Bodies of png.hpp: PNG files: a picture as the bytes of one, and written to disk.
#pragma once

#include <concino/io/atomic_file.hpp>
#include <concino/io/text_sink.hpp>
#include <concino/render/detail/image/deflate.hpp>
#include <concino/render/png.hpp>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <span>
#include <string_view>

namespace concino {

namespace detail {

inline constexpr std::array<std::uint32_t, 256> crc_of_byte = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t c = i;
    for (int k = 0; k < 8; ++k) c = c >> 1 ^ (c & 1 ? 0xedb88320u : 0u);
    table[i] = c;
  }
  return table;
}();

inline void append_number(std::vector<std::uint8_t>& to, std::size_t x) {
  for (const unsigned shift : {24u, 16u, 8u, 0u}) to.push_back(static_cast<std::uint8_t>(x >> shift));
}

/// Appends a chunk: its length, its name, the data, and the cyclic redundancy check of name and data.
inline void append_chunk(std::vector<std::uint8_t>& to, std::string_view name, std::span<const std::uint8_t> data) {
  append_number(to, data.size());
  const std::size_t first = to.size();
  to.insert(to.end(), name.begin(), name.end());
  to.insert(to.end(), data.begin(), data.end());
  std::uint32_t crc = 0xffffffffu;
  for (std::size_t i = first; i < to.size(); ++i) crc = crc >> 8 ^ crc_of_byte[(crc ^ to[i]) & 255];
  append_number(to, crc ^ 0xffffffffu);
}

/// The byte that filter 0 to 4 expects, of the ones to the left, above, and above to the left.
inline int png_prediction(int filter, int left, int above, int corner) {
  if (filter == 0) return 0;
  if (filter == 1) return left;
  if (filter == 2) return above;
  if (filter == 3) return (left + above) / 2;
  const int guess = left + above - corner, l = std::abs(guess - left), a = std::abs(guess - above),
            c = std::abs(guess - corner);
  return l <= a && l <= c ? left : a <= c ? above : corner;
}

/// Filters rows, each by the filter that leaves the smallest numbers.
class png_rows {
  std::size_t size_, pixel_;  // bytes
  std::vector<std::uint8_t> row_, above_, filtered_, best_;

  void filter(int f, std::size_t& least) {
    std::size_t sum = 0;
    filtered_[0] = static_cast<std::uint8_t>(f);
    for (std::size_t i = 0; i < size_; ++i) {
      const std::size_t at = i + pixel_;  // rows begin with a pixel of zeros
      const auto x = static_cast<std::uint8_t>(row_[at] - png_prediction(f, row_[i], above_[at], above_[i]));
      filtered_[i + 1] = x;
      sum += x < 128 ? x : 256u - x;
    }
    if (sum >= least) return;
    least = sum;
    best_.swap(filtered_);
  }

 public:
  png_rows(std::size_t size, std::size_t pixel)
      : size_(size), pixel_(pixel), row_(size + pixel, 0), above_(size + pixel, 0), filtered_(size + 1),
        best_(size + 1) {}

  /// Where the bytes of the next row go.
  std::uint8_t* next() {
    row_.swap(above_);
    return row_.data() + pixel_;
  }

  const std::vector<std::uint8_t>& filtered() {
    std::size_t least = static_cast<std::size_t>(-1);
    for (int f = 0; f < 5; ++f) filter(f, least);
    return best_;
  }
};

inline std::vector<std::uint8_t> png_filtered(const image& picture) {
  const std::size_t pixel = picture.has_opacity() ? 4 : 3, size = picture.width() * pixel;
  std::vector<std::uint8_t> result;
  result.reserve((size + 1) * picture.height());
  png_rows rows(size, pixel);
  for (std::size_t y = 0; y < picture.height(); ++y) {
    std::uint8_t* to = rows.next();
    for (std::size_t x = 0; x < picture.width(); ++x) {
      for (const std::uint8_t b : srgb_bytes(picture(x, y))) *to++ = b;
      if (pixel == 4) *to++ = opacity_byte(picture.opacity(x, y));
    }
    const auto& row = rows.filtered();
    result.insert(result.end(), row.begin(), row.end());
  }
  return result;
}

}  // namespace detail

CONCINO_INLINE std::vector<std::uint8_t> png_bytes(const image& picture) {
  if (picture.width() == 0) throw invalid_argument("png_bytes: the picture has no pixels");
  std::vector<std::uint8_t> file = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'}, header;
  detail::append_number(header, picture.width());
  detail::append_number(header, picture.height());
  const std::uint8_t color_type = picture.has_opacity() ? 6 : 2;
  header.insert(header.end(), {8, color_type, 0, 0, 0});
  detail::append_chunk(file, "IHDR", header);
  detail::append_chunk(file, "sRGB", std::array<std::uint8_t, 1>{0});
  const std::vector<std::uint8_t> data = detail::deflated(detail::png_filtered(picture));
  constexpr std::size_t piece = std::size_t{1} << 24;  // a chunk must be shorter than 2^31 bytes
  for (std::size_t i = 0; i < data.size(); i += piece)
    detail::append_chunk(file, "IDAT", std::span(data).subspan(i, std::min(piece, data.size() - i)));
  detail::append_chunk(file, "IEND", {});
  return file;
}

CONCINO_INLINE void save_png(const image& picture, const std::string& path, const file_options& options) {
  if (picture.width() == 0) core::throw_joined<invalid_argument>({"save_png: ", path, ": the picture has no pixels"});
  atomic_file file(path, {.sync = options.sync});
  const std::vector<std::uint8_t> bytes = png_bytes(picture);
  text_sink out(file.descriptor(), path);
  out << std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  out.flush();
  file.commit();
}

}  // namespace concino
