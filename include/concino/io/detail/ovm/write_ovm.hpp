// The writer of .ovm, the text format of OpenVolumeMesh: edges of verts, faces of half-edges, polyhedra of half-faces.
#pragma once

#include <concino/io/detail/ovm/ovm_format.hpp>
#include <concino/io/detail/ovm/ovm_types.hpp>
#include <concino/io/detail/text/write_common.hpp>
#include <concino/io/detail/vtk/vtk_output.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <string>
#include <utility>
#include <vector>

namespace concino::detail {

/// The edges of the faces of a volume, in the order in which the faces list them first, each as it runs there: these
/// numbers depend on the faces only.
class ovm_edges {
  std::vector<std::uint32_t> half_edges_;  // of the corners of all faces

  static std::uint64_t key(vert_id a, vert_id b) {
    return std::uint64_t{std::min(a.raw(), b.raw())} << 32 | std::max(a.raw(), b.raw());
  }

 public:
  std::vector<std::array<vert_id, 2>> verts;

  explicit ovm_edges(const flat_lists<vert_id>& faces) {
    std::vector<std::array<vert_id, 2>> listed;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const std::span<const vert_id> v = faces[f];
      for (std::size_t k = 0; k < v.size(); ++k) {
        listed.push_back({v[k], v[k + 1 == v.size() ? 0 : k + 1]});
        keys.emplace_back(key(listed.back()[0], listed.back()[1]), static_cast<std::uint32_t>(keys.size()));
      }
    }
    std::sort(keys.begin(), keys.end());
    std::vector<std::uint32_t> first(keys.size());  // the first corner with the same edge
    for (std::size_t i = 0; i < keys.size(); ++i)
      first[keys[i].second] =
          i > 0 && keys[i].first == keys[i - 1].first ? first[keys[i - 1].second] : keys[i].second;
    half_edges_.resize(keys.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (first[i] == i) {
        half_edges_[i] = static_cast<std::uint32_t>(2 * verts.size());
        verts.push_back(listed[i]);
      } else {
        half_edges_[i] = half_edges_[first[i]] ^ static_cast<std::uint32_t>(listed[i] != listed[first[i]]);
      }
    }
  }

  const std::vector<std::uint32_t>& half_edges() const { return half_edges_; }

  /// The number of each edge in another list of the edges.
  std::vector<std::uint32_t> numbers_in(std::span<const std::array<vert_id, 2>> others) const {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
    for (std::size_t e = 0; e < others.size(); ++e)
      keys.emplace_back(key(others[e][0], others[e][1]), static_cast<std::uint32_t>(e));
    std::sort(keys.begin(), keys.end());
    std::vector<std::uint32_t> numbers;
    for (const auto& v : verts) {
      const auto at = std::lower_bound(keys.begin(), keys.end(), std::pair{key(v[0], v[1]), 0u});
      assert(at != keys.end() && at->first == key(v[0], v[1]));
      numbers.push_back(at->second);
    }
    return numbers;
  }
};

class ovm_writer {
  write_context& c_;
  flat_mesh& m_;

  /// Whether readers find this name between the quotation marks.
  static bool can_be_read(const std::string& name) {
    return !name.empty() && name.back() != '"' && name.find_first_of(std::string_view("\0\r\n", 3)) == name.npos;
  }
  /// Blanks between characters are skipped by readers.
  static bool is_written_as_blank(const unsigned char* value) { return is_space(static_cast<char>(*value)); }

  void value(const ovm_type& t, const void* at) {
    const auto* const bytes = static_cast<const unsigned char*>(at);
    if (t.form == ovm_form::characters) {
      c_.out << static_cast<char>(*bytes);
    } else if (t.form == ovm_form::string) {
      const std::string& s = *static_cast<const std::string*>(at);
      c_.out << s.size() << ':' << s;
    } else if (t.form == ovm_form::list) {
      const auto& list = *static_cast<const std::vector<double>*>(at);
      c_.out << list.size();
      for (const double x : list) c_.out << '\n' << c_.finite(x);
    } else {
      const std::size_t size = t.number == vtk_number::bit ? 1 : vtk_names_of(t.number).size;
      for (std::size_t k = 0; k < t.components; ++k) {
        if (k > 0) c_.out << ' ';
        number(t.number, bytes + k * size);
      }
    }
    c_.out << '\n';
  }
  void number(vtk_number type, const unsigned char* bytes) {
    const auto finite = [&]<class T>(T x) {
      std::memcpy(&x, bytes, sizeof x);
      x = c_.finite(x);
      write_vtk_number(c_.out, type, reinterpret_cast<const unsigned char*>(&x));
    };
    if (type == vtk_number::float64) finite(double{});
    else if (type == vtk_number::float32) finite(float{});
    else write_vtk_number(c_.out, type, bytes);
  }

  /// Writes a property of n elements; `number_of`, unless empty, has the number of each in the mesh.
  void property(const ovm_kind& kind, const flat_property& p, std::size_t n,
                const std::vector<std::uint32_t>& number_of = {}) {
    const ovm_type* const t = ovm_type_of(*p.type);
    if (!t || !can_be_read(p.name)) return;
    const std::size_t size = ovm_value_type(*t, p.name).size;
    const auto at = [&](std::size_t i) {
      const std::size_t k = number_of.empty() ? i : number_of[i];
      return static_cast<const unsigned char*>(p.values) + size * (p.indices ? p.indices[k] : k);
    };
    if (t->form == ovm_form::characters)
      for (std::size_t i = 0; i < n; ++i)
        if (is_written_as_blank(at(i))) return;
    c_.declare_stored(kind.kind, p.name, *p.type);
    c_.out << kind.word << ' ' << t->name << " \"" << p.name << "\"\n";
    for (std::size_t i = 0; i < n; ++i) value(*t, at(i));
  }

 public:
  ovm_writer(write_context& c, flat_mesh& m) : c_(c), m_(m) {}

  void write() {
    const flat_polyhedra& all = m_.polyhedra();
    const ovm_edges edges(all.face_verts);
    if (edges.verts.size() > 0x7FFFFFFF) c_.throw_cannot_hold(".ovm", {"so many edges"}, ".hedra");
    c_.out << "OVM ASCII\nVertices\n" << m_.points.size() << '\n';
    for (const vec3& p : m_.points) {
      write_point(c_.out, p);
      c_.out << '\n';
      c_.report_progress();
    }
    c_.out << "Edges\n" << edges.verts.size() << '\n';
    for (const auto& v : edges.verts) c_.out << v[0].raw() << ' ' << v[1].raw() << '\n';
    c_.out << "Faces\n" << all.face_verts.size() << '\n';
    const std::uint32_t* half_edge = edges.half_edges().data();
    for (std::size_t f = 0; f < all.face_verts.size(); ++f) {
      c_.out << all.face_verts[f].size();
      for (std::size_t k = 0; k < all.face_verts[f].size(); ++k) c_.out << ' ' << *half_edge++;
      c_.out << '\n';
    }
    c_.out << "Polyhedra\n" << m_.num_polys << '\n';
    const std::uint8_t* outward = all.outward.data();
    for (std::size_t p = 0; p < m_.num_polys; ++p) {
      const std::span<const face_id> faces_of_poly = all.poly_faces[p];
      c_.out << faces_of_poly.size();
      for (const face_id f : faces_of_poly) c_.out << ' ' << 2 * std::uint64_t{f.raw()} + (*outward++ != 0 ? 0 : 1);
      c_.out << '\n';
      c_.report_progress();
    }
    properties(edges);
  }

 private:
  void properties(const ovm_edges& edges) {
    const std::vector<flat_property> list = m_.property_list(), of_edges = m_.edge_property_list();
    for (const ovm_kind& kind : ovm_kinds) {
      if (kind.is_half) continue;
      if (kind.kind == element_kind::edge && !of_edges.empty()) {
        const std::vector<std::uint32_t> numbers = edges.numbers_in(m_.edge_verts());
        for (const flat_property& p : of_edges) property(kind, p, edges.verts.size(), numbers);
      }
      const std::size_t n = kind.kind == element_kind::vert   ? m_.points.size()
                            : kind.kind == element_kind::face ? m_.polyhedra().face_verts.size()
                            : kind.kind == element_kind::poly ? m_.num_polys
                                                              : 1;
      for (const flat_property& p : list)
        if (p.kind == kind.kind) property(kind, p, n);
    }
  }
};

}  // namespace concino::detail

namespace concino {

inline void ovm_format::write(write_context& c, flat_mesh& m) { detail::ovm_writer(c, m).write(); }

}  // namespace concino
