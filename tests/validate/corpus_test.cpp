// The reports of validate on every mesh of the corpus agree with an independent program.
#include <concino/validate/validate.hpp>

#include <support/corpus_meshes.hpp>

#include <doctest/doctest.h>

#include <string>

using namespace concino;
using namespace concino::testing;

TEST_CASE("corpus: facts and numbers of defects match the index") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  // "nonmanifold_verts=422" in the column of remarks
  const auto remark = [](const std::string& text, const std::string& key) {
    const auto at = text.find(key + "=");
    return at == std::string::npos ? std::size_t{0} : std::size_t{std::stoul(text.substr(at + key.size() + 1))};
  };
  std::size_t manifold = 0;
  for (const auto& row : rows) {
    INFO(row.name);
    const auto at = [&](const char* name) { return row.column.at(name); };
    std::visit(
        [&]<class M>(const M& m) {
          const auto r = validate(m, {.max_per_kind = 0});
          CHECK(r.size() == 0);
          const mesh_facts& f = r.facts;
          CHECK((f.manifold ? "yes" : "no") == at("manifold"));
          CHECK((f.orientable ? "True" : "False") == at("orientable"));
          CHECK(std::to_string(f.components) == at("components"));
          CHECK(std::to_string(f.euler_characteristic) == at("euler_chi"));
          CHECK((f.genus ? std::to_string(*f.genus) : "") == at("genus"));
          CHECK(std::to_string(f.boundary_loops) == (at("boundary_loops") == "n/a" ? "0" : at("boundary_loops")));
          manifold += f.manifold;

          CHECK(r.count(defect_kind::non_manifold_edge) == remark(at("facts"), "nonmanifold_edges"));
          CHECK(r.count(defect_kind::non_manifold_vert) == remark(at("facts"), "nonmanifold_verts"));
          CHECK(r.count(defect_kind::isolated_vert) == std::stoul(at("n_verts")) - std::stoul(at("n_verts_used")));
          CHECK((r.count(defect_kind::not_orientable) > 0) == (at("orientable") == "False"));
          for (const auto kind : {defect_kind::open_cell, defect_kind::unreferenced_face, defect_kind::non_manifold_face, defect_kind::degenerate_element,
                                  defect_kind::inverted_cell, defect_kind::non_finite_point})
            CHECK(r.count(kind) == 0);
          if (!f.manifold) return;
          for (const auto kind : {defect_kind::inconsistent_winding, defect_kind::duplicated_element, defect_kind::zero_size, defect_kind::self_touching}) {
            INFO(defect_name(kind));
            // one bent face of a restricted Voronoi cell folds over
            CHECK(r.count(kind) == (kind == defect_kind::self_touching && row.name == "polyhedral/eight_voronoi.hedra" ? 1 : 0));
          }
        },
        load_any(row.file.string()));
  }
  CHECK(rows.size() > 25);
  CHECK(manifold == rows.size() - 3);
}
