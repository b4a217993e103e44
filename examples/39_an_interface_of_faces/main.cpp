// An interface becomes faces of the mesh: two materials meet in a sphere that does not follow the cells. Embedding cuts the cells along it, so that each lies on
// one side and can have a material of its own. The mesh itself is changed, and keeps its properties; in a transaction it can be undone.
#include <concino/edit.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/level_sets.hpp>
#include <concino/mesh.hpp>
#include <concino/render/position_criteria.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_png.hpp>
#include <concino/render/value_criteria.hpp>

#include <fmt/core.h>

#include <cstddef>
#include <vector>

namespace cn = concino;

/// Embeds the sphere, and prints what becomes of the mesh. Draws it if there is a name of a file.
template<class M>
void embed_sphere(const char* name, M m, const char* picture = nullptr) {
  // The function is a property of the mesh, so that it grows with it: at new verts it is interpolated.
  const auto height = cn::vert_property<double>(m, "height");
  const auto number = cn::poly_property<int>(m, "number");
  for (const auto v : cn::verts(m)) height[v] = cn::distance(cn::point(m, v), {0.48, 0.51, 0.53}) - 0.35;
  for (const auto p : cn::polys(m)) number[p] = static_cast<int>(p.raw());
  fmt::print("{}: {} verts, {} polys\n", name, cn::num_verts(m), cn::num_polys(m));

  cn::transaction t(m);
  const auto sphere = cn::embed_isosurface(m, "height", 0, {.snap = 0.05});
  fmt::print("  embedded: {} new verts, {} snapped, {} polys, {} faces on the sphere\n", sphere.verts.size(), sphere.snapped.size(), cn::num_polys(m), sphere.faces.size());
  double area = 0, inside = 0, outside = 0;
  auto material = cn::make_poly_map<int>(m);
  for (const auto f : sphere.faces) area += cn::area(m, f);
  for (const auto p : cn::polys(m)) {
    bool is_inside = false;
    for (const auto v : cn::adj_p2v(m, p)) is_inside = is_inside || height[v] < 0;
    (is_inside ? inside : outside) += cn::measure(m, p);
    material[p] = is_inside;
  }
  fmt::print("  area {:.3f}; volume {:.3f} inside and {:.3f} outside\n", area, inside, outside);
  if (picture) {
    cn::scene s;
    s.add(m, {.labels = material, .edges = true, .visible = cn::below('z', 0.5) || cn::labeled(material, {1})});
    cn::save_png(s, picture, {.width = 380, .height = 320, .up = {0, 0, 1}});
  }

  // Parts of a cell have its number.
  std::vector<int> parts(1000);
  for (const auto p : cn::polys(m)) ++parts[static_cast<std::size_t>(number[p])];
  fmt::print("  cell 43 has {} part{}\n", parts[43], parts[43] == 1 ? "" : "s");
  t.roll_back();
  fmt::print("  undone: {} verts, {} polys\n", cn::num_verts(m), cn::num_polys(m));
}

int main(int argc, char** argv) {
  embed_sphere("tets", cn::make_grid<cn::tetmesh>({.cells = {5, 5, 5}}));
  embed_sphere("polyhedra", cn::make_grid<cn::polyhedralmesh>({.cells = {5, 5, 5}}), argc > 1 ? argv[1] : nullptr);
}
