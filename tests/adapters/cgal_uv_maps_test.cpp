// UV maps of CGAL meshes: the same as of native ones, and lscm beside CGAL's Surface_mesh_parameterization.
#include <concino/adapters/cgal_surface_mesh.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/parametrize.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Two_vertices_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <support/cgal.hpp>
#include <support/uv_disks.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <concepts>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using space = CGAL::Simple_cartesian<double>;
using surface = CGAL::Surface_mesh<space::Point_3>;

template<class K>
surface_arrays hill(unsigned n) {
  auto a = grid_arrays<K>(n);
  for (vec3& x : a.points) x = on_hill(x.x, x.y);
  return a;
}

}  // namespace

TEST_CASE("CGAL: UV maps of its meshes have its descriptors, and leave out removed elements") {
  const auto arrays = hill<polygonmesh>(4);
  const polygonmesh native(arrays);
  auto m = cgal_surface<space::Point_3>(arrays);
  const auto uv = lscm(m);
  static_assert(std::same_as<decltype(tutte(m).attached[0].verts), std::vector<surface::Vertex_index>>);
  const auto same = lscm(native);
  for (const auto v : verts(m))
    for (std::size_t k = 0; k < 2; ++k) CHECK(uv[v][k] == doctest::Approx(same[vert_id{index_of(m, v)}][k]).epsilon(1e-9).scale(1));
  CHECK(tutte(m).attached.size() == tutte(native).attached.size());
  CHECK(map_distortion(m, uv).max_angle == doctest::Approx(map_distortion(native, same).max_angle).epsilon(1e-7));
  CGAL::Euler::remove_face(m.halfedge(surface::Face_index(0)), m);
  CHECK(map_distortion(m, lscm(m)).flipped == 0);
}

TEST_CASE("CGAL: its least squares conformal map with the same two verts is the same of a developable surface, and near of others") {
  namespace smp = CGAL::Surface_mesh_parameterization;
  for (const bool is_developable : {true, false}) {
    const unsigned n = 8;
    auto arrays = hill<trimesh>(n);
    if (is_developable) {
      arrays = grid_arrays<trimesh>(n);
      for (vec3& x : arrays.points) x = on_cylinder(x.x, x.y);
    }
    auto m = cgal_surface<space::Point_3>(arrays);
    using point_map = surface::Property_map<surface::Vertex_index, space::Point_2>;
    const point_map theirs = m.add_property_map<surface::Vertex_index, space::Point_2>("v:uv").first;
    const surface::Vertex_index a(0), b((n + 1) * (n + 1) - 1);
    using border = smp::Two_vertices_parameterizer_3<surface>;
    auto boundary = *m.halfedges().begin();
    for (const auto h : m.halfedges())
      if (m.is_border(h)) boundary = h;
    const auto status = smp::parameterize(m, smp::LSCM_parameterizer_3<surface, border>(border(a, b)), boundary, theirs);
    REQUIRE(status == smp::OK);
    const auto at = [&](surface::Vertex_index v) { return uv_point{theirs[v].x(), theirs[v].y()}; };
    const auto ours = lscm(m, {{a, at(a)}, {b, at(b)}});
    // Their solver is iterative, and their equations of triangles are weighted by areas once more, which does not matter where they all hold.
    for (const auto v : verts(m))
      for (std::size_t k = 0; k < 2; ++k) CHECK(std::abs(ours[v][k] - at(v)[k]) < (is_developable ? 1e-5 : 0.02));
  }
}
