// array_view: the type of the meshes that view_tri, view_quad and so on return. Coordinates and the verts of polys are
// read from the user's arrays; all other adjacencies are stored in tables. Not part of <concino/mesh.hpp>, as
// view_arrays.hpp.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/concepts/views/forward.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/indexed_base.hpp>

#include <memory>
#include <type_traits>
#include <utility>

namespace concino {

namespace views {

/// A mesh over arrays. Points: points[i] is a vec3, points.size(). Copies share the tables. Dimension and Arity as in
/// mesh_traits; Arity 0: not fixed.
template<int Dimension, int Arity, class Points, class Tables>
class array_view {
  Points points_;
  std::shared_ptr<const Tables> tables_;

 public:
  array_view(Points points, Tables tables)
      : points_(std::move(points)), tables_(std::make_shared<const Tables>(std::move(tables))) {}
  const Points& points() const { return points_; }
  const Tables& tables() const { return *tables_; }
};

}  // namespace views

namespace detail {

/// Points in the rows of an array: rows.row(i)[0 .. 2], or [0 .. 1] of flat meshes.
template<class Rows>
class points_in_rows {
  Rows rows_;
  static constexpr bool is_flat = Rows::columns == 2;

 public:
  explicit points_in_rows(Rows r) : rows_(std::move(r)) {}
  std::size_t size() const { return rows_.size(); }
  vec3 operator[](std::size_t i) const {
    auto&& p = rows_.row(i);
    if constexpr (is_flat) return {p[0], p[1], 0};
    else return {p[0], p[1], p[2]};
  }
  template<class P>
  void set(std::size_t i, const P& p) const
    requires(!is_flat) && requires(const Rows& r) { r.row(i)[0] = 0; }
  {
    auto&& row = rows_.row(i);
    using number = std::remove_cvref_t<decltype(row[0])>;
    row[0] = static_cast<number>(p[0]);
    row[1] = static_cast<number>(p[1]);
    row[2] = static_cast<number>(p[2]);
  }
};

}  // namespace detail

template<int Dimension, int Arity, class Points, class Tables>
struct mesh_traits<views::array_view<Dimension, Arity, Points, Tables>>
    : std::conditional_t<Dimension == 2, indexed_surface<views::array_view<Dimension, Arity, Points, Tables>>,
                         indexed_volume<views::array_view<Dimension, Arity, Points, Tables>>>,
      detail::fixed_arity<Arity> {
  using view = views::array_view<Dimension, Arity, Points, Tables>;
  static constexpr bool is_view = true;
  static const Tables& tables(const view& m) { return m.tables(); }
  static vec3 point(const view& m, vert_id v) { return m.points()[v.raw()]; }
  template<class P>
  static void set_point(view& m, vert_id v, const P& p)
    requires requires { m.points().set(v.raw(), p); }
  {
    m.points().set(v.raw(), p);
  }
};

}  // namespace concino
