// Prepares a mesh for queries of heat geodesics: matrices and the graph of bounds are made, and solvers factorised.
#pragma once

#include <concino/core/lexicographic.hpp>
#include <concino/core/message.hpp>
#include <concino/core/number_text.hpp>
#include <concino/fields/detail/heat/euclidean_distance.hpp>
#include <concino/fields/detail/heat/heat_matrix.hpp>
#include <concino/fields/detail/heat/heat_preparation.hpp>
#include <concino/fields/heat_geodesics_options.hpp>
#include <concino/operators/virtual_elements.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace concino::detail {

inline void check_heat_time(double time) {
  if (!(time >= 0 && time <= std::numeric_limits<double>::max()))
    core::throw_joined<invalid_argument>(
        {"heat_geodesics: time is ", core::number_text(time), "; it must be finite and 0 or more"});
}

/// All lengths are those of the scaled mesh.
template<class Solver>
struct geodesic_preparation {
  heat_system<Solver> system;
  distance_graph graph;
  std::vector<double> mass;
  double time;
  int exponent;
  bool clamp;

  bool is_heat_negative() const {
    const auto position = [&](int v) { return graph.position(static_cast<std::size_t>(v)); };
    const auto sources = system.one_source_per_component(
        [&](int v, int w) { return core::is_lexicographically_less(position(v), position(w)); });
    std::vector<double> guess;
    if (system.is_iterative()) {
      std::vector<distance_graph::start> starts;
      for (const heat_source& s : sources) starts.push_back({s.vert, 0, 0, 0});
      guess = graph.path_lengths_from(starts, std::numeric_limits<double>::infinity());
      for (double& x : guess) x /= -std::sqrt(time);
    }
    return system.is_heat_negative(sources, guess);
  }
};

template<class M, class D, class Solver>
geodesic_preparation<Solver> prepare_geodesics(const M& mesh_in, const D& discretisation,
                                               const heat_geodesics_options& input_options, const Solver& solver) {
  const core::profiled_options profiled(input_options, "prepare_heat_geodesics");
  const heat_geodesics_options& options = *profiled;
  check_heat_time(options.time);
  report_progress(options.progress, 0, "heat geodesics");
  const views::scaled<M> m = scaled_to_unit(mesh_in);
  corner_fluxes corners = fluxes_of(m);
  const double edge = mean_edge_length(m);
  const double time = options.time > 0 ? std::ldexp(options.time, -2 * m.exponent())
                                       : default_heat_time<M>(square_widths(m));
  constexpr bool along_edges = requirement::has_masses<D, M>;  // lengths are still those of the mesh
  Eigen::SparseMatrix<double> stiffness;
  if constexpr (along_edges) stiffness = with_diagonal(lower_stiffness(m, virtual_elements));
  else stiffness = with_diagonal(lower_stiffness_at(m, mesh_in, discretisation));
  const auto mass = vert_masses(m);
  double sum = 0;
  for (const double x : mass.values()) sum += x;
  const double mean = num_verts(m) > 0 ? sum / static_cast<double>(num_verts(m)) : 0;
  // Along edges: the mean mass at every vert, and at every edge the conductance of a grid with edges of mean length.
  const double flow = along_edges ? (edge > 0 ? mean / (edge * edge) : 0) * time : time;
  std::vector<double> own;
  if constexpr (along_edges) own = lumped_masses(mesh_in, discretisation, "heat_geodesics");
  const auto heat_by = [&](Eigen::SparseMatrix<double> a) {
    return lower_heat_matrix(with_diagonal(std::move(a)), flow, [&](int c) {
      const double here = mass.values()[static_cast<std::size_t>(c)];
      return along_edges && here > 0 ? mean * own[static_cast<std::size_t>(c)] : here;
    });
  };
  Eigen::SparseMatrix<double> heat =
      along_edges ? heat_by(lower_stiffness(mesh_in, discretisation)) : heat_by(stiffness);
  report_progress(options.progress, 0.1, "factorising");
  geodesic_preparation<Solver> r{{std::move(stiffness), std::move(corners), mean, solver},
                distance_graph_of(m),
                {mass.values().begin(), mass.values().end()},
                time,
                m.exponent(),
                options.clamp};
  report_progress(options.progress, 0.4, "factorising");
  const auto is_dirichlet_vert =
      options.boundary == heat_boundary::neumann ? make_vert_map<bool>(m, false) : boundary_verts(m);
  const std::span<const unsigned char> is_dirichlet = is_dirichlet_vert.values();
  const bool has_boundary = std::find(is_dirichlet.begin(), is_dirichlet.end(), 1) != is_dirichlet.end();
  if (!has_boundary || options.boundary != heat_boundary::dirichlet) {
    r.system.add_heat(Eigen::SparseMatrix<double>(heat), solver);
    if (!along_edges && r.is_heat_negative()) {
      r.system.forget_heat();
      heat = heat_by(lower_positive_stiffness(m));
      r.system.add_heat(Eigen::SparseMatrix<double>(heat), solver);
    }
  }
  report_progress(options.progress, 0.7, "factorising");
  if (has_boundary) r.system.add_heat(with_dirichlet_verts(std::move(heat), is_dirichlet), solver);
  report_progress(options.progress, 1, "heat geodesics");
  return r;
}

}  // namespace concino::detail
