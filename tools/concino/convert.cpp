// concino convert: a mesh in another format, or as another kind of mesh.
#include "mesh_files.hpp"

#include <concino/convert/convert.hpp>
#include <concino/core/terminal_progress.hpp>
#include <concino/generate/to_tets.hpp>
#include <concino/generate/to_triangles.hpp>
#include <concino/io/save.hpp>

#include <fmt/format.h>

#include <concepts>

namespace cn = concino;

namespace program {
namespace {

template<class M>
void write(const M& m, const convert_options& options) {
  cn::save_report report;
  or_fail(not_written, [&] {
    cn::terminal_progress line;
    cn::save(m, options.to,
             {.report = &report,
              .progress = line,
              .binary = options.binary,
              .as_triangles = options.as_triangles,
              .as_boundary = options.as_boundary,
              .strict = options.strict});
  });
  for (const std::string& what : report.lost) say("lost: " + what);
  for (const std::string& what : report.notes) say(what);
}

template<class To, class M>
void write_as(const M& m, const convert_options& options) {
  if constexpr (std::same_as<To, cn::trimesh> && cn::SurfaceMesh<M>) {
    write(or_fail(not_written, [&] { return cn::to_triangles(m); }), options);
  } else if constexpr (std::same_as<To, cn::tetmesh> && cn::VolumeMesh<M>) {
    write(or_fail(not_written, [&] { return cn::to_tets(m); }), options);
  } else if constexpr (cn::dimension_v<To> == cn::dimension_v<M>) {
    cn::convert_report report;
    const To to = or_fail(not_written, [&] { return cn::convert<To>(m, {.report = &report}); });
    for (const std::string& what : report.lost) say("lost: " + what);
    write(to, options);
  } else {
    throw failure{not_written, fmt::format("{} is a {}, which does not become a {}", options.from,
                                           cn::dimension_v<M> == 2 ? "surface" : "volume", options.kind)};
  }
}

}  // namespace

int convert(const convert_options& options) {
  std::visit(
      [&](const auto& m) {
        if (options.kind == "trimesh") write_as<cn::trimesh>(m, options);
        else if (options.kind == "quadmesh") write_as<cn::quadmesh>(m, options);
        else if (options.kind == "polygonmesh") write_as<cn::polygonmesh>(m, options);
        else if (options.kind == "tetmesh") write_as<cn::tetmesh>(m, options);
        else if (options.kind == "hexmesh") write_as<cn::hexmesh>(m, options);
        else if (options.kind == "polyhedralmesh") write_as<cn::polyhedralmesh>(m, options);
        else write(m, options);
      },
      load_mesh(options.from, {.corners_only = options.corners_only}));
  return done;
}

}  // namespace program
