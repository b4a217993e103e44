// VolumeMesh: models and non-models.
#include <concino/concepts/volume_mesh.hpp>

#include <support/models.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

namespace cn = concino;
using cn::testing::models_in_all_forms;

namespace {

static_assert(models_in_all_forms<user_mesh::volume>(cn::testing::volume | cn::testing::embedded));
struct tets : user_mesh::volume {};
struct flat : user_mesh::volume {};

}  // namespace
template<>
struct concino::mesh_traits<tets> : mesh_traits<user_mesh::volume> {
  static constexpr int arity = 4;
};
template<>
struct concino::mesh_traits<flat> : mesh_traits<user_mesh::volume> {
  static constexpr int dimension = 2;
};
static_assert(models_in_all_forms<tets>(cn::testing::volume | cn::testing::embedded | cn::testing::fixed_arity));
static_assert(cn::TetMesh<const tets&> && !cn::HexMesh<tets> && !cn::QuadMesh<tets>);
// The dimension decides: a surface may have faces too.
static_assert(models_in_all_forms<flat>(cn::testing::surface | cn::testing::embedded));

TEST_CASE("face_is_outward: is right for the faces of a user's volume") {
  cn::explain_volume_mesh<user_mesh::volume>();
  const user_mesh::volume w = user_mesh::volume_example();
  int outward = 0;
  for (auto p : cn::polys(w))
    for (auto f : cn::adj_p2f(w, p)) outward += cn::face_is_outward(w, p, f);
  CHECK(outward == 10);
}
