// expect in 10 lines: explain_format<F>
// A class that lacks something is no format: what it lacks is named by explain_format.
#include <concino/io.hpp>
#include <concino/mesh/trimesh.hpp>

struct soup {
  static constexpr std::string_view name = "soup";
};
auto refused() { return concino::load<concino::trimesh>("a.soup", soup{}); }
