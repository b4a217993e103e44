// What programs of one file take to compile: CPU seconds and peak memory of the compiler, without optimisation and with. They read a polygon
// mesh, map it harmonically and write it, by single headers and by umbrella headers; the floor is a program that only factorises with Eigen.
#include "support/program.hpp"

#include <stdexcept>

#include <sys/resource.h>
#include <sys/wait.h>

namespace {

struct compilation {
  double seconds, megabytes;
};

/// The compiler's driver waits for its children, so what is counted for it counts them too.
compilation compile(const std::string& source, const char* optimisation, const std::string& object) {
  const std::string path = CONCINO_COMPILE_TIME_FOLDER "/" + source + ".cpp";
  const char* const command[] = {CONCINO_COMPILER, "-std=c++20",  optimisation, "-I" CONCINO_INCLUDE, "-I" CONCINO_CONCEPTS, "-isystem", CONCINO_EIGEN,
                                 "-c",             path.c_str(), "-o",         object.c_str(),       nullptr};
  const ::pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process for the compiler");
  if (child == 0) {
    ::execv(command[0], const_cast<char* const*>(command));
    ::_exit(127);
  }
  int status = 0;
  ::rusage used = {};
  if (::wait4(child, &status, 0, &used) != child || status != 0) throw std::runtime_error(path + " does not compile");
  const double seconds = static_cast<double>(used.ru_utime.tv_sec) + 1e-6 * static_cast<double>(used.ru_utime.tv_usec);
  return {seconds, static_cast<double>(used.ru_maxrss) / 1024};
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    const int rounds = p.rounds < 3 ? p.rounds : 3;
    for (const char* const optimisation : {"-O0", "-O3"}) {
      if (p.data.tiny && optimisation[2] == '3') continue;
      for (const std::string source : {"program", "program_by_umbrellas"}) {
        const std::string name = (source == "program" ? "single" : "umbrellas") + std::string(".") + (optimisation + 1);
        if (!p.wants("compile." + name)) continue;
        double most = 0, most_of_floor = 0;
        const auto contender = [&](const std::string& what, double& peak) {
          return [&, what] {
            const compilation c = compile(what, optimisation, p.file("object.o"));
            peak = std::max(peak, c.megabytes);
            return c.seconds;
          };
        };
        p.print(bench::compare("compile." + name, rounds, {{"floor", contender("floor", most_of_floor)}, {"concino", contender(source, most)}}));
        p.print({{"compiler." + name, "floor", "MB", most_of_floor, most / most_of_floor}, {"compiler." + name, "concino", "MB", most, 1}});
      }
    }
  });
}
