// Saves meshes as FOLDER/NAME.vtu, and with all processes as FOLDER/NAME.pvtu, for pieces.py:  pieces FOLDER
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/distributed_files.hpp>
#include <concino/adapters/metis_partition.hpp>
#include <concino/adapters/petsc_session.hpp>
#include <concino/generate/grid.hpp>
#include <concino/io/vtu.hpp>
#include <concino/mesh.hpp>

#include <mpi.h>

#include <cstddef>
#include <string>

namespace cn = concino;

namespace {

template<class M>
void save_both(M m, const std::string& path, bool binary) {
  const auto number = cn::poly_property<double>(m, "number");
  for (const auto p : cn::polys(m)) number[p] = static_cast<double>(cn::index_of(m, p)) / 2;
  int size = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  // one process more than there are parts, so that a piece is empty
  const cn::distributed d(MPI_COMM_WORLD, m, cn::partition(m, static_cast<std::size_t>(size) - 1, cn::metis).part);
  if (d.rank() == 0) cn::save_vtu(m, path + ".vtu", {.binary = binary});
  auto of_part = cn::make_poly_map<double>(d);
  for (const auto p : cn::polys(d)) of_part[p] = static_cast<double>(d.global_number(p)) / 2;
  cn::save_pvtu(d, path + ".pvtu", {{"number", of_part}}, {.binary = binary});
}

}  // namespace

int main(int argc, char** argv) {
  cn::petsc_session session(argc, argv);
  if (argc < 2) return 2;
  const std::string folder = argv[1];
  for (const bool binary : {false, true}) {
    const std::string form = binary ? "_binary" : "_text";
    save_both(cn::make_grid<cn::trimesh>({.cells = {4, 3, 1}}), folder + "/triangles" + form, binary);
    save_both(cn::make_grid<cn::polygonmesh>({.cells = {4, 3, 1}}), folder + "/polygons" + form, binary);
    save_both(cn::make_grid<cn::tetmesh>({.cells = {3, 2, 2}}), folder + "/tets" + form, binary);
    save_both(cn::make_grid<cn::hexmesh>({.cells = {4, 3, 2}}), folder + "/hexes" + form, binary);
    save_both(cn::make_grid<cn::polyhedralmesh>({.cells = {4, 3, 2}}), folder + "/polyhedra" + form, binary);
  }
}
