// Quality of the small meshes of the corpus: sizes are those of area() and volume(), values are in their ranges, and scale changes nothing.
#include <concino/concepts/views/with_points.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/quality/worst.hpp>

#include <support/corpus_meshes.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <type_traits>
#include <variant>

namespace cn = concino;

TEST_CASE("quality: of the small meshes of the corpus") {
  using cn::metric;
  const auto rows = cn::testing::corpus_meshes();
  if (rows.empty()) return cn::testing::skip("no corpus");
  std::size_t polys_seen = 0;
  for (const auto& row : rows) {
    if (std::filesystem::file_size(row.file) > 40000) continue;  // long enough with sanitizers
    INFO(row.name);
    std::visit(
        [&](const auto& m) {
          using M = std::remove_cvref_t<decltype(m)>;
          double unit = 0;
          const auto size = cn::quality(m, cn::dimension_v<M> == 2 ? metric::area : metric::volume);
          for (const auto p : cn::polys(m)) {
            unit = std::max(unit, std::abs(cn::measure(m, p)));
            ++polys_seen;
          }
          std::size_t other_size = 0;
          for (const auto p : cn::polys(m)) other_size += !(std::abs(size[p] - cn::measure(m, p)) <= 1e-12 * unit);
          CHECK(other_size == 0);
          auto points = cn::make_vert_map<cn::vec3>(m);
          for (const auto v : cn::verts(m)) points[v] = 0x1p30 * cn::point(m, v);
          const auto larger = cn::with_points(m, points);
          for (const metric what : {metric::scaled_jacobian, metric::mean_ratio, metric::planarity, metric::star_shapedness, metric::edge_ratio}) {
            const std::string name(cn::name_of(what));
            INFO(name);
            const auto value = cn::quality(m, what);
            const auto of_larger = cn::quality(larger, what);
            std::size_t outside = 0, changed = 0;
            for (const auto p : cn::polys(m)) {
              outside += !cn::limits_of(what, cn::shape_of_poly(m, p)).full.contains(value[p]);
              changed += !(value[p] == of_larger[p] || std::abs(value[p] - of_larger[p]) < 1e-14);  // cube roots are rounded differently
            }
            CHECK(outside == 0);
            CHECK(changed == 0);
            const auto w = cn::worst(m, what);
            CHECK(w.value == value[w.poly]);
          }
        },
        cn::load_any(row.file.string()));
  }
  CHECK(polys_seen > 1000);
}
