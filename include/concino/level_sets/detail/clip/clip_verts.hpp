// The verts of a clipped mesh, and of what its elements were made.
#pragma once

#include <concino/core/error.hpp>
#include <concino/level_sets/detail/cut/level_place.hpp>
#include <concino/mesh/correspondence.hpp>
#include <concino/mesh/property.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// Numbers the verts that are kept, then the new ones, and lists their points and origins. Crossed: crossed_surface or
/// crossed_volume.
template<class M, class Crossed>
class clip_verts {
  const M& m_;
  const Crossed& crossed_;
  const std::vector<level_place>& places_;
  double level_;
  std::vector<std::uint32_t> number_;           // by index of the vert in m
  std::vector<std::uint32_t> number_of_place_;  // by place that is not a vert of m

  bool is_vert(const level_place& x) const {
    return x.kind == level_place::vert && crossed_.vert_indices[x.above] != ~0u;
  }

 public:
  std::vector<vec3> points;
  element_origins origins;

  clip_verts(const M& m, const Crossed& crossed, const std::vector<level_place>& places, double level)
      : m_(m), crossed_(crossed), places_(places), level_(level), number_(vert_index_bound(m), ~0u),
        number_of_place_(places.size(), ~0u) {}

  void mark(const vert_t<M>& v) { number_[index_of(m_, v)] = 0; }
  void mark_place(std::uint32_t place) {
    const level_place& x = places_[place];
    if (is_vert(x)) number_[crossed_.vert_indices[x.above]] = 0;
    else number_of_place_[place] = 0;
  }

  /// Numbers what is marked.
  void number() {
    std::uint32_t n = 0;
    for (const vert_t<M> v : verts(m_))
      if (std::uint32_t& x = number_[index_of(m_, v)]; x != ~0u) x = n++;
    for (std::uint32_t& x : number_of_place_)
      if (x != ~0u) x = n++;
  }

  /// Lists points and origins, after number(). origins_of(place): the verts of m of which a place was made.
  template<class OriginsOf>
  void list(const OriginsOf& origins_of) {
    for (const vert_t<M> v : verts(m_)) {
      const auto index = static_cast<std::uint32_t>(index_of(m_, v));
      if (number_[index] == ~0u) continue;
      points.push_back(to_vec3(point(m_, v)));
      origins.add(index);
    }
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (number_of_place_[i] == ~0u) continue;
      const level_place& x = places_[i];
      const double t = x.kind == level_place::vert
                           ? 1
                           : crossing_parameter(crossed_.values[x.below], crossed_.values[x.above], level_);
      points.push_back(crossing_point(crossed_.points[x.below], crossed_.points[x.above], t));
      origins.add(std::span<const origin>(origins_of(x)));
    }
  }

  vert_id of(const vert_t<M>& v) const { return vert_id{number_[index_of(m_, v)]}; }
  vert_id of_place(std::uint32_t place) const {
    const level_place& x = places_[place];
    return vert_id{is_vert(x) ? number_[crossed_.vert_indices[x.above]] : number_of_place_[place]};
  }
};

[[noreturn, gnu::cold, gnu::noinline]] inline void throw_not_convex(const char* caller, std::size_t poly) {
  core::throw_joined<unsupported>(
      {caller, ": poly ", poly,
       " is not convex, so that its parts may overlap; leave out .convex_only to cut it nevertheless"});
}

/// Transfers the named properties of m to a mesh that was made of it, if both can have them.
template<class M, class To>
void transfer_if_any([[maybe_unused]] const M& m, [[maybe_unused]] To& made, [[maybe_unused]] const correspondence& c) {
  if constexpr (ShowsProperties<M>)
    if (traits<M>::properties(m).size() > 0) transfer_properties(m, made, c);
}

}  // namespace concino::detail
