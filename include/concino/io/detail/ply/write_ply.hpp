// The writer of PLY: as text, or little-endian on request.
#pragma once

#include <concino/io/detail/ply/ply_format.hpp>
#include <concino/io/detail/ply/ply_output.hpp>

#include <array>
#include <cmath>

namespace concino::detail {

class ply_writer {
  using texture = std::array<double, 2>;

  write_context& c_;
  flat_mesh& m_;
  ply_numbers_output out_;
  const std::vector<flat_property> list_;
  ply_output of_verts_, of_polys_;
  flat_values<texture> textures_;
  bool has_texture_ = false, corners_are_bytes_ = true, textures_are_bytes_ = true;
  std::uint64_t num_partial_ = 0;  // polys with texture coordinates at some corners only

 public:
  ply_writer(write_context& c, flat_mesh& m)
      : c_(c), m_(m), out_(c.out, c.options.binary), list_(m.property_list()),
        of_verts_(c, list_, element_kind::vert, m.points.size()), of_polys_(c, list_, element_kind::poly, m.num_polys),
        textures_(m.corner_values<texture>("texture")) {
    for (std::size_t p = 0, corner = 0; p < m.num_polys; corner += m.poly_verts[p++].size()) {
      const std::size_t n = m.poly_verts[p].size(), given = num_textures(corner, n);
      corners_are_bytes_ = corners_are_bytes_ && n < 256;
      textures_are_bytes_ = textures_are_bytes_ && 2 * n < 256;
      has_texture_ = has_texture_ || given == n;
      num_partial_ += given != 0 && given != n;
    }
    if (textures_ && (has_texture_ || m.num_polys == 0)) c.declare_stored<texture>(element_kind::corner, "texture");
  }

  void write() {
    const bool has_large_ids = m_.points.size() > 0x7FFFFFFFu;
    const char* const index = has_large_ids ? "uint" : "int";
    const std::vector<flat_property> list = m_.edge_property_list();
    const ply_output of_edges(c_, list, element_kind::edge, list.empty() ? 0 : m_.edge_verts().size());
    std::vector<std::uint32_t> edges;  // with values
    for (std::uint32_t e = 0; !of_edges.all.empty() && e < m_.edge_verts().size(); ++e)
      if (of_edges.has_value(e)) edges.push_back(e);
    c_.out << "ply\nformat " << (c_.options.binary ? "binary_little_endian" : "ascii") << " 1.0\nelement vertex "
           << m_.points.size() << "\nproperty double x\nproperty double y\nproperty double z\n";
    of_verts_.header();
    c_.out << "element face " << m_.num_polys << "\nproperty list " << (corners_are_bytes_ ? "uchar " : "uint ")
           << index << " vertex_indices\n";
    if (has_texture_)
      c_.out << "property list " << (textures_are_bytes_ ? "uchar" : "uint") << " double texcoord\n";
    of_polys_.header();
    if (!edges.empty()) {
      c_.out << "element edge " << edges.size() << "\nproperty " << index << " vertex1\nproperty " << index
             << " vertex2\n";
      of_edges.header();
    }
    c_.out << "end_header\n";
    verts();
    polys();
    for (const std::uint32_t e : edges) {
      for (const vert_id v : m_.edge_verts()[e]) out_.integer(v.raw());
      of_edges.values(out_, e);
      out_.end_element();
    }
    report(of_edges, edges.size());
  }

 private:
  /// How many of n corners have texture coordinates.
  std::size_t num_textures(std::size_t first, std::size_t n) const {
    std::size_t given = 0;
    for (std::size_t k = first; textures_ && k < first + n; ++k)
      given += !std::isnan(textures_[k][0]) || !std::isnan(textures_[k][1]);
    return given;
  }

  void verts() {
    for (std::size_t v = 0; v < m_.points.size(); ++v) {
      for (const double x : {m_.points[v].x, m_.points[v].y, m_.points[v].z}) out_.real(x);
      of_verts_.values(out_, v);
      out_.end_element();
      c_.report_progress();
    }
  }
  void polys() {
    for (std::size_t p = 0, corner = 0; p < m_.num_polys; ++p) {
      const std::span<const vert_id> verts = m_.poly_verts[p];
      out_.length(verts.size(), corners_are_bytes_);
      for (const vert_id v : verts) out_.integer(v.raw());
      if (has_texture_) {
        const std::size_t n = num_textures(corner, verts.size()) == verts.size() ? verts.size() : 0;
        out_.length(2 * n, textures_are_bytes_);
        for (std::size_t k = corner; k < corner + n; ++k)
          for (const double x : textures_[k]) out_.real(x);
      }
      corner += verts.size();
      of_polys_.values(out_, p);
      out_.end_element();
      c_.report_progress();
    }
  }

  void report(const ply_output& of_edges, std::size_t num_edges) {
    if (num_partial_)
      c_.report.lost.push_back(
          core::joined({"corner property \"texture\" of ", num_partial_,
                        " polys that have it at some corners only: .ply cannot store it"}));
    if (num_edges == 0)
      for (const ply_output_property& p : of_edges.all)
        c_.report.lost.push_back(
            core::joined({"edge property \"", p.property.name,
                          "\", which has default values only: .ply lists edges with other values"}));
  }
};

}  // namespace concino::detail

namespace concino {

inline void ply_format::write(write_context& c, flat_mesh& m) { detail::ply_writer(c, m).write(); }

}  // namespace concino
