// Exchanges files with VTK, which compare.py runs:  exchange FOLDER FILE...
// Reads each file, prints "file NAME", a line "note ..." for each remark of the report, and for each poly "measure X number N": its area or volume, and its
// value of the property "number". Saves the mesh as FOLDER/NAME_text.vtk, ..._binary.vtk, and the same as .vtu and, if it is a surface, as .vtp; also as
// .pvtu, with the even polys and the odd ones as pieces.
#include <concino/geometry/measure.hpp>
#include <concino/io.hpp>

#include <fmt/core.h>

#include <filesystem>
#include <string>
#include <variant>

namespace cn = concino;

namespace {

template<class M>
void print_mesh(const M& m, const std::string& name, const cn::load_report& report) {
  fmt::print("file {}\n", name);
  for (const std::string& note : report.notes) fmt::print("note {}\n", note);
  for (const std::string& skipped : report.skipped) fmt::print("note skipped: {}\n", skipped);
  const auto number = cn::find_poly_property<double>(m, "number");
  for (const auto p : cn::polys(m)) fmt::print("measure {} number {}\n", cn::measure(m, p), number ? number[p] : -1);
}

template<class M>
void save_mesh(const M& m, const std::string& folder, const std::string& name) {
  for (const char* extension : {".vtk", ".vtu", ".vtp"}) {
    if (cn::dimension_v<M> == 3 && std::string(extension) == ".vtp") continue;
    for (const bool binary : {false, true}) cn::save(m, folder + "/" + name + (binary ? "_binary" : "_text") + extension, {.binary = binary});
  }
  auto part = cn::make_poly_map<int>(m);
  for (const auto p : cn::polys(m)) part[p] = static_cast<int>(cn::index_of(m, p) % 2);
  for (const bool binary : {false, true}) cn::save_pvtu(m, folder + "/" + name + (binary ? "_binary" : "_text") + ".pvtu", part, {.binary = binary});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  for (int i = 2; i < argc; ++i) {
    const std::string name = std::filesystem::path(argv[i]).filename().string();
    cn::load_report report;
    const cn::any_mesh mesh = cn::load_any(argv[i], {.report = &report});
    std::visit(
        [&](const auto& m) {
          print_mesh(m, name, report);
          save_mesh(m, argv[1], name);
        },
        mesh);
  }
}
