// Measures concino::compiled against header-only use: loading, a harmonic map and heat geodesics on the bunny, with the default solver. Each variant is a
// module of its own, because in one program the linker would use one definition for both. Both are built from one file with the flags of the compiled library.
// These do not include -march=native, with which the library would have to be built too.
#include "works.hpp"

#include "../support/program.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include <dlfcn.h>

namespace {

std::unique_ptr<bench::works> open(const char* module, const std::string& path) {
  void* const library = ::dlopen(module, RTLD_NOW | RTLD_LOCAL);  // stays loaded as long as the program runs
  if (!library) throw std::runtime_error(::dlerror());
  const auto make = reinterpret_cast<bench::make_works*>(::dlsym(library, bench::make_works_name));
  if (!make) throw std::runtime_error(::dlerror());
  return std::unique_ptr<bench::works>(make(path.c_str()));
}

void expect_same(const std::string& work, const std::vector<double>& a, const std::vector<double>& b) {
  bool same = a.size() == b.size() && !a.empty();
  for (std::size_t i = 0; same && i < a.size(); ++i) same = std::abs(a[i] - b[i]) <= 1e-12 * std::abs(a[i]);
  if (!same) throw std::runtime_error(work + ": header-only and compiled have different results");
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    const std::string path = p.file("bunny.obj");
    bench::write_obj(p.data.bunny(), path);
    const auto header_only = open(CONCINO_WORKS_HEADER_ONLY, path), compiled = open(CONCINO_WORKS_COMPILED, path);
    for (const std::string name : {"load", "harmonic", "heat.prepare", "heat.query"}) {
      const std::string work = "compiled." + name + ".bunny";
      if (!p.wants(work)) continue;
      expect_same(work, header_only->results(name), compiled->results(name));
      p.print(bench::compare(work, p.rounds,
                             {{"header-only", [&] { return header_only->seconds(name); }}, {"concino", [&] { return compiled->seconds(name); }}}));
    }
  });
}
