// Loading, a harmonic map and heat geodesics with the default solver, as a module that compiled_bench loads.
#include "works.hpp"

#include "../support/timing.hpp"

#include <concino/fields/harmonic_map.hpp>
#include <concino/fields/heat_geodesics.hpp>
#include <concino/io/load.hpp>
#include <concino/mesh/trimesh.hpp>

#include <functional>
#include <map>
#include <stdexcept>

namespace {

namespace cn = concino;

class mesh_works final : public bench::works {
  struct work {
    std::function<double()> seconds;
    std::function<std::vector<double>()> results;
  };

  std::string path_;
  cn::trimesh mesh_;
  cn::vert_id first_{0}, last_;
  cn::prepared_heat_geodesics<cn::trimesh, cn::auto_solver> heat_;
  std::map<std::string, work> works_;

  /// f does the work. values_of(result) returns numbers of the result of f.
  template<class F, class G>
  void add(const std::string& name, F f, G values_of) {
    works_[name] = {[f] { return bench::seconds_of(f); }, [f, values_of] { return values_of(f()); }};
  }

 public:
  explicit mesh_works(const std::string& path)
      : path_(path), mesh_(cn::load<cn::trimesh>(path)), last_(cn::num_verts(mesh_) - 1), heat_(cn::prepare_heat_geodesics(mesh_)) {
    const auto values = [](const auto& map) { return std::vector<double>(map.values().begin(), map.values().end()); };
    add("load", [this] { return cn::load<cn::trimesh>(path_); },
        [](const cn::trimesh& m) {
          std::vector<double> x;
          for (const cn::vert_id v : cn::verts(m)) x.push_back(cn::point(m, v).x);
          for (const cn::poly_id p : cn::polys(m))
            for (const cn::edge_id e : cn::adj_p2e(m, p)) x.push_back(e.raw());
          return x;
        });
    add("harmonic", [this] { return cn::harmonic_map(mesh_, {{first_, 0.0}, {last_, 1.0}}); }, values);
    add("heat.prepare", [this] { return cn::prepare_heat_geodesics(mesh_); },
        [this, values](const auto& heat) { return values(heat.distance_from(first_)); });
    add("heat.query", [this] { return heat_.distance_from(first_); }, values);
  }
  mesh_works(const mesh_works&) = delete;
  mesh_works& operator=(const mesh_works&) = delete;

  double seconds(const std::string& name) const override { return works_.at(name).seconds(); }
  std::vector<double> results(const std::string& name) const override { return works_.at(name).results(); }
};

}  // namespace

extern "C" [[gnu::visibility("default")]] bench::works* concino_make_works(const char* path) { return new mesh_works(path); }
