// Measures the compile time of ten lines that read a mesh and compute a harmonic map: CPU seconds and peak memory of the compiler. The floor is a program
// that only factorises a matrix with Eigen. Variants: header-only, with concino::compiled, with the precompiled header of concino_precompile, with a solver
// of the user's own, and with a mesh of the user's own; for each compiler, with and without optimisation. Measures also the time to build
// concino::compiled on one core.
#include "support/compiler.hpp"
#include "support/program.hpp"

#include <algorithm>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// One measurement: the program and how it is compiled.
struct variant {
  std::string name, source;
  std::vector<std::string> flags;
};

/// The rows of a variant are compile.<name><suffix> in seconds and compiler.<name><suffix> in megabytes. In each round every variant is compiled right
/// after the floor, in an order that changes. The minimum of all rounds counts, because other load on the machine can only add time.
void compare(const bench::program& p, int rounds, const bench::compiler& by, const std::vector<std::string>& flags, const std::string& suffix,
             std::vector<variant> variants) {
  std::erase_if(variants, [&](const variant& v) { return !p.wants("compile." + v.name + suffix); });
  struct measured {
    double seconds = infinity, floor_seconds = infinity, megabytes = 0, floor_megabytes = 0;
  };
  std::vector<measured> all(variants.size());
  std::vector<std::size_t> order(variants.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::mt19937 shuffle(1);
  const auto compile = [&](const std::string& source, std::vector<std::string> more) {
    more.insert(more.begin(), flags.begin(), flags.end());
    return by.compile(CONCINO_COMPILE_TIME_FOLDER "/" + source + ".cpp", more, p.file("object.o"));
  };
  bench::compilation floor = {};
  for (int r = 0; r < rounds; ++r) {
    std::shuffle(order.begin(), order.end(), shuffle);
    for (const std::size_t i : order) {
      if (!p.data.tiny || floor.user_seconds == 0) floor = compile("floor", {});
      const bench::compilation ours = compile(variants[i].source, variants[i].flags);
      all[i].floor_seconds = std::min(all[i].floor_seconds, floor.user_seconds);
      all[i].seconds = std::min(all[i].seconds, ours.user_seconds);
      all[i].floor_megabytes = std::max(all[i].floor_megabytes, floor.megabytes);
      all[i].megabytes = std::max(all[i].megabytes, ours.megabytes);
    }
  }
  for (std::size_t i = 0; i < variants.size(); ++i) {
    const std::string name = variants[i].name + suffix;
    const measured& x = all[i];
    p.print({{"compile." + name, "floor", "s", x.floor_seconds, x.seconds / x.floor_seconds},
             {"compile." + name, "concino", "s", x.seconds, 1},
             {"compiler." + name, "floor", "MB", x.floor_megabytes, x.megabytes / x.floor_megabytes},
             {"compiler." + name, "concino", "MB", x.megabytes, 1}});
  }
}

/// All variants of the ten lines, by one compiler with one optimisation level.
void compare_ways(const bench::program& p, int rounds, const bench::compiler& by, const std::string& optimisation) {
  const std::string suffix = std::string(".").append(by.name).append(".").append(optimisation, 1);
  const std::vector<std::string> compiled = {"-DCONCINO_COMPILED"};
  std::vector<variant> variants = {{"header-only.trimesh", "trimesh", {}},
                                   {"header-only.polygonmesh", "polygonmesh", {}},
                                   {"compiled.trimesh", "trimesh", compiled},
                                   {"compiled.polygonmesh", "polygonmesh", compiled},
                                   {"compiled.own-mesh", "own_mesh", compiled},
                                   {"compiled.own-solver", "own_solver", compiled}};
  if (p.wants("compile.precompiled.polygonmesh" + suffix) || p.wants("compile.precompile" + suffix)) {
    const bench::precompiled_header header = by.precompile(CONCINO_PRECOMPILED_HEADERS, {optimisation, "-DCONCINO_COMPILED"}, p.file("precompiled.hpp"));
    p.print({{"compile.precompile" + suffix, "concino", "s", header.cost.user_seconds, 1},
             {"compiler.precompile" + suffix, "concino", "MB", header.cost.megabytes, 1}});
    std::vector<std::string> flags = compiled;
    flags.insert(flags.end(), header.flags.begin(), header.flags.end());
    variants.push_back({"precompiled.polygonmesh", "polygonmesh", flags});
  }
  compare(p, rounds, by, {optimisation}, suffix, variants);
}

/// All files of concino::compiled, one after another, with the flags that CMake uses when no build type is set.
void build_library(const bench::program& p, const bench::compiler& by) {
  const std::string name = "library." + by.name;
  if (!p.wants("compile." + name)) return;
  std::vector<std::string> files = bench::lines_of(CONCINO_LIBRARY_FILES);
  if (p.data.tiny) files.resize(1);
  double seconds = 0, most = 0;
  for (const std::string& file : files) {
    const bench::compilation c = by.compile(file, {"-O3", "-DNDEBUG", "-fPIC", "-DCONCINO_COMPILED"}, p.file("object.o"));
    seconds += c.user_seconds + c.system_seconds;
    most = std::max(most, c.megabytes);
  }
  p.print({{"compile." + name, "concino", "s", seconds, 1}, {"compiler." + name, "concino", "MB", most, 1}});
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    const int rounds = std::min(p.rounds, 3);
    std::vector<bench::compiler> compilers = bench::compilers_of(CONCINO_COMPILERS);
    if (p.data.tiny) compilers.resize(1);
    const std::vector<std::string> optimisations = p.data.tiny ? std::vector<std::string>{"-O0"} : std::vector<std::string>{"-O0", "-O3"};
    for (const bench::compiler& by : compilers) {
      for (const std::string& optimisation : optimisations) compare_ways(p, rounds, by, optimisation);
      build_library(p, by);
    }
    // A longer program that also writes the result, and the same program with the headers of whole modules, by the compiler of this build.
    const std::vector<variant> longer = {{"single", "program", {}}, {"umbrellas", "program_by_umbrellas", {}}};
    for (const std::string& optimisation : optimisations) compare(p, rounds, compilers[0], {optimisation}, std::string(".").append(optimisation, 1), longer);
  });
}
