// Files beyond 4 GiB: sparse ones, which take no space on the disk, and text from a pipe.
#include <concino/io/load_any.hpp>
#include <concino/mesh/property.hpp>
#include <concino/mesh/trimesh.hpp>

#include <support/corpus.hpp>
#include <support/reading.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <csignal>
#include <thread>

#include <fcntl.h>
#include <unistd.h>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr std::uint64_t gib = std::uint64_t{1} << 30;

/// A file that consists of pieces at given positions. The rest is zeros that take no space on the disk.
struct sparse_file {
  std::string path;
  int fd;

  sparse_file(const std::string& path_, std::uint64_t size) : path(path_), fd(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {
    REQUIRE(fd >= 0);
    resize(size);
  }
  sparse_file(const sparse_file&) = delete;
  ~sparse_file() { ::close(fd); }
  void resize(std::uint64_t size) { REQUIRE(::ftruncate(fd, static_cast<::off_t>(size)) == 0); }
  void write(std::uint64_t place, const std::string& bytes) {
    REQUIRE(::pwrite(fd, bytes.data(), bytes.size(), static_cast<::off_t>(place)) == static_cast<::ssize_t>(bytes.size()));
  }
};

std::string words(std::initializer_list<std::uint32_t> all) {
  std::string bytes;
  for (const std::uint32_t x : all)
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(x >> shift & 255);
  return bytes;
}
std::uint32_t real(float x) { return std::bit_cast<std::uint32_t>(x); }

std::vector<vec3> points_of(const trimesh& m) {
  std::vector<vec3> all;
  for (const vert_id v : verts(m)) all.push_back(point(m, v));
  return all;
}

std::uint64_t free_memory() {
  return static_cast<std::uint64_t>(::sysconf(_SC_AVPHYS_PAGES)) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

/// The text of a pipe: `head`, then n times `line`, then `tail`.
template<class F>
void with_pipe(const std::string& head, const std::string& line, std::uint64_t n, const std::string& tail, const F& f) {
  std::signal(SIGPIPE, SIG_IGN);  // a reader that stops early must not end this process
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  std::string block;
  while (block.size() < 1 << 20) block += line;
  std::thread writer([&] {
    const auto send = [&](std::string_view text) {
      while (!text.empty()) {
        const ::ssize_t sent = ::write(ends[1], text.data(), text.size());
        if (sent <= 0) return;
        text.remove_prefix(static_cast<std::size_t>(sent));
      }
    };
    send(head);
    for (std::uint64_t left = n * line.size(); left > 0;) {
      const std::size_t now = static_cast<std::size_t>(std::min<std::uint64_t>(left, block.size()));
      send(std::string_view(block).substr(0, now));
      left -= now;
    }
    send(tail);
    ::close(ends[1]);
  });
  const std::string path = "/dev/fd/" + std::to_string(ends[0]);
  f(path);
  ::close(ends[0]);
  writer.join();
}

}  // namespace

// Points of a million coordinates make a large file with few verts.
TEST_CASE("large files: binary OFF beyond 4 GiB can be mapped and read") {
  constexpr std::uint64_t dimension = 1'000'000, num_points = 1'100, points_at = 12 + 16, polys_at = points_at + 4 * dimension * num_points;
  static_assert(polys_at > 4 * gib);
  const temporary_folder dir;
  sparse_file file(dir / "a.off", polys_at);
  file.write(0, "nOFF BINARY\n" + words({dimension, num_points, 2, 0}));
  for (const std::uint32_t v : {0u, 1u, 1098u, 1099u})
    file.write(points_at + 4 * dimension * v, words({real(static_cast<float>(v)), real(2), real(static_cast<float>(v) / 2)}));
  file.write(polys_at, words({3, 0, 1, 1099, 0, 3, 1, 1098, 1099, 1, real(7)}));
  for (const bool map : {true, false}) {
    if (!map && free_memory() < 6 * gib) return skip("less than 6 GiB of memory are free");
    load_report report;
    const auto m = load<surface_arrays>(file.path, {.report = &report, .map = map});
    REQUIRE(m.points.size() == num_points);
    CHECK(m.points[1099] == vec3{1099, 2, 549.5});
    CHECK(m.points[1097] == vec3{0, 0, 0});
    CHECK(raw(m.verts) == std::vector<unsigned>{0, 1, 1099, 1, 1098, 1099});
  }
  // The byte of an error is right beyond 4 GiB too.
  file.write(polys_at + 8, words({5000}));
  CHECK_THROWS_WITH_AS(load<surface_arrays>(file.path, {.map = true}),
                       (file.path + ":1: expected the index of a vert below 1100, found another value at byte " + std::to_string(polys_at + 8)).c_str(), parse_error);
  file.resize(polys_at + 6);
  CHECK_THROWS_WITH_AS(load<surface_arrays>(file.path, {.map = true}),
                       (file.path + ":1: expected the number of verts of a poly, no more than the rest of the file can hold, found another value at byte " +
                        std::to_string(polys_at))
                           .c_str(),
                       parse_error);
}

// Arrays may stand anywhere behind the tags.
TEST_CASE("large files: .vtu with arrays beyond 4 GiB can be mapped and read") {
  constexpr std::uint64_t far = 5 * gib;
  const auto array = [](const std::string& type, const std::string& name, std::uint64_t offset) {
    return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" + (name == "Points" ? "3" : "1") + "\" format=\"appended\" offset=\"" + std::to_string(offset) + "\"/>\n";
  };
  const std::string tags = "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
                           "<Piece NumberOfPoints=\"3\" NumberOfCells=\"1\">\n<PointData>\n" + array("Float32", "heat", far + 1024) + "</PointData>\n<Points>\n" +
                           array("Float32", "Points", 0) + "</Points>\n<Cells>\n" + array("Int32", "connectivity", far) + array("Int32", "offsets", far + 256) +
                           array("UInt8", "types", far + 512) + "</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  const auto little = [](std::initializer_list<std::uint32_t> all) {
    std::string bytes;
    for (const std::uint32_t x : all)
      for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(x >> shift & 255);
    return bytes;
  };
  const temporary_folder dir;
  sparse_file file(dir / "a.vtu", tags.size() + far + 2048);
  file.write(0, tags + little({36, 0, 0, 0, 0, real(1), 0, 0, 0, real(1), 0}));
  file.write(tags.size() + far, little({12, 0, 2, 0, 1}));
  file.write(tags.size() + far + 256, little({4, 0, 3}));
  file.write(tags.size() + far + 512, little({1, 0, 5}));
  file.write(tags.size() + far + 1024, little({12, 0, real(7), real(8), real(9)}));
  const auto m = load<trimesh>(file.path, {.map = true});
  CHECK(points_of(m) == std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(find_vert_property<float>(m, "heat")[vert_id{2}] == 9);
  file.write(tags.size() + far, little({12, 0, 2, 0, 3}));
  CHECK_THROWS_AS(load<trimesh>(file.path, {.map = true}), parse_error);
}

TEST_CASE("large files: .vtk with an array behind 4 GiB of another one can be mapped and read") {
  const temporary_folder dir;
  std::string head = "# vtk DataFile Version 3.0\nlarge\nBINARY\nDATASET POLYDATA\nPOINTS 3 float\n" + words({0, 0, 0, real(1), 0, 0, 0, real(1), 0}) +
                     "\nPOLYGONS 1 4\n" + words({3, 0, 1, 2}) + "\nPOINT_DATA 3\nFIELD values 2\nlarge 1500000000 3 unsigned_char\n";
  const std::uint64_t behind = head.size() + 4'500'000'000u;
  static_assert(4'500'000'000u > 4 * gib);
  const std::string tail = "\nheat 1 3 float\n" + words({real(7), real(8), real(9)}) + "\n";
  sparse_file file(dir / "a.vtk", behind + tail.size());
  file.write(0, head);
  file.write(behind, tail);
  load_report report;
  const auto m = load<trimesh>(file.path, {.report = &report, .map = true});
  CHECK(find_vert_property<float>(m, "heat")[vert_id{2}] == 9);
  CHECK(report.skipped.size() == 1);
}

TEST_CASE("large files: .meshb with sections beyond 4 GiB can be mapped and read") {
  const auto ints = [](std::initializer_list<std::uint64_t> all, unsigned size) {
    std::string bytes;
    for (const std::uint64_t x : all)
      for (unsigned k = 0; k < size; ++k) bytes += static_cast<char>(x >> (8 * k) & 255);
    return bytes;
  };
  constexpr std::uint64_t far = 5 * gib;
  const temporary_folder dir;
  // version 3: positions of 64 bits; the section of an unknown keyword ends beyond 4 GiB
  const std::string head = ints({1, 3, 3}, 4) + ints({24}, 8) + ints({3, 900}, 4) + ints({far}, 8);
  std::string points = ints({4}, 4);
  const std::string coordinates = ints({3}, 4) + ints({0, 0, 0}, 8) + ints({0}, 4) + ints({std::bit_cast<std::uint64_t>(1.0), 0, 0}, 8) + ints({0}, 4) +
                                  ints({0, std::bit_cast<std::uint64_t>(1.0), 0}, 8) + ints({0}, 4);
  points += ints({far + 12 + coordinates.size()}, 8) + coordinates;
  const std::string triangles = ints({6}, 4) + ints({far + points.size() + 12 + 20}, 8) + ints({1, 1, 2, 3, 7}, 4) + ints({54}, 4) + ints({0}, 8);
  sparse_file file(dir / "a.meshb", far + points.size() + triangles.size());
  file.write(0, head);
  file.write(far, points + triangles);
  const auto m = load<trimesh>(file.path, {.map = true});
  CHECK(points_of(m) == std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(find_poly_property<int>(m, "label")[poly_id{0}] == 7);
}

TEST_CASE("large files: .vtp with arrays beyond 4 GiB can be mapped and read") {
  constexpr std::uint64_t far = 5 * gib;
  const auto array = [](const std::string& type, const std::string& name, const std::string& components, std::uint64_t offset) {
    return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" + components + "\" format=\"appended\" offset=\"" + std::to_string(offset) + "\"/>\n";
  };
  const std::string tags = "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\"3\" NumberOfPolys=\"1\">\n"
                           "<Points>\n" + array("Float32", "Points", "3", 0) + "</Points>\n<Polys>\n" + array("Int32", "connectivity", "1", far) + array("Int32", "offsets", "1", far + 256) +
                           "</Polys>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  const auto little = [](std::initializer_list<std::uint32_t> all) {
    std::string bytes;
    for (const std::uint32_t x : all)
      for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(x >> shift & 255);
    return bytes;
  };
  const temporary_folder dir;
  sparse_file file(dir / "a.vtp", tags.size() + far + 1024);
  file.write(0, tags + little({36, 0, 0, 0, 0, real(1), 0, 0, 0, real(1), 0}));
  file.write(tags.size() + far, little({12, 0, 2, 0, 1}));
  file.write(tags.size() + far + 256, little({4, 0, 3}));
  const auto m = load<trimesh>(file.path, {.map = true});
  CHECK(points_of(m) == std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  file.write(tags.size() + far, little({12, 0, 2, 0, 3}));
  CHECK_THROWS_AS(load<trimesh>(file.path, {.map = true}), parse_error);
}

// A comment of zeros takes no space on the disk.
TEST_CASE("large files: .tet and .iv with a comment beyond 4 GiB can be mapped and read") {
  constexpr std::uint64_t far = 4 * gib + 100;
  const temporary_folder dir;
  sparse_file a(dir / "a.tet", far);
  a.write(0, "4 vertices\n1 tets\n# ");
  a.write(far, "\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n4 0 1 2 3\n");
  const auto cells = load<polyhedra_arrays>(a.path, {.map = true});
  CHECK(cells.points.size() == 4);
  CHECK(cells.num_faces() == 4);
  sparse_file b(dir / "b.iv", far);
  b.write(0, "#Inventor V2.1 ascii\nCoordinate3 { point [ 0 0 0, 1 0 0, 0 1 0 ] }\n# ");
  b.write(far, "\nIndexedFaceSet { coordIndex [ 0, 1, x, -1 ] }\n");
  CHECK_THROWS_WITH_AS(load<surface_arrays>(b.path, {.map = true}), (b.path + ":4: expected the index of a vert or -1, found 'x,'").c_str(), parse_error);
  b.write(far, "\nIndexedFaceSet { coordIndex [ 0, 1, 2, -1 ] }\n");
  CHECK(raw(load<surface_arrays>(b.path, {.map = true}).verts) == std::vector<unsigned>{0, 1, 2});
}

TEST_CASE("large files: counts beyond 32 bits are errors even if the file could hold the elements") {
  const temporary_folder dir;
  const auto refused = [&](const std::string& name, const std::string& head) {
    sparse_file file(dir / name, 40 * gib);
    file.write(0, head);
    CHECK_THROWS_WITH_AS(load_any(file.path, {.map = true}), (file.path + ": more than 4294967294 elements of one kind").c_str(), unsupported);
  };
  refused("a.off", "OFF\n4294967295 1 0\n");
  refused("b.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n4294967295\n");
  refused("c.hedra", "4294967295 4 1\n");
}

TEST_CASE("large files: text beyond 4 GiB with more than 2^32 lines can be read from a pipe") {
  if (free_memory() < 10 * gib) return skip("less than 10 GiB of memory are free");
  constexpr std::uint64_t lines = (std::uint64_t{1} << 32) + 10;
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  // Verts and faces after 2^32 lines are read, including the last one.
  with_pipe(triangle, "\n", lines, "v 0 0 9\nf -1 1 2\nf 1 2 5\nf 1 2 x\n", [&](const std::string& path) {
    CHECK_THROWS_WITH_AS(load<surface_arrays>(path, {.format = file_format::obj}),
                         (path + ":" + std::to_string(lines + 7) + ": expected the index of a vert, found 'x'").c_str(), parse_error);
  });
}
