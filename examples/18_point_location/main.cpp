// Find the cell that contains a point, with a tree of boxes. It takes a few comparisons, for cells of any shape. For a point on the face between two cells it
// always returns the same one of them. A tree over the boundary returns the distance to it, and whether a point is inside.
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace cn = concino;

int main() {
  // The Voronoi cells of some sites in a block: a point must be in the cell of its nearest site.
  cn::box block;
  block.add({0, 0, 0});
  block.add({2, 1, 1});
  const std::vector<cn::vec3> sites = cn::random_points(500, block, 1);
  const cn::polyhedralmesh cells = cn::voronoi_polyhedra(sites, block);
  const auto tree = cn::bounding_tree(cells);

  const auto nearest_site = [&](const cn::vec3& x) {
    const auto nearer = [&](const cn::vec3& a, const cn::vec3& b) { return cn::distance(x, a) < cn::distance(x, b); };
    return static_cast<std::size_t>(std::min_element(sites.begin(), sites.end(), nearer) - sites.begin());
  };
  std::size_t same = 0;
  const auto probes = cn::random_points(10000, block, 2);
  for (const cn::vec3& x : probes) {
    const auto cell = tree.locate(x);
    same += cell && cell->raw() == nearest_site(x);
  }
  fmt::print("{} of {} random points are in the cell of the nearest site\n", same, probes.size());

  std::size_t found = 0, corners = 0;
  for (const auto v : cn::verts(cells)) {
    found += tree.locate(cn::point(cells, v)).has_value();
    ++corners;
  }
  fmt::print("{} of {} corners of cells are in a cell\n", found, corners);

  // The boundary of the block is a mesh too: a view whose polys are faces of the cells.
  const auto skin = cn::boundary(cells);
  const auto around = cn::bounding_tree(skin);
  for (const cn::vec3 x : {cn::vec3{1, 0.5, 0.75}, cn::vec3{3, 0.5, 0.5}, cn::vec3{2, 1, 1}}) {
    const auto hit = around.closest(x);
    fmt::print("({}, {}, {}) is {} the block, {:.3f} from ({:.3f}, {:.3f}, {:.3f}) on its boundary\n", x.x, x.y, x.z,
               around.is_inside(x) ? "inside" : "outside", hit.distance, hit.point.x, hit.point.y, hit.point.z);
  }

  // The cells along a ray through the block, and the cells in a corner of it.
  const auto passed = tree.ray_all({-1, 0.5, 0.5}, {1, 0, 0});
  fmt::print("a ray through the middle passes {} cells, from parameter {:.3f} on\n", passed.size(), passed.front().parameter);
  cn::box corner;
  corner.add({0, 0, 0});
  corner.add({0.2, 0.2, 0.2});
  fmt::print("{} cells reach into a corner of the block\n", tree.in_box(corner).size());
}
