// concino geodesic: distances from verts, along a surface or through a volume.
#include "fields.hpp"
#include "mesh_files.hpp"

#include <concino/fields/exact_geodesics.hpp>
#include <concino/fields/heat_geodesics.hpp>

#include <fmt/format.h>

#include <concepts>

namespace cn = concino;

namespace program {
namespace {

template<class M>
void run(M& m, const geodesic_options& options) {
  std::vector<cn::vert_t<M>> sources;
  for (const std::size_t v : options.from) sources.push_back(vert_of(m, v, "--from"));
  const auto distance = or_fail(unreadable_input, [&] {
    if constexpr (std::same_as<M, cn::trimesh>) return cn::exact_geodesics(m, sources);
    else return cn::heat_geodesics(m, sources);
  });
  write_field(m, distance, "distance", options.to);
}

}  // namespace

int geodesic(const geodesic_options& options) {
  auto mesh = load_mesh(options.file);
  std::visit([&](auto& m) { run(m, options); }, mesh);
  return done;
}

}  // namespace program
