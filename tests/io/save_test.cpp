#include <concino/io/load.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh/submesh.hpp>

#include <support/kinds.hpp>
#include <support/reading.hpp>
#include <support/temporary.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <sys/resource.h>
#include <sys/stat.h>
#include <clocale>
#include <csignal>
#include <limits>

using namespace concino;
using namespace concino::testing;

namespace {

/// A trimesh whose first vert and first poly are deleted, so that ids start at 1.
struct with_holes {
  trimesh m;
};

template<class A, class B>
bool same_points(const A& a, const B& b) {
  if (num_verts(a) != num_verts(b)) return false;
  for (const auto v : verts(a)) {
    const vec3 p = point(a, v), q = point(b, v);
    if (std::bit_cast<std::array<std::uint64_t, 3>>(p) != std::bit_cast<std::array<std::uint64_t, 3>>(q)) return false;
  }
  return true;
}

/// All connectivity that a file can store.
template<class M>
std::vector<std::vector<unsigned>> said(const M& m) {
  std::vector<std::vector<unsigned>> all;
  for (const auto p : polys(m)) {
    all.push_back(raw(adj_p2v(m, p)));
    if constexpr (dimension_v<M> == 3 && arity_v<M> == 0) {
      all.back() = raw(adj_p2f(m, p));
      for (const auto f : adj_p2f(m, p)) all.back().push_back(face_is_outward(m, p, f));
    }
  }
  if constexpr (dimension_v<M> == 3 && arity_v<M> == 0)
    for (const auto f : faces(m)) all.push_back(raw(adj_f2v(m, f)));
  return all;
}

template<class M>
M ugly(unsigned n) {
  auto a = jittered(grid_arrays<M>(n), 0.1 / n, dimension_v<M> == 3);
  const double numbers[] = {0.1, -0.0, 1e-300, 123456789.123456789, 5e-324, 1.7976931348623157e308, 1.0 / 3};
  if (dimension_v<M> == 2)
    for (std::size_t i = 0; i < std::size(numbers) && i < a.points.size(); ++i) a.points[i].z = numbers[i];
  return M(std::move(a));
}

template<class M>
std::string as_text(const M& m, format_id f) {
  return save_text(m, f);
}

}  // namespace

template<>
struct concino::mesh_traits<with_holes> : concino::mesh_traits<trimesh> {
  template<class R>
  static auto from_1(const R& r) {
    std::vector<typename R::value_type> some;
    for (const auto x : r)
      if (x.raw() > 0) some.push_back(x);
    return some;
  }
  using base = mesh_traits<trimesh>;
  using H = with_holes;
  static auto verts(const H& h) { return from_1(base::verts(h.m)); }
  static auto polys(const H& h) { return from_1(base::polys(h.m)); }
  static auto edges(const H& h) { return base::edges(h.m); }
  static std::size_t num_verts(const H& h) { return base::num_verts(h.m) - 1; }
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
  static auto adj_p2p(const H& h, poly_id p) { return base::adj_p2p(h.m, p); }
  static auto adj_v2v(const H& h, vert_id v) { return base::adj_v2v(h.m, v); }
  static auto adj_v2e(const H& h, vert_id v) { return base::adj_v2e(h.m, v); }
  static auto adj_v2p(const H& h, vert_id v) { return base::adj_v2p(h.m, v); }
  static auto adj_e2v(const H& h, edge_id e) { return base::adj_e2v(h.m, e); }
  static auto adj_e2p(const H& h, edge_id e) { return base::adj_e2p(h.m, e); }
  static vec3 point(const H& h, vert_id v) { return base::point(h.m, v); }
};

TEST_CASE_TEMPLATE("save: loading gives the same mesh to the last bit", M, CONCINO_ALL_KINDS) {
  const temporary_folder dir;
  for (const M& m : {ugly<M>(1), ugly<M>(4), two_grids<M>(2), M()}) {
    const std::string path = dir / (dimension_v<M> == 2 ? "a.obj" : "a.hedra");
    save(m, path);
    const M again = load<M>(path);
    CHECK(same_points(m, again));
    if constexpr (dimension_v<M> == 2 || arity_v<M> == 0) {
      CHECK(said(m) == said(again));
    } else {
      // tets and hexes are restored from their faces: with the same verts, in another order
      REQUIRE(num_polys(m) == num_polys(again));
      for (const auto p : polys(m)) {
        auto a = raw(adj_p2v(m, p)), b = raw(adj_p2v(again, p));
        CHECK(std::is_permutation(a.begin(), a.end(), b.begin(), b.end()));
      }
    }
    CHECK(num_polys(m) == num_polys(again));
    CHECK(num_edges(m) == num_edges(again));
    CHECK(dir.num_files() == 1);
    if constexpr (dimension_v<M> == 2) {
      const M from_off = load_text<M>(save_text(m, file_format::off), file_format::off);
      CHECK(same_points(m, from_off));
      CHECK(said(m) == said(from_off));
    }
  }
}

TEST_CASE_TEMPLATE("save: .mesh stores tris, quads, tets and hexes in order", M, trimesh, quadmesh, tetmesh, hexmesh) {
  for (const M& m : {ugly<M>(1), ugly<M>(3), two_grids<M>(2), M()}) {
    const M again = load_text<M>(save_text(m, file_format::medit), file_format::medit);
    CHECK(same_points(m, again));
    CHECK(said(m) == said(again));
  }
}

TEST_CASE("save: .mesh stores polyhedra that are standard cells") {
  const std::string text =
      "MeshVersionFormatted 2\nDimension 3\nVertices 11\n0 0 0 1  1 0 0 0  1 1 0 0  0 1 0 0\n0 0 1 0  1 0 1 0  1 1 1 0  0 1 1 0  0.5 0.5 2 "
      "0  2 0 0 0  2 0 1 0\n"
      "Pyramids 1\n5 6 7 8 9 1\nHexahedra 1\n1 2 3 4 5 6 7 8 2\nPrisms 1\n2 10 3 6 11 7 3\nTetrahedra 1\n6 11 7 9 4\nEnd";
  const auto m = load_text<polyhedralmesh>(text, file_format::medit);
  save_report r;
  const std::string written = save_text(m, file_format::medit, {.report = &r});
  CHECK(r.notes.size() == 1);
  CHECK(r.lost.empty());
  load_report read;
  const auto again = load_text<polyhedralmesh>(written, file_format::medit, {.report = &read});
  CHECK(read.reoriented_polys == 0);
  CHECK(num_polys(again) == 4);
  CHECK(num_faces(again) == num_faces(m));
  const auto labels = find_poly_property<int>(again, "label");
  REQUIRE(bool(labels));
  const int expected[] = {4, 2, 3, 1};
  const std::size_t sizes[] = {4, 6, 5, 5};
  for (unsigned p = 0; p < 4; ++p) {
    CHECK(labels[poly_id{p}] == expected[p]);
    CHECK(raw(adj_p2f(again, poly_id{p})).size() == sizes[p]);
  }
  CHECK(find_vert_property<int>(again, "label")[vert_id{0}] == 1);
}

TEST_CASE("save: the error names the first poly that does not fit, and other formats") {
  const temporary_folder dir;
  const auto refuses = [&](const auto& m, const std::string& file, const std::string& what) {
    write_file(dir / file, "old");
    CHECK_THROWS_WITH_AS(save(m, dir / file), ((dir / file) + what).c_str(), unsupported);
    CHECK(read_file(dir / file) == "old");
    CHECK(dir.num_files() == 1);
    std::filesystem::remove(dir / file);
  };
  refuses(grid<tetmesh>(1), "a.obj", ": .obj cannot hold volumes, unless options.as_boundary is set; save it as .mesh or .hedra");
  refuses(grid<trimesh>(1), "a.hedra", ": .hedra cannot hold surfaces; save it as .obj, or .mesh if it has triangles and quads only");
  refuses(polygonmesh(with_offsets(polygon_grid(1))), "a.mesh", ": .mesh cannot hold poly 0, a polygon of 8 verts; save it as .obj");
  refuses(grid<polyhedralmesh>(1), "a.mesh",
          ": .mesh cannot hold poly 0, a polyhedron of 10 faces that is not a tet, hex, prism or pyramid; save it as .hedra");
  CHECK_THROWS_AS(save(grid<trimesh>(1), dir / "a.3ds"), unsupported);
  CHECK_THROWS_AS(save_text(grid<trimesh>(1), file_format::by_extension), invalid_argument);
}

TEST_CASE("save: throws if a coordinate is not finite") {
  auto m = grid<trimesh>(1);
  for (const double x : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    auto points = user_mesh::surface_example();
    points.points[3][1] = x;
    for (const format_id f : std::initializer_list<format_id>{file_format::obj, file_format::off, file_format::medit})
      CHECK_THROWS_WITH_AS(save_text(points, f), "text: vert 3 has a coordinate that is not a finite number; no file can hold it",
                           invalid_mesh);
  }
}

TEST_CASE("save: works on users' meshes") {
  const auto s = load_text<polygonmesh>(save_text(user_mesh::surface_example(), file_format::obj), file_format::obj);
  CHECK(said(s) == std::vector<std::vector<unsigned>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5, 6}});
  CHECK(num_verts(s) == 8);
  const auto v = load_text<polyhedralmesh>(save_text(user_mesh::volume_example(), file_format::hedra), file_format::hedra);
  CHECK(num_polys(v) == 2);
  CHECK(num_faces(v) == 10);
  CHECK(num_verts(v) == 10);
  load_report r;
  const auto cells = load_text<polyhedralmesh>(save_text(user_mesh::volume_example(), file_format::medit), file_format::medit, {.report = &r});
  CHECK(num_faces(cells) == 10);
  CHECK(r.reoriented_polys == 0);
}

TEST_CASE("save: the file has no gaps for deleted elements") {
  static_assert(SurfaceMesh<with_holes> && Embedded<with_holes>);
  with_holes h{trimesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {1, 2, 3}})};
  for (const format_id f : std::initializer_list<format_id>{file_format::obj, file_format::off, file_format::medit}) {
    const auto m = load_text<trimesh>(save_text(h, f), f);
    CHECK(num_verts(m) == 3);
    CHECK(said(m) == std::vector<std::vector<unsigned>>{{0, 1, 2}});
    CHECK(point(m, vert_id{0}) == vec3{1, 0, 0});
  }
}

TEST_CASE("save: names that become equal in a file are written once") {
  auto m = grid<quadmesh>(2);
  const auto group = poly_property<std::string>(m, "group");
  const char* const names[] = {"a\x1f_b", "a__b", "a__b", "c"};
  for (const auto p : polys(m)) group[p] = names[p.raw()];
  save_report r;
  const std::string text = save_text(m, file_format::obj, {.report = &r});
  CHECK(r.lost.size() == 1);
  CHECK(text.find("g a__b\nf") != text.npos);
  CHECK(text.find("g a__b\n", text.find("g a__b\n") + 1) == text.npos);
  CHECK(save_text(load_text<quadmesh>(text, file_format::obj), file_format::obj) == text);
}

TEST_CASE("save: a group whose name has to be changed does not become a label in .obj") {
  for (const std::string text : {"v 0 0 0\nv 1 0 0\nv 0 1 0\ng label\t1\nf 1 2 3\n", "v 0 0 0\nv 1 0 0\nv 0 1 0\no x\ng label\t1\nf 1 2 3\n",
                                 "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 3 2 1\ng label\t1\nf 1 2 3\n"}) {
    CAPTURE(text);
    const std::string first = save_text(load_text<trimesh>(text, file_format::obj), file_format::obj);
    const auto again = load_text<trimesh>(first, file_format::obj);
    CHECK(find_poly_property<std::string>(again, "group"));
    CHECK(save_text(again, file_format::obj) == first);
  }
}

TEST_CASE("save: labels that number the objects of an .obj file once their names have become equal are written once") {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const auto m = load_text<trimesh>(points + "g label_1\no a\x02" "b\nf 1 2 3\no a\tb\nf 3 2 1\n", file_format::obj);
  const std::string first = save_text(m, file_format::obj);
  CHECK(first.find("\ng ") == first.npos);  // the reader numbers the objects
  CHECK(save_text(load_text<trimesh>(first, file_format::obj), file_format::obj) == first);
}

TEST_CASE("save: stores labels, and reports properties that the format cannot store") {
  auto m = grid<quadmesh>(2);
  vert_property<int>(m, "label")[vert_id{4}] = -9;
  poly_property<int>(m, "label")[poly_id{1}] = 12;
  vert_property<double>(m, "heat");
  edge_property<int>(m, "sharpness");
  save_report r;
  const auto again = load_text<quadmesh>(save_text(m, file_format::medit, {.report = &r}), file_format::medit);
  CHECK(find_vert_property<int>(again, "label")[vert_id{4}] == -9);
  CHECK(find_poly_property<int>(again, "label")[poly_id{1}] == 12);
  CHECK(r.lost == std::vector<std::string>{"vert property \"heat\": .mesh cannot store it",
                                           "edge property \"sharpness\": .mesh cannot store it"});
  save_text(m, file_format::obj, {.report = &r});
  CHECK(r.lost.size() == 3);
  auto odd = grid<quadmesh>(1);
  poly_property<double>(odd, "label");
  save_text(odd, file_format::medit, {.report = &r});
  CHECK(r.lost.size() == 1);
}

TEST_CASE_TEMPLATE("save: a submesh keeps the labels of its elements", M, trimesh, hexmesh) {
  M m = grid<M>(3);
  const auto of_verts = vert_property<int>(m, "label");
  const auto of_polys = poly_property<int>(m, "label");
  vert_property<double>(m, "heat");
  for (const auto v : verts(m)) of_verts[v] = 100 + static_cast<int>(v.raw());
  for (const auto p : polys(m)) of_polys[p] = 100 + static_cast<int>(p.raw());
  const auto part = submesh(m, [](const poly_id p) { return p.raw() % 4 > 1; });
  save_report report;
  const std::string text = save_text(part, file_format::medit, {.report = &report});
  CHECK(report.lost == std::vector<std::string>{"vert property \"heat\": .mesh cannot store it"});
  const M again = load_text<M>(text, file_format::medit);
  std::size_t n = 0;
  for (const auto v : verts(part)) CHECK(find_vert_property<int>(again, "label")[vert_id{n++}] == of_verts[v]);
  CHECK(n == num_verts(again));
  n = 0;
  for (const auto p : polys(part)) CHECK(find_poly_property<int>(again, "label")[poly_id{n++}] == of_polys[p]);
  CHECK(n == num_polys(again));
}

TEST_CASE("save: after any error the target is unchanged and no other file is left") {
  const temporary_folder dir;
  const auto m = grid<trimesh>(60);
  write_file(dir / "a.obj", "old");
  const auto stop = [](double f, const char* label) {
    CHECK(std::string(label) == "writing");
    return f < 0.5;
  };
  CHECK_THROWS_AS(save(m, dir / "a.obj", {.progress = stop}), cancelled);
  CHECK(read_file(dir / "a.obj") == "old");
  CHECK(dir.num_files() == 1);

  // a full disk, simulated by a limit of 16 KiB for files
  struct ::rlimit was {};
  ::getrlimit(RLIMIT_FSIZE, &was);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const struct ::rlimit little { 16384, was.rlim_max };
  ::setrlimit(RLIMIT_FSIZE, &little);
  std::string said;
  try {
    save(m, dir / "a.obj");
  } catch (const io_error& e) {
    said = e.what();
  }
  ::setrlimit(RLIMIT_FSIZE, &was);
  std::signal(SIGXFSZ, handler);
  CHECK(said == (dir / "a.obj") + ": cannot be written: File too large");
  CHECK(read_file(dir / "a.obj") == "old");
  CHECK(dir.num_files() == 1);

  CHECK_THROWS_WITH_AS(save(m, dir / "none/a.obj"), ((dir / "none/a.obj") + ": cannot be written: No such file or directory").c_str(),
                       io_error);
  std::filesystem::create_directory(dir / "d.obj");
  CHECK_THROWS_AS(save(m, dir / "d.obj"), io_error);
  REQUIRE(::mkfifo((dir / "pipe").c_str(), 0600) == 0);  // not a device, as a failing test would destroy those of the machine
  CHECK_THROWS_AS(save(m, dir / "pipe", {.format = file_format::obj}), io_error);
  CHECK(dir.num_files() == 3);
}

TEST_CASE("save: keeps the permissions of the old file, and symbolic links") {
  const temporary_folder dir;
  const auto m = grid<trimesh>(1);
  write_file(dir / "a.obj", "old");
  namespace fs = std::filesystem;
  fs::permissions(dir / "a.obj", fs::perms(0640));
  fs::create_symlink("a.obj", dir / "link.obj");
  save(m, dir / "link.obj");
  CHECK(fs::is_symlink(dir / "link.obj"));
  CHECK(num_polys(load<trimesh>(dir / "a.obj")) == 2);
  CHECK(fs::status(dir / "a.obj").permissions() == fs::perms(0640));
  CHECK(dir.num_files() == 2);
}

TEST_CASE("save: numbers do not depend on the locale and are as short as possible") {
  const char* const set = std::setlocale(LC_ALL, "de_DE.UTF-8");
  const trimesh t({{0.1, -2, 1e-7}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  CHECK(save_text(t, file_format::obj) == "# 3 verts, 1 polys\nv 0.1 -2 1e-07\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  if (set) std::setlocale(LC_ALL, "C");
}

TEST_CASE("save: files may be larger than the buffer") {
  const temporary_folder dir;
  const auto m = grid<quadmesh>(200);
  std::vector<double> told;
  const auto hear = [&](double f, const char*) {
    told.push_back(f);
    return true;
  };
  save(m, dir / "a.obj", {.progress = hear});
  CHECK(told.back() == 1);
  CHECK(std::is_sorted(told.begin(), told.end()));
  CHECK(read_file(dir / "a.obj") == save_text(m, file_format::obj));
  CHECK(said(load<quadmesh>(dir / "a.obj")) == said(m));
}
