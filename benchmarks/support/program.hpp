// The parts that all programs of this folder share: the command line, the output of rows, and a folder for the files that are read.
#pragma once

#include "../floor/read.hpp"
#include "data.hpp"
#include "timing.hpp"
#include "write.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>

#include <malloc.h>
#include <unistd.h>

namespace bench {

struct program {
  data_sets data;
  int rounds = 9;
  std::string only;                // part of the work's name; empty: all work
  std::FILE* out = stdout;
  std::filesystem::path folder;    // for the input files; removed at the end
  cpu_set_t cores;                 // those of the process before it was kept on one

  program(int argc, char** argv) {
    bool warm = false;
    for (int i = 1; i < argc; ++i) {
      const std::string a = argv[i];
      const auto value = [&] {
        if (i + 1 == argc) usage(argv[0]);
        return std::string(argv[++i]);
      };
      if (a == "--tiny") data.tiny = true;
      else if (a == "--rounds") rounds = std::atoi(value().c_str());
      else if (a == "--only") only = value();
      else if (a == "--out") out = std::fopen(value().c_str(), "w");
      else if (a == "--warm") warm = true;
      else if (a == "--base") data.base = arrays_from_obj(value());
      else usage(argv[0]);
    }
    if (!out || rounds < 1) usage(argv[0]);
    folder = std::filesystem::temp_directory_path() / ("concino-benchmark-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    cores = pin_to_one_core();
    // Large arrays come from the system in every run and are returned to it, as in a program that does the work once. By default malloc starts to keep
    // them, and the order of the contenders then decides which one pays for new pages. --warm leaves this default on, as in a long session.
    if (!warm) mallopt(M_MMAP_THRESHOLD, 128 * 1024);
  }
  program(const program&) = delete;
  program& operator=(const program&) = delete;
  ~program() {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
    if (out != stdout) std::fclose(out);
  }

  bool wants(const std::string& work) const { return work.find(only) != std::string::npos; }
  std::string file(const std::string& name) const { return (folder / name).string(); }
  void print(const std::vector<row>& rows) const {
    for (const row& r : rows) bench::print(out, r);
  }
  void print_point(const std::string& work, const char* model, double elements, double ours, double floor) const {
    bench::print_point(out, work, model, elements, ours, floor);
  }

 private:
  [[noreturn]] static void usage(const char* name) {
    std::fprintf(stderr,
                 "usage: %s [--tiny] [--warm] [--rounds N] [--only TEXT] [--out ROWS.tsv] [--base TRIANGLES.obj]\n"
                 "  --tiny    use meshes of some hundred elements, to test that everything runs\n"
                 "  --warm    let malloc keep freed memory, instead of new pages for every run\n"
                 "  --rounds  measure N times and print medians\n"
                 "  --only    measure only work whose name contains TEXT, such as load.tri1m or dijkstra\n"
                 "  --out     write the rows to a file, as text with tabs\n"
                 "  --base    generate the surfaces from this closed triangle mesh (an OBJ file) instead of the torus\n",
                 name);
    std::exit(2);
  }
  static surface_arrays arrays_from_obj(const std::string& path) {
    const auto m = floors::parse_obj<3>(path);
    surface_arrays a;
    a.arity = 3;
    for (u32 v = 0; v < m.num_verts(); ++v) a.points.emplace_back(m.points[3 * v], m.points[3 * v + 1], m.points[3 * v + 2]);
    for (u32 v : m.p2v) a.verts.emplace_back(v);
    return a;
  }
};

/// Runs the body of a program. An exception is printed and makes the program fail.
template<class F>
int run_program(int argc, char** argv, F&& body) {
  try {
    program p(argc, argv);
    body(p);
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s: %s\n", argv[0], e.what());
    return 1;
  }
}

}  // namespace bench
