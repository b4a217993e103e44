// Measures the readers of all formats of meshes alone: from a text in memory to flat arrays, in megabytes of text per second.
#include "support/parse.hpp"

#include <concino/io.hpp>
#include <concino/mesh.hpp>

#include <string>
#include <utility>

namespace {

/// Measures one format on one mesh, which is read again as Arrays.
template<class Arrays>
struct reader_rows {
  const bench::program& p;
  std::string mesh;

  template<class M, class Format>
  void operator()(const M& m, Format format, bool binary = false) const {
    const std::string name = std::string(Format::name) + (binary ? "-binary." : ".") + mesh;
    if (!p.wants("parse." + name)) return;
    of_text(concino::save_text(m, format, {.binary = binary}), concino::num_polys(m), format, name, binary);
  }

  template<class Format>
  void of_text(const std::string& text, std::size_t polys, Format format, const std::string& name, bool binary = false) const {
    const std::string work = "parse." + name;
    if (!p.wants(work)) return;
    const auto read = [&] { return concino::load_text<Arrays>(text, format); };
    if (read().num_polys() != polys) throw std::runtime_error(work + ": the text holds another number of polys");
    bench::measure_parse(p, name, text, binary, read);
  }
};

/// The text of an Open Inventor file, which the library does not write.
std::string inventor_text(const concino::trimesh& m) {
  concino::text_sink out;
  out << "#Inventor V2.1 ascii\nSeparator {\n  Coordinate3 {\n    point [\n";
  for (const concino::vec3& x : m.points()) out << x.x << ' ' << x.y << ' ' << x.z << ",\n";
  out << "    ]\n  }\n  IndexedFaceSet {\n    coordIndex [\n";
  for (const concino::poly_id t : concino::polys(m)) {
    for (const concino::vert_id v : concino::adj_p2v(m, t)) out << v.raw() << ", ";
    out << "-1,\n";
  }
  out << "    ]\n  }\n}\n";
  return std::move(out).release();
}

/// The mesh with a texture coordinate and a normal at each corner, those of its vert.
concino::trimesh with_corner_values(concino::trimesh m) {
  auto texture = concino::corner_property<std::array<double, 2>>(m, "texture");
  auto normal = concino::corner_property<concino::vec3>(m, "normal");
  for (const concino::poly_id t : concino::polys(m)) {
    std::uint32_t k = 0;
    for (const concino::vert_id v : concino::adj_p2v(m, t)) {
      const concino::vec3 x = concino::point(m, v);
      texture[{t, k}] = {x.x, x.y};
      normal[{t, k++}] = concino::vec3{x.z, x.x, 1} / concino::norm(concino::vec3{x.z, x.x, 1});
    }
  }
  return m;
}

void measure_surface(const bench::program& p) {
  using namespace concino;
  const reader_rows<surface_arrays> read{p, "tri1m"};
  const trimesh m(p.data.tri1m());
  read(m, file_format::obj);
  read(m, file_format::off);
  read(m, file_format::off, true);
  if (p.wants("parse.obj.tri1m_corners")) read.of_text(save_text(with_corner_values(m), file_format::obj), num_polys(m), file_format::obj, "obj.tri1m_corners");
  if (p.wants("parse.iv.tri1m")) read.of_text(inventor_text(m), num_polys(m), file_format::iv, "iv.tri1m");
  read(m, file_format::medit);
  read(m, file_format::medit, true);
  read(m, file_format::vtk);
  read(m, file_format::vtk, true);
  read(m, file_format::vtu);
  read(m, file_format::vtu, true);
}

void measure_tets(const bench::program& p) {
  using namespace concino;
  const reader_rows<cell_arrays> read{p, "tet1m"};
  const tetmesh m(p.data.tet1m());
  read(m, file_format::medit);
  read(m, file_format::medit, true);
  read(m, file_format::tet);
  read(m, file_format::vtk);
  read(m, file_format::vtk, true);
  read(m, file_format::vtu);
  read(m, file_format::vtu, true);
}

void measure_polyhedra(const bench::program& p) {
  using namespace concino;
  const reader_rows<polyhedra_arrays> read{p, "dual200k"};
  const polyhedralmesh m(p.data.dual200k());
  read(m, file_format::hedra);
  read(m, file_format::hybrid);
  read(m, file_format::vtk);
  read(m, file_format::vtk, true);
  read(m, file_format::vtu);
  read(m, file_format::vtu, true);
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    measure_surface(p);
    measure_tets(p);
    measure_polyhedra(p);
  });
}
