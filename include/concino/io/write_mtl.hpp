// Material libraries beside OBJ files: the colours of polys, each under a name.
#pragma once

#include <concino/io/write_common.hpp>

namespace concino::detail {

/// The material of each poly: its property "material" where that says one, and one colour; else one made up for its colour.
class mtl_names {
  write_state& c_;
  const std::string* material_;  // of polys, by their indices; null: none
  const rgba* color_;            // the same
  name_table keys_;              // names with colours
  std::vector<std::string> names_;  // what each of these is called
  name_table taken_;
  std::vector<std::uint32_t> uses_;  // how many colours go by each of the names taken
  text_sink library_;
  std::string name_, key_;
  std::size_t num_renamed_ = 0, last_number_ = 0;

 public:
  bool changed = false;  // names that no line can hold

  /// Colours need a file of their own: where there is none they are lost.
  [[gnu::noinline, gnu::cold]] mtl_names(write_state& c, const std::string* material, const rgba* color) : c_(c), material_(material), color_(color) {
    if (!color_) return;
    if (!c.library) {
      c.report.lost.push_back("poly property \"color\": it goes to a .mtl file beside the .obj file, and text has none beside it");
      color_ = nullptr;
    } else {
      c.out << "mtllib " << c.library_name << '\n';
    }
    c.keep(element_kind::poly, "color", typeid(rgba));
  }

  bool any() const { return material_ || color_; }
  bool any_to_take() const { return material_ && color_; }
  /// For every poly, before the first is asked for: no name made up later may be one of these.
  void take(std::size_t poly) { use(line_name(material_[poly], changed)); }

  [[gnu::noinline]] const std::string& operator()(std::size_t poly) {
    name_.clear();
    if (material_) name_ = line_name(material_[poly], changed);
    if (!color_) return name_;
    const rgba& color = color_[poly];
    key_ = name_;
    key_.push_back('\n');
    key_.append(std::string_view(reinterpret_cast<const char*>(&color), sizeof(rgba)));
    const std::size_t known = keys_.find(key_);
    if (known != name_table::none) return names_[known];
    keys_.add(key_);
    if (name_.empty() || ++uses_[use(name_)] > 1) {
      num_renamed_ += !name_.empty();
      make_up();
    }
    names_.push_back(name_);
    define(color);
    return names_.back();
  }

  [[gnu::noinline, gnu::cold]] void end() {
    if (num_renamed_)
      c_.report.lost.push_back(
          joined({"materials of several colours: ", num_renamed_, " were given names of their own, as a material of .mtl has one colour"}));
    if (!color_) return;
    *c_.library = joined({"# ", names_.size(), " materials\n", std::move(library_).take()});
  }

 private:
  std::size_t use(std::string_view name) {
    const std::size_t i = taken_.add(name);
    if (i == uses_.size()) uses_.push_back(0);
    return i;
  }

  [[gnu::noinline, gnu::cold]] void make_up() {
    const std::string base = joined({name_.empty() ? std::string_view("color") : std::string_view(name_), "_"});
    do name_ = joined({base, ++last_number_});
    while (taken_.find(name_) != name_table::none);
    uses_[use(name_)] = 1;
  }

  [[gnu::noinline, gnu::cold]] void define(const rgba& color) {
    library_ << "newmtl " << names_.back() << "\nKd";
    for (const float part : {color.r, color.g, color.b}) {
      library_ << ' ';
      write_part(library_, c_.finite(part), false);
    }
    if (color.a != 1) {
      library_ << "\nd ";
      write_part(library_, c_.finite(color.a), false);
    }
    library_ << '\n';
  }
};

}  // namespace concino::detail
