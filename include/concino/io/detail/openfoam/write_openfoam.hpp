// The writer of the polyMesh folders of OpenFOAM: text and binary, volumes of any polyhedra.
#pragma once

#include <concino/io/detail/openfoam/foam_groups.hpp>
#include <concino/io/detail/openfoam/foam_output.hpp>
#include <concino/io/detail/openfoam/openfoam_format.hpp>
#include <concino/io/detail/openfoam/openfoam_order.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

class openfoam_writer {
  write_context& c_;
  flat_mesh& m_;
  const flat_polyhedra& all_;
  openfoam_order order_;
  foam_groups patches_, zones_;
  std::vector<std::uint32_t> faces_;  // all faces in the order of the file

  save_report& report() { return c_.report; }

  void make_patches(const label_names* names) {
    const flat_values<int> label = m_.face_values<int>("label");
    const auto label_of = [&](std::uint32_t f) { return label ? label[f] : 0; };
    std::vector<int> used;
    for (const std::uint32_t f : order_.boundary) used.push_back(label_of(f));
    patches_.make(names, element_kind::face, std::move(used), "defaultFaces", "patch");
    for (const std::uint32_t f : order_.boundary) patches_.all[patches_.find(label_of(f))].elements.push_back(f);
    if (const std::size_t g = patches_.find(0); g != foam_groups::no_group)
      if (const std::size_t n = patches_.all[g].elements.size())
        report().notes.push_back(
            core::joined({n, " boundary faces without a label are in the patch ", patches_.all[g].name}));
    faces_ = order_.inner;
    for (const foam_group& g : patches_.all) faces_.insert(faces_.end(), g.elements.begin(), g.elements.end());
    std::size_t num_inner_labels = 0;
    for (const std::uint32_t f : order_.inner) num_inner_labels += label_of(f) != 0;
    if (num_inner_labels)
      report().lost.push_back(
          core::joined({"labels of ", num_inner_labels, " faces between two polys, which belong to no patch"}));
  }

  void make_zones(const label_names* names) {
    const flat_values<int> label = m_.poly_values<int>("label");
    std::vector<int> used;
    for (std::size_t p = 0; label && p < m_.num_polys; ++p) used.push_back(label[p]);
    zones_.make(names, element_kind::poly, std::move(used), {}, "cellZone");
    for (std::uint32_t p = 0; p < m_.num_polys; ++p)
      if (const std::size_t g = zones_.find(label ? label[p] : 0); g != foam_groups::no_group)
        zones_.all[g].elements.push_back(p);
  }

  void report_changes(const label_names* names) {
    patches_.report_numbers("faces");
    zones_.report_numbers("polys");
    std::size_t num_other = 0;
    for (const concino::label_name& n : names ? names->names : std::vector<concino::label_name>())
      num_other += n.kind != element_kind::face && n.kind != element_kind::poly;
    if (num_other) report().lost.push_back(core::joined({num_other, " names of labels of neither faces nor polys"}));
    if (order_.num_unused) report().lost.push_back(core::joined({order_.num_unused, " faces of no poly"}));
    for (const foam_group& g : patches_.all)
      for (const std::string& line : g.lines)
        if (m_.arity != 0 && !g.elements.empty() && line.starts_with("neighbourPatch "))
          report().lost.push_back(
              core::joined({"the order of the faces of the patch ", g.name,
                            ", which is coupled: a polyhedralmesh that was loaded from its case keeps it"}));
    bool is_reordered = false;
    for (std::uint32_t f = 0; f < faces_.size(); ++f) is_reordered = is_reordered || faces_[f] != f;
    if (is_reordered && m_.arity == 0) report().notes.push_back("the order of the faces changed, to that of OpenFOAM");
  }

  void write_points() {
    foam_output out = begin("points", "vectorField");
    out.begin_list(m_.points.size());
    for (const vec3& p : m_.points) {
      out.point(p.x, p.y, p.z);
      c_.report_progress();
    }
    out.end_list(m_.points.size());
  }

  void write_faces() {
    const bool binary = c_.options.binary;
    foam_output out = begin("faces", binary ? "faceCompactList" : "faceList");
    text_sink& text = *last_;
    std::vector<vert_id> verts;
    if (binary) {
      std::size_t end = 0;
      out.begin_list(faces_.size() + 1);
      out.label(0);
      for (const std::uint32_t f : faces_) out.label(end += all_.face_verts[f].size());
      out.end_list(faces_.size() + 1);
      out.begin_list(end);
      for (const std::uint32_t f : faces_) {
        order_.verts_of(f, verts);
        for (const vert_id v : verts) out.label(v.raw());
      }
      return out.end_list(end);
    }
    out.begin_list(faces_.size());
    for (const std::uint32_t f : faces_) {
      order_.verts_of(f, verts);
      text << verts.size() << '(' << verts[0].raw();
      for (std::size_t k = 1; k < verts.size(); ++k) text << ' ' << verts[k].raw();
      text << ")\n";
    }
    out.end_list(faces_.size());
  }

  void write_cells(std::string_view file, const std::vector<std::uint32_t>& faces,
                   const std::vector<std::uint32_t>& cells) {
    foam_output out = begin(file, "labelList",
                            core::joined({"nPoints:", m_.points.size(), "  nCells:", m_.num_polys,
                                          "  nFaces:", faces_.size(), "  nInternalFaces:", order_.inner.size()}));
    out.begin_list(faces.size());
    for (const std::uint32_t f : faces) out.label(cells[f]);
    out.end_list(faces.size());
  }

  /// Dictionaries are text.
  void write_boundary() {
    text_sink& out = c_.folder->file("boundary");
    foam_output(out, false).header("polyBoundaryMesh", "boundary");
    out << patches_.all.size() << "\n(\n";
    std::size_t first = order_.inner.size();
    for (const foam_group& g : patches_.all) {
      out << "    " << g.name << "\n    {\n";
      foam_groups::write_lines(out, g);
      out << "        nFaces          " << g.elements.size() << ";\n        startFace       " << first << ";\n    }\n";
      first += g.elements.size();
    }
    out << ")\n";
  }

  void write_zones() {
    text_sink& out = c_.folder->file("cellZones");
    foam_output(out, false).header("regIOobject", "cellZones");
    out << zones_.all.size() << "\n(\n";
    for (const foam_group& g : zones_.all) {
      out << "    " << g.name << "\n    {\n";
      foam_groups::write_lines(out, g);
      out << "        cellLabels      List<label>\n" << g.elements.size() << "\n(\n";
      for (const std::uint32_t p : g.elements) out << p << '\n';
      out << ")\n;\n    }\n";
    }
    out << ")\n";
  }

  /// What describes the elements of the mesh that is replaced.
  void remove_old_files() {
    for (const std::string_view name : {"points", "faces", "owner", "neighbour", "boundary", "cellZones", "faceZones",
                                        "pointZones", "meshModifiers", "parallelData"})
      for (const std::string_view ending : {"", ".gz"}) {
        const bool is_new =
            ending.empty() && (name == "points" || name == "faces" || name == "owner" || name == "neighbour" ||
                               name == "boundary" || (name == "cellZones" && !zones_.all.empty()));
        if (!is_new && c_.folder->remove(core::joined({name, ending})))
          report().notes.push_back(core::joined({name, ending, ", which belongs to the former mesh, is removed"}));
      }
  }

  text_sink* last_ = nullptr;
  foam_output begin(std::string_view file, std::string_view class_name, std::string_view note = {}) {
    last_ = &c_.folder->file(file);
    foam_output out(*last_, c_.options.binary);
    out.header(class_name, file, note);
    return out;
  }

 public:
  openfoam_writer(write_context& c, flat_mesh& m)
      : c_(c), m_(m), all_(m.polyhedra()), order_(c, m), patches_(c.report, "patch"), zones_(c.report, "zone") {}

  void write() {
    if (all_.face_verts.values.size() > 0x7FFFFFFF || m_.points.size() > 0x7FFFFFFF)
      c_.throw_cannot_hold("polyMesh", {"more than 2147483647 points or corners of faces"}, ".vtu");
    c_.declare_stored<int>(element_kind::face, "label");
    c_.declare_stored<int>(element_kind::poly, "label");
    c_.declare_stored<label_names>(element_kind::mesh, "label_names");
    const label_names* const names = m_.mesh_value<label_names>("label_names");
    make_patches(names);
    make_zones(names);
    report_changes(names);
    write_points();
    write_faces();
    write_cells("owner", faces_, order_.owner);
    write_cells("neighbour", order_.inner, order_.neighbour);
    write_boundary();
    if (!zones_.all.empty()) write_zones();
    remove_old_files();
  }
};

}  // namespace concino::detail

namespace concino {

inline void openfoam_format::write(write_context& c, flat_mesh& m) { detail::openfoam_writer(c, m).write(); }

}  // namespace concino
