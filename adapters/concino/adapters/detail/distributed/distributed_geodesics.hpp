// Heat geodesics of a distributed mesh: the steps of heat_geodesics, with sums over the processes between them.
#pragma once

#include <concino/adapters/detail/distributed/distributed_components.hpp>
#include <concino/adapters/detail/distributed/distributed_heat.hpp>
#include <concino/adapters/detail/distributed/distributed_problem.hpp>
#include <concino/adapters/detail/distributed/distributed_scale.hpp>
#include <concino/adapters/detail/distributed/distributed_sources.hpp>
#include <concino/adapters/detail/distributed/distributed_system.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/detail/mpi/mpi_all_to_all.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/petsc.hpp>
#include <concino/fields/heat_geodesics_options.hpp>
#include <concino/fields/support/heat_geodesics_parts.hpp>
#include <concino/graph/boundary_verts.hpp>
#include <concino/operators/virtual_elements.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace concino::detail {

/// Lengths are those of the scaled mesh. Every function is collective.
template<class M>
class distributed_geodesics {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  using own_polys = decltype(owned_part(std::declval<const distributed<M>&>()));

  const distributed<M>& mesh_;
  const petsc& solver_;
  int exponent_, unit_ = 0;
  double time_ = 0;
  distributed_problem<M> problem_;
  distributed_components components_;
  corner_fluxes corners_;         // of the polys of this process
  std::vector<double> own_mass_;  // by local vert, of the polys of this process
  std::vector<double> mass_;      // by local vert, right at those of this process
  std::optional<distributed_system<M>> poisson_;
  std::optional<distributed_heat<M>> neumann_, dirichlet_;

  MPI_Comm all() const { return mesh_.communicator(); }
  std::size_t index(const vert_t<M>& v) const { return index_of(mesh_, v); }
  const ghost_exchange& exchange() const { return mesh_.exchange(static_cast<const vert_t<M>*>(nullptr)); }

  /// The default time needs the widths of all polys.
  void read(const views::scaled<own_polys>& part, double time) {
    square_width_sums widths;
    on_all(all(), [&] {
      corners_ = fluxes_of(part);
      const auto mass = vert_masses(part);
      own_mass_.assign(mass.values().begin(), mass.values().end());
      widths = square_widths(part);
    });
    mass_ = own_mass_;
    exchange().to_owners(mass_.data(), [](double& sum, double x) { sum += x; });
    std::vector<double> sums = {widths.sum, widths.measure};
    add_over_processes(all(), sums);
    widths = {sums[0], sums[1]};
    time_ = time > 0 ? std::ldexp(time, -2 * exponent_) : default_heat_time<M>(widths);
    if (widths.measure > 0)  // the sum of the masses
      unit_ = std::ilogb(widths.measure / static_cast<double>(mesh_.num_global_verts()));
  }

  Eigen::SparseMatrix<double> heat_matrix(Eigen::SparseMatrix<double> stiffness) const {
    return lower_heat_matrix(with_diagonal(std::move(stiffness)), time_,
                             [&](int c) { return own_mass_[static_cast<std::size_t>(c)]; });
  }

  /// As heat_system: only differences of the solution count, so one vert of each component is constrained.
  void factorize_poisson(Eigen::SparseMatrix<double> stiffness) {
    for (const vert_t<M> v : verts(mesh_))
      if (const std::size_t c = components_.of_vert[index(v)];
          c != distributed_components::none && components_.first_vert[c] == mesh_.global_number(v))
        stiffness.coeffRef(static_cast<int>(index(v)), static_cast<int>(index(v))) *= 2;
    poisson_.emplace(problem_, both_triangles(stiffness), solver_.options());
  }

  /// As prepare_geodesics.
  void factorize_heat(const views::scaled<own_polys>& part, const Eigen::SparseMatrix<double>& stiffness,
                      heat_boundary boundary) {
    auto is_dirichlet = make_vert_map<bool>(mesh_, false);
    Eigen::SparseMatrix<double> heat;
    on_all(all(), [&] {
      if (boundary != heat_boundary::neumann) is_dirichlet = boundary_verts(mesh_);
      heat = heat_matrix(stiffness);
    });
    exchange_ghosts(is_dirichlet);
    const auto marks = is_dirichlet.values();
    const bool has_boundary = is_any_over_processes(all(), std::find(marks.begin(), marks.end(), 1) != marks.end());
    if (!has_boundary || boundary != heat_boundary::dirichlet) {
      neumann_.emplace(problem_, heat, solver_);
      if (is_heat_negative()) {
        on_all(all(), [&] { heat = heat_matrix(lower_positive_stiffness(part)); });
        neumann_.emplace(problem_, heat, solver_);
      }
    }
    if (has_boundary) dirichlet_.emplace(problem_, with_dirichlet_verts(std::move(heat), marks), solver_);
  }

  /// As heat_system.
  bool is_heat_negative() const {
    const std::vector<double> log_u =
        log_heat(one_source_per_component(mesh_, exponent_, components_), std::vector<double>(components_.size(), 0.0));
    std::vector<double> counts(2);
    for (const vert_t<M> v : problem_.own()) {
      counts[0] += log_u[index(v)] == -infinity;
      counts[1] += 1;
    }
    add_over_processes(all(), counts);
    return counts[0] > 0 && 500 * counts[0] >= counts[1];
  }

  /// The logarithm of heat at each local vert, up to a constant in each component. A source is the weaker the more its
  /// initial distance exceeds the least one of its component.
  std::vector<double> log_heat(const std::vector<distributed_source>& sources, const std::vector<double>& least) const {
    std::vector<heat_source> own;
    std::vector<unsigned char> is_heated(components_.of_vert.size());
    for (const vert_t<M> v : verts(mesh_)) {
      const std::size_t c = components_.of_vert[index(v)];
      if (c == distributed_components::none) continue;
      is_heated[index(v)] = least[c] < infinity;
      const distributed_source* const s = mesh_.is_ghost(v) ? nullptr : source_at(sources, mesh_.global_number(v));
      const double strength = s ? std::exp((least[c] - s->distance) / std::sqrt(time_)) : 0;
      if (strength > 0) own.push_back({static_cast<int>(index(v)), strength});
    }
    const rescaled_heat heat = (neumann_ ? neumann_ : dirichlet_)->heat_from(own, is_heated, unit_);
    if (!neumann_ || !dirichlet_) return heat.logs();
    return heat.logs_of_sum(dirichlet_->heat_from(own, is_heated, unit_));
  }

  /// Where heat is not positive, by shortest paths along edges.
  void fill(std::vector<double>& log_u) const {
    std::vector<unsigned char> is_open(log_u.size());
    for (std::size_t i = 0; i < log_u.size(); ++i) is_open[i] = log_u[i] == -infinity;
    for (bool changes = true; changes;) {
      const std::vector<double> before = log_u;
      on_all(all(), [&] {
        fill_along_edges(views::scaled<distributed<M>>(mesh_, exponent_), std::sqrt(time_), is_open, log_u);
      });
      exchange().to_owners(log_u.data(), [](double& known, double other) { known = std::max(known, other); });
      exchange().to_ghosts(log_u.data());
      changes = is_any_over_processes(all(), log_u != before);
    }
  }

 public:
  distributed_geodesics(const distributed<M>& m, const heat_geodesics_options& options, const petsc& solver)
      : mesh_(m), solver_(solver), exponent_(common_length_exponent(m)),
        problem_(m, std::vector<std::pair<vert_t<M>, double>>(), "heat_geodesics", true),
        components_(find_components(m)) {
    const views::scaled<own_polys> part(owned_part(m), exponent_);
    read(part, options.time);
    Eigen::SparseMatrix<double> stiffness;
    on_all(all(), [&] { stiffness = with_diagonal(lower_stiffness(part, virtual_elements)); });
    factorize_heat(part, stiffness, options.boundary);
    factorize_poisson(std::move(stiffness));
  }

  distributed_geodesics(const distributed_geodesics&) = delete;
  distributed_geodesics& operator=(const distributed_geodesics&) = delete;

  template<class S>
  vert_map<distributed<M>, double> distance_from(const S& input) const {
    const std::vector<distributed_source> sources = gather_sources(mesh_, exponent_, input);
    const std::vector<double> least = min_distances(sources);
    double first = -infinity;
    for (const double x : least)
      if (x < infinity) first = std::max(first, x);
    const double decay = std::sqrt(time_);
    const std::vector<double> path =
        path_lengths_near(mesh_, exponent_, sources, first + distance_constants::longest_path(decay));
    std::vector<double> log_u = log_heat(sources, least);
    bool is_complete = true;
    for (std::size_t i = 0; i < log_u.size(); ++i)
      if (const std::size_t c = components_.of_vert[i]; c != distributed_components::none && least[c] < infinity)
        is_complete = is_complete && log_u[i] > -infinity;
    if (is_any_over_processes(all(), !is_complete)) fill(log_u);
    const Eigen::VectorXd potential = solve_over_processes(mesh_, *poisson_, direction_load(corners_, log_u), solver_);
    return shifted(sources, least, path, potential);
  }

 private:
  /// The least initial distance in each component.
  std::vector<double> min_distances(const std::vector<distributed_source>& sources) const {
    std::vector<double> least(components_.size(), infinity);
    for (const vert_t<M> v : verts(mesh_))
      if (const std::size_t c = components_.of_vert[index(v)]; c != distributed_components::none)
        if (const distributed_source* const s = source_at(sources, mesh_.global_number(v)))
          least[c] = std::min(least[c], s->distance);
    (MPI_Allreduce)(MPI_IN_PLACE, least.data(), static_cast<int>(least.size()), MPI_DOUBLE, MPI_MIN, all());
    return least;
  }

  /// The potential plus the constant of each component, as distances.
  vert_map<distributed<M>, double> shifted(const std::vector<distributed_source>& sources,
                                           const std::vector<double>& least, const std::vector<double>& path,
                                           const Eigen::VectorXd& potential) const {
    const views::scaled<distributed<M>> scaled(mesh_, exponent_);
    const euclidean_distance straight = straight_distance(sources);
    distance_constants constants(components_.size(), std::sqrt(time_));
    for (const vert_t<M> v : problem_.own()) {
      const std::size_t i = index(v), c = components_.of_vert[i];
      const double here = potential[static_cast<Eigen::Index>(i)];
      if (path[i] < infinity) constants.add(c, straight(point(scaled, v)), path[i], least[c], mass_[i], here);
      if (const distributed_source* const s = source_at(sources, mesh_.global_number(v)))
        constants.add_source(c, s->distance, here);
    }
    constants.for_each_sum([&](std::vector<double>& sums) { add_over_processes(all(), sums); });
    auto r = make_vert_map<double>(mesh_, infinity);
    for (const vert_t<M> v : verts(mesh_)) {
      const std::size_t i = index(v), c = components_.of_vert[i];
      if (c != distributed_components::none && least[c] < infinity)
        r[v] = std::ldexp(std::max(least[c], potential[static_cast<Eigen::Index>(i)] + constants(c)), exponent_);
      if (const distributed_source* const s = source_at(sources, mesh_.global_number(v)))
        r[v] = std::min(r[v], std::ldexp(s->distance, exponent_));
    }
    return r;
  }
};

}  // namespace concino::detail
