// The bytes of a file, mapped into memory rather than copied (POSIX).
#pragma once

#include <concino/detail/message.hpp>
#include <concino/error.hpp>

#include <cerrno>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace concino::detail {

[[noreturn, gnu::noinline, gnu::cold]] inline void throw_io_error(const std::string& path, const char* what, int error_number) {
  throw_joined<io_error>({path, ": ", what, ": ", std::strerror(error_number)});
}

/// Unmaps itself. An empty file has an empty text.
/// Errors: io_error if the path cannot be opened or read, or is not a file (a directory, a pipe).
class mapped_file {
  const char* data_ = nullptr;
  std::size_t size_ = 0;

 public:
  mapped_file() = default;
  [[gnu::noinline, gnu::cold]] explicit mapped_file(const std::string& path) {
    // Without O_NONBLOCK opening a pipe that nobody writes to would wait for ever.
    const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (fd < 0) throw_io_error(path, "cannot be opened", errno);
    struct ::stat info {};
    int failed = ::fstat(fd, &info) != 0 ? errno : 0;
    if (!failed && S_ISDIR(info.st_mode)) failed = EISDIR;
    if (!failed && !S_ISREG(info.st_mode)) {
      ::close(fd);
      throw_joined<io_error>({path, ": is not a file"});
    }
    if (!failed && info.st_size > 0) {
      size_ = static_cast<std::size_t>(info.st_size);
      void* p = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, fd, 0);
      if (p == MAP_FAILED) failed = errno;
      else data_ = static_cast<const char*>(p);
      if (data_) ::madvise(p, size_, MADV_SEQUENTIAL);
    }
    ::close(fd);
    if (failed) throw_io_error(path, "cannot be read", failed);
  }
  mapped_file(mapped_file&& o) noexcept : data_(std::exchange(o.data_, nullptr)), size_(std::exchange(o.size_, 0)) {}
  mapped_file& operator=(mapped_file&& o) noexcept {
    std::swap(data_, o.data_);
    std::swap(size_, o.size_);
    return *this;
  }
  ~mapped_file() {
    if (data_) ::munmap(const_cast<char*>(data_), size_);
  }

  std::string_view text() const { return {data_, size_}; }
};

}  // namespace concino::detail
