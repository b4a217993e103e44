// Compression of bytes in the zlib format (RFC 1950 and 1951), which PNG files contain.
#pragma once

#include <concino/core/compiled.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// Compressed bytes that zlib expands to `bytes`.
std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/render/detail/image/deflate.ipp>
#endif
