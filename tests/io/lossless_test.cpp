// What is in a mesh is written, or named in save_report::lost, or refused by options.strict.
#include <concino/io.hpp>
#include <concino/mesh.hpp>

#include <support/formats.hpp>

#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace concino;

namespace {

/// A trimesh without its first poly, whose edges stay.
struct with_loose_edges {
  trimesh m;
};

const std::string cube = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n.5 .5 2\n";
const std::string cube_faces = "4 1 4 3 2\n4 5 6 7 8\n4 1 2 6 5\n4 2 3 7 6\n4 3 4 8 7\n4 4 1 5 8\n3 5 6 9\n3 6 7 9\n3 7 8 9\n3 8 5 9\n";

bool mentions(const std::vector<std::string>& remarks, std::string_view words) {
  for (const std::string& r : remarks)
    if (r.find(words) != r.npos) return true;
  return false;
}

}  // namespace

template<>
struct concino::mesh_traits<with_loose_edges> : concino::mesh_traits<trimesh> {
  template<class R>
  static auto without_0(const R& r) {
    std::vector<poly_id> some;
    for (const poly_id p : r)
      if (p.raw() > 0) some.push_back(p);
    return some;
  }
  using base = mesh_traits<trimesh>;
  using H = with_loose_edges;
  static auto verts(const H& h) { return base::verts(h.m); }
  static auto polys(const H& h) { return without_0(base::polys(h.m)); }
  static auto edges(const H& h) { return base::edges(h.m); }
  static std::size_t num_verts(const H& h) { return base::num_verts(h.m); }
  static std::size_t num_polys(const H& h) { return base::num_polys(h.m) - 1; }
  static std::size_t num_edges(const H& h) { return base::num_edges(h.m); }
  static std::size_t vert_index_bound(const H& h) { return base::vert_index_bound(h.m); }
  static std::size_t edge_index_bound(const H& h) { return base::edge_index_bound(h.m); }
  static std::size_t poly_index_bound(const H& h) { return base::poly_index_bound(h.m); }
  template<class X>
  static std::size_t index_of(const H& h, X x) {
    return base::index_of(h.m, x);
  }
  static auto adj_p2v(const H& h, poly_id p) { return base::adj_p2v(h.m, p); }
  static auto adj_p2e(const H& h, poly_id p) { return base::adj_p2e(h.m, p); }
  static auto adj_p2p(const H& h, poly_id p) { return without_0(base::adj_p2p(h.m, p)); }
  static auto adj_v2v(const H& h, vert_id v) { return base::adj_v2v(h.m, v); }
  static auto adj_v2e(const H& h, vert_id v) { return base::adj_v2e(h.m, v); }
  static auto adj_v2p(const H& h, vert_id v) { return without_0(base::adj_v2p(h.m, v)); }
  static auto adj_e2v(const H& h, edge_id e) { return base::adj_e2v(h.m, e); }
  static auto adj_e2p(const H& h, edge_id e) { return without_0(base::adj_e2p(h.m, e)); }
  static vec3 point(const H& h, vert_id v) { return base::point(h.m, v); }
};

TEST_CASE("lossless: faces with the same verts, and faces of no poly, are written, or lost with a word, or refused") {
  struct sample {
    std::string text;
    const char* words;
    std::size_t num_faces_left;
  };
  const sample samples[] = {
      {"9 11 2\n" + cube + cube_faces + "4 5 8 7 6\n6 1 2 3 4 5 6\n5 11 7 8 9 10\n", "1 faces with the verts of another face", 10},
      {"9 10 1\n" + cube + cube_faces + "6 1 2 3 4 5 6\n", "4 faces of no poly", 6},
  };
  for (const sample& s : samples) {
    const auto m = load_text<polyhedralmesh>(s.text, file_format::hedra);
    for (const format_id f : {format_id(file_format::hedra), format_id(file_format::hybrid)}) {
      save_report r;
      const auto back = load_text<polyhedralmesh>(save_text(m, f, {.report = &r, .strict = true}), f);
      CHECK(num_faces(back) == num_faces(m));
      CHECK(r.lost.empty());
    }
    for (const format_id f : {format_id(file_format::vtk), format_id(file_format::vtu), format_id(file_format::medit), format_id(file_format::tet)}) {
      CAPTURE(f.name());
      save_report r;
      const auto back = load_text<polyhedralmesh>(save_text(m, f, {.report = &r}), f);
      CHECK(num_faces(back) == s.num_faces_left);
      CHECK(mentions(r.lost, s.words));
      CHECK_THROWS_AS(save_text(m, f, {.strict = true}), unsupported);
    }
  }
}

TEST_CASE("lossless: verts without polys are written in every format") {
  const auto volume = load_text<polyhedralmesh>("9 6 1\n" + cube + cube_faces.substr(0, 60) + "6 1 2 3 4 5 6\n", file_format::hedra);
  const auto surface = load_text<polygonmesh>("v 0 0 0\nv 1 0 0\nv 5 5 5\nv 0 1 0\nf 1 2 4\n", file_format::obj);
  const auto check = [](const auto& m, format_id f) {
    CAPTURE(f.name());
    save_report r;
    using M = std::remove_cvref_t<decltype(m)>;
    const auto back = load_text<M>(save_text(m, f, {.report = &r, .strict = true}), f);
    CHECK(num_verts(back) == num_verts(m));
    CHECK(point(back, vert_id{2}) == point(m, vert_id{2}));
  };
  for (const format_id f : {format_id(file_format::vtk), format_id(file_format::vtu), format_id(file_format::medit), format_id(file_format::gmsh)}) check(volume, f), check(surface, f);
  for (const format_id f : {format_id(file_format::hedra), format_id(file_format::hybrid), format_id(file_format::tet)}) check(volume, f);
  for (const format_id f : {format_id(file_format::obj), format_id(file_format::off), format_id(file_format::vtp), format_id(file_format::ply)}) check(surface, f);
}

TEST_CASE("lossless: values of polys that a mesh does not have leave no trace that a second save would lack") {
  surface_arrays points;
  points.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  points.offsets.push_back(0);
  polygonmesh m(std::move(points));
  poly_property<int>(m, "label");
  poly_property<double>(m, "heat");
  for (const format_id f : testing::formats_with_reader(standard_formats))
    for (const bool binary : {false, true}) {
      CAPTURE(f.name());
      try {
        const std::string first = save_text(m, f, {.binary = binary});
        CHECK(save_text(load_text<polygonmesh>(first, f), f, {.binary = binary}) == first);
      } catch (const unsupported&) {  // formats of volumes, of folders, or without a binary form
      }
    }
}

TEST_CASE("lossless: edges without polys are lost with a word") {
  const with_loose_edges m{trimesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}})};
  for (const format_id f : {format_id(file_format::obj), format_id(file_format::off), format_id(file_format::medit), format_id(file_format::vtk),
      format_id(file_format::vtp), format_id(file_format::ply), format_id(file_format::gmsh)}) {
    save_report r;
    save_text(m, f, {.report = &r});
    CHECK(r.lost == std::vector<std::string>{"2 edges without polys: ." + std::string(f == format_id(file_format::medit) ? "mesh" : f == format_id(file_format::gmsh) ? "msh" : f.name()) + " "
        "cannot store them"});
    CHECK_THROWS_AS(save_text(m, f, {.strict = true}), unsupported);
  }
}
