// The functions of stb_image.h that read PNG, JPEG, BMP and TGA files, compiled once into the library of concino::stb,
// without warnings. They are static, so a program may have its own copy of stb. The other formats of stb_image.h are
// left out: its authors do not claim that reading them is safe.
#include <concino/adapters/detail/stb_image_functions.hpp>
#include <concino/adapters/detail/stb_memory.hpp>
#include <concino/core/error.hpp>

#include <cassert>
#include <climits>
#include <cmath>
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_JPEG
#define STBI_ONLY_PNG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_SIMD
#define STBI_MAX_DIMENSIONS 65535
#define STBI_ASSERT(x) ((x) ? void() : throw ::concino::error("stb_image: an assertion failed"))
#define STBI_MALLOC(size) ::concino::detail::stb_memory::resized(nullptr, size)
#define STBI_REALLOC(p, size) ::concino::detail::stb_memory::resized(p, size)
#define STBI_FREE(p) ::concino::detail::stb_memory::free(p)
#if defined(__clang__)
// The colours of damaged JPEG files may overflow, which gives other wrong colours.
#pragma clang attribute push(__attribute__((no_sanitize("signed-integer-overflow", "shift"))), apply_to = function)
#endif
namespace concino::detail::stb {
// stb copies no bytes from or to null, which the standard library does not allow.
[[maybe_unused]] static inline void* memcpy(void* to, const void* from, std::size_t size) {
  return size > 0 ? std::memcpy(to, from, size) : to;
}
#include <stb/stb_image.h>
}
#if defined(__clang__)
#pragma clang attribute pop
#endif

namespace concino::detail {

bool stb_info(const unsigned char* bytes, int size, int& width, int& height, int& channels) {
  return stb::stbi_info_from_memory(bytes, size, &width, &height, &channels) != 0;
}

const unsigned char* stb_load(const unsigned char* bytes, int size, int& width, int& height, int& channels,
                              int wanted) {
  return stb::stbi_load_from_memory(bytes, size, &width, &height, &channels, wanted);
}

const char* stb_failure_reason() { return stb::stbi_failure_reason(); }

}  // namespace concino::detail
