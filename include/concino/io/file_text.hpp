// The bytes of a file as one string: read into memory, or mapped where the system is POSIX.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/error.hpp>
#include <concino/io/detail/files/system_files.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace concino {

/// Options of file_text.
struct file_access {
  bool map = false;    // map files instead of reading them; no effect where the system is not POSIX
  bool pipes = false;  // accept pipes, and read them to their end
};

/// All bytes of a file: file_text(path).text(). The destructor frees them. The text of an empty file is empty, and so
/// is that of a pipe without a writer: reading does not wait for one.
/// Errors: io_error if the path cannot be opened or read, is not a file (a directory, a device), or has another size
///         when it is read than when it was opened. If a file shrinks while it is mapped, reading the text beyond its
///         end terminates the program by SIGBUS. Where the system is not POSIX, opening a pipe waits for a writer.
class file_text {
  const char* data_ = nullptr;
  std::size_t size_ = 0;
  detail::file_handle mapped_ = detail::no_file;  // the file, if it is mapped

 public:
  file_text() = default;
  explicit file_text(const std::string& path, file_access access = {});
  /// Reads an open file, a descriptor (int) on POSIX systems and a std::FILE* on others, from its current position.
  /// `size` is the size that the system reported, 0 if unknown.
  file_text(detail::file_handle file, const std::string& path, std::uint64_t size);

  file_text(file_text&& o) noexcept
      : data_(std::exchange(o.data_, nullptr)), size_(std::exchange(o.size_, 0)),
        mapped_(std::exchange(o.mapped_, detail::no_file)) {}
  file_text& operator=(file_text&& o) noexcept {
    std::swap(data_, o.data_);
    std::swap(size_, o.size_);
    std::swap(mapped_, o.mapped_);
    return *this;
  }
  ~file_text();

  std::string_view text() const { return {data_, size_}; }

  /// Frees the text, so that its memory can be used for the mesh.
  /// Errors: io_error if a mapped file has changed its size since it was opened.
  void close(const std::string& path);

 private:
  void read(detail::file_handle file, const std::string& path, std::uint64_t size);
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/io/detail/files/file_text.ipp>
#endif
