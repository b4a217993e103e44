// Measures the bytes per poly of a mesh after every adjacency was used, and the peak while reading as a multiple of them. The same pass checks that the
// library and the floor have the same mesh.
#include "support/check.hpp"
#include "support/heap.hpp"
#include "support/kinds.hpp"

#include <concino/io.hpp>

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    mallopt(M_MMAP_THRESHOLD, 1 << 25);  // the maximum of glibc: blocks of whole pages would be counted rounded up
    bench::for_each_file(p, {"memory", "peak"}, [&](const std::string& name, const std::string& path, const auto& arrays, auto kind) {
      using mesh = typename decltype(kind)::mesh;
      const double polys = static_cast<double>(arrays.num_polys());
      const auto floor = kind.read(path);
      const bench::digest expected = bench::digest_of(floor);

      const std::size_t before = bench::heap::live;
      bench::heap::peak = before;
      const auto m = concino::load<mesh>(path);
      const std::size_t peak = bench::heap::peak - before;
      bench::expect_same("memory." + name, expected, bench::digest_of(m));
      const std::size_t held = bench::heap::live - before;
      const auto ours = static_cast<double>(held), flat = static_cast<double>(floor.bytes());
      p.print({{"memory." + name, "floor", "B/poly", flat / polys, ours / flat},
               {"memory." + name, "concino", "B/poly", ours / polys, 1},
               {"peak." + name, "concino", "x mesh", static_cast<double>(peak) / ours, 1}});
    });
  });
}
