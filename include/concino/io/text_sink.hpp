// Where writers put their text: a buffer that goes to a file, or stays a string. A file appears under its name only when it is complete.
#pragma once

#include <concino/io/mapped_file.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace concino::detail {

/// Text goes to a file descriptor in large pieces, or with none is kept.
class text_sink {
  static constexpr std::size_t piece = 1 << 18;
  std::string text_;
  std::size_t used_ = 0;
  int file_ = -1;
  std::string path_;

  char* room(std::size_t n) {
    if (text_.size() - used_ < n) make_room(n);
    return text_.data() + used_;
  }
  [[gnu::noinline]] void make_room(std::size_t n) {
    if (file_ >= 0) flush();
    if (text_.size() - used_ < n) text_.resize(std::max({piece, used_ + n, file_ < 0 ? 2 * text_.size() : 0}));
  }
  [[gnu::noinline]] text_sink& put(std::uint64_t i) {
    char* const p = room(24);
    used_ += static_cast<std::size_t>(std::to_chars(p, p + 24, i).ptr - p);
    return *this;
  }

 public:
  text_sink() = default;
  text_sink(int file, std::string path) : file_(file), path_(std::move(path)) {}

  [[gnu::noinline]] text_sink& operator<<(char c) {  // there are many, and the numbers between them take longer
    *room(1) = c;
    ++used_;
    return *this;
  }
  [[gnu::noinline]] text_sink& operator<<(std::string_view s) {
    std::memcpy(room(s.size()), s.data(), s.size());
    used_ += s.size();
    return *this;
  }
  text_sink& operator<<(const char* s) { return *this << std::string_view(s); }
  /// The shortest digits that read back as the same number.
  [[gnu::noinline]] text_sink& operator<<(double x) {
    char* const p = room(32);
    used_ += static_cast<std::size_t>(std::to_chars(p, p + 32, x).ptr - p);
    return *this;
  }
  template<std::integral I>
  text_sink& operator<<(I i) {
    return i < 0 ? (*this << '-').put(0 - static_cast<std::uint64_t>(i)) : put(static_cast<std::uint64_t>(i));
  }

  void flush() {
    for (std::size_t done = 0; done < used_;) {
      const ::ssize_t n = ::write(file_, text_.data() + done, used_ - done);
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) throw_io_error(path_, "cannot be written", errno);
      done += static_cast<std::size_t>(n);
    }
    used_ = 0;
  }

  std::string take() && {
    text_.resize(used_);
    return std::move(text_);
  }
};

/// A new file beside the target, which takes its place by commit(). Unless that succeeds the target stays as it was and the new file goes.
class replacing_file {
  std::string path_, target_, temporary_;
  int file_ = -1;

 public:
  /// Errors: io_error if no file can be made there, or what is there is not a file.
  [[gnu::noinline, gnu::cold]] explicit replacing_file(const std::string& path) : path_(path), target_(path) {
    // a link stays a link: what it points at is replaced
    if (char* const real = ::realpath(path.c_str(), nullptr)) {
      target_ = real;
      std::free(real);
    }
    struct ::stat old {};
    const bool exists = ::stat(target_.c_str(), &old) == 0;
    if (exists && S_ISDIR(old.st_mode)) throw_io_error(path_, "cannot be written", EISDIR);
    if (exists && !S_ISREG(old.st_mode)) throw_joined<io_error>({path_, ": is not a file"});
    if (exists && ::access(target_.c_str(), W_OK) != 0) throw_io_error(path_, "cannot be written", errno);
    for (int attempt = 0; file_ < 0; ++attempt) {
      temporary_ = joined({target_, ".tmp", static_cast<std::uint64_t>(::getpid()), "-", static_cast<std::uint64_t>(attempt)});
      file_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (file_ < 0 && (errno != EEXIST || attempt == 10000)) throw_io_error(path_, "cannot be written", errno);
    }
    if (exists) (void)!::fchmod(file_, old.st_mode & 07777);  // best effort: the new file is right without it
  }
  replacing_file(const replacing_file&) = delete;
  replacing_file& operator=(const replacing_file&) = delete;
  [[gnu::noinline, gnu::cold]] ~replacing_file() {
    if (file_ >= 0) ::close(file_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
  }

  int descriptor() const { return file_; }

  [[gnu::noinline, gnu::cold]] void commit() {
    const int closed = ::close(std::exchange(file_, -1));
    if (closed != 0) throw_io_error(path_, "cannot be written", errno);
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) throw_io_error(path_, "cannot be replaced", errno);
    temporary_.clear();
  }
};

}  // namespace concino::detail
