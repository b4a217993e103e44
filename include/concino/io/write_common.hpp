// What writers of all formats share: verts numbered densely, points checked, progress told.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/geometry/vec3.hpp>
#include <concino/io/options.hpp>
#include <concino/io/text_sink.hpp>

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

  std::uint32_t number_of(const vert_t<M>& v) const { return number[index_of(mesh, v)]; }
};

/// One line a vert: `before`, its coordinates, after(v). Errors: invalid_mesh if one is not finite, naming the vert.
template<class M, class After>
void write_points(write_context<M>& c, std::string_view before, const After& after) {
  c.number.assign(static_cast<std::size_t>(vert_index_bound(c.mesh)), 0);
  std::uint32_t n = 0;
  for (vert_t<M> v : verts(c.mesh)) {
    const std::size_t i = index_of(c.mesh, v);
    c.number[i] = n++;
    const vec3 p = to_vec3(point(c.mesh, v));
    if (!is_finite(p))
      throw invalid_mesh(std::string(c.name) + ": vert " + std::to_string(i) +
                         " has a coordinate that is not a finite number; no file can hold it");
    c.out << before << p.x << ' ' << p.y << ' ' << p.z;
    after(v);
    c.out << '\n';
    c.tell();
  }
}

[[noreturn]] inline void throw_cannot_hold(std::string_view name, std::string_view format, const std::string& what, const char* instead) {
  throw unsupported(std::string(name) + ": " + std::string(format) + " cannot hold " + what + "; save it as " + instead);
}

}  // namespace concino::detail
