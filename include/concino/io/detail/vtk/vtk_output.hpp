// The cells and arrays that the writers of VTK's formats write.
#pragma once

#include <concino/io/detail/cells/canonical_cells.hpp>
#include <concino/io/detail/cells/corners.hpp>
#include <concino/io/detail/cells/face_key.hpp>
#include <concino/io/detail/text/write_common.hpp>
#include <concino/io/detail/vtk/vtk_grid.hpp>
#include <concino/io/detail/vtk/vtk_numbers.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace concino::detail {

/// The cells of a mesh: its polys, and after those of a volume the faces that have a value other than the default one
/// in a property. The order of faces, and the order of verts in cells that are recognised by their faces, do not depend
/// on how the mesh stores them.
template<class Context>  // write_context; a template only so that programs that write no such files need not compile it
class vtk_cell_list {
  flat_mesh& m_;
  std::vector<vert_id> verts_;  // of the cells that are no lists of verts in the mesh, as in vtk_grid
  std::vector<std::uint32_t> ends_;
  std::vector<std::uint8_t> types_;
  std::vector<std::uint64_t> face_keys_;
  std::size_t num_direct_ = 0;  // cells that are lists of verts in the mesh

  void end_cell(const Context& c, unsigned type) {
    if (verts_.size() > max_ids)
      core::throw_joined<unsupported>({c.name, ": more than ", max_ids, " corners of faces"});
    ends_.push_back(static_cast<std::uint32_t>(verts_.size()));
    types_.push_back(static_cast<std::uint8_t>(type));
  }

  /// Errors: unsupported if two faces of poly p have the same verts: faces have no numbers in the file, so readers
  ///         could not tell them apart.
  void check_faces(const Context& c, const flat_polyhedra& all, std::size_t p) {
    face_keys_.clear();
    for (const face_id f : all.poly_faces[p])
      face_keys_.push_back(face_key(all.face_verts[f.raw()].data(), all.face_verts[f.raw()].size()));
    std::sort(face_keys_.begin(), face_keys_.end());
    if (std::adjacent_find(face_keys_.begin(), face_keys_.end()) != face_keys_.end())
      c.throw_cannot_hold("VTK", {"poly ", m_.poly_index(p), ", which has two faces with the same verts"}, ".hedra");
  }

  void add_polyhedron(const Context& c, const flat_polyhedra& all, std::size_t p, const std::uint8_t*& outward,
                      cell_recogniser& known) {
    known.clear();
    const std::size_t first = verts_.size();
    verts_.push_back(vert_id{all.poly_faces[p].size()});
    for (const face_id f : all.poly_faces[p]) {
      const std::span<const vert_id> v = all.face_verts[f.raw()];
      const bool forward = *outward++ != 0;
      known.begin_face();
      for (const vert_id x : v) known.push(x);
      if (!forward) known.reverse_face();
      verts_.push_back(vert_id{v.size()});
      verts_.insert(verts_.end(), v.begin(), v.end());
      vert_id* const mine = verts_.data() + (verts_.size() - v.size());
      if (!forward) std::reverse(mine, mine + v.size());
      rotate_to_smallest(mine, v.size());
    }
    const cell_shape shape = known.recognise();
    if (shape == cell_shape::general) {
      check_faces(c, all, p);
      return end_cell(c, vtk_polyhedron);
    }
    verts_.resize(first);
    make_canonical(shape, known.cell);
    constexpr std::uint8_t types[] = {10, 12, 13, 14};
    const unsigned type = types[static_cast<unsigned>(shape)];
    swap_vtk_order(type, known.cell);
    verts_.insert(verts_.end(), known.cell, known.cell + standard_cell_of(shape).num_verts);
    end_cell(c, type);
  }

 public:
  std::vector<std::uint32_t> faces;  // the number of each face that is a cell

  vtk_cell_list(const Context& c, flat_mesh& m) : m_(m) {
    if (m.dimension == 2 || m.arity == 4 || m.arity == 8) {
      num_direct_ = m.num_polys;
      return;
    }
    const flat_polyhedra& all = m.polyhedra();
    const std::uint8_t* outward = all.outward.data();
    cell_recogniser known;
    for (std::size_t p = 0; p < m.num_polys; ++p) add_polyhedron(c, all, p, outward, known);
  }

  /// Adds the faces with has_value(face number) as cells.
  template<class HasValue>
  void add_faces(const Context& c, const HasValue& has_value) {
    const flat_lists<vert_id>& lists = m_.polyhedra().face_verts;
    std::vector<std::vector<vert_id>> cycles;
    std::vector<std::uint32_t> order, numbers;
    for (std::size_t f = 0; f < lists.size(); ++f) {
      if (!has_value(f)) continue;
      std::vector<vert_id> cycle(lists[f].begin(), lists[f].end());
      rotate_to_smallest(cycle.data(), cycle.size());
      if (cycle.back() < cycle[1]) std::reverse(cycle.begin() + 1, cycle.end());
      order.push_back(static_cast<std::uint32_t>(cycles.size()));
      cycles.push_back(std::move(cycle));
      numbers.push_back(static_cast<std::uint32_t>(f));
    }
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::lexicographical_compare(cycles[a].begin(), cycles[a].end(), cycles[b].begin(), cycles[b].end());
    });
    for (const std::uint32_t i : order) {
      faces.push_back(numbers[i]);
      verts_.insert(verts_.end(), cycles[i].begin(), cycles[i].end());
      end_cell(c, type_of_polygon(cycles[i].size()));
    }
  }

  std::size_t size() const { return num_direct_ + types_.size(); }
  std::span<const vert_id> verts(std::size_t i) const {
    if (i < num_direct_) return m_.poly_verts[i];
    i -= num_direct_;
    const std::size_t first = i ? ends_[i - 1] : 0;
    return {verts_.data() + first, ends_[i] - first};
  }
  unsigned type(std::size_t i) const {
    if (i >= num_direct_) return types_[i - num_direct_];
    return m_.dimension == 3 ? (m_.arity == 4 ? 10 : 12) : type_of_polygon(m_.poly_verts[i].size());
  }
  static unsigned type_of_polygon(std::size_t n) { return n == 3 ? 5 : n == 4 ? 9 : 7; }
};

/// A property that a VTK file holds as an array: of verts, of the mesh, or of polys and faces together.
struct vtk_output_array {
  std::string name;
  vtk_property_type type;
  flat_values<unsigned char> values, face_values;  // bytes; converts to false if there are none
  std::size_t bytes = 0;                           // of one value
  unsigned char default_value[72] = {};            // of elements that have none: those of the other kind

  const unsigned char* value(std::size_t i) const { return at(values, i); }
  const unsigned char* face_value(std::size_t f) const { return at(face_values, f); }
  bool has_value(const unsigned char* value) const { return !std::equal(value, value + bytes, default_value); }

 private:
  const unsigned char* at(const flat_values<unsigned char>& v, std::size_t i) const {
    return v ? v.values + (v.indices ? v.indices[i] : i) * bytes : default_value;
  }
};

/// All arrays of a mesh that a VTK file can hold. Declares them as stored.
template<class Context>  // as above
struct vtk_output_arrays {
  std::vector<vtk_output_array> of_verts, of_cells, of_mesh;

  /// keeps_defaults: also arrays of faces that have default values only, as in a piece of a mesh.
  vtk_output_arrays(Context& c, flat_mesh& m, bool has_bits, bool keeps_defaults = false) {
    const std::vector<flat_property> all = m.property_list();
    for (const element_kind kind : {element_kind::vert, element_kind::poly, element_kind::face, element_kind::mesh})
      for (const flat_property& p : all) {
        const vtk_property_type type = vtk_type_of(*p.type);
        if (p.kind != kind || p.name.empty() || type.number == vtk_number::none ||
            (type.number == vtk_number::bit && !has_bits))
          continue;
        std::vector<vtk_output_array>& list = kind == element_kind::vert   ? of_verts
                                              : kind == element_kind::mesh ? of_mesh
                                                                           : of_cells;
        const flat_values<unsigned char> values{static_cast<const unsigned char*>(p.values), p.indices};
        const std::size_t bytes = type.components * vtk_names_of(type.number).size;
        const auto same =
            std::find_if(list.begin(), list.end(), [&](const vtk_output_array& a) { return a.name == p.name; });
        const bool of_faces = kind == element_kind::face;
        if (same == list.end()) {
          list.push_back({p.name,
                          type,
                          of_faces ? flat_values<unsigned char>{} : values,
                          of_faces ? values : flat_values<unsigned char>{},
                          bytes,
                          {}});
          if (*p.type == typeid(rgba)) values_of<rgba>.make(list.back().default_value);  // of all other types it is 0
        } else if (same->type.number == type.number && same->type.components == type.components) {
          same->face_values = values;
        } else {
          continue;
        }
        c.declare_stored(kind, p.name, *p.type);
      }
    if (!keeps_defaults) drop_defaults(c, m);
  }

  /// Whether a face has a value other than the default one.
  bool face_has_value(std::size_t f) const {
    return std::any_of(of_cells.begin(), of_cells.end(),
                       [&](const vtk_output_array& a) { return a.face_values && a.has_value(a.face_value(f)); });
  }
  bool any_of_faces() const {
    return std::any_of(of_cells.begin(), of_cells.end(),
                       [](const vtk_output_array& a) { return static_cast<bool>(a.face_values); });
  }

 private:
  /// Drops values of faces that are all default ones, as no face is written for them. A reader takes an array for one
  /// of faces, and not of polys, if only faces have other values. Reports what a reader will not find.
  void drop_defaults(Context& c, flat_mesh& m) {
    const auto lost = [&](element_kind kind, const std::string& name, const char* why) {
      c.report.lost.push_back(
          core::joined({to_string(kind), " property \"", name, "\", which has default values only: ", why}));
    };
    for (vtk_output_array& a : of_cells) {
      if (!a.face_values) continue;
      bool faces_have = false, polys_have = false;
      for (std::size_t f = 0; f < m.polyhedra().face_verts.size() && !faces_have; ++f)
        faces_have = a.has_value(a.face_value(f));
      for (std::size_t p = 0; p < m.num_polys && !polys_have; ++p) polys_have = a.has_value(a.value(p));
      if (!faces_have) {
        lost(element_kind::face, a.name, "a file of VTK lists faces with other values only");
        a.face_values = {};
      } else if (a.values && !polys_have) {
        lost(element_kind::poly, a.name, "the property of faces of that name takes its place");
      }
    }
    std::erase_if(of_cells, [](const vtk_output_array& a) { return !a.values && !a.face_values; });
  }
};

/// Writes a number as text.
inline void write_vtk_number(text_sink& out, vtk_number type, const unsigned char* bytes) {
  with_number_type(type, [&]<class T>(std::type_identity<T>) {
    T x;
    std::memcpy(&x, bytes, sizeof x);
    if constexpr (std::is_same_v<T, float>) write_float(out, x, false);
    else if constexpr (std::is_same_v<T, double>) out << x;
    else if constexpr (std::is_same_v<T, bool>) out << int{x};
    else out << x;
  });
}

}  // namespace concino::detail
