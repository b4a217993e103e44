// The reader of PLY: verts, polygons, strips and edges with properties of any names; as text or binary.
#pragma once

#include <concino/io/detail/ply/ply_format.hpp>
#include <concino/io/detail/ply/ply_rows.hpp>

#include <algorithm>
#include <limits>

namespace concino::detail {

class ply_reader : ply_rows {
  load_report& report_;
  std::vector<std::array<double, 2>> textures_of_corners_;
  std::vector<vert_id> triangles_;  // of strips
  std::uint64_t num_odd_ = 0;

 public:
  ply_reader(const read_context& c, file_contents& out) : ply_rows(c, out), report_(*c.report) {}

  void read() {
    header();
    for (const ply_element& e : elements_)
      if (e.name == "vertex") num_verts_ = e.count;
    if (std::none_of(elements_.begin(), elements_.end(), [](const ply_element& e) { return e.name == "vertex"; }))
      fail(binary_line_, {"an element vertex"}, {"none"});
    for (const ply_element& e : elements_) {
      require_room(e);
      if (e.count > max_ids) fail_to_count("elements of one kind");
      if (e.name == "vertex") verts(e);
      else if (e.name == "face") faces(e);
      else if (e.name == "edge") edges(e);
      else if (e.name == "tristrips") strips(e);
      else others(e);
    }
    add_triangles();
    if (surface_.offsets.empty()) surface_.arity = arity_;
    if (surface_.arity == 0 && surface_.offsets.empty()) surface_.offsets.push_back(0);
    add_textures();
    report_rest();
  }

 private:
  [[noreturn, gnu::noinline, gnu::cold]] void fail_element(const ply_element& e, const char* expected) const {
    fail(e.position, {expected}, {"none"});
  }

  void verts(const ply_element& e) {
    surface_.points.resize(e.count);
    ply_columns columns(e, element_kind::vert, out_);
    const std::string_view names[] = {"x", "y", "z"};
    for (std::size_t k = 0; k < 3; ++k)
      if (!columns.set_single(names[k], ply_use::coordinate, surface_.points.data(), k * sizeof(double), sizeof(vec3)))
        fail_element(e, "properties x, y and z of element vertex");
    const std::vector<ply_column>& all = columns.finish();
    for (std::uint64_t i = 0; i < e.count; ++i) row(all, i);
  }

  void faces(const ply_element& e) {
    ply_columns columns(e, element_kind::poly, out_);
    const ply_property* const corners = columns.set_list("vertex_indices", "vertex_index", ply_use::corners);
    if (!corners || !is_integer(corners->type)) fail_element(e, "a list vertex_indices of integers of element face");
    const bool has_texture = columns.set_list("texcoord", {}, ply_use::reals) != nullptr;
    const std::vector<ply_column>& all = columns.finish();
    for (std::uint64_t i = 0; i < e.count; ++i) {
      const std::size_t first = surface_.verts.size();
      row(all, i);
      if (has_texture) end_textures(surface_.verts.size() - first);
    }
  }

  void edges(const ply_element& e) {
    ply_columns columns(e, element_kind::edge, out_);
    out_.edges.verts.resize(2 * e.count);
    const std::string_view names[] = {"vertex1", "vertex2"};
    for (std::size_t k = 0; k < 2; ++k) {
      const ply_property* const p = e.find(names[k]);
      constexpr std::size_t size = sizeof(vert_id);
      if (!p || p->is_list() || !is_integer(p->type) ||
          !columns.set_single(names[k], ply_use::end, out_.edges.verts.data(), k * size, 2 * size))
        fail_element(e, "properties vertex1 and vertex2 of element edge, integers");
    }
    const std::vector<ply_column>& all = columns.finish();
    for (std::uint64_t i = 0; i < e.count; ++i) row(all, i);
    if (all.size() == 2) {
      out_.edges.verts.clear();
      if (e.count) report_.skipped.push_back(core::joined({e.count, " edges, which have no values"}));
      return;
    }
    for (std::uint64_t i = 0; i < e.count; ++i) out_.edges.offsets.push_back(static_cast<std::uint32_t>(2 * (i + 1)));
  }

  /// Strips of triangles, of which -1 ends one and begins another.
  void strips(const ply_element& e) {
    const ply_property* const list = e.find("vertex_indices", "vertex_index");
    if (!list || !list->is_list() || !is_integer(list->type))
      fail_element(e, "a list vertex_indices of integers of element tristrips");
    for (std::uint64_t i = 0; i < e.count; ++i)
      for (const ply_property& p : e.properties) {
        if (&p == list) strip(p);
        else skip_property(p);
      }
    report_.notes.push_back(core::joined({"the strips were split into ", triangles_.size() / 3, " triangles"}));
  }
  void strip(const ply_property& p) {
    std::int64_t a = -1, b = -1;  // the last two verts
    bool is_odd = false;
    for (std::size_t left_of_list = take_length(p); left_of_list > 0; --left_of_list) {
      const std::int64_t v = next_vert(p.type, -1);
      if (v < 0) {
        a = b = -1;
        is_odd = false;
        continue;
      }
      if (a >= 0 && a != b && b != v && v != a)
        for (const std::int64_t x : {is_odd ? b : a, is_odd ? a : b, v})
          triangles_.push_back(vert_id{static_cast<std::uint32_t>(x)});
      is_odd = is_odd != (a >= 0);
      a = b;
      b = v;
    }
  }
  void add_triangles() {
    for (std::size_t i = 0; i < triangles_.size(); i += 3) {
      const std::size_t first = surface_.verts.size();
      surface_.verts.insert(surface_.verts.end(), &triangles_[i], &triangles_[i] + 3);
      end_poly_at(binary_line_, first);
    }
  }

  void others(const ply_element& e) {
    std::string names;
    for (const ply_property& p : e.properties) names = core::joined({names, names.empty() ? "" : ", ", p.name});
    for (std::uint64_t i = 0; i < e.count && !e.properties.empty(); ++i)
      for (const ply_property& p : e.properties) skip_property(p);
    if (e.count) report_.skipped.push_back(core::joined({e.count, " elements \"", e.name, "\" with ", names}));
  }

  /// Ends the texture coordinates of a poly of n corners: two for each corner, or none.
  void end_textures(std::size_t n) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const bool fits = reals_.size() == 2 * n;
    num_odd_ += !fits && !reals_.empty();
    textures_of_corners_.resize(surface_.verts.size() - n, {none, none});
    for (std::size_t k = 0; k < n; ++k)
      textures_of_corners_.push_back(fits ? std::array<double, 2>{reals_[2 * k], reals_[2 * k + 1]}
                                          : std::array<double, 2>{none, none});
  }
  void add_textures() {
    if (num_odd_)
      report_.skipped.push_back(
          core::joined({"texture coordinates of ", num_odd_, " faces that have not two for each corner"}));
    if (std::all_of(textures_of_corners_.begin(), textures_of_corners_.end(),
                    [](const std::array<double, 2>& t) { return std::isnan(t[0]) && std::isnan(t[1]); }))
      return;
    textures_of_corners_.resize(surface_.verts.size(), {std::numeric_limits<double>::quiet_NaN(),
                                                        std::numeric_limits<double>::quiet_NaN()});
    std::copy(textures_of_corners_.begin(), textures_of_corners_.end(),
              out_.add_property<std::array<double, 2>>(element_kind::corner, "texture", textures_of_corners_.size()));
  }

  void report_rest() {
    for (const std::string& file : textures_)
      report_.skipped.push_back(core::joined({"the texture file \"", file, "\""}));
    if (binary_) {
      if (!at_end()) report_.skipped.push_back(core::joined({left(), " bytes after the last element"}));
    } else {
      skip_space();
      if (!text_without_padding({at, left()}).empty())
        report_.skipped.push_back(core::joined({"what follows the last element, from line ", line_of(at), " on"}));
    }
  }
};

}  // namespace concino::detail

namespace concino {

/// Needs:  text of a PLY file of version 1.0, as text or binary of either byte order.
/// Result: its verts and faces, in the order of the file; after these the triangles of its strips. Of verts, edges and
///         faces: nx, ny, nz become "normal" (vec3); red, green, blue and alpha, of which integers are divided by 255
///         or 65535, become "color" (rgba). Of verts: s, t or u, v or texture_u, texture_v become "texture"
///         (std::array<double, 2>). Of faces: a list texcoord with two numbers for each corner becomes "texture" of
///         corners. Numbers of one type in a row that are called name_x, name_y ... or name_0, name_1 ... become one
///         property "name" of the types that VTK files have. All others become properties of their type, or a
///         std::vector of it for lists. %XX in names stands for a character. Values of edges that the mesh does not
///         have, edges without values and other elements are reported as skipped.
/// Cost:   O(size of the text)
/// Errors: parse_error naming the line (in binary files, the byte) of a wrong header, a number that is invalid or does
///         not fit its type, a coordinate that is not finite, a count that is negative or larger than the file, an
///         index out of range, a face of fewer than three verts or with a vert twice, a face that the wanted mesh
///         cannot hold, or the end of a file that is cut off.
inline void ply_format::read(const read_context& in, file_contents& out) { detail::ply_reader(in, out).read(); }

}  // namespace concino
