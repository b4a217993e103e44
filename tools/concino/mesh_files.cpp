#include "mesh_files.hpp"

#include <concino/core/terminal_progress.hpp>
#ifdef CONCINO_TOOLS_ZLIB
#include <concino/adapters/zlib.hpp>
#endif

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstring>

namespace program {

void say(const std::string& message) { fmt::print(stderr, "concino: {}\n", message); }

bool has_extension(const std::string& path, const char* extension) {
  const std::size_t n = std::strlen(extension);
  return path.size() > n && std::equal(extension, extension + n, path.end() - static_cast<std::ptrdiff_t>(n),
                                       [](char x, char y) { return x == std::tolower(static_cast<unsigned char>(y)); });
}

concino::any_mesh load_mesh(const std::string& path, const load_choices& choices) {
  concino::load_report report;
  auto m = or_fail(unreadable_input, [&] {
    concino::terminal_progress line;
    concino::load_options options;
    options.report = &report;
    options.progress = line;
    options.corners_only = choices.corners_only;
    if (choices.collapses_repeated_verts) options.repeated_verts = concino::repeated_verts::collapse;
#ifdef CONCINO_TOOLS_ZLIB
    options.inflate = concino::zlib_inflate;
#endif
    return concino::load_any(path, options);
  });
  if (report.reoriented_polys > 0) say(fmt::format("{} polys of {} were turned", report.reoriented_polys, path));
  for (const std::string& what : report.skipped) say("left out: " + what);
  for (const std::string& what : report.notes) say(what);
  return m;
}

}  // namespace program
