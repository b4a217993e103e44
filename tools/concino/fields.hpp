// Numbers at the verts of a mesh: where they come from and where they go.
#pragma once

#include "mesh_files.hpp"

#include <concino/core/terminal_progress.hpp>
#include <concino/io/atomic_file.hpp>
#include <concino/io/save.hpp>
#include <concino/io/text_sink.hpp>
#include <concino/mesh/property.hpp>

#include <fmt/format.h>

#include <cstdio>
#include <iterator>

namespace program {

/// The vert of a number that was typed.
template<class M>
concino::vert_t<M> vert_of(const M& m, std::size_t number, const char* option) {
  if (number >= concino::num_verts(m))
    throw failure{wrong_usage, fmt::format("{}: there is no vert {}; the last one is {}", option, number,
                                           static_cast<std::ptrdiff_t>(concino::num_verts(m)) - 1)};
  return concino::vert_t<M>(static_cast<std::uint32_t>(number));
}

/// Writes a number for each vert: to the standard output if there is no path, as a text, or as a property of the mesh.
template<class M, class U>
void write_field(M& m, const U& u, const char* name, const std::string& path) {
  if (!path.empty() && !has_extension(path, ".txt")) {
    if (!has_extension(path, ".vtu") && !has_extension(path, ".vtk") && !has_extension(path, ".vtp") &&
        !has_extension(path, ".ply") && !has_extension(path, ".msh"))
      throw failure{not_written, path + ": values at verts are written to .vtu, .vtk, .vtp, .ply, .msh and .txt"};
    const auto values = concino::vert_property<double>(m, name);
    for (const auto v : concino::verts(m)) values[v] = u[v];
    or_fail(not_written, [&] {
      concino::terminal_progress line;
      concino::save_report report;
      concino::save(m, path, {.report = &report, .progress = line});
      for (const std::string& what : report.lost) say("lost: " + what);
    });
    return;
  }
  fmt::memory_buffer text;
  for (const auto v : concino::verts(m)) fmt::format_to(std::back_inserter(text), "{}\n", u[v]);
  if (path.empty()) {
    std::fwrite(text.data(), 1, text.size(), stdout);
    return;
  }
  or_fail(not_written, [&] {
    concino::atomic_file file(path);
    concino::text_sink out(file.descriptor(), path);
    out << std::string_view(text.data(), text.size());
    out.flush();
    file.commit();
  });
}

}  // namespace program
