#include <concino/level_sets/detail/embed/add_face_with.hpp>

#include <concino/mesh/hexmesh.hpp>
#include <concino/mesh/tetmesh.hpp>

#include <support/cavities.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

namespace cn = concino;

namespace {

/// Tets that list their faces in reverse.
struct faces_backwards : cn::tetmesh {
  using cn::tetmesh::tetmesh;
  explicit faces_backwards(const cn::tetmesh& m) : cn::tetmesh(m) {}
};

}  // namespace
template<>
struct concino::mesh_traits<faces_backwards> : mesh_traits<tetmesh> {
  static std::vector<face_id> adj_p2f(const tetmesh& m, poly_id p) {
    const auto in_order = mesh_traits<tetmesh>::adj_p2f(m, p);
    return {in_order[3], in_order[2], in_order[1], in_order[0]};
  }
};

TEST_CASE_TEMPLATE("add_face_with: finds each face by its verts in any order", M, cn::tetmesh, faces_backwards, cn::hexmesh) {
  M m;
  if constexpr (cn::arity_v<M> == 8) m = cn::testing::grid<cn::hexmesh>(2);
  else m = M(cn::testing::grid<cn::tetmesh>(2));
  std::vector<cn::face_id> expected, found;
  for (const auto f : cn::faces(m)) {
    std::vector<cn::vert_id> corners;
    for (const auto v : cn::adj_f2v(m, f)) corners.push_back(v);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
      expected.push_back(f);
      cn::detail::add_face_with(m, corners, found);
    }
  }
  CHECK(found == expected);
}
