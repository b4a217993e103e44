// Makes the level set of a property elements of a mesh.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/edit/replace_polys.hpp>
#include <concino/level_sets/detail/cut/crossed_surface_reader.hpp>
#include <concino/level_sets/detail/cut/crossed_volume_reader.hpp>
#include <concino/level_sets/detail/cut/level_states.hpp>
#include <concino/level_sets/detail/embed/embedding_lists.hpp>
#include <concino/mesh/property.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace concino::detail {

/// The property with this name.
template<class M>
auto level_property(M& m, std::string_view name, const char* caller) {
  if (!find_vert_property<double>(m, name))
    core::throw_joined<invalid_argument>({caller, ": the verts have no property \"", name,
                                          "\" of type double; vert_property<double>(m, name) makes one"});
  return vert_property<double>(m, name);
}

/// Finds the verts near which the level set crosses an edge, nearer than a fraction of that.
template<class M, class U>
std::vector<vert_t<M>> verts_to_snap(const M& m, const U& u, double level, double fraction) {
  std::vector<vert_t<M>> found;
  if (!(fraction > 0)) return found;
  for (const vert_t<M> v : verts(m)) {
    const double x = static_cast<double>(u[v]);
    if (x == level) continue;
    for (const edge_t<M> e : adj_v2e(m, v)) {
      const auto ends = end_verts(m, e);
      const double y = static_cast<double>(u[ends.first == v ? ends.second : ends.first]);
      if ((x < level) == (y < level) || y == level) continue;
      const double t = x < level ? crossing_parameter(x, y, level) : 1 - crossing_parameter(y, x, level);  // from v
      if (t >= fraction) continue;
      found.push_back(v);
      break;
    }
  }
  return found;
}

/// Makes room in a map of the library for verts that are added. Named properties, and those of other libraries, grow
/// with their mesh.
template<class M, class U>
void make_room_for_verts(const M& m, U& u, std::size_t num_added) {
  if constexpr (requires { u.resize(num_added); }) u.resize(vert_index_bound(m) + num_added);
}

/// Crossed: the reader of the polys that the level set crosses.
template<class M, class Crossed>
class level_embedder {
  const Crossed& crossed_;
  double level_;
  const embedding_lists& lists_;
  const std::vector<level_place>& places_;
  std::vector<poly_t<M>> polys_;
  std::vector<vert_t<M>> verts_;
  std::vector<vec3> points_;
  correspondence from_;
  std::vector<vert_t<M>> corners_;  // of one edge or face on the level set; no memory is needed after the edit

  template<class T>
  static id_span<T> span(const std::vector<T>& v) { return {v.data(), v.data() + v.size()}; }

 public:
  std::vector<vert_t<M>> new_verts;
  std::vector<poly_t<M>> new_polys;

  /// origins_of(place) lists the verts of m of which a place was made.
  template<class OriginsOf>
  level_embedder(const M& m, const Crossed& crossed, double level, const embedding_lists& lists,
                 const std::vector<level_place>& places, const OriginsOf& origins_of)
      : crossed_(crossed), level_(level), lists_(lists), places_(places) {
    polys_.reserve(lists.old_polys.size()), verts_.reserve(lists.verts.size()), points_.reserve(lists.places.size());
    for (const std::uint32_t p : lists.old_polys) polys_.push_back(crossed.polys[p]);
    for (const std::uint32_t v : lists.verts) verts_.push_back(crossed.verts[v]);
    for (const std::uint32_t place : lists.places) {
      const level_place& x = places[place];
      const double t = x.kind == level_place::vert
                           ? 1
                           : crossing_parameter(crossed.arrays.values[x.below], crossed.arrays.values[x.above], level);
      points_.push_back(crossing_point(crossed.arrays.points[x.below], crossed.arrays.points[x.above], t));
      const auto origins = origins_of(x);
      from_.verts.add(std::span<const origin>(origins));
    }
    std::vector<std::uint32_t> old_polys;
    old_polys.reserve(lists.origins.size());
    for (const std::uint32_t old : lists.origins)
      old_polys.push_back(static_cast<std::uint32_t>(index_of(m, polys_[old])));
    from_.polys = element_origins(std::move(old_polys));
    new_verts.resize(points_.size());
    new_polys.resize(lists.origins.size());
    std::size_t most = 0;
    for (std::size_t i = 0; i < lists.cut_ends.size(); ++i)
      most = std::max<std::size_t>(most, lists.cut_ends[i] - (i == 0 ? 0 : lists.cut_ends[i - 1]));
    corners_.reserve(most);
  }

  /// Replaces the polys, and sets u at new verts and at those that are snapped.
  template<class U>
  void run(M& m, U& u, const std::vector<vert_t<M>>& snapped, const char* caller) {
    const cavity<M> c{span(polys_),      span(verts_),           span(points_), span(lists_.corners),
                      span(lists_.ends), span(lists_.poly_ends), polys_.size(), 0};
    if (const permission p = can_replace_polys(m, c); !p) core::throw_joined<unsupported>({caller, ": ", p.why});
    if (!points_.empty()) make_room_for_verts(m, u, points_.size());
    replace_polys(m, c, cavity_result<M>{new_verts.data(), new_polys.data()}, from_, snapped, [&] {
      for (std::size_t i = 0; i < new_verts.size(); ++i) {
        const level_place& x = places_[lists_.places[i]];
        u[new_verts[i]] = x.kind == level_place::vert ? crossed_.arrays.values[x.above] : level_;
      }
      for (const vert_t<M>& v : snapped) u[v] = level_;
    });
  }

  vert_t<M> vert_at(std::uint32_t place) const {
    const std::uint32_t n = lists_.number_of_place[place];
    return n != ~0u ? new_verts[n] : crossed_.verts[places_[place].above];
  }
  /// Calls f(verts) for each edge or face on the level set.
  template<class F>
  void for_each_cut(const F& f) {
    std::size_t k = 0;
    for (std::size_t i = 0; i < lists_.cut_ends.size(); ++i) {
      corners_.clear();
      for (; k < lists_.cut_ends[i]; ++k) corners_.push_back(vert_at(lists_.cut_places[k]));
      f(corners_);
    }
  }
};

}  // namespace concino::detail
