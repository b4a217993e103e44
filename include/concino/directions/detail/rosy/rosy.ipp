// Bodies of rosy.hpp: the reader and the writer of .rosy files.
#pragma once

#include <concino/core/error.hpp>
#include <concino/directions/rosy.hpp>
#include <concino/io/atomic_file.hpp>
#include <concino/io/file_text.hpp>
#include <concino/io/text_cursor.hpp>
#include <concino/io/text_sink.hpp>

#include <cstdint>

namespace concino {

CONCINO_INLINE rosy load_rosy_text(std::string_view text, std::string_view name) {
  token_cursor in(text, name, nullptr, 0);
  rosy r;
  const std::uint64_t n = in.next_count("the number of elements", 6);
  in.skip();
  const char* const at_symmetry = in.at;
  const std::int64_t symmetry = in.next_integer("the number of directions of an element");
  if (symmetry < 1 || symmetry > 16) in.fail(at_symmetry, "the number of directions of an element, 1 to 16");
  r.symmetry = static_cast<int>(symmetry);
  r.vectors.reserve(in.reservable(n, 6));
  for (std::uint64_t i = 0; i < n; ++i) {
    const double x = in.next_real("the x of a vector"), y = in.next_real("the y of a vector");
    r.vectors.push_back({x, y, in.next_real("the z of a vector")});
  }
  in.skip();
  if (!in.at_end()) in.fail(in.at, {"the end of the text after ", n, " vectors"});
  return r;
}

CONCINO_INLINE rosy load_rosy(const std::string& path) {
  const file_text file(path);
  return load_rosy_text(file.text(), path);
}

CONCINO_INLINE void save_rosy(const rosy& r, const std::string& path, const file_options& options) {
  if (r.symmetry < 1 || r.symmetry > 16) throw invalid_argument("save_rosy: symmetry must be from 1 to 16");
  for (std::size_t i = 0; i < r.vectors.size(); ++i)
    if (!is_finite(r.vectors[i])) core::throw_joined<invalid_argument>({"save_rosy: vector ", i, " is not finite"});
  atomic_file file(path, {.sync = options.sync});
  text_sink out(file.descriptor(), path);
  out << r.vectors.size() << ' ' << r.symmetry << '\n';
  for (const vec3& x : r.vectors) out << x.x << ' ' << x.y << ' ' << x.z << '\n';
  out.flush();
  file.commit();
}

}  // namespace concino
