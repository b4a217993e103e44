// PNG files through stb (Debian: libstb-dev).
#pragma once

#include <concino/error.hpp>
#include <concino/io/options.hpp>
#include <concino/io/replacing_file.hpp>
#include <concino/io/text_sink.hpp>
#include <concino/render/image.hpp>

#include <cassert>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

// stb's implementation is compiled into each translation unit, static and in a namespace of ours, so that any number of them can be
// linked together and beside a program's own copy of stb. Its macros are put back as they were.
#pragma push_macro("INCLUDE_STB_IMAGE_WRITE_H")
#pragma push_macro("STB_IMAGE_WRITE_IMPLEMENTATION")
#pragma push_macro("STB_IMAGE_WRITE_STATIC")
#pragma push_macro("STBIWDEF")
#undef INCLUDE_STB_IMAGE_WRITE_H
#undef STB_IMAGE_WRITE_IMPLEMENTATION
#undef STB_IMAGE_WRITE_STATIC
#undef STBIWDEF
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wcast-qual"
#endif
namespace concino::detail::stb {
#include <stb/stb_image_write.h>
}
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
#undef INCLUDE_STB_IMAGE_WRITE_H
#undef STB_IMAGE_WRITE_IMPLEMENTATION
#undef STB_IMAGE_WRITE_STATIC
#undef STBIWDEF
#pragma pop_macro("STBIWDEF")
#pragma pop_macro("STB_IMAGE_WRITE_STATIC")
#pragma pop_macro("STB_IMAGE_WRITE_IMPLEMENTATION")
#pragma pop_macro("INCLUDE_STB_IMAGE_WRITE_H")

namespace concino {

/// Writes a picture as an 8-bit sRGB PNG.
/// Result: the file at `path` is the old one or the whole new one, never a part.
/// Errors: invalid_argument if the picture is empty; io_error if the file cannot be written.
// Static because it calls stb's static functions: an inline function must not mean something else in each translation unit.
[[maybe_unused]] static inline void write_png(const image& picture, const std::string& path, const file_options& options = {}) {
  if (picture.width() == 0) detail::throw_joined<invalid_argument>({"write_png: ", path, ": the picture has no pixels"});
  const int width = static_cast<int>(picture.width()), height = static_cast<int>(picture.height());
  detail::replacing_file file(path, {.sync = options.sync});
  const std::vector<std::uint8_t> pixels = srgb_bytes(picture);
  int length = 0;
  unsigned char* const bytes = detail::stb::stbi_write_png_to_mem(pixels.data(), width * 3, width, height, 3, &length);
  const std::unique_ptr<unsigned char, decltype(&std::free)> png(bytes, &std::free);
  if (!png) detail::throw_joined<io_error>({"write_png: ", path, ": not enough memory to compress the picture"});
  detail::text_sink out(file.descriptor(), path);
  out << std::string_view(reinterpret_cast<const char*>(png.get()), static_cast<std::size_t>(length));
  out.flush();
  file.commit();
}

}  // namespace concino
