// The values of named properties follow the merging and splitting of verts. They are found before the edit, by the rule of each property, and written
// after it, which needs no memory.
#pragma once

#include <concino/edit/detail/relabelled_cavity.hpp>
#include <concino/edit/detail/saved_edit.hpp>
#include <concino/mesh/carried_values.hpp>

#include <map>
#include <vector>

namespace concino::detail {

/// A vert that has other values afterwards, and where these come from.
struct relabelled_vert {
  unsigned label;
  std::vector<origin> from, of_sums;
};

template<class M>
class relabelled_values {
  static constexpr std::size_t nowhere = ~std::size_t{0};

  struct part {
    unsigned number = 0;
    std::vector<origin> from;
    std::size_t stays_at = nowhere;  // the index of one that polys outside the cavity have too
    bool is_written = false;
  };
  /// Edges or faces, by the sorted labels of their verts.
  struct parts {
    element_kind kind;
    std::map<std::vector<unsigned>, part> by_verts;
    std::vector<std::size_t> old;
  };

  relabelled_cavity<M>& c_;
  const std::vector<relabelled_vert>& verts_;
  parts edges_{element_kind::edge, {}, {}}, faces_{element_kind::face, {}, {}};
  std::vector<std::size_t> poly_index_, corner_index_;  // before
  std::vector<std::pair<std::size_t, unsigned>> new_verts_;  // index and label, sorted
  std::vector<unsigned> corner_labels_, first_corner_{0};    // of the survivors
  std::vector<unsigned> key_;
  carried_values values_;

  /// The edge or face with the labels key_ comes from the one with this index.
  part* add_origin(parts& all, std::size_t index) {
    std::sort(key_.begin(), key_.end());
    key_.erase(std::unique(key_.begin(), key_.end()), key_.end());
    if (key_.size() < (all.kind == element_kind::edge ? 2u : 3u)) return nullptr;
    part& x = all.by_verts[key_];
    const origin one{static_cast<std::uint32_t>(index)};
    if (std::find(x.from.begin(), x.from.end(), one) == x.from.end()) x.from.push_back(one);
    return &x;
  }
  /// The same for one that remains where it is, if polys outside the cavity have it.
  template<class Verts, class Polys>
  void add_itself(parts& all, std::size_t index, const Verts& its_verts, const Polys& its_polys) {
    bool stays = false;
    for (const poly_t<M> p : its_polys) stays = stays || !c_.has(p);
    if (!stays) return;
    key_.clear();
    for (const vert_t<M> v : its_verts) key_.push_back(c_.find_number(index_of(c_.mesh(), v)));
    part& x = *add_origin(all, index);
    x.stays_at = index;
    std::iter_swap(x.from.begin(), std::find(x.from.begin(), x.from.end(), origin{static_cast<std::uint32_t>(index)}));  // a copy takes the first value
  }
  /// Edge or face x of the selected poly becomes the one with the labels of its verts.
  template<class X, class Verts, class Polys>
  void add_part(parts& all, const X& x, const Verts& its_verts, const Polys& its_polys) {
    const std::size_t index = index_of(c_.mesh(), x);
    all.old.push_back(index);
    key_.clear();
    for (const vert_t<M> v : its_verts) key_.push_back(c_.label_of(v));
    add_origin(all, index);
    add_itself(all, index, its_verts, its_polys);
  }
  /// An edge or face at a vert that remains, which others may become.
  template<class X, class Verts, class Polys>
  void add_if_met(parts& all, const X& x, const Verts& its_verts, const Polys& its_polys) {
    key_.clear();
    for (const vert_t<M> v : its_verts) key_.push_back(c_.find_number(index_of(c_.mesh(), v)));
    std::sort(key_.begin(), key_.end());
    if (all.by_verts.find(key_) == all.by_verts.end()) return;
    all.old.push_back(index_of(c_.mesh(), x));
    add_itself(all, index_of(c_.mesh(), x), its_verts, its_polys);
  }

  void find_parts(bool wants_edges, bool wants_faces) {
    const M& m = c_.mesh();
    for (unsigned k = 0; k < c_.polys().size(); ++k) {
      c_.select(k);
      if (wants_edges)
        for (const edge_t<M> e : adj_p2e(m, c_.polys()[k])) add_part(edges_, e, adj_e2v(m, e), adj_e2p(m, e));
      if constexpr (VolumeMesh<M>)  // surfaces have no faces
        if (wants_faces)
          for (const face_t<M> f : adj_p2f(m, c_.polys()[k])) add_part(faces_, f, adj_f2v(m, f), adj_f2p(m, f));
    }
    for (const relabelled_vert& x : verts_) {
      if (c_.num_removed() == 0) break;
      const vert_t<M> v = c_.vert_at(x.label);
      if (wants_edges)
        for (const edge_t<M> e : adj_v2e(m, v)) add_if_met(edges_, e, adj_e2v(m, e), adj_e2p(m, e));
      if constexpr (VolumeMesh<M>)  // surfaces have no faces
        if (wants_faces)
          for (const face_t<M> f : adj_v2f(m, v)) add_if_met(faces_, f, adj_f2v(m, f), adj_f2p(m, f));
    }
  }
  static element_origins origins_of_parts(parts& all) {
    element_origins origins;
    for (auto& [key, x] : all.by_verts) {
      x.number = static_cast<unsigned>(origins.size());
      origins.add(std::span<const origin>(x.from));
    }
    return origins;
  }

  /// Corners of survivors, each label once.
  void find_corners(element_origins& origins) {
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
        origins.add(std::span<const origin>(from));
        corner_labels_.push_back(labels[i]);
      }
      first_corner_.push_back(static_cast<unsigned>(corner_labels_.size()));
    }
    for (const poly_t<M>& p : c_.polys())
      for (std::size_t n = num_elements(adj_p2v(m, p)), i = traits<M>::first_corner(m, p); n > 0; --n) corner_index_.push_back(i++);
  }
  /// Polys that vanish add their sums to the survivor with which they share most verts.
  void find_polys(correspondence& origins, correspondence& of_sums) {
    for (const poly_t<M>& p : c_.polys()) poly_index_.push_back(index_of(c_.mesh(), p));
    std::vector<std::vector<origin>> lists;
    for (const unsigned k : c_.survivors()) {
      origins.polys.add(static_cast<std::uint32_t>(poly_index_[k]));
      lists.push_back({{static_cast<std::uint32_t>(poly_index_[k])}});
    }
    for (const unsigned k : c_.degenerate()) {
      std::size_t to = 0, most = 0;
      for (std::size_t i = 0; i < lists.size(); ++i) {
        std::size_t common = 0;
        const id_span<unsigned> its_labels = c_.labels(c_.survivors()[i]);
        for (const unsigned x : c_.labels(k)) common += std::find(its_labels.begin(), its_labels.end(), x) != its_labels.end();
        if (common > most) most = common, to = i;
      }
      if (!lists.empty()) lists[to].push_back({static_cast<std::uint32_t>(poly_index_[k])});
    }
    for (const auto& list : lists) of_sums.polys.add(std::span<const origin>(list));
  }

  carried_values find() {
    const property_set& all = traits<M>::properties(c_.mesh());
    correspondence origins, of_sums;
    for (const relabelled_vert& x : verts_) origins.verts.add(std::span<const origin>(x.from)), of_sums.verts.add(std::span<const origin>(x.of_sums));
    if (all.has(element_kind::poly)) find_polys(origins, of_sums);
    if (all.has(element_kind::corner)) find_corners(origins.corners), of_sums.corners = origins.corners;
    find_parts(all.has(element_kind::edge), all.has(element_kind::face));
    of_sums.edges = origins.edges = origins_of_parts(edges_);
    of_sums.faces = origins.faces = origins_of_parts(faces_);
    new_verts_.resize(c_.new_verts.size());
    key_.reserve(corner_bound());
    return carried_values(all, origins, of_sums);
  }
  /// A bound for the verts of a face.
  std::size_t corner_bound() const {
    std::size_t n = 2;
    for (unsigned k = 0; k < c_.polys().size(); ++k) n = std::max<std::size_t>(n, c_.labels(k).size());
    return n;
  }

  std::size_t index_at(unsigned label) const { return index_of(c_.mesh(), label < c_.new_label ? c_.vert_at(label) : c_.new_verts[label - c_.new_label]); }
  unsigned label_after(std::size_t index) const {
    if (const unsigned i = c_.find_number(index); i != core::local_numbers::none) return i;
    return std::lower_bound(new_verts_.begin(), new_verts_.end(), std::pair{index, 0u})->second;
  }
  template<class Verts>
  void write_part(parts& all, std::size_t index, const Verts& its_verts) {
    key_.clear();
    for (const vert_t<M> v : its_verts) key_.push_back(label_after(index_of(c_.mesh(), v)));
    std::sort(key_.begin(), key_.end());
    const auto at = all.by_verts.find(key_);
    if (at != all.by_verts.end()) write_part(all, at->second, index);
  }
  void write_part(parts& all, part& x, std::size_t index) {
    if (!std::exchange(x.is_written, true)) values_.write(all.kind, x.number, index);  // a value can be moved once only
  }

 public:
  /// `verts` exist as long as this.
  relabelled_values(relabelled_cavity<M>& c, const std::vector<relabelled_vert>& verts) : c_(c), verts_(verts), values_(find()) {}

  /// Calls f(kind, index) for every element of the mesh before whose values write() may replace.
  template<class F>
  void for_each_replaced(const F& f) const {
    for (const relabelled_vert& x : verts_)
      if (x.label < c_.new_label) f(element_kind::vert, index_at(x.label));
    for (const std::size_t i : poly_index_) f(element_kind::poly, i);
    for (const std::size_t i : corner_index_) f(element_kind::corner, i);
    for (const std::size_t i : edges_.old) f(element_kind::edge, i);
    for (const std::size_t i : faces_.old) f(element_kind::face, i);
  }

  /// After the edit.
  void write(const M& m) noexcept {
    for (unsigned j = 0; j < new_verts_.size(); ++j) new_verts_[j] = {index_of(m, c_.new_verts[j]), c_.new_label + j};
    std::sort(new_verts_.begin(), new_verts_.end());
    for (std::size_t i = 0; i < verts_.size(); ++i) values_.write(element_kind::vert, i, index_at(verts_[i].label));
    for (parts* const all : {&edges_, &faces_})
      for (auto& [key, x] : all->by_verts)
        if (x.stays_at != nowhere) write_part(*all, x, x.stays_at);
    for (std::size_t k = 0; k < c_.new_polys.size(); ++k) {
      const poly_t<M>& p = c_.new_polys[k];
      if (!poly_index_.empty()) values_.write(element_kind::poly, k, index_of(m, p));
      if (!corner_labels_.empty()) {
        std::size_t corner = traits<M>::first_corner(m, p);
        const auto first = corner_labels_.begin() + first_corner_[k], last = corner_labels_.begin() + first_corner_[k + 1];
        for (const vert_t<M> v : adj_p2v(m, p))
          values_.write(element_kind::corner, static_cast<std::size_t>(std::find(first, last, label_after(index_of(m, v))) - corner_labels_.begin()), corner++);
      }
      if (!edges_.by_verts.empty())
        for (const edge_t<M> e : adj_p2e(m, p)) write_part(edges_, index_of(m, e), adj_e2v(m, e));
      if constexpr (VolumeMesh<M>)  // surfaces have no faces
        if (!faces_.by_verts.empty())
          for (const face_t<M> f : adj_p2f(m, p)) write_part(faces_, index_of(m, f), adj_f2v(m, f));
    }
  }
};

/// Calls replace(), which calls c.apply(m). Named properties follow; `verts` are those that have other values afterwards.
template<class M, class Replace>
void apply_relabelling(M& m, relabelled_cavity<M>& c, const std::vector<relabelled_vert>& verts, const Replace& replace) {
  if constexpr (carries_values<M>)
    if (traits<M>::properties(m).size() > 0) {
      relabelled_values<M> values(c, verts);
      replace_saved(m, [&](const auto& save) { values.for_each_replaced(save); }, replace);
      return values.write(m);
    }
  replace_saved(m, [](const auto&) {}, replace);
}

}  // namespace concino::detail
