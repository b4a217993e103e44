// Chooses the materials of the polys of an OBJ file, and collects the materials that its library must define.
#pragma once

#include <concino/io/detail/obj/material_library_file.hpp>
#include <concino/io/detail/text/write_common.hpp>

#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace concino::detail {

/// The colour that the lines of a material define. Sets is_taken to whether a reader assigns it to polys.
inline rgba color_of(const std::vector<std::string>& lines, bool& is_taken) {
  rgba color;
  is_taken = false;
  for (const std::string& line : lines) {
    text_cursor in(line, {});
    const std::string_view word = in.word();
    while (!in.at_end() && is_blank(*in.at)) ++in.at;
    try {
      is_taken = read_color(in, word, color) || is_taken;
    } catch (const parse_error&) {  // ignored, as by the reader
    }
  }
  return color;
}

/// Chooses the name of the material of each poly: its property "material", unless this is empty; otherwise a new
/// material for its colour. If polys have the same material but different colours, new materials are added, which
/// differ only in the colour.
class mtl_names {
  static constexpr std::uint32_t none = ~0u;

  struct name_info {
    std::uint32_t in_table = none;  // index in needed_
    rgba color = {};                // the colour in the table; else the default
    bool is_colored = false;        // a poly has a colour other than this
    bool is_used = false;           // a poly has this colour
    bool is_defined = false;        // the name already stands for one colour
  };

  write_context& c_;
  material_library_file* library_;                    // null: the output is a string, which has no library
  flat_values<std::string> material_;         // of polys; false if they have none
  flat_values<rgba> color_;                   // of polys; false if they have none
  const material_table* table_;               // null: none
  std::vector<material> table_materials_;     // in the form that lines can hold
  std::vector<material> needed_;              // the materials that the library must define, those of the table first
  name_table names_;                          // of materials; 0: no material
  std::vector<name_info> info_;               // of each name
  bool table_colors_ = false;                 // a poly has a material of the table that defines a colour
  name_table colored_names_;                  // pairs of name and colour, as bytes
  std::vector<std::uint32_t> key_material_;   // the name of the material of each pair
  std::vector<std::uint32_t> poly_material_;  // the name of the material of each poly, in the order of polys(m)
  std::vector<std::string> undefined_;        // names that no library may define
  std::size_t num_polys_ = 0, last_number_ = 0, num_renamed_ = 0, num_duplicates_ = 0, num_bad_lines_ = 0;
  std::size_t last_poly_ = ~std::size_t{0};
  std::uint32_t last_name_ = 0;

 public:
  bool changed = false;  // some names had to be changed, as no line can hold them

  mtl_names(write_context& c, material_library_file* library, const flat_values<std::string>& material,
                     const flat_values<rgba>& color, const material_table* table)
      : c_(c), library_(library), material_(material), color_(color), table_(table) {
    c.declare_stored<rgba>(element_kind::poly, "color");
    c.declare_stored<material_table>(element_kind::mesh, "materials");
    if (!library) {
      constexpr const char* where = "it belongs in a .mtl file beside the .obj file, and text has no folder";
      if (color_) c.report.lost.push_back(core::joined({"poly property \"color\": ", where}));
      if (table_ && !table_->materials.empty())
        c.report.lost.push_back(core::joined({"mesh property \"materials\": ", where}));
      color_ = {};
    }
    add_name("");
    if (!table_ || !library) return;
    for (const concino::material& m : table_->materials) {
      const std::uint32_t name = add_name(line_name(m.name, changed));
      if (m.name.empty() || info_[name].in_table != none) {
        ++num_duplicates_;
        continue;
      }
      info_[name].in_table = static_cast<std::uint32_t>(needed_.size());
      needed_.push_back({names_[name], {}});
      for (const std::string& line : m.lines) {
        std::string fit = library_line(line);
        if (fit.empty()) ++num_bad_lines_;
        else needed_.back().lines.push_back(std::move(fit));
      }
    }
    for (name_info& a : info_) {
      if (a.in_table == none) continue;
      const rgba defined_color = color_of(needed_[a.in_table].lines, a.is_defined);
      if (a.is_defined) a.color = defined_color;
    }
    table_materials_ = needed_;
  }

  bool any() const { return material_ || color_; }

  /// Called for every poly before assign_material(): records its material and whether its colour is that of the
  /// material.
  void register_poly(std::size_t poly) {
    name_info& a = info_[name_of(poly)];
    ++num_polys_;
    if (!color_) return;
    table_colors_ = table_colors_ || (a.in_table != none && a.is_defined);
    (color_[poly] == a.color ? a.is_used : a.is_colored) = true;
  }

  /// Chooses the name of the material of a poly. Called for every poly, in the order of polys(m).
  void assign_material(std::size_t poly) {
    const std::uint32_t name = name_of(poly);
    if (!color_) {
      poly_material_.push_back(name);
      return;
    }
    if (poly_material_.empty()) poly_material_.reserve(num_polys_);
    char key[sizeof name + sizeof(rgba)];
    std::memcpy(key, &name, sizeof name);
    std::memcpy(key + sizeof name, &color_[poly], sizeof(rgba));
    const std::size_t known = colored_names_.add(std::string_view(key, sizeof key));
    if (known == key_material_.size()) key_material_.push_back(material_for(name, color_[poly]));
    poly_material_.push_back(key_material_[known]);
  }

  /// Writes the lines that name the libraries. Called after all polys have their materials.
  void end() {
    const auto lost = [&](std::size_t n, const char* what, const char* why) {
      if (n) c_.report.lost.push_back(core::joined({what, n, why}));
    };
    lost(num_renamed_, "materials of several colours: ", " got new names, as a material of .mtl has one colour");
    lost(num_duplicates_, "materials without a name, or with the name of another: ", " were left out");
    lost(num_bad_lines_, "lines of materials that are empty or begin another material: ", " were left out");
    std::vector<std::string> libraries;
    if (library_) libraries = library_->choose_or_write(needed_, undefined_, table_, c_.report);
    else if (table_) libraries = table_->libraries;
    bool ignored = false;
    std::set<std::string> written;  // different names can have equal lines
    for (const std::string& name : libraries)
      if (const auto [line, is_new] = written.insert(std::string(line_name(name, ignored))); is_new)
        c_.out << "mtllib " << *line << '\n';
  }

  /// The material of the k-th poly of polys(m).
  const std::string& operator[](std::size_t k) const { return names_[poly_material_[k]]; }

 private:
  std::uint32_t add_name(std::string_view name) {
    const std::size_t i = names_.add(name);
    if (i == info_.size()) info_.push_back({});
    return static_cast<std::uint32_t>(i);
  }

  /// The property "material" of a poly, in the form that a line can hold, as a number in names_.
  std::uint32_t name_of(std::size_t poly) {
    if (!material_) return 0;
    if (last_poly_ == ~std::size_t{0} || std::string_view(material_[last_poly_]) != material_[poly])
      last_name_ = add_name(line_name(material_[poly], changed));
    last_poly_ = poly;
    return last_name_;
  }

  /// The material of polys with this name and colour. Defines it if necessary.
  std::uint32_t material_for(std::uint32_t name, const rgba& color) {
    const name_info a = info_[name];
    if (a.in_table != none && color == a.color) return name;
    if (a.in_table == none && table_colors_ && color == rgba{} && (name == 0 || !a.is_colored)) {
      if (name != 0) undefined_.push_back(names_[name]);  // the poly is white because no library defines the material
      return name;
    }
    if (a.in_table != none && !a.is_used) {  // no poly has the colour in the table, so it is replaced
      info_[name].is_used = true;
      set_color(needed_[a.in_table].lines, color);
      return name;
    }
    if (a.in_table == none && name != 0 && !a.is_defined) {
      info_[name].is_defined = true;
      needed_.push_back({names_[name], {}});
      set_color(needed_.back().lines, color);
      return name;
    }
    num_renamed_ += name != 0;
    const std::uint32_t renamed = make_up(name);
    needed_.push_back(
        {names_[renamed], a.in_table != none ? table_materials_[a.in_table].lines : std::vector<std::string>()});
    set_color(needed_.back().lines, color);
    return renamed;
  }

  /// Creates a new name: color_1, or name_1.
  std::uint32_t make_up(std::uint32_t name) {
    const std::string base =
        core::joined({name == 0 ? std::string_view("color") : std::string_view(names_[name]), "_"});
    std::string numbered;
    do numbered = core::joined({base, ++last_number_});
    while (names_.find(numbered) != name_table::none);
    const std::uint32_t i = add_name(numbered);
    info_[i].is_defined = true;
    return i;
  }

  std::string line_of(std::string_view keyword, std::initializer_list<float> numbers) {
    text_sink line;
    line << keyword;
    for (const float x : numbers) {
      line << ' ';
      write_float(line, c_.finite(x), false);
    }
    return std::move(line).release();
  }

  /// Replaces the lines for the colour and the opacity, if they differ.
  void set_color(std::vector<std::string>& lines, const rgba& color) {
    bool is_taken = false;
    const rgba defined_color = color_of(lines, is_taken);
    const bool opacity = !(color.a == defined_color.a),
               parts = !is_taken || !(defined_color == rgba{color.r, color.g, color.b, defined_color.a});
    bool kd = !parts, d = !opacity;  // whether the lines exist
    std::vector<std::string> other;
    for (std::string& line : lines) {
      const std::string_view word = std::string_view(line).substr(0, line.find_first_of(" \t"));
      if (word == "Kd" && parts) {
        if (!std::exchange(kd, true)) other.push_back(line_of("Kd", {color.r, color.g, color.b}));
      } else if (word == "d" && opacity) {
        if (!std::exchange(d, true)) other.push_back(line_of("d", {color.a}));
      } else if (word == "Tr" && opacity) {
        other.push_back(line_of("Tr", {1 - color.a}));
      } else {
        other.push_back(std::move(line));
      }
    }
    if (!kd) other.insert(other.begin(), line_of("Kd", {color.r, color.g, color.b}));
    if (!d) other.push_back(line_of("d", {color.a}));
    lines.swap(other);
  }
};

}  // namespace concino::detail
