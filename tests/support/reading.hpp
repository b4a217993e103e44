// Text to arrays, without a file or a mesh, for tests of readers.
#pragma once

#include <concino/io/load.hpp>

#include <doctest/doctest.h>

#include <string>

namespace concino::testing {

inline surface_arrays obj(const std::string& text, const load_options& options = {}) {
  return load_text<surface_arrays>(text, file_format::obj, options, "t.obj");
}

/// The line that reading M from the text complains of; 0 if it does not.
template<class M>
std::size_t bad_line(const std::string& text, file_format format) {
  try {
    load_text<M>(text, format);
  } catch (const parse_error& e) {
    CHECK(!e.expected.empty());
    CHECK(!e.found.empty());
    return e.line;
  }
  return 0;
}

template<class Ids>
std::vector<unsigned> raw(const Ids& ids) {
  std::vector<unsigned> r;
  for (const auto x : ids) r.push_back(x.raw());
  return r;
}

/// Every LF as another line end.
inline std::string with_line_ends(const std::string& text, const std::string& end) {
  std::string r;
  for (const char c : text) c == '\n' ? r += end : r += c;
  return r;
}

}  // namespace concino::testing
