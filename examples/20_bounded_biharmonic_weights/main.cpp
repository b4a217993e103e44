// Compute weights for handles that deform a shape. The weights of a handle are smooth, 1 at that handle and 0 at the others. The biharmonic map is smooth but
// leaves [0, 1], so that parts move against the handle. With bounds it becomes a quadratic program (Jacobson, Baran, Popovic, Sorkine 2011).
#include <concino/fields.hpp>
#include <concino/generate.hpp>
#include <concino/operators.hpp>
#include <concino/optimize.hpp>
#include <concino/render/scene.hpp>
#include <concino/render/scene_png.hpp>

#include <fmt/core.h>

namespace cn = concino;

int main(int argc, char** argv) {
  const auto m = cn::make_grid<cn::polygonmesh>({.cells = {16, 12, 1}});
  const auto n = static_cast<Eigen::Index>(cn::num_verts(m));
  cn::vert_id handle[3] = {cn::vert_id{0}, cn::vert_id{0}, cn::vert_id{0}};  // the verts nearest to `place`
  const cn::vec3 place[3] = {{0.15, 0.2, 0}, {0.5, 0.85, 0}, {0.9, 0.3, 0}};
  for (int k = 0; k < 3; ++k)
    for (const cn::vert_id v : cn::verts(m))
      if (cn::distance(cn::point(m, v), place[k]) < cn::distance(cn::point(m, handle[k]), place[k])) handle[k] = v;

  const auto smooth = cn::harmonic_map(m, {{handle[0], 1.0}, {handle[1], 0.0}, {handle[2], 0.0}}, {.exponent = 2});
  double low = 0, high = 1;
  for (const double w : smooth.values()) low = std::min(low, w), high = std::max(high, w);
  fmt::print("biharmonic:          weights of the first handle from {:.4f} to {:.4f}\n", low, high);

  // The same energy, with all weights between 0 and 1.
  const Eigen::SparseMatrix<double> laplacian = cn::laplacian(m);
  Eigen::SparseMatrix<double> inverse_mass = cn::mass_matrix(m), identity(n, n);
  inverse_mass.coeffs() = inverse_mass.coeffs().inverse();
  identity.setIdentity();
  const Eigen::SparseMatrix<double> energy = laplacian * inverse_mass * laplacian;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(n);
  auto weight = cn::make_vert_map<double>(m);
  for (int k = 0; k < 3; ++k) {
    Eigen::VectorXd at_least = Eigen::VectorXd::Zero(n), at_most = Eigen::VectorXd::Ones(n);
    for (int other = 0; other < 3; ++other) {
      const auto i = static_cast<Eigen::Index>(cn::index_of(m, handle[other]));
      at_least[i] = at_most[i] = other == k ? 1 : 0;
    }
    const auto w = cn::solve_qp(energy, Eigen::VectorXd::Zero(n), identity, at_least, at_most);
    fmt::print("bounded, handle {}:   from {:.4f} to {:.4f}, {} of {} verts at a bound\n", k, std::abs(w.x.minCoeff()), w.x.maxCoeff(),
               (w.multipliers.array() != 0).count(), n);
    sum += w.x;
    for (const cn::vert_id v : cn::verts(m)) weight[v] = w.x[static_cast<Eigen::Index>(cn::index_of(m, v))];
  }
  fmt::print("sum of the weights:  {:.3f} to {:.3f}\n", sum.minCoeff(), sum.maxCoeff());

  // A picture, if the program is given the name of a file: the weights of the last handle, and all handles.
  if (argc > 1) {
    cn::scene s;
    s.add(m, {.field = weight, .isobands = 10, .edges = true});
    s.add_points({cn::point(m, handle[0]), cn::point(m, handle[1]), cn::point(m, handle[2])}, {.radius = 0.015});
    cn::save_png(s, argv[1], {.width = 400, .height = 320, .camera = cn::camera::from_front, .legend = {.title = "weight"}});
  }
}
