// Carries the named properties of a mesh to the repaired one.
#pragma once

#include <concino/mesh/correspondence.hpp>
#include <concino/mesh/property.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The origins by other numbers: index[number].
inline element_origins renamed(element_origins from, const std::vector<std::uint32_t>& index) {
  std::uint32_t same = 0;
  while (same < index.size() && index[same] == same) ++same;
  if (same == index.size()) return from;
  element_origins result;
  std::vector<origin> all;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::uint32_t only = from.only(i);
    if (from[i].size() == 0) result.add(element_origins::none);
    else if (only != element_origins::none) result.add(index[only]);
    else {
      all.clear();
      for (const origin x : from[i]) all.push_back({index[x.index], x.weight});
      result.add(all);
    }
  }
  return result;
}

/// The origins of the elements of a mesh that is as it was.
inline element_origins origins_of_themselves(const std::vector<std::uint32_t>& indices, std::size_t bound) {
  std::vector<std::uint32_t> single(bound, element_origins::none);
  for (const std::uint32_t i : indices) single[i] = i;
  return element_origins(std::move(single));
}

/// Finds edges and faces before with the verts of those after, where verts may have become one.
class facet_origins {
  std::vector<std::uint32_t> cluster_;  // by index of a vert before

  /// Whether each of `list` is in the cluster of one of `wanted`, which are verts before.
  template<class M, class R>
  bool fits(const M& before, const R& list, std::vector<std::uint32_t>& wanted) const {
    std::size_t n = 0;
    for (const vert_t<M> v : list) {
      const std::uint32_t c = cluster_[index_of(before, v)];
      const auto at = std::find(wanted.begin() + static_cast<std::ptrdiff_t>(n), wanted.end(), c);
      if (at == wanted.end()) return false;
      std::swap(*at, wanted[n++]);
    }
    return n == wanted.size();
  }

 public:
  /// Of a mesh whose verts have these indices and clusters, by number.
  facet_origins(std::size_t bound, const std::vector<std::uint32_t>& cluster,
                const std::vector<std::uint32_t>& vert_index)
      : cluster_(bound) {
    for (std::size_t i = 0; i < cluster.size(); ++i) cluster_[vert_index[i]] = cluster[i];
  }

  /// The origins of elements with the verts of(x) among those that around(v) gives for a vert v before, whose verts are
  /// of_before(y).
  template<class From, class To, class Elements, class Of, class Around, class OfBefore>
  element_origins find(const From& before, const To& m, std::size_t bound, const Elements& all, const Of& of,
                       const Around& around, const OfBefore& of_before, const element_origins& verts_from,
                       const std::vector<vert_t<From>>& vert_before) const {
    std::vector<std::uint32_t> single(bound, element_origins::none), wanted;
    for (const auto x : all) {
      wanted.clear();
      std::uint32_t first = element_origins::none;
      for (const vert_t<To> v : of(x)) {
        const auto from = verts_from[index_of(m, v)];
        if (from.empty()) break;
        if (wanted.empty()) first = static_cast<std::uint32_t>(index_of(m, v));
        wanted.push_back(cluster_[from[0].index]);
      }
      std::size_t n = 0;
      for ([[maybe_unused]] const vert_t<To> v : of(x)) ++n;
      if (n != wanted.size()) continue;
      std::uint32_t& found = single[index_of(m, x)];
      for (const origin v : verts_from[first])
        for (const auto y : around(vert_before[v.index]))
          if (const auto i = static_cast<std::uint32_t>(index_of(before, y)); i < found)
            if (fits(before, of_before(y), wanted)) found = i;
    }
    return element_origins(std::move(single));
  }
};

/// Transfers the properties of `before` to m. cluster and vert_index: by number of a vert before, a number that verts
/// which became one have in common, and its index.
template<class From, class To>
void carry_properties(const From& before, To& m, const correspondence& from, const std::vector<std::uint32_t>& cluster,
                      const std::vector<std::uint32_t>& vert_index) {
  if constexpr (ShowsProperties<From>) {
    const property_set& source = traits<From>::properties(before);
    if (source.size() == 0) return;
    correspondence c = from;
    if (source.has(element_kind::edge) || source.has(element_kind::face)) {
      std::vector<vert_t<From>> vert_before(vert_index_bound(before));
      for (const vert_t<From> v : verts(before)) vert_before[index_of(before, v)] = v;
      const facet_origins finder(vert_before.size(), cluster, vert_index);
      c.edges = finder.find(
          before, m, edge_index_bound(m), edges(m), [&](const auto& e) { return adj_e2v(m, e); },
          [&](const auto& v) { return adj_v2e(before, v); }, [&](const auto& e) { return adj_e2v(before, e); },
          from.verts, vert_before);
      if constexpr (dimension_v<To> == 3)  // surfaces have no faces
        c.faces = finder.find(
            before, m, face_index_bound(m), faces(m), [&](const auto& f) { return adj_f2v(m, f); },
            [&](const auto& v) { return adj_v2f(before, v); }, [&](const auto& f) { return adj_f2v(before, f); },
            from.verts, vert_before);
    }
    transfer_properties(before, m, c);
  }
}

}  // namespace concino::detail
