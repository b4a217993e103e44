// What writers of all formats share: verts numbered densely, points checked, progress told.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/geometry/vec3.hpp>
#include <concino/io/numbers.hpp>
#include <concino/io/options.hpp>
#include <concino/io/properties.hpp>
#include <concino/io/text_sink.hpp>

#include <cmath>
#include <cstdint>
#include <vector>

namespace concino::detail {

template<class M>
struct write_context {
  const M& mesh;
  std::string_view name;  // for messages
  text_sink& out;
  save_report& report;
  const concino::progress& progress;
  std::vector<kept_property> kept;  // what the format holds of the properties of the mesh
  std::string* library = nullptr;   // where a material library goes: a file beside this one
  std::string library_name = {};
  std::size_t num_not_finite = 0;     // parts of colours and the like, written as 0
  std::vector<std::uint32_t> number;  // of each vert in the file, from 0: deleted verts leave no gap
  std::size_t done = 0, all = 0;

  write_context(const M& m, std::string_view n, text_sink& o, save_report& r, const concino::progress& p)
      : mesh(m), name(n), out(o), report(r), progress(p) {
    all = static_cast<std::size_t>(num_verts(m)) + static_cast<std::size_t>(num_polys(m));
  }

  /// Once an element.
  void tell() {
    if (done++ % 4096 == 0) detail::tell(progress, std::min(1.0, static_cast<double>(done) / static_cast<double>(all + 1)), "writing");
  }

  template<class T>
  void keep(element_kind kind, std::string_view property) {
    kept.push_back({kind, property, &typeid(T)});
  }

  /// A number that is no coordinate: files cannot hold those that are not finite.
  template<class T>
  T finite(T x) {
    if (std::isfinite(x)) return x;
    ++num_not_finite;
    return 0;
  }

  std::uint32_t number_of(const vert_t<M>& v) const { return number[index_of(mesh, v)]; }
};

/// The shortest digits that a reader of doubles makes the same float of; with a point where they must not look like an integer.
inline void write_part(text_sink& out, float x, bool is_real) {
  char digits[32];
  const char* end = std::to_chars(digits, digits + 32, x).ptr;
  double back = 0;
  parse_real(digits, end, back);
  if (static_cast<float>(back) != x) end = std::to_chars(digits, digits + 32, static_cast<double>(x)).ptr;  // it was rounded twice
  const std::string_view text(digits, static_cast<std::size_t>(end - digits));
  out << text;
  if (is_real && text.find_first_of(".e") == text.npos) out << ".0";
}

/// A name as a line can hold it. `changed` tells whether it is another.
inline std::string line_name(std::string name, bool& changed) {
  const std::string was = name;
  for (std::size_t i = 0; i < name.size(); ++i)
    if (static_cast<unsigned char>(name[i]) < 32 || name[i] == '\\' || (name[i] == '#' && (i == 0 || name[i - 1] == ' '))) name[i] = '_';
  if (name.starts_with(' ')) name.front() = '_';
  if (name.ends_with(' ')) name.back() = '_';
  changed = changed || name != was;
  return name;
}

/// One line a vert: `before`, its coordinates, after(v); but where other(point) writes them itself and says so, only after(v).
/// Errors: invalid_mesh if a coordinate is not finite, naming the vert.
template<class M, class After, class Other>
void write_points(write_context<M>& c, std::string_view before, const After& after, const Other& other) {
  c.number.assign(static_cast<std::size_t>(vert_index_bound(c.mesh)), 0);
  std::uint32_t n = 0;
  for (vert_t<M> v : verts(c.mesh)) {
    const std::size_t i = index_of(c.mesh, v);
    c.number[i] = n++;
    const vec3 p = to_vec3(point(c.mesh, v));
    if (!is_finite(p))
      throw invalid_mesh(std::string(c.name) + ": vert " + std::to_string(i) +
                         " has a coordinate that is not a finite number; no file can hold it");
    const bool is_line = !other(p);
    if (is_line) c.out << before << p.x << ' ' << p.y << ' ' << p.z;
    after(v);
    if (is_line) c.out << '\n';
    c.tell();
  }
}
template<class M, class After>
void write_points(write_context<M>& c, std::string_view before, const After& after) {
  write_points(c, before, after, [](const vec3&) { return false; });
}

[[noreturn]] inline void throw_cannot_hold(std::string_view name, std::string_view format, const std::string& what, const char* instead) {
  throw unsupported(std::string(name) + ": " + std::string(format) + " cannot hold " + what + "; save it as " + instead);
}

}  // namespace concino::detail
