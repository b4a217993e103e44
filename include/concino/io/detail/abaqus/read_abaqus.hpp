// The reader of Abaqus files: nodes, elements and sets of parts, or of no part.
#pragma once

#include <concino/io/cell_builder.hpp>
#include <concino/io/detail/abaqus/abaqus_format.hpp>
#include <concino/io/detail/abaqus/abaqus_model.hpp>
#include <concino/io/detail/cells/element_nodes.hpp>
#include <concino/io/detail/formats/contents.hpp>

#include <string>
#include <type_traits>
#include <vector>

namespace concino::detail {

/// Reads the elements and sets of a file whose model is known. Programs that read only surfaces need not compile the
/// code for volumes.
template<bool Volumes>
class abaqus_reader {
  const read_context& c_;
  contents_of<Volumes>& out_;
  abaqus_cursor in_;
  abaqus_model model_;
  std::vector<vert_id> corners_;
  std::vector<std::uint64_t> scratch_;
  std::uint32_t polys_ = 0, arity_ = 0;
  bool has_volume_ = false;
  element_nodes nodes_;

  struct no_cells {
    no_cells(const read_context&, std::vector<vec3>&, std::size_t) {}
  };
  std::conditional_t<Volumes, cell_builder, no_cells> cells_;

 public:
  abaqus_reader(const read_context& c, contents_of<Volumes>& out)
      : c_(c), out_(out), in_(c.text, c.name, c.progress), model_(in_, *c.report), cells_(c, model_.points, 0) {}

  void read() {
    model_.read();
    check_kind();
    const std::size_t num_points = model_.points.size();
    if (!has_volume_) out_.surface.points = std::move(model_.points);
    for (abaqus_model::element_block& b : model_.elements) read_elements(b, num_points);
    model_.check_numbers(&abaqus_part::elements, "an element number that is not used yet");
    if (has_volume_) {
      if constexpr (Volumes) cells_.finish(out_);
    } else {
      if (out_.surface.offsets.empty()) out_.surface.arity = arity_;
      if (out_.surface.arity == 0 && out_.surface.offsets.empty()) out_.surface.offsets.push_back(0);
    }
    model_.read_sets(num_points, polys_, out_);
    nodes_.remove(out_, *c_.report);
  }

 private:
  /// Finds out whether the file holds a volume.
  void check_kind() {
    bool has_surface = false;
    for (const abaqus_model::element_block& b : model_.elements) {
      if (b.num_lines == 0) continue;
      using family = abaqus_element::family;
      if (b.element.kind == family::unknown)
        core::throw_joined<unsupported>({in_.name(), ":", in_.line_of(b.at), ": elements of the type ", b.type,
                                         " are not read, as their number of nodes is not known"});
      if (b.element.is_poly() && b.element.is_second_order() && !c_.corners_only)
        core::throw_joined<unsupported>({in_.name(), ":", in_.line_of(b.at), ": elements of the type ", b.type,
                                         " have nodes on edges; ", read_corners_instead});
      has_volume_ = has_volume_ || b.element.kind == family::volume;
      has_surface = has_surface || b.element.kind == family::surface;
    }
    if (has_volume_ && !Volumes) throw_wrong_dimension(in_.name(), true);
    if (!has_volume_ && has_surface && !c_.wanted.surface) throw_wrong_dimension(in_.name(), false);
    if (!has_surface && !c_.wanted.surface) has_volume_ = true;  // without elements: what is wanted
  }

  void read_elements(abaqus_model::element_block& b, std::size_t num_points) {
    using family = abaqus_element::family;
    b.first = b.last = polys_;
    if (b.num_lines == 0) return;
    if (b.element.kind == family::other || (has_volume_ && b.element.kind == family::surface)) {
      c_.report->skipped.push_back(core::joined(
          {b.num_lines, " lines of elements of the type ", b.type,
           b.element.kind == family::other ? "" : ", which are surfaces, while others of the file are volumes"}));
      return;
    }
    abaqus_part& part = model_.parts[b.part];
    in_.at = b.data;
    while (in_.next_data_line()) {
      const char* const from = in_.at;
      const std::int64_t number = in_.integer_field("the number of an element");
      if (number <= 0) in_.fail(from, "the number of an element, from 1");
      read_nodes(b, part, num_points);
      if (b.element.kind == family::surface) add_polygon(from);
      else add_cell(from, b.element.shape);
      part.elements.add(number, from, polys_++);
      if (polys_ == max_ids) in_.fail_to_count("elements");
    }
    b.last = polys_;
  }

  /// Reads the nodes of an element, which may be on several lines.
  void read_nodes(const abaqus_model::element_block& b, const abaqus_part& part, std::size_t num_points) {
    corners_.clear();
    while (corners_.size() < b.element.nodes) {
      if (!in_.has_field() && !in_.next_data_line())
        in_.fail(in_.at, {"node ", corners_.size() + 1, " of an element of the type ", b.type});
      const char* const from = in_.at;
      const std::uint32_t v = part.nodes.find(in_.integer_field("the number of a node"));
      if (v >= num_points) in_.fail(from, "the number of a node of this part");
      corners_.push_back(vert_id{v});
    }
    if (in_.has_field()) in_.fail(in_.at, {"the end of the line after ", b.element.nodes, " nodes"});
    if (b.element.is_second_order())
      nodes_.add(corners_.data() + b.element.corners, b.element.nodes - b.element.corners);
    corners_.resize(b.element.corners);
  }

  void add_cell(const char* from, cell_shape shape) {
    if constexpr (Volumes)
      if (!cells_.add_cell(shape, corners_.data())) in_.fail(from, {cells_.expected}, {cells_.found});
  }
  void add_polygon(const char* from) {
    surface_arrays& s = out_.surface;
    const std::size_t first = s.verts.size();
    s.verts.insert(s.verts.end(), corners_.begin(), corners_.end());
    end_checked_poly(in_, from, first, scratch_, c_.wanted, out_, arity_,
                     {.different = "different nodes at the corners of an element"});
  }
};

}  // namespace concino::detail

namespace concino {

/// Needs:  the text of an Abaqus or CalculiX input file: keyword lines in any case, with or without blanks, and their
///         data lines; ** begins a comment.
/// Result: a volume if there is an element of one, else a surface. *NODE gives the points; *ELEMENT the polys in order:
///         solids (C3D4, C3D5, C3D6, C3D8 and those of heat, acoustics, continuum shells and the like, with any letters
///         behind the number) or shells, membranes, rigid and plane elements (S3, S4R, M3D4, R3D3, CPS4, CPE3, CAX4).
///         Elements of second order are read by their corners, if load_options::corners_only is set. The verts of cells
///         of negative volume are put into the standard order, and these cells are counted. Each *NSET and *ELSET, also
///         as a parameter of *NODE and *ELEMENT, becomes a property (int, 0 or 1) of verts or polys, by its name;
///         in a second part, with the name of the part before it. All parts become one mesh; a part without an
///         instance, while others have one, has a note. Reported as skipped: other keywords, elements of other types
///         (beams, springs), surface elements beside a volume, normals of nodes, members of sets that the mesh does not
///         have, and sets whose values would take more than 64 bytes for each byte of the file.
/// Cost:   O(size of the text, and of the sets), with sorting if numbers are not in order
/// Errors: parse_error naming the line of a wrong number, a node that its part does not have, a number that is there
///         twice, an element with a node twice, one that the wanted mesh cannot hold, or a line that ends too early;
///         unsupported for elements of second order, for those of an unknown number of nodes (C3D15V, C3D27), for
///         *INCLUDE and keywords that generate or move nodes and elements (*NGEN, *ELGEN, *NFILL, *NCOPY, *ELCOPY,
///         *NMAP, *SYSTEM), cylindrical coordinates, other input files, instances that move their part, several
///         instances of one part, and if the file holds a volume and a surface was wanted, or the reverse.
template<std::derived_from<file_contents> Contents>
void abaqus_format::read(const read_context& in, Contents& out) {
  detail::abaqus_reader<std::is_same_v<Contents, volume_contents>>(in, out).read();
}

}  // namespace concino
