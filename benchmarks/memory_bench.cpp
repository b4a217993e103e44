// Measures the bytes per poly of a mesh after every adjacency was used, and the peak while reading as a multiple of them: from the file of the kind, and
// from the same mesh in each other format that holds it. The same pass checks that the library and the floor have the same mesh.
#include "support/check.hpp"
#include "support/heap.hpp"
#include "support/kinds.hpp"

#include <concino/io.hpp>

namespace {

struct other_format {
  const char* ending;
  bool binary;
};
constexpr other_format other_formats[] = {{".vtk", true}, {".vtu", true}, {".vtu", false}, {".vtp", true}, {".tet", false}, {".hybrid", false}, {".meshb", true}};

/// Writes a surface as Open Inventor, which the library only reads.
template<class M>
void write_iv(const M& m, const std::string& path) {
  std::FILE* const out = std::fopen(path.c_str(), "w");
  if (!out) throw std::runtime_error("cannot write " + path);
  std::fputs("#Inventor V2.1 ascii\nSeparator { Coordinate3 { point [\n", out);
  for (const concino::vert_id v : concino::verts(m)) std::fprintf(out, "%.17g %.17g %.17g,\n", concino::point(m, v).x, concino::point(m, v).y, concino::point(m, v).z);
  std::fputs("] } IndexedFaceSet { coordIndex [\n", out);
  for (const concino::poly_id p : concino::polys(m)) {
    for (const concino::vert_id v : concino::adj_p2v(m, p)) std::fprintf(out, "%u, ", v.raw());
    std::fputs("-1,\n", out);
  }
  std::fputs("] } }\n", out);
  std::fclose(out);
}

/// Loads a file, which is mapped: its bytes are not on the heap. Result: the peak of the heap as a multiple of what the mesh holds after every adjacency was used.
template<class M>
double peak_of(const std::string& path) {
  const std::size_t before = bench::heap::live;
  bench::heap::peak = before;
  const auto m = concino::load<M>(path, {.map = true});
  const std::size_t peak = bench::heap::peak - before;
  bench::digest_of(m);
  return static_cast<double>(peak) / static_cast<double>(bench::heap::live - before);
}

/// Saves a mesh in each other format that holds it, and measures the peak while each is read.
template<class M>
void print_other_formats(const bench::program& p, const std::string& name, const M& m) {
  const auto measure = [&](const std::string& path, const std::string& work) {
    p.print({{work, "concino", "x mesh", peak_of<M>(path), 1}});
    std::filesystem::remove(path);
  };
  for (const auto& [ending, binary] : other_formats) {
    const std::string path = p.file(name + ending);
    try {
      concino::save(m, path, {.binary = binary});
    } catch (const concino::unsupported&) {  // the format does not hold such a mesh
      continue;
    }
    measure(path, "peak." + name + ending + (binary ? ".binary" : ""));
  }
  if constexpr (concino::SurfaceMesh<M>) {  // Open Inventor holds no volumes
    const std::string path = p.file(name + ".iv");
    write_iv(m, path);
    measure(path, "peak." + name + ".iv");
  }
}

}  // namespace

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
      print_other_formats(p, name, m);
    });
  });
}
