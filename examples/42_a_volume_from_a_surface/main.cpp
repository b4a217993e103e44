// Makes volumes of surfaces: by moving them, turning them around an axis, thickening them, or filling them with cubes; then a surface of a volume again, and one mesh of two.
// Named properties follow.
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>
#include <concino/render/position_criteria.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_png.hpp>
#include <concino/render/sheet.hpp>

#include <fmt/core.h>

namespace cn = concino;

int main(int argc, char** argv) {
  // Quads become hexes, other polygons prisms. Each cell has the label of its polygon.
  auto floor = cn::make_grid<cn::quadmesh>({.cells = {4, 3, 1}, .max = {4, 3, 0}});
  const auto label = cn::poly_property<int>(floor, "label");
  for (const auto p : cn::polys(floor)) label[p] = cn::centroid(floor, p).x < 1 ? 1 : 2;
  const cn::hexmesh block = cn::extrude(floor, {0, 0, 2}, 5);
  const auto label_of = cn::find_poly_property<int>(block, "label");
  double labelled = 0;
  for (const auto p : cn::polys(block)) labelled += label_of[p] == 1 ? cn::volume(block, p) : 0;
  fmt::print("{} quads, {} hexes of volume {:.3f}, {:.3f} of it with label 1\n", cn::num_polys(floor), cn::num_polys(block), cn::total_measure(block), labelled);
  const cn::polyhedralmesh prisms = cn::extrude(cn::make_grid<cn::polygonmesh>(), {0.5, 0, -1});
  fmt::print("{} prisms of volume {:.3f}\n", cn::num_polys(prisms), cn::total_measure(prisms));

  // A whole turn around the y axis joins the last layer to the first. Verts on the axis are not repeated.
  const auto half = cn::make_grid<cn::trimesh>({.cells = {6, 6, 1}});
  const cn::polyhedralmesh drum = cn::revolve(half, {0, 0, 0}, {0, 1, 0}, 64);
  const cn::polyhedralmesh quarter = cn::revolve(half, {-1, 0, 0}, {0, 1, 0}, 16, {.angle_deg = 90});
  fmt::print("{} verts turn into {} of a drum of volume {:.3f}, or {} of a quarter of a ring of volume {:.3f}\n", cn::num_verts(half), cn::num_verts(drum),
             cn::total_measure(drum), cn::num_verts(quarter), cn::total_measure(quarter));

  // A shell, 0.2 thick. If the offset were inverted somewhere, the call would name the poly, or list all of them.
  const auto sphere = cn::make_sphere<cn::quadmesh>({.cells = 16});
  const cn::hexmesh shell = cn::offset_shell(sphere, -0.2, 2);
  std::vector<cn::poly_id> inverted;
  cn::offset_shell(sphere, -1.2, 2, {.inverted = &inverted});
  fmt::print("a shell of {} hexes of volume {:.3f}; if it were six times as thick, {} would be inverted\n", cn::num_polys(shell), cn::total_measure(shell), inverted.size());

  // Cubes inside a closed surface.
  const cn::hexmesh cubes = cn::voxel_hexes(cn::make_torus<cn::trimesh>(), 64);
  fmt::print("{} cubes of volume {:.3f} in a torus of volume {:.3f}\n", cn::num_polys(cubes), cn::total_measure(cubes), cn::total_measure(cn::make_torus<cn::hexmesh>()));

  // The boundary of a volume is a mesh of its own. Its polys know the faces of the volume that they were.
  cn::correspondence of;
  const cn::quadmesh skin = cn::boundary_surface(shell, {.correspondence = &of});
  const cn::face_id face{of.polys.only(0)};
  fmt::print("its boundary has {} quads, of area {:.3f}; the first one is a face of {} poly\n", cn::num_polys(skin), cn::total_measure(skin),
             cn::num_elements(cn::adj_f2p(shell, face)));

  // Two blocks that touch become one, in which they share verts and faces.
  const auto next = cn::make_grid<cn::hexmesh>({.cells = {2, 3, 5}, .min = {4, 0, 0}, .max = {6, 3, 2}});
  const cn::hexmesh both = cn::unite(block, next);
  fmt::print("{} + {} verts become {}, {} + {} faces {}\n", cn::num_verts(block), cn::num_verts(next), cn::num_verts(both), cn::num_faces(block), cn::num_faces(next),
             cn::num_faces(both));

  // A picture, if the program is given the name of a file.
  if (argc > 1) {
    cn::scene scenes[4];
    scenes[0].add(block, {.labels = label_of, .edges = true});
    scenes[1].add(quarter, {.edges = true});
    scenes[2].add(shell, {.edges = true, .visible = cn::below('x', 0)});
    scenes[3].add(cubes, {.edges = true, .edge_width = 0.8});
    std::vector<cn::image> pictures;
    for (const auto& s : scenes) pictures.push_back(cn::render(s, {.width = 220, .height = 190}));
    cn::save_png(cn::make_sheet(pictures, {.columns = 2, .captions = {"extruded", "revolved", "a thick shell", "cubes in a torus"}}), argv[1]);
  }
}
