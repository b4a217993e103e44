// The verts of a clipped mesh, and of what its elements were made.
#pragma once

#include <concino/core/large_pages.hpp>
#include <concino/level_sets/detail/level_place.hpp>
#include <concino/level_sets/detail/part_lists.hpp>
#include <concino/mesh/correspondence.hpp>
#include <concino/mesh/mesh_point.hpp>
#include <concino/mesh/property.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace concino::detail {

/// Numbers the verts that are kept, then the new ones, and lists their points and origins. Crossed: crossed_surface or place_ends.
template<class M, class Crossed>
class clip_verts {
  const M& m_;
  const Crossed& crossed_;
  const std::vector<level_place>& places_;
  double level_;
  std::vector<std::uint32_t> number_;           // by index of the vert in m
  std::vector<std::uint32_t> number_of_place_;  // by place that is not a vert of m
  std::vector<std::uint32_t> new_places_;       // by new vert
  std::uint32_t num_kept_ = 0, num_verts_ = 0;

  bool is_vert(const level_place& x) const { return x.kind == level_place::vert && crossed_.vert_indices[x.above] != ~0u; }

 public:
  std::vector<vec3> points;
  element_origins origins;

  clip_verts(const M& m, const Crossed& crossed, const std::vector<level_place>& places, double level)
      : clip_verts(m, crossed, places, level, core::large_vector(vert_index_bound(m), ~0u)) {}
  /// marks: by index of the vert in m: 0 if it is marked already, else ~0.
  clip_verts(const M& m, const Crossed& crossed, const std::vector<level_place>& places, double level, std::vector<std::uint32_t> marks)
      : m_(m), crossed_(crossed), places_(places), level_(level), number_(std::move(marks)), number_of_place_(core::large_vector(places.size(), ~0u)) {}

  void mark(const vert_t<M>& v) { number_[index_of(m_, v)] = 0; }
  void mark_place(std::uint32_t place) {
    if (place & part_lists::of_mesh) {
      number_[place & ~part_lists::of_mesh] = 0;
      return;
    }
    const level_place& x = places_[place];
    if (is_vert(x)) number_[crossed_.vert_indices[x.above]] = 0;
    else number_of_place_[place] = 0;
  }

  /// Numbers what is marked.
  void number() {
    std::uint32_t n = 0;
    for (const vert_t<M> v : verts(m_))
      if (std::uint32_t& x = number_[index_of(m_, v)]; x != ~0u) x = n++;
    num_kept_ = n;
    for (std::uint32_t& x : number_of_place_)
      if (x != ~0u) x = n++;
    num_verts_ = n;
  }

  /// Lists points and origins, after number(). origins_of(place, list) lists the verts of m of which a place was made.
  template<class OriginsOf>
  void list(const OriginsOf& origins_of) {
    std::vector<std::uint32_t> kept;
    core::reserve_exact(points, num_verts_);
    core::reserve_exact(kept, num_verts_);
    for (const vert_t<M> v : verts(m_)) {
      const auto index = static_cast<std::uint32_t>(index_of(m_, v));
      if (number_[index] == ~0u) continue;
      points.push_back(to_vec3(point(m_, v)));
      kept.push_back(index);
    }
    core::reserve_pages(new_places_, num_verts_ - num_kept_);
    origins = element_origins(std::move(kept));
    std::vector<origin> of_place;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (number_of_place_[i] == ~0u) continue;
      new_places_.push_back(static_cast<std::uint32_t>(i));
      const level_place& x = places_[i];
      const double t = x.kind == level_place::vert ? 1 : crossing_parameter(crossed_.values[x.below], crossed_.values[x.above], level_);
      points.push_back(crossing_point(crossed_.points[x.below], crossed_.points[x.above], t));
      origins_of(x, of_place);
      origins.add(std::span<const origin>(of_place));
    }
  }

  /// The number of verts that are kept; new ones follow.
  std::uint32_t num_kept() const { return num_kept_; }
  const level_place& place_of(const vert_id& made) const { return places_[new_places_[made.raw() - num_kept_]]; }

  /// The numbers of the verts of m, which of() then lacks.
  std::vector<std::uint32_t> take_numbers() { return std::move(number_); }

  vert_id of(const vert_t<M>& v) const { return vert_id{number_[index_of(m_, v)]}; }
  vert_id of_place(std::uint32_t place) const {
    if (place & part_lists::of_mesh) return vert_id{number_[place & ~part_lists::of_mesh]};
    const level_place& x = places_[place];
    return vert_id{is_vert(x) ? number_[crossed_.vert_indices[x.above]] : number_of_place_[place]};
  }
};

[[noreturn, gnu::cold, gnu::noinline]] inline void throw_not_convex(const char* caller, std::size_t poly) {
  core::throw_joined<unsupported>({caller, ": poly ", poly, " is not convex, so that its parts may overlap; leave out .convex_only to cut it nevertheless"});
}

/// Transfers the named properties of m to a mesh that was made of it, if both can have them.
template<class M, class To>
void transfer_if_any([[maybe_unused]] const M& m, [[maybe_unused]] To& made, [[maybe_unused]] const correspondence& c) {
  if constexpr (ShowsProperties<M>)
    if (traits<M>::properties(m).size() > 0) transfer_properties(m, made, c);
}

}  // namespace concino::detail
