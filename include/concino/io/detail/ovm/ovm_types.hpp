// The kinds and types of properties in .ovm files.
#pragma once

#include <concino/io/detail/vtk/vtk_numbers.hpp>
#include <concino/mesh/property_set.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

/// The elements that a property belongs to. Half-edges and half-faces are the two orientations of edges and faces;
/// half-edge 2e + 1 is edge e reversed, and so on.
struct ovm_kind {
  std::string_view word, lower;
  element_kind kind;
  bool is_half = false;
};
inline constexpr ovm_kind ovm_kinds[] = {
    {"VProp", "vprop", element_kind::vert},         {"EProp", "eprop", element_kind::edge},
    {"HEProp", "heprop", element_kind::edge, true}, {"FProp", "fprop", element_kind::face},
    {"HFProp", "hfprop", element_kind::face, true}, {"CProp", "cprop", element_kind::poly},
    {"MProp", "mprop", element_kind::mesh}};

/// What the values of a property are: numbers, or single characters, or strings, or lists of doubles.
enum class ovm_form : std::uint8_t { numbers, characters, string, list };

struct ovm_type {
  std::string_view name;
  vtk_number number;
  std::size_t components;
  ovm_form form = ovm_form::numbers;
};
inline constexpr ovm_type ovm_types[] = {
    {"int", vtk_number::int32, 1},
    {"uint", vtk_number::uint32, 1},
    {"short", vtk_number::int16, 1},
    {"long", vtk_number::int64, 1},
    {"ulong", vtk_number::uint64, 1},
    {"char", vtk_number::int8, 1, ovm_form::characters},
    {"uchar", vtk_number::uint8, 1, ovm_form::characters},
    {"bool", vtk_number::bit, 1},
    {"float", vtk_number::float32, 1},
    {"double", vtk_number::float64, 1},
    {"vec2f", vtk_number::float32, 2},
    {"vec2d", vtk_number::float64, 2},
    {"vec2i", vtk_number::int32, 2},
    {"vec2ui", vtk_number::uint32, 2},
    {"vec3f", vtk_number::float32, 3},
    {"vec3d", vtk_number::float64, 3},
    {"vec3i", vtk_number::int32, 3},
    {"vec3ui", vtk_number::uint32, 3},
    {"vec4f", vtk_number::float32, 4},
    {"vec4d", vtk_number::float64, 4},
    {"vec4i", vtk_number::int32, 4},
    {"vec4ui", vtk_number::uint32, 4},
    {"string", vtk_number::none, 1, ovm_form::string},
    {"vector_double", vtk_number::float64, 0, ovm_form::list}};

/// The type of that name, in lower case; null if no property of a mesh has its values.
inline const ovm_type* ovm_type_of(std::string_view name) {
  for (const ovm_type& t : ovm_types)
    if (t.name == name) return &t;
  return nullptr;
}
/// The type of the values of a property; null if a file cannot hold them.
inline const ovm_type* ovm_type_of(const std::type_info& type) {
  if (type == typeid(std::string)) return ovm_type_of("string");
  if (type == typeid(std::vector<double>)) return ovm_type_of("vector_double");
  const vtk_property_type v = vtk_type_of(type);
  for (const ovm_type& t : ovm_types)
    if (t.form <= ovm_form::characters && t.number == v.number && t.components == v.components) return &t;
  return nullptr;
}

/// The type of the property with such values and that name.
inline const value_type& ovm_value_type(const ovm_type& t, std::string_view name) {
  if (t.form == ovm_form::string) return values_of<std::string>;
  if (t.form == ovm_form::list) return values_of<std::vector<double>>;
  return *property_type_of(t.number, t.components, name);
}

}  // namespace concino::detail
