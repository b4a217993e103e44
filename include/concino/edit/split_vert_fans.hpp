// Splits non-manifold verts: afterwards the polys at a vert are connected by facets at it.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/edit/detail/operator_checks.hpp>
#include <concino/edit/detail/relabelled_origins.hpp>

#include <vector>

namespace concino {

/// A vert that split_vert_fans made.
template<class M>
struct vert_of_fan {
  vert_t<M> vert, origin;  // the new vert, and the one that was split
};

namespace detail {

/// The fans at one vert: polys that facets at this vert connect.
template<class M>
class vert_fans {
  core::local_numbers numbers_;
  std::vector<unsigned> fan_of_, stack_;

 public:
  std::vector<poly_t<M>> polys;  // at the vert, in the order of adj_v2p
  unsigned num_fans = 0;

  vert_fans(const M& m, const vert_t<M>& v) {
    for (const poly_t<M> p : adj_v2p(m, v)) polys.push_back(p), numbers_.add(index_of(m, p));
    fan_of_.assign(polys.size(), ~0u);
    for (unsigned k = 0; k < polys.size(); ++k) {
      if (fan_of_[k] != ~0u) continue;
      fan_of_[k] = num_fans;
      stack_.assign(1, k);
      while (!stack_.empty()) {
        const unsigned i = stack_.back();
        stack_.pop_back();
        add_neighbours(m, v, i);
      }
      ++num_fans;
    }
  }
  unsigned fan_of(unsigned k) const { return fan_of_[k]; }

 private:
  void add_neighbours(const M& m, const vert_t<M>& v, unsigned i) {
    for (const facet_t<M> f : adj_p2facet(m, polys[i])) {
      bool is_at_vert = false;
      for (const vert_t<M> x : adj_facet2v(m, f)) is_at_vert = is_at_vert || x == v;
      if (!is_at_vert) continue;
      for (const poly_t<M> p : adj_facet2p(m, f)) {
        const unsigned j = numbers_.find(index_of(m, p));
        if (fan_of_[j] == ~0u) fan_of_[j] = num_fans, stack_.push_back(j);
      }
    }
  }
};

/// The first fan at v keeps it, the others get new verts.
template<class M>
void split_fans_at(const M& m, const vert_t<M>& v, relabelled_cavity<M>& c, std::vector<relabelled_vert>& changed,
                   std::vector<vert_of_fan<M>>& made) {
  const vert_fans<M> fans(m, v);
  if (fans.num_fans < 2) return;
  const auto index = static_cast<std::uint32_t>(index_of(m, v));
  const std::size_t first = changed.size();
  const unsigned number = c.number(v);
  for (unsigned i = 0; i < fans.num_fans; ++i) {
    changed.push_back({i == 0 ? number : c.add_vert(v), {{index}}, {{index, 0}}});
    if (i > 0) made.push_back({vert_t<M>{}, v});
  }
  for (unsigned k = 0; k < fans.polys.size(); ++k) {
    relabelled_vert& x = changed[first + fans.fan_of(k)];
    x.of_sums[0].weight += 1;  // sums are divided by the numbers of polys
    if (fans.fan_of(k) > 0) c.set_label(c.add(fans.polys[k]), number, x.label);
  }
}

template<class M, class Verts>
std::vector<vert_of_fan<M>> split_fans(M& m, const Verts& all) {
  relabelled_cavity<M> c(m);
  std::vector<relabelled_vert> changed;
  std::vector<vert_of_fan<M>> made;
  for (const vert_t<M> v : all) split_fans_at<M>(m, v, c, changed, made);
  if (made.empty()) return made;
  c.build();
  c.prepare();
  apply_relabelling(m, c, changed, [&] { c.apply(m); });
  for (std::size_t i = 0; i < made.size(); ++i) made[i].vert = c.new_verts[i];
  return made;
}

}  // namespace detail

/// Splits v if it is not manifold: each fan of polys at v that edges of a surface, or faces of a volume, at v connect
/// gets a vert of its own, at the same point.
/// Needs:  EditableMesh M, a vert of m.
/// Result: the new verts with v; empty if there is one fan at most. v belongs to the fan of its first poly. Polys keep
///         their descriptors, and edges and faces those that the remaining fan has. The values of properties follow:
///         sums at v are divided by the numbers of polys, others copied.
/// Cost:   the polys at v, and the elements at the verts of the polys of other fans, but O(mesh) the first time.
/// Errors: invalid_mesh if v is not a vert of m. The mesh is unchanged then, also if memory runs out.
template<EditableMesh M>
std::vector<vert_of_fan<M>> split_vert_fans(M& m, vert_t<M> v) {
  detail::check_element(m, v, "split_vert_fans", "vert");
  const vert_t<M> one[] = {v};
  return detail::split_fans(m, one);
}

/// Splits all verts that are not manifold, as above, at once.
/// Needs:  EditableMesh M.
/// Result: the new verts, each with the vert that was split. Edges and faces that several fans shared keep their
///         descriptors in one of these.
/// Cost:   O(elements) time; memory for the polys that change.
/// Errors: none of its own. If memory runs out, the mesh is unchanged.
template<EditableMesh M>
std::vector<vert_of_fan<M>> split_vert_fans(M& m) {
  return detail::split_fans(m, verts(m));
}

}  // namespace concino
