// Asks invariants whether the edit of a cavity is allowed.
#pragma once

#include <concino/edit/detail/cavity_builder.hpp>
#include <concino/edit/detail/operator_checks.hpp>
#include <concino/edit/detail/representable.hpp>
#include <concino/edit/proposed_edit.hpp>

namespace concino::detail {

/// Its address stands for the type of a mesh.
template<class M> inline constexpr char type_tag = 0;

/// Whether m can represent the result of the edit. Needed only if the edit may change the topology of a mesh that m can
/// represent.
template<class M>
permission is_representable(const M& m, const cavity_builder<M>& c) {
  core::small_array<vert_t<M>, 32> verts;
  core::small_array<unsigned, 96> corners, ends;
  const unsigned last = c.num_verts() - 1, removed = c.removed_vert();
  for (unsigned i = 0; i <= last; ++i) verts.push_back(c.vert_at(i));
  if (removed != c.none) std::swap(verts[removed], verts[last]);
  for (const unsigned i : c.new_corners()) {
    corners.push_back(i == c.added ? last + 1 : i == last && removed != c.none ? removed : i);
    if (corners.size() % c.size == 0) ends.push_back(static_cast<unsigned>(corners.size()));
  }
  const auto all = [](const auto& list) { return id_span(list.begin(), list.end()); };
  const vec3& x = c.point_of_new();
  return is_representable(m, cavity<M>{{&c.poly(0), &c.poly(0) + c.num_old()},
                                       all(verts),
                                       {&x, &x + c.has_point()},
                                       all(corners),
                                       all(ends),
                                       {},
                                       0,
                                       removed != c.none});
}

/// The first refusal. Nothing is computed if there are no invariants.
template<class M>
permission ask(const std::vector<invariant>& keep, const M& m, const cavity_builder<M>& c) {
  if (keep.empty()) return {};
  constexpr unsigned size = cavity_builder<M>::size;
  core::small_array<std::size_t, 32> verts, polys;
  core::small_array<vec3, 32> before, after;
  core::small_array<unsigned, 192> corners;
  core::small_array<poly_origin, 64> origins;
  for (unsigned i = 0; i < c.num_verts(); ++i) {
    verts.push_back(index_of(m, c.vert_at(i)));
    before.push_back(to_vec3(point(m, c.vert_at(i))));
    after.push_back(i == c.moved_vert() ? c.moved_to() : before.back());
  }
  if (c.has_point()) after.push_back(c.point_of_new());
  for (const unsigned i : c.new_corners()) corners.push_back(i == c.added ? c.num_verts() : i);
  for (const poly_origin& x : c.origins()) origins.push_back(x);
  for (unsigned k = 0; k < c.num_old(); ++k) polys.push_back(index_of(m, c.poly(k)));
  if (c.moved_vert() != c.none)
    for (unsigned k = c.num_old(); k < c.num_polys(); ++k) {
      for (unsigned i = 0; i < size; ++i) corners.push_back(c.corners(k)[i]);
      polys.push_back(index_of(m, c.poly(k)));
      origins.push_back({k, 1});
    }
  proposed_edit e;
  e.corners_per_poly = size;
  e.verts = {verts.data(), verts.size()};
  e.points_before = {before.data(), before.size()};
  e.points_after = {after.data(), after.size()};
  e.old_polys = {polys.data(), polys.size()};
  e.old_corners = {c.corners(0), polys.size() * size};
  e.new_corners = {corners.data(), corners.size()};
  e.origins = {origins.data(), origins.size()};
  e.removed_vert = c.removed_vert(), e.kept_vert = c.kept_vert();
  e.mesh = &m, e.cavity = &c, e.mesh_type = &type_tag<M>;
  for (const invariant& x : keep)
    if (const permission p = x(e); !p) return p;
  return {};
}

}  // namespace concino::detail
