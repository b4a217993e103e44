// Which meshes are editable; tests/mesh/surface_rewire_test.cpp checks the laws on those of the library.
#include <concino/concepts/editable.hpp>
#include <concino/mesh.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

namespace cn = concino;

namespace {

struct fixed_surface {
  cn::trimesh inside;
};

}  // namespace

template<>
struct concino::mesh_traits<fixed_surface> : concino::indexed_surface<fixed_surface> {
  static const auto& tables(const fixed_surface& m) { return m.inside.tables(); }
  static const cn::vec3& point(const fixed_surface& m, cn::vert_id v) { return m.inside.points()[v.raw()]; }
};

static_assert(cn::SurfaceMesh<fixed_surface> && !cn::EditableSurfaceMesh<fixed_surface> && !cn::EditableMesh<fixed_surface>);
static_assert(cn::EditableGeneralMesh<cn::polygonmesh> && cn::EditableGeneralMesh<cn::polyhedralmesh> && !cn::EditableGeneralMesh<cn::quadmesh> && !cn::EditableGeneralMesh<int>);
static_assert(!cn::EditableSurfaceMesh<int> && !cn::EditableVolumeMesh<int> && !cn::EditableMesh<int>);

TEST_CASE_TEMPLATE("editable: native surfaces", M, CONCINO_ALL_SURFACE_KINDS) {
  static_assert(cn::EditableSurfaceMesh<M> && cn::EditableMesh<M> && !cn::EditableVolumeMesh<M>);
  cn::explain_editable_surface_mesh<M>();
}
