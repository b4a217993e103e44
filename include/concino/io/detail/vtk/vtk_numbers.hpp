// The number types of VTK's files: their names, sizes, and the types of properties that hold them.
#pragma once

#include <concino/core/rgba.hpp>
#include <concino/core/vec3.hpp>
#include <concino/mesh/property_set.hpp>

#include <array>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <string_view>
#include <type_traits>

namespace concino::detail {

/// A type of numbers in a file. `none`: the name is unknown, or stands for strings.
enum class vtk_number : std::uint8_t {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64,
  bit,
  none
};

struct vtk_number_names {
  std::string_view legacy, xml, fixed;  // in .vtk, in .vtu, and the name of fixed size in .vtk
  std::size_t size;
};
inline constexpr vtk_number_names vtk_numbers[] = {
    {"char", "Int8", "vtktypeint8", 1},
    {"unsigned_char", "UInt8", "vtktypeuint8", 1},
    {"short", "Int16", "vtktypeint16", 2},
    {"unsigned_short", "UInt16", "vtktypeuint16", 2},
    {"int", "Int32", "vtktypeint32", 4},
    {"unsigned_int", "UInt32", "vtktypeuint32", 4},
    {"long", "Int64", "vtktypeint64", 8},
    {"unsigned_long", "UInt64", "vtktypeuint64", 8},
    {"float", "Float32", "vtktypefloat32", 4},
    {"double", "Float64", "vtktypefloat64", 8},
    {"bit", "", "", 1},
};
inline const vtk_number_names& vtk_names_of(vtk_number t) { return vtk_numbers[static_cast<unsigned>(t)]; }

/// Whether integers of this type have a sign. Needs: a type of integers.
inline bool is_signed(vtk_number t) { return static_cast<unsigned>(t) % 2 == 0; }

inline vtk_number vtk_number_of_xml(std::string_view name) {
  for (unsigned i = 0; i + 1 < std::size(vtk_numbers); ++i)
    if (vtk_numbers[i].xml == name) return static_cast<vtk_number>(i);
  return vtk_number::none;
}
/// The name is in lower case. Ids are written as 32-bit integers.
inline vtk_number vtk_number_of_legacy(std::string_view name) {
  for (unsigned i = 0; i < std::size(vtk_numbers); ++i)
    if (vtk_numbers[i].legacy == name || (!vtk_numbers[i].fixed.empty() && vtk_numbers[i].fixed == name))
      return static_cast<vtk_number>(i);
  if (name == "vtkidtype") return vtk_number::int32;
  if (name == "signed_char") return vtk_number::int8;
  if (name == "long_long" || name == "vtktypeint64") return vtk_number::int64;
  if (name == "unsigned_long_long") return vtk_number::uint64;
  return vtk_number::none;
}

/// Calls f(std::type_identity<T>()) with the type of the numbers. Needs: not `none`.
template<class F>
decltype(auto) with_number_type(vtk_number t, const F& f) {
  switch (t) {
    case vtk_number::int8: return f(std::type_identity<std::int8_t>{});
    case vtk_number::uint8: return f(std::type_identity<std::uint8_t>{});
    case vtk_number::int16: return f(std::type_identity<std::int16_t>{});
    case vtk_number::uint16: return f(std::type_identity<std::uint16_t>{});
    case vtk_number::int32: return f(std::type_identity<std::int32_t>{});
    case vtk_number::uint32: return f(std::type_identity<std::uint32_t>{});
    case vtk_number::int64: return f(std::type_identity<std::int64_t>{});
    case vtk_number::uint64: return f(std::type_identity<std::uint64_t>{});
    case vtk_number::float32: return f(std::type_identity<float>{});
    case vtk_number::float64: return f(std::type_identity<double>{});
    default: return f(std::type_identity<bool>{});
  }
}

/// Numbers of components that properties of VTK files can have. Others are skipped.
inline constexpr std::size_t vtk_component_counts[] = {1, 2, 3, 4, 6, 9};

template<class T>
inline constexpr const value_type* value_types_of[] = {&values_of<T>,
                                                       &values_of<std::array<T, 2>>,
                                                       &values_of<std::array<T, 3>>,
                                                       &values_of<std::array<T, 4>>,
                                                       &values_of<std::array<T, 6>>,
                                                       &values_of<std::array<T, 9>>};
template<>
inline constexpr const value_type* value_types_of<bool>[] = {&values_of<bool>, nullptr, nullptr,
                                                             nullptr,          nullptr, nullptr};
inline constexpr const value_type* const* vtk_value_types[] = {
    value_types_of<std::int8_t>,   value_types_of<std::uint8_t>,  value_types_of<std::int16_t>,
    value_types_of<std::uint16_t>, value_types_of<std::int32_t>,  value_types_of<std::uint32_t>,
    value_types_of<std::int64_t>,  value_types_of<std::uint64_t>, value_types_of<float>,
    value_types_of<double>,        value_types_of<bool>};

/// The type of a property with so many numbers per element: vec3 for three doubles, rgba for four floats called
/// "color", else T or std::array<T, n>. Null if there is none.
inline const value_type* property_type_of(vtk_number t, std::size_t components, std::string_view name) {
  if (t == vtk_number::none) return nullptr;
  if (t == vtk_number::float32 && components == 4 && name == "color") return &values_of<rgba>;
  if (t == vtk_number::float64 && components == 3) return &values_of<vec3>;
  for (unsigned i = 0; i < std::size(vtk_component_counts); ++i)
    if (vtk_component_counts[i] == components) return vtk_value_types[static_cast<unsigned>(t)][i];
  return nullptr;
}

/// The numbers of which the values of a property consist; `none` if a VTK file cannot hold them.
struct vtk_property_type {
  vtk_number number = vtk_number::none;
  std::size_t components = 0;
};
inline vtk_property_type vtk_type_of(const std::type_info& type) {
  for (unsigned i = 0; i < std::size(vtk_numbers); ++i)
    for (const std::size_t n : vtk_component_counts)
      if (const value_type* v = property_type_of(static_cast<vtk_number>(i), n, ""); v && *v->type == type)
        return {static_cast<vtk_number>(i), n};
  if (type == typeid(rgba)) return {vtk_number::float32, 4};
  if (type == typeid(std::array<double, 3>)) return {vtk_number::float64, 3};
  return {};
}

template<class T>
void swap_bytes_of(unsigned char* p, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i, p += sizeof(T)) {
    T x;
    std::memcpy(&x, p, sizeof x);
    if constexpr (sizeof(T) == 2) x = __builtin_bswap16(x);
    else if constexpr (sizeof(T) == 4) x = __builtin_bswap32(x);
    else x = __builtin_bswap64(x);
    std::memcpy(p, &x, sizeof x);
  }
}

/// Reverses the bytes of each of n numbers of `size` bytes: between big-endian and little-endian.
inline void swap_bytes(void* numbers, std::size_t n, std::size_t size) {
  auto* const p = static_cast<unsigned char*>(numbers);
  if (size == 2) swap_bytes_of<std::uint16_t>(p, n);
  if (size == 4) swap_bytes_of<std::uint32_t>(p, n);
  if (size == 8) swap_bytes_of<std::uint64_t>(p, n);
}

}  // namespace concino::detail
