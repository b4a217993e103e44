// PNG files: a picture as the bytes of one, and written to disk. No other library is needed.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/options.hpp>
#include <concino/render/image.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace concino {

/// A picture as the bytes of a PNG file: 8 bits a component, sRGB, with a channel of opacities if the picture has them.
/// Needs:  a picture of at least one pixel.
/// Result: the same bytes on every run.
/// Cost:   O(pixels) time and memory, in the calling thread.
/// Errors: invalid_argument if the picture has no pixels.
/// Source: PNG 1.2 (ISO 15948), each row with the filter of least absolute sum; deflate of RFC 1951 with Huffman codes
///         of its own.
std::vector<std::uint8_t> png_bytes(const image& picture);

/// Writes a picture as a PNG file, as png_bytes.
/// Needs:  as png_bytes.
/// Result: the file at `path` is the old one or the whole new one, never a part.
/// Cost:   as png_bytes.
/// Errors: as png_bytes; io_error if the file cannot be written.
void save_png(const image& picture, const std::string& path, const file_options& options = {});

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/render/detail/image/png.ipp>
#endif
