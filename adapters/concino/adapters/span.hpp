// Adapter for meshes in plain arrays: std::span, and, as named variables, std::vector, std::array and all else from
// which a span can be made.
//
//   std::vector<double> xyz;  std::vector<int> corners;                    // three numbers per point; three, four or
//   eight per poly auto tri = cn::view_tri(xyz, corners);                                 // also view_quad, view_tet,
//   view_hex std::span<const std::array<float, 3>> p;  std::span<const std::array<unsigned, 4>> t;
//   auto tet = cn::view_tet(p, t);                                         // or arrays of points and of lists
//   auto poly = cn::view_polygons(points, offsets, indices);               // and view_polyhedra
//
// Points are floats or doubles in groups of three, std::array of two (z is 0) or three, or any type with p[0], p[1],
// p[2]. Lists of verts are integers of any type, in groups of three, four or eight, or std::array of as many. A
// container is stored by address, so its memory may be reallocated (xyz = smoothed(xyz)); a span is stored by value.
// Needs: the standard library only.
#pragma once

#include <concino/core/message.hpp>
#include <concino/mesh/view_arrays.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <type_traits>

namespace concino::detail {

template<class A> inline constexpr bool is_span = false;
template<class T, std::size_t N> inline constexpr bool is_span<std::span<T, N>> = true;
template<class T> inline constexpr std::size_t array_size = 0;
template<class T, std::size_t N> inline constexpr std::size_t array_size<std::array<T, N>> = N;

/// A type from which a span can be made, except Eigen's vectors: <concino/adapters/eigen.hpp> reads those.
template<class A> concept spannable = !requires { typename A::PlainObject; } && requires(A& a) { std::span(a); };

/// An array; A is const if it is read-only. A container is stored by address, a span by value.
template<class A>
class span_storage {
  std::conditional_t<is_span<std::remove_const_t<A>>, std::remove_const_t<A>, A*> kept_;

 public:
  explicit span_storage(A& a)
      : kept_([&] {
          if constexpr (is_span<std::remove_const_t<A>>) return a;
          else return &a;
        }()) {}
  auto get() const {
    if constexpr (is_span<std::remove_const_t<A>>) return kept_;
    else return std::span(*kept_);
  }
  using element = typename decltype(std::span(std::declval<A&>()))::element_type;
};

/// Consecutive numbers, N of them per row.
template<class A, unsigned N>
class rows_of_numbers : span_storage<A> {
 public:
  static constexpr unsigned columns = N;
  using span_storage<A>::span_storage;
  std::size_t size() const { return this->get().size() / N; }
  auto row(std::size_t i) const { return strided(this->get().data() + i * N); }
  std::string shape_error(unsigned) const {
    const std::size_t n = this->get().size();
    if (n % N == 0) return {};
    return core::joined({"has ", n, " numbers; it needs ", N, " for each"});
  }
  auto numbers() const
    requires(N == 1)
  {
    return strided(this->get().data());
  }
};

/// Objects, each of which is a row.
template<class A>
class rows_of_objects : span_storage<A> {
  using object = std::remove_const_t<typename span_storage<A>::element>;

 public:
  static constexpr std::size_t columns = array_size<object> ? array_size<object> : 3;
  using span_storage<A>::span_storage;
  std::size_t size() const { return this->get().size(); }
  decltype(auto) row(std::size_t i) const {
    if constexpr (array_size<object> > 0) return strided(this->get()[i].data());
    else return this->get()[i];
  }
  std::string shape_error(unsigned) const { return {}; }
};

template<spannable A>
struct array_source<A> {
  using number_or_object = std::remove_const_t<typename span_storage<A>::element>;
  static constexpr bool is_view = is_span<A>;

  template<unsigned N, class T>
  static auto rows(T& a) {
    if constexpr (std::is_arithmetic_v<number_or_object>) return rows_of_numbers<T, N>(a);
    else return rows_of_objects<T>(a);
  }
  template<class T>
    requires std::is_arithmetic_v<number_or_object>
  static auto flat(T& a) { return rows_of_numbers<T, 1>(a); }
};

}  // namespace concino::detail
