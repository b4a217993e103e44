// The readers of TetGen's surfaces, .smesh and .poly.
#pragma once

#include <concino/io/detail/files/system_files.hpp>
#include <concino/io/detail/formats/contents.hpp>
#include <concino/io/detail/tetgen/smesh_format.hpp>
#include <concino/io/detail/tetgen/tetgen_nodes.hpp>
#include <concino/io/detail/tetgen/tetgen_paths.hpp>
#include <concino/io/file_text.hpp>

#include <string>
#include <vector>

namespace concino::detail {

/// Reads points, facets, and the points in holes and regions.
class smesh_reader {
  const read_context& c_;
  file_contents& out_;
  const bool has_polygons_;  // facets list polygons, as in .poly files; else they are polygons
  tetgen_cursor in_;
  tetgen_nodes nodes_;
  bool has_markers_ = false;
  std::uint32_t arity_ = 0;
  std::uint64_t num_small_ = 0, num_several_ = 0;
  std::vector<int> labels_;
  std::vector<std::uint64_t> scratch_;

 public:
  smesh_reader(const read_context& c, file_contents& out, bool has_polygons)
      : c_(c), out_(out), has_polygons_(has_polygons), in_(c.text, c.name, c.progress) {}

  void read() {
    const std::uint64_t num_points = nodes_.read_header(in_);
    if (num_points > 0) nodes_.read_rows(in_, num_points);
    if (!in_.next_row()) in_.fail(in_.at, "the number of facets");
    const std::uint64_t n = in_.count_of_row("the number of facets", 4);
    has_markers_ = in_.flag_of_row("the number of markers, 0 or 1");
    in_.end_row();
    if (num_points == 0 && n > 0) read_node_file();
    out_.surface.points = std::move(nodes_.points);
    for (std::uint64_t i = 0; i < n; ++i) facet(i);
    finish();
    skip_list("points in holes");
    skip_list("points in regions");
    in_.end_file("the end of the file after the regions");
    in_.report_longer(*c_.report);
  }

 private:
  /// Reads the points from the .node file.
  void read_node_file() {
    const std::string beside = tetgen_path(c_.name, ".node");
    if (!c_.is_file)
      core::throw_joined<unsupported>(
          {c_.name, ": the points of its facets are in another file, .node, and a text has no file beside it"});
    if (status_of(beside).kind == file_kind::none)
      core::throw_joined<io_error>(
          {c_.name, ": lists no points; those of its facets are expected in ", beside, ", which does not exist"});
    file_text file(beside);
    tetgen_cursor in(file.text(), beside, nullptr);
    nodes_.read_rows(in, nodes_.read_header(in));
    in.end_file("the end of the file after the last point");
    in.report_longer(*c_.report);
    file.close(beside);
  }

  void facet(std::uint64_t number) {
    if (!in_.next_row()) in_.fail(in_.at, "a facet");
    const char* const from = in_.at;
    if (!has_polygons_) {
      const bool is_poly = polygon();
      const int marker = marker_if_any();
      if (is_poly) labels_.push_back(marker);
      in_.end_row();
      return;
    }
    const std::uint64_t polygons = in_.count_of_row("the number of polygons of a facet", 4);
    std::int64_t holes = 0;
    if (in_.row_goes_on()) holes = in_.integer_of_row("the number of holes of a facet");
    const int marker = marker_if_any();
    in_.end_row();
    if (polygons == 0) in_.fail(from, "at least one polygon of a facet");
    if (holes != 0)
      core::throw_joined<unsupported>({in_.name(), ":", in_.line_of(from), ": facet ", number,
                                       " has holes, which no polygon holds; cut it into polygons without holes"});
    const std::size_t before = labels_.size();
    for (std::uint64_t k = 0; k < polygons; ++k) {
      if (!in_.next_row()) in_.fail(in_.at, "a polygon of a facet");
      if (polygon()) labels_.push_back(marker);
      in_.end_row();
    }
    num_several_ += labels_.size() > before + 1;
  }

  int marker_if_any() { return has_markers_ && in_.row_goes_on() ? in_.marker_of_row("a marker, an integer") : 0; }

  /// Reads a polygon, whose corners may be on several lines. Returns false if it is a point or a segment.
  bool polygon() {
    const char* const from = in_.at;
    surface_arrays& s = out_.surface;
    const std::size_t first = s.verts.size();
    const std::uint64_t corners = in_.count_of_row("the number of corners of a polygon", 2);
    if (corners == 0) in_.fail(from, "at least one corner of a polygon");
    for (std::uint64_t k = 0; k < corners; ++k)
      s.verts.push_back(vert_id{in_.next_index(s.points.size(), "the number of a point", nodes_.first)});
    if (corners < 3) {
      ++num_small_;
      s.verts.resize(first);
      return false;
    }
    end_checked_poly(
        in_, from, first, scratch_, c_.wanted, out_, arity_,
        {.different = "different points at the corners of a polygon", .vert = "point ", .first = nodes_.first});
    return true;
  }

  /// Skips a list of points, of which the first row is the number.
  void skip_list(const char* what) {
    if (!in_.next_row()) return;
    const std::uint64_t n = in_.count_of_row("the number of points in holes or regions", 2);
    in_.end_row();
    for (std::uint64_t i = 0; i < n; ++i) {
      if (!in_.next_row()) in_.fail(in_.at, "a point in a hole or region");
      in_.skip_line();
    }
    if (n > 0) c_.report->skipped.push_back(core::joined({n, " ", what}));
  }

  void finish() {
    surface_arrays& s = out_.surface;
    if (s.offsets.empty()) s.arity = arity_;
    if (s.arity == 0 && s.offsets.empty()) s.offsets.push_back(0);
    if (has_markers_) out_.poly_labels = std::move(labels_);
    nodes_.store_values(out_);
    if (num_small_) c_.report->skipped.push_back(core::joined({num_small_, " points and segments in facets"}));
    if (num_several_)
      c_.report->notes.push_back(
          core::joined({num_several_, " facets have several polygons: each is a poly, even if one lies in another"}));
  }
};

}  // namespace concino::detail

namespace concino {

/// Needs:  the text of a .smesh file, as TetGen and others write it: points, facets of one polygon each, points in
///         holes, points in regions. If there are no points, but facets: its path, and the points in x.node beside it.
/// Result: the points and polygons in order. The markers of points and facets become "label" of verts and polys, the
///         attributes of points "attribute_1", ... (double). Facets of one or two corners, and points in holes and
///         regions, are reported as skipped.
/// Cost:   O(size of the files)
/// Errors: parse_error naming the line of a wrong number, an index out of range, a polygon with a vert twice, one that
///         the wanted mesh cannot hold, text after the regions, or the end of a file that is cut off; io_error and
///         unsupported if x.node is missing; unsupported for points of two coordinates.
inline void smesh_format::read(const read_context& in, file_contents& out) {
  detail::smesh_reader(in, out, false).read();
}

/// Needs:  the text of a .poly file: as .smesh, but each facet lists one or more polygons.
/// Result: as for .smesh. Each polygon of a facet is a poly, with the marker of the facet as "label".
/// Cost:   O(size of the files)
/// Errors: as for .smesh; unsupported for facets with holes, naming the facet, counted from 0, and its line.
inline void poly_format::read(const read_context& in, file_contents& out) {
  detail::smesh_reader(in, out, true).read();
}

}  // namespace concino
