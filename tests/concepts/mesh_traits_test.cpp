// A type without mesh_traits is not a mesh: every concept is false for it, never an error.
#include <concino/concepts/mesh_traits.hpp>

#include <support/models.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <vector>

namespace cn = concino;
using cn::testing::models_in_all_forms;

namespace {

struct incomplete;
struct abstract { virtual ~abstract() = 0; };
static_assert(!cn::PrimalGraph<int> && !cn::SurfaceMesh<std::string>);
static_assert(models_in_all_forms<int>(0) && models_in_all_forms<std::string>(0) && models_in_all_forms<std::vector<std::vector<int>>>(0));
static_assert(models_in_all_forms<abstract>(0) && models_in_all_forms<incomplete>(0));
static_assert(models_in_all_forms<std::unique_ptr<user_mesh::surface>>(0) && models_in_all_forms<user_mesh::surface*>(0));
static_assert(cn::testing::models<void>() == 0 && cn::testing::models<int[3]>() == 0 && cn::testing::models<int(int)>() == 0);

// A class derived from a model is not a model unless its author specialises mesh_traits.
struct derived : user_mesh::surface {};
static_assert(models_in_all_forms<derived>(0));
struct opted_in : user_mesh::surface {};

}  // namespace

template<>
struct concino::mesh_traits<opted_in> : mesh_traits<user_mesh::surface> {
  static constexpr bool is_view = true;
  static constexpr int arity = 4;
};

TEST_CASE("traits describe a type, and optional members have defaults") {
  CHECK(cn::dimension_v<user_mesh::surface> == 2);
  CHECK(cn::dimension_v<const user_mesh::volume&> == 3);
  CHECK(cn::dimension_v<int> == 0);
  CHECK(cn::arity_v<user_mesh::surface> == 0);
  CHECK(cn::arity_v<opted_in> == 4);
  CHECK(cn::QuadMesh<opted_in>);
  CHECK(cn::is_view_v<const opted_in&>);
  CHECK_FALSE(cn::is_view_v<user_mesh::surface>);
  CHECK_FALSE(cn::is_view_v<int>);
}
