// Turns the contents of a Gmsh file into those of a mesh.
#pragma once

#include <concino/io/cell_builder.hpp>
#include <concino/io/detail/gmsh/gmsh_values_reader.hpp>
#include <concino/io/detail/medit/medit_marks.hpp>
#include <concino/io/label_names.hpp>

#include <cstring>
#include <utility>

namespace concino::detail {

/// The contents are those of a volume if the file has cells, else those of a surface. Elements of lower dimension are
/// listed, with their labels and values.
template<bool Volumes>
class gmsh_mesh : protected gmsh_values_reader {
  const read_context& in_;
  contents_of<Volumes>& out_;
  medit_marks marks_;
  std::vector<std::uint64_t> scratch_;

 protected:
  gmsh_mesh(const read_context& c, contents_of<Volumes>& out) : gmsh_values_reader(c), in_(c), out_(out) {}

  void make() {
    const std::size_t num_cells = grid_.num_of(3), num_polygons = grid_.num_of(2);
    if (num_cells ? !Volumes : !in_.wanted.surface && num_polygons > 0)
      throw_wrong_dimension(name(), num_cells != 0, num_cells ? num_cells : num_polygons);
    if (num_cells && !in_.wanted.cells && !in_.wanted.polyhedra) throw_wrong_dimension(name(), true, num_cells);
    const bool is_volume = num_cells || !in_.wanted.surface;
    list_elements(is_volume ? 3 : 2);
    add_names(is_volume ? 3 : 2);
    add_values(is_volume ? 3 : 2);
    if (!is_volume) make_surface();
    if constexpr (Volumes) {
      if (is_volume) make_volume();
    }
    nodes_.remove(out_, report_);
  }

 private:
  static element_kind kind_of(int dimension, int of_polys) {
    if (dimension == of_polys) return element_kind::poly;
    return dimension == 0 ? element_kind::vert : dimension == 1 ? element_kind::edge : element_kind::face;
  }

  void make_surface() {
    medit_polygons surface;
    grid_.for_each(2, [&](std::size_t e, const gmsh_run& r, const vert_id* v) {
      std::size_t poly = 0;
      const auto number = [&] {
        for (std::size_t i = 0; grid_.runs[i].first != r.first; ++i)
          poly += grid_.runs[i].type.dimension() == 2 ? grid_.size_of(i) : 0;
        return poly + (e - r.first);
      };
      check_read_polygon(
          out_, in_.wanted, v, r.type.corners(), words_, scratch_,
          [&](core::message expected, core::message found) { reject(place_of(e), expected, found); }, number,
          [&] { return describe_place(place_of(e)); });
      surface.add(v, r.type.corners());
      if (surface.size_of_lists() > max_ids) fail_to_count("corners");
    });
    out_.surface = std::move(surface).finish(std::move(grid_.points), in_.wanted.arity);
  }

  void make_volume() {
    basic_cell_builder<contents_of<Volumes>> cells(in_, grid_.points, 1);
    for (std::size_t i = 0; i < grid_.runs.size(); ++i)
      if (grid_.runs[i].type.dimension() == 3) cells.reserve(grid_.runs[i].type.cell(), grid_.size_of(i));
    grid_.for_each(3, [&](std::size_t e, const gmsh_run& r, const vert_id* v) {
      if (!cells.add_cell(r.type.cell(), v)) reject(place_of(e), {cells.expected}, {cells.found});
    });
    cells.finish(out_);
  }

  static constexpr polygon_words words_{.different = "different verts in an element", .first = 1};

  /// Whether the entities of a dimension are more than the labels say.
  bool has_entities(int dimension) const {
    std::vector<gmsh_entity_key> keys;
    for (const gmsh_run& r : grid_.runs)
      if (r.type.dimension() == dimension) keys.push_back({0, r.label});
    const gmsh_entity_tags tags(std::move(keys));
    for (const gmsh_run& r : grid_.runs)
      if (r.type.dimension() == dimension && r.entity != 0 && r.entity != tags({0, r.label})) return true;
    return false;
  }

  /// Lists edges, faces of a volume, and labels of all elements.
  void list_elements(int of_polys) {
    for (int d = 0; d <= of_polys; ++d) {
      const element_kind kind = kind_of(d, of_polys);
      listed_elements* const listed = kind == element_kind::edge   ? &out_.edges
                                      : kind == element_kind::face ? &out_.faces
                                                                   : nullptr;
      const bool entities = has_entities(d);
      std::size_t i = 0;
      bool needs_mark = false;  // to be written again
      grid_.for_each(d, [&](std::size_t e, const gmsh_run& r, const vert_id* v) {
        if (listed) list(*listed, e, v, r.type.corners());
        const std::size_t number = kind == element_kind::vert ? v->raw() : i;
        marks_.set(kind, "label", number, r.label);
        if (entities) marks_.set(kind, "entity_tag", number, r.entity);
        needs_mark = needs_mark || (kind == element_kind::vert && r.label == 0 && (!entities || r.entity == 0));
        ++i;
      });
      if (needs_mark)
        grid_.for_each(
            d, [&](std::size_t, const gmsh_run&, const vert_id* v) { marks_.set(kind, "entity", v->raw(), 1); });
      marks_.store(kind, kind == element_kind::vert ? grid_.points.size() : i, listed != nullptr, out_);
    }
  }

  /// Lists an edge or a face. Without options.repeated_verts its verts have to be different; with it, equal neighbours
  /// become one.
  void list(listed_elements& to, std::size_t e, const vert_id* v, std::uint32_t n) {
    vert_id corners[4];
    std::copy(v, v + n, corners);
    const std::size_t k = first_repeated(v, n, scratch_);
    if (k != n) {
      if (out_.repeated.policy == repeated_verts::refuse)
        reject(place_of(e), {words_.different, repeated_verts_hint},
               {words_.vert, v[k].raw() + words_.first, " twice"});
      n = collapse_verts(corners, n);
    }
    to.verts.insert(to.verts.end(), corners, corners + n);
    if (to.verts.size() > max_ids) fail_to_count("corners of edges or faces");
    to.end_element();
  }

  void add_names(int of_polys) {
    label_names all;
    for (gmsh_group& g : grid_.groups) {
      if (g.dimension <= of_polys)
        all.names.push_back({kind_of(g.dimension, of_polys), g.label, std::move(g.name), {}});
      else report_.skipped.push_back(core::joined({"the name \"", g.name, "\" of a group of volumes: there are none"}));
    }
    if (all.names.empty()) return;
    *static_cast<label_names*>(out_.add_property(element_kind::mesh, "label_names", values_of<label_names>, 1)) =
        std::move(all);
  }

  /// Adds a property of n elements, whose values lie at positions(i).
  template<class Positions>
  void add_property(element_kind kind, const gmsh_values& v, std::size_t n, const Positions& positions) {
    void* const to = out_.add_property(kind, v.name, *property_type_of(vtk_number::float64, v.components, ""), n);
    const std::size_t bytes = v.components * sizeof(double);
    for (std::size_t i = 0; i < n; ++i)
      std::memcpy(static_cast<unsigned char*>(to) + i * bytes, v.values.data() + positions(i) * v.components, bytes);
  }

  void add_values(int of_polys) {
    for (const gmsh_values& v : grid_.values) {
      if (v.of_nodes) {
        add_property(element_kind::vert, v, grid_.points.size(), [](std::size_t i) { return i; });
        continue;
      }
      for (int d = of_polys; d >= 0; --d) {
        if (!v.has_dimension[d]) continue;
        std::vector<std::size_t> positions(d == 0 ? grid_.points.size() : 0, grid_.num_elements);  // that of no value
        grid_.for_each(d, [&](std::size_t e, const gmsh_run&, const vert_id* verts) {
          if (d == 0) positions[verts->raw()] = e;
          else positions.push_back(e);
        });
        add_property(kind_of(d, of_polys), v, positions.size(), [&](std::size_t i) { return positions[i]; });
      }
    }
  }
};

}  // namespace concino::detail
