// Coarsens a polyhedral mesh cell by cell, and solves on each level. Cells are merged two by two as long as their virtual elements stay stable, then the faces
// and edges between them. Linear functions are exact on every level; the picture shows the levels, cut open.
#include <concino/edit.hpp>
#include <concino/edit/min_stability.hpp>
#include <concino/fields.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace cn = concino;

/// Makes one face of two that cell p shares with the same cell, or has on the same side of the cube. Returns false if there are no such faces.
bool merge_two_faces(cn::polyhedralmesh& m, cn::poly_id p, const cn::edit_options& options) {
  for (const auto f : cn::adj_p2f(m, p))
    for (const auto g : cn::adj_p2f(m, p)) {
      const bool on_sides = cn::num_elements(cn::adj_f2p(m, f)) == 1;
      if (on_sides && cn::dot(cn::normal(m, f), cn::normal(m, g)) < 0.999) continue;
      if (f < g && cn::face_merge(m, f, g, options)) return true;
    }
  return false;
}

/// Fewer faces and verts for the same cells. Faces between two cells were bent where cells were merged, and are made one; verts that have only two edges
/// then vanish. On the boundary, those vanish that are on a straight line, so that the cube stays as it is.
void simplify(cn::polyhedralmesh& m, const cn::edit_options& options) {
  const std::vector<cn::poly_id> cells(cn::polys(m).begin(), cn::polys(m).end());
  for (const auto p : cells)
    while (merge_two_faces(m, p, options)) {}
  const auto on_boundary = cn::boundary_verts(m);
  const std::vector<cn::vert_id> verts(cn::verts(m).begin(), cn::verts(m).end());
  for (const auto v : verts) {
    const std::vector<cn::vert_id> ends(cn::adj_v2v(m, v).begin(), cn::adj_v2v(m, v).end());
    if (ends.size() != 2) continue;
    const auto x = cn::point(m, v), a = cn::point(m, ends[0]), b = cn::point(m, ends[1]);
    if (!on_boundary[v] || cn::distance(a, x) + cn::distance(x, b) < (1 + 1e-9) * cn::distance(a, b)) cn::edge_merge(m, v, options);
  }
}

/// The L2 norm of the error of -(Laplacian of u) = load, with the values of the exact solution on the boundary.
template<class F, class L>
double error(const cn::polyhedralmesh& m, const F& exact, const L& load) {
  std::vector<std::pair<cn::vert_id, double>> given;
  const auto on_boundary = cn::boundary_verts(m);
  for (const auto v : cn::verts(m))
    if (on_boundary[v]) given.emplace_back(v, exact(cn::point(m, v)));
  const auto u = cn::poisson(m, load, {.values = given});
  const auto mass = cn::vert_masses(m);
  double squares = 0;
  for (const auto v : cn::verts(m)) squares += mass[v] * std::pow(u[v] - exact(cn::point(m, v)), 2);
  return std::sqrt(squares);
}

int main(int argc, char** argv) {
  const cn::box cube{{0, 0, 0}, {1, 1, 1}};
  cn::polyhedralmesh m = cn::voronoi_polyhedra(cn::random_points(160, cube), cube, {.relax = 5});
  const auto linear = [](const cn::vec3& x) { return 1 + x.x - 2 * x.y + 3 * x.z; };
  const auto smooth = [](const cn::vec3& x) { return std::exp(x.x) * std::cos(2 * x.y) * std::sin(x.z + 1); };

  // The limit is a part of the stability of a cube. Edits that would make a cell of less are refused, and something else is tried instead.
  const cn::min_stability stable(0.05);
  std::vector<cn::image> pictures;
  std::vector<std::string> captions;
  for (const std::size_t cells : {160u, 80u, 40u, 20u}) {
    cn::agglomerate_while(m, stable, {.target = cells});
    const std::size_t verts_before = cn::num_verts(m);
    if (cells < 160) simplify(m, {.keep = {stable}});
    const double of_linear = error(m, linear, [](const cn::vec3&) { return 0.0; });
    const double of_smooth = error(m, smooth, [&](const cn::vec3& x) { return 4 * smooth(x); });
    fmt::print("{:3} cells, {:4} verts, {:4} after simplification; error {:.4f}, linear function {}\n", cn::num_polys(m), verts_before, cn::num_verts(m), of_smooth,
               of_linear < 1e-12 ? "exact" : "not exact");
    if (argc > 1) {
      auto color = cn::make_poly_map<int>(m);
      for (const auto p : cn::polys(m)) color[p] = static_cast<int>(p.raw());
      cn::scene s;
      s.add(m, {.labels = color, .edges = true, .visible = cn::below('x', 0.5) || cn::above('y', 0.5) || cn::below('z', 0.5)});
      pictures.push_back(cn::render(s, {.width = 210, .height = 210, .camera = cn::view_options{.towards = {1, -0.8, 0.9}, .up = {0, 0, 1}}, .samples = 4, .ground = false}));
      captions.push_back(fmt::format("{} cells", cells));
    }
  }
  fmt::print("volume {:.12f}\n", cn::total_measure(m));

  // If the invariant allows no merge any more, it ends above the target, and says so.
  cn::polyhedralmesh strict = m;
  const auto r = cn::agglomerate_while(strict, cn::min_stability(0.2), {.target = 1});
  fmt::print("with a limit of 0.2 it ends at {} cells: {}\n", cn::num_polys(strict), r.reached_target ? "as asked" : r.last_refusal.why);
  if (argc > 1) cn::save_png(cn::make_sheet(pictures, {.columns = 4, .captions = captions}), argv[1]);
}
