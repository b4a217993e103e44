// The reader of TetGen's .node, .ele, .face and .edge files.
#pragma once

#include <concino/io/cell_builder.hpp>
#include <concino/io/detail/cells/element_nodes.hpp>
#include <concino/io/detail/files/system_files.hpp>
#include <concino/io/detail/tetgen/ele_format.hpp>
#include <concino/io/detail/tetgen/tetgen_nodes.hpp>
#include <concino/io/detail/tetgen/tetgen_paths.hpp>
#include <concino/io/file_text.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

/// Reads the files beside the one that is loaded, and it. Contents is volume_contents; a template only so that programs
/// that read no volumes need not compile it.
template<class Contents>
class ele_reader {
  const read_context& c_;
  Contents& out_;
  tetgen_nodes nodes_;
  tetgen_attributes attributes_;
  bool has_labels_ = true;  // the first attribute of all tets is written as an integer
  bool second_order_ = false;
  element_nodes element_nodes_;
  std::vector<std::uint64_t> scratch_;

 public:
  ele_reader(const read_context& c, Contents& out) : c_(c), out_(out) {
    if (!c.is_file)
      core::throw_joined<unsupported>(
          {c.name, ": .ele lists the tets of points that another file lists, .node, and a text has no file beside it; ",
           "load them by their path"});
  }

  void read() {
    const bool is_node = ends_in(c_.name, ".node");
    file_text other;
    const std::string beside = tetgen_path(c_.name, is_node ? ".ele" : ".node");
    if (status_of(beside).kind == file_kind::none)
      core::throw_joined<io_error>({c_.name,
                                    is_node ? ": lists points only; the tets of them are expected in "
                                            : ": lists tets only; their points are expected in ",
                                    beside, ", which does not exist"});
    other = file_text(beside);
    if (is_node) {
      read_nodes(c_.text, c_.name, c_.progress);
      read_tets(other.text(), beside, nullptr);
    } else {
      read_nodes(other.text(), beside, nullptr);
      read_tets(c_.text, c_.name, c_.progress);
    }
    other.close(beside);
    read_listed(".face", element_kind::face, 3, second_order_ ? 3 : 0, out_.faces);
    read_listed(".edge", element_kind::edge, 2, second_order_ ? 1 : 0, out_.edges);
    nodes_.store_values(out_);
    store_attributes();
    element_nodes_.remove(out_, *c_.report);
  }

 private:
  void read_nodes(std::string_view text, std::string_view name, const concino::progress* progress) {
    tetgen_cursor in(text, name, progress);
    nodes_.read_rows(in, nodes_.read_header(in));
    in.end_file("the end of the file after the last point");
    in.report_longer(*c_.report);
  }

  void read_tets(std::string_view text, std::string_view name, const concino::progress* progress) {
    tetgen_cursor in(text, name, progress);
    if (!in.next_row()) in.fail(in.at, "the number of tets");
    const std::uint64_t n = in.count_of_row("the number of tets", 10);
    if (in.row_goes_on()) {
      const char* const from = in.at;
      const std::int64_t corners = in.integer_of_row("the number of nodes of a tet, 4 or 10");
      if (corners == 3 || corners == 6)
        core::throw_joined<unsupported>(
            {name, ": lists triangles, as files of the program Triangle do; only tets are read"});
      if (corners != 4 && corners != 10) in.fail(from, "the number of nodes of a tet, 4 or 10");
      second_order_ = corners == 10;
    }
    if (second_order_ && n > 0 && !c_.corners_only)
      core::throw_joined<unsupported>(
          {name, ": has ", n, " second-order tets, with nodes on edges; ", read_corners_instead});
    attributes_.read_number(in, n);
    in.end_row();
    read_rows_of_tets(in, n);
    in.end_file("the end of the file after the last tet");
    in.report_longer(*c_.report);
  }

  void read_rows_of_tets(tetgen_cursor& in, std::uint64_t n) {
    basic_cell_builder<Contents> cells(c_, nodes_.points, nodes_.first);
    cells.reserve(cell_shape::tet, in.reservable(n, 10));
    for (std::uint64_t i = 0; i < n; ++i) {
      if (!in.next_row()) in.fail(in.at, "the number of a tet");
      const char* const from = in.at;
      in.integer_of_row("the number of a tet");
      vert_id corners[4], nodes[6];
      for (vert_id& v : corners) v = next_vert(in);
      if (second_order_) {
        for (vert_id& v : nodes) v = next_vert(in);
        element_nodes_.add(nodes, 6);
      }
      if (!cells.add_cell(cell_shape::tet, corners)) in.fail(from, {cells.expected}, {cells.found});
      bool ignored = false;
      for (std::size_t k = 0; k < attributes_.size(); ++k)
        attributes_.add(k, in.attribute_of_row("an attribute of the tet", k == 0 ? has_labels_ : ignored));
      in.end_row();
    }
    cells.finish(out_);
  }

  std::uint32_t num_points() const {
    return static_cast<std::uint32_t>(out_.filled == arrays_kind::cells ? out_.cells.points.size()
                                                                        : out_.polyhedra.points.size());
  }
  vert_id next_vert(tetgen_cursor& in) {
    return vert_id{in.index_of_row(nodes_.points.size(), "the number of a point", nodes_.first)};
  }

  /// Reads faces or edges of `size` verts, if there is a file of them and it has markers. Rows of elements of second
  /// order have more nodes.
  void read_listed(std::string_view extension, element_kind kind, std::uint32_t size, std::uint32_t num_nodes,
                   listed_elements& listed) {
    const std::string path = tetgen_path(c_.name, extension);
    if (status_of(path).kind != file_kind::regular) return;
    file_text file(path);
    tetgen_cursor in(file.text(), path, nullptr);
    if (!in.next_row()) in.fail(in.at, "the number of faces or edges");
    const std::uint64_t n = in.count_of_row("the number of faces or edges", 6);
    if (!in.flag_of_row("the number of markers, 0 or 1")) {
      if (n > 0)
        c_.report->skipped.push_back(core::joined(
            {path, ": ", n, kind == element_kind::face ? " faces" : " edges", ", as they have no markers"}));
      return;
    }
    in.end_row();
    std::vector<int> labels;
    labels.reserve(in.reservable(n, 6));
    for (std::uint64_t i = 0; i < n; ++i) {
      if (!in.next_row()) in.fail(in.at, "the number of a face or edge");
      in.integer_of_row("the number of a face or edge");
      add_listed(in, size, listed);
      for (std::uint32_t k = 0; k < num_nodes; ++k)
        in.index_of_row(num_points(), "the number of a point", nodes_.first);
      labels.push_back(in.marker_of_row("the marker, an integer"));
      in.end_row();
    }
    in.end_file("the end of the file after the last face or edge");
    in.report_longer(*c_.report);
    int* const to = out_.template add_property<int>(kind, "label", labels.size());
    for (std::size_t i = 0; i < labels.size(); ++i) to[i] = labels[i];
  }

  void add_listed(tetgen_cursor& in, std::uint32_t size, listed_elements& listed) {
    in.row_goes_on();
    const char* const from = in.at;
    vert_id v[3];
    for (std::uint32_t k = 0; k < size; ++k)
      v[k] = vert_id{in.index_of_row(num_points(), "the number of a point", nodes_.first)};
    const std::size_t repeated = first_repeated(v, size, scratch_);
    if (repeated != size && c_.repeated_verts == repeated_verts::refuse)
      in.fail(from, {"different verts", repeated_verts_hint}, {"point ", v[repeated].raw() + nodes_.first, " twice"});
    const std::uint32_t left = repeated == size ? size : collapse_verts(v, size);
    listed.verts.insert(listed.verts.end(), v, v + left);
    listed.end_element();
  }

  /// The first attribute of tets becomes "label" if it is an integer.
  void store_attributes() {
    if (attributes_.size() > 0 && has_labels_)
      for (const double x : attributes_.take_first()) out_.poly_labels.push_back(static_cast<int>(x));
    attributes_.store(element_kind::poly, out_);
  }
};

}  // namespace concino::detail

namespace concino {

/// Needs:  the text and the path of x.node or x.ele, with the other one beside it, as TetGen and others write them: a
///         row of counts, then a row of numbers for each point or tet. Points are numbered from 0 or 1, as the first
///         one is. `#` begins a comment.
/// Result: the points and tets in order. The verts of tets of negative volume are put into the standard order, and
///         these tets are counted. The markers of points become "label" of verts, their attributes "attribute_1", ...
///         (double). The first attribute of tets, the region, becomes "label" of polys if all its values are integers
///         without a point; the others become "attribute_1", ... of polys. If there are x.face and x.edge with markers,
///         these become "label" of faces and edges; those that the mesh does not have are reported as skipped, as are
///         faces and edges without markers, and columns that the first row does not name. Tets of ten nodes are read by
///         their corners, if load_options::corners_only is set.
/// Cost:   O(size of the files)
/// Errors: io_error if the other file is missing, which is named, or cannot be read; parse_error naming the file and
///         the line of a wrong number, an index out of range, an element with a vert twice, a tet that the wanted mesh
///         cannot hold, a row that ends too early, text after the last row, or the end of a file that is cut off;
///         unsupported for a text without a path, for points of two coordinates, and for tets of ten nodes.
template<std::same_as<volume_contents> Contents>
void ele_format::read(const read_context& in, Contents& out) {
  detail::ele_reader<Contents>(in, out).read();
}

}  // namespace concino
