// The reader of Open Inventor files: the polygons of all nodes IndexedFaceSet, with the points of Coordinate3 and
// VertexProperty.
#pragma once

#include <concino/io/detail/formats/contents.hpp>
#include <concino/io/detail/iv/iv_cursor.hpp>
#include <concino/io/detail/iv/iv_format.hpp>
#include <concino/io/detail/iv/iv_nodes.hpp>
#include <concino/io/detail/values/name_runs.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace concino::detail {

class iv_reader : iv_cursor {
  const wanted_mesh& wanted_;
  file_contents& extra_;
  surface_arrays& out_;
  load_report& report_;

  using node_kind = iv_node_kind;
  /// The part of `out_.points` that indices refer to.
  struct point_range {
    std::uint32_t begin = 0, size = 0;
  };
  /// A node that has not ended, and what is restored at its end.
  struct scope {
    node_kind kind;
    std::size_t name;  // a number of names_, or name_table::none
    std::size_t points;
  };
  static constexpr std::size_t max_depth = 10000;
  std::vector<scope> scopes_;
  std::vector<point_range> ranges_{{}};  // 0: none
  std::size_t points_ = 0;               // the current range
  name_table names_;                     // that DEF gives
  std::vector<std::size_t> range_of_;    // the range that the node of each name defines; 0: none
  std::size_t name_ = name_table::none;  // of the next node

  // the node IndexedFaceSet that is read
  std::size_t first_poly_ = 0, first_corner_ = 0;
  std::int64_t max_index_ = -1;
  const char* at_max_index_ = nullptr;
  std::vector<int> materials_;
  bool materials_fit_ = true;  // 32 bits each

  std::uint32_t arity_ = 0;
  std::vector<std::uint64_t> scratch_;
  node_counts skipped_nodes_;
  std::size_t num_copies_ = 0, num_unmatched_ = 0;

 public:
  iv_reader(const read_context& c, file_contents& out)
      : iv_cursor(text_without_padding(c.text), c.name, c.progress), wanted_(c.wanted), extra_(out), out_(out.surface),
        report_(*c.report) {}

  void read() {
    skip_header();
    std::string_view last;  // the last word, the type of a node if a brace follows
    for (skip(); at != end(); skip()) {
      const char c = *at;
      if (c == '{' || c == '[') begin_scope(c == '[' ? node_kind::list : kind_of(last));
      else if (c == '}' || c == ']') end_scope();
      else if (c == '"') skip_string();
      else last = next_word();
      report_progress();
    }
    if (!scopes_.empty()) fail(end(), scopes_.back().kind == node_kind::list ? "']'" : "'}'");
    if (out_.points.empty()) fail(end(), {"points (Coordinate3 or VertexProperty)"}, {"none"});
    if (out_.offsets.empty()) out_.arity = arity_;
    if (out_.arity == 0 && out_.offsets.empty()) out_.offsets.push_back(0);
    if (!extra_.poly_labels.empty()) extra_.poly_labels.resize(out_.num_polys());
    report_skipped();
  }

 private:
  node_kind kind_of(std::string_view type) {
    const node_kind kind = iv_node_kind_of(type);
    if (kind == node_kind::other) skipped_nodes_.add(type.empty() ? "without a type" : type.substr(0, 40));
    return kind;
  }

  void begin_scope(node_kind kind) {
    if (scopes_.size() == max_depth) fail(at, {"at most ", max_depth, " nodes inside each other"}, {"more"});
    ++at;
    scopes_.push_back({kind, std::exchange(name_, name_table::none), points_});
    if (kind != node_kind::face_set) return;
    first_poly_ = num_polys();
    first_corner_ = out_.verts.size();
    max_index_ = -1;
    materials_.clear();
    materials_fit_ = true;
  }

  void end_scope() {
    const bool is_list = *at == ']';
    if (scopes_.empty() || (scopes_.back().kind == node_kind::list) != is_list)
      fail(at, scopes_.empty() ? "a node" : is_list ? "'}'" : "']'");
    const scope s = scopes_.back();
    scopes_.pop_back();
    if (s.kind == node_kind::face_set) end_faces();
    if (s.kind == node_kind::face_set || s.kind == node_kind::separator) points_ = s.points;
    ++at;
  }

  /// Reads a word outside of lists of numbers, and the values after it if it is the name of a field with them.
  std::string_view next_word() {
    const std::string_view w = word();
    const node_kind inside = scopes_.empty() ? node_kind::group : scopes_.back().kind;
    if (w == "DEF") {
      skip();
      name_ = names_.add(word());
    } else if (w == "USE") {
      skip();
      use(word());
    } else if ((inside == node_kind::coordinates && w == "point") ||
               (inside == node_kind::vertex_property && w == "vertex")) {
      points();
    } else if (inside == node_kind::face_set && w == "coordIndex") {
      faces();
    } else if (inside == node_kind::face_set && w == "materialIndex") {
      for_each_value("a material index", [&] {
        const std::int64_t i = integer("a material index");
        materials_.push_back(static_cast<int>(i));
        materials_fit_ = materials_fit_ && i == materials_.back();
      });
    }
    return w;
  }

  void use(std::string_view name) {
    const std::size_t i = names_.find(name);
    if (i < range_of_.size() && range_of_[i] != 0) points_ = range_of_[i];
    else ++num_copies_;
  }

  void points() {
    const std::size_t begin = out_.points.size();
    for_each_value("the x of a vert", [&] {
      vec3 p;
      p.x = real("the x of a vert");
      skip();
      p.y = real("the y of a vert");
      skip();
      p.z = real("the z of a vert");
      out_.points.push_back(p);
    });
    if (out_.points.size() > max_ids) fail_to_count("verts");
    if (out_.points.size() == begin) return;
    points_ = ranges_.size();
    ranges_.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(out_.points.size() - begin)});
    if (const std::size_t n = scopes_.back().name; n != name_table::none) {
      range_of_.resize(std::max(range_of_.size(), n + 1));
      range_of_[n] = points_;
    }
  }

  /// Reads polygons, each of which -1 or the end of the list ends. Indices count from the first point of the node,
  /// which may be given later.
  void faces() {
    std::size_t first = out_.verts.size();
    const char* face = nullptr;
    for_each_value("the index of a vert or -1", [&] {
      const char* const position = at;
      const std::int64_t i = integer("the index of a vert or -1");
      if (i < -1 || i >= static_cast<std::int64_t>(max_ids)) fail(position, "the index of a vert or -1");
      if (i == -1) {
        if (out_.verts.size() > first) end_face(face, first);
        first = out_.verts.size();
        return;
      }
      if (out_.verts.size() == first) face = position;
      if (i > max_index_) {
        max_index_ = i;
        at_max_index_ = position;
      }
      const vert_id v{static_cast<std::uint32_t>(i)};
      out_.verts.push_back(v);
    });
    if (out_.verts.size() > first) end_face(face, first);
  }

  void end_face(const char* position, std::size_t first) {
    const std::size_t size = out_.verts.size() - first;
    if (size < 3) fail(position, {"a face of at least three verts"}, {"one of ", size});
    end_checked_poly(*this, position, first, scratch_, wanted_, extra_, arity_,
                     {.different = "different verts at the corners of a face"});
  }

  std::size_t num_polys() const {
    return out_.offsets.empty() ? (arity_ ? out_.verts.size() / arity_ : 0) : out_.offsets.size() - 1;
  }

  /// Ends a node IndexedFaceSet: its points are known now.
  void end_faces() {
    const point_range points = ranges_[points_];
    if (max_index_ >= static_cast<std::int64_t>(points.size)) {
      if (points.size == 0)
        fail(at_max_index_, {"points (Coordinate3 or VertexProperty) for the indices of IndexedFaceSet"}, {"none"});
      fail(at_max_index_, {"the index of a vert from 0 to ", points.size - 1, " or -1"});
    }
    if (points.begin != 0)
      for (std::size_t k = first_corner_; k < out_.verts.size(); ++k)
        out_.verts[k] = vert_id{out_.verts[k].raw() + points.begin};
    set_labels();
  }

  /// Material indices are labels if there is one for each face. A single -1 is the default value of the field.
  void set_labels() {
    const std::size_t polys = num_polys() - first_poly_;
    if (materials_.empty() || (materials_.size() == 1 && materials_[0] == -1)) return;
    if (materials_.size() != polys || !materials_fit_) {
      num_unmatched_ += materials_.size();
      return;
    }
    extra_.poly_labels.resize(first_poly_);
    extra_.poly_labels.insert(extra_.poly_labels.end(), materials_.begin(), materials_.end());
  }

  void report_skipped() const {
    skipped_nodes_.report(report_.skipped);
    if (num_copies_) report_.skipped.push_back(core::joined({num_copies_, " nodes used again (USE)"}));
    if (num_unmatched_)
      report_.skipped.push_back(core::joined({num_unmatched_, " material indices that are not one for each face"}));
  }
};

}  // namespace concino::detail

namespace concino {

/// Needs:  text of an Open Inventor file in ASCII, whose first line begins with #Inventor.
/// Result: the points of all nodes Coordinate3 and VertexProperty and the polys of all nodes IndexedFaceSet, in the
///         order of the file. Each node refers to the points before it, those in it, or those that it names by USE.
///         Indices of materials become labels of the polys of their node if there is one for each poly; polys of other
///         nodes have label 0. Nodes of other types, transformations too, are reported as skipped.
/// Cost:   O(size of the text)
/// Errors: parse_error naming the line of a number that is invalid or not finite, of an index out of range, of a poly
///         of fewer than three verts or with a vert twice, of a poly that the wanted mesh cannot hold, of a bracket
///         without its counterpart, or if the file is cut off; unsupported if the file is binary.
inline void iv_format::read(const read_context& in, file_contents& out) { detail::iv_reader(in, out).read(); }

}  // namespace concino
