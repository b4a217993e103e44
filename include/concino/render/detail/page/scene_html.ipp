// Bodies of scene_html.hpp: scenes as pages for web browsers.
#pragma once

#include <concino/io/atomic_file.hpp>
#include <concino/render/detail/page/page_appearance.hpp>
#include <concino/render/detail/page/page_text.hpp>
#include <concino/render/detail/page/page_writer.hpp>
#include <concino/render/scene_html.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace concino {

namespace detail {

/// The middle and half the diagonal of all points: the page works in these units, in which single precision is enough.
struct page_units {
  box bounds;
  vec3 center;
  double radius = 1;

  explicit page_units(const scene& s) {
    for (const drawable& d : s.drawables()) {
      for (const vec3& p : d.points) bounds.add(p);
      if (d.inspected)
        for (const vec3& p : d.inspected->points)
          if (is_finite(p)) bounds.add(p);
    }
    if (bounds.is_empty()) bounds = {{-1, -1, -1}, {1, 1, 1}};
    center = bounds.centre();
    const vec3 half = bounds.max / 2 - bounds.min / 2;
    const double largest = std::max({half.x, half.y, half.z});
    if (largest > 0) radius = largest * norm(half / largest);  // squares of lengths may overflow
  }
  vec3 operator()(const vec3& p) const { return (p / 2 - center / 2) / radius * 2; }
};

inline std::vector<double> coordinates_of(std::span<const vec3> points) {
  std::vector<double> numbers;
  numbers.reserve(3 * points.size());
  for (const vec3& p : points) numbers.insert(numbers.end(), {p.x, p.y, p.z});
  return numbers;
}

inline void write_inspected(page_writer& out, const inspected_mesh& m) {
  out.begin("mesh", '{');
  out.add("volume", m.is_volume);
  out.add("crease", m.crease_angle);
  out.begin("arrays", '{');
  out.add_numbers("points", coordinates_of(m.points));
  out.add_indices("edges", m.edge_verts);
  out.add_indices("polygon_starts", m.polygon_offsets);
  out.add_indices("corners", m.polygon_verts);
  out.add_indices("triangles", m.triangles);
  out.add_numbers("centroids", coordinates_of(m.centroids));
  out.add_bytes("shown", m.visible);
  out.add_bytes("laid_bare", m.exposed);
  if (m.is_volume) {
    out.add_indices("poly_starts", m.poly_offsets);
    out.add_indices("poly_faces", m.poly_faces);
    out.add_indices("corner_starts", m.corner_offsets);
    out.add_indices("corner_verts", m.corner_verts);
  }
  out.end('}');
  out.begin("values", '[');
  for (const inspected_values& v : m.values) {
    out.begin('{');
    out.add("name", v.name);
    out.add("at", to_string(v.at));
    out.add("width", static_cast<double>(v.width));
    if (v.texts.empty()) {
      out.add_numbers("numbers", v.numbers);
    } else {
      out.begin("texts", '[');
      for (const std::string& text : v.texts) out.add_text(text);
      out.end(']');
    }
    out.end('}');
  }
  out.end(']');
  out.end('}');
  if (m.has_field) out.add("field", 0.0);
  if (m.colors.empty()) return;
  out.begin("colors", '{');
  out.add("at", m.colors_at == element_kind::face ? "element" : to_string(m.colors_at));
  out.add_bytes("rgb", bytes_of_colors(m.colors));
  out.end('}');
}

inline std::string_view name_of_place(value_place at) {
  return at == value_place::points ? "point" : at == value_place::polygons ? "polygon" : "corner";
}

inline void write_polygons(page_writer& out, const drawable& d, const page_units& unit) {
  std::vector<float> points;
  points.reserve(3 * d.points.size());
  for (const vec3& p : d.points)
    for (std::size_t k = 0; k < 3; ++k) points.push_back(static_cast<float>(unit(p)[k]));
  std::vector<std::int8_t> normals;
  normals.reserve(3 * d.normals.size());
  for (const auto& n : d.normals)
    for (const float x : n) normals.push_back(static_cast<std::int8_t>(std::lround(127 * std::clamp(x, -1.0f, 1.0f))));
  std::vector<std::uint32_t> triangles;
  if (d.triangles.size() * 3 != d.corners.size())
    for (const auto& t : d.triangles) triangles.insert(triangles.end(), t.begin(), t.end());
  out.begin("arrays", '{');
  out.add_floats("points", points);
  out.add_indices("starts", d.offsets);
  out.add_indices("corners", d.corners);
  out.add_indices("triangles", triangles);  // none: each polygon is one
  out.add_signed("normals", normals);
  out.add_bytes("exposed", d.exposed);
  out.end('}');
  if (!d.values.empty()) {
    out.begin("values", '{');
    out.add("name", d.look.labels ? "labels" : "field");
    out.add("at", name_of_place(d.values_at));
    out.add_numbers("numbers", d.values);
    out.end('}');
  }
  if (!d.edge_values.empty()) out.add_numbers("edge_values", d.edge_values);
  if (d.colors.empty()) return;
  out.begin("colors", '{');
  out.add("at", name_of_place(d.colors_at));
  out.add_bytes("rgb", bytes_of_colors(d.colors));
  out.end('}');
}

inline void write_texture(page_writer& out, const drawable& d) {
  if (!d.look.texture || d.texture_coordinates.empty()) return;
  out.begin("texture", '{');
  texture_page::write(out, d.look.texture);
  if (d.inspected) {
    out.add("values", static_cast<double>(d.inspected->values.size() - 1));
  } else {
    std::vector<float> coordinates;
    for (const auto& t : d.texture_coordinates) coordinates.insert(coordinates.end(), t.begin(), t.end());
    out.add_floats("coordinates", coordinates);  // by corner
  }
  out.end('}');
}

inline void write_things(page_writer& out, const scene& s, const page_units& unit) {
  out.begin("objects", '[');
  for (const drawable& d : s.drawables()) {
    out.begin('{');
    out.add("name", d.name);
    if (d.inspected) write_inspected(out, *d.inspected);
    else write_polygons(out, d, unit);
    write_texture(out, d);
    write_material(out, d.look.material);
    write_look(out, d.look, !d.values.empty() || !d.edge_values.empty());
    out.end('}');
  }
  out.end(']');
  out.begin("labels", '[');
  for (const point_label& l : s.labels()) {
    out.begin('{');
    out.add("at", l.point);
    out.add("text", l.text);
    out.end('}');
  }
  out.end(']');
}

inline void write_camera(page_writer& out, const scene& s, const html_options& options) {
  const camera c = options.camera.of(s.drawables(), 4.0 / 3, options.up);
  out.begin("camera", '{');
  out.add("fixed", options.camera.has_camera());
  out.add("eye", c.eye);
  out.add("right", c.right);
  out.add("up", c.up);
  out.add("back", c.back);
  out.add("half_height", c.half_height);
  out.add("parallel", c.parallel);
  out.end('}');
}

}  // namespace detail

CONCINO_INLINE void save_html(const scene& s, const std::string& path, const html_options& options) {
  const double length = norm(options.up);
  if (!(length > 0) || !std::isfinite(length)) throw invalid_argument("save_html: up must be finite and not 0");
  const detail::page_units unit(s);
  atomic_file file(path, {.sync = options.sync});
  text_sink page(file.descriptor(), path);
  page << detail::page_start;
  detail::write_html_text(page, options.title.empty() ? "Scene" : options.title);
  page << detail::page_middle;
  detail::page_writer out(page);
  out.begin('{');
  out.add("title", options.title);
  out.add("theme", options.theme == page_theme::dark    ? "dark"
                   : options.theme == page_theme::light ? "light"
                                                        : "system");
  out.add("up", options.up / length);
  out.add("center", unit.center);
  out.add("radius", unit.radius);
  out.add("low", unit.bounds.min);
  out.add("high", unit.bounds.max);
  detail::write_camera(out, s, options);
  detail::write_maps(out);
  detail::write_things(out, s, unit);
  out.end('}');
  out.finish();
  for (const std::string_view part : detail::page_end) page << part;
  page.flush();
  file.commit();
}

}  // namespace concino
