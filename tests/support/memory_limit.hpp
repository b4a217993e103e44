// Limits the memory of a test.
#pragma once

#include <sys/resource.h>

#include <cstddef>
#include <fstream>
#include <string>

namespace concino::testing {

/// While it exists, memory beyond what the program has now and `more` bytes cannot be allocated: std::bad_alloc. The address sanitizer reserves
/// addresses beyond any limit, so with it, only was_exceeded() tells.
class memory_limit {
  ::rlimit before_{};
  std::size_t most_;  // resident memory

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define CONCINO_TEST_LIMITS_ADDRESSES 0
#endif
#endif
#ifndef CONCINO_TEST_LIMITS_ADDRESSES
#define CONCINO_TEST_LIMITS_ADDRESSES 1
#endif
  static constexpr bool limits_addresses = CONCINO_TEST_LIMITS_ADDRESSES;
#undef CONCINO_TEST_LIMITS_ADDRESSES

  /// A number of kB in /proc/self/status, as bytes; 0 if it is not there.
  static std::size_t status(const std::string& name) {
    std::ifstream in("/proc/self/status");
    for (std::string word; in >> word;)
      if (word == name + ':') {
        std::size_t kb = 0;
        in >> kb;
        return kb << 10;
      }
    return 0;
  }

 public:
  explicit memory_limit(std::size_t more) : most_(status("VmHWM") + more) {
    ::getrlimit(RLIMIT_AS, &before_);
    if (!limits_addresses) return;
    ::rlimit limit = before_;
    limit.rlim_cur = status("VmSize") + more;
    ::setrlimit(RLIMIT_AS, &limit);
  }
  memory_limit(const memory_limit&) = delete;
  memory_limit& operator=(const memory_limit&) = delete;
  ~memory_limit() { ::setrlimit(RLIMIT_AS, &before_); }

  /// Whether the program has had more memory in use than allowed.
  bool was_exceeded() const { return status("VmHWM") > most_; }
};

}  // namespace concino::testing
