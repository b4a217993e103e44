// A second opinion on the files of TetGen: TetGen reads ours, and we read those of TetGen.
#include <concino/adapters/tetgen.hpp>

#include <concino/io/load.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/tetmesh.hpp>

#include <support/corpus.hpp>
#include <support/reading.hpp>
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

std::vector<int> sorted_list(const int* v, int n) {
  std::vector<int> all(v, v + n);
  std::sort(all.begin(), all.end());
  return all;
}
template<class Range>
std::vector<int> sorted(const Range& r, int first) {
  std::vector<int> all;
  for (const auto v : r) all.push_back(static_cast<int>(v.raw()) + first);
  std::sort(all.begin(), all.end());
  return all;
}

/// The markers of faces or edges other than 0, by their sorted verts.
using markers = std::map<std::vector<int>, int>;
markers markers_of(const int* verts, const int* marker, int n, int size) {
  markers all;
  for (int i = 0; i < n; ++i)
    if (marker && marker[i] != 0) all[sorted_list(verts + size * i, size)] = marker[i];
  return all;
}

/// `digits`: how far the coordinates may be apart. TetGen writes 16 digits, which are not always enough.
void check_same(const tetmesh& m, tetgenio& t, double digits = 0) {
  const int first = t.firstnumber;
  REQUIRE(static_cast<std::size_t>(t.numberofpoints) == num_verts(m));
  REQUIRE(static_cast<std::size_t>(t.numberoftetrahedra) == num_polys(m));
  std::size_t wrong = 0;
  for (const auto v : verts(m)) wrong += !(norm(vec3{t.pointlist[3 * v.raw()], t.pointlist[3 * v.raw() + 1], t.pointlist[3 * v.raw() + 2]} - point(m, v)) <= digits);
  for (const auto p : polys(m)) wrong += sorted_list(t.tetrahedronlist + 4 * p.raw(), 4) != sorted(adj_p2v(m, p), first);
  const auto of_verts = find_vert_property<int>(m, "label");
  const auto of_polys = find_poly_property<int>(m, "label");
  for (const auto v : verts(m)) wrong += (of_verts ? of_verts[v] : 0) != (t.pointmarkerlist ? t.pointmarkerlist[v.raw()] : 0);
  for (const auto p : polys(m)) wrong += of_polys && t.tetrahedronattributelist[p.raw() * static_cast<unsigned>(t.numberoftetrahedronattributes)] != of_polys[p];
  CHECK(wrong == 0);
  markers here;
  if (const auto label = find_face_property<int>(m, "label"))
    for (const auto f : faces(m))
      if (label[f] != 0) here[sorted(adj_f2v(m, f), first)] = label[f];
  CHECK((here == markers_of(t.trifacelist, t.trifacemarkerlist, t.numberoftrifaces, 3)));
  here.clear();
  if (const auto label = find_edge_property<int>(m, "label"))
    for (const auto e : edges(m))
      if (label[e] != 0) here[sorted(adj_e2v(m, e), first)] = label[e];
  CHECK((here == markers_of(t.edgelist, t.edgemarkerlist, t.numberofedges, 2)));
}

const std::string box_file = "8 3 0 1\n1 0 0 0 1\n2 2 0 0 2\n3 2 1 0 3\n4 0 1 0 4\n5 0 0 1 5\n6 2 0 1 6\n7 2 1 1 7\n8 0 1 1 8\n"
                        "6 1\n4 1 2 3 4 -1\n4 5 6 7 8 -2\n4 1 2 6 5 3\n4 2 3 7 6 4\n4 3 4 8 7 5\n4 4 1 5 8 6\n0\n1\n1 .5 .5 .5 7 0\n";

}  // namespace

TEST_CASE("tetgen files: TetGen reads our tets with all markers, and we read those of TetGen") {
  const temporary_folder dir;
  write_file(dir / "box.smesh", box_file);
  tetgenio plc, mesh;
  std::string path = dir / "box";
  REQUIRE(plc.load_plc(path.data(), static_cast<int>(tetgenbehavior::POLY)));
  std::string switches = "pq1.4Aa0.02eQ";
  ::tetrahedralize(switches.data(), &plc, &mesh);
  REQUIRE(mesh.numberoftetrahedra > 20);

  std::string theirs = dir / "theirs";
  mesh.save_nodes(theirs.data());
  mesh.save_elements(theirs.data());
  mesh.save_faces(theirs.data());
  mesh.save_edges(theirs.data());
  load_report r;
  const auto m = load<tetmesh>(theirs + ".ele", {.report = &r});
  CHECK(r.skipped.empty());
  MESSAGE(r.reoriented_polys << " of " << num_polys(m) << " tets of TetGen were put into the standard order");
  check_same(m, mesh, 1e-15);
  CHECK(find_poly_property<int>(m, "label")[poly_id{0}] == 7);

  std::string ours = dir / "ours";
  save(m, ours + ".node");
  tetgenio back;
  REQUIRE(back.load_tetmesh(ours.data(), static_cast<int>(tetgenbehavior::NODES)));
  check_same(m, back);
  CHECK((record_of(load<tetmesh>(ours + ".ele")) == record_of(m)));
}

TEST_CASE("tetgen files: TetGen reads our .smesh and .poly as we wrote them") {
  const auto m = load_text<polygonmesh>(box_file, file_format::smesh);
  for (const std::string extension : {".smesh", ".poly"}) {
    const temporary_folder dir;
    save(m, dir / ("m" + extension));
    std::string path = dir / "m";
    tetgenio t;
    REQUIRE(t.load_plc(path.data(), static_cast<int>(tetgenbehavior::POLY)));
    REQUIRE(static_cast<std::size_t>(t.numberofpoints) == num_verts(m));
    REQUIRE(static_cast<std::size_t>(t.numberoffacets) == num_polys(m));
    CHECK(t.numberofholes == 0);
    CHECK(t.numberofregions == 0);
    for (const auto v : verts(m)) CHECK(t.pointmarkerlist[v.raw()] == find_vert_property<int>(m, "label")[v]);
    for (const auto p : polys(m)) {
      const tetgenio::facet& f = t.facetlist[p.raw()];
      REQUIRE(f.numberofpolygons == 1);
      std::vector<unsigned> corners;
      for (int k = 0; k < f.polygonlist[0].numberofvertices; ++k) corners.push_back(static_cast<unsigned>(f.polygonlist[0].vertexlist[k] - t.firstnumber));
      CHECK(corners == raw(adj_p2v(m, p)));
      CHECK(t.facetmarkerlist[p.raw()] == find_poly_property<int>(m, "label")[p]);
    }
  }
}

TEST_CASE("tetgen files: TetGen reads a mesh of the corpus as we do") {
  CONCINO_CORPUS_OR_SKIP(path, "tet/tet_in_box.ele");
  const std::string file = path;
  std::string base = file.substr(0, file.size() - 4);
  tetgenio t;
  REQUIRE(t.load_tetmesh(base.data(), static_cast<int>(tetgenbehavior::NODES)));
  check_same(load<tetmesh>(path), t);
}
