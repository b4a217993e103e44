// The writer of glTF 2.0 in its binary form: a chunk of JSON, and a chunk of numbers.
#pragma once

#include <concino/io/detail/gltf/gltf_format.hpp>
#include <concino/io/detail/gltf/gltf_triangles.hpp>
#include <concino/io/detail/gltf/json_text.hpp>
#include <concino/io/detail/text/write_common.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace concino::detail {

class gltf_writer {
  write_context& c_;
  flat_mesh& m_;
  flat_values<vec3> normals_;
  flat_values<std::array<double, 2>> textures_;
  flat_values<rgba> vert_colors_, poly_colors_;
  gltf_triangles triangles_;
  bool rounded_ = false, is_translucent_ = false;
  std::size_t num_limited_ = 0;  // colours with a part that is not from 0 to 1
  text_sink json_;

  float stored(double x) {
    const float f = static_cast<float>(x);
    rounded_ = rounded_ || static_cast<double>(f) != x;
    return f;
  }

  /// The normals, if all are unit vectors, as glTF asks for.
  void choose_normals() {
    normals_ = m_.vert_values<vec3>("normal");
    for (std::size_t v = 0; normals_ && v < m_.points.size(); ++v)
      if (!(std::abs(norm(normals_[v]) - 1) < 1e-3)) normals_ = {};
    if (normals_) c_.declare_stored<vec3>(element_kind::vert, "normal");
  }

  /// A part of a colour: files hold linear ones, meshes those of screens (sRGB).
  static float linear(float x) {
    return x <= 0.04045f ? x / 12.92f : static_cast<float>(std::pow((static_cast<double>(x) + 0.055) / 1.055, 2.4));
  }
  static float limited(float x) { return x >= 0 ? std::min(x, 1.0f) : 0.0f; }
  std::array<float, 4> stored(const rgba& x) {
    const rgba y{limited(x.r), limited(x.g), limited(x.b), limited(x.a)};
    num_limited_ += x != y;
    is_translucent_ = is_translucent_ || y.a < 1;
    return {linear(y.r), linear(y.g), linear(y.b), y.a};
  }

  static void put(std::string& bytes, std::uint32_t x) {
    for (int i = 0; i < 4; ++i, x >>= 8) bytes += static_cast<char>(x & 255);
  }
  template<std::size_t N>
  static void put(std::string& bytes, const std::array<float, N>& values) {
    for (const float x : values) put(bytes, std::bit_cast<std::uint32_t>(x));
  }

  std::array<float, 3> position(std::size_t v) {
    const vec3& p = m_.points[triangles_.origin(v)];
    const std::array<float, 3> x{stored(p.x), stored(p.y), stored(p.z)};
    for (const float part : x)
      if (!std::isfinite(part))
        c_.throw_cannot_hold(".glb", {"a coordinate that is too large for floats"}, ".ply or .obj");
    return x;
  }

  /// A part of the buffer: the values of an attribute, or the indices.
  struct accessor {
    const char* name;  // of the attribute; null: the indices
    const char* type;
    std::size_t count, bytes;
  };

  void json(const std::vector<accessor>& all, const std::array<float, 3>& low, const std::array<float, 3>& high) {
    const std::string* const name = m_.mesh_value<std::string>("name");
    const std::string quoted =
        name && !name->empty() ? core::joined({"\"name\":", json_string(*name), ","}) : std::string();
    if (name) c_.declare_stored<std::string>(element_kind::mesh, "name");
    json_ << R"({"asset":{"version":"2.0","generator":"concino"},"scene":0,"scenes":[{)";
    if (all.empty()) {
      json_ << "}]}";
      return;
    }
    json_ << R"("nodes":[0]}],"nodes":[{)" << quoted << R"("mesh":0}],"meshes":[{)" << quoted
          << R"("primitives":[{"attributes":{)";
    for (std::size_t i = 0; i + 1 < all.size(); ++i) json_ << (i ? ",\"" : "\"") << all[i].name << "\":" << i;
    json_ << "},\"indices\":" << all.size() - 1 << R"(,"material":0,"mode":4}]}],"materials":[{)"
          << (is_translucent_ ? R"("alphaMode":"BLEND",)" : "")
          << R"("pbrMetallicRoughness":{"metallicFactor":0},"doubleSided":true}],"accessors":[)";
    for (std::size_t i = 0; i < all.size(); ++i) {
      json_ << (i ? ",{" : "{") << "\"bufferView\":" << i << ",\"componentType\":" << (all[i].name ? 5126 : 5125)
            << ",\"count\":" << all[i].count << ",\"type\":\"" << all[i].type << '"';
      for (const auto& [word, x] : {std::pair{"min", &low}, std::pair{"max", &high}})
        if (i == 0)
          json_ << ",\"" << word << "\":[" << static_cast<double>((*x)[0]) << ',' << static_cast<double>((*x)[1]) << ','
                << static_cast<double>((*x)[2]) << ']';
      json_ << '}';
    }
    json_ << "],\"bufferViews\":[";
    std::size_t offset = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::size_t length = all[i].count * all[i].bytes;
      json_ << (i ? ",{" : "{") << "\"buffer\":0,\"byteOffset\":" << offset << ",\"byteLength\":" << length
            << ",\"target\":" << (all[i].name ? 34962 : 34963) << '}';
      offset += length;
    }
    json_ << "],\"buffers\":[{\"byteLength\":" << offset << "}]}";
  }

 public:
  gltf_writer(write_context& c, flat_mesh& m)
      : c_(c), m_(m), textures_(m.vert_values<std::array<double, 2>>("texture")),
        vert_colors_(m.vert_values<rgba>("color")), poly_colors_(m.poly_values<rgba>("color")), triangles_(c, m) {}

  void write() {
    const bool is_empty = triangles_.verts.empty();
    choose_normals();
    if (textures_) c_.declare_stored<std::array<double, 2>>(element_kind::vert, "texture");
    if (vert_colors_) c_.declare_stored<rgba>(element_kind::vert, "color");
    else if (poly_colors_) {
      c_.declare_stored<rgba>(element_kind::poly, "color");
      triangles_.split_verts(m_, poly_colors_, c_.report);
    }
    std::vector<accessor> all;
    std::string bytes;
    std::array<float, 3> low{}, high{};
    if (!is_empty) {
      const std::size_t n = triangles_.num_verts(m_);
      all.push_back({"POSITION", "VEC3", n, 12});
      for (std::size_t v = 0; v < n; ++v) {
        const std::array<float, 3> x = position(v);
        if (v == 0) low = high = x;
        for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], x[k]), high[k] = std::max(high[k], x[k]);
        put(bytes, x);
        c_.report_progress();
      }
      attributes(all, bytes, n);
      all.push_back({nullptr, "SCALAR", triangles_.verts.size(), 4});
      for (const std::uint32_t v : triangles_.verts) put(bytes, v);
    } else if (!m_.points.empty()) {
      c_.report.lost.push_back(
          core::joined({m_.points.size(), " verts of no poly: .glb has no mesh without triangles"}));
    }
    json(all, low, high);
    std::string text = std::move(json_).release();
    text.append((4 - text.size() % 4) % 4, ' ');
    chunks(text, bytes);
    report();
  }

 private:
  void attributes(std::vector<accessor>& all, std::string& bytes, std::size_t n) {
    if (normals_) {
      all.push_back({"NORMAL", "VEC3", n, 12});
      for (std::size_t v = 0; v < n; ++v) {
        const vec3& x = normals_[triangles_.origin(v)];
        const double length = norm(x);
        put(bytes, std::array{stored(x.x / length), stored(x.y / length), stored(x.z / length)});
      }
    }
    if (textures_) {
      all.push_back({"TEXCOORD_0", "VEC2", n, 8});
      for (std::size_t v = 0; v < n; ++v) {  // images begin at the top in glTF, and at the bottom in other formats
        const std::array<double, 2>& x = textures_[triangles_.origin(v)];
        put(bytes, std::array{stored(c_.finite(x[0])), stored(1 - c_.finite(x[1]))});
      }
    }
    if (vert_colors_ || poly_colors_) {
      all.push_back({"COLOR_0", "VEC4", n, 16});
      for (std::size_t v = 0; v < n; ++v) put(bytes, stored(vert_colors_ ? vert_colors_[v] : triangles_.colors[v]));
    }
  }

  void chunks(const std::string& text, const std::string& bytes) {
    const std::uint64_t size = 12 + 8 + text.size() + (bytes.empty() ? 0 : 8 + bytes.size());
    if (size > 0xFFFFFFFFu) c_.throw_cannot_hold(".glb", {size, " bytes, more than 32 bits count"}, ".ply or .obj");
    std::string head = "glTF";
    for (const std::uint64_t x : {std::uint64_t{2}, size, std::uint64_t{text.size()}})
      put(head, static_cast<std::uint32_t>(x));
    c_.out << head << "JSON" << text;
    if (bytes.empty()) return;
    head.clear();
    put(head, static_cast<std::uint32_t>(bytes.size()));
    c_.out << head << std::string_view("BIN\0", 4) << bytes;
  }

  void report() {
    if (rounded_) c_.report.lost.push_back(".glb holds floats: coordinates and other numbers were rounded to 32 bits");
    if (num_limited_)
      c_.report.lost.push_back(core::joined({num_limited_, " colours with parts beyond 0 to 1 were limited to that"}));
  }
};

}  // namespace concino::detail

namespace concino {

/// Needs:  the points are finite.
/// Result: one mesh of triangles, with the axes of the mesh; glTF takes y for up and the metre for the unit. "normal"
///         of verts is written if all are unit vectors, "texture" of verts with the image's origin at its top, "color"
///         as linear parts, and the mesh property "name" (std::string). Without colours of verts, those of polys are
///         written: verts where polys of different colours meet are split.
/// Cost:   O(corners), O(corners log corners) with colours of polys; the whole file is in memory.
/// Errors: unsupported if a poly is no triangle, unless options.as_triangles is set, if a coordinate is too large for
///         floats, or if the file would have more than 4 GiB.
inline void gltf_format::write(write_context& c, flat_mesh& m) { detail::gltf_writer(c, m).write(); }

}  // namespace concino
