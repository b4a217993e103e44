// Reads meshes from text in memory, for tests of readers.
#pragma once

#include <concino/io/load.hpp>

#include <doctest/doctest.h>

#include <string>

namespace concino::testing {

/// The contents of arrays as text; for a mesh, the numbers of its elements.
template<class M>
std::string listed(const M& m) {
  std::string r;
  const auto list = [&](const auto& values) {
    r += '|';
    for (const auto& x : values) {
      if constexpr (requires { x.raw(); }) r += std::to_string(x.raw()) + ' ';
      else if constexpr (requires { x.z; }) r += std::to_string(x.x) + ' ' + std::to_string(x.y) + ' ' + std::to_string(x.z) + ' ';
      else r += std::to_string(x) + ' ';
    }
  };
  if constexpr (requires { m.points; }) list(m.points);
  if constexpr (requires { m.verts; }) list(m.verts);
  if constexpr (requires { m.offsets; }) list(m.offsets);
  if constexpr (requires { m.arity; }) r += '|' + std::to_string(m.arity);
  if constexpr (requires { m.face_verts; }) list(m.face_verts), list(m.face_offsets), list(m.poly_faces), list(m.poly_offsets), list(m.outward);
  if constexpr (requires { num_verts(m); }) r += std::to_string(num_verts(m)) + ' ' + std::to_string(num_polys(m));
  return r;
}

/// Calls load_text twice, with different characters after the text in memory: these must not be read, so the results must be equal.
template<class M>
M load_alone(const std::string& text, format_id format, const load_options& options = {}, const std::string& name = "t") {
  const auto outcome = [&](std::string_view part) {
    try {
      return listed(load_text<M>(part, format, options, name));
    } catch (const error& e) {
      return std::string(e.what());
    }
  };
  const std::string expected = outcome(text);
  for (const char* tail : {"7", "/7", " 7", "\\\n7", "\n7", "e5", "#", "Y\n"}) CHECK(outcome(std::string_view(text + tail).substr(0, text.size())) == expected);
  return load_text<M>(text, format, options, name);
}

inline surface_arrays obj(const std::string& text, const load_options& options = {}) {
  return load_alone<surface_arrays>(text, file_format::obj, options, "t.obj");
}

/// The error of reading M from the text, as "line: expected | found". Empty if there is none.
template<class M>
std::string complaint(const std::string& text, format_id format) {
  try {
    load_alone<M>(text, format);
  } catch (const parse_error& e) {
    CHECK(!e.expected.empty());
    CHECK(!e.found.empty());
    return std::to_string(e.line) + ": " + e.expected + " | " + e.found;
  }
  return {};
}

/// The line of the error; 0 if there is none.
template<class M>
std::size_t bad_line(const std::string& text, format_id format) {
  const std::string said = complaint<M>(text, format);
  return said.empty() ? 0 : std::stoul(said);
}

template<class Ids>
std::vector<unsigned> raw(const Ids& ids) {
  std::vector<unsigned> r;
  for (const auto x : ids) r.push_back(x.raw());
  return r;
}

/// Replaces every LF by another line end.
inline std::string with_line_ends(const std::string& text, const std::string& end) {
  std::string r;
  for (const char c : text) c == '\n' ? r += end : r += c;
  return r;
}

}  // namespace concino::testing
