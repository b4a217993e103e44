// Adapter for PNG files through stb.
// Needs: stb (Debian: libstb-dev).
#pragma once

#include <concino/core/error.hpp>
#include <concino/io/atomic_file.hpp>
#include <concino/io/options.hpp>
#include <concino/io/text_sink.hpp>
#include <concino/render/image.hpp>

#include <cassert>
#include <cmath>
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace concino::detail {

/// Owns the memory that stb allocates in this thread during the lifetime of this object. Without memory, stb would leak or write to null; here
/// std::bad_alloc is thrown out of stb, and the destructor frees what stb holds then.
class stb_memory {
  struct alignas(std::max_align_t) block {
    block *before, *after;
    void join() { before->after = after->before = this; }
  };
  block ring_{&ring_, &ring_};
  stb_memory* const outer_ = std::exchange(current(), this);

  // A pointer for the thread, since stb's functions cannot pass one on.
  static stb_memory*& current() {
    static thread_local stb_memory* memory = nullptr;
    return memory;
  }

 public:
  stb_memory() = default;
  stb_memory(const stb_memory&) = delete;
  stb_memory& operator=(const stb_memory&) = delete;
  ~stb_memory() {
    while (ring_.after != &ring_) free(ring_.after + 1);
    current() = outer_;
  }

  /// Resizes p, or allocates memory if p is null.
  static void* resized(void* p, std::size_t size) {
    block* const old = p ? static_cast<block*>(p) - 1 : nullptr;
    auto* const b = size > SIZE_MAX / 2 ? nullptr : static_cast<block*>(std::realloc(old, sizeof(block) + size));
    if (!b) throw std::bad_alloc();
    if (!old) *b = {current()->ring_.before, &current()->ring_};
    b->join();
    return b + 1;
  }
  static void free(void* p) {
    if (!p) return;
    block* const b = static_cast<block*>(p) - 1;
    b->before->after = b->after;
    b->after->before = b->before;
    std::free(b);
  }
};

}  // namespace concino::detail

// stb's implementation is compiled into each translation unit, static and in a namespace of this library. So any number of them can be
// linked together, and with a program's own copy of stb. Its macros are restored afterwards.
#pragma push_macro("INCLUDE_STB_IMAGE_WRITE_H")
#pragma push_macro("STB_IMAGE_WRITE_IMPLEMENTATION")
#pragma push_macro("STB_IMAGE_WRITE_STATIC")
#pragma push_macro("STBIWDEF")
#pragma push_macro("STBIW_MALLOC")
#pragma push_macro("STBIW_REALLOC")
#pragma push_macro("STBIW_REALLOC_SIZED")
#pragma push_macro("STBIW_FREE")
#pragma push_macro("STBIW_MEMMOVE")
#pragma push_macro("STBIW_ASSERT")
#pragma push_macro("STBIW_UCHAR")
#pragma push_macro("STBIW_ZLIB_COMPRESS")
#pragma push_macro("STBIW_CRC32")
#undef INCLUDE_STB_IMAGE_WRITE_H
#undef STB_IMAGE_WRITE_IMPLEMENTATION
#undef STB_IMAGE_WRITE_STATIC
#undef STBIWDEF
#undef STBIW_MALLOC
#undef STBIW_REALLOC
#undef STBIW_REALLOC_SIZED
#undef STBIW_FREE
#undef STBIW_MEMMOVE
#undef STBIW_ASSERT
#undef STBIW_UCHAR
#undef STBIW_ZLIB_COMPRESS
#undef STBIW_CRC32
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBIW_MALLOC(size) ::concino::detail::stb_memory::resized(nullptr, size)
#define STBIW_REALLOC(p, size) ::concino::detail::stb_memory::resized(p, size)
#define STBIW_FREE(p) ::concino::detail::stb_memory::free(p)
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
#undef STBIW_MALLOC
#undef STBIW_REALLOC
#undef STBIW_REALLOC_SIZED
#undef STBIW_FREE
#undef STBIW_MEMMOVE
#undef STBIW_ASSERT
#undef STBIW_UCHAR
#undef STBIW_ZLIB_COMPRESS
#undef STBIW_CRC32
#pragma pop_macro("STBIW_CRC32")
#pragma pop_macro("STBIW_ZLIB_COMPRESS")
#pragma pop_macro("STBIW_UCHAR")
#pragma pop_macro("STBIW_ASSERT")
#pragma pop_macro("STBIW_MEMMOVE")
#pragma pop_macro("STBIW_FREE")
#pragma pop_macro("STBIW_REALLOC_SIZED")
#pragma pop_macro("STBIW_REALLOC")
#pragma pop_macro("STBIW_MALLOC")
#pragma pop_macro("STBIWDEF")
#pragma pop_macro("STB_IMAGE_WRITE_STATIC")
#pragma pop_macro("STB_IMAGE_WRITE_IMPLEMENTATION")
#pragma pop_macro("INCLUDE_STB_IMAGE_WRITE_H")

namespace concino {

/// Writes a picture as an 8-bit sRGB PNG.
/// Needs:  a picture of at least one pixel.
/// Result: the file at `path` is the old one or the whole new one, never a part.
/// Cost:   O(pixels) time and memory, in the calling thread.
/// Errors: invalid_argument if the picture is empty; unsupported if its bytes are more than 1 GiB, some 350 million pixels; io_error if the file
///         cannot be written.
// Static because it calls stb's static functions: an inline function must be the same in each translation unit.
[[maybe_unused]] static inline void write_png(const image& picture, const std::string& path, const file_options& options = {}) {
  if (picture.width() == 0) core::throw_joined<invalid_argument>({"write_png: ", path, ": the picture has no pixels"});
  // stb counts bytes by int, and allocates twice as many.
  if ((3 * picture.width() + 1) * picture.height() > std::size_t{1} << 30)
    core::throw_joined<unsupported>({"write_png: ", path, ": ", picture.width(), " x ", picture.height(), " pixels are more than 1 GiB"});
  const int width = static_cast<int>(picture.width()), height = static_cast<int>(picture.height());
  atomic_file file(path, {.sync = options.sync});
  const std::vector<std::uint8_t> pixels = srgb_bytes(picture);
  const detail::stb_memory memory;
  int length = 0;
  const unsigned char* const png = detail::stb::stbi_write_png_to_mem(pixels.data(), width * 3, width, height, 3, &length);
  text_sink out(file.descriptor(), path);
  out << std::string_view(reinterpret_cast<const char*>(png), static_cast<std::size_t>(length));
  out.flush();
  file.commit();
}

}  // namespace concino
