// Collects the cavity of an edit of simplices: old polys, and new ones that differ from old ones in one vert.
#pragma once

#include <concino/concepts/editable.hpp>
#include <concino/core/error.hpp>
#include <concino/core/local_numbers.hpp>
#include <concino/core/message.hpp>
#include <concino/core/small_array.hpp>
#include <concino/core/vec3.hpp>
#include <concino/edit/detail/open_recorder.hpp>
#include <concino/edit/detail/simplex_origins.hpp>
#include <concino/edit/proposed_edit.hpp>

#include <cmath>

namespace concino::detail {

/// What a new vert comes from: the point (1 - t) a + t b of two verts, which may be the same.
struct vert_origin {
  unsigned a, b;
  double t;
};

/// All verts have local numbers, in the order in which they are met.
template<class M>
class cavity_builder {
  static constexpr unsigned simplex_size = dimension_v<M> + 1;

  const M* m_;
  core::local_numbers numbers_;
  core::small_array<vert_t<M>, 32> verts_;   // of old polys, then of neighbours
  core::small_array<poly_t<M>, 32> polys_;   // old polys, then neighbours
  core::small_array<unsigned, 96> corners_;  // of these, one after another
  core::small_array<unsigned, 96> new_corners_;
  core::small_array<unsigned, 32> ends_;
  core::small_array<poly_origin, 32> origins_;
  core::small_array<poly_t<M>, 32> new_polys_;
  core::small_array<unsigned, 4> split_;     // the verts that the new vert replaces, if it lies in their simplex
  unsigned num_old_ = 0, num_old_verts_ = 0;
  unsigned removed_ = none, moved_ = none;  // local numbers of verts
  std::size_t kept_ = 0;
  vec3 point_, moved_to_;
  vert_origin origin_{none, none, 0};
  bool has_point_ = false;
  vert_t<M> new_vert_{};

  template<class T>
  static id_span<T> span(const T* first, std::size_t n) { return {first, first + n}; }

  bool add(const poly_t<M>& p) {
    if constexpr (VolumeMesh<M> && arity_v<M> == 0) return false;  // general polyhedra, whose verts come in any order
    unsigned n = 0;
    for (const vert_t<M> v : adj_p2v(*m_, p)) {
      if (++n > size) return false;
      corners_.push_back(vert(v));
    }
    polys_.push_back(p);
    return n == size;
  }

 public:
  static constexpr unsigned none = edit_outline::none;
  static constexpr unsigned added = edit_outline::added;  // the number of the new vert
  static constexpr unsigned size = simplex_size;

  explicit cavity_builder(const M& m) : m_(&m) {}

  unsigned vert(const vert_t<M>& v) {
    const unsigned i = numbers_.add(index_of(*m_, v));
    if (i == verts_.size()) verts_.push_back(v);
    return i;
  }

  /// Adds an old poly. Returns false if it is not a simplex; in volumes, one of a mesh of tets.
  bool add_old(const poly_t<M>& p) {
    const bool is_simplex = add(p);
    num_old_ = static_cast<unsigned>(polys_.size());
    num_old_verts_ = static_cast<unsigned>(verts_.size());
    return is_simplex;
  }
  /// Adds a poly that stays, but has a vert that moves. Old polys come before. Returns false if it is not a simplex.
  bool add_neighbour(const poly_t<M>& p) { return add(p); }

  /// New polys have the verts so far, and no others.
  void end_verts_of_cavity() { num_old_verts_ = static_cast<unsigned>(verts_.size()); }

  unsigned num_old() const { return num_old_; }
  unsigned num_polys() const { return static_cast<unsigned>(polys_.size()); }
  unsigned num_verts() const { return static_cast<unsigned>(verts_.size()); }
  /// The corners of an old poly, or of a neighbour.
  const unsigned* corners(unsigned k) const { return corners_.data() + k * size; }
  const poly_t<M>& poly(unsigned k) const { return polys_[k]; }
  const vert_t<M>& vert_at(unsigned i) const { return verts_[i]; }
  bool has(unsigned k, unsigned v) const { return std::find(corners(k), corners(k) + size, v) != corners(k) + size; }
  /// Whether polys k and j, which share all corners but x of k and y of j, run along their common facet in opposite
  /// directions.
  bool is_consistent(unsigned k, unsigned x, unsigned j, unsigned y) const {
    unsigned other[size];
    for (unsigned i = 0; i < size; ++i) other[i] = corners(j)[i] == y ? x : corners(j)[i];
    bool is_odd = false;
    for (unsigned i = 0; i < size; ++i) {
      const unsigned at = static_cast<unsigned>(std::find(other + i, other + size, corners(k)[i]) - other);
      if (at != i) std::swap(other[i], other[at]), is_odd = !is_odd;
    }
    return is_odd;
  }

  /// Adds the new vert.
  void add_point(const vec3& x, const vert_origin& from) { point_ = x, origin_ = from, has_point_ = true; }
  /// Moves a vert that stays.
  void move(unsigned v, const vec3& x) { moved_ = v, moved_to_ = x; }
  /// Adds a new poly: poly k with vert `by` instead of `v`.
  void add_new(unsigned k, unsigned v, unsigned by) {
    for (unsigned i = 0; i < size; ++i) new_corners_.push_back(corners(k)[i] == v ? by : corners(k)[i]);
    ends_.push_back(static_cast<unsigned>(new_corners_.size()));
    origins_.push_back({k, 1});
  }
  /// Adds a new poly with these corners, which comes from poly k.
  void add_new(const unsigned* its_corners, unsigned k) {
    for (unsigned i = 0; i < size; ++i) new_corners_.push_back(its_corners[i]);
    ends_.push_back(static_cast<unsigned>(new_corners_.size()));
    origins_.push_back({k, 1});
  }
  /// The new vert lies in the simplex of these verts, and replaces each of them in as many new polys.
  void split_at(const unsigned* verts, unsigned n) {
    for (unsigned i = 0; i < n; ++i) split_.push_back(verts[i]);
  }
  /// Removes vert b, which no new poly has. It becomes one with a, at (1 - t) a + t b.
  void merge(unsigned a, unsigned b, double t) { removed_ = b, origin_ = {a, b, t}; }
  /// The first n new polys have the descriptors of the first n old ones.
  void keep(std::size_t n) { kept_ = n; }
  /// Each new poly comes from all old ones.
  void mix_origins() {
    for (poly_origin& x : origins_) x = {0, num_old_};
  }

  const vert_t<M>& new_vert() const { return new_vert_; }
  const core::small_array<unsigned, 96>& new_corners() const { return new_corners_; }
  const core::small_array<poly_origin, 32>& origins() const { return origins_; }
  unsigned removed_vert() const { return removed_; }
  unsigned kept_vert() const { return removed_ == none ? none : origin_.a; }
  unsigned moved_vert() const { return moved_; }
  const vec3& moved_to() const { return moved_to_; }
  bool has_point() const { return has_point_; }
  const vec3& point_of_new() const { return point_; }

  /// Replaces the polys. Named properties follow, by the origins of the new elements.
  void apply(M& m) {
    new_polys_.resize(ends_.size(), poly_t<M>{});
    if constexpr (carries_values<M>)
      if (traits<M>::properties(m).size() > 0) return apply_with_values(m);
    replace(m);
  }

 private:
  void replace(M& m) {
    unsigned last = num_old_verts_;
    if (removed_ != none) {  // the removed vert comes last
      std::swap(verts_[removed_], verts_[--last]);
      for (unsigned& i : new_corners_)
        if (i == last) i = removed_;
    }
    for (unsigned& i : new_corners_)
      if (i == added) i = num_old_verts_;
    const cavity<M> c{span(polys_.data(), num_old_),
                      span(verts_.data(), num_old_verts_),
                      span(&point_, has_point_ ? 1 : 0),
                      span(new_corners_.data(), new_corners_.size()),
                      span(ends_.data(), ends_.size()),
                      {},
                      kept_,
                      removed_ == none ? 0u : 1u};
    const vert_t<M> moving = moved_ == none ? vert_t<M>{} : verts_[moved_ == last ? removed_ : moved_];
    if constexpr (saves_values<M>)
      if (auto* const recorder = open_recorder(m)) return replace_recorded(m, c, moving, *recorder);
    rewire(m, c, cavity_result<M>{&new_vert_, new_polys_.data()});
    if (moved_ != none) set_point(m, moving, moved_to_);
  }
  /// While a transaction is open, moving the vert may fail, so it comes first.
  template<class Recorder>
  void replace_recorded(M& m, const cavity<M>& c, const vert_t<M>& moving, Recorder& recorder) {
    const std::size_t before = recorder.log.num_steps();
    if (moved_ != none) set_point(m, moving, moved_to_);
    try {
      rewire(m, c, cavity_result<M>{&new_vert_, new_polys_.data()});
    } catch (...) {
      recorder.roll_back(before);
      throw;
    }
  }

  void apply_with_values(M& m) {
    core::small_array<double, 32> old_measures, new_measures;
    core::small_array<unsigned, 96> corners_of_new;
    const auto at = [&](unsigned v) { return v == added ? point_ : to_vec3(point(m, verts_[v])); };
    const auto measure = [&](const unsigned* v) {
      vec3 x[size];
      for (unsigned i = 0; i < size; ++i) x[i] = at(v[i]);
      return simplex_measure(x, size);
    };
    edit_outline e;
    e.size = size, e.num_old = num_old_, e.num_new = static_cast<unsigned>(ends_.size());
    for (unsigned k = 0; k < e.num_old; ++k) old_measures.push_back(measure(corners(k)));
    for (unsigned k = 0; k < e.num_new; ++k) new_measures.push_back(measure(new_corners_.data() + k * size));
    for (const unsigned v : new_corners_) corners_of_new.push_back(v);  // replace() numbers them differently
    e.old_corners = corners_.data(), e.new_corners = corners_of_new.data(), e.origins = origins_.data();
    e.old_measures = old_measures.data(), e.new_measures = new_measures.data();
    describe_verts(e);
    const std::span<const vert_t<M>> existing(verts_.data(), num_old_verts_);
    edit_values<M> values(m, existing, added, e.around.empty() ? 0 : 1);
    simplex_origins<M>(m, e, existing, {polys_.data(), num_old_}, values).add(traits<M>::properties(m));
    values.find(traits<M>::properties(m));
    const auto write = [&] { values.write(m, &new_vert_, {new_polys_.data(), new_polys_.size()}); };
    if constexpr (saves_values<M>) {
      if (auto* const recorder = open_recorder(m)) {
        const std::size_t before = recorder->log.num_steps();
        recorder->save_values([&](const auto& save) { values.for_each_replaced(save); });
        try {
          replace(m);
        } catch (...) {
          recorder->roll_back(before);
          throw;
        }
        return write();
      }
    }
    replace(m);
    write();
  }

  void describe_verts(edit_outline& e) const {
    if (removed_ != none && origin_.a != none) {
      e.remaining = origin_.a, e.removed = origin_.b, e.at = origin_.t;
    } else if (has_point_ && origin_.a != none) {
      e.around.push_back({origin_.a, origin_.a == origin_.b ? 1 : 1 - origin_.t});
      if (origin_.a != origin_.b) e.around.push_back({origin_.b, origin_.t});
    } else if (has_point_) {  // the weights are barycentric coordinates
      const auto n = static_cast<unsigned>(split_.size());
      for (unsigned i = 0; i < n; ++i) {
        double weight = 0;
        for (unsigned k = 0; k < num_old_; ++k) weight += e.new_measures[i * num_old_ + k];
        e.around.push_back({split_[i], std::isfinite(weight) ? weight : 1});
      }
    }
  }
};

}  // namespace concino::detail
