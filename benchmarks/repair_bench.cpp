// Measures repair: a soup of triangles, an OBJ file with three points for each, is merged, oriented and validated, against loading the file.
#include "support/kinds.hpp"

#include <concino/io.hpp>
#include <concino/repair.hpp>
#include <concino/validate.hpp>

#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>

namespace cn = concino;

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    if (!p.wants("repair.soup1m")) return;
    const cn::trimesh whole(p.data.tri1m());
    const std::string path = p.file("soup.obj");
    {
      std::ofstream file(path);
      char line[128];
      for (const auto t : cn::polys(whole)) {
        for (const auto v : cn::adj_p2v(whole, t)) {
          const cn::vec3 x = cn::point(whole, v);
          std::snprintf(line, sizeof line, "v %.9g %.9g %.9g\n", x.x, x.y, x.z);
          file << line;
        }
        file << (t.raw() % 3 == 0 ? "f -1 -2 -3\n" : "f -3 -2 -1\n");
      }
    }
    const auto soup = cn::load<cn::trimesh>(path);
    const auto mend = [&](cn::trimesh& m) {
      cn::repair(m, {.merge_within = 0.0, .orient = true});
      if (!cn::validate(m).is_clean() || cn::num_verts(m) != cn::num_verts(whole))
        throw std::runtime_error("repair: the soup is not mended");
      return cn::num_verts(m);
    };
    p.print(bench::compare("repair.soup1m", p.rounds,
                           {{"load", [&] { return bench::seconds_of([&] { return cn::load<cn::trimesh>(path); }); }},
                            {"concino", [&] {
                               auto m = soup;
                               return bench::seconds_of([&] { return mend(m); });
                             }}}));
  });
}
