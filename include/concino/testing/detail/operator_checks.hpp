// Edits edges of a mesh by its own operators and by `rewire`, and checks law ED6: both make the same mesh.
#pragma once

#include <concino/edit/edge_collapse.hpp>
#include <concino/edit/edge_flip.hpp>
#include <concino/edit/edge_split.hpp>
#include <concino/testing/detail/rewire_checks.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace concino::testing::detail {

template<class M>
concept has_own_operators = EditableMesh<M> &&
    (concino::detail::splits_edges<M> || concino::detail::flips_edges<M> || concino::detail::collapses_edges<M>);

/// Whether both meshes have the same descriptors, points and polys; each difference breaks ED6.
template<class M>
bool are_alike(const M& own, const described_mesh<M>& expected, const std::string& operation, const edge_t<M>& e,
               concino::detail::law_log& log) {
  concino::detail::law_log differences;
  compare(expected, describe(own), differences);
  for (const broken_law& b : differences.take())
    log.add("ED6",
            core::joined({operation, " of ", name('e', index_of(own, e)),
                          " does not leave the mesh that rewire leaves: ", b.what}),
            b.witness);
  return log.empty();
}

/// Edits the n-th edge of a mesh in both ways. own(m, e, x): whether the mesh did it itself; by_rewire(m, e, x):
/// whether rewire did.
template<class M, class Make, class Own, class ByRewire>
void check_operator(const Make& make, std::size_t n, const char* operation, const Own& own, const ByRewire& by_rewire,
                    concino::detail::law_log& log) {
  M direct = make(), expected = make();
  const auto nth = [n](const M& m) {
    std::vector<edge_t<M>> all;
    for (const edge_t<M> e : edges(m)) all.push_back(e);
    return all[n];
  };
  const edge_t<M> e = nth(direct);
  const auto ends = end_verts(direct, e);
  const vec3 x =
      concino::detail::point_between(to_vec3(point(direct, ends.first)), to_vec3(point(direct, ends.second)), 0.5);
  if (!own(direct, e, x)) {
    are_alike(direct, describe(expected), core::joined({operation, ", which says that it did nothing,"}), e, log);
  } else if (!by_rewire(expected, nth(expected), x)) {
    log.add("ED6", core::joined({operation, " edits ", name('e', n), ", although the edit is not possible"}),
            name('e', n));
  } else {
    are_alike(direct, describe(expected), operation, e, log);
  }
}

/// Edits some edges by each operator that the mesh has. The last edit is made in m, too.
template<class M, class Make>
void check_own_operators(M& m, const Make& make, concino::detail::law_log& log) {
  using concino::detail::cavity_builder;
  const std::size_t n = num_edges(m), step = n / 24 + 1;
  for (std::size_t i = 0; i < n && log.empty(); i += step) {
    if constexpr (concino::detail::splits_edges<M>) {
      const auto split = [](M& x, const edge_t<M>& e, const vec3& at) {
        return traits<M>::split_edge(x, e, at).has_value();
      };
      const auto by_rewire = [](M& x, const edge_t<M>& e, const vec3&) {
        cavity_builder<M> c(x);
        const permission p = concino::detail::edge_split_cavity(x, e, 0.5, c);
        if (p) c.apply(x);
        return bool(p);
      };
      check_operator<M>(make, i, "split_edge", split, by_rewire, log);
    }
    if constexpr (concino::detail::flips_edges<M>) {
      const auto flip = [](M& x, const edge_t<M>& e, const vec3&) { return traits<M>::flip_edge(x, e); };
      const auto by_rewire = [](M& x, const edge_t<M>& e, const vec3&) {
        return bool(concino::detail::flip_facet(x, e, {}));
      };
      check_operator<M>(make, i, "flip_edge", flip, by_rewire, log);
    }
    if constexpr (concino::detail::collapses_edges<M>) {
      const auto collapse = [](M& x, const edge_t<M>& e, const vec3& at) { return traits<M>::collapse_edge(x, e, at); };
      const auto by_rewire = [](M& x, const edge_t<M>& e, const vec3& at) {
        cavity_builder<M> c(x);
        const permission p = concino::detail::edge_collapse_cavity(x, e, {.point = at}, c);
        if (p) c.apply(x);
        return bool(p);
      };
      check_operator<M>(make, i, "collapse_edge", collapse, by_rewire, log);
    }
  }
  if constexpr (requirement::can_split_edges<M>)
    for (const edge_t<M> e : edges(m))
      if (edge_split(m, e)) return;
}

}  // namespace concino::testing::detail
