// Slices of files whose arrays are compressed.
#include <concino/adapters/zlib.hpp>
#include <concino/io/load_slice.hpp>
#include <concino/mesh/polygonmesh.hpp>

#include <support/file_slices.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include <zlib.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE("zlib: a slice of a file reads some blocks of compressed arrays") {
  const temporary_folder folder;
  const std::string path = folder / "m.vtu";
  write_file(path, slice_vtu_text(lines_between_polygons, [](const std::string& bytes) {
    std::string packed(compressBound(static_cast<uLong>(bytes.size())), 0);
    uLongf size = static_cast<uLongf>(packed.size());
    compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()));
    return packed.substr(0, size);
  }));
  check_slices<polygonmesh>(path, 5, {.inflate = zlib_inflate});
  const auto s = load_slice<polygonmesh>(path, 1, 2, {.inflate = zlib_inflate});
  CHECK(s.global_vert == std::vector<std::uint64_t>{2, 3, 4, 5, 6});
  CHECK(find_poly_property<double>(s.mesh, "heat")[*polys(s.mesh).begin()] == 1.5);
  CHECK_THROWS_WITH_AS(load_slice<polygonmesh>(path, 0, 2), doctest::Contains(": the arrays are compressed"), unsupported);
}
