// Writes .glb files to a folder: small meshes with all attributes, and every surface and volume of the corpus, which is the first of the other folders that
// exists. Names of files count up.
#include <concino/io/gltf.hpp>
#include <concino/io/load_any.hpp>
#include <concino/mesh/property.hpp>

#include <cstdio>
#include <filesystem>
#include <string>

using namespace concino;

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  int number = 0;
  const auto write = [&](const auto& m) { save_gltf(m, std::string(argv[1]) + "/" + std::to_string(number++) + ".glb", {.as_triangles = true, .as_boundary = true}); };
  write(trimesh());
  write(trimesh({{0, 0, 0}}, {}));
  trimesh m({{0, 0, 0.1}, {1, 0, -2e-30}, {1, 1, 3e30}, {0, 1, 0}, {5, 5, 5}}, {{0, 1, 2}, {0, 2, 3}});
  write(m);
  auto of_polys = poly_property<rgba>(m, "color");
  of_polys[poly_id{0}] = {1, 0.5f, 0, 0.5f};
  *mesh_property<std::string>(m, "name") = "\"\\\n\x7f\xff \xc3\xa9";
  write(m);
  auto normal = vert_property<vec3>(m, "normal");
  auto texture = vert_property<std::array<double, 2>>(m, "texture");
  auto color = vert_property<rgba>(m, "color");
  for (const auto v : verts(m)) normal[v] = {0.6, 0, -0.8003}, texture[v] = {-3, 0.1 * v.raw()}, color[v] = {0.2f, 7, -1, 1};
  write(m);
  for (int k = 2; k < argc; ++k) {
    if (!std::filesystem::is_directory(argv[k])) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(argv[k])) {
      const std::string path = entry.path().string();
      if (!entry.is_regular_file() || entry.file_size() > 2'000'000 || path.find("/bad/") != std::string::npos) continue;
      try {
        std::visit(write, load_any(path, {.repeated_verts = repeated_verts::collapse}));
      } catch (const error&) {  // not a mesh
        continue;
      }
      std::printf("%d.glb: %s\n", number - 1, path.c_str());
    }
    break;
  }
}
