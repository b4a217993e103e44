// Writes the pages that pages.mjs opens in a browser, and what it should find there:  browser_pages <folder>

#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/level_sets.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>

#include <fmt/core.h>
#include <fmt/os.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace cn = concino;

namespace {

constexpr std::size_t width = 640, height = 480;

/// Writes which pixels of a picture show something: rows of 0 and 1.
void write_silhouette(const cn::scene& s, const cn::camera& from, const std::string& path) {
  const cn::image picture = cn::render(
      s, {.width = width, .height = height, .camera = from, .samples = 1, .occlusion_rays = 0, .ground = false, .transparent_background = true});
  auto out = fmt::output_file(path);
  for (std::size_t y = 0; y < height; ++y) {
    std::string row;
    for (std::size_t x = 0; x < width; ++x) row += picture.opacity(x, y) > 0 ? '1' : '0';
    out.print("{}\n", row);
  }
}

struct nearest_polygon {
  std::size_t poly = 0, element = 0;
  cn::vec3 middle;
};

/// The outer polygon whose middle is nearest to the viewer, so that nothing hides it.
template<class M>
nearest_polygon nearest(const M& m, const cn::camera& from) {
  nearest_polygon best;
  double depth = -std::numeric_limits<double>::infinity();
  const cn::drawable d = cn::make_drawable(m);
  for (std::size_t p = 0; p + 1 < d.offsets.size(); ++p) {
    cn::vec3 middle;
    for (auto c = d.offsets[p]; c < d.offsets[p + 1]; ++c) middle += d.points[d.corners[c]] / (d.offsets[p + 1] - d.offsets[p]);
    if (const double z = cn::dot(middle, from.back); z > depth) depth = z, best = {d.polys[p], d.mesh_polygons[p], middle};
  }
  return best;
}

/// The page of a mesh with fields, and what is known of it.
template<class M>
void write_kind(const M& mesh, const std::string& name, const std::string& folder, fmt::ostream& out) {
  M m = mesh;
  auto height_of = cn::vert_property<double>(m, "height");
  auto velocity = cn::vert_property<cn::vec3>(m, "velocity");
  auto label = cn::poly_property<int>(m, "label");
  auto part = cn::poly_property<std::string>(m, "part");
  for (const auto v : cn::verts(m)) {
    const cn::vec3 x = cn::to_vec3(cn::point(m, v));
    height_of[v] = x.y;
    velocity[v] = {-x.y, x.x, 0};
  }
  for (const auto p : cn::polys(m)) label[p] = static_cast<int>(cn::index_of(m, p) % 7), part[p] = fmt::format("part {}", cn::index_of(m, p));
  auto u = cn::make_vert_map<double>(m, 0.0);
  for (const auto v : cn::verts(m)) {
    const cn::vec3 x = cn::to_vec3(cn::point(m, v));
    u[v] = std::sin(3 * x.x) + x.y * x.z;
  }
  for (const bool parallel : {false, true}) {
    const std::string file = name + (parallel ? "_orthographic" : "");
    cn::scene s;
    s.add(m, {.field = u, .isolines = 8, .edges = true, .inspect = true, .name = name});
    const cn::view_options looks{.towards = {0.4, 0.7, 1}, .angle = parallel ? 0.0 : 25.0};
    const cn::camera from = cn::frame(s.drawables(), static_cast<double>(width) / height, looks);
    cn::save_html(s, folder + "/" + file + ".html", {.title = file, .camera = from});
    write_silhouette(s, from, folder + "/" + file + ".txt");
    const nearest_polygon at = nearest(m, from);
    const cn::image_point film = from.project(at.middle);
    out.print("  {{\"page\": \"{}\", \"polys\": {}, \"x\": {}, \"y\": {}, \"poly\": {}, \"element\": {}, \"label\": {}, \"volume\": {},\n", file, cn::num_polys(m),
              width / 2.0 + film.x * height / 2, height / 2.0 - film.y * height / 2, at.poly, at.element, static_cast<int>(at.poly % 7), cn::VolumeMesh<M>);
    const cn::box b = cn::bounding_box(m);
    std::size_t below = 0, peeled = 0;
    const auto is_below = cn::visible_polys(m, cn::below('x', (b.min.x + b.max.x) / 2));
    const auto stays = cn::visible_polys(m, cn::peeled(1));
    for (const auto p : cn::polys(m)) below += is_below[p], peeled += stays[p];
    double area = 0;
    if constexpr (cn::VolumeMesh<M>) area = cn::total_measure(cn::slice(m, {.normal = {0, 0, 1}, .offset = 0.7 * b.min.z + 0.3 * b.max.z}).mesh);
    out.print("   \"below\": {}, \"peeled\": {}, \"area\": {}}},\n", below, peeled, area);
  }
}

/// Pages that only have to be shown: texts that look like scripts, extreme coordinates, nothing, values that are no numbers.
void write_odd(const std::string& folder) {
  const std::string evil = "</script><script>window.broken = 1</script><img src=x onerror='window.broken = 2'>\"'\\\x01 \xE2\x80\xAE" "abc";
  cn::trimesh m = cn::make_sphere<cn::trimesh>();
  auto text = cn::vert_property<std::string>(m, evil);
  for (const auto v : cn::verts(m)) text[v] = evil;
  cn::scene strings;
  strings.add(m, {.inspect = true, .name = evil}).add_label({0, 0, 1.2}, evil);
  cn::save_html(strings, folder + "/strings.html", {.title = evil});

  cn::save_html(cn::scene(), folder + "/empty.html");
  for (const double size : {1e30, 1e-30}) {
    cn::trimesh scaled = m;
    for (const auto v : cn::verts(scaled)) cn::set_point(scaled, v, cn::point(scaled, v) * size);
    auto x = cn::make_vert_map<double>(scaled, 0.0);
    for (const auto v : cn::verts(scaled)) x[v] = cn::point(scaled, v).x;
    cn::scene s;
    s.add(scaled, {.field = x, .inspect = true});
    cn::save_html(s, folder + (size > 1 ? "/large.html" : "/small.html"));
  }
  cn::scene one;
  one.add(cn::make_grid<cn::hexmesh>({.cells = {1, 1, 1}}), {.edges = true, .inspect = true});
  cn::save_html(one, folder + "/one.html");

  auto u = cn::make_vert_map<double>(m, 1.0);
  for (const auto v : cn::verts(m)) u[v] = cn::point(m, v).x < 0 ? std::numeric_limits<double>::quiet_NaN() : cn::point(m, v).y > 0.5 ? std::numeric_limits<double>::infinity() : 1.0;
  cn::scene no_values;
  no_values.add(m, {.field = u, .map = cn::colormap::viridis, .inspect = true});
  no_values.add_points({cn::vec3{2, 0, 0}}, {.radius = 0.1});
  cn::save_html(no_values, folder + "/no_values.html", {.theme = cn::page_theme::dark});
}

/// A page of a textured mesh, and which of red, green and blue is strongest at each pixel of its picture.
template<class M, class Coordinates>
void write_textured(const M& m, const cn::texture& texture, const Coordinates& at, bool inspect, const std::string& path) {
  cn::scene s;
  s.add(m, {.color = cn::srgb(0.2f, 0.2f, 0.9f), .texture = texture, .texture_coordinates = at, .inspect = inspect});
  const cn::camera from = cn::frame(s.drawables(), static_cast<double>(width) / height, {.towards = {0.3, 0.4, 1}});
  cn::save_html(s, path + ".html", {.camera = from});
  const cn::image picture = cn::render(s, {.width = width, .height = height, .camera = from, .samples = 1, .occlusion_rays = 0, .ground = false});
  auto out = fmt::output_file(path + ".txt");
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const cn::rgb c = picture(x, y);
      out.print("{}", c.r > 2 * c.g && c.r > 2 * c.b ? 'r' : c.g > 2 * c.r && c.g > 2 * c.b ? 'g' : c.b > 2 * c.r && c.b > 2 * c.g ? 'b' : '.');
    }
    out.print("\n");
  }
}

void write_textures(const std::string& folder) {
  const cn::rgb red = cn::srgb(0.9f, 0.1f, 0.1f), green = cn::srgb(0.1f, 0.8f, 0.1f);
  cn::image picture(8, 8, green);
  picture.add_opacity();
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 8; ++j) picture(i, j) = red, picture.opacity(j, 7 - i) = 0;  // red to the left, and clear below
  const auto square = cn::make_grid<cn::quadmesh>({.cells = {6, 6}});
  auto at_verts = cn::make_vert_map<std::array<double, 2>>(square);
  for (const auto v : cn::verts(square)) at_verts[v] = {2 * cn::point(square, v).x, 2 * cn::point(square, v).y};
  auto at_corners = cn::make_corner_map<std::array<double, 2>>(square);
  for (const auto p : cn::polys(square))
    for (std::uint32_t k = 0; k < 4; ++k) at_corners[{p, k}] = {static_cast<double>(k == 1 || k == 2), static_cast<double>(k > 1)};
  auto cubes = cn::make_grid<cn::hexmesh>({.cells = {3, 3, 3}});
  auto uv = cn::corner_property<std::array<double, 2>>(cubes, "uv");
  for (const auto p : cn::polys(cubes))
    for (std::uint32_t k = 0; k < 8; ++k) {
      const cn::vec3 x = cn::point(cubes, cn::vert_at(cubes, {p, k}));
      uv[{p, k}] = {x.x + x.z + 0.1 * static_cast<double>(p.raw() % 2), x.y};
    }
  write_textured(square, cn::texture::checkerboard(3, red, green), at_verts, true, folder + "/texture_squares");
  write_textured(square, cn::texture::isolines(4, red, 8), at_verts, false, folder + "/texture_lines");
  write_textured(square, cn::texture::from(picture), at_corners, false, folder + "/texture_picture");
  write_textured(square, cn::texture::from(picture, cn::texture::outside::clamp), at_verts, true, folder + "/texture_clamped");
  write_textured(cubes, cn::texture::checkerboard(4, red, green), uv, true, folder + "/texture_volume");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string folder = argv[1];
  auto out = fmt::output_file(folder + "/expected.json");
  out.print("[\n");
  write_kind(cn::make_torus<cn::trimesh>({.cells = {24, 12}}), "trimesh", folder, out);
  write_kind(cn::make_torus<cn::quadmesh>({.cells = {24, 12}}), "quadmesh", folder, out);
  write_kind(cn::dual_mesh(cn::make_torus<cn::trimesh>({.cells = {24, 12}})), "polygonmesh", folder, out);
  write_kind(cn::make_grid<cn::tetmesh>({.cells = {5, 5, 5}}), "tetmesh", folder, out);
  write_kind(cn::make_torus<cn::hexmesh>({.cells = {16, 8}}), "hexmesh", folder, out);
  const cn::box unit{{0, 0, 0}, {1, 1, 1}};
  write_kind(cn::voronoi_polyhedra(cn::random_points(200, unit), unit, {.relax = 2}), "polyhedralmesh", folder, out);
  out.print("  null]\n");
  write_odd(folder);
  write_textures(folder);
}
