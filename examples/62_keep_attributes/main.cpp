// Keep attributes from file to file: labels of polys, edges and verts, their names, and values. What a format cannot hold is in the report of save, and what a
// mesh has after load is in its list of properties.
#include <concino/io.hpp>
#include <concino/mesh.hpp>

#include <fmt/core.h>

namespace cn = concino;

/// Saves a mesh, loads it again, and prints what it has then. Result: what was loaded.
cn::trimesh through(const cn::trimesh& m, const std::string& path) {
  cn::save_report saved;
  cn::load_report loaded;
  cn::save(m, path, {.report = &saved});
  auto back = cn::load<cn::trimesh>(path, {.report = &loaded});
  fmt::print("{}\n", path);
  for (const auto& p : cn::property_list(back)) fmt::print("  {} \"{}\"\n", cn::to_string(p.kind), p.name);
  for (const auto& what : saved.lost) fmt::print("  lost: {}\n", what);
  for (const auto& what : loaded.skipped) fmt::print("  skipped: {}\n", what);
  return back;
}

int main() {
  // A plate of two materials. Its left edges are a wall, and one corner is fixed.
  cn::trimesh plate({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}}, {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}});
  const auto material = cn::poly_property<int>(plate, "label");
  for (const auto p : cn::polys(plate)) material[p] = p.raw() < 2 ? 10 : 20;
  const auto wall = cn::edge_property<int>(plate, "label");
  for (const auto e : cn::edges(plate)) {
    bool is_left = true;
    for (const auto v : cn::adj_e2v(plate, e)) is_left = is_left && cn::point(plate, v).x == 0;
    wall[e] = is_left ? 5 : 0;
  }
  cn::vert_property<int>(plate, "label")[cn::vert_id{2}] = 1;
  const auto heat = cn::vert_property<double>(plate, "heat");
  for (const auto v : cn::verts(plate)) heat[v] = 20 + 30 * cn::point(plate, v).x;
  const auto order = cn::poly_property<float>(plate, "order");
  for (const auto p : cn::polys(plate)) order[p] = static_cast<float>(p.raw());

  // Labels have names in the mesh property "label_names", for each kind of element.
  *cn::mesh_property<cn::label_names>(plate, "label_names") = {
      {{cn::element_kind::poly, 10, "steel"}, {cn::element_kind::poly, 20, "copper"}, {cn::element_kind::edge, 5, "wall"}, {cn::element_kind::vert, 1, "fixed"}}};

  // Gmsh holds all of this, but writes all numbers as doubles. The others hold less.
  const auto from_gmsh = through(plate, "plate.msh");
  through(plate, "plate.mesh");
  through(plate, "plate.vtu");
  const auto from_ply = through(plate, "plate.ply");

  // So the way to a program matters: from PLY, Gmsh gets no names any more.
  through(from_ply, "plate_of_ply.msh");
  const auto names = cn::find_mesh_property<cn::label_names>(from_gmsh, "label_names");
  for (const auto p : cn::polys(from_gmsh)) {
    const int label = cn::find_poly_property<int>(from_gmsh, "label")[p];
    fmt::print("poly {}: {}, {}\n", p.raw(), label, names->find(cn::element_kind::poly, label)->name);
  }

  // Where nothing may be lost, save refuses before it touches the file.
  try {
    cn::save(plate, "plate.mesh", {.strict = true});
  } catch (const cn::unsupported& e) {
    fmt::print("{}\n", e.what());
  }
}
