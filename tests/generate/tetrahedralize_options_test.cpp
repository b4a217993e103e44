#include <concino/generate/tetrahedralize_options.hpp>

#include <doctest/doctest.h>

using namespace concino;

namespace {

struct back_end {
  const char* name() const { return "a back end"; }
  tetrahedralize_output tetrahedralize(const tetrahedralize_input&, const tetrahedralize_options&) const { return {}; }
};
struct without_name {
  tetrahedralize_output tetrahedralize(const tetrahedralize_input&, const tetrahedralize_options&) const { return {}; }
};
struct not_const {
  const char* name() const { return "a back end"; }
  tetrahedralize_output tetrahedralize(const tetrahedralize_input&, const tetrahedralize_options&) { return {}; }
};

}  // namespace

TEST_CASE("tetrahedralize_options: what a back end must have") {
  CHECK(requirement::is_tet_back_end<back_end>);
  CHECK_FALSE(requirement::is_tet_back_end<without_name>);
  CHECK_FALSE(requirement::is_tet_back_end<not_const>);
  CHECK_FALSE(requirement::is_tet_back_end<int>);
}

TEST_CASE("tetrahedralize_options: by default the boundary is kept, nothing is refined, and a back end may not run without end") {
  const tetrahedralize_options o;
  CHECK(o.keep_boundary);
  CHECK((o.radius_edge == 0 && o.min_dihedral_deg == 0 && o.max_volume == 0 && !o.edge_length));
  CHECK((o.max_seconds > 0 && !o.in_process));
}
