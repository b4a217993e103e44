// Compute gradient and divergence of a known function, on polygons in the plane and on hexahedra with non-planar faces. The same code works for both, and
// for any other mesh: polys may have any shape.
#include <concino/generate.hpp>
#include <concino/mesh.hpp>
#include <concino/operators.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_png.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace cn = concino;

double u_at(const cn::vec3& x) { return x.x * x.x + x.x * x.y; }
cn::vec3 gradient_at(const cn::vec3& x) { return {2 * x.x + x.y, x.x, 0}; }  // its divergence is 2 everywhere

bool is_inside(double t) { return t > 0.2 && t < 0.8; }

template<class M>
void refine(const char* name) {
  fmt::print("{}: error of the gradient at polys, error at verts, mean divergence of the gradient inside\n", name);
  for (const std::size_t n : {6u, 12u, 24u}) {
    M m = cn::make_grid<M>({.cells = {n, n, n}});
    cn::jitter(m, 0.15);

    auto u = cn::make_vert_map<double>(m);
    for (const auto v : cn::verts(m)) u[v] = u_at(cn::point(m, v));
    const auto g = cn::gradient(m, u);       // one vector per poly
    const auto h = cn::vert_gradient(m, u);  // one per vert: the mean over the polys at it
    const auto d = cn::divergence(m, g);     // one number per vert: the integral around it

    double wrong_at_polys = 0, wrong_at_verts = 0, flow = 0, inside = 0;
    for (const auto p : cn::polys(m)) wrong_at_polys = std::max(wrong_at_polys, cn::distance(g[p], gradient_at(cn::centroid(m, p))));
    const auto mass = cn::vert_masses(m);
    for (const auto v : cn::verts(m)) {
      const cn::vec3 x = cn::point(m, v);
      if (!is_inside(x.x) || !is_inside(x.y) || (cn::VolumeMesh<M> && !is_inside(x.z))) continue;
      wrong_at_verts = std::max(wrong_at_verts, cn::distance(h[v], gradient_at(x)));
      flow += d[v];
      inside += mass[v];
    }
    fmt::print("  {:5} polys   {:.4f}   {:.4f}   {:.2f}\n", cn::num_polys(m), wrong_at_polys, wrong_at_verts, flow / inside);
  }
}

int main(int argc, char** argv) {
  refine<cn::polygonmesh>("hexagons");
  refine<cn::hexmesh>("hexahedra");

  // The same operators as matrices. Under the inner products that integrate over the mesh, the divergence is minus the adjoint of the gradient.
  const auto m = cn::make_grid<cn::hexmesh>({.cells = {4, 4, 4}});
  const Eigen::SparseMatrix<double> G = cn::gradient_matrix(m), D = cn::divergence_matrix(m).transpose(), M = cn::poly_mass_matrix(m);
  fmt::print("G is {} x {}; M G + transpose(D) = 0: {}\n", G.rows(), G.cols(), (M * G + D).norm() < 1e-12 ? "yes" : "no");

  // A picture, if the program is given the name of a file: the function and its gradient.
  if (argc > 1) {
    const auto hexagons = cn::make_grid<cn::polygonmesh>({.cells = {12, 12, 1}});
    auto u = cn::make_vert_map<double>(hexagons);
    for (const auto v : cn::verts(hexagons)) u[v] = u_at(cn::point(hexagons, v));
    cn::scene s;
    s.add(hexagons, {.field = u, .edges = true}).add_arrows(hexagons, cn::gradient(hexagons, u));
    cn::save_png(s, argv[1], {.width = 380, .height = 320, .camera = cn::camera::from_front, .legend = {.title = "u"}});
  }
}
