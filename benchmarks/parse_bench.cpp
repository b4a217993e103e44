// Measures the readers of all formats alone: from a text in memory to flat arrays, in megabytes of text per second. The floor of a text is
// std::from_chars on each of its words, that of a binary file is a copy.
#include "support/program.hpp"

#include <concino/io.hpp>
#include <concino/mesh.hpp>

#include <charconv>
#include <string_view>

namespace {

/// Words that are no numbers are skipped, as is the rest of a word after its first number.
double sum_of_numbers(std::string_view text) {
  double sum = 0;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at < end) {
    while (at < end && static_cast<unsigned char>(*at) <= ' ') ++at;
    double x = 0;
    if (at < end) at = std::from_chars(at, end, x).ptr;
    sum += x;
    while (at < end && static_cast<unsigned char>(*at) > ' ') ++at;
  }
  return sum;
}

/// Measures one format on one mesh, which is read again as Arrays.
template<class Arrays>
struct reader_rows {
  const bench::program& p;
  std::string mesh;

  template<class M, class Format>
  void operator()(const M& m, Format format, bool binary = false) const {
    const std::string name = std::string(Format::name) + (binary ? "-binary." : ".") + mesh, work = "parse." + name;
    if (!p.wants(work)) return;
    const std::string text = concino::save_text(m, format, {.binary = binary});
    const auto read = [&] { return concino::load_text<Arrays>(text, format); };
    if (read().num_polys() != concino::num_polys(m)) throw std::runtime_error(work + ": the text holds another number of polys");
    const auto floor = [&] { return binary ? bench::seconds_of([&] { return text; }) : bench::seconds_of([&] { return sum_of_numbers(text); }); };
    const auto rows = bench::compare(work, p.rounds, {{"floor", floor}, {"concino", [&] { return bench::seconds_of(read); }}});
    p.print(rows);
    for (const bench::row& r : rows)
      if (r.contender == "concino") p.print({{"parse_speed." + name, "concino", "MB/s", static_cast<double>(text.size()) / 1e6 / r.value, 1}});
  }
};

void measure_surface(const bench::program& p) {
  using namespace concino;
  const reader_rows<surface_arrays> read{p, "tri1m"};
  const trimesh m(p.data.tri1m());
  read(m, file_format::obj);
  read(m, file_format::off);
  read(m, file_format::off, true);
  read(m, file_format::medit);
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
