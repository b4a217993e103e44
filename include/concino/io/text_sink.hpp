// Buffered output of text, to a file or to a string.
#pragma once

#include <concino/io/detail/files/io_errors.hpp>
#include <concino/io/detail/files/system_files.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

namespace concino {

/// A buffer for text. It writes to a file in large pieces; without a file it keeps the text, or discards it.
///
///   atomic_file file(path);
///   text_sink out(file.descriptor(), path);
///   out << "verts " << 3 << '\n' << 0.5;
///   out.flush();
///   file.commit();
///
/// Errors: io_error if the file cannot be written; messages call it `path`.
class text_sink {
  static constexpr std::size_t piece = 1 << 18;
  std::string text_;
  std::size_t used_ = 0;
  enum class target { memory, file, nowhere };
  target target_ = target::memory;
  detail::file_handle file_ = detail::no_file;
  std::string path_;

  char* reserve(std::size_t n) {
    if (text_.size() - used_ < n) grow(n);
    return text_.data() + used_;
  }
  void grow(std::size_t n) {
    if (target_ != target::memory) flush();
    if (text_.size() - used_ < n)
      text_.resize(std::max({piece, used_ + n, target_ == target::memory ? 2 * text_.size() : 0}));
  }
  text_sink& put(std::uint64_t i) {
    char* const p = reserve(24);
    used_ += static_cast<std::size_t>(std::to_chars(p, p + 24, i).ptr - p);
    return *this;
  }

 public:
  text_sink() = default;
  /// A sink that writes to an open file, the descriptor() of an atomic_file.
  text_sink(detail::file_handle file, std::string path) : target_(target::file), file_(file), path_(std::move(path)) {}
  /// A sink that discards what is written to it.
  static text_sink nowhere() {
    text_sink sink;
    sink.target_ = target::nowhere;
    return sink;
  }

  /// Makes room for n bytes, so that a text in memory takes no more.
  void expect(std::size_t n) { reserve(n); }

  text_sink& operator<<(char c) {  // not inlined: there are many calls, and the numbers between them take longer
    *reserve(1) = c;
    ++used_;
    return *this;
  }
  text_sink& operator<<(std::string_view s) {
    std::memcpy(reserve(s.size()), s.data(), s.size());
    used_ += s.size();
    return *this;
  }
  text_sink& operator<<(const char* s) { return *this << std::string_view(s); }
  /// Writes the shortest decimal number that reads back as the same double.
  text_sink& operator<<(double x) {
    char* const p = reserve(32);
    used_ += static_cast<std::size_t>(std::to_chars(p, p + 32, x).ptr - p);
    return *this;
  }
  template<std::integral I>
  text_sink& operator<<(I i) {
    return i < 0 ? (*this << '-').put(0 - static_cast<std::uint64_t>(i)) : put(static_cast<std::uint64_t>(i));
  }

  /// Writes the rest of the buffer to the file. A text without a file stays as it is.
  void flush() {
    if (target_ == target::memory) return;
    if (target_ == target::file && !detail::write_all(file_, text_.data(), used_))
      detail::throw_io_error(path_, "cannot be written", errno);
    used_ = 0;
  }

  /// Moves the text out of the buffer. Needs: no file.
  std::string release() && {
    text_.resize(used_);
    return std::move(text_);
  }
};

}  // namespace concino
