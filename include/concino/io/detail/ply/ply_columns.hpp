// Decides what becomes of each property of an element of a PLY file.
#pragma once

#include <concino/io/detail/ply/ply_header.hpp>
#include <concino/io/detail/text/encoded_name.hpp>
#include <concino/io/file_contents.hpp>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

/// What becomes of the numbers of a property.
enum class ply_use : std::uint8_t {
  skip,
  number,      // a value, or a component of one, of the type that the file has
  coordinate,  // a double that is finite
  real,        // a double
  part,        // of a colour
  end,         // the vert at one end of an edge
  list,        // a std::vector
  reals,       // a list of doubles, kept until the next element
  corners      // the verts of a poly
};

struct ply_column {
  const ply_property* property = nullptr;
  ply_use use = ply_use::skip;
  unsigned char* to = nullptr;  // where the value of the first element is
  std::size_t stride = 0;       // from one element to the next, in bytes
};

/// The names of the components of values in PLY files: name_x, name_y ..., or name_0, name_1 ... where there are more
/// than four.
inline constexpr std::string_view ply_component_names[] = {"_x", "_y", "_z", "_w"};
inline constexpr std::string_view ply_component_numbers[] = {"_0", "_1", "_2", "_3", "_4", "_5", "_6", "_7", "_8"};

/// Properties of one number that have a meaning of their own.
inline constexpr std::string_view ply_normal_names[] = {"nx", "ny", "nz"};
inline constexpr std::string_view ply_color_names[] = {"red", "green", "blue", "alpha"};
inline constexpr std::string_view ply_diffuse_names[] = {"diffuse_red", "diffuse_green", "diffuse_blue",
                                                         "diffuse_alpha"};
inline constexpr std::string_view ply_texture_names[][2] = {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}};

/// The columns of the properties of an element. It creates the properties of the mesh, in the order of the file.
class ply_columns {
  const ply_element& e_;
  element_kind kind_;
  file_contents& out_;
  std::vector<ply_column> all_;
  std::vector<bool> is_done_;

  static constexpr std::size_t none = ~std::size_t{0};

  /// The first single number of that name whose use is not known yet.
  std::size_t find(std::string_view name) const {
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (!is_done_[i] && !e_.properties[i].is_list() && e_.properties[i].name == name) return i;
    return none;
  }
  /// The value of the first element is `offset` bytes behind `to`, which is null if there are no elements.
  void set(std::size_t i, ply_use use, void* to, std::size_t offset, std::size_t stride) {
    all_[i].use = use;
    all_[i].to = to ? static_cast<unsigned char*>(to) + offset : nullptr;
    all_[i].stride = stride;
    is_done_[i] = true;
  }

  /// Whether property i is one of these, and all of them are there: then they are components of one value.
  bool is_one_of(std::size_t i, std::span<const std::string_view> names) const {
    const std::string_view name = e_.properties[i].name;
    return std::find(names.begin(), names.end(), name) != names.end() &&
           std::all_of(names.begin(), names.end(), [&](std::string_view x) { return find(x) != none; });
  }
  template<class T, class Part>
  void set_components(std::span<const std::string_view> names, const char* property, ply_use use) {
    T* const values = out_.add_property<T>(kind_, property, e_.count);
    for (std::size_t k = 0; k < names.size(); ++k)
      set(find(names[k]), use, values, k * sizeof(Part), sizeof(T));
  }
  bool set_color(std::size_t i, std::span<const std::string_view> names) {
    const bool has_alpha = find(names[3]) != none;
    if (!is_one_of(i, names.first(has_alpha ? 4 : 3))) return false;
    set_components<rgba, float>(names.first(has_alpha ? 4 : 3), "color", ply_use::part);
    return true;
  }

  /// How many properties from i on are the components of one value: name_x, name_y and so on, of one type.
  std::size_t num_components(std::size_t i, std::span<const std::string_view> endings) const {
    const ply_property& first = e_.properties[i];
    const std::string_view name = first.name.substr(0, first.name.size() - std::min<std::size_t>(2, first.name.size()));
    std::size_t n = 0;
    for (; !name.empty() && i + n < all_.size() && n < endings.size(); ++n) {
      const ply_property& p = e_.properties[i + n];
      if (p.is_list() || is_done_[i + n] || p.type != first.type || p.name.size() != name.size() + 2 ||
          !p.name.starts_with(name) || !p.name.ends_with(endings[n]))
        break;
    }
    const bool goes_on = i + n < all_.size() && is_numbered(e_.properties[i + n].name, name);  // beyond the endings
    return endings.size() > 4 && goes_on ? 0 : n;
  }
  /// Whether a name is another one, an underscore and digits.
  static bool is_numbered(std::string_view name, std::string_view other) {
    return name.size() > other.size() + 1 && name.starts_with(other) && name[other.size()] == '_' &&
           name.find_first_not_of("0123456789", other.size() + 1) == name.npos;
  }

  void set_numbers(std::size_t i) {
    const ply_property& p = e_.properties[i];
    std::size_t n = std::max<std::size_t>(1, num_components(i, ply_component_names));
    if (n == 1) n = std::max<std::size_t>(1, num_components(i, ply_component_numbers));
    const value_type* type = n == 1 ? nullptr : property_type_of(p.type, n, {});
    if (!type || (n > 4) != p.name.ends_with("_0")) {
      n = 1;
      type = property_type_of(p.type, 1, {});
    }
    void* const to =
        out_.add_property(kind_, decoded_name(p.name.substr(0, p.name.size() - (n == 1 ? 0 : 2))), *type, e_.count);
    for (std::size_t k = 0; k < n; ++k) set(i + k, ply_use::number, to, k * vtk_names_of(p.type).size, type->size);
  }
  void set_list(std::size_t i) {
    const ply_property& p = e_.properties[i];
    with_number_type(p.type, [&]<class T>(std::type_identity<T>) {
      if constexpr (!std::is_same_v<T, bool>)
        set(i, ply_use::list, out_.add_property<std::vector<T>>(kind_, decoded_name(p.name), e_.count), 0,
            sizeof(std::vector<T>));
    });
  }

 public:
  ply_columns(const ply_element& e, element_kind kind, file_contents& out)
      : e_(e), kind_(kind), out_(out), all_(e.properties.size()), is_done_(e.properties.size()) {
    for (std::size_t i = 0; i < all_.size(); ++i) all_[i].property = &e.properties[i];
  }

  /// Sets the use of a property. Result: whether the element has it.
  bool set_single(std::string_view name, ply_use use, void* to, std::size_t offset, std::size_t stride) {
    const std::size_t i = find(name);
    if (i != none) set(i, use, to, offset, stride);
    return i != none;
  }
  /// The same for a list; null if there is none.
  const ply_property* set_list(std::string_view name, std::string_view or_else, ply_use use) {
    const ply_property* const p = e_.find(name, or_else);
    if (!p || !p->is_list()) return nullptr;
    set(static_cast<std::size_t>(p - e_.properties.data()), use, nullptr, 0, 0);
    return p;
  }

  /// All other properties become properties of the mesh. Result: one column for each property of the element.
  const std::vector<ply_column>& finish() {
    for (std::size_t i = 0; i < all_.size(); ++i) {
      if (is_done_[i]) continue;
      if (e_.properties[i].is_list()) {
        set_list(i);
        continue;
      }
      bool is_set = false;
      if (is_one_of(i, ply_normal_names)) {
        set_components<vec3, double>(ply_normal_names, "normal", ply_use::real);
        is_set = true;
      }
      is_set = is_set || set_color(i, ply_color_names) || set_color(i, ply_diffuse_names);
      for (const auto& names : ply_texture_names) {
        if (is_set || kind_ != element_kind::vert || !is_one_of(i, names)) continue;
        set_components<std::array<double, 2>, double>(names, "texture", ply_use::real);
        is_set = true;
      }
      if (!is_set) set_numbers(i);
    }
    return all_;
  }
};

}  // namespace concino::detail
