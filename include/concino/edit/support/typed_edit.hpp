// What invariants ask about the mesh of a proposed edit.
#pragma once

#include <concino/edit/detail/facet_flip.hpp>
#include <concino/edit/detail/polys/general_proposal.hpp>
#include <concino/edit/detail/propose.hpp>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace concino::core {

/// The cavity of an edit of simplices of m.
/// Errors: invalid_argument if e is an edit of another mesh.
template<class M>
const detail::cavity_builder<M>& cavity_of_simplices(const proposed_edit& e, const M& m, const char* name) {
  if (e.mesh_type != &detail::type_tag<M> || e.mesh != &m)
    throw_joined<invalid_argument>(
        {name, ": the invariant was made for another mesh; make it with the mesh that is edited"});
  return *static_cast<const detail::cavity_builder<M>*>(e.cavity);
}

/// Calls f(cavity) with the cavity of an edit of m: a cavity_builder of simplices, or a general_cavity.
/// Errors: invalid_argument if e is an edit of another mesh.
template<class M, class F>
permission with_cavity_of_edit(const proposed_edit& e, const M& m, const char* name, const F& f) {
  if (e.mesh_type == &detail::general_tag<M> && e.mesh == &m)
    return f(*static_cast<const detail::general_cavity<M>*>(e.cavity));
  return f(cavity_of_simplices(e, m, name));
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

/// Calls f(edge) for each edge of old polys that the edit removes, until f returns false. The same for faces.
template<class M, class F>
bool for_each_removed_edge(const detail::general_cavity<M>& c, const F& f) {
  using edge = std::pair<unsigned, unsigned>;
  std::vector<edge> before, after;
  const auto add = [](const detail::poly_lists& all, std::size_t first, std::size_t last, std::vector<edge>& to) {
    for (std::size_t i = first; i < last; ++i)
      detail::for_each_edge_of(all.list(i), [&](unsigned a, unsigned b) { to.push_back(std::minmax(a, b)); });
  };
  add(c.old_polys(), 0, c.num_old_lists(), before);
  add(c.old_polys(), c.num_old_lists(), c.old_polys().num_lists(), after);
  add(c.new_polys(), 0, c.new_polys().num_lists(), after);
  std::sort(before.begin(), before.end());
  before.erase(std::unique(before.begin(), before.end()), before.end());
  std::sort(after.begin(), after.end());
  for (const auto& [a, b] : before)
    if (!std::binary_search(after.begin(), after.end(), edge{a, b}) &&
        !f(detail::edge_between_verts(c.mesh(), c.vert_at(a), c.vert_at(b))))
      return false;
  return true;
}
template<class M, class F>
bool for_each_removed_face(const detail::general_cavity<M>& c, const F& f) {
  std::vector<std::vector<unsigned>> after;
  for (std::size_t i = 0; i < c.new_polys().num_lists(); ++i)
    after.push_back(detail::sorted_list(c.new_polys().list(i)));
  for (std::size_t i = c.num_old_lists(); i < c.old_polys().num_lists(); ++i)
    after.push_back(detail::sorted_list(c.old_polys().list(i)));
  std::sort(after.begin(), after.end());
  for (std::size_t i = 0; i < c.num_old_lists(); ++i)
    if (!std::binary_search(after.begin(), after.end(), detail::sorted_list(c.old_polys().list(i))) && !f(c.face(i)))
      return false;
  return true;
}

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

/// The same for edits of simplices.
template<class M, class F>
bool for_each_removed_edge(const detail::cavity_builder<M>& c, const M& m, const F& f) {
  return for_each_removed<2>(c, [&](const std::array<unsigned, 2>& s) {
    return f(detail::edge_between_verts(m, c.vert_at(s[0]), c.vert_at(s[1])));
  });
}
template<class M, class F>
bool for_each_removed_edge(const detail::general_cavity<M>& c, const M&, const F& f) {
  return for_each_removed_edge(c, f);
}

}  // namespace concino::core
