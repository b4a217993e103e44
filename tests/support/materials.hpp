// The materials of a mesh, without the names of files, for comparisons.
#pragma once

#include <concino/core/rgba.hpp>
#include <concino/io/load.hpp>
#include <concino/io/material_table.hpp>
#include <concino/mesh/trimesh.hpp>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace concino::testing {

struct said_materials {
  std::vector<material> materials;  // by name
  std::vector<std::string> names;   // of polys
  std::vector<rgba> colors;

  bool operator==(const said_materials&) const = default;
};

template<class M>
said_materials said_of(const M& m) {
  said_materials s;
  if (const auto t = find_mesh_property<material_table>(m, "materials")) s.materials = t->materials;
  std::sort(s.materials.begin(), s.materials.end(), [](const material& a, const material& b) { return a.name < b.name; });
  const auto name = find_poly_property<std::string>(m, "material");
  const auto color = find_poly_property<rgba>(m, "color");
  for (const auto p : polys(m)) {
    s.names.push_back(name ? name[p] : "");
    s.colors.push_back(color ? color[p] : rgba{});
  }
  return s;
}

/// The materials of the mesh in a file; none if the file does not exist.
inline said_materials said_in(const std::string& path) { return std::filesystem::exists(path) ? said_of(load<trimesh>(path)) : said_materials{}; }

/// Two triangles with colours and without materials.
inline trimesh colored(float r) {
  trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}});
  const auto color = poly_property<rgba>(m, "color");
  color[poly_id{0}] = {r, 0, 0};
  color[poly_id{1}] = {0, r, 0};
  return m;
}

}  // namespace concino::testing
