// The functions of stb that read pictures; stb_image.cpp has them. Their memory is that of stb_memory.
#pragma once

namespace concino::detail {

/// Finds the size and the number of channels; false if these bytes are no picture.
bool stb_info(const unsigned char* bytes, int size, int& width, int& height, int& channels);

/// The pixels, row by row, with `wanted` bytes each; null if the picture is damaged.
const unsigned char* stb_load(const unsigned char* bytes, int size, int& width, int& height, int& channels, int wanted);

/// Why stb failed last in this thread, or null.
const char* stb_failure_reason();

}  // namespace concino::detail
