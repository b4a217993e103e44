// Material libraries beside OBJ files: the colours of polys, each under a name.
#pragma once

#include <concino/io/write_common.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <map>

namespace concino::detail {

/// The material of each poly: its property "material" where that says one, and one colour; else one made up for its colour.
template<class M>
class mtl_names {
  using key = std::pair<std::string, std::array<std::uint32_t, 4>>;

  write_context<M>& c_;
  decltype(property_if_any<element_kind::poly, std::string>(std::declval<const M&>(), "")) material_;
  decltype(property_if_any<element_kind::poly, rgba>(std::declval<const M&>(), "")) color_;
  std::map<key, std::string> names_;
  std::map<std::string, std::size_t, std::less<>> used_;  // names, and how many colours go by each
  std::vector<std::pair<std::string, rgba>> library_;
  std::size_t num_renamed_ = 0;
  int last_number_ = 0;

 public:
  bool changed = false;  // names that no line can hold

  /// Colours need a file of their own: where there is none they are lost.
  explicit mtl_names(write_context<M>& c)
      : c_(c),
        material_(property_if_any<element_kind::poly, std::string>(c.mesh, "material")),
        color_(property_if_any<element_kind::poly, rgba>(c.mesh, "color")) {
    if (!color_) return;
    if (!c.library) {
      c.report.lost.push_back("poly property \"color\": it goes to a .mtl file beside the .obj file, and text has none beside it");
      color_ = {};
    } else {
      c.out << "mtllib " << c.library_name << '\n';
      if (material_)
        for (poly_t<M> p : polys(c.mesh)) used_.try_emplace(line_name(material_[p], changed), 0);  // no made-up name may be one of these
    }
    c.template keep<rgba>(element_kind::poly, "color");
  }

  explicit operator bool() const { return bool(material_) || bool(color_); }

  std::string operator()(const poly_t<M>& p) {
    const std::string name = material_ ? line_name(material_[p], changed) : std::string();
    if (!color_) return name;
    const rgba color = color_[p];
    const auto [at, is_new] = names_.try_emplace({name, std::bit_cast<std::array<std::uint32_t, 4>>(color)}, name);
    if (is_new) {
      if (name.empty() || ++used_[name] > 1) {
        num_renamed_ += !name.empty();
        at->second = made_up(name);
      }
      library_.push_back({at->second, color});
    }
    return at->second;
  }

  void end() {
    if (num_renamed_)
      c_.report.lost.push_back("materials of several colours: " + std::to_string(num_renamed_) +
                               " were given names of their own, as a material of .mtl has one colour");
    if (!color_ || !c_.library) return;
    text_sink out;
    out << "# " << library_.size() << " materials\n";
    for (const auto& [name, color] : library_) {
      out << "newmtl " << name << "\nKd";
      for (const float part : {color.r, color.g, color.b}) write_part(out << ' ', c_.finite(part), false);
      if (color.a != 1) write_part(out << "\nd ", c_.finite(color.a), false);
      out << '\n';
    }
    *c_.library = std::move(out).take();
  }

 private:
  std::string made_up(const std::string& name) {
    std::string made;
    do made = (name.empty() ? "color" : name) + "_" + std::to_string(++last_number_);
    while (used_.contains(made));
    used_.emplace(made, 1);
    return made;
  }
};

}  // namespace concino::detail
