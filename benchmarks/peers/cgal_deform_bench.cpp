// Measures deformations by handles, as rigid as possible, against CGAL's Surface_mesh_deformation with its default options, on the same triangles: the
// preparation, and 20 iterations from the shape at rest, which are also compared with the back-substitutions that they need.
#include "../support/matrix_keeper.hpp"
#include "../support/kinds.hpp"

#include <concino/deform/prepare_deform.hpp>
#include <concino/generate/grid.hpp>
#include <concino/solve/ldlt.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_deformation.h>

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using surface = CGAL::Surface_mesh<kernel::Point_3>;

struct shape {
  concino::trimesh ours;
  surface theirs;
  std::vector<concino::vert_id> handles;
  std::vector<std::pair<concino::vert_id, concino::vec3>> positions;
  std::vector<surface::Vertex_index> same;  // by index

  explicit shape(std::size_t n) : ours(concino::make_grid<concino::trimesh>({.cells = {n, n}})) {
    for (const auto v : concino::verts(ours)) {
      concino::vec3 x = concino::point(ours, v);
      const bool is_end = x.x == 0 || x.x == 1;
      x.z = 0.1 * std::sin(3 * x.x) * std::cos(4 * x.y);
      concino::set_point(ours, v, x);
      same.push_back(theirs.add_vertex({x.x, x.y, x.z}));
      if (!is_end) continue;
      handles.push_back(v);
      positions.push_back({v, x.x == 0 ? x : x + concino::vec3{-0.1, 0, 0.2}});
    }
    for (const auto t : concino::polys(ours)) {
      std::vector<surface::Vertex_index> corners;
      for (const auto v : concino::adj_p2v(ours, t)) corners.push_back(same[v.raw()]);
      theirs.add_face(corners);
    }
  }
};

template<CGAL::Deformation_algorithm_tag Tag>
struct peer : CGAL::Surface_mesh_deformation<surface, CGAL::Default, CGAL::Default, Tag> {
  explicit peer(shape& s) : CGAL::Surface_mesh_deformation<surface, CGAL::Default, CGAL::Default, Tag>(s.theirs) {
    this->insert_roi_vertices(s.same.begin(), s.same.end());
    for (const auto v : s.handles) this->insert_control_vertex(s.same[v.raw()]);
  }
  void put_handles(const shape& s) {
    this->reset();
    for (const auto& [v, x] : s.positions) this->set_target_position(s.same[v.raw()], {x.x, x.y, x.z});
  }
};

/// Both find the same shape, after many iterations on few triangles.
template<CGAL::Deformation_algorithm_tag Tag>
void check(const std::string& name, concino::rigid_cells cells) {
  shape s(6);
  const auto x = concino::prepare_deform(s.ours, s.handles, {.rigidity = cells}).with_positions(s.positions, {.max_iterations = 3000, .tolerance = 0});
  peer<Tag> d(s);
  d.preprocess();
  d.put_handles(s);
  d.deform(3000, 0);
  double difference = 0;
  for (const auto v : concino::verts(s.ours)) {
    const auto& y = s.theirs.point(s.same[v.raw()]);
    difference = std::max(difference, concino::distance(x.points[v], {y.x(), y.y(), y.z()}));
  }
  if (!(difference < 1e-3)) throw std::runtime_error(name + ": CGAL and the library differ by " + std::to_string(difference));
}

template<CGAL::Deformation_algorithm_tag Tag>
void measure(const bench::program& p, const std::string& name, shape& s, concino::rigid_cells cells) {
  const std::string prepare = name + ".prepare.hill100k", iterate = name + ".iterate.hill100k";
  if (!p.wants(prepare) && !p.wants(iterate)) return;
  check<Tag>(name, cells);
  const auto ours = [&] { return concino::prepare_deform(s.ours, s.handles, {.rigidity = cells}); };
  if (p.wants(prepare))
    p.print(bench::compare(prepare, std::min(p.rounds, 3), {{"concino", [&] { return bench::seconds_of(ours); }}, {"cgal", [&] {
                                                              peer<Tag> d(s);
                                                              return bench::seconds_of([&] { return d.preprocess(); });
                                                            }}}));
  if (!p.wants(iterate)) return;
  constexpr unsigned iterations = 20;
  std::vector<Eigen::SparseMatrix<double>> matrices;
  (void)concino::prepare_deform(s.ours, s.handles, {.rigidity = cells}, bench::matrix_keeper(&matrices));
  concino::ldlt solver;
  solver.factorize(matrices.at(0));
  const Eigen::VectorXd load = Eigen::VectorXd::Ones(matrices[0].cols());
  const auto arap = ours();
  auto rest = concino::make_vert_map<concino::vec3>(s.ours);
  for (const auto v : concino::verts(s.ours)) rest[v] = concino::point(s.ours, v);
  const auto iterated = [&] { return arap.with_positions_from(rest, s.positions, {.max_iterations = iterations, .tolerance = 0}); };
  if (iterated().energies.size() != iterations + 1) throw std::runtime_error(iterate + ": not as many iterations");
  const auto substitutions = [&] {
    double sum = 0;
    for (unsigned i = 0; i < 3 * iterations; ++i) sum += solver.solve(load)[0];
    return sum;
  };
  peer<Tag> d(s);
  d.preprocess();
  const auto their_iterations = [&] {
    d.put_handles(s);
    return bench::seconds_of([&] {
      d.deform(iterations, 0);
      return 0;
    });
  };
  p.print(bench::compare(iterate, std::min(p.rounds, 5), {{"concino", [&] { return bench::seconds_of(iterated); }},
                                             {"substitutions", [&] { return bench::seconds_of(substitutions); }},
                                             {"cgal", their_iterations}}));
  d.reset();
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    shape s(p.data.tiny ? 12 : 315);
    measure<CGAL::ORIGINAL_ARAP>(p, "deform", s, concino::rigid_cells::spokes);
    measure<CGAL::SPOKES_AND_RIMS>(p, "deform-rims", s, concino::rigid_cells::spokes_and_rims);
  });
}
