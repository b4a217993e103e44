// The program `concino`: what is in a mesh file, what is wrong with it, and what it looks like.
#include "commands.hpp"

#include <concino/core/error.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <map>
#include <new>

namespace {

using namespace program;

constexpr const char* codes =
    "Exit codes: 0 done, 1 defects found, 2 wrong usage, 3 unreadable or unsupported input, 4 could not write.";

CLI::App* add_command(CLI::App& app, const char* name, const char* what, const char* example) {
  CLI::App* const command = app.add_subcommand(name, what);
  command->footer(fmt::format("Example:\n  concino {}\n\n{}", example, codes));
  return command;
}

/// A size such as 800x600.
void set_size(const std::string& text, render_options& options) {
  int used = 0;
  unsigned width = 0, height = 0;
  if (std::sscanf(text.c_str(), "%5ux%5u%n", &width, &height, &used) != 2 || text.size() != static_cast<std::size_t>(used))
    throw CLI::ValidationError("--size", text + " is not a width and a height, such as 800x600");
  options.width = width;
  options.height = height;
}

/// Verts and values such as 0=0 and 100=1.
std::vector<std::pair<std::size_t, double>> values_of(const std::vector<std::string>& words) {
  std::vector<std::pair<std::size_t, double>> values;
  for (const std::string& word : words) {
    std::size_t vert = 0;
    double value = 0;
    const std::size_t middle = word.find('=');
    if (middle == std::string::npos || !CLI::detail::lexical_cast(word.substr(0, middle), vert) ||
        !CLI::detail::lexical_cast(word.substr(middle + 1), value))
      throw CLI::ValidationError("--values", word + " is not a vert and its value, such as 0=1.5");
    values.push_back({vert, value});
  }
  return values;
}

void add_look(CLI::App* command, render_options& options) {
  command->add_option("file", options.file, "the mesh")->required();
  command->add_option("--field", options.field, "colours by this property of the verts or polys");
  command->add_option("--slice", options.slice, "shows the polys below this fraction of the box, such as x=0.3");
  command->add_flag("--edges", options.edges, "draws the edges");
}

int run(int argc, char** argv) {
  CLI::App app("Looks at meshes of polygons and polyhedra, checks, converts and draws them.", "concino");
  app.set_version_flag("--version", std::string("concino ") + CONCINO_PROGRAM_VERSION);
  app.require_subcommand(1);
  app.footer(codes);
  int code = done;

  info_options of_info;
  CLI::App* command = add_command(app, "info", "What is in a file: counts, topology, sizes, properties", "info bunny.obj");
  command->add_option("file", of_info.file, "the mesh")->required();
  command->add_flag("--json", of_info.json, "prints one JSON object");
  command->callback([&] { code = info(of_info); });

  validate_options of_validate;
  command = add_command(app, "validate", "What is wrong with a mesh; exit code 1 if anything is", "validate bunny.obj");
  command->add_option("file", of_validate.file, "the mesh")->required();
  command->add_flag("--all", of_validate.all, "prints all defects, not five of each kind");
  command->callback([&] { code = validate(of_validate); });

  convert_options of_convert;
  command = add_command(app, "convert", "Writes a mesh in another format", "convert bunny.obj bunny.vtu");
  command->add_option("in", of_convert.from, "the mesh")->required();
  command->add_option("out", of_convert.to, "the new file, whose extension names the format, or a polyMesh folder")->required();
  command
      ->add_option("--kind", of_convert.kind,
                   "the kind of mesh: polygons become triangles by trimesh, polyhedra tets by tetmesh")
      ->check(CLI::IsMember({"trimesh", "quadmesh", "polygonmesh", "tetmesh", "hexmesh", "polyhedralmesh"}));
  command->add_flag("--strict", of_convert.strict, "refuses if the format cannot hold everything");
  command->add_flag("--binary", of_convert.binary, "writes the binary form of the format");
  command->add_flag("--as-triangles", of_convert.as_triangles, "cuts polygons into triangles where the format needs it");
  command->add_flag("--as-boundary", of_convert.as_boundary, "writes the boundary of a volume to a format of surfaces");
  command->add_flag("--corners-only", of_convert.corners_only, "reads elements of higher order by their corners");
  command->callback([&] { code = convert(of_convert); });

  repair_options of_repair;
  command = add_command(app, "repair", "Mends what can be mended of a mesh, and says what it did",
                        "repair scan.stl scan.ply --merge 1e-6 --orient --fill 30");
  command->add_option("in", of_repair.from, "the mesh")->required();
  command->add_option("out", of_repair.to, "the mended mesh")->required();
  command->add_option("--merge", of_repair.merge, "verts at most this far apart become one");
  command->add_option("--fill", of_repair.fill, "fills holes of at most so many edges");
  command->add_flag("--orient", of_repair.orient, "winds polys alike, and outward where the surface is closed");
  command->add_flag("--split", of_repair.split, "splits verts and edges where a surface is not manifold");
  command->add_flag("--collapse", of_repair.collapse, "collapses triangles without area");
  command->add_flag("--remove-intersecting", of_repair.remove_intersecting,
                    "removes triangles that intersect others, and fills the holes");
  command->callback([&] { code = repair(of_repair); });

  render_options of_render;
  std::string size;
  command = add_command(app, "render", "Draws a picture (.png), or a page for web browsers (.html)",
                        "render bunny.obj -o bunny.png --edges");
  add_look(command, of_render);
  command->add_option("-o,--output", of_render.to, "the picture or page")->required();
  command->add_option("--size", size, "of the picture in pixels, such as 800x600");
  const std::map<std::string, picture_quality> qualities = {
      {"draft", picture_quality::draft}, {"normal", picture_quality::normal}, {"print", picture_quality::print}};
  command->add_option("--quality", of_render.quality, "draft, normal or print")
      ->transform(CLI::CheckedTransformer(qualities, CLI::ignore_case));
  command->callback([&] {
    if (!size.empty()) set_size(size, of_render);
    code = render(of_render);
  });

  render_options of_view;
  command = add_command(app, "view", "Writes a page to a temporary file, prints its path and opens it in the browser",
                        "view bunny.obj");
  add_look(command, of_view);
  command->callback([&] { code = view(of_view); });

  harmonic_options of_harmonic;
  std::vector<std::string> values;
  command = add_command(app, "harmonic",
                        "A field with given values at some verts, smooth between them; a line for each vert",
                        "harmonic bunny.obj --values 0=0,100=1 -o field.vtu");
  command->add_option("file", of_harmonic.file, "the mesh")->required();
  command->add_option("--values", values, "verts and their values, such as 0=0,100=1")->required()->delimiter(',');
  command->add_option("-o,--output", of_harmonic.to, "a mesh with the property harmonic, or a .txt");
  command->callback([&] {
    of_harmonic.values = values_of(values);
    code = harmonic(of_harmonic);
  });

  geodesic_options of_geodesic;
  command = add_command(app, "geodesic",
                        "Distances from verts: exact on triangles, by the heat method on other meshes; a line each",
                        "geodesic bunny.obj --from 0 -o distances.vtu");
  command->add_option("file", of_geodesic.file, "the mesh")->required();
  command->add_option("--from", of_geodesic.from, "verts, by number")->required()->delimiter(',');
  command->add_option("-o,--output", of_geodesic.to, "a mesh with the property distance, or a .txt");
  command->callback([&] { code = geodesic(of_geodesic); });

  demo_options of_demo;
  command = add_command(app, "demo", "A harmonic field between two far ends of a mesh, its picture and its page",
                        "demo bunny.obj demo.png");
  command->add_option("file", of_demo.file, "the mesh")->required();
  command->add_option("picture", of_demo.picture, "the picture; the page and the values get its name")->required();
  command->add_flag("--print", of_demo.for_print, "more samples a pixel, which takes more time");
  command->callback([&] { code = demo(of_demo); });

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& e) {
    return app.exit(e);
  } catch (const CLI::ParseError& e) {
    app.exit(e);
    return wrong_usage;
  }
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const program::failure& e) {
    fmt::print(stderr, "concino: {}\n", e.message);
    return e.code;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "concino: not enough memory\n");
  } catch (const std::exception& e) {
    fmt::print(stderr, "concino: {}\n", e.what());
  }
  return unreadable_input;
}
