// The interface between compiled_bench and works.cpp, which is built twice: header-only, and with concino::compiled.
#pragma once

#include <string>
#include <vector>

namespace bench {

/// The works on the triangle mesh of one file, each with a name: "load", "harmonic", "heat.prepare", "heat.query".
struct works {
  virtual ~works() = default;
  virtual double seconds(const std::string& name) const = 0;              // CPU seconds of one run
  virtual std::vector<double> results(const std::string& name) const = 0;  // numbers that depend on the whole result
};

/// The name and the type of the only function that a module exports. It reads the mesh from this path and stores it.
inline constexpr const char* make_works_name = "concino_make_works";
using make_works = works*(const char* path);

}  // namespace bench
