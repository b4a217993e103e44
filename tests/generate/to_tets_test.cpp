#include <concino/generate/to_tets.hpp>

#include <concino/generate/agglomerate.hpp>
#include <concino/generate/box.hpp>
#include <concino/generate/jitter.hpp>
#include <concino/generate/random_labels.hpp>
#include <concino/generate/random_points.hpp>
#include <concino/generate/voronoi_polyhedra.hpp>
#include <concino/geometry/orientation.hpp>
#include <concino/io/load_any.hpp>
#include <concino/mesh/boundary.hpp>

#include <support/corpus_meshes.hpp>
#include <support/kinds.hpp>
#include <support/random_meshes.hpp>
#include <support/subdivisions.hpp>
#include <support/unit_cells.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <variant>

using namespace concino;
using namespace concino::testing;

namespace {

struct checked_tets {
  tetmesh mesh;
  correspondence from;
  std::vector<std::size_t> inverted_cells = {};
};

/// Checks that the tets fit together: the faces of each poly are covered by the outer faces of its tets, and all others are between two tets of one poly.
template<class M>
checked_tets check_tets(const M& m) {
  checked_tets r;
  std::vector<poly_id> inverted;
  r.mesh = to_tets(m, {.correspondence = &r.from, .inverted = &inverted, .inverted_cells = &r.inverted_cells});
  const tetmesh& t = r.mesh;
  CHECK(check_laws(t).empty());
  REQUIRE(num_verts(t) >= num_verts(m));
  std::size_t boundary_triangles = 0, boundary_faces = 0;
  for (const auto f : faces(m))
    if (is_boundary(m, f)) boundary_triangles += num_elements(adj_f2v(m, f)) - 2;
  for (const face_id f : faces(t)) {
    CHECK(num_elements(adj_f2p(t, f)) <= 2);
    boundary_faces += is_boundary(t, f);
  }
  CHECK(boundary_faces == boundary_triangles);
  std::set<std::uint32_t> cells;
  std::vector<poly_id> not_positive;
  for (const poly_id p : polys(t)) {
    std::array<vec3, 4> x;
    std::size_t n = 0;
    for (const vert_id v : adj_p2v(t, p)) x[n++] = point(t, v);
    REQUIRE(r.from.polys[p.raw()].size() == 1);
    if (orient3d(x[0], x[1], x[2], x[3]) > 0) continue;
    not_positive.push_back(p);
    cells.insert(r.from.polys.only(p.raw()));
  }
  CHECK(inverted == not_positive);
  CHECK(std::set<std::uint32_t>(r.inverted_cells.begin(), r.inverted_cells.end()) == cells);
  CHECK(total_measure(t) == doctest::Approx(total_measure(m)).epsilon(1e-12));
  return r;
}

/// The volume of the tets of each poly.
std::vector<double> volumes_of_parts(const checked_tets& t, std::size_t bound) {
  std::vector<double> sum(bound);
  for (const poly_id p : polys(t.mesh)) sum[t.from.polys.only(p.raw())] += measure(t.mesh, p);
  return sum;
}

/// A cell of a standard shape, whose verts have the numbers of a permutation.
polyhedralmesh numbered_cell(cell_shape s, const std::vector<unsigned>& number) {
  const std::vector<vec3> x = unit_cell(s);
  std::vector<vec3> points(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) points[number[i]] = x[i];
  const standard_cell& table = standard_cell_of(s);
  std::vector<std::vector<unsigned>> walls;
  std::vector<std::vector<std::pair<unsigned, bool>>> cells(1);
  for (unsigned f = 0; f < table.num_faces; ++f) {
    walls.emplace_back();
    for (unsigned k = 0; k < table.face_size[f]; ++k) walls.back().push_back(number[table.face_vert[f][k]]);
    cells[0].push_back({f, true});
  }
  return polyhedralmesh(points, walls, cells);
}

}  // namespace

TEST_CASE("to_tets: standard cells with any numbers at their verts have 1, 2, 3, and 5 or 6 tets") {
  std::map<std::size_t, unsigned> sizes;
  for (const cell_shape s : {cell_shape::tet, cell_shape::pyramid, cell_shape::prism, cell_shape::hex}) {
    std::vector<unsigned> number(standard_cell_of(s).num_verts);
    std::iota(number.begin(), number.end(), 0u);
    std::mt19937 random(1);
    for (unsigned round = 0; round < (s == cell_shape::hex ? 200u : 40u); ++round) {
      const polyhedralmesh m = numbered_cell(s, number);
      const checked_tets t = check_tets(m);
      CHECK(t.inverted_cells.empty());
      CHECK(num_verts(t.mesh) == num_verts(m));
      const std::size_t n = num_polys(t.mesh);
      ++sizes[n];
      if (s == cell_shape::hex) CHECK((n == 5 || n == 6));
      else CHECK(n == (s == cell_shape::tet ? 1 : s == cell_shape::pyramid ? 2 : 3));
      for (std::size_t i = number.size(); i > 1; --i) std::swap(number[i - 1], number[random() % i]);
    }
  }
  CHECK(sizes[5] > 10);
  CHECK(sizes[6] > 10);
}

TEST_CASE_TEMPLATE("to_tets: every kind of volume", M, CONCINO_VOLUME_KINDS) {
  M m = grid<M>(3);
  checked_tets t = check_tets(m);
  CHECK(t.inverted_cells.empty());
  check_sound(t.mesh, 1);
  const auto parts = volumes_of_parts(t, poly_index_bound(m));
  for (const poly_t<M> p : polys(m)) CHECK(parts[p.raw()] == doctest::Approx(measure(m, p)).epsilon(1e-13));
  jitter(m, 0.03);
  t = check_tets(m);
  CHECK(t.inverted_cells.empty());
  check_sound(t.mesh, 1);
  for (const int exponent : {-300, 300}) {
    const M scaled(scaled_by_power_of_two(grid_arrays<M>(2), exponent));
    std::vector<poly_id> inverted;
    CHECK(num_polys(to_tets(scaled, {.inverted = &inverted})) == num_polys(to_tets(grid<M>(2))));
    CHECK(inverted.empty());
  }
}

TEST_CASE("to_tets: a box of hexes with random numbers at its verts") {
  cell_arrays a = hex_grid(4);
  std::vector<unsigned> number(a.points.size());
  std::iota(number.begin(), number.end(), 0u);
  std::mt19937 random(3);
  for (std::size_t i = number.size(); i > 1; --i) std::swap(number[i - 1], number[random() % i]);
  const std::vector<vec3> points = a.points;
  for (std::size_t i = 0; i < points.size(); ++i) a.points[number[i]] = points[i];
  for (vert_id& v : a.verts) v = vert_id{number[v.raw()]};
  hexmesh m(a);
  jitter(m, 0.1);
  const checked_tets t = check_tets(m);
  CHECK(t.inverted_cells.empty());
  CHECK(num_verts(t.mesh) == num_verts(m));
  CHECK(num_polys(t.mesh) < 6 * num_polys(m));
  check_sound(t.mesh, 1);
}

TEST_CASE("to_tets: Voronoi cells and prisms over polygons") {
  const polyhedralmesh cells = voronoi_polyhedra(random_points(60, {{0, 0, 0}, {1, 1, 1}}, 3), {{0, 0, 0}, {1, 1, 1}});
  const checked_tets t = check_tets(cells);
  CHECK(t.inverted_cells.empty());
  check_sound(t.mesh, 1);
  CHECK(num_verts(t.mesh) == num_verts(cells) + num_polys(cells));
  const auto parts = volumes_of_parts(t, poly_index_bound(cells));
  for (const poly_id p : polys(cells)) CHECK(parts[p.raw()] == doctest::Approx(measure(cells, p)).epsilon(1e-12));
  const polyhedralmesh prisms(extrude(with_offsets(triangle_grid(3)), 2));
  const checked_tets of_prisms = check_tets(prisms);
  CHECK(num_polys(of_prisms.mesh) == 3 * num_polys(prisms));
  CHECK(num_verts(of_prisms.mesh) == num_verts(prisms));
}

TEST_CASE("to_tets: merged cells that their means do not see as a whole are listed") {
  const tetmesh m = grid<tetmesh>(3);
  for (const unsigned labels : {4u, 12u, 40u}) {
    const polyhedralmesh merged = agglomerate(m, random_labels(m, labels));
    std::vector<std::size_t> cells;
    std::vector<poly_id> inverted;
    correspondence c;
    const tetmesh t = to_tets(merged, {.correspondence = &c, .inverted = &inverted, .inverted_cells = &cells});
    CHECK(check_laws(t).empty());
    CHECK(!cells.empty());
    CHECK(!inverted.empty());
    double sum = 0;
    std::vector<double> part(num_polys(merged));
    for (const poly_id p : polys(t)) part[c.polys.only(p.raw())] += measure(t, p);
    for (const double x : part) sum += x;
    CHECK(sum == doctest::Approx(1).epsilon(1e-12));
    for (const poly_id p : polys(merged))  // the others are covered without overlaps
      if (std::find(cells.begin(), cells.end(), p.raw()) == cells.end())
        for (const poly_id q : polys(t))
          if (c.polys.only(q.raw()) == p.raw()) CHECK(measure(t, q) > 0);
  }
}

TEST_CASE("to_tets: merged hexes, whose faces have straight corners") {
  const hexmesh m = grid<hexmesh>(4);
  auto block = make_poly_map<int>(m, 0);
  for (const poly_id p : polys(m)) {
    const vec3 x = vert_mean(m, p);
    block[p] = (x.x > 0.5) + 2 * (x.y > 0.5) + 4 * (x.z > (x.x > 0.5 ? 0.25 : 0.5));
  }
  const polyhedralmesh merged = agglomerate(m, block);
  const checked_tets t = check_tets(merged);
  CHECK(num_polys(merged) == 8);
  CHECK(t.inverted_cells.empty());
  check_sound(t.mesh, 1);
}

TEST_CASE("to_tets: cells of which a tet is inverted are cut from their mean, or listed") {
  std::map<std::size_t, unsigned> cut_from_mean, listed;
  const auto tets_of = [&](const hexmesh& m, std::vector<std::size_t>& cells) { return to_tets(m, {.inverted_cells = &cells}); };
  std::vector<std::size_t> cells{5};
  tetmesh t;
  for (unsigned seed = 0; seed < 300; ++seed) {
    t = tets_of(hexmesh(jittered(hex_grid(1), 0.45, true, seed)), cells);
    ++(cells.empty() ? cut_from_mean : listed)[num_polys(t)];
    CHECK(num_verts(t) == (num_polys(t) == 12 ? 9 : 8));
    for (const poly_id p : polys(t)) CHECK((measure(t, p) > 0 || !cells.empty()));
  }
  CHECK(cut_from_mean[6] > 50);
  CHECK(cut_from_mean[12] > 3);
  CHECK(listed[6] > 10);
  CHECK(listed[12] == 0);
  cell_arrays a = hex_grid(1);
  for (vec3& x : a.points) x.z = -x.z;  // inside out
  t = tets_of(hexmesh(a), cells);
  CHECK(cells == std::vector<std::size_t>{0});
  CHECK(num_verts(t) == 8);
  for (vec3& x : a.points) x.z = 0;  // flat
  t = tets_of(hexmesh(a), cells);
  CHECK(cells == std::vector<std::size_t>{0});
}

TEST_CASE("to_tets: properties, origins, archetype, deleted polys") {
  polyhedralmesh m = grid<polyhedralmesh>(2);
  add_properties(m);
  remove_poly(m, poly_id{3});
  correspondence c;
  const tetmesh t = to_tets(m, {.correspondence = &c});
  CHECK(check_laws(t).empty());
  const auto place = find_vert_property<vec3>(t, "place");
  const auto mass = find_poly_property<double>(t, "mass");
  const auto crease = find_edge_property<int>(t, "crease");
  REQUIRE(place);
  for (const vert_id v : verts(t)) CHECK(norm(place[v] - point(t, v)) < 1e-14);
  for (const poly_id p : polys(t)) CHECK(mass[p] == doctest::Approx(measure(t, p)).epsilon(1e-12));
  for (const edge_id e : edges(t)) CHECK(crease[e] == (c.edges[e.raw()].empty() ? 0 : 1 + static_cast<int>(c.edges[e.raw()][0].index)));
  std::vector<int> met(face_index_bound(m));
  for (const face_id f : faces(t))
    if (!c.faces[f.raw()].empty()) ++met[c.faces[f.raw()][0].index];
  for (const face_id f : faces(m)) CHECK(met[f.raw()] == static_cast<int>(num_elements(adj_f2v(m, f))) - 2);
  const tetmesh plain = to_tets(m, {.properties = false});
  CHECK(property_list(plain).empty());
  CHECK(record_of(to_tets(only_embedded_mesh(m))) == record_of(plain));
}

TEST_CASE_TEMPLATE("to_tets: random cells of any shape, also flat, inverted and not closed", M, CONCINO_VOLUME_KINDS) {
  std::mt19937 random(7);
  for (unsigned i = 0; i < num_random_meshes() / 4; ++i) {
    const M m = random_mesh<M>(random);
    correspondence c;
    std::vector<poly_id> inverted;
    std::vector<std::size_t> cells;
    const tetmesh t = to_tets(m, {.correspondence = &c, .inverted = &inverted, .inverted_cells = &cells});
    CHECK(check_laws(t).empty());
    std::vector<int> parts(poly_index_bound(m));
    for (const poly_id p : polys(t)) {
      REQUIRE(c.polys[p.raw()].size() == 1);
      ++parts[c.polys.only(p.raw())];
    }
    for (const auto p : polys(m)) CHECK(parts[p.raw()] > 0);
    CHECK(inverted.empty() == cells.empty());
    double sum = 0;
    for (const poly_id p : polys(t)) sum += measure(t, p);
    if (arity_v<M> == 4) CHECK(sum == doctest::Approx(total_measure(m)).epsilon(1e-12));
  }
}

TEST_CASE("to_tets: empty meshes, and points that are not finite") {
  CHECK(num_polys(to_tets(polyhedralmesh())) == 0);
  hexmesh m = grid<hexmesh>(1);
  set_point(m, vert_id{5}, vec3{0, std::numeric_limits<double>::quiet_NaN(), 0});
  CHECK_THROWS_WITH_AS(to_tets(m), "to_tets: the point of vert 5 is not finite; validate() lists all such verts", invalid_mesh);
}

TEST_CASE("to_tets: volumes of files") {
  for (const corpus_row& row : corpus_meshes()) {
    if (std::filesystem::file_size(row.file) > (long_run() ? 20000000u : 100000u)) continue;
    std::visit(
        [&](const auto& m) {
          if constexpr (VolumeMesh<std::remove_cvref_t<decltype(m)>>) {
            CAPTURE(row.name);
            std::vector<std::size_t> cells;
            const tetmesh t = to_tets(m, {.inverted_cells = &cells});
            CHECK(check_laws(t).empty());
            if (row.name.rfind("polyhedral/agglomerated", 0) != 0) CHECK(50 * cells.size() <= num_polys(m));
            if (cells.empty())
              for (const face_id f : faces(t)) CHECK(num_elements(adj_f2p(t, f)) <= 2);
          }
        },
        load_any(row.file));
  }
}
