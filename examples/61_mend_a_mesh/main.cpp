// Mend a mesh from the internet: see what is wrong, say what shall be mended, read what was done and what is left. The same for polyhedra, and for meshes
// of other libraries.
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/io.hpp>
#include <concino/mesh.hpp>
#include <concino/repair.hpp>
#include <concino/validate.hpp>

#include <fmt/core.h>

#include <fstream>

namespace cn = concino;

void say(const cn::repair_result& fix) {
  for (const auto& what : fix.done) fmt::print("  done: {}\n", what);
  for (const auto& what : fix.left) fmt::print("  left: {}\n", what);
}

int main() {
  // Such files are common: each triangle has three points of its own, some run the wrong way round, one is there twice, one is missing.
  const auto ball = cn::icosphere(3);
  {
    std::ofstream file("from_the_internet.obj");
    const auto add = [&](cn::poly_id p, bool turned) {
      for (const auto v : cn::adj_p2v(ball, p)) file << fmt::format("v {:.6f} {:.6f} {:.6f}\n", cn::point(ball, v).x, cn::point(ball, v).y, cn::point(ball, v).z);
      file << (turned ? "f -1 -2 -3\n" : "f -3 -2 -1\n");
    };
    for (const auto p : cn::polys(ball))
      if (p != cn::poly_id{77}) add(p, p.raw() % 5 == 0);
    add(cn::poly_id{100}, false);
  }
  auto m = cn::load<cn::trimesh>("from_the_internet.obj");
  auto facts = cn::validate(m).facts;
  fmt::print("{} verts, {} components, closed: {}\n", cn::num_verts(m), facts.components, facts.closed);

  // Labels and other properties stay with their elements.
  const auto label = cn::poly_property<int>(m, "label");
  for (const auto p : cn::polys(m)) label[p] = cn::centroid(m, p).z > 0 ? 1 : 2;

  // By default, repair does what has one right answer. All else is asked for: how close verts are that are the same, the size of holes.
  auto fix = cn::repair(m, {.merge_within = 1e-5, .orient = true, .fill_holes = 10});
  say(fix);
  facts = cn::validate(m).facts;
  fmt::print("{} verts, {} component, closed: {}, {} defects\n", cn::num_verts(m), facts.components, facts.closed, cn::validate(m).count());
  const auto kept = cn::find_poly_property<int>(m, "label");
  std::size_t above = 0;
  for (const auto p : cn::polys(m)) above += kept[p] == 1;
  fmt::print("{} polys have label 1; {} elements of the mesh before are in the records of merged verts\n", above, fix.count(cn::repair_kind::merged_verts));

  // A mended mesh comes back as it is.
  fmt::print("again: {} changes\n", cn::repair(m, {.merge_within = 1e-5, .orient = true, .fill_holes = 10}).done.size());

  // Polyhedra: two cubes that touch, each with verts and faces of its own, become neighbours. The second one is inside out.
  const std::vector<cn::vec3> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1},
                                     {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 0, 1}, {2, 0, 1}, {2, 1, 1}, {1, 1, 1}};
  std::vector<std::vector<unsigned>> faces;
  std::vector<std::vector<cn::list_face>> cells(2);
  for (unsigned c = 0; c < 2; ++c)
    for (const auto& f : std::vector<std::vector<unsigned>>{{0, 3, 2, 1}, {1, 2, 6, 5}, {4, 5, 6, 7}, {3, 0, 4, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}}) {
      cells[c].push_back({faces.size(), c == 0});
      faces.push_back({f[0] + 8 * c, f[1] + 8 * c, f[2] + 8 * c, f[3] + 8 * c});
    }
  cn::polyhedralmesh cubes(points, faces, cells);
  say(cn::repair(cubes, {.merge_within = 0.0}));
  fmt::print("{} faces, volume {}\n", cn::num_faces(cubes), cn::total_measure(cubes));
}
