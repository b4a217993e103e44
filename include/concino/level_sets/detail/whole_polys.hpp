// The polys of a volume that a level set leaves whole.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/large_pages.hpp>
#include <concino/core/temporary_array.hpp>
#include <concino/level_sets/detail/level_states.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Lists the polys that are kept whole, with their faces and verts. First come those that the level set does not cross, which are known before any poly is cut.
template<class M>
class whole_polys {
  const M& m_;
  bool both_;
  struct crossed_poly {
    poly_t<M> poly;
    std::size_t num_before;  // how many of `polys` come before it
  };
  std::vector<crossed_poly> crossed_;

  void add_elements(const poly_t<M>& p) {
    for (const face_t<M> f : adj_p2f(m_, p)) has_face[index_of(m_, f)] = 1, ++num_faces;
    for (const vert_t<M> v : adj_p2v(m_, p)) vert_numbers[index_of(m_, v)] = 0;
  }

 public:
  struct inserted_poly {
    std::uint32_t number;  // among the crossed polys
    bool is_above;
  };

  std::vector<poly_t<M>> polys;
  std::vector<unsigned char> above;               // by poly of `polys`
  core::temporary_array<unsigned char> has_face;  // by index of the face: 1 if it is of one of the polys, else 0
  std::vector<std::uint32_t> vert_numbers;        // by index of the vert: 0 if it is of one of the polys, else ~0
  std::size_t num_faces = 0;                      // of all polys, with repetitions

  whole_polys(const M& m, bool both)
      : m_(m), both_(both), has_face(face_index_bound(m), 0), vert_numbers(core::large_vector(vert_index_bound(m), ~0u)) {}

  /// Lists the polys that are not crossed. states: see poly_states().
  void list(const state_array& states) {
    const std::size_t all = num_polys(m_);  // an upper bound, which costs addresses only
    core::reserve_large(polys, all), core::reserve_exact(above, all);
    for (const poly_t<M> p : concino::polys(m_)) {
      const unsigned char s = states[index_of(m_, p)];
      if (is_crossed(s)) {
        crossed_.push_back({p, polys.size()});
      } else if (both_ || s != below_level) {
        add_elements(p);
        polys.push_back(p);
        above.push_back(s != below_level);
      }
    }
  }

  /// Adds crossed polys that are whole nevertheless, in their order.
  void insert(const std::vector<inserted_poly>& whole) {
    if (whole.empty()) return;
    std::vector<poly_t<M>> all;
    std::vector<unsigned char> all_above;
    core::reserve_large(all, polys.size() + whole.size()), core::reserve_exact(all_above, polys.size() + whole.size());
    std::size_t next = 0;
    const auto append_until = [&](std::size_t end) {
      for (; next < end; ++next) all.push_back(polys[next]), all_above.push_back(above[next]);
    };
    for (const inserted_poly& x : whole) {
      const crossed_poly& c = crossed_[x.number];
      append_until(c.num_before);
      add_elements(c.poly);
      all.push_back(c.poly), all_above.push_back(x.is_above);
    }
    append_until(polys.size());
    polys.swap(all), above.swap(all_above);
  }
};

}  // namespace concino::detail
