// Reads the tets of any volume that a level set crosses, and cuts them.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/level_sets/detail/announced_numbers.hpp>
#include <concino/level_sets/detail/level_states.hpp>
#include <concino/level_sets/detail/tet_cutter.hpp>
#include <concino/mesh/element_origins.hpp>
#include <concino/mesh/mesh_point.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Tets that a level set crosses: their new parts, and their verts by number. The names are those of crossed_volume_reader.
template<class M>
class crossed_tet_reader {
  struct known_face {
    std::uint32_t first;     // the number of the tet that was read first, times four, plus the position of the face there
    std::uint32_t opposite;  // the vert of that tet that is not a corner
  };

  struct read_face {
    face_t<M> face;
    vert_t<M> verts[3];
    bool is_outward;
  };
  static constexpr std::size_t batch = 16;  // tets that are read at once

  announced_numbers vert_numbers_, face_numbers_;
  std::vector<known_face> faces_;
  double level_;

 public:
  struct {
    std::vector<vec3> points;
    std::vector<double> values;
    std::vector<std::uint32_t> vert_indices;
  } arrays;  // by number of a vert
  std::vector<poly_t<M>> polys;
  std::vector<vert_t<M>> verts;
  tet_cutter cutter;
  bool can_cut = true;  // whether the tets can be cut one by one; if not, nothing else here is of use

  /// `crossed`: the polys that the level set crosses. `states`: of all verts, by index.
  template<class U>
  crossed_tet_reader(const M& m, const U& u, double level, const state_array& states, const std::vector<poly_t<M>>& crossed)
      : vert_numbers_(vert_index_bound(m)), face_numbers_(face_index_bound(m)), level_(level), polys(crossed) {
    std::vector<std::uint32_t> cut, on_level_or_below;
    cut.reserve(polys.size());
    for (std::uint32_t p = 0; p < polys.size(); ++p) {
      unsigned char joint = 0;
      for (const vert_t<M> v : adj_p2v(m, polys[p])) {
        const std::size_t index = index_of(m, v);
        joint |= states[index];
        vert_numbers_.announce(index);
      }
      (joint & above_level ? cut : on_level_or_below).push_back(p);
    }
    reserve(cut.size());
    std::vector<face_t<M>> faces;
    faces.reserve(4 * cut.size());
    for (const std::uint32_t p : cut)
      for (const face_t<M> f : adj_p2f(m, polys[p])) {
        faces.push_back(f);
        face_numbers_.announce(index_of(m, f));
      }
    vert_numbers_.count();
    faces_.reserve(face_numbers_.count());
    for (std::size_t i = 0; i < cut.size() && can_cut; i += batch)
      add_tets(m, u, states, cut.data() + i, faces.data() + 4 * i, std::min(batch, cut.size() - i));
    if (!can_cut) return;
    const auto num_verts = static_cast<std::uint32_t>(verts.size());
    for (const std::uint32_t p : on_level_or_below) add_face_on_level(m, u, states, polys[p]);
    cutter.finish(num_verts);
  }

  /// The verts of the mesh of which a new vert was made.
  std::array<origin, 2> origins_of(const level_place& x) const {
    const double t = crossing_parameter(arrays.values[x.below], arrays.values[x.above], level_);
    return {origin{arrays.vert_indices[x.below], 1 - t}, origin{arrays.vert_indices[x.above], t}};
  }

 private:
  void reserve(std::size_t num_tets) {
    cutter.resize(num_tets);
    verts.reserve(num_tets);
    arrays.points.reserve(num_tets), arrays.values.reserve(num_tets), arrays.vert_indices.reserve(num_tets);
  }

  template<class Verts>
  static unsigned char joint_states(const M& m, const state_array& states, const Verts& all) {
    unsigned char joint = 0;
    for (const vert_t<M> v : all) joint |= states[index_of(m, v)];
    return joint;
  }

  template<class U>
  std::uint32_t number(const M& m, const U& u, const vert_t<M>& v) {
    const std::size_t index = index_of(m, v);
    const std::uint32_t n = vert_numbers_.add(index, verts.size());
    if (n < verts.size()) return n;
    verts.push_back(v);
    arrays.vert_indices.push_back(static_cast<std::uint32_t>(index));
    arrays.points.push_back(to_vec3(point(m, v)));
    arrays.values.push_back(static_cast<double>(u[v]));
    return n;
  }

  /// Adds n tets, whose faces are given. Each loop reads one thing of all of them, so that the processor waits for the memory of several at once.
  template<class U>
  void add_tets(const M& m, const U& u, const state_array& states, const std::uint32_t* numbers, const face_t<M>* faces, std::size_t n) {
    read_face all[4 * batch];
    for (std::size_t i = 0; i < 4 * n; ++i) {
      all[i].face = faces[i];
      vert_t<M>* to = all[i].verts;
      for (const vert_t<M> v : adj_f2v(m, faces[i])) *to++ = v;
    }
    for (std::size_t i = 0; i < 4 * n; ++i) all[i].is_outward = face_is_outward(m, polys[numbers[i / 4]], faces[i]);
    for (std::size_t i = 0; i < 4 * n; ++i) can_cut = can_cut && num_elements(adj_f2p(m, faces[i])) <= 2;
    for (std::size_t i = 0; i < n && can_cut; ++i) add_tet(m, u, states, numbers[i], all + 4 * i);
  }
  template<class U>
  void add_tet(const M& m, const U& u, const state_array& states, std::uint32_t p, const read_face* faces) {
    crossed_tet t;
    t.poly = p;
    std::size_t indices[4];
    std::uint32_t num_verts = 0;
    for (std::uint32_t k = 0; k < 4; ++k) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const vert_t<M>& v = faces[k].verts[i];
        const std::size_t index = index_of(m, v);
        const auto at = static_cast<unsigned char>(std::find(indices, indices + num_verts, index) - indices);
        if (at == num_verts) {
          indices[at] = index;
          t.states[at] = states[index];
          t.verts[at] = number(m, u, v);
          ++num_verts;
        }
        t.corners[k][i] = at;
      }
      t.is_outward[k] = faces[k].is_outward;
      t.order[k] = static_cast<std::uint32_t>(index_of(m, faces[k].face));  // until find_order()
    }
    find_order(t);
    if (can_cut) cutter.add(t);
  }
  void find_order(crossed_tet& t) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      const unsigned char* const c = t.corners[k];
      const std::uint32_t opposite = t.verts[6 - c[0] - c[1] - c[2]], n = face_numbers_.add(t.order[k], faces_.size());
      if (n == faces_.size()) faces_.push_back({4 * t.poly + k, opposite});
      else if (faces_[n].opposite == opposite) can_cut = false;
      t.order[k] = faces_[n].first;
    }
  }

  /// Adds the face of a tet that is on the level set, if the tet beyond is above.
  template<class U>
  void add_face_on_level(const M& m, const U& u, const state_array& states, const poly_t<M>& p) {
    for (const face_t<M> f : adj_p2f(m, p)) {
      if (joint_states(m, states, adj_f2v(m, f)) != on_level) continue;
      std::size_t n = 0;
      bool is_between = true;
      for (const poly_t<M> q : adj_f2p(m, f)) ++n, is_between = is_between && (q == p || !(joint_states(m, states, adj_p2v(m, q)) & below_level));
      std::uint32_t corners[3], k = 0;
      for (const vert_t<M> v : adj_f2v(m, f)) corners[k++] = number(m, u, v);
      if (is_between && n == 2) cutter.add_whole_face(corners);
    }
  }
};

}  // namespace concino::detail
