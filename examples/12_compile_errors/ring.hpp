// Two mesh types for this lesson: `half_done`, a ring of n verts whose mesh_traits lack one line, and `whole`, which has that line too.
#pragma once

#include <concino/concepts/mesh.hpp>

#include <array>

struct half_done { unsigned n; };
struct whole : half_done {};

template<> struct concino::mesh_traits<half_done> {
  using vert = vert_id;
  static id_range<vert> verts(const half_done& r) { return id_range<vert>(r.n); }
  static std::size_t num_verts(const half_done& r) { return r.n; }
  static std::size_t vert_index_bound(const half_done& r) { return r.n; }
  static std::size_t index_of(const half_done&, vert v) { return v.raw(); }
};

template<> struct concino::mesh_traits<whole> : concino::mesh_traits<half_done> {
  static std::array<vert, 2> adj_v2v(const whole& r, vert v) { return {vert{(v.raw() + 1) % r.n}, vert{(v.raw() + r.n - 1) % r.n}}; }
};
