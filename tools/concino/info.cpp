// concino info: facts about a mesh, as a table or as one JSON object.
#include "kind_names.hpp"
#include "mesh_files.hpp"

#include <concino/core/terminal_progress.hpp>
#include <concino/geometry/bounding_box.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/property.hpp>
#include <concino/quality/poly_quality.hpp>
#include <concino/validate/validate.hpp>

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <typeinfo>

namespace cn = concino;

namespace program {
namespace {

/// A text as it stands in JSON.
std::string quoted(const std::string& text) {
  std::string s = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') s += '\\';
    if (static_cast<unsigned char>(c) < 0x20) s += fmt::format("\\u{:04x}", static_cast<unsigned char>(c));
    else s += c;
  }
  return s + '"';
}

/// A number as it stands in JSON, which knows no infinity and no NaN.
std::string number(double x) { return std::isfinite(x) ? fmt::format("{}", x) : "null"; }

/// Rows of a table, or members of a JSON object.
class row_writer {
  bool json_;
  std::string text_;

 public:
  explicit row_writer(bool json) : json_(json) {}

  /// A value as it stands in JSON, which is also readable.
  void add(const char* name, const std::string& value) {
    if (json_) text_ += fmt::format("{}\n  \"{}\": {}", text_.empty() ? "{" : ",", name, value);
    else text_ += fmt::format("{:<20}{}\n", name, value);
  }
  void add(const char* name, std::size_t value) { add(name, fmt::format("{}", value)); }
  void add_text(const char* name, const std::string& value) { add(name, json_ ? quoted(value) : value); }
  void print() const { fmt::print("{}{}", text_, json_ ? "\n}\n" : ""); }
  bool is_json() const { return json_; }
};

std::string name_of_type(const std::type_info& type) {
  const std::pair<const std::type_info*, const char*> known[] = {
      {&typeid(int), "int"},
      {&typeid(unsigned), "unsigned"},
      {&typeid(long), "long"},
      {&typeid(float), "float"},
      {&typeid(double), "double"},
      {&typeid(std::uint8_t), "unsigned char"},
      {&typeid(std::uint16_t), "unsigned short"},
      {&typeid(cn::vec3), "vec3"},
      {&typeid(cn::rgba), "rgba"},
      {&typeid(std::array<double, 2>), "two doubles"},
      {&typeid(std::string), "text"}};
  for (const auto& [known_type, name] : known)
    if (*known_type == type) return name;
  return "other";
}

template<class M>
void add_properties(const M& m, row_writer& rows) {
  std::string list;
  for (const auto& p : cn::property_list(m)) {
    const std::string kind(to_string(p.kind)), type = name_of_type(*p.type);
    if (!list.empty()) list += ", ";
    if (rows.is_json())
      list += fmt::format(R"({{"of": {}, "name": {}, "type": {}}})", quoted(kind), quoted(p.name), quoted(type));
    else list += fmt::format("{} of {}s ({})", p.name, kind, type);
  }
  rows.add("properties", rows.is_json() ? "[" + list + "]" : list.empty() ? "none" : list);
}

template<class M>
void add_quality(const M& m, row_writer& rows) {
  const auto q = cn::quality(m, cn::metric::scaled_jacobian);
  double worst = std::numeric_limits<double>::infinity(), sum = 0;
  for (const auto p : cn::polys(m)) worst = std::min(worst, q[p]), sum += q[p];
  const double mean = sum / static_cast<double>(cn::num_polys(m));
  if (rows.is_json())
    rows.add("quality", fmt::format(R"({{"scaled_jacobian": {{"min": {}, "mean": {}}}}})", number(worst), number(mean)));
  else rows.add("quality", fmt::format("scaled Jacobian {:.4g} at least, {:.4g} on average", worst, mean));
}

template<class M>
double boundary_area(const M& m) {
  double sum = 0;
  for (const auto f : cn::faces(m))
    if (std::size(cn::adj_f2p(m, f)) == 1) sum += cn::area(m, f);
  return sum;
}

template<class M>
void print_info(const M& m, const info_options& options) {
  cn::mesh_facts facts;
  {
    cn::terminal_progress line;
    facts = cn::validate(m, {.max_per_kind = 0, .progress = line}).facts;
  }
  constexpr bool is_volume = cn::VolumeMesh<M>;
  row_writer rows(options.json);
  rows.add_text("file", options.file);
  rows.add_text("kind", name_of(m));
  rows.add("verts", cn::num_verts(m));
  rows.add("edges", cn::num_edges(m));
  if constexpr (is_volume) rows.add("faces", cn::num_faces(m));
  rows.add("polys", cn::num_polys(m));
  rows.add("euler", fmt::format("{}", facts.euler_characteristic));
  rows.add("genus", facts.genus ? fmt::format("{}", *facts.genus) : options.json ? "null" : "none");
  rows.add("components", facts.components);
  rows.add(is_volume ? "boundary_components" : "boundary_loops", facts.boundary_loops);
  rows.add("manifold", facts.manifold ? "true" : "false");
  rows.add("orientable", facts.orientable ? "true" : "false");
  rows.add("closed", facts.closed ? "true" : "false");
  if constexpr (is_volume) {
    rows.add("area", number(boundary_area(m)));
    rows.add("volume", number(cn::total_measure(m)));
  } else {
    rows.add("area", number(cn::total_measure(m)));
  }
  if (cn::num_verts(m) > 0) {
    const cn::box b = cn::bounding_box(m);
    rows.add("box", fmt::format("[[{}, {}, {}], [{}, {}, {}]]", number(b.min.x), number(b.min.y), number(b.min.z),
                                number(b.max.x), number(b.max.y), number(b.max.z)));
  }
  if (cn::num_polys(m) > 0) add_quality(m, rows);
  add_properties(m, rows);
  rows.print();
}

}  // namespace

int info(const info_options& options) {
  std::visit([&](const auto& m) { or_fail(unreadable_input, [&] { print_info(m, options); }); },
             load_mesh(options.file));
  return done;
}

}  // namespace program
