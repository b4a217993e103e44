#include "call.hpp"

#include <concino/render.hpp>
#include <concino/render/ambient_occlusion.hpp>
#include <concino/render/axes.hpp>
#include <concino/render/best_view.hpp>
#include <concino/render/label_colors.hpp>
#include <concino/render/labels.hpp>
#include <concino/render/legend.hpp>
#include <concino/render/polygon_weights.hpp>
#include <concino/render/sheet.hpp>
#include <concino/render/smooth_normals.hpp>
#include <concino/render/text.hpp>

namespace {

const cn::camera front = cn::perspective_camera({0, 0, 5}, {0, 0, 0});

void call_colors() {
  const cn::rgb white{1, 1, 1};
  call("mix", [&] { cn::mix(white, white, 0.5f); });
  call("srgb_from_linear", [] { cn::srgb_from_linear(0.5f); });
  call("linear_from_srgb", [] { cn::linear_from_srgb(0.5f); });
  call("srgb", [] { cn::srgb(0.5f, 0.5f, 0.5f); });
  call("srgb_bytes", [&] { cn::srgb_bytes(white); });
  call("opacity_byte", [] { cn::opacity_byte(0.5f); });
  call("lightness", [&] { cn::lightness(white); });
  call("label_color", [] { cn::label_color(3); });
  call("label_of", [] { cn::label_of(3.0); });
}

void call_images() {
  cn::image picture(32, 24);
  const std::vector<cn::vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<std::uint32_t> offsets{0, 4}, corners{0, 1, 2, 3};
  call("perspective_camera", [] { cn::perspective_camera({0, 0, 5}, {0, 0, 0}); });
  call("orthographic_camera", [] { cn::orthographic_camera({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 2); });
  call("options_of", [] { cn::options_of(cn::camera::isometric); });
  call("draw_axes", [&] { cn::draw_axes(picture, front, {{0, 0, 0}, {1, 1, 1}}); });
  call("draw_labels", [&] { cn::draw_labels(picture, front, std::vector<cn::point_label>{{{0, 0, 0}, "a"}}); });
  const cn::appearance look;
  call("draw_legend", [&] { cn::draw_legend(picture, look); });
  call("legend_box", [&] { cn::legend_box(32, 24, look); });
  call("draw_title", [&] { cn::draw_title(picture, "a"); });
  call("draw_text", [&] { cn::draw_text(picture, "a", {1, 1}); });
  call("text_box", [] { cn::text_box("a", {1, 1}); });
  call("text_width", [] { cn::text_width("a", 8); });
  call("srgb_bytes", [&] { cn::srgb_bytes(picture); });
  call("png_bytes", [&] { cn::png_bytes(picture); });
  call("save_png", [&] { cn::save_png(picture, "picture.png"); });
  call("make_sheet", [&] { cn::make_sheet(std::vector{picture, picture}); });
  call("polygon_weights", [&] {
    std::vector<double> weights(4);
    cn::polygon_weights(square, {0, 0, 1}, {0.5, 0.5, 0}, weights);
  });
  call("smooth_normals", [&] { cn::smooth_normals({square, offsets, corners}, 0.5); });
}

void call_criteria() {
  const auto on_polys = [](const auto& m) { return cn::make_poly_map<int>(m); };
  call("below", [](auto& m) {
    cn::visible_polys(m, cn::below('x', 0.5));
    cn::visible_polys(m, cn::below(cn::plane{{1, 0, 0}, 0.5}));
  }, all);
  call("above", [](auto& m) {
    cn::visible_polys(m, cn::above('x', 0.5));
    cn::visible_polys(m, cn::above(cn::plane{{1, 0, 0}, 0.5}));
  }, all);
  call("between", [](auto& m) { cn::visible_polys(m, cn::between('x', 0.2, 0.5)); }, all);
  call("below_fraction", [](auto& m) { cn::visible_polys(m, cn::below_fraction('x', 0.5)); }, all);
  call("above_fraction", [](auto& m) { cn::visible_polys(m, cn::above_fraction('x', 0.5)); }, all);
  call("peeled", [](auto& m) { cn::visible_polys(m, cn::peeled(1)); }, all);
  call("labeled", [&](auto& m) { cn::visible_polys(m, cn::labeled(on_polys(m), {0, 1})); }, all);
  call("at_most", [&](auto& m) { cn::visible_polys(m, cn::at_most(on_polys(m), 1)); }, all);
  call("at_least", [&](auto& m) { cn::visible_polys(m, cn::at_least(on_polys(m), 1)); }, all);
  call("selected", [&](auto& m) { cn::visible_polys(m, cn::selected(on_polys(m))); }, all);
  call("where", [](auto& m) { cn::visible_polys(m, cn::where([](auto) { return true; })); }, all);
  call("visible_polys", [](auto& m) { cn::visible_polys(m, cn::below('x', 0.5)); }, all);
  call("visible_facets", [](auto& m) { cn::visible_facets(m, cn::below('x', 0.5)); }, all);
  call("visible_faces", [](auto& m) { cn::visible_faces(m, cn::below('x', 0.5)); }, volumes);
  call("exposed_facets", [](auto& m) { cn::exposed_facets(m, cn::below('x', 0.5)); }, all);
}

void call_drawables() {
  call("make_drawable", [](auto& m) { cn::make_drawable(m); }, all);
  call("make_arrows", [](auto& m) {
    cn::make_arrows(m, cn::make_poly_map<cn::vec3>(m, {1, 0, 0}));
    cn::make_arrows(m, cn::make_vert_map<cn::vec3>(m, {1, 0, 0}));
  }, all);
  call("make_balls", [](auto& m) { cn::make_balls(m); }, all);
  call("make_balls", [] { cn::make_balls({{0, 0, 0}}); });
  call("make_graph_tubes", [](auto& m) {
    cn::make_graph_tubes(m);
    cn::make_graph_tubes(m, [](auto) { return true; });
  }, all);
  call("make_tubes", [] { cn::make_tubes({{0, 0, 0}, {1, 0, 0}}); });
  call("make_tubes", [](auto& m) {
    const auto [a, b] = cn::end_verts(m, first(cn::edges(m)));
    cn::make_tubes(m, std::vector{a, b});
  }, all);
  call("ambient_occlusion", [](auto& m) { cn::ambient_occlusion(m); }, all);
  call("ambient_occlusion_at_verts", [](auto& m) { cn::ambient_occlusion_at_verts(m); }, all);
}

void call_scenes() {
  const std::vector drawn{cn::make_drawable(cn::make_grid<cn::trimesh>({.cells = {2, 2, 2}}))};
  cn::scene s;
  s.add(drawn.front());
  const cn::render_options options{.width = 16, .height = 12, .samples = 1, .occlusion_rays = 1};
  call("frame", [&] { cn::frame(drawn, 1.0); });
  call("best_view", [&] { cn::best_view(drawn, 1.0); });
  call("render", [&] { cn::render(s, options); });
  call("save_png", [&] { cn::save_png(s, "scene.png", options); });
  call("save_html", [&] { cn::save_html(s, "scene.html"); });
  call("save_turntable", [&] { cn::save_turntable(s, "turntable_%.png", 2, options); });
}

}  // namespace

void call_render() {
  call_colors();
  call_images();
  call_criteria();
  call_drawables();
  call_scenes();
}
