// What compiled_bench asks of works.cpp, which is built twice: header-only, and with concino::compiled.
#pragma once

#include <string>
#include <vector>

namespace bench {

/// Works on the triangle mesh in one file, each by its name: "load", "harmonic", "heat.prepare", "heat.query".
struct works {
  virtual ~works() = default;
  virtual double seconds(const std::string& name) const = 0;              // CPU seconds of one run
  virtual std::vector<double> results(const std::string& name) const = 0;  // numbers that depend on all that the work finds
};

/// The name and the type of the only function that a module exports: it reads the mesh from this path and keeps it.
inline constexpr const char* make_works_name = "concino_make_works";
using make_works = works*(const char* path);

}  // namespace bench
