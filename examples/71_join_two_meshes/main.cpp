// Joins two meshes that do not match: two blocks of hexes that meet in a plane, one with 2 x 2 faces there, the other with 3 x 3. Their faces are cut along the
// edges of the other block, so that the hexes become polyhedra that share faces. No vert moves, none hangs, and linear functions are exact across the plane.
#include <concino/convert.hpp>
#include <concino/edit.hpp>
#include <concino/fields.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>
#include <concino/validate.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace cn = concino;

/// The faces on the boundary of m that lie in the plane x = at.
std::vector<cn::face_id> faces_in_plane(const cn::polyhedralmesh& m, double at) {
  std::vector<cn::face_id> faces;
  for (const auto f : cn::faces(m)) {
    bool inside = cn::num_elements(cn::adj_f2p(m, f)) == 1;
    for (const auto v : cn::adj_f2v(m, f)) inside = inside && std::abs(cn::point(m, v).x - at) < 1e-9;
    if (inside) faces.push_back(f);
  }
  return faces;
}

/// Cuts these faces along a line: where the coordinate k (y: 1, z: 2) is c. That is enough here, since the edges of grids form such lines.
void cut_along(cn::polyhedralmesh& m, double at, std::size_t k, double c) {
  const auto side = [&](cn::vert_id v) {
    const double d = cn::point(m, v)[k] - c;
    return std::abs(d) < 1e-9 ? 0 : d < 0 ? -1 : 1;
  };
  // Edges that cross it get a vert there.
  std::vector<cn::edge_id> crossed;
  for (const auto f : faces_in_plane(m, at))
    for (const auto e : cn::adj_f2e(m, f)) crossed.push_back(e);
  std::sort(crossed.begin(), crossed.end());
  crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());
  for (const auto e : crossed) {
    const auto [a, b] = cn::end_verts(m, e);
    const double from = cn::point(m, a)[k], to = cn::point(m, b)[k];
    if (side(a) * side(b) < 0) cn::edge_split(m, e, (c - from) / (to - from));
  }
  // Faces with verts on both sides of it are cut between the two verts on it.
  for (const auto f : faces_in_plane(m, at)) {
    std::vector<cn::vert_id> on;
    for (const auto v : cn::adj_f2v(m, f))
      if (side(v) == 0) on.push_back(v);
    if (on.size() == 2) cn::face_cut(m, f, on[0], on[1]);  // refused if they are the ends of an edge
  }
}

/// A block of n x n x n hexes, as polyhedra, whose faces in the plane x = 1 are cut along the edges that a block of k x k x k hexes has there.
cn::polyhedralmesh make_block(double from, std::size_t n, std::size_t k) {
  auto m = cn::convert<cn::polyhedralmesh>(cn::make_grid<cn::hexmesh>({.cells = {n, n, n}, .min = {from, 0, 0}, .max = {from + 1, 1, 1}}));
  for (const std::size_t axis : {1u, 2u})
    for (std::size_t i = 1; i < k; ++i) cut_along(m, 1, axis, static_cast<double>(i) / static_cast<double>(k));
  return m;
}

/// The harmonic function with the values of u in the planes x = 0 and x = 2, or on the whole boundary.
template<class F>
auto solve(const cn::polyhedralmesh& m, const F& u, bool whole_boundary) {
  std::vector<std::pair<cn::vert_id, double>> given;
  const auto on_boundary = cn::boundary_verts(m);
  for (const auto v : cn::verts(m))
    if (const auto x = cn::point(m, v); whole_boundary ? on_boundary[v] : x.x == 0 || x.x == 2) given.emplace_back(v, u(x));
  return cn::harmonic_map(m, given);
}

/// The L2 norm of its error.
template<class F>
double error(const cn::polyhedralmesh& m, const F& u, bool whole_boundary) {
  const auto h = solve(m, u, whole_boundary);
  const auto mass = cn::vert_masses(m);
  double squares = 0;
  for (const auto v : cn::verts(m)) squares += mass[v] * std::pow(h[v] - u(cn::point(m, v)), 2);
  return std::sqrt(squares);
}

void say(const char* what, const cn::polyhedralmesh& m) {
  const auto facts = cn::validate(m).facts;
  fmt::print("{}: {} cells, {} faces, {} verts; {} component{} by faces, volume {:.6f}\n", what, cn::num_polys(m), cn::num_faces(m), cn::num_verts(m),
             facts.components, facts.components == 1 ? "" : "s", cn::total_measure(m));
}

int main(int argc, char** argv) {
  // Beside each other as they are, the blocks share four verts, at the corners of the plane, but no face.
  const auto a = make_block(0, 2, 1), b = make_block(1, 3, 1);
  const auto apart = cn::unite(a, b);
  say("side by side", apart);

  // With their faces cut they have the same verts and the same faces in the plane, so that they become one mesh.
  const auto a_cut = make_block(0, 2, 3), b_cut = make_block(1, 3, 2);
  std::size_t largest = 0;
  for (const auto p : cn::polys(a_cut)) largest = std::max<std::size_t>(largest, cn::num_elements(cn::adj_p2f(a_cut, p)));
  fmt::print("the left block: {} faces in the plane were {}, a cell has up to {} faces\n", faces_in_plane(a_cut, 1).size(), faces_in_plane(a, 1).size(), largest);
  const auto m = cn::unite(a_cut, b_cut, {.tolerance = 1e-9});
  say("joined", m);

  // A function that grows from the left to the right: 0 at x = 0, 1 at x = 2. It is linear, and exact if it crosses the plane.
  const auto linear = [](const cn::vec3& x) { return x.x / 2; };
  fmt::print("error of a linear function: {:.2f} side by side, {} joined\n", error(apart, linear, false), error(m, linear, false) < 1e-12 ? "none" : "some");

  // The error of another harmonic function is of second order, as on blocks of the larger hexes that match, but larger: the cells at the plane have faces in
  // many pieces.
  const auto smooth = [](const cn::vec3& x) { return std::exp(x.x) * std::sin(x.y + 0.3) + x.x * x.z; };
  for (const std::size_t n : {1u, 2u, 4u}) {
    const auto fine = cn::unite(make_block(0, 2 * n, 3 * n), make_block(1, 3 * n, 2 * n), {.tolerance = 1e-9});
    const auto matching = cn::unite(make_block(0, 2 * n, 1), make_block(1, 2 * n, 1), {.tolerance = 1e-9});
    fmt::print("{:4} cells: error {:.5f}; {:4} cells that match: error {:.5f}\n", cn::num_polys(fine), error(fine, smooth, true), cn::num_polys(matching),
               error(matching, smooth, true));
  }

  if (argc > 1) {
    const auto draw = [](const cn::polyhedralmesh& mesh, const cn::vec3& towards, const cn::mesh_look<cn::polyhedralmesh>& look) {
      const cn::view_options from{.towards = towards, .up = {0, 0, 1}};
      return cn::render(cn::scene().add(mesh, look), {.width = 200, .height = 200, .camera = from, .samples = 4, .ground = false});
    };
    const cn::vec3 right{1, -0.5, 0.4}, left{-1, -0.5, 0.4}, front{0.3, -1, 0.5};
    const std::vector<cn::image> pictures{draw(a, right, {.edges = true}), draw(a_cut, right, {.edges = true}), draw(b, left, {.edges = true}),
                                          draw(b_cut, left, {.edges = true}), draw(m, front, {.field = solve(m, linear, false), .isobands = 10, .edges = true})};
    const std::vector<std::string> captions{"left block", "its faces cut", "right block", "its faces cut", "joined"};
    cn::save_png(cn::make_sheet(pictures, {.columns = 5, .captions = captions}), argv[1]);
  }
}
