// Volumes: models and non-models.
#include <concino/concepts/volume_mesh.hpp>

#include <support/models.hpp>
#include <support/tiny.hpp>

#include <doctest/doctest.h>

namespace cn = concino;
using cn::testing::models_in_all_forms;

namespace {

static_assert(models_in_all_forms<tiny::volume>(cn::testing::volume | cn::testing::embedded));
struct tets : tiny::volume {};
struct flat : tiny::volume {};

}  // namespace
template<>
struct concino::mesh_traits<tets> : mesh_traits<tiny::volume> {
  static constexpr int arity = 4;
};
template<>
struct concino::mesh_traits<flat> : mesh_traits<tiny::volume> {
  static constexpr int dimension = 2;
};
static_assert(models_in_all_forms<tets>(cn::testing::volume | cn::testing::embedded | cn::testing::fixed_arity));
static_assert(cn::TetMesh<const tets&> && !cn::HexMesh<tets> && !cn::QuadMesh<tets>);
// The dimension decides: what has faces besides may still be a surface.
static_assert(models_in_all_forms<flat>(cn::testing::surface | cn::testing::embedded));

TEST_CASE("faces of a volume are walked and turned outward") {
  cn::explain_volume_mesh<tiny::volume>();
  const tiny::volume w = tiny::volume_example();
  int outward = 0;
  for (auto p : cn::polys(w))
    for (auto f : cn::adj_p2f(w, p)) outward += cn::face_is_outward(w, p, f);
  CHECK(outward == 10);
}
