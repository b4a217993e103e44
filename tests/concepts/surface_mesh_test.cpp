// SurfaceMesh: models, non-models, and overload resolution.
#include <concino/concepts/surface_mesh.hpp>

#include <support/models.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

namespace cn = concino;
using cn::testing::models_in_all_forms;

namespace {

static_assert(models_in_all_forms<user_mesh::surface>(cn::testing::surface | cn::testing::embedded));
struct triangles : user_mesh::surface {};
struct one_descriptor : user_mesh::surface {};

}  // namespace
template<>
struct concino::mesh_traits<triangles> : mesh_traits<user_mesh::surface> {
  static constexpr int arity = 3;
};
template<>
struct concino::mesh_traits<one_descriptor> : mesh_traits<user_mesh::surface> {
  using edge = vert;
};
namespace {

static_assert(models_in_all_forms<triangles>(cn::testing::surface | cn::testing::embedded | cn::testing::fixed_arity));
static_assert(cn::TriMesh<const triangles&> && !cn::QuadMesh<triangles> && !cn::TetMesh<triangles>);
// If two kinds of elements have the same type, only the graph concepts hold.
static_assert(models_in_all_forms<one_descriptor>(cn::testing::primal_graph | cn::testing::dual_graph | cn::testing::embedded));

constexpr int pick(const cn::PrimalGraph auto&) { return 1; }
constexpr int pick(const cn::AnyMesh auto&) { return 2; }
constexpr int pick(const cn::SurfaceMesh auto&) { return 3; }
constexpr int pick(const cn::TriMesh auto&) { return 4; }

}  // namespace

TEST_CASE("overload resolution chooses the most constrained concept") {
  cn::explain_surface_mesh<const user_mesh::surface>();
  CHECK(pick(user_mesh::volume()) == 2);
  CHECK(pick(user_mesh::surface()) == 3);
  CHECK(pick(triangles()) == 4);
}
