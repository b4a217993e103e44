// Where writers put their text: a buffer that goes to a file, or stays a string.
#pragma once

#include <concino/io/detail/io_errors.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>

#include <unistd.h>

namespace concino {

/// Text goes to a file descriptor in large pieces, or with none is kept.
///
///   atomic_file file(path);
///   text_sink out(file.descriptor(), path);
///   out << "verts " << 3 << '\n' << 0.5;
///   out.flush();
///   file.commit();
///
/// Errors: io_error where the file cannot be written; `path` is what messages call it.
class text_sink {
  static constexpr std::size_t piece = 1 << 18;
  std::string text_;
  std::size_t used_ = 0;
  int file_ = -1;
  std::string path_;

  char* reserve(std::size_t n) {
    if (text_.size() - used_ < n) grow(n);
    return text_.data() + used_;
  }
  [[gnu::noinline]] void grow(std::size_t n) {
    if (file_ >= 0) flush();
    if (text_.size() - used_ < n) text_.resize(std::max({piece, used_ + n, file_ < 0 ? 2 * text_.size() : 0}));
  }
  [[gnu::noinline]] text_sink& put(std::uint64_t i) {
    char* const p = reserve(24);
    used_ += static_cast<std::size_t>(std::to_chars(p, p + 24, i).ptr - p);
    return *this;
  }

 public:
  text_sink() = default;
  text_sink(int file, std::string path) : file_(file), path_(std::move(path)) {}

  [[gnu::noinline]] text_sink& operator<<(char c) {  // there are many, and the numbers between them take longer
    *reserve(1) = c;
    ++used_;
    return *this;
  }
  [[gnu::noinline]] text_sink& operator<<(std::string_view s) {
    std::memcpy(reserve(s.size()), s.data(), s.size());
    used_ += s.size();
    return *this;
  }
  text_sink& operator<<(const char* s) { return *this << std::string_view(s); }
  /// The shortest digits that read back as the same number.
  [[gnu::noinline]] text_sink& operator<<(double x) {
    char* const p = reserve(32);
    used_ += static_cast<std::size_t>(std::to_chars(p, p + 32, x).ptr - p);
    return *this;
  }
  template<std::integral I>
  text_sink& operator<<(I i) {
    return i < 0 ? (*this << '-').put(0 - static_cast<std::uint64_t>(i)) : put(static_cast<std::uint64_t>(i));
  }

  /// Brings what is left to the file. Needs: a descriptor.
  void flush() {
    for (std::size_t done = 0; done < used_;) {
      const ::ssize_t n = ::write(file_, text_.data() + done, used_ - done);
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) detail::throw_io_error(path_, "cannot be written", errno);
      done += static_cast<std::size_t>(n);
    }
    used_ = 0;
  }

  /// All that was written. Needs: no descriptor.
  std::string release() && {
    text_.resize(used_);
    return std::move(text_);
  }
};

}  // namespace concino
