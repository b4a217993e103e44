// Merges polys greedily as long as an invariant allows it.
#pragma once

#include <concino/core/progress.hpp>
#include <concino/edit/merge_polys.hpp>
#include <concino/geometry/measure.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

namespace concino {

struct agglomerate_while_options {
  std::size_t target = 1;            // it ends at this many polys
  concino::progress progress = {};   // called with "agglomerating"
};

/// What agglomerate_while has done.
struct agglomeration {
  std::size_t num_merges = 0;
  bool reached_target = true;    // else it has stopped early: no merge of two polys is allowed
  permission last_refusal = {};  // if it has stopped early: why the last merge was refused, if one was tried
};

namespace detail {

/// The polys in the order in which they are merged.
template<class M>
class agglomerator {
  struct entry {
    double size;
    std::size_t index;
    std::uint32_t version;
    poly_t<M> poly;

    bool operator<(const entry& x) const { return size != x.size ? size > x.size : index > x.index; }
  };
  struct candidate {
    poly_t<M> poly;
    facet_t<M> facet;
    double shared;
  };

  M& m_;
  const edit_options keep_;
  std::priority_queue<entry> queue_;
  std::vector<std::uint32_t> version_;       // by index of a poly
  std::vector<unsigned char> is_refused_;
  std::vector<candidate> candidates_;

  void push(const poly_t<M>& p) {
    const std::size_t i = index_of(m_, p);
    const double size = std::abs(measure(m_, p));
    is_refused_[i] = 0;
    queue_.push({std::isfinite(size) ? size : 0, i, version_[i], p});
  }
  /// The neighbours of p, the one with which it shares most first.
  void find_candidates(const poly_t<M>& p) {
    candidates_.clear();
    for (const facet_t<M> f : adj_p2facet(m_, p))
      for (const poly_t<M> q : other_polys(m_, p, f)) {
        const double size = measure(m_, f);
        const auto known = std::find_if(candidates_.begin(), candidates_.end(),
                                        [&](const candidate& c) { return c.poly == q; });
        if (known == candidates_.end()) candidates_.push_back({q, f, std::isfinite(size) ? size : 0});
        else if (std::isfinite(size)) known->shared += size;
      }
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const candidate& a, const candidate& b) { return a.shared > b.shared; });
  }

 public:
  agglomerator(M& m, const invariant& keep)
      : m_(m), keep_{{keep}}, version_(poly_index_bound(m), 0), is_refused_(poly_index_bound(m), 0) {
    for (const poly_t<M> p : polys(m)) push(p);
  }

  /// Makes the first merge that is allowed. Returns false if there is none.
  bool merge_next(permission& last_refusal) {
    while (!queue_.empty()) {
      const entry x = queue_.top();
      queue_.pop();
      if (x.version != version_[x.index]) continue;
      find_candidates(x.poly);
      for (const candidate& c : candidates_) {
        const std::size_t i = index_of(m_, c.poly);
        const poly_result<M> r = merge_polys(m_, c.facet, keep_);
        if (!r) {
          last_refusal = r;
          continue;
        }
        ++version_[x.index], ++version_[i];
        push(r.poly);
        for (const poly_t<M> q : adj_p2p(m_, r.poly))
          if (is_refused_[index_of(m_, q)]) push(q);  // it may be allowed now
        return true;
      }
      is_refused_[x.index] = 1;
    }
    return false;
  }
};

}  // namespace detail

/// Merges two polys after another as long as there are more than the target and the invariant allows it. The smallest
/// poly is merged first, by area or volume, with the neighbour with which it shares most, by length or area. If that is
/// refused, the next neighbour is tried, then the next poly.
/// Needs:  EditableGeneralMesh M, an invariant such as min_stability(0.05), min_quality or a lambda.
/// Result: what was done; m has fewer polys, as merge_polys leaves it. It stops early if no merge of two polys is
///         allowed, and says so.
/// Cost:   O(P log P) for P polys, and that of each merge that is tried; a poly that is refused is tried again when a
///         neighbour has changed.
/// Errors: what the invariant throws; cancelled; std::bad_alloc. The merges before are kept then; a transaction can
///         undo them.
/// Source: agglomerated meshes as in Bassi, Botti, Colombo, Di Pietro, Tesini 2012.
template<EditableGeneralMesh M>
  requires Embedded<M>
agglomeration agglomerate_while(M& m, const invariant& keep, const agglomerate_while_options& options = {}) {
  agglomeration result;
  const std::size_t before = num_polys(m);
  detail::agglomerator<M> next(m, keep);
  while (num_polys(m) > options.target) {
    if (result.num_merges % 256 == 0)
      detail::report_progress(
          options.progress,
          static_cast<double>(before - num_polys(m)) / static_cast<double>(before - options.target), "agglomerating");
    if (!next.merge_next(result.last_refusal)) {
      result.reached_target = false;
      break;
    }
    ++result.num_merges;
  }
  if (result.reached_target) result.last_refusal = {};
  detail::report_progress(options.progress, 1, "agglomerating");
  return result;
}

// What to write instead of calls that cannot compile.
template<EditableMesh M, class... T>
  requires(arity_v<M> > 0)
void agglomerate_while(const M&, const T&...) = delete;  // fixed number of verts: make m a polygonmesh or polyhedralmesh

}  // namespace concino
