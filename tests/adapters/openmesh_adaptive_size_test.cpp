#include <concino/adapters/openmesh.hpp>
#include <concino/convert/convert.hpp>
#include <concino/generate/torus.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/remesh/adaptive_size.hpp>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <doctest/doctest.h>

namespace cn = concino;

TEST_CASE("OpenMesh: sizes are those of a trimesh") {
  const auto native = cn::make_torus<cn::trimesh>({.cells = {20, 12}});
  const auto m = cn::convert<OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>>(native);
  const cn::adaptive_size_options options{.chord_error = 0.01, .max_length = 4};
  const auto want = cn::adaptive_size(native, options);
  const auto sizes = cn::adaptive_size(m, options);
  for (const auto v : cn::verts(m)) CHECK(sizes[v] == doctest::Approx(want[cn::vert_id{cn::index_of(m, v)}]));
}
