// relabelled_origins: from which elements those come that merging and splitting of verts makes or changes, for the
// values of named properties (edit_values.hpp).
#pragma once

#include <concino/edit/detail/edit_values.hpp>
#include <concino/edit/detail/relabelled_cavity.hpp>
#include <concino/edit/detail/saved_edit.hpp>

#include <map>
#include <vector>

namespace concino::detail {

/// A vert that has other values afterwards, and where these come from.
struct relabelled_vert {
  unsigned label;
  std::vector<origin> from, of_sums;
};

template<class M>
class relabelled_origins {
  struct edge_or_face {
    std::vector<origin> from;
    std::size_t stays_at = edit_values<M>::nowhere;  // the index of one that polys outside the cavity have too
  };
  /// Edges or faces, by the sorted labels of their verts.
  struct edges_or_faces {
    element_kind kind;
    std::map<std::vector<unsigned>, edge_or_face> by_verts = {};
  };

  relabelled_cavity<M>& c_;
  const std::vector<relabelled_vert>& verts_;
  edit_values<M>& to_;
  edges_or_faces edges_{element_kind::edge}, faces_{element_kind::face};
  std::vector<unsigned> key_;

  /// The edge or face with the labels key_ comes from the one with this index.
  edge_or_face* add_origin(edges_or_faces& all, std::size_t index) {
    std::sort(key_.begin(), key_.end());
    key_.erase(std::unique(key_.begin(), key_.end()), key_.end());
    if (key_.size() < (all.kind == element_kind::edge ? 2u : 3u)) return nullptr;
    edge_or_face& x = all.by_verts[key_];
    const origin one{static_cast<std::uint32_t>(index)};
    if (std::find(x.from.begin(), x.from.end(), one) == x.from.end()) x.from.push_back(one);
    return &x;
  }
  /// The same for one that remains where it is, if polys outside the cavity have it.
  template<class Verts, class Polys>
  void add_itself(edges_or_faces& all, std::size_t index, const Verts& its_verts, const Polys& its_polys) {
    bool stays = false;
    for (const poly_t<M> p : its_polys) stays = stays || !c_.has(p);
    if (!stays) return;
    key_.clear();
    for (const vert_t<M> v : its_verts) key_.push_back(c_.find_number(index_of(c_.mesh(), v)));
    edge_or_face& x = *add_origin(all, index);
    x.stays_at = index;
    // a copy takes the first value
    std::iter_swap(x.from.begin(), std::find(x.from.begin(), x.from.end(), origin{static_cast<std::uint32_t>(index)}));
  }
  /// Edge or face x of the selected poly becomes the one with the labels of its verts.
  template<class X, class Verts, class Polys>
  void add_selected(edges_or_faces& all, const X& x, const Verts& its_verts, const Polys& its_polys) {
    const std::size_t index = index_of(c_.mesh(), x);
    to_.replaces(all.kind, index);
    key_.clear();
    for (const vert_t<M> v : its_verts) key_.push_back(c_.label_of(v));
    add_origin(all, index);
    add_itself(all, index, its_verts, its_polys);
  }
  /// An edge or face at a vert that remains, which others may become.
  template<class X, class Verts, class Polys>
  void add_remaining(edges_or_faces& all, const X& x, const Verts& its_verts, const Polys& its_polys) {
    key_.clear();
    for (const vert_t<M> v : its_verts) key_.push_back(c_.find_number(index_of(c_.mesh(), v)));
    std::sort(key_.begin(), key_.end());
    if (all.by_verts.find(key_) == all.by_verts.end()) return;
    to_.replaces(all.kind, index_of(c_.mesh(), x));
    add_itself(all, index_of(c_.mesh(), x), its_verts, its_polys);
  }

  void find_edges_and_faces(bool wants_edges, bool wants_faces) {
    const M& m = c_.mesh();
    for (unsigned k = 0; k < c_.polys().size(); ++k) {
      c_.select(k);
      if (wants_edges)
        for (const edge_t<M> e : adj_p2e(m, c_.polys()[k])) add_selected(edges_, e, adj_e2v(m, e), adj_e2p(m, e));
      if constexpr (VolumeMesh<M>)  // surfaces have no faces
        if (wants_faces)
          for (const face_t<M> f : adj_p2f(m, c_.polys()[k])) add_selected(faces_, f, adj_f2v(m, f), adj_f2p(m, f));
    }
    for (const relabelled_vert& x : verts_) {
      if (c_.num_removed() == 0) break;
      const vert_t<M> v = c_.vert_at(x.label);
      if (wants_edges)
        for (const edge_t<M> e : adj_v2e(m, v)) add_remaining(edges_, e, adj_e2v(m, e), adj_e2p(m, e));
      if constexpr (VolumeMesh<M>)  // surfaces have no faces
        if (wants_faces)
          for (const face_t<M> f : adj_v2f(m, v)) add_remaining(faces_, f, adj_f2v(m, f), adj_f2p(m, f));
    }
  }
  void add_edges_or_faces(const edges_or_faces& all) {
    for (const auto& [key, x] : all.by_verts) to_.add_edge_or_face(all.kind, key, x.from, x.from, x.stays_at);
  }

  /// Corners of survivors, each label once.
  void add_corners() {
    const M& m = c_.mesh();
    std::vector<origin> from;
    for (const unsigned k : c_.survivors()) {
      const id_span<unsigned> labels = c_.labels(k);
      const auto first = static_cast<std::uint32_t>(traits<M>::first_corner(m, c_.polys()[k]));
      for (unsigned i = 0; i < labels.size(); ++i) {
        if (std::find(labels.begin(), labels.begin() + i, labels[i]) != labels.begin() + i) continue;
        from.clear();
        for (unsigned j = i; j < labels.size(); ++j)
          if (labels[j] == labels[i]) from.push_back({first + j});
        to_.add_corner(labels[i], from);
      }
      to_.end_corners();
    }
    for (const poly_t<M>& p : c_.polys())
      for (std::size_t n = num_elements(adj_p2v(m, p)), i = traits<M>::first_corner(m, p); n > 0; --n)
        to_.replaces(element_kind::corner, i++);
  }
  /// Polys that vanish add their sums to the survivor with which they share most verts.
  void add_polys() {
    const auto index = [this](unsigned k) { return static_cast<std::uint32_t>(index_of(c_.mesh(), c_.polys()[k])); };
    for (unsigned k = 0; k < c_.polys().size(); ++k) to_.replaces(element_kind::poly, index(k));
    std::vector<std::vector<origin>> lists;
    for (const unsigned k : c_.survivors()) lists.push_back({{index(k)}});
    for (const unsigned k : c_.degenerate()) {
      std::size_t to = 0, most = 0;
      for (std::size_t i = 0; i < lists.size(); ++i) {
        std::size_t common = 0;
        const id_span<unsigned> its_labels = c_.labels(c_.survivors()[i]);
        for (const unsigned x : c_.labels(k))
          common += std::find(its_labels.begin(), its_labels.end(), x) != its_labels.end();
        if (common > most) most = common, to = i;
      }
      if (!lists.empty()) lists[to].push_back({index(k)});
    }
    for (const auto& list : lists) to_.add_poly({list.data(), 1}, list);
  }

 public:
  relabelled_origins(relabelled_cavity<M>& c, const std::vector<relabelled_vert>& verts, edit_values<M>& to)
      : c_(c), verts_(verts), to_(to) {}

  void add(const property_set& all) {
    for (const relabelled_vert& x : verts_) to_.add_vert(x.label, x.from, x.of_sums);
    if (all.has(element_kind::poly)) add_polys();
    if (all.has(element_kind::corner)) add_corners();
    find_edges_and_faces(all.has(element_kind::edge), all.has(element_kind::face));
    add_edges_or_faces(edges_), add_edges_or_faces(faces_);
  }
};

/// Calls replace(), which calls c.apply(m). Named properties follow; `verts` are those that have other values
/// afterwards.
template<class M, class Replace>
void apply_relabelling(M& m, relabelled_cavity<M>& c, const std::vector<relabelled_vert>& verts,
                       const Replace& replace) {
  if constexpr (carries_values<M>)
    if (traits<M>::properties(m).size() > 0) {
      std::vector<vert_t<M>> existing;
      for (unsigned i = 0; i < c.num_verts(); ++i) existing.push_back(c.vert_at(i));
      edit_values<M> values(m, existing, c.new_label, c.new_verts.size());
      relabelled_origins<M>(c, verts, values).add(traits<M>::properties(m));
      values.find(traits<M>::properties(m));
      replace_saved(m, [&](const auto& save) { values.for_each_replaced(save); }, replace);
      return values.write(m, c.new_verts.data(), c.new_polys);
    }
  replace_saved(m, [](const auto&) {}, replace);
}

}  // namespace concino::detail
