// The triangles and verts of a glTF file: verts are split where polys of different colours meet.
#pragma once

#include <concino/core/rgba.hpp>
#include <concino/io/flat_triangles.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <tuple>
#include <vector>

namespace concino::detail {

class gltf_triangles {
  std::vector<std::uint32_t> polys_;    // of the triangles
  std::vector<std::uint32_t> origins_;  // the number in the mesh of each vert of the file; empty if all are equal

 public:
  std::vector<std::uint32_t> verts;  // three of each triangle
  std::vector<rgba> colors;          // of the verts of the file, once they were split

  /// The triangles of a mesh, with its verts. Errors: as flat_triangles.
  gltf_triangles(write_context& c, const flat_mesh& m) {
    flat_triangles triangles(c, m, ".glb", ".ply or .obj");
    for (std::size_t p = 0; p < m.num_polys; ++p)
      for (const std::array<vert_id, 3>& t : triangles(p)) {
        for (const vert_id v : t) verts.push_back(v.raw());
        polys_.push_back(static_cast<std::uint32_t>(p));
      }
    triangles.report_cut(c.report);
  }

  std::size_t num_verts(const flat_mesh& m) const { return origins_.empty() ? m.points.size() : origins_.size(); }
  /// The number in the mesh of a vert of the file.
  std::size_t origin(std::size_t i) const { return origins_.empty() ? i : origins_[i]; }

  /// Colours belong to verts in glTF: a vert where polys of different colours meet becomes one for each colour.
  void split_verts(const flat_mesh& m, const flat_values<rgba>& poly_colors, save_report& report) {
    struct corner {
      std::uint32_t vert, at;
      rgba color;
    };
    const auto key = [](const corner& x) {
      return std::tuple(x.vert, std::bit_cast<std::uint32_t>(x.color.r), std::bit_cast<std::uint32_t>(x.color.g),
                        std::bit_cast<std::uint32_t>(x.color.b), std::bit_cast<std::uint32_t>(x.color.a));
    };
    std::vector<corner> all;
    std::vector<bool> is_used(m.points.size());
    for (std::size_t i = 0; i < verts.size(); ++i) {
      all.push_back({verts[i], static_cast<std::uint32_t>(i), poly_colors[polys_[i / 3]]});
      is_used[verts[i]] = true;
    }
    for (std::uint32_t v = 0; v < is_used.size(); ++v)
      if (!is_used[v]) all.push_back({v, ~0u, {}});
    std::sort(all.begin(), all.end(), [&](const corner& a, const corner& b) { return key(a) < key(b); });
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i == 0 || key(all[i]) != key(all[i - 1])) {
        origins_.push_back(all[i].vert);
        colors.push_back(all[i].color);
      }
      if (all[i].at != ~0u) verts[all[i].at] = static_cast<std::uint32_t>(origins_.size() - 1);
    }
    if (const std::size_t added = origins_.size() - m.points.size())
      report.notes.push_back(core::joined({added, " verts were added where polys of different colours meet"}));
  }
};

}  // namespace concino::detail
