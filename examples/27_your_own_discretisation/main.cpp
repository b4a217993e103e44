// Write a discretisation of your own, for example to choose where heat spreads well. The library needs a type with one member function; laplacian,
// harmonic_map, smooth, heat_flow and others take it in place of `uniform` or `cotangent`.
#include <concino/concepts/views.hpp>
#include <concino/fields.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>

#include <fmt/core.h>

#include <utility>
#include <vector>

namespace cn = concino;

/// Weights of the edges of any graph: the number of lanes. A graph has no areas, so this type defines masses too.
template<class Lanes>
struct roads {
  const Lanes& lanes;

  template<cn::PrimalGraph M>
  auto neighbour_weights(const M&) const {
    return [this](const cn::vert_t<M>& a, const cn::vert_t<M>& b) { return (lanes[a] + lanes[b]) / 2.0; };
  }
  template<cn::PrimalGraph M>
  auto masses(const M& m) const { return cn::make_vert_map<double>(m, 1.0); }
};
template<class Lanes> roads(const Lanes&) -> roads<Lanes>;

/// A matrix for each poly, the default one times a factor: a block of wood whose lowest third conducts better. Masses are those of the mesh.
struct layered {
  double conductivity;

  template<cn::EmbeddedMesh M>
  auto poly_matrices(const M& m) const {
    return [&m, factor = conductivity, element = cn::virtual_elements.poly_matrices(m)](const cn::poly_t<M>& p, cn::local_matrix<cn::vert_t<M>>& k) mutable {
      element(p, k);
      if (cn::centroid(m, p)[1] < 1 / 3.0)
        for (double& x : k.entries) x *= factor;
    };
  }
};
static_assert(cn::Discretisation<layered, cn::tetmesh> && cn::Discretisation<layered, cn::polyhedralmesh>);

void conduct(const auto& block) {
  std::vector<std::pair<cn::vert_id, double>> ends;
  for (const cn::vert_id v : cn::verts(block))
    if (const double x = cn::point(block, v)[0]; x == 0 || x == 1) ends.push_back({v, x});
  for (const double c : {1.0, 2.0, 4.0}) {
    const auto u = cn::harmonic_map(block, ends, layered{c});
    const Eigen::Map<const Eigen::VectorXd> x(u.values().data(), static_cast<Eigen::Index>(u.values().size()));
    fmt::print("conductivity {} in the lowest third: heat flow {:.4f}, expected {:.4f}\n", c, -x.dot(cn::laplacian(block, layered{c}) * x), (2 + c) / 3);
  }
}

int main() {
  const auto town = cn::make_grid<cn::quadmesh>({.cells = {4, 4}});
  const auto streets = cn::primal(town);  // verts and edges only
  auto lanes = cn::make_vert_map<int>(town, 1);
  for (const cn::vert_id v : cn::verts(town))
    if (cn::point(town, v)[1] == 0) lanes[v] = 8;  // a motorway in the south
  const cn::vert_id south_west{0}, south_east{4}, north_west{20};
  const auto slow = cn::harmonic_map(streets, {{south_west, 0.0}, {north_west, 1.0}}, cn::uniform);
  const auto fast = cn::harmonic_map(streets, {{south_west, 0.0}, {north_west, 1.0}}, roads{lanes});
  fmt::print("south east: {:.3f}, with the motorway {:.3f}\n", slow[south_east], fast[south_east]);

  conduct(cn::make_grid<cn::hexmesh>({.cells = {6, 6, 3}}));
  conduct(cn::make_grid<cn::tetmesh>({.cells = {6, 6, 3}}));
}
