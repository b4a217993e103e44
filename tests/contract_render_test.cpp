// A picture of a mesh of any kind, with its field, lines, arrows and points, by the calls that the library promises.
#include <concino/operators.hpp>
#include <concino/render.hpp>

#include <support/kinds.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

namespace cn = concino;

TEST_CASE_TEMPLATE("contract: pictures", M, cn::polygonmesh, cn::hexmesh) {
  const cn::testing::temporary_folder folder;
  const M m = cn::testing::grid<M>(3);
  auto u = cn::make_vert_map<double>(m, 0.0);
  for (auto v : cn::verts(m)) u[v] = cn::point(m, v)[0];
  const auto g = cn::gradient(m, u);
  const std::vector<std::vector<cn::vec3>> lines = {{{0, 0, 1.1}, {1, 1, 1.1}}};
  const std::vector<cn::vec3> points = {{0, 0, 1.1}, {1, 1, 1.1}};

  cn::scene s;
  s.add(m, {.field = u, .map = cn::colormap::viridis, .isobands = 20, .edges = true, .visible = cn::below('x', 0.3)});
  s.add_lines(lines, {.radius = 0.004, .color = {1, 0, 0}});
  s.add_arrows(m, g, {.scale = 0.5});
  s.add_points(points);
  cn::save_png(s, folder / "a.png", {.width = 64, .height = 48, .camera = cn::camera::isometric, .occlusion_rays = 1, .legend = {.title = "T", .unit = "K"}});
  CHECK(folder.num_files() == 1);

  auto ao = cn::ambient_occlusion(m, {.rays = 16});
  for (auto p : cn::polys(m)) CHECK((ao[p] >= 0 && ao[p] <= 1));
  if constexpr (cn::VolumeMesh<M>) {
    auto shown = cn::visible_faces(m, cn::below('x', 0.3));
    CHECK(!shown.empty());
  }
}
