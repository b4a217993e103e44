// Reads the properties at the end of .ovm files.
#pragma once

#include <concino/io/detail/ovm/ovm_types.hpp>
#include <concino/io/detail/values/typed_number_cursor.hpp>
#include <concino/io/file_contents.hpp>

#include <array>
#include <string>
#include <string_view>

namespace concino::detail {

/// The numbers of elements in the file.
struct ovm_counts {
  std::uint64_t verts = 0, edges = 0, faces = 0, polys = 0;

  std::uint64_t of(const ovm_kind& k) const {
    const std::uint64_t n = k.kind == element_kind::vert   ? verts
                            : k.kind == element_kind::edge ? edges
                            : k.kind == element_kind::face ? faces
                            : k.kind == element_kind::poly ? polys
                                                           : 1;
    return k.is_half ? 2 * n : n;
  }
};

/// Reads properties, each of which is a line `VProp int "name"` and its values. Those of half-edges and half-faces, and
/// those of types that no property of a mesh has, are skipped and reported.
class ovm_properties_reader : typed_number_cursor {
  load_report& report_;
  const ovm_counts& counts_;
  file_contents& out_;

  static std::string lower_word(text_cursor& in) {
    std::string w(in.word());
    for (char& c : w)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c | 0x20);
    return w;
  }
  void skip_blanks() {
    while (!at_end() && is_blank(*at)) ++at;
  }
  static const ovm_kind* kind_of(std::string_view lower) {
    for (const ovm_kind& k : ovm_kinds)
      if (k.lower == lower) return &k;
    return nullptr;
  }

  /// Whether only NUL and Ctrl-Z follow, which some programs write behind the last line.
  bool only_padding_follows() const {
    for (const char* p = at; p != end(); ++p)
      if (*p != '\0' && *p != '\x1a' && !is_space(*p)) return false;
    return true;
  }

  /// The rest of the line: what is between the first quotation mark and the last ones.
  std::string name_of_property() {
    skip_blanks();
    const char* const from = at;
    skip_line();
    std::string_view rest(from, static_cast<std::size_t>(at - from));
    while (!rest.empty() && is_blank(rest.back())) rest.remove_suffix(1);
    if (rest.size() < 2 || rest.front() != '"' || rest.back() != '"') fail(from, "the name of the property in quotes");
    return std::string(rest.substr(1, rest.size() - 2));
  }

  /// Moves to the next line that begins like a property.
  void skip_lines() {
    while (true) {
      skip_line();
      skip_space('#');
      if (at_end()) return;
      const char* const from = at;
      const bool is_property = kind_of(lower_word(*this)) != nullptr;
      at = from;
      if (is_property) return;
    }
  }

  void read_characters(unsigned char* to) {
    skip_space();
    if (at_end()) fail(at, "a character");
    *to = static_cast<unsigned char>(*at++);
  }
  void read_string(std::string& to) {
    skip_space();
    std::int64_t n = 0;
    const char* const colon = parse_integer(at, end(), n);
    if (!colon || n < 0 || colon == end() || *colon != ':') fail(at, "the length of a string and a colon");
    if (end() - (colon + 1) < n) fail(at, {"a string that fits into the file"}, {"one of ", n, " bytes"});
    to.assign(colon + 1, static_cast<std::size_t>(n));
    at = colon + 1 + n;
  }
  void read_list(std::vector<double>& to) {
    skip();
    const char* const from = at;
    const std::uint64_t n = next_count("the number of values", 2);
    require_room(from, n, vtk_number::float64);
    to.resize(static_cast<std::size_t>(n));
    read_values(to.data(), to.size());
  }

  /// Reads one value. `to` is null if it is skipped.
  void read_value(const ovm_type& t, void* to) {
    unsigned char unused[32];
    std::string unused_text;
    std::vector<double> unused_list;
    if (t.form == ovm_form::characters) {
      read_characters(to ? static_cast<unsigned char*>(to) : unused);
    } else if (t.form == ovm_form::string) {
      read_string(to ? *static_cast<std::string*>(to) : unused_text);
    } else if (t.form == ovm_form::list) {
      read_list(to ? *static_cast<std::vector<double>*>(to) : unused_list);
    } else if (t.number == vtk_number::bit) {
      skip();
      const char* const from = at;
      const std::uint64_t x = next_integer(false, 1);
      if (x > 1) fail(from, "0 or 1");
      *(to ? static_cast<unsigned char*>(to) : unused) = static_cast<unsigned char>(x);
    } else {
      read_values_of(t.number, to ? to : unused, t.components);
    }
    report_progress();
  }

  void read_property(const ovm_kind& kind) {
    skip_blanks();
    const char* const from = at;
    const std::string type = lower_word(*this);
    if (type.empty()) fail(from, "the type of the property");
    const std::string property = name_of_property();
    const ovm_type* const t = ovm_type_of(type);
    if (kind.is_half || !t) {
      const char* const half = kind.is_half ? "half-" : "";
      report_.skipped.push_back(t ? core::joined({half, to_string(kind.kind), " property \"", property, "\""})
                                  : core::joined({half, to_string(kind.kind), " property \"", property,
                                                  "\" of the type ", type, ", which no property has"}));
    }
    if (!t) return skip_lines();
    const std::uint64_t n = counts_.of(kind);
    constexpr std::size_t shortest[] = {2, 1, 3, 2};  // bytes of a number and so on, with the blank behind it
    const std::size_t bytes = shortest[static_cast<unsigned>(t->form)] * (t->components ? t->components : 1);
    if (reservable(n, bytes) < n)
      fail(at, {"a value for each of ", n, " elements"}, {"only ", left(), " bytes to the end of the file"});
    const value_type& values = ovm_value_type(*t, property);
    unsigned char* to = nullptr;
    if (!kind.is_half)
      to = static_cast<unsigned char*>(out_.add_property(kind.kind, property, values, static_cast<std::size_t>(n)));
    for (std::uint64_t i = 0; i < n; ++i) {
      read_value(*t, to);
      if (to) to += values.size;
    }
  }

 public:
  /// Reads from a position of the text to its end.
  ovm_properties_reader(const read_context& c, const char* from, const ovm_counts& counts, file_contents& out)
      : typed_number_cursor(c.text, c.name, c.progress, '#'), report_(*c.report), counts_(counts), out_(out) {
    at = from;
  }

  void read() {
    while (true) {
      skip_space('#');
      if (only_padding_follows()) return;
      const char* const from = at;
      const ovm_kind* const kind = kind_of(lower_word(*this));
      if (!kind) fail(from, "a property (VProp, EProp, HEProp, FProp, HFProp, CProp or MProp), or the end of the file");
      read_property(*kind);
    }
  }
};

}  // namespace concino::detail
