// Reads the elements of XML files as VTK writes them, one inside of another, and the attributes that are numbers.
#pragma once

#include <concino/io/detail/vtk_xml/xml_scanner.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace concino::detail {

class xml_elements : protected xml_scanner {
  std::vector<std::uint64_t> open_;  // the elements around the next tag: where the name of each begins in the text, and
                                     // its size

  void open(std::string_view element) {
    open_.push_back(static_cast<std::uint64_t>(element.data() - text_cursor::begin()));
    open_.push_back(element.size());
  }
  std::string_view last_open() const { return {text_cursor::begin() + open_[open_.size() - 2], open_.back()}; }

 protected:
  using xml_scanner::xml_scanner;

  /// Reads the first tag, <VTKFile>, and passes it to first. Then calls begins(tag) for each element that begins, and
  /// ends(name) for each that ends in another place, until begins returns false or the first element ends.
  template<class First, class Begins, class Ends>
  void read_elements(const First& first, const Begins& begins, const Ends& ends) {
    xml_tag tag;
    if (!next(tag) || tag.name != "VTKFile" || !tag.begins) fail(tag.at ? tag.at : at, "<VTKFile>");
    first(tag);
    open(tag.name);
    while (!open_.empty() && next(tag)) {
      if (tag.begins) {
        if (!begins(tag)) return;
        if (!tag.ends) open(tag.name);
      } else if (last_open() != tag.name) {
        fail(tag.at, {"</", last_open(), ">"}, {"</", tag.name.substr(0, 40), ">"});
      } else {
        open_.pop_back(), open_.pop_back();
        ends(tag.name);
      }
    }
    if (!open_.empty()) fail(end(), {"</", last_open().substr(0, 40), ">"}, {"the end of the file"});
  }

  /// The value of an attribute; empty if there is none.
  std::string text_of(const xml_tag& tag, std::string_view name) const {
    std::string value;
    attribute(tag, name, value);
    return value;
  }
  std::uint64_t number_of(const xml_tag& tag, std::string_view name, std::uint64_t otherwise) const {
    std::string value;
    if (!attribute(tag, name, value)) return otherwise;
    std::uint64_t n = 0;
    const char* first = value.data();
    const char* const last = first + value.size();
    while (first != last && is_space(*first)) ++first;
    const char* rest = first;
    bool fits = true;
    for (; rest != last && is_digit(*rest); ++rest) {
      const auto digit = static_cast<std::uint64_t>(*rest - '0');
      fits = fits && n <= (~std::uint64_t{0} - digit) / 10;
      n = 10 * n + digit;
    }
    fits = fits && rest != first;
    while (rest != last && is_space(*rest)) ++rest;
    if (!fits || rest != last) fail(tag.at, {name, ", a number"}, {"'", std::string_view(value).substr(0, 40), "'"});
    return n;
  }
};

}  // namespace concino::detail
