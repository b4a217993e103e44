// concino harmonic: a field that is given at some verts, and as smooth as possible between them.
#include "fields.hpp"
#include "mesh_files.hpp"

#include <concino/fields/harmonic_map.hpp>

namespace cn = concino;

namespace program {
namespace {

template<class M>
void run(M& m, const harmonic_options& options) {
  std::vector<std::pair<cn::vert_t<M>, double>> values;
  for (const auto& [v, value] : options.values) values.push_back({vert_of(m, v, "--values"), value});
  const auto field = or_fail(unreadable_input, [&] {
    cn::terminal_progress line;
    return cn::harmonic_map(m, values, {.progress = line});
  });
  write_field(m, field, "harmonic", options.to);
}

}  // namespace

int harmonic(const harmonic_options& options) {
  auto mesh = load_mesh(options.file);
  std::visit([&](auto& m) { run(m, options); }, mesh);
  return done;
}

}  // namespace program
