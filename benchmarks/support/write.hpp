// Writes the data sets as files: numbers have six decimals, as in most programs, and nothing is written that the mesh does not need.
#pragma once

#include <concino/mesh/arrays.hpp>

#include <charconv>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace bench {

class text {
  std::string s_;

 public:
  text& operator<<(const char* t) { s_ += t; return *this; }
  template<class N>
  text& number(N x) {
    char b[64];
    if constexpr (std::is_floating_point_v<N>) s_.append(b, std::to_chars(b, b + sizeof b, x, std::chars_format::fixed, 6).ptr);
    else s_.append(b, std::to_chars(b, b + sizeof b, x).ptr);
    return *this;
  }
  text& point(const concino::vec3& p) {
    number(p.x) << " ";
    number(p.y) << " ";
    return number(p.z);
  }
  void save(const std::string& path) const {
    std::FILE* f = std::fopen(path.c_str(), "wb");
    const bool ok = f && std::fwrite(s_.data(), 1, s_.size(), f) == s_.size();
    if (!f || std::fclose(f) != 0 || !ok) throw std::runtime_error("cannot write " + path);
  }
};

inline void write_obj(const concino::surface_arrays& m, const std::string& path) {
  text t;
  for (const auto& p : m.points) (t << "v ").point(p) << "\n";
  for (std::size_t p = 0; p < m.num_polys(); ++p) {
    t << "f";
    const std::size_t begin = m.arity ? m.arity * p : m.offsets[p], end = m.arity ? begin + m.arity : m.offsets[p + 1];
    for (std::size_t k = begin; k < end; ++k) (t << " ").number(m.verts[k].raw() + 1);
    t << "\n";
  }
  t.save(path);
}

inline void write_mesh(const concino::cell_arrays& m, const std::string& path) {
  text t;
  (t << "MeshVersionFormatted 2\nDimension 3\nVertices\n").number(m.points.size()) << "\n";
  for (const auto& p : m.points) t.point(p) << " 0\n";
  (t << (m.arity == 4 ? "Tetrahedra\n" : "Hexahedra\n")).number(m.num_polys()) << "\n";
  for (std::size_t p = 0; p < m.num_polys(); ++p) {
    for (std::size_t i = 0; i < m.arity; ++i) t.number(m.verts[m.arity * p + i].raw() + 1) << " ";
    t << "0\n";
  }
  (t << "End\n").save(path);
}

inline void write_hedra(const concino::polyhedra_arrays& m, const std::string& path) {
  text t;
  t.number(m.points.size()) << " ";
  t.number(m.num_faces()) << " ";
  t.number(m.num_polys()) << "\n";
  for (const auto& p : m.points) t.point(p) << "\n";
  for (std::size_t f = 0; f < m.num_faces(); ++f) {
    t.number(m.face_offsets[f + 1] - m.face_offsets[f]);
    for (std::size_t k = m.face_offsets[f]; k < m.face_offsets[f + 1]; ++k) (t << " ").number(m.face_verts[k].raw() + 1);
    t << "\n";
  }
  for (std::size_t p = 0; p < m.num_polys(); ++p) {
    t.number(m.poly_offsets[p + 1] - m.poly_offsets[p]);
    for (std::size_t k = m.poly_offsets[p]; k < m.poly_offsets[p + 1]; ++k)
      (t << (m.outward[k] ? " " : " -")).number(m.poly_faces[k].raw() + 1);
    t << "\n";
  }
  t.save(path);
}

}  // namespace bench
