// Definitions of file_text.hpp.
#pragma once

#include <concino/core/message.hpp>
#include <concino/io/detail/files/io_errors.hpp>
#include <concino/io/file_text.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace concino {

CONCINO_INLINE file_text::file_text(const std::string& path, file_access access) : file_text() {
  struct open_file {
    int fd;
    ~open_file() {
      if (fd >= 0) ::close(fd);
    }
  };
  // Without O_NONBLOCK, opening a pipe without a writer would block for ever.
  open_file file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
  if (file.fd < 0) detail::throw_io_error(path, "cannot be opened", errno);
  struct ::stat info {};
  if (::fstat(file.fd, &info) != 0) detail::throw_io_error(path, "cannot be read", errno);
  if (S_ISDIR(info.st_mode)) detail::throw_io_error(path, "cannot be read", EISDIR);
  if (S_ISFIFO(info.st_mode) && access.pipes) {
    if (::fcntl(file.fd, F_SETFL, O_RDONLY) != 0) detail::throw_io_error(path, "cannot be read", errno);
    read(file.fd, path, 0);
  } else if (!S_ISREG(info.st_mode)) {
    core::throw_joined<io_error>({path, ": is not a regular file"});
  } else if (!access.map || info.st_size == 0) {
    read(file.fd, path, static_cast<std::uint64_t>(info.st_size));
  } else {
    void* const p = ::mmap(nullptr, static_cast<std::size_t>(info.st_size), PROT_READ, MAP_PRIVATE, file.fd, 0);
    if (p == MAP_FAILED) detail::throw_io_error(path, "cannot be mapped", errno);
    data_ = static_cast<const char*>(p);
    size_ = static_cast<std::size_t>(info.st_size);
    mapped_ = std::exchange(file.fd, -1);
  }
}

CONCINO_INLINE file_text::file_text(int fd, const std::string& path, std::uint64_t size) : file_text() { read(fd, path, size); }

CONCINO_INLINE file_text::~file_text() {
  if (mapped_ < 0) {
    std::free(const_cast<char*>(data_));
  } else {
    ::munmap(const_cast<char*>(data_), size_);
    ::close(mapped_);
  }
}

CONCINO_INLINE void file_text::close(const std::string& path) {
  const file_text old = std::move(*this);
  *this = file_text();
  if (old.mapped_ < 0) return;
  struct ::stat info {};
  if (::fstat(old.mapped_, &info) != 0) detail::throw_io_error(path, "cannot be read", errno);
  const auto now = static_cast<std::size_t>(info.st_size);
  if (now != old.size_) detail::throw_size_changed(path, now > old.size_);
}

CONCINO_INLINE void file_text::read(int fd, const std::string& path, std::uint64_t size) {
  std::size_t room = 0;
  const auto make_room = [&](std::size_t n) {
    void* const p = std::realloc(const_cast<char*>(data_), n);
    if (!p) throw std::bad_alloc();
    data_ = static_cast<const char*>(p);
    room = n;
  };
  if (size >= SIZE_MAX) throw std::bad_alloc();
  make_room(size ? static_cast<std::size_t>(size) + 1 : 1 << 16);  // one more byte, to notice that a file has grown
  for (;;) {
    if (size_ == room) {
      if (size) detail::throw_size_changed(path, true);
      make_room(2 * room);
    }
    const ::ssize_t n = ::read(fd, const_cast<char*>(data_) + size_, std::min<std::size_t>(room - size_, 1 << 30));
    if (n < 0 && errno != EINTR) detail::throw_io_error(path, "cannot be read", errno);
    if (n == 0) break;
    if (n > 0) size_ += static_cast<std::size_t>(n);
  }
  if (size_ < size) detail::throw_size_changed(path, false);
}

}  // namespace concino
