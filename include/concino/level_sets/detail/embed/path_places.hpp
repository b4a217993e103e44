// The points of a path on a surface, each once, and the polys and edges between them.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/local_numbers.hpp>
#include <concino/core/message.hpp>
#include <concino/core/number_text.hpp>
#include <concino/mesh/mesh_point.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace concino::detail {

/// Reads the points of a path, and finds what joins them.
template<class M>
class path_places {
 public:
  struct place {
    std::optional<vert_t<M>> vert;  // of the mesh; none inside an edge
    edge_t<M> edge{};
    double parameter = 0;
  };

 private:
  const M& m_;
  core::local_numbers vert_numbers_;  // of verts that are places
  core::local_numbers edge_numbers_;
  std::vector<std::uint32_t> place_of_vert_;
  std::vector<std::vector<std::uint32_t>> places_on_;  // by edge with places: these, by parameter

  std::uint32_t add_vert(const vert_t<M>& v) {
    const unsigned n = vert_numbers_.add(index_of(m_, v));
    if (n == place_of_vert_.size()) {
      place_of_vert_.push_back(static_cast<std::uint32_t>(places.size()));
      places.push_back({v});
    }
    return place_of_vert_[n];
  }
  std::uint32_t add_on_edge(const edge_point<M>& x, std::size_t point) {
    if (!(x.parameter >= 0 && x.parameter <= 1))
      core::throw_joined<invalid_argument>({"embed_path: point ", point, " has the parameter ",
                                            core::number_text(x.parameter), " on its edge; it must be in [0, 1]"});
    const auto ends = end_verts(m_, x.edge);
    if (x.parameter == 0 || x.parameter == 1) return add_vert(x.parameter == 0 ? ends.first : ends.second);
    const unsigned n = edge_numbers_.add(index_of(m_, x.edge));
    if (n == places_on_.size()) {
      places_on_.emplace_back();
      edges.push_back(x.edge);
    }
    std::vector<std::uint32_t>& row = places_on_[n];
    const auto at = std::lower_bound(row.begin(), row.end(), x.parameter,
                                     [&](std::uint32_t i, double t) { return places[i].parameter < t; });
    if (at != row.end() && places[*at].parameter == x.parameter) return *at;
    const auto number = static_cast<std::uint32_t>(places.size());
    row.insert(at, number);
    places.push_back({{}, x.edge, x.parameter});
    return number;
  }

  std::vector<poly_t<M>> polys_at(const place& x) const {
    std::vector<poly_t<M>> list;
    if (x.vert) {
      for (const poly_t<M> p : adj_v2p(m_, *x.vert)) list.push_back(p);
    } else {
      for (const poly_t<M> p : adj_e2p(m_, x.edge)) list.push_back(p);
    }
    return list;
  }
  bool is_on(const place& x, const edge_t<M>& e) const {
    if (!x.vert) return x.edge == e;
    const auto ends = end_verts(m_, e);
    return ends.first == *x.vert || ends.second == *x.vert;
  }

 public:
  std::vector<place> places;
  std::vector<edge_t<M>> edges;               // those with places
  std::vector<std::uint32_t> place_of_point;

  explicit path_places(const M& m) : m_(m) {}

  void add(const vert_t<M>& v, std::size_t) { place_of_point.push_back(add_vert(v)); }
  void add(const edge_point<M>& x, std::size_t point) { place_of_point.push_back(add_on_edge(x, point)); }
  void add(const mesh_point<M>& x, std::size_t point) {
    if (const auto* const v = std::get_if<vert_t<M>>(&x.element)) add(*v, point);
    else if (const auto* const on_edge = std::get_if<edge_point<M>>(&x.element)) add(*on_edge, point);
    else
      core::throw_joined<invalid_argument>(
          {"embed_path: point ", point,
           " is inside a poly; a path can be embedded if its points are at verts and on edges"});
  }

  /// The places inside an edge, by parameter.
  std::span<const std::uint32_t> places_on(const edge_t<M>& e) const {
    const unsigned n = edge_numbers_.find(index_of(m_, e));
    if (n == core::local_numbers::none) return {};
    return places_on_[n];
  }

  /// The edge that has both places.
  std::optional<edge_t<M>> common_edge(std::uint32_t a, std::uint32_t b) const {
    const place &x = places[a], &y = places[b];
    if (!x.vert) return is_on(y, x.edge) ? std::optional(x.edge) : std::nullopt;
    if (!y.vert) return is_on(x, y.edge) ? std::optional(y.edge) : std::nullopt;
    for (const edge_t<M> e : adj_v2e(m_, *x.vert))
      if (is_on(y, e)) return e;
    return {};
  }
  /// The poly that has both places; of several the one with the lowest index.
  std::optional<poly_t<M>> common_poly(std::uint32_t a, std::uint32_t b) const {
    std::optional<poly_t<M>> found;
    const auto others = polys_at(places[b]);
    for (const poly_t<M>& p : polys_at(places[a]))
      if (std::find(others.begin(), others.end(), p) != others.end() &&
          (!found || index_of(m_, p) < index_of(m_, *found)))
        found = p;
    return found;
  }
  /// Calls f(from, to) for each part of an edge between two places on it.
  template<class F>
  void for_each_step(const edge_t<M>& e, std::uint32_t a, std::uint32_t b, const F& f) const {
    const auto parameter = [&](std::uint32_t i) {
      const place& x = places[i];
      return !x.vert ? x.parameter : end_verts(m_, e).first == *x.vert ? 0.0 : 1.0;
    };
    const auto inside = places_on(e);
    const double from = parameter(a), to = parameter(b), low = std::min(from, to), high = std::max(from, to);
    std::uint32_t at = a;
    for (std::size_t k = 0; k < inside.size(); ++k) {
      const std::uint32_t x = from < to ? inside[k] : inside[inside.size() - 1 - k];
      if (!(low < places[x].parameter && places[x].parameter < high)) continue;
      f(at, x);
      at = x;
    }
    f(at, b);
  }
};

}  // namespace concino::detail
