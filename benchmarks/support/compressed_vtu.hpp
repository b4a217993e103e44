// Compresses the appended arrays of a .vtu file as VTK does, in blocks of 32 KiB.
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

#include <zlib.h>

namespace bench {

inline std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  if (compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size())) != Z_OK)
    throw std::runtime_error("zlib cannot compress");
  out.resize(size);
  return out;
}

/// A compressed array: the number of blocks, their size, the size of the last one if it is smaller, their compressed sizes, the blocks.
inline std::string in_blocks(std::string_view bytes) {
  constexpr std::size_t block = 32768;
  std::string sizes, data;
  const auto add = [&](std::size_t n) {
    const auto word = static_cast<std::uint32_t>(n);
    sizes.append(reinterpret_cast<const char*>(&word), 4);
  };
  add((bytes.size() + block - 1) / block);
  add(block);
  add(bytes.size() % block);
  for (std::size_t i = 0; i < bytes.size(); i += block) {
    const std::string one = deflated(bytes.substr(i, block));
    add(one.size());
    data += one;
  }
  return sizes + data;
}

/// Calls array(offset in the tags, bytes) for each array of a .vtu file that save_text writes with .binary.
template<class F>
void for_each_array(const std::string& text, F&& array) {
  const std::string before_data = "<AppendedData encoding=\"raw\">\n_", before_offset = " offset=\"";
  const std::size_t tags_end = text.find(before_data), data = tags_end + before_data.size();
  for (std::size_t at = text.find(before_offset); at < tags_end; at = text.find(before_offset, at + 1)) {
    const std::size_t digits = at + before_offset.size(), begin = data + std::stoull(text.substr(digits, 20));
    std::uint32_t size = 0;
    std::memcpy(&size, text.data() + begin, 4);
    array(digits, std::string_view(text).substr(begin + 4, size));
  }
}

/// The same file, compressed.
inline std::string compressed(const std::string& text) {
  std::string tags, data;
  std::size_t from = 0;
  for_each_array(text, [&](std::size_t digits, std::string_view bytes) {
    tags.append(text, from, digits - from).append(std::to_string(data.size()));
    from = text.find('"', digits);
    data += in_blocks(bytes);
  });
  tags.append(text, from, text.find('_', from) + 1 - from);
  const std::string header = " header_type=";
  tags.insert(tags.find(header), " compressor=\"vtkZLibDataCompressor\"");
  return tags + data + "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace bench
