// A look inside a mesh of hexes: criteria say which polys a picture shows. What they expose has a colour of its own. At last a cut that goes through cells.
// The pictures are small and fast; with the name of a file they are large enough to see all hexes.
#include <concino/generate.hpp>
#include <concino/level_sets.hpp>
#include <concino/mesh.hpp>
#include <concino/quality.hpp>
#include <concino/render.hpp>

#include <fmt/core.h>

#include <string>
#include <utility>
#include <vector>

namespace cn = concino;

std::size_t width = 80;  // of each picture, in pixels
std::vector<cn::image> pictures;
std::vector<std::string> captions;

void draw(const char* caption, const cn::scene& s) {
  pictures.push_back(cn::render(s, {.width = width, .height = width * 7 / 8, .camera = cn::camera::isometric, .samples = 2, .occlusion_rays = 16}));
  captions.push_back(caption);
}

/// Counts what a criterion leaves, and draws it.
void show(const char* caption, const cn::hexmesh& m, const cn::poly_criterion<cn::hexmesh>& criterion, const cn::any_field<cn::hexmesh>& field = {}) {
  const auto visible = cn::visible_polys(m, criterion);
  std::size_t count = 0;
  for (auto p : cn::polys(m)) count += visible[p];
  fmt::print("{:<17} {:3} of {} hexes, bounded by {:3} faces, {:3} of them inside the mesh\n", caption, count, cn::num_polys(m), cn::visible_faces(m, criterion).size(),
             cn::exposed_facets(m, criterion).size());
  cn::scene s;
  s.add(m, {.field = field, .edges = true, .visible = criterion});
  if (field) s.add(m, {.opacity = 0.15});  // the whole mesh around them, transparent
  draw(caption, s);
}

int main(int argc, char** argv) {
  const std::string path = argc > 1 ? argv[1] : "inside.png";
  if (argc > 1) width = 170;
  auto m = cn::make_sphere<cn::hexmesh>({.cells = 6});
  cn::jitter(m, 0.15);
  const auto quality = cn::quality(m, cn::metric::scaled_jacobian);
  auto material = cn::make_poly_map<int>(m);
  for (auto p : cn::polys(m)) material[p] = cn::norm(cn::centroid(m, p)) < 0.6 ? 1 : 2;

  // Criteria are combined by &&, || and !. Those that refer to a map, such as `material`, need it until they are used.
  show("below a plane", m, cn::below('z', 0.1));
  show("a corner less", m, cn::below('z', 0.1) || cn::below(cn::plane{{1, 1, 0}, 0}));
  show("a material whole", m, cn::below('z', 0.1) || cn::labeled(material, {1}));
  show("two layers less", m, cn::peeled(2));
  show("the worst shapes", m, cn::at_most(quality, 0.6), quality);

  // clip cuts through the hexes, and knows the faces on the cut.
  const auto half = cn::clip(m, cn::plane{{0, 0, -1}, -0.1});
  fmt::print("clip: {} polyhedra, {} faces on the cut\n", cn::num_polys(half.mesh), half.cut_faces.size());
  draw("an exact cut", cn::scene().add(half.mesh, {.edges = true, .exposed = half.cut_faces}));

  cn::save_png(cn::make_sheet(pictures, {.columns = 3, .captions = captions}), path);
}
