// Adapter for meshes in Eigen matrices, as in libigl: V has a row of coordinates per vert; F has a row of indices per
// poly.
//
//   Eigen::MatrixXd V;  Eigen::MatrixXi F;
//   auto tri = cn::view_tri(V, F);                                 // also view_quad, view_tet, view_hex
//   auto u = cn::harmonic_map(tri, {{a, 0.0}, {b, 1.0}});          // nothing of V and F was copied
//   V.col(2) *= 2;                                                 // tri has the new coordinates
//   auto poly = cn::view_polygons(V, offsets, indices);            // and view_polyhedra: vectors of integers
//
// Supported: Matrix and Array, row-major or column-major, of fixed or dynamic size, of floats or doubles and of any
// integers; Map and Ref; and, as named variables, Block, Transpose and other expressions that refer to storage:
//
//   auto points = V3xN.transpose();  auto tris = F3xN.transpose();  auto tri = cn::view_tri(points, tris);
//
// A Matrix is stored by address, so its memory may be reallocated (V = smoothed(V)); of the others the memory address
// is stored.
// Needs: Eigen 3.4 (Debian: libeigen3-dev).
#pragma once

#include <concino/core/message.hpp>
#include <concino/mesh/view_arrays.hpp>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>

namespace concino::detail {

template<class X> X eigen_type(const Eigen::DenseBase<X>&);
/// The Eigen type of A, which may be a class that the user derived from it.
template<class A> using eigen_in = decltype(detail::eigen_type(std::declval<const A&>()));
template<class A> concept eigen_array = requires { typename eigen_in<A>; }
&&(eigen_in<A>::Flags& Eigen::DirectAccessBit) != 0;

template<class X> inline constexpr bool is_eigen_pointer = false;
template<class X, int A, class S> inline constexpr bool is_eigen_pointer<Eigen::Map<X, A, S>> = true;
// A Ref to const may own a copy of its argument, so it must be a named variable.
template<class X, int A, class S> inline constexpr bool is_eigen_pointer<Eigen::Ref<X, A, S>> = !std::is_const_v<X>;

constexpr std::ptrdiff_t eigen_step(int at_compile_time) {
  return at_compile_time == Eigen::Dynamic ? 0 : at_compile_time;
}

/// The storage of the numbers of an array. X is its Eigen type, T the type of its numbers, const if they are read-only.
/// Flat: a row or column vector, used as a list of consecutive numbers.
template<class X, class T, bool Flat>
class eigen_layout {
  static constexpr std::ptrdiff_t inner = eigen_step(X::InnerStrideAtCompileTime),
                                  outer = eigen_step(X::OuterStrideAtCompileTime);
  static constexpr std::ptrdiff_t inner_row_stride = X::IsRowMajor ? outer : inner,
                                  inner_column_stride = X::IsRowMajor ? inner : outer;
  using matrix = std::conditional_t<std::is_const_v<T>, const X, X>;
  struct storage {
    T* start;
    Eigen::Index num_rows, num_columns;
    step_of<inner_row_stride> row_step;
    step_of<inner_column_stride> column_step;
    T* data() const { return start; }
    Eigen::Index rows() const { return num_rows; }
    Eigen::Index cols() const { return num_columns; }
    std::ptrdiff_t rowStride() const { return row_step; }
    std::ptrdiff_t colStride() const { return column_step; }
  };
  static constexpr bool by_address = std::is_base_of_v<Eigen::PlainObjectBase<X>, X>;
  std::conditional_t<by_address, matrix*, storage> kept_;

  decltype(auto) at() const {
    if constexpr (by_address) return (*kept_);
    else return (kept_);
  }
  // Strides from the type, if it fixes them, so that the compiler knows them.
  step_of<inner_row_stride> row_step() const { return at().rowStride(); }
  step_of<inner_column_stride> column_step() const { return at().colStride(); }

 public:
  static constexpr int columns = X::ColsAtCompileTime == Eigen::Dynamic ? 0 : X::ColsAtCompileTime;

  template<class A>
    requires by_address
  explicit eigen_layout(A& a) : kept_(&a) {}
  template<class A>
  explicit eigen_layout(A& a) : kept_{a.data(), a.rows(), a.cols(), a.rowStride(), a.colStride()} {}

  std::string shape_error(unsigned wanted) const {
    if (at().rows() == 0 || at().cols() == static_cast<Eigen::Index>(wanted)) return {};
    return core::joined({"has ", at().cols(), " columns; it needs ", wanted,
                   wanted == 3 && at().cols() == 2 ? ", or a type with 2 columns such as Eigen::MatrixX2d" : ""});
  }
  std::size_t size() const { return static_cast<std::size_t>(Flat ? at().rows() * at().cols() : at().rows()); }
  auto row(std::size_t i) const
    requires(!Flat)
  {
    return strided<T, inner_column_stride>(at().data() + static_cast<std::ptrdiff_t>(i) * row_step(), column_step());
  }
  auto numbers() const
    requires Flat
  {
    if constexpr (X::ColsAtCompileTime == 1) return strided<T, inner_row_stride>(at().data(), row_step());
    else return strided<T, inner_column_stride>(at().data(), column_step());
  }
};

template<eigen_array A>
struct array_source<A> {
  using X = eigen_in<A>;
  static constexpr bool is_view = is_eigen_pointer<X>;

  template<unsigned, class T>
  static auto rows(T& a) { return layout<false>(a); }
  template<class T>
    requires(X::IsVectorAtCompileTime == 1)
  static auto flat(T& a) { return layout<true>(a); }

 private:
  template<bool Flat, class T>
  static auto layout(T& a) {
    constexpr bool is_const = std::is_const_v<T> || !(X::Flags & Eigen::LvalueBit);
    using number = typename X::Scalar;
    return eigen_layout<X, std::conditional_t<is_const, const number, number>, Flat>(a);
  }
};

}  // namespace concino::detail
