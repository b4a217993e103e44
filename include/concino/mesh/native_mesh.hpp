// native_mesh: the common base class of the six native meshes, with points, adjacency tables and properties. Also the
// conversion of lists of points and of verts, as braced lists or containers, into flat arrays.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/message.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/detail/edits/edit_recorder.hpp>
#include <concino/mesh/element_origins.hpp>
#include <concino/mesh/indexed_base.hpp>
#include <concino/mesh/property_set.hpp>
#include <concino/mesh/surface_tables.hpp>

#include <concepts>
#include <initializer_list>
#include <optional>

namespace concino {

/// An index in a braced list: any integer, or a descriptor of the library.
class list_index {
  std::uint32_t raw_;

 public:
  template<std::integral I>
  constexpr list_index(I i)
      : raw_(i < 0 || static_cast<std::uint64_t>(i) >= ~0u ? ~0u : static_cast<std::uint32_t>(i)) {}
  template<class Tag>
  constexpr list_index(id<Tag> x) : raw_(x.raw()) {}
  constexpr std::uint32_t raw() const { return raw_; }
};

/// A face of a polyhedron in a braced list: {face, whether its verts run counter-clockwise seen from outside}.
struct list_face {
  list_index face;
  bool outward;
};

using point_list = std::initializer_list<vec3>;
using index_lists = std::initializer_list<std::initializer_list<list_index>>;
using face_lists = std::initializer_list<std::initializer_list<list_face>>;

namespace detail {

template<class R> concept PointRange = requires(const R& r) { (*std::begin(r))[0]; (*std::begin(r))[2]; };
template<class R> concept IndexRange = requires(const R& r) { list_index(*std::begin(r)); };
template<class R> concept IndexListRange = requires(const R& r) {
  requires IndexRange<std::remove_cvref_t<decltype(*std::begin(r))>>;
};

template<class R>
std::vector<vec3> to_points(const R& r) {
  std::vector<vec3> points;
  for (const auto& p : r) points.push_back(to_vec3(p));
  return points;
}

/// Lists stored one after another; offsets are where each begins. If `arity` is given, every list must have that many
/// entries. Errors name `mesh`.
template<class R>
surface_arrays to_surface(std::vector<vec3> points, const R& lists, std::uint32_t arity, const char* mesh) {
  surface_arrays a;
  a.points = std::move(points);
  a.arity = arity;
  if (!arity) a.offsets.push_back(0);
  std::size_t p = 0;
  for (const auto& list : lists) {
    const std::size_t before = a.verts.size();
    for (const auto& i : list) a.verts.push_back(vert_id{list_index(i).raw()});
    const std::size_t n = a.verts.size() - before;
    if (arity && n != arity)
      core::throw_joined<invalid_mesh>({mesh, ": poly ", p, " has ", n, " verts; every poly of this mesh has ", arity});
    if (!arity) a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
    ++p;
  }
  return a;
}

/// The same polys, stored as lists of `arity` verts, or with offsets if `arity` is 0.
surface_arrays to_arity(surface_arrays a, std::uint32_t arity);

template<class R>
cell_arrays to_cells(std::vector<vec3> points, const R& lists, std::uint32_t arity) {
  surface_arrays a = to_surface(std::move(points), lists, arity, arity == 4 ? "tetmesh" : "hexmesh");
  return {std::move(a.points), std::move(a.verts), arity};
}

template<class Faces, class Polys>
polyhedra_arrays polyhedra_arrays_from(std::vector<vec3> points, const Faces& face_lists, const Polys& poly_lists) {
  surface_arrays a = to_surface(std::move(points), face_lists, 0, "polyhedralmesh");
  polyhedra_arrays b{std::move(a.points), std::move(a.offsets), std::move(a.verts), {0}, {}, {}};
  for (const auto& poly : poly_lists) {
    for (const auto& [face, outward] : poly) {
      b.poly_faces.push_back(face_id{list_index(face).raw()});
      b.outward.push_back(outward ? 1 : 0);
    }
    b.poly_offsets.push_back(static_cast<std::uint32_t>(b.poly_faces.size()));
  }
  return b;
}

/// Points, connectivity, properties. Copies are deep; a moved-from mesh is empty.
template<class Tables>
class native_mesh {
  std::vector<vec3> points_;
  Tables tables_;
  property_set properties_;
  edit_state<native_mesh> edits_;

 protected:
  native_mesh(std::vector<vec3> points, Tables tables);

 public:
  using native = native_mesh;
  using tables_type = Tables;

  native_mesh();
  native_mesh(const native_mesh&);
  native_mesh(native_mesh&&) noexcept;
  native_mesh& operator=(const native_mesh&);  // strong exception guarantee
  native_mesh& operator=(native_mesh&&) noexcept;
  ~native_mesh();

  const std::vector<vec3>& points() const { return points_; }
  std::vector<vec3>& points() { return points_; }
  const Tables& tables() const { return tables_; }
  Tables& tables() { return tables_; }
  const property_set& properties() const { return properties_; }
  property_set& properties() { return properties_; }
  edit_state<native_mesh>& edits() { return edits_; }

  /// Numbers the elements without gaps, in the same order. Strong exception guarantee.
  correspondence garbage_collect();
};

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

}  // namespace detail

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/mesh/detail/meshes/native_mesh.ipp>
#endif
