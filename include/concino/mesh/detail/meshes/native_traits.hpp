// The part of mesh_traits that the six native meshes share.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/detail/edits/edit_recorder.hpp>
#include <concino/mesh/element_origins.hpp>
#include <concino/mesh/indexed_base.hpp>
#include <concino/mesh/property_set.hpp>
#include <concino/mesh/surface_tables.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace concino::detail {

/// Whether the tables of M can record edits, so that these can be undone.
template<class M>
inline constexpr bool can_be_undone = requires(M& m, const native_cavity& c, const native_cavity_result& made) {
  m.tables().rewire(c, made, {}, nullptr);
};

/// The part of mesh_traits that the six native meshes share, besides adjacencies.
template<class M, template<class> class Base>
struct native_traits : Base<M> {
  using precompiled = M;  // compiled in concino::compiled
  static const auto& tables(const M& m) { return m.tables(); }
  static const vec3& point(const M& m, vert_id v) { return m.points()[v.raw()]; }
  template<class P>
  static void set_point(M& m, vert_id v, const P& p) {
    if constexpr (can_be_undone<M>)
      if (m.edits().recorder) m.edits().recorder->save_point(v.raw());
    m.points()[v.raw()] = to_vec3(p);
  }
  static const property_set& properties(const M& m) { return m.properties(); }
  static property_set& properties(M& m) { return m.properties(); }
  static std::size_t first_corner(const M& m, poly_id p) { return m.tables().first_corner(p); }
  static std::size_t corner_index_bound(const M& m) { return m.tables().corner_bound(); }

  static vert_id add_vert(M& m, const vec3& x) {
    const vec3 copy = x;  // a copy: x may be a point of m, which moves
    if (is_recorded(m)) return edit_by_rewire(m, {.points = {&copy, &copy + 1}}).vert;
    reserve_more(m.points(), 1);
    const vert_id v = m.tables().add_vert(growing(m));
    m.points().push_back(copy);
    count_edit(m);
    return v;
  }
  static void remove_vert(M& m, vert_id v) {
    if (is_recorded(m)) {
      remove_faces_without_polys(m, v);
      edit_by_rewire(m, {.verts = {&v, &v + 1}, .removed = 1});
      return;
    }
    m.tables().remove_vert(v);
    count_edit(m);
  }
  static poly_id add_poly(M& m, std::span<const vert_id> corners)
    requires requires { m.tables().add_poly(corners); }
  {
    if (is_recorded(m)) {
      check_new_verts({corners.data(), corners.data() + corners.size()}, m.tables().verts(), "add_poly: poly",
                      m.tables().polys().bound());
      std::vector<unsigned> all(corners.size());
      for (unsigned k = 0; k < all.size(); ++k) all[k] = k;
      const auto n = static_cast<unsigned>(all.size());
      return edit_by_rewire(m, {.verts = {corners.data(), corners.data() + n},
                                .corners = {all.data(), all.data() + n},
                                .ends = {&n, &n + 1}})
          .poly;
    }
    const poly_id p = m.tables().add_poly(corners, growing(m));
    count_edit(m);
    return p;
  }
  static face_id add_face(M& m, std::span<const vert_id> corners)
    requires requires { m.tables().add_face(corners); }
  {
    edit_step<typename M::native> step(m);
    const face_id f = m.tables().add_face(corners, growing(m), step.log());
    step.finish();
    return f;
  }
  static poly_id add_poly(M& m, std::span<const face_id> list, std::span<const std::uint8_t> outward)
    requires requires { m.tables().add_poly(list, outward); }
  {
    edit_step<typename M::native> step(m);
    const poly_id p = m.tables().add_poly(list, outward, growing(m), step.log());
    step.finish();
    return p;
  }
  static void rewire(M& m, const native_cavity& c, const native_cavity_result& made)
    requires requires { m.tables().rewire(c, made); }
  {
    reserve_more(m.points(), c.points.size());
    if constexpr (can_be_undone<M>) {
      edit_step<typename M::native> step(m);
      m.tables().rewire(c, made, growing(m), step.log());
      step.finish();
    } else {
      m.tables().rewire(c, made, growing(m));
    }
    m.points().insert(m.points().end(), c.points.begin(), c.points.end());
  }

  // See concepts/editable.hpp. An edit that is recorded, or whose properties must follow, is left to rewire. Meshes
  // whose traits are derived from these do not have them: there another `rewire` may have been written.

  template<std::same_as<M> X>
  static std::optional<vert_id> split_edge(X& m, edge_id e, const vec3& x)
    requires requires { m.tables().split_edge(e); }
  {
    if (!may_edit_directly(m)) return {};
    const vec3 copy = x;  // a copy: x may be a point of m, which moves
    reserve_more(m.points(), 1);
    const vert_id v = m.tables().split_edge(e);
    if (v.is_none()) return {};
    m.points().push_back(copy);
    count_edit(m);
    return v;
  }
  template<std::same_as<M> X>
  static bool flip_edge(X& m, edge_id e)
    requires requires { m.tables().flip_edge(e); }
  {
    if (!may_edit_directly(m) || !m.tables().flip_edge(e)) return false;
    count_edit(m);
    return true;
  }
  template<std::same_as<M> X>
  static bool collapse_edge(X& m, edge_id e, const vec3& x)
    requires requires { m.tables().collapse_edge(e); }
  {
    const vert_id kept = m.tables().adj_e2v(e)[0];
    if (!may_edit_directly(m) || !m.tables().collapse_edge(e)) return false;
    m.points()[kept.raw()] = x;
    count_edit(m);
    return true;
  }
  static edit_state<typename M::native>& edits(M& m) { return m.edits(); }
  static correspondence garbage_collect(M& m) {
    if (is_recorded(m))
      throw unsupported(
          "garbage_collect: elements cannot be renumbered while a transaction is open; call it before or after");
    correspondence c = m.garbage_collect();
    count_edit(m);
    return c;
  }
  static void reserve_removal(M& m, std::span<const poly_id> polys) { m.tables().reserve_removal(polys); }
  static void remove_poly(M& m, poly_id p) {
    if (is_recorded(m)) {
      std::vector<vert_id> all;
      for (const vert_id v : m.tables().adj_p2v(p)) all.push_back(v);
      edit_by_rewire(m, {.polys = {&p, &p + 1}, .verts = {all.data(), all.data() + all.size()}});
      return;
    }
    m.tables().remove_poly(p);
    count_edit(m);
  }
  static void remove_face(M& m, face_id f)
    requires requires { m.tables().remove_face(f); }
  {
    edit_step<typename M::native> step(m);
    m.tables().remove_face(f, step.log());
    step.finish();
  }

 private:
  static auto growing(M& m) {
    return [&m](const index_bounds& after) { m.properties().grow(bounds_of(m.tables()), after); };
  }
  static bool may_edit_directly(M& m) { return !is_recorded(m) && m.properties().size() == 0; }
  static bool is_recorded(M& m) { return m.edits().recorder != nullptr; }
  static void remove_faces_without_polys(M& m, vert_id v) {
    if constexpr (requires(face_id f) { m.tables().remove_face(f); }) {
      std::vector<face_id> all;
      for (const face_id f : m.tables().adj_v2f(v))
        if (num_elements(m.tables().adj_f2p(f)) == 0) all.push_back(f);
      for (const face_id f : all) remove_face(m, f);
    }
  }
  static void count_edit(M& m) { m.edits().version = ++m.edits().last_version; }
  struct new_elements {
    vert_id vert;
    poly_id poly;
  };
  /// An edit that adds at most one vert and one poly, as rewire does it, which can be undone.
  static new_elements edit_by_rewire(M& m, const native_cavity& c) {
    new_elements made;
    if constexpr (can_be_undone<M>) rewire(m, c, {&made.vert, &made.poly});
    return made;
  }
};

}  // namespace concino::detail
