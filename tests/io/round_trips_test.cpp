// Every file of the corpus survives being saved to every format that can hold it, and read again.
#include <concino/io.hpp>

#include <support/formats.hpp>
#include <support/corpus.hpp>
#include <support/same_mesh.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// The verts of a polygon, beginning with the smallest one.
std::vector<std::size_t> rotated(std::vector<std::size_t> verts) {
  std::rotate(verts.begin(), std::min_element(verts.begin(), verts.end()), verts.end());
  return verts;
}

/// Each poly as its faces, seen from outside, or as itself in a surface.
template<class M>
std::vector<std::vector<std::vector<std::size_t>>> polys_as_lists(const M& m) {
  std::vector<std::vector<std::vector<std::size_t>>> all;
  const auto indices = [&](const auto& around) {
    std::vector<std::size_t> r;
    for (const auto v : around) r.push_back(index_of(m, v));
    return r;
  };
  for (const auto p : polys(m)) {
    all.emplace_back();
    if constexpr (dimension_v<M> == 2) {
      all.back().push_back(rotated(indices(adj_p2v(m, p))));
    } else {
      for (const auto f : adj_p2f(m, p)) {
        auto face = indices(adj_f2v(m, f));
        if (!face_is_outward(m, p, f)) std::reverse(face.begin(), face.end());
        all.back().push_back(rotated(face));
      }
      std::sort(all.back().begin(), all.back().end());
    }
  }
  return all;
}

/// The values of a property as bytes, sorted by the verts of their elements: files list edges and faces in an order of their own.
template<class M>
std::vector<std::pair<std::vector<std::size_t>, std::string>> values_by_verts(const M& m, const property_info& p) {
  const std::string bytes = bytes_of_property(m, p);
  std::vector<std::pair<std::vector<std::size_t>, std::string>> all;
  const auto add = [&](std::size_t index, std::size_t bound, const auto& verts) {
    const std::size_t size = bytes.size() / bound;
    std::vector<std::size_t> key;
    for (const auto v : verts) key.push_back(index_of(m, v));
    std::sort(key.begin(), key.end());
    all.emplace_back(key, bytes.substr(index * size, size));
  };
  if (p.kind == element_kind::edge)
    for (const auto e : edges(m)) add(index_of(m, e), edge_index_bound(m), adj_e2v(m, e));
  else if (p.kind == element_kind::face) {
    if constexpr (dimension_v<M> == 3)  // surfaces have no faces
      for (const auto f : faces(m)) add(index_of(m, f), face_index_bound(m), adj_f2v(m, f));
  } else
    all.emplace_back(std::vector<std::size_t>(), bytes);
  std::sort(all.begin(), all.end());
  return all;
}

struct contents {
  std::vector<vec3> points;
  std::vector<std::vector<std::vector<std::size_t>>> polys;
  std::map<std::string, std::vector<std::pair<std::vector<std::size_t>, std::string>>> properties;  // by kind and name
};

contents contents_of(const any_mesh& any) {
  return std::visit(
      [](const auto& m) {
        contents r;
        for (const auto v : verts(m)) r.points.push_back(point(m, v));
        r.polys = polys_as_lists(m);
        for (const property_info& p : property_list(m)) r.properties[core::joined({to_string(p.kind), " property \"", p.name, "\""})] = values_by_verts(m, p);
        return r;
      },
      any);
}

std::string text_of(const any_mesh& any, format_id format, bool binary, save_report& report) {
  return std::visit([&](const auto& m) { return save_text(m, format, {.report = &report, .binary = binary}); }, any);
}

/// Whether a mesh has values of edges, or of faces.
bool has_values_of(const contents& c, const std::string& kind) {
  return std::any_of(c.properties.begin(), c.properties.end(), [&](const auto& x) { return x.first.starts_with(kind); });
}

/// Checks that each property is the same afterwards, or reported as lost, and that there are no others.
void check_properties(const contents& before, const contents& after, const save_report& saved, format_id format) {
  for (const auto& [name, values] : before.properties) {
    const std::string property = name;
    CAPTURE(property);
    const bool is_lost = std::any_of(saved.lost.begin(), saved.lost.end(), [&](const std::string& lost) { return lost.starts_with(property); });
    const bool has_reals = property == "vert property \"texture\"" || property == "vert property \"normal\"";
    const bool is_rounded = has_reals && std::any_of(saved.lost.begin(), saved.lost.end(), [](const std::string& lost) {
      return lost.starts_with("binary .off holds floats");
    });
    const auto found = after.properties.find(property);
    CHECK(is_lost != (found != after.properties.end() && (is_rounded || found->second == values)));
  }
  for (const auto& [name, values] : after.properties) {
    const std::string property = name;
    CAPTURE(property);
    const bool is_number = property == "poly property \"label\"" && before.properties.count("poly property \"object\"") == 1;  // by which OBJ numbers names
    // .msh marks edges and faces that it lists for their values and that have no label
    const bool is_listed = format == file_format::gmsh && ((property == "edge property \"entity\"" && has_values_of(before, "edge property")) ||
                                                           (property == "face property \"entity\"" && has_values_of(before, "face property")));
    CHECK((before.properties.count(property) == 1 || is_number || is_listed));
  }
}

/// The points of the corners of each polygon, beginning with the smallest one: what an STL file holds. Binary files hold floats.
std::vector<std::vector<std::array<double, 3>>> corners_of(const contents& c, bool binary) {
  std::vector<std::vector<std::array<double, 3>>> all;
  const auto stored = [&](double x) { return binary ? static_cast<double>(static_cast<float>(x)) : x; };
  for (const auto& poly : c.polys) {
    auto& points = all.emplace_back();
    for (const std::size_t v : poly[0]) points.push_back({stored(c.points[v].x), stored(c.points[v].y), stored(c.points[v].z)});
    std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
  }
  return all;
}

/// Returns whether the format can hold the mesh.
bool survives(const any_mesh& m, const contents& before, format_id format, bool binary, const std::string& path) {
  CAPTURE(format.name());
  CAPTURE(binary);
  std::string text;
  save_report saved;
  try {
    text = text_of(m, format, binary, saved);
  } catch (const unsupported&) {
    return false;
  }
  write_file(path, text);
  load_report report;
  const any_mesh again = load_any(path, {.format = format, .report = &report});
  CHECK(report.reoriented_polys == 0);
  const contents after = contents_of(again);
  const bool is_rounded = binary && format == file_format::off;
  const bool is_stl = format == file_format::stl;  // which numbers its verts anew
  if (is_stl) CHECK((corners_of(before, binary) == corners_of(after, binary)));
  else CHECK(after.points.size() == before.points.size());
  if (!is_rounded && !is_stl) CHECK(after.points == before.points);
  if (is_stl) {
    // its own tests compare properties
  } else if (before.polys == after.polys) {
    check_properties(before, after, saved, format);
  } else {  // .mesh lists cells by their shapes
    CHECK(!saved.notes.empty());
    auto sorted = before.polys, sorted_after = after.polys;
    std::sort(sorted.begin(), sorted.end());
    std::sort(sorted_after.begin(), sorted_after.end());
    CHECK((sorted == sorted_after));
  }
  std::string second = text_of(again, format, binary, saved);
  if (before.polys != after.polys && !is_stl) {  // the elements have another order now, which stays
    text = second;
    write_file(path, text);
    second = text_of(load_any(path, {.format = format}), format, binary, saved);
  }
  const bool is_same_again = second == text;
  CHECK(is_same_again);
  return true;
}

}  // namespace

TEST_CASE("round trips: every file of the corpus through every format that can hold it, and the second save is the first") {
  if (corpus_dir().empty()) return skip("no corpus");
  const std::size_t largest = long_run() ? 2'000'000 : 60'000;  // bytes
  const temporary_folder folder;
  std::size_t files = 0, trips = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus_dir())) {
    const std::string path = entry.path().string();
    if (!entry.is_regular_file() || entry.file_size() > largest || path.find("/bad/") != std::string::npos) continue;
    any_mesh m;
    try {
      m = load_any(path, {.repeated_verts = repeated_verts::collapse});
    } catch (const unsupported&) {
      continue;  // not a mesh
    }
    CAPTURE(path);
    ++files;
    std::size_t here = 0;
    const contents before = contents_of(m);
    for (const format_id format : formats_with_reader(standard_formats))
      for (const bool binary : {false, true}) here += survives(m, before, format, binary, folder / "mesh");
    CHECK(here >= 3);
    trips += here;
  }
  MESSAGE(files << " files, " << trips << " round trips");
  CHECK(files >= 15);
}
