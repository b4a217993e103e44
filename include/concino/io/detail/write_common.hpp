// What writers of all formats share: verts numbered densely, points checked, progress told.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/vec3.hpp>
#include <concino/io/detail/library_file.hpp>
#include <concino/io/numbers.hpp>
#include <concino/io/detail/properties.hpp>
#include <concino/io/options.hpp>
#include <concino/io/text_sink.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

/// What writers need beside the mesh.
struct write_state {
  std::string_view name;  // for messages
  text_sink& out;
  save_report& report;
  const concino::progress& progress;
  std::size_t done = 0, all = 0;  // elements
  kept_property kept[8] = {};     // what the format holds of the properties of the mesh
  std::size_t num_kept = 0;
  library_file* library = nullptr;  // where materials go; null: there is no file beside this one
  std::size_t num_not_finite = 0;          // parts of colours and the like, written as 0
  std::vector<std::uint32_t> number = {};  // of each vert in the file, from 0: deleted verts leave no gap
  std::uint32_t next_number = 0;

  /// Once an element.
  void tell() {
    if (done++ % 4096 == 0) detail::tell(progress, std::min(1.0, static_cast<double>(done) / static_cast<double>(all + 1)), "writing");
  }

  void keep(element_kind kind, const char* property, const std::type_info& type) {
    assert(num_kept < 8);
    kept[num_kept++] = {kind, property, &type};
  }

  /// A number that is no coordinate: files cannot hold those that are not finite.
  double finite(double x) {
    if (std::isfinite(x)) return x;
    ++num_not_finite;
    return 0;
  }
  float finite(float x) { return static_cast<float>(finite(static_cast<double>(x))); }

  /// Errors: invalid_mesh if a coordinate is not finite, naming the vert by its index.
  void check_point(const vec3& p, std::size_t index) const {
    if (!is_finite(p))
      core::throw_joined<invalid_mesh>({name, ": vert ", index, " has a coordinate that is not a finite number; no file can hold it"});
  }

  [[noreturn, gnu::noinline, gnu::cold]] void cannot_hold(std::string_view format, core::message what, const char* instead) const {
    core::throw_joined<unsupported>({name, ": ", format, " cannot hold ", core::joined(what), "; save it as ", instead});
  }
};

template<class M>
struct write_context : write_state {
  const M& mesh;

  write_context(const M& m, std::string_view n, text_sink& o, save_report& r, const concino::progress& p)
      : write_state{n, o, r, p, 0, num_verts(m) + num_polys(m)}, mesh(m) {
    number.resize(vert_index_bound(m));
  }

  std::uint32_t number_of(const vert_t<M>& v) const { return number[index_of(mesh, v)]; }

  /// The place of v, which becomes the next vert of the file. Errors: as check_point.
  vec3 next_point(const vert_t<M>& v) {
    const std::size_t i = index_of(mesh, v);
    number[i] = next_number++;
    const vec3 p = to_vec3(point(mesh, v));
    check_point(p, i);
    return p;
  }
};

[[gnu::noinline]] inline void write_point(text_sink& out, const vec3& p) { out << p.x << ' ' << p.y << ' ' << p.z; }

/// The shortest digits that a reader of doubles makes the same float of; with a point where they must not look like an integer.
[[gnu::noinline]] inline void write_part(text_sink& out, float x, bool is_real) {
  char digits[32];
  const char* end = std::to_chars(digits, digits + 32, x).ptr;
  double back = 0;
  parse_real(digits, end, back);
  if (static_cast<float>(back) != x) end = std::to_chars(digits, digits + 32, static_cast<double>(x)).ptr;  // it was rounded twice
  const std::string_view text(digits, static_cast<std::size_t>(end - digits));
  out << text;
  if (is_real && text.find_first_of(".e") == text.npos) out << ".0";
}

}  // namespace concino::detail
