// The reader of Wavefront OBJ: verts and polygons of any size, with colours, groups, materials, and texture coordinates
// and normals of corners. Lines that a mesh cannot store are counted and reported.
#pragma once

#include <concino/io/detail/formats/contents.hpp>
#include <concino/io/detail/obj/obj_corner_values.hpp>
#include <concino/io/detail/obj/obj_cursor.hpp>
#include <concino/io/detail/obj/obj_format.hpp>
#include <concino/io/detail/obj/obj_names.hpp>
#include <concino/io/detail/obj/obj_sizes.hpp>
#include <concino/io/detail/obj/obj_skipped.hpp>
#include <concino/io/detail/obj/obj_vert_colors.hpp>

namespace concino::detail {

class obj_reader : obj_cursor {
  const read_context& context_;
  const wanted_mesh& wanted_;
  file_contents& extra_;
  surface_arrays& out_;
  std::vector<std::string> libraries_;                                       // the names of material libraries
  corner_value_list<texture_point> texture_;
  corner_value_list<vec3> normal_;
  std::uint64_t points_ = max_ids, textures_ = max_ids, normals_ = max_ids;  // the final numbers, once they are known
  std::uint64_t max_point_ = 0, max_texture_ = 0, max_normal_ = 0;           // the largest index so far
  obj_skipped skipped_;
  obj_vert_colors colors_;
  std::uint32_t arity_ = 0;
  std::vector<std::uint64_t> scratch_;

 public:
  obj_reader(const read_context& c, file_contents& out)
      : obj_cursor(text_without_padding(c.text), c.name, c.progress), context_(c), wanted_(c.wanted), extra_(out),
        out_(out.surface), colors_(out.vert_colors) {}

  void read(load_report& report) {
    const std::string_view all{at, static_cast<std::size_t>(end() - at)};
    if (all.find_first_not_of(" \t\v\f\r\n") == all.npos) fail(end(), {"verts and faces"}, {"an empty file"});
    make_room(all);
    lines();
    // Indices may refer to elements later in the file, so their bounds are known only now. If an index is out of range,
    // the file is read again with the bounds, to find the line.
    if (max_point_ > out_.points.size() || max_texture_ > texture_.size() || max_normal_ > normal_.size()) {
      points_ = out_.points.size(), textures_ = texture_.size(), normals_ = normal_.size();
      restart(all.data());
    }
    if (out_.points.empty() && skipped_.num_other > 0)
      fail(end(), {"verts (v x y z)"},
           {"none, and ", skipped_.num_other, " lines that are not of an OBJ file, the first '", skipped_.other, "'"});
    if (out_.offsets.empty()) out_.arity = arity_;
    if (out_.arity == 0 && out_.offsets.empty()) out_.offsets.push_back(0);
    skipped_.num_textures = texture_.store("texture", out_.verts.size(), extra_);
    skipped_.num_normals = normal_.store("normal", out_.verts.size(), extra_);
    skipped_.report(report, [this](std::size_t position) { return line_of(begin() + position); });
    if (colors_.finish(out_.points.size()))
      report.notes.push_back(
          "colours of verts: all numbers are whole and one is larger than 1, so they were read as components from 0 to 255");
    end_obj_names(context_, libraries_, extra_);
  }

 private:
  void make_room(std::string_view all) {
    const obj_sizes expected = expected_sizes_of_obj(all);
    out_.points.reserve(expected.points);
    out_.verts.reserve(expected.corners);
    if (expected.textures) texture_.reserve(expected.textures, expected.corners);
    if (expected.normals) normal_.reserve(expected.normals, expected.corners);
  }

  /// Reads the file again to throw the error. Members that do not influence the error are not reset.
  void restart(const char* from) {
    out_.points.clear();
    out_.offsets.clear();
    out_.verts.clear();
    at = from;
    texture_.clear();
    normal_.clear();
    lines();
  }

  void lines() {
    for (;;) {
      skip_space();
      if (at_end()) return;
      report_progress();
      const char c = *at, d = at + 1 != end() ? at[1] : '\n';
      if (c == 'v' && (is_space(d) || d == '\\')) vert();
      else if (c == 'f' && (is_space(d) || d == '\\')) face();
      else if (c == 'v' && (d == 't' || d == 'n') && (end() - at == 2 || is_space(at[2]) || at[2] == '\\'))
        corner_value(d == 't');
      else if (c == '#') text_cursor::skip_line();  // a backslash at the end of a comment does not join lines
      else other();
    }
  }

  void vert() {
    ++at;
    vec3 p;
    p.x = coordinate("the x of a vert");
    p.y = coordinate("the y of a vert");
    p.z = coordinate("the z of a vert");
    out_.points.push_back(p);
    blanks();
    if (line_is_over()) text_cursor::skip_line();
    else after_point();
  }

  /// Reads a texture coordinate u [v [w]] or a normal. If it has no finite numbers, as some programs write, it is no
  /// value.
  void corner_value(bool is_texture) {
    const char* const line = at;
    at += 2;
    double x[3] = {};
    unsigned n = 0;
    for (blanks(); n < 3 && !line_is_over(); blanks(), ++n) {
      const char* const p = parse_real(at, end(), x[n]);
      if (!p || !ends_token(p, '#') || !std::isfinite(x[n])) break;
      at = p;
    }
    const bool is_valid = is_texture ? n > 0 && (n == 3 || line_is_over()) : n == 3;
    if (!is_valid && skipped_.num_invalid++ == 0) skipped_.first_invalid = static_cast<std::size_t>(line - begin());
    if (is_texture && is_valid) skipped_.num_third += x[2] != 0;
    if (is_texture) texture_.add(is_valid ? texture_point{x[0], x[1]} : no_corner_value<texture_point>());
    else normal_.add(is_valid ? vec3{x[0], x[1], x[2]} : no_corner_value<vec3>());
    skip_joined_line();
  }

  /// Reads the weight or the colour after the coordinates of a vert.
  void after_point() {
    constexpr const char* expected = "a number (a weight or a colour) or the end of the line";
    double x[3] = {};
    std::size_t n = 0;
    const char* not_finite = nullptr;
    bool is_whole = true;
    for (; !line_is_over(); ++n, blanks()) {
      double value = 0;
      const char* const p = parse_real(at, end(), value);
      if (!p || !ends_token(p, '#')) fail(at, expected);
      if (!std::isfinite(value)) not_finite = at;
      for (; at != p; ++at) is_whole = is_whole && is_digit(*at);
      if (n < 3) x[n] = value;
    }
    if (not_finite && n != 3) fail(not_finite, {expected, ", a finite number"});
    text_cursor::skip_line();
    if (n != 3) ++skipped_.num_extra;
    else if (not_finite) ++skipped_.num_bad_colors;
    else colors_.add(out_.points.size() - 1, x, is_whole);
  }

  void face() {
    const char* const line = at++;
    const std::size_t first = out_.verts.size();
    for (blanks(); !line_is_over(); blanks()) {
      const char* const corner = at;
      std::int64_t i = 0;
      const char* p = parse_integer(at, end(), i);
      if (!p) fail(at, "the index of a vert");
      const std::uint64_t v = absolute(corner, i, out_.points.size(), points_, "a vert");
      if (v > max_point_) max_point_ = v;
      if (p != end() && *p == '/') p = attributes(corner, p);
      if (!ends_token(p, '#')) fail(corner, "a corner v, v/vt, v//vn or v/vt/vn");
      at = p;
      const vert_id id{static_cast<std::uint32_t>(v - 1)};
      out_.verts.push_back(id);
    }
    text_cursor::skip_line();
    end_face(line, first);
  }

  /// Reads the indices of a texture coordinate and a normal, each of which may be missing. Some programs write 0 for
  /// none.
  const char* attributes(const char* corner, const char* p) {
    p = attribute(corner, p + 1, texture_, textures_, max_texture_, "a texture coordinate");
    return p != end() && *p == '/' ? attribute(corner, p + 1, normal_, normals_, max_normal_, "a normal") : p;
  }
  template<class T>
  const char* attribute(const char* corner, const char* p, corner_value_list<T>& values, std::uint64_t bound,
                        std::uint64_t& largest, const char* what) {
    std::int64_t i = 0;
    const char* const q = parse_integer(p, end(), i);
    if (!q) return p;
    if (i == 0) {
      ++skipped_.num_zero;
    } else {
      const std::uint64_t k = absolute(corner, i, values.size(), bound, what);
      values.set(out_.verts.size(), k - 1);
      if (k > largest) largest = k;
    }
    return q;
  }

  void end_face(const char* line, std::size_t first) {
    const std::size_t size = out_.verts.size() - first;
    if (size < 3) fail(line, {"a face of at least three corners"}, {"one of ", size});
    end_checked_poly(*this, line, first, scratch_, wanted_, extra_, arity_,
                     {.different = "different verts at the corners of a face", .first = 1});
  }

  std::size_t num_polys() const {
    return out_.offsets.empty() ? (arity_ ? out_.verts.size() / arity_ : 0) : out_.offsets.size() - 1;
  }

  void other() {
    const char* const from = at;
    while (at != end() && (is_letter(*at) || is_digit(*at) || *at == '_')) ++at;
    const std::string_view word{from, static_cast<std::size_t>(at - from)};
    if (!is_letter(*from) || !(ends_token(at, '#'))) fail(from, "a keyword of OBJ such as v or f");
    if (word == "l" || word == "p") ++skipped_.num_lines;
    else if (word == "g") return extra_.groups.change(num_polys(), name_to_end_of_line());
    else if (word == "o") return extra_.objects.change(num_polys(), name_to_end_of_line());
    else if (word == "usemtl") return extra_.materials.change(num_polys(), name_to_end_of_line());
    else if (word == "mtllib") return libraries_.push_back(name_to_end_of_line());
    else if (word == "s") ++skipped_.num_smooth;
    else if (skipped_.num_other++ == 0) {
      skipped_.other = std::string(word.substr(0, 40));
      skipped_.first_other = static_cast<std::size_t>(from - begin());
    }
    skip_joined_line();
  }
};

}  // namespace concino::detail

namespace concino {

/// Needs:  text of an OBJ file. Lines may end in LF, CRLF or CR, and go on after a backslash; indices count from 1 or
///         back from the last.
/// Result: its verts and polys, in the order of the file; isolated verts and equal positions are kept. `v x y z r g b`
///         defines the colour of a vert, by components from 0 to 1, or from 0 to 255 if all in the file are whole
///         numbers and one exceeds 1; the others are white. An index 0 of vt or vn is none. `o`, `g` and `usemtl`
///         define names of polys, of at most 1000 bytes. Labels number the groups (the objects if there are no groups)
///         from 1, in the order of the file. If all groups are called label_<number>, they become labels only. Texture
///         coordinates and normals become "texture" (std::array<double, 2>) and "normal" (vec3) of corners, if a corner
///         has one; those of the other corners are not-a-number. Kd and d in the libraries define colours of polys. A
///         material called color_<number> that defines nothing else becomes a colour only. `table` holds all lines of
///         the libraries.
/// Cost:   O(size of the text)
/// Errors: parse_error naming the line of a number that is invalid or not finite, of an index out of range, of a poly
///         of fewer than three verts or with a vert twice, or of a poly that the wanted mesh cannot hold; parse_error
///         if the file is empty.
inline void obj_format::read(const read_context& in, file_contents& out) {
  detail::obj_reader(in, out).read(*in.report);
}

}  // namespace concino
