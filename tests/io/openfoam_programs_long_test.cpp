// OpenFOAM's own programs, where they are installed: checkMesh finds nothing wrong with the topology of what is saved, and what blockMesh and
// foamFormatConvert write is read. CONCINO_OPENFOAM is the folder of OpenFOAM with etc/controlDict; by default that of the Debian package.
#include <concino/io/load_any.hpp>
#include <concino/io/openfoam.hpp>
#include <concino/io/save.hpp>

#include <support/corpus.hpp>
#include <support/foam_text.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <variant>

using namespace concino;
using namespace concino::testing;
namespace fs = std::filesystem;

namespace {

std::string openfoam_folder() {
  const char* const named = std::getenv("CONCINO_OPENFOAM");
  return named && *named ? named : "/usr/share/openfoam";
}

/// Whether OpenFOAM's programs are there.
bool has_openfoam() { return fs::exists(openfoam_folder() + "/etc/controlDict") && std::system("command -v checkMesh blockMesh topoSet foamFormatConvert >/dev/null 2>&1") == 0; }

/// What a program of OpenFOAM prints in a case.
std::string output_of(const std::string& program, const std::string& folder) {
  std::FILE* const pipe = ::popen(("cd '" + folder + "' && WM_PROJECT_DIR='" + openfoam_folder() + "' " + program + " 2>&1").c_str(), "r");
  std::string all;
  char buffer[4096];
  for (std::size_t n; pipe && (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) all.append(buffer, n);
  if (pipe) ::pclose(pipe);
  return all;
}

void write_dictionary(const std::string& folder, const std::string& name, const std::string& text) {
  fs::create_directories(folder + "/system");
  write_file(folder + "/system/" + name, "FoamFile { version 2.0; format ascii; class dictionary; object " + name + "; }\n" + text);
}
void write_case(const std::string& folder, const std::string& format = "ascii") {
  write_dictionary(folder, "controlDict", "application none; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1; writeControl timeStep; writeInterval 1; writeFormat " + format +
                                              "; writePrecision 17; writeCompression off; timeFormat general; timePrecision 6;\n");
  write_dictionary(folder, "fvSchemes", "ddtSchemes { default none; } gradSchemes { default none; } divSchemes { default none; } laplacianSchemes { default none; } interpolationSchemes { default none; } "
                                        "snGradSchemes { default none; }\n");
  write_dictionary(folder, "fvSolution", "");
}

/// Whether each of the checks of topology that checkMesh makes has passed. Its checks of quality depend on the mesh.
void check_topology(const std::string& folder) {
  const std::string said = output_of("checkMesh -allTopology", folder);
  CAPTURE(said);
  for (const char* const words : {"Boundary definition OK.", "Cell to face addressing OK.", "Upper triangular ordering OK.", "Face vertices OK.", "Topological cell zip-up check OK."})
    CHECK(said.find(words) != std::string::npos);
  CHECK(said.find("FATAL") == std::string::npos);
  CHECK(said.find("End") != std::string::npos);
}

}  // namespace

TEST_CASE("openfoam: checkMesh accepts the topology of every volume of the corpus below 100,000 polys") {
  if (!has_openfoam()) return skip("OpenFOAM is not installed");
  std::size_t n = 0;
  for (const char* const kind : {"tet", "hex", "polyhedral"}) {
    if (corpus(kind).empty()) continue;
    for (const auto& entry : fs::directory_iterator(corpus(kind))) {
      const std::string path = entry.path().generic_string();
      CAPTURE(path);
      for (const bool binary : {false, true}) {
        const temporary_folder dir;
        write_case(dir.path());
        try {
          std::visit([&](const auto& m) {
            if (num_polys(m) < 100'000) save(m, dir / "constant/polyMesh", {.binary = binary});
          }, load_any(path));
        } catch (const unsupported&) {  // another format, a surface, or faces of three polys
        }
        if (!fs::exists(dir / "constant/polyMesh")) continue;
        check_topology(dir.path());
        ++n;
      }
    }
  }
  CHECK(n >= 10);
}

TEST_CASE("openfoam: what blockMesh and topoSet write is read, as text and as binary, and accepted when it is saved again") {
  if (!has_openfoam()) return skip("OpenFOAM is not installed");
  const temporary_folder dir;
  write_case(dir.path());
  write_dictionary(dir.path(), "blockMeshDict",
                   "scale 0.1; vertices ((0 0 0) (1 0 0) (1 1 0) (0 1 0) (0 0 1) (1 0 1) (1 1 1) (0 1 1)); blocks (hex (0 1 2 3 4 5 6 7) (3 2 2) simpleGrading (1 1 1)); edges ();\n"
                   "boundary (movingWall { type wall; faces ((3 7 6 2)); } ends { type patch; faces ((0 4 7 3) (2 6 5 1)); } none { type patch; faces (); });\n");
  write_dictionary(dir.path(), "topoSetDict", "actions ({ name left; type cellSet; action new; source boxToCell; box (0 0 0) (0.06 1 1); } { name left; type cellZoneSet; action new; source setToCellZone; set left; });\n");
  output_of("blockMesh", dir.path());
  output_of("topoSet", dir.path());
  load_report r;
  const auto m = load<hexmesh>(dir.path(), {.report = &r});
  CHECK(num_polys(m) == 12);
  CHECK(r.reoriented_polys == 0);
  const label_names* const names = &*find_mesh_property<label_names>(m, "label_names");
  REQUIRE(names->names.size() == 5);
  CHECK(names->names[0] == label_name{element_kind::face, 1, "movingWall", {"type wall;", "inGroups 1(wall);"}});
  CHECK(names->find(element_kind::poly, "left")->label == 1);
  CHECK(names->find(element_kind::face, "defaultFaces")->label == 4);
  std::size_t left = 0;
  for (const poly_id p : polys(m)) left += find_poly_property<int>(m, "label")[p] == 1;
  CHECK(left == 8);
  const auto text = load<polyhedralmesh>(dir.path());
  write_case(dir.path(), "binary");
  output_of("foamFormatConvert", dir.path());
  CHECK(read_file(dir / "constant/polyMesh/faces").find("faceCompactList") != std::string::npos);
  // foamFormatConvert writes the entries of dictionaries with other blanks
  const auto numbers_of = [](const polyhedralmesh& mesh) {
    const std::string all = save_text(mesh, foam_text_format{});
    return all.substr(0, all.find("@@boundary")) + all.substr(all.find("@@cellZones"));
  };
  CHECK(numbers_of(load<polyhedralmesh>(dir.path())) == numbers_of(text));
  // the order of blockMesh is the one that is written
  const std::string listed = read_file(dir / "constant/polyMesh/faces"), owner = read_file(dir / "constant/polyMesh/owner");
  save_openfoam(text, dir.path(), {.binary = true});
  const auto list_of = [](const std::string& file) { return file.substr(file.find("\n("), file.rfind(')') - file.find("\n(")); };
  CHECK(list_of(read_file(dir / "constant/polyMesh/faces")) == list_of(listed));
  CHECK(list_of(read_file(dir / "constant/polyMesh/owner")) == list_of(owner));
  check_topology(dir.path());
}
