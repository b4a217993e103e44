// Replaces polys by themselves with other verts at some corners, in meshes of all kinds: merging and splitting of
// verts.
#pragma once

#include <concino/concepts/editable.hpp>
#include <concino/core/local_numbers.hpp>
#include <concino/core/vec3.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace concino::detail {

/// Verts have local numbers: first those that are removed, then others in the order in which they are met. Corners have
/// labels, the numbers of their verts afterwards. Polys that become degenerate are removed.
template<class M>
class relabelled_cavity {
  const M& m_;
  core::local_numbers numbers_, poly_numbers_;
  std::vector<vert_t<M>> verts_;
  std::vector<poly_t<M>> polys_;
  std::vector<unsigned> old_corners_, labels_, first_corner_{0};  // of the polys, in the order of adj_p2v
  std::vector<unsigned> survivors_, degenerate_;                  // numbers of polys
  std::vector<poly_t<M>> replaced_;                               // survivors, then degenerate ones
  std::vector<unsigned> corners_, ends_, poly_ends_;              // of the survivors, for `rewire`
  std::vector<vert_t<M>> verts_of_cavity_;
  std::vector<vec3> points_;
  std::vector<unsigned> label_of_, last_poly_;  // by number of a vert: its label in the selected poly, and the last
                                                // list of corners that has it
  unsigned num_removed_ = 0, num_lists_ = 0;

  template<class T>
  static id_span<T> span(const std::vector<T>& v) { return {v.data(), v.data() + v.size()}; }

  bool has_repeated(std::size_t first) {
    ++num_lists_;
    for (std::size_t i = first; i < corners_.size(); ++i)
      if (corners_[i] < new_label && std::exchange(last_poly_[corners_[i]], num_lists_) == num_lists_) return true;
    return false;
  }
  /// Removes corners that repeat the one before them, from `first` on.
  void remove_repeated_neighbours(std::size_t first) {
    const auto begin = corners_.begin() + static_cast<std::ptrdiff_t>(first);
    corners_.erase(std::unique(begin, corners_.end()), corners_.end());
    while (corners_.size() > first + 1 && corners_.back() == corners_[first]) corners_.pop_back();
  }
  void end_list() { ends_.push_back(static_cast<unsigned>(corners_.size())); }

  /// Adds poly k to the lists for `rewire`, unless it is degenerate.
  bool add_new(unsigned k)
    requires(SurfaceMesh<M>)
  {
    const std::size_t first = corners_.size();
    for (unsigned i = first_corner_[k]; i < first_corner_[k + 1]; ++i) corners_.push_back(labels_[i]);
    if (arity_v<M> == 0) remove_repeated_neighbours(first);
    if (corners_.size() < first + 3 || has_repeated(first)) return corners_.resize(first), false;
    end_list();
    return true;
  }
  bool add_new(unsigned k)
    requires(VolumeMesh<M> && arity_v<M> > 0)
  {
    const std::size_t first = corners_.size();
    for (unsigned i = first_corner_[k]; i < first_corner_[k + 1]; ++i) corners_.push_back(labels_[i]);
    if (has_repeated(first)) return corners_.resize(first), false;
    end_list();
    return true;
  }
  /// Faces that keep fewer than three verts vanish. The others must be different, and make a polyhedron of the same
  /// Euler characteristic.
  bool add_new(unsigned k)
    requires(VolumeMesh<M> && arity_v<M> == 0)
  {
    const std::size_t first = corners_.size(), first_list = ends_.size();
    const auto undo = [&] { return corners_.resize(first), ends_.resize(first_list), false; };
    select(k);
    for (const face_t<M> f : adj_p2f(m_, polys_[k])) {
      const std::size_t begin = corners_.size();
      for (const vert_t<M> v : adj_f2v(m_, f)) corners_.push_back(label_of(v));
      remove_repeated_neighbours(begin);
      if (corners_.size() < begin + 3) {
        corners_.resize(begin);
        continue;
      }
      if (has_repeated(begin)) return undo();
      if (face_is_outward(m_, polys_[k], f)) end_list();
      else std::reverse(corners_.begin() + static_cast<std::ptrdiff_t>(begin), corners_.end()), end_list();
    }
    if (is_degenerate_polyhedron(k, first, first_list)) return undo();
    poly_ends_.push_back(static_cast<unsigned>(ends_.size()));
    return true;
  }
  /// Whether poly k, with the faces in the lists from `first_list` on, has few or repeated ones, or another Euler
  /// characteristic than before.
  bool is_degenerate_polyhedron(unsigned k, std::size_t first, std::size_t first_list) const {
    if (num_removed_ == 0) return false;
    std::vector<unsigned> verts(corners_.begin() + static_cast<std::ptrdiff_t>(first), corners_.end());
    std::vector<std::pair<unsigned, unsigned>> edges;
    std::vector<std::vector<unsigned>> faces;
    for (std::size_t list = first_list, i = first; list < ends_.size(); ++list) {
      const std::size_t begin = i;
      for (; i < ends_[list]; ++i)
        edges.push_back(std::minmax(corners_[i], corners_[i + 1 == ends_[list] ? begin : i + 1]));
      faces.emplace_back(corners_.begin() + static_cast<std::ptrdiff_t>(begin),
                         corners_.begin() + static_cast<std::ptrdiff_t>(i));
      std::sort(faces.back().begin(), faces.back().end());
    }
    const auto num_different = [](auto& all) {
      std::sort(all.begin(), all.end());
      return static_cast<std::ptrdiff_t>(std::unique(all.begin(), all.end()) - all.begin());
    };
    const auto count = [](const auto& range) { return static_cast<std::ptrdiff_t>(num_elements(range)); };
    const auto n = static_cast<std::ptrdiff_t>(faces.size());
    const std::ptrdiff_t faces_before = count(adj_p2f(m_, polys_[k]));
    if (n < std::min<std::ptrdiff_t>(4, faces_before) || num_different(faces) < n) return true;
    return num_different(verts) - num_different(edges) + n !=
           count(adj_p2v(m_, polys_[k])) - count(adj_p2e(m_, polys_[k])) + faces_before;
  }

 public:
  static constexpr unsigned new_label = 1u << 31;  // new_label + j is the label of the j-th new vert

  explicit relabelled_cavity(const M& m) : m_(m) {}

  const M& mesh() const { return m_; }
  unsigned number(const vert_t<M>& v) {
    const unsigned i = numbers_.add(index_of(m_, v));
    if (i == verts_.size()) verts_.push_back(v);
    return i;
  }
  unsigned find_number(std::size_t index) const { return numbers_.find(index); }
  unsigned num_verts() const { return static_cast<unsigned>(verts_.size()); }
  const vert_t<M>& vert_at(unsigned i) const { return verts_[i]; }
  /// The verts so far will be removed.
  void end_removed() { num_removed_ = num_verts(); }
  unsigned num_removed() const { return num_removed_; }

  bool has(const poly_t<M>& p) const { return poly_numbers_.find(index_of(m_, p)) != poly_numbers_.none; }
  /// Adds p if it is not there, with the labels that its verts have. Returns its number.
  unsigned add(const poly_t<M>& p) {
    const unsigned k = poly_numbers_.add(index_of(m_, p));
    if (k < polys_.size()) return k;
    polys_.push_back(p);
    for (const vert_t<M> v : adj_p2v(m_, p)) old_corners_.push_back(number(v));
    labels_.insert(labels_.end(), old_corners_.begin() + first_corner_.back(), old_corners_.end());
    first_corner_.push_back(static_cast<unsigned>(labels_.size()));
    return k;
  }
  void set_label(unsigned k, unsigned vert, unsigned label) {
    for (unsigned i = first_corner_[k]; i < first_corner_[k + 1]; ++i)
      if (old_corners_[i] == vert) labels_[i] = label;
  }
  /// Adds a new vert at the point of v. Returns its label.
  unsigned add_vert(const vert_t<M>& v) {
    points_.push_back(to_vec3(point(m_, v)));
    return new_label + static_cast<unsigned>(points_.size() - 1);
  }

  /// Finds the new polys. Returns whether none is degenerate.
  bool build() {
    label_of_.resize(verts_.size());
    last_poly_.resize(verts_.size());
    for (unsigned k = 0; k < polys_.size(); ++k) (add_new(k) ? survivors_ : degenerate_).push_back(k);
    return degenerate_.empty();
  }

  const std::vector<poly_t<M>>& polys() const { return polys_; }
  const std::vector<unsigned>& survivors() const { return survivors_; }
  const std::vector<unsigned>& degenerate() const { return degenerate_; }
  /// The labels of the corners of poly k, in the order that adj_p2v has before.
  id_span<unsigned> labels(unsigned k) const {
    return {labels_.data() + first_corner_[k], labels_.data() + first_corner_[k + 1]};
  }
  /// label_of(v) is about poly k from now on.
  void select(unsigned k) {
    for (unsigned i = first_corner_[k]; i < first_corner_[k + 1]; ++i) label_of_[old_corners_[i]] = labels_[i];
  }
  unsigned label_of(const vert_t<M>& v) const { return label_of_[numbers_.find(index_of(m_, v))]; }

  /// Makes the lists, and allocates the memory that apply() needs.
  void prepare() {
    for (const unsigned k : survivors_) replaced_.push_back(polys_[k]);
    for (const unsigned k : degenerate_) replaced_.push_back(polys_[k]);
    verts_of_cavity_.assign(verts_.begin() + num_removed_, verts_.end());
    const auto num_kept = static_cast<unsigned>(verts_of_cavity_.size());
    verts_of_cavity_.insert(verts_of_cavity_.end(), verts_.begin(), verts_.begin() + num_removed_);
    for (unsigned& i : corners_) i = i < new_label ? i - num_removed_ : num_kept + num_removed_ + (i - new_label);
    new_verts.resize(points_.size());
    new_polys.resize(survivors_.size());
  }
  cavity<M> lists() const {
    return {span(replaced_), span(verts_of_cavity_), span(points_),     span(corners_),
            span(ends_),     span(poly_ends_),       survivors_.size(), num_removed_};
  }
  void apply(M& m) { rewire(m, lists(), cavity_result<M>{new_verts.data(), new_polys.data()}); }

  std::vector<vert_t<M>> new_verts;
  std::vector<poly_t<M>> new_polys;  // the survivors
};

}  // namespace concino::detail
