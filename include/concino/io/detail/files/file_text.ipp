// Bodies of file_text.hpp: the bytes of a file as one string: read into memory, or mapped (POSIX).
#pragma once

#include <concino/core/message.hpp>
#include <concino/io/detail/files/io_errors.hpp>
#include <concino/io/detail/files/system_files.hpp>
#include <concino/io/file_text.hpp>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <utility>

namespace concino {

CONCINO_INLINE file_text::file_text(const std::string& path, file_access access) : file_text() {
  detail::open_file file(detail::open_to_read(path));
  if (!file.is_open()) detail::throw_io_error(path, "cannot be opened", errno);
  const detail::file_status status = detail::status_of(file.handle(), path);
  if (status.kind == detail::file_kind::none) detail::throw_io_error(path, "cannot be read", errno);
  if (status.kind == detail::file_kind::folder) detail::throw_io_error(path, "cannot be read", EISDIR);
  if (status.kind == detail::file_kind::pipe && access.pipes) {
    if (!detail::wait_for_writer(file.handle())) detail::throw_io_error(path, "cannot be read", errno);
    read(file.handle(), path, 0);
  } else if (status.kind != detail::file_kind::regular) {
    core::throw_joined<io_error>({path, ": is not a regular file"});
  } else if (!access.map || status.size == 0 || !detail::can_map_files) {
    read(file.handle(), path, status.size);
  } else {
    data_ = detail::map_file(file.handle(), static_cast<std::size_t>(status.size));
    if (!data_) detail::throw_io_error(path, "cannot be mapped", errno);
    size_ = static_cast<std::size_t>(status.size);
    mapped_ = file.release();
  }
}

CONCINO_INLINE file_text::file_text(detail::file_handle file, const std::string& path, std::uint64_t size)
    : file_text() {
  read(file, path, size);
}

CONCINO_INLINE file_text::~file_text() {
  if (mapped_ == detail::no_file) {
    std::free(const_cast<char*>(data_));
  } else {
    detail::unmap_file(data_, size_);
    detail::close_file(mapped_);
  }
}

CONCINO_INLINE void file_text::close(const std::string& path) {
  const file_text old = std::move(*this);
  *this = file_text();
  if (old.mapped_ == detail::no_file) return;
  const detail::file_status now = detail::status_of(old.mapped_, path);
  if (now.kind == detail::file_kind::none) detail::throw_io_error(path, "cannot be read", errno);
  if (now.size != old.size_) detail::throw_size_changed(path, now.size > old.size_);
}

CONCINO_INLINE void file_text::read(detail::file_handle file, const std::string& path, std::uint64_t size) {
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
    const std::ptrdiff_t n = detail::read_some(file, const_cast<char*>(data_) + size_, room - size_);
    if (n < 0) detail::throw_io_error(path, "cannot be read", errno);
    if (n == 0) break;
    size_ += static_cast<std::size_t>(n);
  }
  if (size_ < size) detail::throw_size_changed(path, false);
}

}  // namespace concino
