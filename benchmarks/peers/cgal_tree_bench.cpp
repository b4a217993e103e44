// Measures the tree over a surface against CGAL's AABB_tree: building, closest points and rays.
#include "../support/kinds.hpp"
#include "../support/queries.hpp"

#include <concino/mesh/trimesh.hpp>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <memory>

namespace {

using kernel = CGAL::Simple_cartesian<double>;
using surface = CGAL::Surface_mesh<kernel::Point_3>;
using cgal_tree = CGAL::AABB_tree<CGAL::AABB_traits<kernel, CGAL::AABB_face_graph_triangle_primitive<surface>>>;

surface surface_of(const bench::surface_arrays& a) {
  surface s;
  std::vector<surface::Vertex_index> v;
  for (const auto& x : a.points) v.push_back(s.add_vertex({x.x, x.y, x.z}));
  for (std::size_t i = 0; i < a.verts.size(); i += 3) s.add_face(v[a.verts[i].raw()], v[a.verts[i + 1].raw()], v[a.verts[i + 2].raw()]);
  return s;
}

std::unique_ptr<cgal_tree> built(const surface& s) {
  auto tree = std::make_unique<cgal_tree>(faces(s).begin(), faces(s).end(), s);
  tree->build();
  tree->accelerate_distance_queries();
  return tree;
}

kernel::Point_3 to_cgal(const concino::vec3& x) { return {x.x, x.y, x.z}; }

void expect_close(const std::string& work, double ours, double theirs) {
  if (std::abs(ours - theirs) > 1e-9 * std::abs(theirs)) throw std::runtime_error(work + ": CGAL and the library differ");
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    if (!p.wants("tree.build.tri1m") && !p.wants("tree.closest.tri1m") && !p.wants("tree.ray.tri1m")) return;
    const auto arrays = p.data.tri1m();
    const surface s = surface_of(arrays);
    const concino::trimesh m(arrays);
    const auto ours = concino::bounding_tree(m);
    const auto theirs = built(s);
    const auto near = bench::places_near(m, p.data.tiny ? 100 : 100000, 0.1);
    const auto sum = [&] {
      double total = 0;
      for (const auto& x : near) total += std::sqrt(theirs->squared_distance(to_cgal(x)));
      return total;
    };
    const auto hits = [&] {
      std::size_t met = 0;
      for (std::size_t i = 1; i < near.size(); ++i)
        met += theirs->first_intersected_primitive(kernel::Ray_3(to_cgal(near[i - 1]), to_cgal(near[i]))).has_value();
      return met;
    };
    const auto row = [&](const std::string& work, auto run, auto theirs_run) {
      if (!p.wants(work)) return;
      for (const bench::row& r : bench::compare(work, std::min(p.rounds, 3), {{"concino", [&] { return bench::seconds_of(run); }},
                                                                             {"cgal", [&] { return bench::seconds_of(theirs_run); }}}))
        if (r.contender == "cgal") p.print({r});
    };
    expect_close("tree.closest.tri1m", bench::sum_of_distances(ours, near), sum());
    expect_close("tree.ray.tri1m", static_cast<double>(bench::rays_that_hit(ours, near)), static_cast<double>(hits()));
    row("tree.build.tri1m", [&] { return concino::bounding_tree(m); }, [&] { return built(s); });
    row("tree.closest.tri1m", [&] { return bench::sum_of_distances(ours, near); }, sum);
    row("tree.ray.tri1m", [&] { return bench::rays_that_hit(ours, near); }, hits);
  });
}
