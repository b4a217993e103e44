// Read anything and look at it: the file says which kind of mesh it holds, reports say what was not kept, and errors say where a file is wrong.
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/io.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>

#include <fmt/core.h>

#include <fstream>
#include <variant>
#include <vector>

namespace cn = concino;

/// Such files as people send. Your own program has them already.
void write_files() {
  cn::save(cn::icosphere(3), "scan.stl", {.binary = true});
  cn::save(cn::dual_mesh(cn::icosphere(2)), "tiles.ply");
  const cn::box cube{{0, 0, 0}, {1, 1, 1}};
  cn::save(cn::voronoi_polyhedra(cn::random_points(60, cube, 1), cube), "case/constant/polyMesh");
  cn::save(cn::make_grid<cn::tetmesh>({.cells = {4, 4, 2}}), "part.ele");
  std::ofstream("bridge.inp") << "*HEADING\nthree blocks\n*NODE, NSET=all\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n6, 1, 0, 1\n7, 1, 1, 1\n8, 0, 1, 1\n"
                                 "9, 0.5, 0.5, 1.7\n*ELEMENT, TYPE=C3D8R, ELSET=concrete\n1, 1, 2, 3, 4, 5, 6, 7, 8\n*ELEMENT, TYPE=C3D5, ELSET=steel\n2, 5, 6, 7, 8, 9\n"
                                 "*MATERIAL, NAME=concrete\n*STEP\n";
  std::ofstream("broken.off") << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n";
}

const char* name_of(const cn::trimesh&) { return "triangles"; }
const char* name_of(const cn::quadmesh&) { return "quads"; }
const char* name_of(const cn::polygonmesh&) { return "polygons"; }
const char* name_of(const cn::tetmesh&) { return "tets"; }
const char* name_of(const cn::hexmesh&) { return "hexes"; }
const char* name_of(const cn::polyhedralmesh&) { return "polyhedra"; }

int main(int argc, char** argv) {
  write_files();
  std::vector<cn::image> pictures;
  std::vector<std::string> captions;
  for (const char* path : {"scan.stl", "tiles.ply", "case", "part.ele", "bridge.inp", "broken.off", "letter.txt"}) {
    // load_any returns one of six kinds: the most special one that holds what is in the file.
    cn::load_report report;
    cn::any_mesh mesh;
    try {
      mesh = cn::load_any(path, {.report = &report});
    } catch (const cn::error& e) {  // one sentence: which file, which line, what should be there
      fmt::print("{}\n", e.what());
      continue;
    }
    // One function looks at all of them.
    std::visit(
        [&](const auto& m) {
          const auto size = cn::bounding_box(m).diagonal();
          fmt::print("{}: {} {}, {} verts, diagonal {:.3f}\n", path, cn::num_polys(m), name_of(m), cn::num_verts(m), size);
          for (const auto& p : cn::property_list(m)) fmt::print("  {} \"{}\"\n", cn::to_string(p.kind), p.name);
          for (const auto& what : report.skipped) fmt::print("  skipped: {}\n", what);
          for (const auto& what : report.notes) fmt::print("  note: {}\n", what);
          if (argc > 1) {
            cn::scene s;
            s.add(m, {.edges = true});
            pictures.push_back(cn::render(s, {.width = 200, .height = 200, .camera = cn::view_options{.towards = {1, -0.8, 0.6}, .up = {0, 0, 1}}, .samples = 4, .ground = false}));
            captions.push_back(path);
          }
        },
        mesh);
  }
  if (argc > 1) cn::save_png(cn::make_sheet(pictures, {.columns = 5, .captions = captions}), argv[1]);
}
