// What a profiler has measured.
#pragma once

#include <concino/core/profiler.hpp>

#include <string>
#include <vector>

namespace concino::testing {

/// The names of entries, each with a dash for every scope around it.
inline std::vector<std::string> names_of(const profiler& p) {
  std::vector<std::string> names;
  for (const auto& e : p.entries()) names.push_back(std::string(e.depth, '-') + e.name);
  return names;
}

}  // namespace concino::testing
