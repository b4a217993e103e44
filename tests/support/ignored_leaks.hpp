// Leaks that the address sanitizer must not report: those of other libraries when memory runs out.
#pragma once

extern "C" {
[[gnu::weak]] void __lsan_disable();
[[gnu::weak]] void __lsan_enable();
}

namespace concino::testing {

/// What is allocated while it exists may leak.
struct ignored_leaks {
  ignored_leaks() {
    if (__lsan_disable) __lsan_disable();
  }
  ignored_leaks(const ignored_leaks&) = delete;
  ignored_leaks& operator=(const ignored_leaks&) = delete;
  ~ignored_leaks() {
    if (__lsan_enable) __lsan_enable();
  }
};

}  // namespace concino::testing
