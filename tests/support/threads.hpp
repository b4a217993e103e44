// Sets the number of threads of parallel loops.
#pragma once

#include <cstdlib>
#include <string>

namespace concino::testing {

/// Sets the number of threads of parallel loops during its lifetime.
class with_num_threads {
  std::string before_;
  bool was_set_ = false;

#ifdef _WIN32
  static void set(const char* text) { ::_putenv_s("CONCINO_NUM_THREADS", text ? text : ""); }
#else
  static void set(const char* text) { text ? ::setenv("CONCINO_NUM_THREADS", text, 1) : ::unsetenv("CONCINO_NUM_THREADS"); }
#endif

 public:
  explicit with_num_threads(int n) {
    if (const char* const text = std::getenv("CONCINO_NUM_THREADS")) {
      before_ = text;
      was_set_ = true;
    }
    set(std::to_string(n).c_str());
  }
  with_num_threads(const with_num_threads&) = delete;
  with_num_threads& operator=(const with_num_threads&) = delete;
  ~with_num_threads() { set(was_set_ ? before_.c_str() : nullptr); }
};

}  // namespace concino::testing
