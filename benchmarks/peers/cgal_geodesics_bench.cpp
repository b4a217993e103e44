// Measures exact geodesics against CGAL's shortest paths on a surface, from one vert to all others.
#include "../support/kinds.hpp"

#include <concino/fields/exact_geodesics.hpp>
#include <concino/mesh/trimesh.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using surface = CGAL::Surface_mesh<kernel::Point_3>;
using shortest_path = CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<kernel, surface>>;

surface surface_of(const bench::surface_arrays& a) {
  surface s;
  std::vector<surface::Vertex_index> v;
  for (const auto& x : a.points) v.push_back(s.add_vertex({x.x, x.y, x.z}));
  for (std::size_t i = 0; i < a.verts.size(); i += 3) s.add_face(v[a.verts[i].raw()], v[a.verts[i + 1].raw()], v[a.verts[i + 2].raw()]);
  return s;
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    const std::string work = "exact.bunny";
    if (!p.wants(work)) return;
    const auto arrays = p.data.bunny();
    const surface s = surface_of(arrays);
    const concino::trimesh m(arrays);
    const auto ours = [&] {
      const auto d = concino::prepare_exact_geodesics(m).distance_from(concino::vert_id{0});
      return std::vector<double>(d.values().begin(), d.values().end());
    };
    const auto theirs = [&] {
      shortest_path paths(s);
      paths.add_source_point(surface::Vertex_index(0));
      std::vector<double> d;
      for (const auto v : s.vertices()) d.push_back(paths.shortest_distance_to_source_points(v).first);
      return d;
    };
    const auto a = ours(), b = theirs();
    for (std::size_t i = 0; i < b.size(); ++i)
      if (std::abs(a[i] - b[i]) > 1e-9 * (1 + b[i])) throw std::runtime_error(work + ": CGAL and the library differ");
    p.print(bench::compare(work, std::min(p.rounds, 3), {{"concino", [&] { return bench::seconds_of(ours); }},
                                                         {"cgal", [&] { return bench::seconds_of(theirs); }}}));
  });
}
