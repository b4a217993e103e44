// Measures CGAL's isotropic remeshing beside remesh: the bunny to 0.8 of its mean edge. Each works on a copy of the mesh, which is made before the clock starts.
// Standard error says which part of the lengths is within a factor of 4/3, and how far each result is from the input.
#include "../support/program.hpp"

#include <concino/adapters/cgal_surface_mesh.hpp>
#include <concino/convert.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>
#include <concino/remesh.hpp>

#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdio>
#include <memory>

namespace {

using mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

double mean_edge(const concino::trimesh& m) {
  double sum = 0;
  for (const auto e : concino::edges(m)) sum += concino::edge_length(m, e);
  return sum / static_cast<double>(concino::num_edges(m));
}

double share_of_lengths(const concino::trimesh& m, double length) {
  std::size_t good = 0;
  for (const auto e : concino::edges(m)) {
    const double x = concino::edge_length(m, e);
    good += x <= length * 4 / 3 && x >= length * 3 / 4;
  }
  return static_cast<double>(good) / static_cast<double>(concino::num_edges(m));
}

void report(const char* name, const concino::trimesh& input, const concino::trimesh& m, double length) {
  std::fprintf(stderr, "remesh.bunny16: %s: %zu triangles, %.1f %% of lengths good, error %.3g of a length\n", name, concino::num_polys(m),
               100 * share_of_lengths(m, length), concino::hausdorff_distance(input, m).upper / length);
}

template<class M, class Remesh>
double seconds_of_remeshing(const M& m, const Remesh& remesh) {
  auto copy = std::make_unique<M>(m);
  return bench::seconds_of([&] { return remesh(*copy); });
}

void compare_remeshing(const bench::program& p, const concino::trimesh& ours, unsigned iterations, const char* name) {
  const auto theirs = concino::convert<mesh>(ours);
  const double length = 0.8 * mean_edge(ours);
  const auto mine = [length](concino::trimesh& m) { return concino::remesh(m, {.edge_length = length, .feature_angle_deg = 180, .measure_error = false}).num_splits; };
  const auto peer = [length, iterations](mesh& m) {
    CGAL::Polygon_mesh_processing::isotropic_remeshing(faces(m), length, m, CGAL::parameters::number_of_iterations(iterations));
    return m.number_of_faces();
  };
  p.print(bench::compare("remesh.bunny16", p.rounds, {{name, [&] { return seconds_of_remeshing(theirs, peer); }}, {"concino", [&] { return seconds_of_remeshing(ours, mine); }}}));
  auto a = ours;
  mine(a);
  report("concino", ours, concino::convert<concino::trimesh>(a), length);
  auto b = theirs;
  peer(b);
  report(name, ours, concino::convert<concino::trimesh>(b), length);
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    if (!p.wants("remesh.bunny16")) return;
    const concino::trimesh ours(p.data.bunny16());
    compare_remeshing(p, ours, 3, "cgal");
    compare_remeshing(p, ours, 10, "cgal_10");
  });
}
