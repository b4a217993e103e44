// Write an algorithm once for surfaces and volumes, with facets: the edges of a surface, the faces of a volume. The two algorithms below name no dimension and
// no mesh type. They run on meshes of the library, on arrays of other programs, and on non-manifold meshes.
#include <concino/adapters/span.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>

#include <fmt/core.h>

#include <vector>

namespace cn = concino;

/// The length of the boundary of a surface, or the area of the boundary of a volume.
template<cn::EmbeddedMesh M>
double boundary_measure(const M& m) {
  double sum = 0;
  for (auto x : cn::facets(m))
    if (cn::is_boundary(m, x)) sum += cn::measure(m, x);
  return sum;
}

/// How much a field with a value per poly jumps between poly p and its neighbours: squared differences times the measures of the facets.
template<cn::EmbeddedMesh M, class Field>
double jump_energy(const M& m, const Field& u, cn::poly_t<M> p) {
  double sum = 0;
  for (auto x : cn::adj_p2facet(m, p))
    for (auto q : cn::other_polys(m, p, x)) sum += cn::measure(m, x) * (u[p] - u[q]) * (u[p] - u[q]);
  return sum;
}

/// Prints the measure of the boundary, and where a field jumps that is 0 on the left and 2 on the right of x = 1/2.
template<cn::EmbeddedMesh M>
void report(const char* name, const M& m) {
  auto u = cn::make_poly_map<double>(m);
  for (auto p : cn::polys(m)) u[p] = cn::centroid(m, p).x < 0.5 ? 0 : 2;
  double total = 0;
  int rough = 0, at_boundary = 0;
  for (auto p : cn::polys(m)) {
    const double energy = jump_energy(m, u, p);
    total += energy;
    rough += energy > 0;
    at_boundary += cn::is_boundary(m, p);
  }
  fmt::print("{:<17} {:>4} facets, boundary {:.4f}; {:>3} of {:>3} polys at it, {:>2} at the jump, energy {:.4f}\n", name, cn::num_facets(m),
             boundary_measure(m), at_boundary, cn::num_polys(m), rough, total);
}

int main() {
  // A square and a cube of side 1: the boundaries measure 4 and 6. The field jumps by 2 at a line of length 1 or at a square of area 1, and both polys at a
  // facet count: the energy is 8. The polygons have no facets along the line x = 1/2, so their jump follows a longer line.
  report("quads", cn::make_grid<cn::quadmesh>({.cells = {4, 4, 1}}));
  report("polygons", cn::make_grid<cn::polygonmesh>({.cells = {4, 4, 1}}));
  report("tets", cn::make_grid<cn::tetmesh>({.cells = {4, 4, 4}}));
  report("hexes", cn::make_grid<cn::hexmesh>({.cells = {4, 4, 4}}));

  // Arrays of another program: three triangles that meet in one edge, and a cube of five tets.
  const std::vector<double> book = {0, 0, 0, 0, 0, 1, 3, 0, 0, 0, 1, 0, -1, 0, 0};
  const std::vector<int> pages = {0, 2, 1, 0, 3, 1, 0, 4, 1};
  report("an open book", cn::view_tri(book, pages));
  const std::vector<double> corners = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
  const std::vector<int> cells = {0, 1, 3, 4, 2, 3, 1, 6, 5, 4, 6, 1, 7, 6, 4, 3, 1, 3, 4, 6};
  report("a cube of tets", cn::view_tet(corners, cells));
}
