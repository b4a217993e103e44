// The floor of reading numbers from a file: the file is mapped into memory, loops read the digits of indices and short decimals, and std::from_chars the other
// numbers. Only the contents of the benchmark's own files are understood. Anything else is an error, so that a wrong file is noticed.
#pragma once

#include "buffer.hpp"

#include <charconv>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace bench::floors {

class mapped_file {
  const char* data_ = nullptr;
  std::size_t size_ = 0;

 public:
  explicit mapped_file(const std::string& path) {
    const int fd = ::open(path.c_str(), O_RDONLY);
    struct stat s = {};
    if (fd < 0 || ::fstat(fd, &s) != 0) throw std::runtime_error("floor: cannot open " + path);
    size_ = static_cast<std::size_t>(s.st_size);
    void* p = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE | MAP_POPULATE, fd, 0);
    ::close(fd);
    if (p == MAP_FAILED) throw std::runtime_error("floor: cannot map " + path);
    data_ = static_cast<const char*>(p);
  }
  mapped_file(const mapped_file&) = delete;
  mapped_file& operator=(const mapped_file&) = delete;
  ~mapped_file() { ::munmap(const_cast<char*>(data_), size_); }
  const char* begin() const { return data_; }
  const char* end() const { return data_ + size_; }
};

struct cursor {
  const char* at;
  const char* end;

  [[noreturn]] static void wrong() { throw std::runtime_error("floor: not a file of this benchmark"); }
  void spaces() { while (at != end && (*at == ' ' || *at == '\n')) ++at; }
  void blanks() { while (at != end && *at == ' ') ++at; }
  void line() {
    while (at != end && *at != '\n') ++at;
    if (at != end) ++at;
  }
  bool word(const char* w) {
    const char* p = at;
    for (; *w; ++w, ++p)
      if (p == end || *p != *w) return false;
    at = p;
    return true;
  }
  /// A decimal of up to 15 digits is one exact integer divided by one exact power of ten (Clinger 1990). std::from_chars reads all others.
  double real() {
    blanks();
    const char* p = at;
    const bool negative = p != end && *p == '-';
    p += negative;
    const char* first = p;
    std::uint64_t digits = 0;
    for (; p != end && static_cast<unsigned char>(*p - '0') < 10; ++p) digits = 10 * digits + static_cast<std::uint64_t>(*p - '0');
    const char* point = p;
    if (p != end && *p == '.')
      for (++p; p != end && static_cast<unsigned char>(*p - '0') < 10; ++p) digits = 10 * digits + static_cast<std::uint64_t>(*p - '0');
    if (p - first < 2 || p - first > 16 || (p != end && (*p == 'e' || *p == 'E'))) return slow_real();
    static constexpr double power[] = {1, 1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    at = p;
    const double x = static_cast<double>(digits) / power[p - point];
    return negative ? -x : x;
  }
  double slow_real() {
    double x = 0;
    const auto r = std::from_chars(at, end, x);
    if (r.ec != std::errc{}) wrong();
    at = r.ptr;
    return x;
  }
  bool digit() const { return at != end && static_cast<unsigned char>(*at - '0') < 10; }
  u32 natural() {
    blanks();
    if (!digit()) wrong();
    u32 x = 0;
    for (; digit(); ++at) x = 10 * x + static_cast<u32>(*at - '0');
    return x;
  }
};

}  // namespace bench::floors
