// The properties that a PLY file holds for the elements of one kind.
#pragma once

#include <concino/io/detail/ply/ply_columns.hpp>
#include <concino/io/detail/text/write_common.hpp>
#include <concino/io/detail/vtk/vtk_output.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace concino::detail {

/// Writes numbers in the form of the file: as text, with a blank between two, or as little-endian bytes.
class ply_numbers_output {
  text_sink& out_;
  bool binary_;
  bool is_first_ = true;  // of the line

 public:
  ply_numbers_output(text_sink& out, bool binary) : out_(out), binary_(binary) {}

  void number(vtk_number type, const unsigned char* bytes) {
    if (!binary_) {
      if (!is_first_) out_ << ' ';
      is_first_ = false;
      return write_vtk_number(out_, type, bytes);
    }
    const std::size_t size = vtk_names_of(type).size;
    unsigned char swapped[8];
    std::memcpy(swapped, bytes, size);
    if constexpr (std::endian::native == std::endian::big) swap_bytes(swapped, 1, size);
    out_ << std::string_view(reinterpret_cast<const char*>(swapped), size);
  }
  template<class T>
  void number(vtk_number type, T x) {
    number(type, reinterpret_cast<const unsigned char*>(&x));
  }
  void real(double x) { number(vtk_number::float64, x); }
  void byte(unsigned x) { number(vtk_number::uint8, static_cast<std::uint8_t>(x)); }
  /// An integer that is not negative, as `int` or, if that is too small, `uint`, which have the same bytes.
  void integer(std::uint32_t i) { number(vtk_number::uint32, i); }
  void length(std::size_t n, bool is_byte) {
    if (is_byte) byte(static_cast<unsigned>(n));
    else integer(static_cast<std::uint32_t>(n));
  }
  void end_element() {
    if (!binary_) out_ << '\n';
    is_first_ = true;
  }
};

/// Whether a name of a property of one number means something else in a PLY file, so that it is written with %XX.
inline bool is_reserved_in_ply(std::string_view name) {
  for (const std::string_view x : {"x", "y", "z", "vertex1", "vertex2", "vertex_indices", "vertex_index", "texcoord"})
    if (name == x) return true;
  const auto has = [&](const auto& names) {
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
  };
  return has(ply_normal_names) || has(ply_color_names) || has(ply_diffuse_names) ||
         std::any_of(std::begin(ply_texture_names), std::end(ply_texture_names), has);
}

/// The name of a property as a word; that of a single number looks like none that readers take for part of a value.
inline std::string ply_word(std::string_view name, bool is_single) {
  const std::size_t line = name.rfind('_');
  const bool has_ending = is_single && line != name.npos && line + 1 < name.size() &&
                          (name.find_first_not_of("0123456789", line + 1) == name.npos ||
                           (line + 2 == name.size() && std::string_view("xyzw").find(name.back()) != name.npos));
  std::string word;
  for (std::size_t i = 0; i < name.size(); ++i)
    if (is_plain_in_name(name[i]) && !(i == 0 && is_single && is_reserved_in_ply(name)) && !(has_ending && i == line))
      word += name[i];
    else append_encoded(word, name[i]);
  return word;
}

/// A property of the mesh, as a PLY file has it.
struct ply_output_property {
  flat_property property;
  vtk_property_type type{};  // components: 0 for lists
  bool is_bytes = false;     // a colour of integers from 0 to 255; of lists: the length is a byte

  bool is_list() const { return type.components == 0; }
  bool is_color() const { return *property.type == typeid(rgba) && property.name == "color"; }
  std::size_t index(std::size_t i) const { return property.indices ? property.indices[i] : i; }
  const rgba& color(std::size_t i) const { return static_cast<const rgba*>(property.values)[index(i)]; }
  const unsigned char* bytes(std::size_t i) const {
    return static_cast<const unsigned char*>(property.values) + index(i) * type.components * size();
  }
  std::size_t size() const { return vtk_names_of(type.number).size; }
  /// Calls f(values) with the list of element i, a const std::vector<T>&.
  template<class F>
  void with_list(std::size_t i, const F& f) const {
    with_number_type(type.number, [&]<class T>(std::type_identity<T>) {
      if constexpr (!std::is_same_v<T, bool>) f(static_cast<const std::vector<T>*>(property.values)[index(i)]);
    });
  }
};

/// The properties of n elements of a kind that a file holds. Declares them as stored.
class ply_output {
  write_context& c_;

  /// The type of the numbers in lists of this type; `none` if it is no list.
  static vtk_number number_of_list(const std::type_info& type) {
    vtk_number found = vtk_number::none;
    for (std::size_t i = 0; i < 8; ++i)
      with_number_type(ply_numbers[i].number, [&]<class T>(std::type_identity<T>) {
        if (type == typeid(std::vector<T>)) found = ply_numbers[i].number;
      });
    return found;
  }

 public:
  std::vector<ply_output_property> all;

  ply_output(write_context& c, const std::vector<flat_property>& list, element_kind kind, std::size_t n) : c_(c) {
    for (const flat_property& p : list) {
      if (p.kind != kind || p.name.empty()) continue;
      ply_output_property x{p};
      x.type = vtk_type_of(*p.type);
      if (x.type.number == vtk_number::none) x.type.number = number_of_list(*p.type);
      if (x.type.number == vtk_number::none || ply_name_of(x.type.number).empty()) continue;
      x.is_bytes = true;
      for (std::size_t i = 0; i < n && x.is_bytes; ++i) {
        int bytes[4];
        if (x.is_color()) x.is_bytes = bytes_of(x.color(i), bytes);
        if (x.is_list()) x.with_list(i, [&](const auto& values) { x.is_bytes = values.size() < 256; });
      }
      c.declare_stored(kind, p.name, *p.type);
      all.push_back(std::move(x));
    }
  }

  void header() const {
    for (const ply_output_property& p : all) {
      const std::string_view type = ply_name_of(p.type.number);
      const std::string& name = p.property.name;
      const auto lines = [&](std::string_view t, const auto& names) {
        for (const std::string_view x : names) c_.out << "property " << t << ' ' << x << '\n';
      };
      if (p.is_list())
        c_.out << "property list " << (p.is_bytes ? "uchar " : "uint ") << type << ' ' << ply_word(name, true) << '\n';
      else if (p.is_color()) lines(p.is_bytes ? "uchar" : "float", ply_color_names);
      else if (is_normal(p)) lines(type, ply_normal_names);
      else if (is_texture(p)) lines(type, ply_texture_names[0]);
      else if (p.type.components == 1) c_.out << "property " << type << ' ' << ply_word(name, true) << '\n';
      else
        for (std::size_t k = 0; k < p.type.components; ++k)
          c_.out << "property " << type << ' ' << ply_word(name, false)
                 << (p.type.components > 4 ? ply_component_numbers : ply_component_names)[k] << '\n';
    }
  }

  void values(ply_numbers_output& out, std::size_t i) const {
    for (const ply_output_property& p : all) {
      int bytes[4];
      if (p.is_list()) {
        p.with_list(i, [&](const auto& values) {
          out.length(values.size(), p.is_bytes);
          for (const auto x : values) out.number(p.type.number, x);
        });
      } else if (p.is_color() && p.is_bytes) {
        bytes_of(p.color(i), bytes);
        for (const int b : bytes) out.byte(static_cast<unsigned>(b));
      } else if (p.is_color()) {
        for (const float x : {p.color(i).r, p.color(i).g, p.color(i).b, p.color(i).a})
          out.number(vtk_number::float32, c_.finite(x));
      } else {
        for (std::size_t k = 0; k < p.type.components; ++k) out.number(p.type.number, p.bytes(i) + k * p.size());
      }
    }
  }

  /// Whether a value of element i is not the default one.
  bool has_value(std::size_t i) const {
    return std::any_of(all.begin(), all.end(), [&](const ply_output_property& p) {
      if (p.is_list()) {
        bool has = false;
        p.with_list(i, [&](const auto& values) { has = !values.empty(); });
        return has;
      }
      if (*p.property.type == typeid(rgba)) return p.color(i) != rgba();
      const unsigned char* const bytes = p.bytes(i);
      return std::any_of(bytes, bytes + p.type.components * p.size(), [](unsigned char b) { return b != 0; });
    });
  }

 private:
  static bool is_normal(const ply_output_property& p) {
    return p.type.number == vtk_number::float64 && p.type.components == 3 && p.property.name == "normal";
  }
  static bool is_texture(const ply_output_property& p) {
    return p.property.kind == element_kind::vert && p.type.number == vtk_number::float64 && p.type.components == 2 &&
           p.property.name == "texture";
  }
};

}  // namespace concino::detail
