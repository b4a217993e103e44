// A mesh of tets that is being improved: points, qualities, what is fixed, and which verts have changed last.
#pragma once

#include <concino/remesh/detail/fixed_elements.hpp>
#include <concino/remesh/detail/moving_vert.hpp>
#include <concino/remesh/detail/tet_quality.hpp>
#include <concino/remesh/detail/unit_points.hpp>

#include <algorithm>
#include <vector>

namespace concino::detail {

template<class M>
struct tet_corners {
  vert_t<M> verts[4];
  bool has(const vert_t<M>& v) const { return v == verts[0] || v == verts[1] || v == verts[2] || v == verts[3]; }
  unsigned place_of(const vert_t<M>& v) const {
    unsigned i = 0;
    while (i < 3 && verts[i] != v) ++i;
    return i;
  }
};

template<class M>
class improvable_tets {
  const unit_points& unit_;
  std::vector<unsigned> changed_;  // by index of the vert: the round in which a tet at it was changed last

 public:
  M& mesh;
  const fixed_elements<M> fixed;
  unsigned round = 1;

  template<class F>
  improvable_tets(M& m, const unit_points& unit, const F& label)
      : unit_(unit), changed_(vert_index_bound(m), 1u), mesh(m), fixed(m, label) {}

  vec3 at(const vert_t<M>& v) const { return unit_.at(mesh, v); }
  vec3 to_mesh(const vec3& x) const { return unit_.to_mesh(x); }

  tet_corners<M> corners(const poly_t<M>& p) const {
    tet_corners<M> t;
    unsigned n = 0;
    for (const vert_t<M> v : adj_p2v(mesh, p))
      if (n < 4) t.verts[n++] = v;
    return t;
  }
  double quality(const vert_t<M>& a, const vert_t<M>& b, const vert_t<M>& c, const vert_t<M>& d) const {
    return tet_quality(at(a), at(b), at(c), at(d));
  }
  double quality(const tet_corners<M>& t) const { return quality(t.verts[0], t.verts[1], t.verts[2], t.verts[3]); }
  double quality(const poly_t<M>& p) const { return quality(corners(p)); }
  /// The quality of t with a vert at another place, or another vert.
  double quality(const tet_corners<M>& t, unsigned place, const vec3& x) const {
    vec3 p[4];
    for (unsigned i = 0; i < 4; ++i) p[i] = i == place ? x : at(t.verts[i]);
    return tet_quality(p[0], p[1], p[2], p[3]);
  }

  /// Adds the face of t opposite to a corner.
  void add_face(moving_vert& vert, const tet_corners<M>& t, unsigned place) const {
    static constexpr unsigned opposite[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    const unsigned* const i = opposite[place];
    vert.add(at(t.verts[i[0]]), at(t.verts[i[1]]), at(t.verts[i[2]]));
  }

  void mark(const vert_t<M>& v) {
    const std::size_t i = index_of(mesh, v);
    if (i >= changed_.size()) changed_.resize(std::max(i + 1, 2 * changed_.size()));
    changed_[i] = round;
  }
  void mark_around(const vert_t<M>& v) {
    mark(v);
    for (const vert_t<M> w : adj_v2v(mesh, v)) mark(w);
  }
  /// Whether something at a vert of t has changed in this round or in the one before.
  bool has_changed(const tet_corners<M>& t) const {
    for (const vert_t<M>& v : t.verts)
      if (const std::size_t i = index_of(mesh, v); i < changed_.size() && changed_[i] + 1 >= round) return true;
    return false;
  }
};

}  // namespace concino::detail
