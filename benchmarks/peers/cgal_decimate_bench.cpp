// Measures CGAL's edge collapse simplification, by quadrics (Garland and Heckbert) and by its default (Lindstrom and Turk), beside decimation by the library.
#include "../support/decimate.hpp"

#include <concino/adapters/cgal_surface_mesh.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

namespace {

using kernel = CGAL::Simple_cartesian<double>;
using mesh = CGAL::Surface_mesh<kernel::Point_3>;
namespace sms = CGAL::Surface_mesh_simplification;

mesh from(const bench::surface_arrays& a) {
  mesh m;
  for (const auto& x : a.points) m.add_vertex({x.x, x.y, x.z});
  const auto vert = [&](std::size_t i) { return mesh::Vertex_index(a.verts[i].raw()); };
  for (std::size_t i = 0; i < a.verts.size(); i += 3) m.add_face(vert(i), vert(i + 1), vert(i + 2));
  return m;
}

/// Stops at this many triangles of a closed surface.
sms::Count_stop_predicate<mesh> until(std::size_t target) { return sms::Count_stop_predicate<mesh>(target * 3 / 2); }

struct lindstrom_turk {
  static std::size_t decimate(mesh& m, std::size_t target) { return static_cast<std::size_t>(sms::edge_collapse(m, until(target))); }
  static concino::trimesh to_concino(const mesh& m) { return concino::convert<concino::trimesh>(m); }
};
struct garland_heckbert : lindstrom_turk {
  static std::size_t decimate(mesh& m, std::size_t target) {
    using policies = sms::GarlandHeckbert_plane_policies<mesh, kernel>;
    const policies q(m);
    return static_cast<std::size_t>(
        sms::edge_collapse(m, until(target), CGAL::parameters::get_cost(q.get_cost()).get_placement(q.get_placement())));
  }
};

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    const auto a = p.data.bunny16();
    const mesh theirs = from(a);
    bench::compare_decimation<garland_heckbert>(p, "cgal", "bunny16", a, theirs);
    bench::compare_decimation<lindstrom_turk>(p, "cgal_default", "bunny16", a, theirs);
  });
}
