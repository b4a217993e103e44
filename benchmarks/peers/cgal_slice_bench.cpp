// Measures the layers of a surface against CGAL's Polygon_mesh_slicer, which looks for the crossed edges in a tree. Building the tree counts. Neither side
// looks for self-intersections.
#include "../support/kinds.hpp"
#include "../support/queries.hpp"

#include <concino/mesh/trimesh.hpp>
#include <concino/print/heights.hpp>
#include <concino/print/slice_mesh.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_slicer.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <iterator>
#include <list>
#include <stdexcept>
#include <vector>

namespace {

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using surface = CGAL::Surface_mesh<kernel::Point_3>;
using line = std::vector<kernel::Point_3>;

surface surface_of(const bench::surface_arrays& a) {
  surface s;
  std::vector<surface::Vertex_index> v;
  for (const auto& x : a.points) v.push_back(s.add_vertex({x.x, x.y, x.z}));
  for (std::size_t i = 0; i < a.verts.size(); i += 3) s.add_face(v[a.verts[i].raw()], v[a.verts[i + 1].raw()], v[a.verts[i + 2].raw()]);
  return s;
}

double length_of(const concino::slice_lines& lines) {
  double sum = 0;
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t k = 0, n = lines[i].size(); k < n; ++k) sum += std::hypot(lines[i][(k + 1) % n][0] - lines[i][k][0], lines[i][(k + 1) % n][1] - lines[i][k][1]);
  return sum;
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    for (const int count : {1, 100}) {
      const std::string work = "slice-mesh." + std::to_string(count) + ".tri1m";
      if (!p.wants(work)) continue;
      const auto arrays = p.data.tri1m();
      const surface s = surface_of(arrays);
      const concino::trimesh m(arrays);
      double bottom = arrays.points[0].z, top = bottom;
      for (const auto& x : arrays.points) bottom = std::min(bottom, x.z), top = std::max(top, x.z);
      std::vector<double> zs;
      for (int i = 0; i < count; ++i) zs.push_back(bottom + (top - bottom) * (i + 0.4999) / count);
      const auto ours = [&] { return concino::slice_mesh(m, zs, {.accept_intersections = true}); };
      const auto theirs = [&] {
        const CGAL::Polygon_mesh_slicer<surface, kernel> slicer(s);
        std::vector<std::list<line>> layers;
        for (const double z : zs) slicer(kernel::Plane_3(0, 0, 1, -z), std::back_inserter(layers.emplace_back()));
        return layers;
      };
      double here = 0, there = 0;
      for (const auto& layer : ours().layers) here += length_of(layer.outer) + length_of(layer.inner);
      for (const auto& layer : theirs())
        for (const line& l : layer)
          for (std::size_t k = 0; k + 1 < l.size(); ++k) there += std::sqrt(CGAL::squared_distance(l[k], l[k + 1]));
      if (!(here > 0) || std::abs(here - there) > 1e-9 * here) throw std::runtime_error(work + ": CGAL and the library differ");
      p.print(bench::compare(work, std::min(p.rounds, 3), {{"concino", [&] { return bench::seconds_of(ours); }}, {"cgal", [&] { return bench::seconds_of(theirs); }}}));
    }
  });
}
