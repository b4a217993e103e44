// expect in 10 lines: explain_format<F>
// A class that lacks a member is not a format; explain_format names the member.
#include <concino/io.hpp>
#include <concino/mesh/trimesh.hpp>

struct soup {
  static constexpr std::string_view name = "soup";
};
auto refused() { return concino::load<concino::trimesh>("a.soup", soup{}); }
