// A mesh prepared for queries of heat geodesics, the result of prepare_heat_geodesics.
#pragma once

#include <concino/core/lexicographic.hpp>
#include <concino/core/message.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/fields/detail/heat/distance_constants.hpp>
#include <concino/fields/detail/heat/euclidean_distance.hpp>
#include <concino/fields/detail/heat/geodesic_preparation.hpp>
#include <concino/fields/detail/heat/geodesic_sources.hpp>
#include <concino/fields/detail/heat/heat_matrix.hpp>
#include <concino/fields/detail/heat/heat_preparation.hpp>
#include <concino/fields/heat_geodesics_options.hpp>
#include <concino/geometry/lowest_element.hpp>
#include <concino/operators/virtual_elements.hpp>

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace concino {

/// A mesh prepared by prepare_heat_geodesics for distance queries. Several threads may query it if the solver allows
/// it. Copies share the prepared data.
template<class M, class Solver>
class prepared_heat_geodesics {
  using scaled_mesh = views::scaled<M>;
  using preparation = detail::geodesic_preparation<Solver>;
  struct query {
    std::vector<detail::distance_source> sources;
    std::vector<detail::distance_graph::start> starts;
  };

  detail::mesh_ref<M> mesh_;
  std::shared_ptr<const preparation> prepared_;

  int number(const vert_t<M>& v) const { return static_cast<int>(index_of(mesh_.get(), v)); }

  double scale_down(double length) const { return std::ldexp(length, -prepared_->exponent); }

  void add_source(query& q, const vert_t<M>& v, double distance) const {
    const M& m = mesh_.get();
    detail::check_distance_source(m, v, distance, [&] { return index_of(m, v); });
    const int i = number(v);
    q.starts.push_back({i, static_cast<int>(q.sources.size()), 0, scale_down(distance)});
    q.sources.push_back({prepared_->graph.position(static_cast<std::size_t>(i)), scale_down(distance)});
  }

  static double path_length_at_source(const detail::distance_graph::start& s) { return s.before + s.distance; }
  static std::size_t index(const detail::distance_graph::start& s) { return static_cast<std::size_t>(s.vert); }
  std::size_t component(std::size_t i) const {
    return static_cast<std::size_t>(prepared_->system.component(static_cast<int>(i)));
  }

  std::vector<double> log_heat(const query& q, const std::vector<double>& least,
                               const std::vector<double>& longest) const;
  vert_map<M, double> answer(const query& q) const;

 public:
  template<class D>
  prepared_heat_geodesics(const M& m, const D& discretisation, const heat_geodesics_options& options,
                          const Solver& solver)
      : mesh_(m), prepared_(std::make_shared<const preparation>(
                         detail::prepare_geodesics(m, discretisation, options, solver))) {}

  const M& mesh() const { return mesh_.get(); }
  /// How long heat flows, in units of length^2.
  double time() const { return std::ldexp(prepared_->time, 2 * prepared_->exponent); }

  /// The distances of all verts from these sources.
  /// Needs:  sources as for heat_geodesics. The mesh has not changed since it was prepared.
  /// Result: that of heat_geodesics.
  /// Cost:   two back-substitutions, three where there is a boundary, and half of their time; more if heat underflows
  ///         and is continued. With clamp also a search for shortest paths. With
  ///         iterative solvers one solve and iterations in bands, see heat_geodesics.
  /// Errors: invalid_argument if there is no source or a number is not finite; invalid_mesh if a source is not a vert
  ///         of the mesh; solver_error.
  template<class S>
    requires(detail::gives_verts<M, S> || detail::gives_distances<M, S>)
  vert_map<M, double> distance_from(const S& sources) const {
    query q;
    detail::for_each_distance_source<M>(sources, [&](const vert_t<M>& v, double d) { add_source(q, v, d); });
    return answer(q);
  }
  vert_map<M, double> distance_from(std::initializer_list<vert_t<M>> sources) const {
    return distance_from<std::initializer_list<vert_t<M>>>(sources);
  }
  vert_map<M, double> distance_from(std::initializer_list<std::pair<vert_t<M>, double>> sources) const {
    return distance_from<std::initializer_list<std::pair<vert_t<M>, double>>>(sources);
  }
  void distance_from(mistake::number<mistake::name_the_element>, ...) const = delete;  // elements have types: vert_id{0}, not 0

  /// The distances of all verts from a point of poly p, as a place of its lowest element.
  /// Needs:  x lies on or in p. The polys that contain it should be convex: the distances of their verts are those of
  ///         straight lines.
  /// Result, cost: as above.
  /// Errors: those of lowest_element.
  vert_map<M, double> distance_from(const poly_t<M>& p, const vec3& x) const {
    const M& m = mesh_.get();
    const mesh_point<M> source = detail::lowest_element_of(m, mesh_point<M>{p, x}, "heat_geodesics", "source");
    if (const auto* v = std::get_if<vert_t<M>>(&source.element)) return distance_from(*v);
    query q;
    q.sources.push_back(
        {vec3{scale_down(source.position.x), scale_down(source.position.y), scale_down(source.position.z)}, 0});
    detail::for_each_poly_at(m, source, [&](const poly_t<M>& at) {
      for (const vert_t<M> v : adj_p2v(m, at)) {
        const int i = number(v);
        if (std::any_of(q.starts.begin(), q.starts.end(), [&](const auto& s) { return s.vert == i; })) continue;
        q.starts.push_back(
            {i, 0, distance(q.sources[0].position, prepared_->graph.position(static_cast<std::size_t>(i))), 0});
      }
    });
    return answer(q);
  }
};

/// The logarithm of heat. A source is the weaker the more its initial distance exceeds `least`, the smallest one in its
/// component. longest: lengths of paths to each vert.
template<class M, class Solver>
std::vector<double> prepared_heat_geodesics<M, Solver>::log_heat(const query& q, const std::vector<double>& least,
                                                                 const std::vector<double>& longest) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double decay = std::sqrt(prepared_->time);
  std::vector<detail::heat_source> sources;
  for (const auto& s : q.starts)
    if (const double strength = std::exp((least[component(index(s))] - path_length_at_source(s)) / decay); strength > 0)
      sources.push_back({s.vert, strength});
  std::vector<double> guess(least.size(), -infinity);
  for (std::size_t i = 0; i < guess.size(); ++i)
    if (longest[i] < infinity) guess[i] = (least[component(i)] - longest[i]) / decay;
  std::vector<double> heat = prepared_->system.log_heat(sources, guess);
  bool complete = true;
  for (std::size_t i = 0; i < least.size(); ++i)
    complete = complete && (heat[i] > -infinity || least[component(i)] == infinity);
  if (complete) return heat;
  std::vector<unsigned char> is_open(heat.size());
  for (std::size_t i = 0; i < heat.size(); ++i) is_open[i] = heat[i] == -infinity;
  detail::fill_along_edges(scaled_mesh(mesh_.get(), prepared_->exponent), decay, is_open, heat);
  return heat;
}

template<class M, class Solver>
vert_map<M, double> prepared_heat_geodesics<M, Solver>::answer(const query& q) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  detail::check_has_source(!q.starts.empty());
  const double decay = std::sqrt(prepared_->time);
  auto distance_at = make_vert_map<double>(mesh_.get(), infinity);
  const auto size = distance_at.values().size();
  std::vector<double> least(size, infinity);  // of the initial distances in each component
  for (const auto& s : q.starts)
    least[component(index(s))] = std::min(least[component(index(s))], path_length_at_source(s));
  // Without clamp, longer paths are only needed as a guess.
  const bool needs_all = prepared_->clamp || prepared_->system.is_iterative();
  double first = -infinity;
  for (const double x : least)
    if (x < infinity) first = std::max(first, x);
  const std::vector<double> longest = prepared_->graph.path_lengths_from(
      q.starts, needs_all ? infinity : first + detail::distance_constants::longest_path(decay));
  const Eigen::VectorXd potential = prepared_->system.integrate_gradient(log_heat(q, least, longest));
  const detail::euclidean_distance straight(q.sources);
  std::vector<double> shortest(size);
  detail::distance_constants constants(size, decay);
  for (std::size_t i = 0; i < size; ++i) {
    if (!(longest[i] < infinity)) continue;
    shortest[i] = straight(prepared_->graph.position(i));
    constants.add(component(i), shortest[i], longest[i], least[component(i)], prepared_->mass[i],
                  potential[static_cast<Eigen::Index>(i)]);
  }
  for (const auto& s : q.starts)
    constants.add_source(component(index(s)), path_length_at_source(s), potential[s.vert]);
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t c = component(i);
    if (least[c] == infinity || (prepared_->clamp && !(longest[i] < infinity))) continue;
    double d = potential[static_cast<Eigen::Index>(i)] + constants(c);
    if (prepared_->clamp) d = std::max(std::min(d, longest[i]), shortest[i]);
    distance_at.values()[i] = std::ldexp(std::max(least[c], d), prepared_->exponent);
  }
  for (const auto& s : q.starts) {
    double& d = distance_at.values()[index(s)];
    d = std::min(d, std::ldexp(path_length_at_source(s), prepared_->exponent));
  }
  return distance_at;
}

}  // namespace concino
