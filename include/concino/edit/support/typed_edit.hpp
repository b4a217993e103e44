// What invariants ask about the mesh of a proposed edit.
#pragma once

#include <concino/edit/detail/propose.hpp>

#include <array>

namespace concino::core {

/// The cavity of an edit of m.
/// Errors: invalid_argument if e is an edit of another mesh.
template<class M>
const detail::cavity_builder<M>& cavity_of_edit(const proposed_edit& e, const M& m, const char* name) {
  if (e.mesh_type != &detail::type_tag<M> || e.mesh != &m)
    throw_joined<invalid_argument>(
        {name, ": the invariant was made for another mesh; make it with the mesh that is edited"});
  return *static_cast<const detail::cavity_builder<M>*>(e.cavity);
}

/// A map or predicate of the caller: a copy if it is small and can be copied byte by byte, else a reference.
template<class F>
class caller_map {
  static constexpr bool is_copied = std::is_trivially_copyable_v<F> && sizeof(F) <= 4 * sizeof(void*);

  std::conditional_t<is_copied, F, const F*> f_;

 public:
  template<class G> static constexpr bool can_hold = is_copied || std::is_lvalue_reference_v<G>;

  explicit caller_map(const F& f) : f_([&]() -> std::conditional_t<is_copied, const F&, const F*> {
      if constexpr (is_copied) return f;
      else return &f;
    }()) {}
  const F& get() const {
    if constexpr (is_copied) return f_;
    else return *f_;
  }
  template<class X>
  decltype(auto) operator()(const X& x) const {
    if constexpr (requires { get()[x]; }) return get()[x];
    else return get()(x);
  }
};

/// Calls f with the local verts of each edge (N = 2) or face (N = 3) of old polys that the edit removes, until f
/// returns false.
template<std::size_t N, class M, class F>
bool for_each_removed(const detail::cavity_builder<M>& c, const F& f) {
  constexpr unsigned size = detail::cavity_builder<M>::size;
  const auto is_kept = [&](const std::array<unsigned, N>& s) {
    const auto is_in = [&](const unsigned* corners) {
      for (const unsigned v : s)
        if (std::find(corners, corners + size, v) == corners + size) return false;
      return true;
    };
    for (std::size_t k = 0; k < c.origins().size(); ++k)
      if (is_in(c.new_corners().data() + k * size)) return true;
    for (unsigned k = c.num_old(); k < c.num_polys(); ++k)
      if (is_in(c.corners(k))) return true;
    return false;
  };
  for (unsigned k = 0; k < c.num_old(); ++k)
    for (unsigned chosen = 0; chosen < 1u << size; ++chosen) {
      std::array<unsigned, N> s{};
      unsigned n = 0;
      for (unsigned i = 0; i < size; ++i)
        if (chosen >> i & 1) {
          if (n < N) s[n] = c.corners(k)[i];
          ++n;
        }
      if (n == N && !is_kept(s) && !f(s)) return false;
    }
  return true;
}

}  // namespace concino::core
