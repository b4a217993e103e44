// Sets the number of threads of parallel loops.
#pragma once

#include <cstdlib>
#include <string>

namespace concino::testing {

/// Sets the number of threads of parallel loops during its lifetime.
class with_num_threads {
  std::string before_;
  bool was_set_ = false;

 public:
  explicit with_num_threads(int n) {
    if (const char* const text = std::getenv("CONCINO_NUM_THREADS")) {
      before_ = text;
      was_set_ = true;
    }
    ::setenv("CONCINO_NUM_THREADS", std::to_string(n).c_str(), 1);
  }
  with_num_threads(const with_num_threads&) = delete;
  with_num_threads& operator=(const with_num_threads&) = delete;
  ~with_num_threads() {
    if (was_set_) ::setenv("CONCINO_NUM_THREADS", before_.c_str(), 1);
    else ::unsetenv("CONCINO_NUM_THREADS");
  }
};

}  // namespace concino::testing
