#include <concino/io/flat_triangles.hpp>

#include <concino/io/format.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh/polygonmesh.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// A format of your own, with triangles only.
struct soup_format {
  static constexpr std::string_view name = "soup";
  static constexpr std::string_view extensions[] = {".soup"};
  static constexpr bool holds_surfaces = true, holds_volumes = false, is_write_only = true;
  static void write(write_context& c, flat_mesh& m) {
    flat_triangles triangles(c, m, ".soup", ".ply");
    for (std::size_t p = 0; p < m.num_polys; ++p)
      for (const std::array<vert_id, 3>& t : triangles(p)) c.out << t[0].raw() << ' ' << t[1].raw() << ' ' << t[2].raw() << '\n';
    triangles.report_cut(c.report);
  }
};

}  // namespace

TEST_CASE("flat_triangles: triangles are taken as they are, other polygons are cut if that is allowed") {
  const polygonmesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 2, 0}}, {{2, 4, 3}, {0, 1, 2, 3}});
  save_report r;
  const std::string text = save_text(m, soup_format{}, {.report = &r, .as_triangles = true});
  CHECK(text.starts_with("2 4 3\n"));
  CHECK(std::count(text.begin(), text.end(), '\n') == 3);
  CHECK(r.lost == std::vector<std::string>{"1 polygons were cut into triangles"});
  CHECK_THROWS_WITH_AS(save_text(m, soup_format{}), "text: .soup cannot hold poly 1 of 4 corners, unless options.as_triangles is set; save it as .ply", unsupported);
  CHECK(save_text(polygonmesh(), soup_format{}).empty());
  // a concave polygon keeps its orientation, and none of its triangles is inverted
  const polygonmesh arrow({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}, {{0, 1, 2, 3}});
  CHECK(save_text(arrow, soup_format{}, {.as_triangles = true}).find("2 ") != std::string::npos);
}

TEST_CASE("flat_triangles: the boundary of a volume") {
  save_report r;
  const std::string text = save_text(grid<hexmesh>(1), soup_format{}, {.report = &r, .as_triangles = true, .as_boundary = true});
  CHECK(std::count(text.begin(), text.end(), '\n') == 12);
  CHECK(r.lost.size() == 2);
}
