// Measures reading a file with all adjacencies, and building the adjacencies alone, against the floor.
#include "support/kinds.hpp"

#include <concino/io.hpp>

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    bench::for_each_file(p, {"load", "build"}, [&](const std::string& name, const std::string& path, const auto& arrays, auto kind) {
      using mesh = typename decltype(kind)::mesh;
      {
        const auto floor = kind.read(path);
        const auto ours = concino::load<mesh>(path);
        if (floor.num_verts() != concino::num_verts(ours) || floor.num_edges() != concino::num_edges(ours) ||
            floor.num_polys() != concino::num_polys(ours))
          throw std::runtime_error("load." + name + ": the floor and the library count different elements");
      }
      if (p.wants("load." + name))
        p.print(bench::compare("load." + name, p.rounds,
                               {{"floor", [&] { return bench::seconds_of([&] { return kind.read(path); }); }},
                                {"concino", [&] { return bench::seconds_of([&] { return concino::load<mesh>(path); }); }}}));
      if (p.wants("build." + name))
        p.print(bench::compare("build." + name, p.rounds,
                               {{"floor",
                                 [&] {
                                   auto m = kind.flat(arrays);
                                   return bench::seconds_of([&] { build(m); return 0; });
                                 }},
                                {"concino", [&] {
                                   auto copy = arrays;
                                   return bench::seconds_of([&] { return mesh(std::move(copy)); });
                                 }}}));
    });
  });
}
