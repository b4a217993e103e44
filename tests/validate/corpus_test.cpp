// What validate says of every mesh of the corpus, against the figures of an independent program.
#include <concino/validate/validate.hpp>

#include <support/corpus_meshes.hpp>

#include <doctest/doctest.h>

#include <string>

using namespace concino;
using namespace concino::testing;

TEST_CASE("corpus: manifold, orientable, boundary loops, genus, components and Euler characteristic are those of the index") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  std::size_t manifold = 0;
  for (const auto& row : rows) {
    INFO(row.name);
    const mesh_facts f = std::visit([](const auto& m) { return validate(m).facts; }, load_any(row.file.string()));
    CHECK((f.manifold ? "yes" : "no") == row.column.at("manifold"));
    CHECK((f.orientable ? "True" : "False") == row.column.at("orientable"));
    CHECK(std::to_string(f.components) == row.column.at("components"));
    CHECK(std::to_string(f.euler_characteristic) == row.column.at("euler_chi"));
    CHECK((f.genus ? std::to_string(*f.genus) : "") == row.column.at("genus"));
    const std::string loops = row.column.at("boundary_loops");
    CHECK(std::to_string(f.boundary_loops) == (loops == "n/a" ? "0" : loops));
    manifold += f.manifold;
  }
  CHECK(rows.size() > 25);
  CHECK(manifold == rows.size() - 3);
}

TEST_CASE("corpus: defects that the index counts") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  // "nonmanifold_verts=422" in the column of remarks
  const auto remark = [](const std::string& text, const std::string& key) {
    const auto at = text.find(key + "=");
    return at == std::string::npos ? std::size_t{0} : std::size_t{std::stoul(text.substr(at + key.size() + 1))};
  };
  for (const auto& row : rows) {
    INFO(row.name);
    const std::string& facts = row.column.at("facts");
    std::visit(
        [&]<class M>(const M& m) {
          const auto r = validate(m, {.most_per_kind = 0});
          CHECK(r.size() == 0);
          CHECK(r.count(defect_kind::non_manifold_edge) == remark(facts, "nonmanifold_edges"));
          CHECK(r.count(defect_kind::non_manifold_vert) == remark(facts, "nonmanifold_verts"));
          CHECK(r.count(defect_kind::isolated_vert) == std::stoul(row.column.at("n_verts")) - std::stoul(row.column.at("n_verts_used")));
          CHECK((r.count(defect_kind::not_orientable) > 0) == (row.column.at("orientable") == "False"));
          for (const auto kind : {defect_kind::open_cell, defect_kind::unreferenced_face, defect_kind::non_manifold_face, defect_kind::degenerate_element,
                                  defect_kind::inverted_cell, defect_kind::non_finite_point})
            CHECK(r.count(kind) == 0);
          if (r.facts.manifold)
            for (const auto kind : {defect_kind::inconsistent_winding, defect_kind::duplicated_element, defect_kind::zero_size, defect_kind::self_touching}) {
              INFO(defect_name(kind));
              // one bent face of a restricted Voronoi cell folds over
              CHECK(r.count(kind) == (kind == defect_kind::self_touching && row.name == "polyhedral/eight_voronoi.hedra" ? 1 : 0));
            }
        },
        load_any(row.file.string()));
  }
}
