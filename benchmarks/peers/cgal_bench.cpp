// Measures reading surfaces into CGAL's Surface_mesh.
#include "../support/peer.hpp"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OBJ.h>

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    using mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
    bench::compare_reading(
        p, "cgal",
        [](const std::string& path) {
          mesh m;
          if (!CGAL::IO::read_OBJ(path, m)) throw std::runtime_error("CGAL cannot read " + path);
          return m;
        },
        [](const mesh& m) { return m.number_of_faces(); });
  });
}
