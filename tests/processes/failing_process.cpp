// One process fails while the others wait for it: by an exception that nobody catches, by one that main catches, for want of memory, or killed.
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/petsc_session.hpp>
#include <concino/mesh/trimesh.hpp>

#include <csignal>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace cn = concino;

namespace {

void run(int argc, char** argv, const std::string& how) {
  cn::petsc_session session(argc, argv);
  int size = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  const cn::trimesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  auto part = cn::make_poly_map<int>(m, 0);
  part[cn::poly_id{1}] = size - 1;
  const cn::distributed<cn::trimesh> d(MPI_COMM_WORLD, m, part);
  if (d.rank() == size - 1) {
    if (how == "killed") std::raise(SIGKILL);
    if (how == "memory") std::vector<double>(std::size_t{1} << 58);
    throw cn::io_error("the disk of the last process is full");
  }
  auto u = cn::make_vert_map<double>(d);
  for (;;) cn::exchange_ghosts(u);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string how = argv[1];
  if (how != "caught") run(argc, argv, how);
  try {
    run(argc, argv, how);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "caught: %s\n", e.what());
    return 1;
  }
}
