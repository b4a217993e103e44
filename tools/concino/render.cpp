// concino render and concino view: a picture or a page of a mesh.
#include "ray_tracer.hpp"
#include "mesh_files.hpp"

#include <concino/core/terminal_progress.hpp>
#include <concino/mesh/property.hpp>
#include <concino/render/best_view.hpp>
#include <concino/render/png.hpp>
#include <concino/render/position_criteria.hpp>
#include <concino/render/render.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_html.hpp>

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string_view>
#include <utility>

namespace cn = concino;

namespace program {
namespace {

/// The property `name` of the verts, else of the polys, if its values are of one of these types.
template<class... T, class M>
bool find_field(const M& m, std::string_view name, cn::any_field<M>& field) {
  const auto is_set = [&](auto values) {
    if (!values) return false;
    field = cn::any_field<M>(std::move(values));  // which holds it then
    return true;
  };
  for (const cn::property_info& p : cn::property_list(m)) {
    if (p.name != name) continue;
    if (p.kind == cn::element_kind::vert &&
        ((*p.type == typeid(T) && is_set(cn::find_vert_property<T>(m, name))) || ...))
      return true;
    if (p.kind == cn::element_kind::poly &&
        ((*p.type == typeid(T) && is_set(cn::find_poly_property<T>(m, name))) || ...))
      return true;
  }
  return false;
}

/// The polys below a plane such as x=0.3, a fraction of the bounding box.
cn::coordinate_criterion criterion_of(const std::string& slice) {
  char* end = nullptr;
  const double fraction = slice.size() > 2 && slice[1] == '=' ? std::strtod(slice.c_str() + 2, &end) : 0;
  if (end == nullptr || *end != '\0' || slice[0] < 'x' || slice[0] > 'z')
    throw failure{wrong_usage, fmt::format("--slice {} is not an axis and a fraction, such as x=0.3", slice)};
  return or_fail(wrong_usage, [&] { return cn::below_fraction(slice[0], fraction); });
}

template<class M>
cn::scene scene_of(const M& m, const render_options& options) {
  if (cn::num_polys(m) == 0) throw failure{unreadable_input, options.file + " has no polys to draw"};
  cn::mesh_look<M> look;
  look.edges = options.edges;
  look.inspect = has_extension(options.to, ".html");
  look.name = std::filesystem::path(options.file).filename().string();
  if (!options.slice.empty()) look.visible = criterion_of(options.slice);
  if (!options.field.empty() &&
      !find_field<double, float, int, unsigned, long, unsigned long, short, unsigned short, signed char, unsigned char>(
          m, options.field, look.field))
    throw failure{wrong_usage, fmt::format("{} has no property {} of numbers at its verts or polys; concino info lists "
                                           "the properties",
                                           options.file, options.field)};
  cn::scene scene;
  or_fail(unreadable_input, [&] { scene.add(m, look); });
  return scene;
}

void write_picture(const cn::scene& scene, const render_options& options) {
  cn::terminal_progress line;
  cn::render_options render;
  render.width = options.width;
  render.height = options.height;
  render.progress = line;
  if (options.quality == picture_quality::draft) render.samples = 1, render.occlusion_rays = 4;
  if (options.quality == picture_quality::print) render.samples = 4, render.occlusion_rays = 256;
  const cn::image image = or_fail(wrong_usage, [&] {
    const double aspect = static_cast<double>(options.width) / static_cast<double>(options.height);
    render.camera = cn::best_view(scene.drawables(), aspect, {}, ray_tracer{});
    return cn::render(scene, render, ray_tracer{});
  });
  or_fail(not_written, [&] { cn::save_png(image, options.to); });
}

void write_page(const cn::scene& scene, const render_options& options) {
  or_fail(not_written, [&] {
    cn::save_html(scene, options.to, {.title = std::filesystem::path(options.file).filename().string()});
  });
}

/// Opens a page in the browser, where there is one and a display for it.
void open_browser(const std::string& path) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return;
  const std::string command = "command -v xdg-open >/dev/null 2>&1 && xdg-open '" + path + "' >/dev/null 2>&1 &";
  if (std::system(command.c_str()) != 0) say("the browser cannot be started");
}

/// A path of a page in the folder of temporary files that no file has.
std::string temporary_page() {
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  std::random_device random;
  for (;;) {
    const std::filesystem::path path = folder / fmt::format("concino-{:08x}.html", random());
    if (!std::filesystem::exists(path)) return path.string();
  }
}

}  // namespace

int render(const render_options& options) {
  const bool is_page = has_extension(options.to, ".html");
  if (!is_page && !has_extension(options.to, ".png"))
    throw failure{wrong_usage, fmt::format("-o {} ends neither with .png nor with .html", options.to)};
  const cn::scene scene =
      std::visit([&](const auto& m) { return scene_of(m, options); }, load_mesh(options.file));
  if (is_page) write_page(scene, options);
  else write_picture(scene, options);
  return done;
}

int view(const render_options& options) {
  render_options page = options;
  page.to = temporary_page();
  render(page);
  fmt::print("{}\n", page.to);
  std::fflush(stdout);
  open_browser(page.to);
  return done;
}

}  // namespace program
