#include <concino/adapters/lib3mf.hpp>

#include <concino/generate/boundary_surface.hpp>
#include <concino/io/load_any.hpp>
#include <concino/mesh/property.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using list = std::vector<std::string>;

/// What the reader of lib3mf finds in a file.
struct part {
  std::vector<vec3> points;
  std::vector<std::array<unsigned, 3>> triangles;
  std::vector<std::array<unsigned, 3>> colors;  // 0xRRGGBBAA of the corners of each triangle
  std::string name;
  unsigned type = 0, unit = 0, warnings = 0;

  explicit part(const std::string& file) {
    using namespace NMR;
    PLib3MFModel* model = nullptr;
    PLib3MFModelReader* reader = nullptr;
    REQUIRE(lib3mf_createmodel(&model) == LIB3MF_OK);
    REQUIRE(lib3mf_model_queryreader(model, "3mf", &reader) == LIB3MF_OK);
    std::string copy = file;
    REQUIRE(lib3mf_reader_readfrombuffer(reader, reinterpret_cast<BYTE*>(copy.data()), copy.size()) == LIB3MF_OK);
    lib3mf_reader_getwarningcount(reader, &warnings);
    lib3mf_model_getunit(model, &unit);
    PLib3MFModelBuildItemIterator* items = nullptr;
    PLib3MFModelBuildItem* item = nullptr;
    PLib3MFModelMeshObject* mesh = nullptr;
    BOOL any = 0;
    REQUIRE(lib3mf_model_getbuilditems(model, &items) == LIB3MF_OK);
    REQUIRE(lib3mf_builditemiterator_movenext(items, &any) == LIB3MF_OK);
    REQUIRE(any);
    REQUIRE(lib3mf_builditemiterator_getcurrent(items, &item) == LIB3MF_OK);
    REQUIRE(lib3mf_builditem_getobjectresource(item, &mesh) == LIB3MF_OK);
    lib3mf_object_gettype(mesh, &type);
    unsigned nv = 0, nt = 0, length = 0;
    lib3mf_meshobject_getvertexcount(mesh, &nv);
    lib3mf_meshobject_gettrianglecount(mesh, &nt);
    char text[256] = {};
    lib3mf_object_getnameutf8(mesh, text, 256, &length);
    name = text;
    for (unsigned v = 0; v < nv; ++v) {
      MODELMESHVERTEX x;
      lib3mf_meshobject_getvertex(mesh, v, &x);
      points.push_back({x.m_fPosition[0], x.m_fPosition[1], x.m_fPosition[2]});
    }
    PLib3MFPropertyHandler* properties = nullptr;
    lib3mf_meshobject_createpropertyhandler(mesh, &properties);
    for (unsigned t = 0; t < nt; ++t) {
      MODELMESHTRIANGLE x;
      lib3mf_meshobject_gettriangle(mesh, t, &x);
      triangles.push_back({x.m_nIndices[0], x.m_nIndices[1], x.m_nIndices[2]});
      eModelPropertyType kind;
      if (lib3mf_propertyhandler_getpropertytype(properties, t, &kind) != LIB3MF_OK || kind != MODELPROPERTYTYPE_COLOR) continue;
      MODELMESH_TRIANGLECOLOR_SRGB c;
      lib3mf_propertyhandler_getcolor(properties, t, &c);
      auto& of = colors.emplace_back();
      for (int k = 0; k < 3; ++k) {
        const auto& p = c.m_Colors[k];
        of[static_cast<std::size_t>(k)] = unsigned{p.m_Red} << 24 | unsigned{p.m_Green} << 16 | unsigned{p.m_Blue} << 8 | p.m_Alpha;
      }
    }
    for (PLib3MFBase* x : {static_cast<PLib3MFBase*>(properties), static_cast<PLib3MFBase*>(mesh), static_cast<PLib3MFBase*>(item), static_cast<PLib3MFBase*>(items), static_cast<PLib3MFBase*>(reader), static_cast<PLib3MFBase*>(model)})
      if (x) lib3mf_release(x);
  }
};

std::string text_of(const auto& m, save_report* r = nullptr) { return save_text(m, lib3mf_format{}, {.report = r, .as_triangles = true, .as_boundary = true}); }

const trimesh tetrahedron({{0, 0, 0}, {1, 0, 0}, {0, 2.5, 0}, {0, 0, -0.25}}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}});

}  // namespace

TEST_CASE("lib3mf: counts, coordinates, triangles, unit and type are read back") {
  save_report r;
  const temporary_folder dir;
  save_3mf(tetrahedron, dir / "a", {.report = &r, .strict = true});
  CHECK(r.lost.empty());
  const part p(read_file(dir / "a"));
  CHECK(p.points == tetrahedron.points());
  CHECK(p.triangles == std::vector<std::array<unsigned, 3>>{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}});
  CHECK(p.unit == NMR::MODELUNIT_MILLIMETER);
  CHECK(p.type == NMR::MODELOBJECTTYPE_MODEL);
  CHECK(p.warnings == 0);
  CHECK(p.colors.empty());
  save(tetrahedron, dir / "b.3mf", standard_formats + lib3mf_format{});
  CHECK(read_file(dir / "b.3mf") == read_file(dir / "a"));
  CHECK(text_of(tetrahedron) == read_file(dir / "a"));
  CHECK_THROWS_WITH_AS(load<trimesh>(dir / "b.3mf", standard_formats + lib3mf_format{}), doctest::Contains("b.3mf: .3mf can be written, but not read"), unsupported);
}

TEST_CASE("lib3mf: open and empty meshes are surfaces") {
  const part open(text_of(grid<trimesh>(2)));
  CHECK(open.type == NMR::MODELOBJECTTYPE_SURFACE);
  CHECK(open.triangles.size() == 8);
  const part none(text_of(trimesh()));
  CHECK(none.points.empty());
  CHECK(none.triangles.empty());
  CHECK(part(text_of(trimesh({{1, 2, 3}}, {}))).points == std::vector<vec3>{{1, 2, 3}});
}

TEST_CASE("lib3mf: polygons and volumes need options") {
  CHECK_THROWS_WITH_AS(save_text(grid<quadmesh>(1), lib3mf_format{}), "text: .3mf cannot hold poly 0 of 4 corners, unless options.as_triangles is set; save it as .ply or .obj", unsupported);
  CHECK_THROWS_AS(save_text(grid<tetmesh>(1), lib3mf_format{}), unsupported);
  save_report r;
  const hexmesh h = grid<hexmesh>(2);
  const part p(text_of(h, &r));
  CHECK(p.triangles.size() == 48);
  CHECK(p.points == boundary_surface(h).points());
  CHECK(p.type == NMR::MODELOBJECTTYPE_MODEL);
  CHECK(r.lost.size() == 3);
}

TEST_CASE("lib3mf: colours of verts, else of polys, and a name") {
  trimesh m = tetrahedron;
  auto of_polys = poly_property<rgba>(m, "color");
  for (const auto p : polys(m)) of_polys[p] = rgba_of_bytes(p.raw(), 2, 3, 255);
  *mesh_property<std::string>(m, "name") = "a <b> & \"c\" \xc3\xa9";
  save_report r;
  const part p(text_of(m, &r));
  CHECK(r.lost.empty());
  CHECK(p.warnings == 0);
  CHECK(p.name == "a <b> & \"c\" \xc3\xa9");
  REQUIRE(p.colors.size() == 4);
  for (unsigned t = 0; t < 4; ++t)
    for (const unsigned c : p.colors[t]) CHECK(c == (t << 24 | 0x0203FF));
  auto of_verts = vert_property<rgba>(m, "color");
  for (const auto v : verts(m)) of_verts[v] = rgba_of_bytes(10 * v.raw(), 0, 0, 9);
  of_verts[vert_id{3}] = {0.3333f, 2, -1, 1};
  *mesh_property<std::string>(m, "name") = "line\nend";
  const part q(text_of(m, &r));
  CHECK(q.name.empty());
  REQUIRE(q.colors.size() == 4);
  for (unsigned t = 0; t < 4; ++t)
    for (std::size_t k = 0; k < 3; ++k) CHECK(q.colors[t][k] == (q.triangles[t][k] == 3 ? 0x55FF00FFu : q.triangles[t][k] * 10 << 24 | 9));
  CHECK(r.lost == list{".3mf holds colours of 8 bits: parts were rounded", "poly property \"color\": .3mf cannot store it", "mesh property \"name\": .3mf cannot store it"});
}

TEST_CASE("lib3mf: coordinates are rounded with a word, or refused") {
  save_report r;
  text_of(trimesh({{0, 0, 0}, {0.1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}), &r);
  CHECK(r.lost == list{".3mf holds floats with six decimals: coordinates were rounded"});
  const part p(text_of(trimesh({{0, 0, 0}, {1e-7, 0, 0}, {0, 1e6, 0}}, {{0, 1, 2}}), &r));
  CHECK(p.points[1].x == 0);
  CHECK(p.points[2].y == doctest::Approx(1e6));
  CHECK(r.lost.size() == 1);
  const temporary_folder dir;
  CHECK_THROWS_WITH_AS(save_3mf(trimesh({{0, 0, 0}, {1e9, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}), dir / "a.3mf"),
                       ((dir / "a.3mf") + ": .3mf cannot hold a coordinate of 1e9 millimetres or more; save it as .ply or .obj").c_str(), unsupported);
  CHECK_THROWS_AS(save_3mf(trimesh({{0, 0, 0}, {std::numeric_limits<double>::infinity(), 0, 0}, {0, 1, 0}}, {{0, 1, 2}}), dir / "a.3mf"), invalid_mesh);
  CHECK_THROWS_AS(save_3mf(tetrahedron, dir / "a.3mf", {.progress = [](double, std::string_view) { return false; }}), cancelled);
  CHECK(dir.num_files() == 0);
}

TEST_CASE("lib3mf: surfaces of the corpus have the same counts and coordinates") {
  std::size_t files = 0;
  for (const char* name : {"tri/cactus.off", "quad/bamboo_pen_genus8.obj", "polygon/dodecahedron.obj", "tet/quarter_crown.mesh"}) {
    const auto file = corpus(name);
    if (file.empty()) continue;
    ++files;
    CAPTURE(name);
    std::visit(
        [&](const auto& m) {
          const part p(text_of(m));
          CHECK(p.warnings == 0);
          if constexpr (dimension_v<std::remove_cvref_t<decltype(m)>> == 2) {  // of a volume, the boundary
            REQUIRE(p.points.size() == num_verts(m));
            for (const auto v : verts(m))
              for (std::size_t k = 0; k < 3; ++k) CHECK(p.points[index_of(m, v)][k] == doctest::Approx(point(m, v)[k]).epsilon(1e-6).scale(1));
          }
        },
        load_any(file));
  }
  if (files == 0) skip("no corpus");
}
