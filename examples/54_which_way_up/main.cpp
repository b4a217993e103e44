// Which way up to print a chair: what overhangs, how much support it needs, and the direction in which printing it is cheapest. The picture shows supports.
#include <concino/convert.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>
#include <concino/print.hpp>
#include <concino/render.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

namespace cn = concino;

/// Blocks of a grid: four legs, a seat, and a back that leans on nothing.
cn::hexmesh make_chair() {
  const auto blocks = cn::make_grid<cn::hexmesh>({.cells = {10, 10, 20}, .max = {10, 10, 20}});
  return cn::convert<cn::hexmesh>(cn::submesh(blocks, [&](cn::poly_id p) {
    const cn::vec3 x = cn::centroid(blocks, p);
    const bool leg = (x.x < 2 || x.x > 8) && (x.y < 2 || x.y > 8), seat = x.z > 8 && x.z < 10, back = x.z > 8 && x.y > 8;
    return (leg && x.z < 9) || seat || back;
  }));
}

/// The part with its overhangs in orange, on columns that support them.
cn::image draw(const cn::hexmesh& m, const cn::overhang_report<cn::hexmesh>& o, const cn::vec3& up) {
  auto color = cn::make_face_map<cn::rgb>(m, cn::srgb(0.75f, 0.78f, 0.82f));
  std::vector<std::vector<cn::vec3>> columns;
  const auto tree = cn::bounding_tree(m);
  for (const auto f : o.polys) {
    color[f] = cn::srgb(0.95f, 0.5f, 0.15f);
    const cn::vec3 top = cn::centroid(m, f), below = top - 1e-6 * up;
    const auto hit = tree.ray(below, -up);
    columns.push_back({top, hit ? hit.point : top - (cn::dot(top, up) - o.plate) * up});
  }
  cn::scene s;
  s.add(m, {.colors = color, .edges = true, .edge_width = 0.6});
  if (!columns.empty()) s.add_lines(columns, {.radius = 0.2, .color = cn::srgb(0.25f, 0.45f, 0.7f)});
  const cn::vec3 front = up.z != 0 ? cn::vec3{0.7, -1, 0} : cn::vec3{1, 0, -0.6};
  return cn::render(s, {.width = 220, .height = 250, .camera = cn::view_options{.towards = front - 0.15 * up, .up = up}, .samples = 4, .ground = false});
}

int main(int argc, char** argv) {
  const cn::hexmesh chair = make_chair();
  const auto best = cn::best_build_direction(chair);

  std::vector<cn::image> pictures;
  std::vector<std::string> captions;
  for (const auto& [name, up] : {std::pair("upright", cn::vec3{0, 0, 1}), std::pair("upside down", cn::vec3{0, 0, -1}), std::pair("the cheapest", best.direction)}) {
    const auto o = cn::overhangs(chair, {.direction = up, .max_angle_deg = 45});
    fmt::print("{:<13} {:3} faces overhang, area {:5.1f}; supports of volume {:6.1f}, which touch an area of {:5.1f}\n", name, o.polys.size(), o.area, o.support_volume,
               o.contact_area);
    if (argc > 1) pictures.push_back(draw(chair, o, up));
    captions.push_back(fmt::format("{}: {:.0f}", name, o.support_volume));
  }
  fmt::print("the cheapest direction is ({:.2f}, {:.2f}, {:.2f}), with {:.1f} of the area on the plate and {:.1f} high\n", best.direction.x + 0.0, best.direction.y + 0.0,
             best.direction.z + 0.0, best.plate_area, best.height);

  // It was chosen among others and those in which a face of the convex hull lies on the plate.
  std::vector<cn::vec3> points;
  for (const auto v : cn::verts(chair)) points.push_back(cn::point(chair, v));
  const cn::polygonmesh hull(cn::convex_hull(points).surface);
  fmt::print("{} points have a convex hull of {} corners and {} faces\n", points.size(), cn::num_verts(hull), cn::num_polys(hull));

  // Is anything too thin, or too narrow?
  const auto walls = cn::thin_walls(chair, 3);
  const auto thinnest = std::min_element(walls.begin(), walls.end(), [](const auto& a, const auto& b) { return a.thickness < b.thickness; });
  fmt::print("{} faces are in front of walls thinner than 3, the thinnest is {:.1f}; {} are in front of gaps narrower than 3\n", walls.size(), thinnest->thickness,
             cn::narrow_gaps(chair, 3).size());
  const auto heights = cn::height_map(chair, {.resolution = 10});
  fmt::print("heights along the middle, from the front to the back:");
  for (std::size_t j = 0; j < heights.rows; ++j) fmt::print(" {:.0f}", heights(5, j));
  fmt::print("\n");

  if (argc > 1) cn::save_png(cn::make_sheet(pictures, {.columns = 3, .captions = captions}), argv[1]);
}
