// Many elements at one element: tables are right in the special cases of building and editing.
#include <concino/edit/elements.hpp>
#include <concino/mesh.hpp>
#include <concino/mesh/support/face_soup.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/dense_meshes.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M>
void keeps_its_laws(const M& m) {
  for (const broken_law& b : check_laws(m)) FAIL_CHECK(b.law << ": " << b.what);
}

/// Checks the mesh as constructed, and after removing and adding polys.
template<class M>
void is_right(const std::string& name, M m) {
  CAPTURE(name);
  keeps_its_laws(m);
  std::vector<std::vector<vert_id>> removed;
  const auto count = num_polys(m);
  for (std::size_t p = 0; p < count; p += count / 3 + 1) {
    auto& verts = removed.emplace_back();
    for (const vert_id v : adj_p2v(m, poly_id{p})) verts.push_back(v);
    remove_poly(m, poly_id{p});
  }
  keeps_its_laws(m);
  if constexpr (!std::same_as<M, polyhedralmesh>) {
    for (const auto& verts : removed) add_poly(m, verts);
    keeps_its_laws(m);
  }
}

}  // namespace

TEST_CASE("dense meshes: surfaces obey all laws, built and edited") {
  for (const dense_mesh& c : {equal_triangles(3), equal_triangles(70), pages(5), pages(80)}) {
    is_right(c.name, c.mesh<trimesh>());
    is_right(c.name, c.mesh<polygonmesh>());
  }
  for (const unsigned n : {12u, 90u}) {
    for (const unsigned copies : {1u, 2u, 5u})
      for (const bool leaves : {false, true}) is_right("equal polygons", equal_polygons(n, copies, leaves).mesh<polygonmesh>());
    is_right("pages", polygon_with_pages(n).mesh<polygonmesh>());
  }
}

TEST_CASE("dense meshes: volumes obey all laws, built and edited") {
  for (const unsigned n : {3u, 40u})
    for (const dense_mesh& c : {tets_on_a_face(n), tets_around_an_edge(n), tets_on_an_edge(n), tets_at_a_vert(n), equal_tets(n)}) {
      is_right(c.name, c.mesh<tetmesh>());
      is_right(c.name, as_polyhedra(c));
    }
  is_right("rings", rings_at_a_vert(400).mesh<tetmesh>());
  for (const dense_mesh& c : {hexes_around_an_edge(40), hexes_on_three_verts(30)}) {
    is_right(c.name, c.mesh<hexmesh>());
    is_right(c.name, as_polyhedra(c));
  }
  for (const unsigned n : {5u, 90u})
    for (const unsigned copies : {1u, 2u, 4u}) {
      is_right("prism", polyhedra_of(prism_faces(n), copies));
      is_right("bipyramid", polyhedra_of(bipyramid_faces(n), copies));
    }
  for (const unsigned n : {5u, 90u}) is_right("polys of one face", polyhedra_of(equal_polygons(n, 1, false), n));
}

TEST_CASE("dense meshes: equal faces are merged, however many have the same three smallest verts") {
  // All quads of the verts 0, 1, 2 and another one, in each of the three cyclic orders, from each vert and in both orientations.
  face_soup soup;
  std::map<std::vector<unsigned>, unsigned> cycles;
  std::vector<std::vector<unsigned>> listed;
  for (unsigned round = 0; round < 4; ++round)
    for (unsigned far = 3; far < 40; ++far)
      for (const std::vector<unsigned>& order : {std::vector{0u, 1u, 2u, far}, std::vector{0u, 2u, 1u, far}, std::vector{0u, 1u, far, 2u}}) {
        std::vector<unsigned> face = order;
        std::rotate(face.begin(), face.begin() + (far + round) % 4, face.end());
        if (round % 2) std::reverse(face.begin(), face.end());
        listed.push_back(face);
        for (const unsigned v : face) soup.face_verts.push_back(vert_id{v});
        soup.face_offsets.push_back(static_cast<std::uint32_t>(soup.face_verts.size()));
        soup.poly_offsets.push_back(static_cast<std::uint32_t>(soup.face_offsets.size() - 1));
      }
  const std::size_t count = listed.size();
  const polyhedra_arrays united = std::move(soup).unite(std::vector<vec3>(40));
  CHECK(united.face_offsets.size() == 37 * 3 + 1);
  for (std::size_t f = 0; f < count; ++f) {
    CHECK(united.poly_faces[f].raw() == f % (37 * 3));  // faces are numbered in order of appearance
    const vert_id* const kept = united.face_verts.data() + united.face_offsets[united.poly_faces[f].raw()];
    std::vector<vert_id> given;
    for (const unsigned v : listed[f]) given.push_back(vert_id{v});
    CHECK(compare_cycles(kept, given.data(), 4) == (united.outward[f] ? 1 : -1));
  }
}
