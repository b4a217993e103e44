// Construction of mesh views (view_tri and so on) from arrays: the description of an array type by its adapter, checks
// of shapes and indices, tables.
#pragma once

#include <concino/core/error.hpp>
#include <concino/mesh/array_view.hpp>
#include <concino/mesh/cell_tables.hpp>
#include <concino/mesh/corner_orders.hpp>
#include <concino/mesh/detail/views/input_lists.hpp>
#include <concino/mesh/polyhedra_tables.hpp>
#include <concino/mesh/surface_tables.hpp>

#include <concepts>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino::detail {

/// How arrays of type A are read; adapters specialise it.
///   is_view       whether copies of an A refer to the same data, so that a temporary A is allowed
///   rows<N>(a)    r.row(i)[k] with k < N, r.size(), r.columns (0: not fixed), r.shape_error(N): "" or what is wrong
///   with the shape flat(a)       f.numbers()[i] with i < f.size()
/// Both take an A or a const A. What they return is cheap to copy and has no reference to an A that is a view.
template<class A>
struct array_source {
  static constexpr bool is_view = false;
};
template<class A> using source_of = array_source<std::remove_cvref_t<A>>;

template<class A> auto flat_of(A& a) { return source_of<A>::flat(a); }
template<unsigned N, class A> auto rows_of(A& a) { return source_of<A>::template rows<N>(a); }
template<class A> using flat_in = decltype(detail::flat_of(std::declval<std::remove_reference_t<A>&>()));
template<class A, unsigned N> using rows_in = decltype(detail::rows_of<N>(std::declval<std::remove_reference_t<A>&>()));

template<class T> concept index_number = std::integral<T> && !std::same_as<T, bool>;
template<class R> using number_in_row = std::remove_cvref_t<decltype(std::declval<const R&>().row(0)[0])>;
template<class A> using number_in = typename decltype(std::declval<const flat_in<A>&>().numbers())::number;

template<class A>
concept holds_points = requires(std::remove_reference_t<A>& a) { source_of<A>::template rows<3>(a); } &&
                       std::floating_point<number_in_row<rows_in<A, 3>>> &&
                       (rows_in<A, 3>::columns == 0 || rows_in<A, 3>::columns == 2 || rows_in<A, 3>::columns == 3);
template<class A, unsigned N> concept holds_lists = requires(std::remove_reference_t<A>& a) {
  typename decltype(source_of<A>::template rows<N>(a).row(0))::number;
}
&&index_number<number_in_row<rows_in<A, N>>> && (rows_in<A, N>::columns == 0 || rows_in<A, N>::columns == N);
template<class A> concept holds_numbers = requires(std::remove_reference_t<A>& a) { source_of<A>::flat(a); };
template<class A> concept holds_indices = holds_numbers<A> && index_number<number_in<A>>;

/// An index as a number in a message, whatever its integer type (char too).
template<class I>
core::message_piece index_piece(I x) {
  return x < 0 ? core::message_piece(static_cast<std::int64_t>(x)) : core::message_piece(static_cast<std::uint64_t>(x));
}
template<class I>
bool is_below(I x, std::size_t bound) {
  return x >= 0 && static_cast<std::uint64_t>(x) < bound;
}

template<class A>
auto wrap_points(A& a, const char* caller) {
  const auto rows = detail::rows_of<3>(a);
  constexpr unsigned width = decltype(rows)::columns == 2 ? 2 : 3;
  if (const std::string bad = rows.shape_error(width); !bad.empty())
    core::throw_joined<invalid_mesh>({caller, ": the array of points ", bad});
  return points_in_rows<std::remove_const_t<decltype(rows)>>(rows);
}

template<unsigned N, class A>
auto checked_rows_of(A& a, const char* caller) {
  const auto rows = detail::rows_of<N>(a);
  if (const std::string bad = rows.shape_error(N); !bad.empty())
    core::throw_joined<invalid_mesh>({caller, ": the array of polys ", bad});
  return rows;
}
template<unsigned N, class A>
auto lists_of(A& a, const char* caller) {
  const auto rows = detail::checked_rows_of<N>(a, caller);
  return lists_in_rows<std::remove_const_t<decltype(rows)>, N>(rows);
}
template<unsigned N, class A>
auto lists_of(A& a, const char* caller, const std::uint8_t* permutation) {
  using reordered = reordered_rows<decltype(detail::checked_rows_of<N>(a, caller))>;
  return lists_in_rows<reordered, N>(reordered(detail::checked_rows_of<N>(a, caller), permutation));
}

template<class O, class I>
auto lists_of(O& input_offsets, I& indices, const char* caller, const char* what) {
  const auto first = detail::flat_of(input_offsets);
  const auto flat = detail::flat_of(indices);
  const auto fail = [&](const std::string& why) {
    core::throw_joined<invalid_mesh>({caller, ": the offsets of ", what, "s ", why});
  };
  if (flat.size() >= ~0u) core::throw_joined<unsupported>({caller, ": more than 2^32 indices"});
  offsets where(first.size());
  for (std::size_t i = 0; i < where.size(); ++i) {
    const auto x = first.numbers()[i];
    if (!is_below(x, flat.size() + 1))
      fail(core::joined({"have ", index_piece(x), " at position ", i, ", but there are ", flat.size(), " indices"}));
    where[i] = static_cast<std::uint32_t>(x);
    if (i == 0 && x != 0) fail(core::joined({"begin with ", index_piece(x), "; they must begin with 0"}));
    if (i > 0 && where[i] < where[i - 1])
      fail(core::joined({"decrease at position ", i, ", from ", where[i - 1], " to ", index_piece(x)}));
  }
  if (where.empty()) where.push_back(0);
  if (where.back() != flat.size())
    fail(core::joined({"end with ", where.back(), ", but there are ", flat.size(), " indices"}));
  return lists_between<std::remove_const_t<decltype(flat)>>(flat, std::move(where));
}

/// Throws on indices that could look valid once they are cut to 32 bits; the tables check the rest.
template<class Lists>
void check_indices(const Lists& lists, std::size_t bound, const char* caller, const char* what) {
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const auto numbers = lists.numbers(i);
    for (std::uint32_t k = 0; k < lists.length(i); ++k)
      if (!is_below(numbers[k], bound))
        core::throw_joined<invalid_mesh>({caller, ": ", what, " ", i, " names point ", index_piece(numbers[k]),
                                          ", but there are ", bound, " points, numbered from 0"});
  }
}

/// A copy that exists only during construction: so the same code builds tables from all array types.
template<class Id, class Lists>
std::vector<Id> copied(const Lists& lists) {
  std::vector<Id> all;
  all.reserve(lists.num_values());
  for (std::size_t i = 0; i < lists.size(); ++i)
    for (const vert_id v : lists[i]) all.push_back(Id{v.raw()});
  return all;
}

template<int Dimension, int Arity, class Points, class Tables>
auto construct_view(const Points& points, Tables tables) {
  return views::array_view<Dimension, Arity, Points, Tables>(points, std::move(tables));
}

template<class Lists> using tri_tables_of = surface_tables<3, Lists>;
template<class Lists> using quad_tables_of = surface_tables<4, Lists>;
template<class Lists> using tet_tables_of = cell_tables<tet_shape, Lists>;
template<class Lists> using hex_tables_of = cell_tables<hex_shape, Lists>;

template<int Dimension, int Arity, template<class> class Tables, class Points, class Lists>
auto view_of_rows(const Points& points, const Lists& lists, const char* caller) {
  check_indices(lists, points.size(), caller, "poly");
  return construct_view<Dimension, Arity>(
      points, Tables<Lists>(Tables<jagged_array<vert_id, Arity>>(points.size(), copied<vert_id>(lists)), lists));
}

template<int Dimension, int Arity, template<class> class Tables, class P, class F>
auto view_of_lists(P& input_points, F& poly_verts, const char* caller) {
  const auto points = detail::wrap_points(input_points, caller);  // first, so that wrong points are reported first
  return view_of_rows<Dimension, Arity, Tables>(points, detail::lists_of<Arity>(poly_verts, caller), caller);
}

/// The same for lists in another order than the standard one.
template<template<class> class Tables, class P, class F, class Order>
auto view_of_cells(P& input_points, F& poly_verts, Order order, const char* caller) {
  constexpr unsigned n = corners_in(Order{});
  const auto points = detail::wrap_points(input_points, caller);
  return view_of_rows<3, n, Tables>(points, detail::lists_of<n>(poly_verts, caller, permutation_of(order)), caller);
}

template<class P, class O, class I>
auto view_of_polygons(P& input_points, O& input_offsets, I& indices, const char* caller) {
  const auto points = detail::wrap_points(input_points, caller);
  const auto lists = detail::lists_of(input_offsets, indices, caller, "poly");
  check_indices(lists, points.size(), caller, "poly");
  using tables = surface_tables<0, std::remove_const_t<decltype(lists)>>;
  return construct_view<2, 0>(
      points, tables(surface_tables<0>(points.size(), *lists.shared_offsets(), copied<vert_id>(lists)), lists));
}

/// Tag: a face is given by its number, or by the complement of its number if it is not oriented outward.
struct signs {};

template<class W>
std::vector<std::uint8_t> flags_in(W& outward) {
  const auto flat = detail::flat_of(outward);
  std::vector<std::uint8_t> flags(flat.size());
  for (std::size_t k = 0; k < flags.size(); ++k) flags[k] = flat.numbers()[k] != 0;
  return flags;
}

template<class P, class FO, class FV, class PO, class PF, class Outward>
auto view_of_polyhedra(P& input_points, FO& face_offsets, FV& face_verts, PO& poly_offsets, PF& input_faces,
                       Outward outward, const char* caller) {
  const auto points = detail::wrap_points(input_points, caller);
  const auto faces = detail::lists_of(face_offsets, face_verts, caller, "face");
  check_indices(faces, points.size(), caller, "face");
  const auto poly_lists = detail::lists_of(poly_offsets, input_faces, caller, "poly");
  std::vector<face_id> poly_faces;
  poly_faces.reserve(poly_lists.num_values());
  std::vector<std::uint8_t> flags;
  if constexpr (!std::same_as<Outward, signs>) flags = std::move(outward);
  for (std::size_t p = 0; p < poly_lists.size(); ++p) {
    const auto numbers = poly_lists.numbers(p);
    for (std::uint32_t k = 0; k < poly_lists.length(p); ++k) {
      auto f = numbers[k];
      if constexpr (std::same_as<Outward, signs>) {
        flags.push_back(f >= 0);
        if (f < 0) f = static_cast<decltype(f)>(~f);
      }
      if (!is_below(f, faces.size()))
        core::throw_joined<invalid_mesh>({caller, ": poly ", p, " names face ", index_piece(f), ", but there are ",
                                          faces.size(), " faces, numbered from 0"});
      poly_faces.push_back(face_id{f});
    }
  }
  if (flags.size() != poly_faces.size())
    core::throw_joined<invalid_mesh>({caller, ": ", flags.size(), " outward flags were given for ", poly_faces.size(),
                                " faces of polys; each needs one"});
  polyhedra_tables built(points.size(), *faces.shared_offsets(), copied<vert_id>(faces), *poly_lists.shared_offsets(),
                         std::move(poly_faces), std::move(flags));
  using tables = basic_polyhedra_tables<std::remove_const_t<decltype(faces)>>;
  return construct_view<3, 0>(points, tables(std::move(built), faces));
}

}  // namespace concino::detail
