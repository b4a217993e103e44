// Measures level sets with two threads against one, in seconds that pass. The results are the same. Nothing else may run meanwhile.
#include "support/kinds.hpp"
#include "support/level_set_values.hpp"

#include <concino/convert/convert.hpp>
#include <concino/level_sets.hpp>

#include <cstdio>
#include <string>
#include <vector>

#include <stdlib.h>

namespace {

namespace cn = concino;

/// The seconds of f() with n threads.
template<class F>
double seconds_with(int n, const F& f) {
  ::setenv("CONCINO_NUM_THREADS", std::to_string(n).c_str(), 1);
  return bench::wall_seconds_of(f);
}

/// The numbers of a result that are compared: coordinates of points, or measures.
template<class Points>
void add_coordinates(const Points& points, std::vector<double>& all) {
  for (const cn::vec3& x : points) all.insert(all.end(), {x.x, x.y, x.z});
}
std::vector<double> numbers_of(const std::vector<double>& measures) { return measures; }
std::vector<double> numbers_of(const std::vector<cn::level_line<cn::trimesh>>& lines) {
  std::vector<double> all;
  for (const auto& line : lines) add_coordinates(line.points, all);
  return all;
}
template<class LevelSet>
std::vector<double> numbers_of(const LevelSet& s) {
  std::vector<double> all;
  add_coordinates(s.mesh.points(), all);
  return all;
}

template<class F>
void compare(const bench::program& p, const std::string& name, const F& f) {
  const std::string work = "two-threads." + name;
  if (!p.wants(work)) return;
  std::vector<double> of_one, of_two;
  seconds_with(1, [&] { return of_one = numbers_of(f()), 0; });
  seconds_with(2, [&] { return of_two = numbers_of(f()), 0; });
  bench::expect(!of_one.empty() && of_one == of_two, work, "one thread and two give other results");
  p.print(bench::compare(work, p.rounds, {{"one-thread", [&] { return seconds_with(1, f); }}, {"concino", [&] { return seconds_with(2, f); }}}));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    if (CPU_COUNT(&p.cores) < 2) {
      std::fprintf(stderr, "level_set_threads_bench needs two cores: nothing is measured\n");
      return;
    }
    bench::use_cores(p.cores);
    {
      const cn::trimesh m(p.data.tri1m());
      const bench::middle_level s(m);
      compare(p, "isolines.tri1m", [&] { return cn::isolines(m, s.u, s.level); });
    }
    {
      const cn::tetmesh m(p.data.tet1m());
      const bench::sphere s(p, "tet1m", m, 0.34);
      compare(p, "isosurface.tet1m", [&] { return cn::isosurface(m, s.u, s.level); });
      compare(p, "measure_between.tet1m", [&] { return cn::measure_between(m, s.u, {s.level / 2, s.level, 2 * s.level}); });
    }
    const cn::hexmesh hexes(p.data.hex1m());
    {
      const bench::sphere s(p, "hex1m", hexes, 0.4);
      compare(p, "isosurface.hex1m", [&] { return cn::isosurface(hexes, s.u, s.level); });
    }
    const auto m = cn::convert<cn::polyhedralmesh>(hexes);
    const bench::sphere s(p, "poly1m", m, 0.4);
    compare(p, "isosurface.poly1m", [&] { return cn::isosurface(m, s.u, s.level); });
    compare(p, "clip.poly1m", [&] { return cn::clip(m, s.u, s.level, {.properties = false}); });
    compare(p, "split.poly1m", [&] { return cn::split(m, s.u, s.level, {.properties = false}); });
  });
}
