// Exchanges files with meshio, which second_opinion.py runs:
//   exchange write FOLDER   writes meshes of several kinds to VTK, PLY, STL and Gmsh files in FOLDER, and prints each name and what the file holds
//   exchange read FILE...   reads files, and prints the same
// A description has lines of words: file NAME, point X Y Z, cell NUMBER_OF_FACES VERT..., and for each property: vert NAME or poly NAME, and all its numbers.
#include <concino/io.hpp>
#include <concino/mesh.hpp>

#include <concino/adapters/zlib.hpp>

#include <fmt/core.h>

#include <cstring>
#include <string>
#include <variant>
#include <vector>

namespace cn = concino;

namespace {

template<class T, class Elements, class Property>
void print_property(const char* kind, const char* name, const Elements& elements, const Property& values) {
  if (!values) return;
  fmt::print("{} {}", kind, name);
  for (const auto x : elements) {
    if constexpr (std::is_same_v<T, cn::vec3>) fmt::print(" {} {} {}", values[x].x, values[x].y, values[x].z);
    else fmt::print(" {}", values[x]);
  }
  fmt::print("\n");
}

template<class M>
void print_points_and_cells(const std::string& name, const M& m) {
  fmt::print("file {}\n", name);
  for (const auto v : cn::verts(m)) fmt::print("point {} {} {}\n", cn::point(m, v).x, cn::point(m, v).y, cn::point(m, v).z);
  for (const auto p : cn::polys(m)) {
    std::size_t faces = 1;
    if constexpr (cn::dimension_v<M> == 3) faces = cn::num_elements(cn::adj_p2f(m, p));
    fmt::print("cell {}", faces);
    for (const auto v : cn::adj_p2v(m, p)) fmt::print(" {}", v.raw());
    fmt::print("\n");
  }
}
template<class M>
void print_mesh(const std::string& name, const M& m) {
  print_points_and_cells(name, m);
  print_property<double>("vert", "heat", cn::verts(m), cn::find_vert_property<double>(m, "heat"));
  print_property<cn::vec3>("vert", "velocity", cn::verts(m), cn::find_vert_property<cn::vec3>(m, "velocity"));
  print_property<std::int64_t>("poly", "number", cn::polys(m), cn::find_poly_property<std::int64_t>(m, "number"));
  print_property<double>("poly", "pressure", cn::polys(m), cn::find_poly_property<double>(m, "pressure"));
  if (!name.ends_with(".msh")) return;
  print_property<int>("poly", "gmsh:physical", cn::polys(m), cn::find_poly_property<int>(m, "label"));
  print_property<int>("poly", "gmsh:geometrical", cn::polys(m), cn::find_poly_property<int>(m, "entity_tag"));
  if (const auto names = cn::find_mesh_property<cn::label_names>(m, "label_names"))
    for (const cn::label_name& n : (*names).names) fmt::print("name {} {} {}\n", n.name, n.label, n.kind == cn::element_kind::poly ? cn::dimension_v<M> : 0);
}

/// Writes Gmsh files, with groups of polys and their names.
template<class M>
void write_gmsh(const std::string& folder, const std::string& name, M m) {
  if (name == "polygons") return;
  auto label = cn::poly_property<int>(m, "label"), entity = cn::poly_property<int>(m, "entity_tag");
  for (const auto p : cn::polys(m)) {
    label[p] = p.raw() % 2 ? 7 : 3;
    entity[p] = p.raw() % 2 ? 12 : 40;
    if (name != "mixed") cn::poly_property<double>(m, "pressure")[p] = 1.0 / (3 + p.raw());  // of several shapes meshio divides values wrongly
  }
  auto& names = cn::mesh_property<cn::label_names>(m, "label_names")->names;
  names = {{cn::element_kind::poly, 3, "steel", {}}, {cn::element_kind::poly, 7, "wood", {}}, {cn::element_kind::vert, 1, "corner", {}}};
  for (const bool binary : {false, true}) {
    const std::string file = name + (binary ? "_binary" : "_text") + ".msh";
    cn::save(m, folder + "/" + file, {.binary = binary});
    print_mesh(file, m);
  }
}

template<class M>
void write_mesh(const std::string& folder, const std::string& name, M m) {
  auto heat = cn::vert_property<double>(m, "heat");
  auto velocity = cn::vert_property<cn::vec3>(m, "velocity");
  double x = 0.1;
  for (const auto v : cn::verts(m)) {
    heat[v] = x *= -1.7;
    velocity[v] = {x / 3, 1e-30 * x, 0};
  }
  if constexpr (cn::dimension_v<M> == 2)  // of surfaces; without values of polys, which meshio does not read from binary PLY files
    for (const bool binary : {false, true}) {
      const std::string file = name + (binary ? "_binary" : "_text");
      cn::save(m, folder + "/" + file + ".ply", {.binary = binary});
      print_mesh(file + ".ply", m);
      if (cn::arity_v<M> != 3) continue;
      cn::save(m, folder + "/" + file + ".stl", {.binary = binary});
      print_mesh(file + ".stl", m);
    }
  write_gmsh(folder, name, m);
  if constexpr (cn::dimension_v<M> == 3)  // TetGen's files hold tets
    if (cn::arity_v<M> == 4) {
      cn::save(m, folder + "/" + name + ".ele");
      print_points_and_cells(name + ".ele", m);
    }
  auto number = cn::poly_property<std::int64_t>(m, "number");
  auto pressure = cn::poly_property<double>(m, "pressure");
  for (const auto p : cn::polys(m)) {
    number[p] = 7 - 3 * static_cast<std::int64_t>(p.raw());
    pressure[p] = 1.0 / (3 + p.raw());
  }
  for (const bool binary : {false, true})
    for (const char* extension : {".vtk", ".vtu"}) {
      const std::string file = name + (binary ? "_binary" : "_text") + extension;
      cn::save(m, folder + "/" + file, {.binary = binary});
      print_mesh(file, m);
    }
}

constexpr const char* cells =
    "MeshVersionFormatted 2 Dimension 3 Vertices 11 0 0 0 0 1 0 0 0 1 1 0 0 0 1 0 0 0 0 1.25 0 1 0 1 0 1 1 1 0 0 1 1 0 .5 .5 2 0 2 0 .3333333333333333 0 2 1 .5 0 ";

}  // namespace

int main(int argc, char** argv) {
  using cn::load_text;
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() == 2 && words[0] == "write") {
    write_mesh(words[1], "tets", load_text<cn::tetmesh>(std::string(cells) + "Tetrahedra 2 1 2 3 6 0 1 3 4 8 0 End", cn::file_format::medit));
    write_mesh(words[1], "hex", load_text<cn::hexmesh>(std::string(cells) + "Hexahedra 1 1 2 3 4 5 6 7 8 0 End", cn::file_format::medit));
    write_mesh(words[1], "mixed",
               load_text<cn::polyhedralmesh>(std::string(cells) + "Hexahedra 1 1 2 3 4 5 6 7 8 0 Pyramids 1 5 6 7 8 9 0 Prisms 1 2 10 6 3 11 7 0 Tetrahedra 1 2 10 6 9 0 End",
                                             cn::file_format::medit));
    write_mesh(words[1], "triangles", load_text<cn::trimesh>("v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nf 1 2 3\nf 1 3 4\n", cn::file_format::obj));
    write_mesh(words[1], "quads", load_text<cn::quadmesh>("v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nv 2 0 0\nv 2 1 0\nf 1 2 3 4\nf 2 5 6 3\n", cn::file_format::obj));
    write_mesh(words[1], "polygons", load_text<cn::polygonmesh>("v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nv -1 .5 0\nf 1 2 3 4\nf 1 4 5\n", cn::file_format::obj));
    return 0;
  }
  if (words.size() >= 2 && words[0] == "read") {
    for (std::size_t i = 1; i < words.size(); ++i)
      std::visit([&](const auto& m) { print_mesh(words[i], m); }, cn::load_any(words[i], {.inflate = cn::zlib_inflate}));
    return 0;
  }
  return 2;
}
