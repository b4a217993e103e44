// The bytes of a file as one text: read into memory, or mapped (POSIX).
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/error.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace concino {

/// How file_text reads.
struct file_access {
  bool map = false;    // map files instead of reading them
  bool pipes = false;  // take pipes, which are read to their end
};

/// All bytes of a file: file_text(path).text(). Frees itself. An empty file has an empty text, and so has a pipe that nobody writes to: it is not waited for.
/// Errors: io_error if the path cannot be opened or read, is not a file (a directory, a device), or has another size when it is read than
///         when it was opened. A file that shrinks while it is mapped ends the program by SIGBUS where the text is read beyond its end.
class file_text {
  const char* data_ = nullptr;
  std::size_t size_ = 0;
  int mapped_ = -1;  // the descriptor, if the file is mapped

 public:
  file_text() = default;
  explicit file_text(const std::string& path, file_access access = {});
  /// What an open file holds from where it stands; `size` is what it said to hold, 0 if it did not say.
  file_text(int fd, const std::string& path, std::uint64_t size);

  file_text(file_text&& o) noexcept
      : data_(std::exchange(o.data_, nullptr)), size_(std::exchange(o.size_, 0)), mapped_(std::exchange(o.mapped_, -1)) {}
  file_text& operator=(file_text&& o) noexcept {
    std::swap(data_, o.data_);
    std::swap(size_, o.size_);
    std::swap(mapped_, o.mapped_);
    return *this;
  }
  ~file_text();

  std::string_view text() const { return {data_, size_}; }

  /// Lets the text go, which makes room for what was read from it.
  /// Errors: io_error if a file that is mapped has changed its size since.
  void close(const std::string& path);

 private:
  void read(int fd, const std::string& path, std::uint64_t size);
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/io/detail/file_text.ipp>
#endif
