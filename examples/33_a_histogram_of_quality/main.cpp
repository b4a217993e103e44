// A histogram of what a solver will not like: how good the cells of a mesh are, and where the bad ones are. Each metric knows for which shapes it is defined,
// what is acceptable and which value is worse. The calls are the same for triangles, hexes and polyhedra, and on meshes of other libraries.
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>
#include <concino/quality.hpp>

#include <fmt/core.h>

#include <string>

namespace cn = concino;
using cn::metric;

/// Prints a histogram, and the worst poly.
template<cn::EmbeddedMesh M>
void report(const char* title, const M& m, metric what, const cn::histogram_options& options) {
  const auto h = cn::histogram(m, what, options);
  const auto w = cn::worst(m, what);
  fmt::print("{}: {} of {} polys\n", title, cn::name_of(what), cn::num_polys(m));
  for (std::size_t i = 0; i < h.counts.size(); ++i)
    fmt::print("  from {:5.2f} |{:<40}| {}\n", h.start_of(i), std::string(40 * h.counts[i] / cn::num_polys(m), '*'), h.counts[i]);
  const auto at = cn::centroid(m, w.poly);
  fmt::print("  {} below, {} above; {} are not acceptable; the worst has {:.3f}, at ({:.2f}, {:.2f}, {:.2f})\n", h.below, h.above, h.unacceptable, w.value, at.x,
             at.y, at.z);
}

int main() {
  // Tets whose points were moved at random. Gradients are large where dihedral angles are small.
  auto tets = cn::make_grid<cn::tetmesh>({.cells = {6, 6, 6}});
  cn::jitter(tets, 0.3);
  report("tets", tets, metric::minimum_angle, {.bins = 6, .low = 0, .high = 60});

  // 30 times, move the inner verts of the worst tet to the means of their neighbours, and look again.
  for (int i = 0; i < 30; ++i)
    for (auto v : cn::adj_p2v(tets, cn::worst(tets, metric::mean_ratio).poly)) {
      cn::vec3 mean;
      for (auto w : cn::adj_v2v(tets, v)) mean += cn::point(tets, w) / static_cast<double>(cn::num_elements(cn::adj_v2v(tets, v)));
      if (!cn::is_boundary(tets, v)) cn::set_point(tets, v, mean);
    }
  report("tets, after 30 moves", tets, metric::minimum_angle, {.bins = 6, .low = 0, .high = 60});

  // A hex that is inside out stops most solvers. Its scaled Jacobian is negative.
  auto hexes = cn::make_grid<cn::hexmesh>({.cells = {4, 4, 4}});
  cn::set_point(hexes, cn::vert_id{62}, cn::vec3{0.95, 0.5, 0.5});
  report("hexes", hexes, metric::scaled_jacobian, {.bins = 5, .low = -1, .high = 1});

  // Polyhedra of any shape: a polyhedron is star-shaped if all of it is visible from a point inside, as many discretisations need.
  const auto grid = cn::make_grid<cn::tetmesh>({.cells = {4, 4, 4}});
  const auto cells = cn::agglomerate(grid, cn::random_labels(grid, 6));
  report("polyhedra", cells, metric::star_shapedness, {.bins = 5, .low = 0, .high = 1});

  // One number per poly is a map like any other: here, to find the polys that are not acceptable.
  const auto quads = cn::make_torus<cn::quadmesh>();
  const auto ratio = cn::quality(quads, metric::max_edge_ratio);
  std::size_t narrow = 0;
  for (auto p : cn::polys(quads)) narrow += !cn::is_acceptable(metric::max_edge_ratio, cn::poly_shape::quad, ratio[p]);
  const double limit = cn::limits_of(metric::max_edge_ratio, cn::poly_shape::quad).acceptable.high;
  fmt::print("a torus: {} of {} quads have a {} above {}\n", narrow, cn::num_polys(quads), cn::name_of(metric::max_edge_ratio), limit);
}
