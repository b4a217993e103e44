// A harmonic map on a grid of hexes that MPI's processes make and solve together: time, memory, messages and iterations, as one row of a table.
// mpirun -n 2 scale_processes --cells 64 --weak: 64 cells along each axis, of the block of each process, or of the grid without --weak.
#include <concino/adapters/distributed_generate.hpp>
#include <concino/adapters/distributed_harmonic_map.hpp>
#include <concino/mesh/hexmesh.hpp>

#include <petscsys.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <sys/resource.h>

namespace cn = concino;

namespace {

/// What a process has used so far. Messages are those of PETSc; the few of the library itself are not counted.
struct usage {
  double seconds, cpu_seconds, bytes, messages, reductions;

  static usage now() {
    rusage r{};
    getrusage(RUSAGE_SELF, &r);
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    return {wall, static_cast<double>(r.ru_utime.tv_sec) + 1e-6 * static_cast<double>(r.ru_utime.tv_usec), petsc_isend_len + petsc_send_len,
            petsc_isend_ct + petsc_send_ct, petsc_allreduce_ct + petsc_gather_ct};
  }
  usage since(const usage& o) const {
    return {seconds - o.seconds, cpu_seconds - o.cpu_seconds, bytes - o.bytes, messages - o.messages, reductions - o.reductions};
  }
  /// The largest of all processes.
  usage largest() const {
    usage r = *this;
    MPI_Allreduce(MPI_IN_PLACE, &r, 5, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    return r;
  }
  /// What one of n + 1 iterations has used, if o has done one.
  usage per_iteration(const usage& o, int n) const {
    const double k = n;
    return {(seconds - o.seconds) / k, (cpu_seconds - o.cpu_seconds) / k, (bytes - o.bytes) / k, (messages - o.messages) / k, (reductions - o.reductions) / k};
  }
};

/// The most memory that a process has had, in MB.
double peak_memory() {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word && word != "VmHWM:") {
  }
  double kilobytes = 0;
  status >> kilobytes;
  MPI_Allreduce(MPI_IN_PLACE, &kilobytes, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return kilobytes / 1024;
}

void measure(std::size_t cells, bool is_weak) {
  int processes = 1, rank = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &processes);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  std::array<std::size_t, 3> size = {cells, cells, cells};
  if (is_weak)
    for (std::size_t left = static_cast<std::size_t>(processes), axis = 0; left > 1; axis = (axis + 1) % 3) {
      const std::size_t factor = left % 2 == 0 ? 2 : left;
      size[axis] *= factor;
      left /= factor;
    }
  const usage start = usage::now();
  cn::vec3 max;  // cells are cubes
  for (const std::size_t k : {0u, 1u, 2u}) max[k] = static_cast<double>(size[k]) / static_cast<double>(cells);
  const auto m = cn::make_distributed_grid<cn::hexmesh>(MPI_COMM_WORLD, {.cells = size, .max = max});
  const double mesh_seconds = usage::now().since(start).largest().seconds;
  std::vector<std::pair<cn::vert_id, double>> values;
  for (const cn::vert_id v : cn::verts(m)) {
    const cn::vec3 p = cn::point(m, v);
    bool is_boundary = false;
    for (const std::size_t k : {0u, 1u, 2u}) is_boundary = is_boundary || p[k] == 0 || p[k] == max[k];
    if (is_boundary) values.emplace_back(v, std::cos(3 * p.x) + p.y * p.y - p.z);
  }
  int iterations = 0;
  double residual = 0, memory = 0;
  const auto solve = [&](int max_iterations) {
    cn::petsc solver({.tolerance = 1e-10, .max_iterations = max_iterations, .accept_missed_tolerance = max_iterations > 0});
    MPI_Barrier(MPI_COMM_WORLD);
    const usage before = usage::now();
    cn::harmonic_map(m, values, {}, solver);
    iterations = solver.iterations();
    residual = solver.residual();
    return usage::now().since(before);
  };
  const usage all = solve(0);
  const int all_iterations = iterations;
  const double all_residual = residual;
  memory = peak_memory();
  const usage one = solve(1), each = all.per_iteration(one, all_iterations - 1).largest(), setup = one.since(each).largest();
  if (rank > 0) return;
  std::printf("| %s | %d | %llu | %d | %.1e | %.0f | %.2f | %.2f | %.2f | %.4f | %.4f | %.1f | %.0f | %.1f |\n", is_weak ? "weak" : "strong", processes,
              static_cast<unsigned long long>(m.num_global_polys()), all_iterations, all_residual, memory, mesh_seconds, setup.seconds, setup.cpu_seconds, each.seconds,
              each.cpu_seconds, each.bytes / 1024, each.messages, each.reductions);
}

}  // namespace

int main(int argc, char** argv) {
  cn::petsc_session session(argc, argv);
  std::size_t cells = 64;
  bool is_weak = false, has_head = false;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--tiny") == 0) cells = 6;
    if (std::strcmp(argv[i], "--weak") == 0) is_weak = true;
    if (std::strcmp(argv[i], "--head") == 0) has_head = true;
    if (std::strcmp(argv[i], "--cells") == 0 && i + 1 < argc) cells = static_cast<std::size_t>(std::atoi(argv[++i]));
  }
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (has_head && rank == 0)
    std::printf("| scaling | processes | hexes | iterations | residual | peak memory, MB | mesh, s | setup, s | setup, CPU s | iteration, s | iteration, CPU s | sent, "
                "kB | messages | reductions |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  try {
    measure(cells, is_weak);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s: %s\n", argv[0], e.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
}
