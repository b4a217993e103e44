// Measures a peer that reads surfaces from OBJ: its time against the library in the same rounds, and its bytes per poly.
#pragma once

#include "heap.hpp"
#include "kinds.hpp"

#include <concino/io.hpp>

#include <stdexcept>

namespace bench {

/// `read(path)` returns the peer's mesh, `count(mesh)` the number of its polys. Only the rows of the peer are printed: load_bench and memory_bench print those
/// of the floor and the library.
template<class Read, class Count>
void compare_reading(const program& p, const std::string& peer, Read read, Count count) {
  for_each_file(p, {"load", "memory"}, [&](const std::string& name, const std::string& path, const auto& arrays, auto kind) {
    if constexpr (requires { arrays.offsets; }) {
      using mesh = typename decltype(kind)::mesh;
      const auto only_peer = [&](const std::vector<row>& rows) {
        for (const row& r : rows)
          if (r.contender == peer) p.print({r});
      };
      const auto held = [](auto make) {
        const std::size_t before = heap::live;
        const auto m = make();
        return static_cast<double>(heap::live - before);
      };
      const auto n = static_cast<std::size_t>(count(read(path)));
      if (n != arrays.num_polys())
        throw std::runtime_error(peer + ": " + std::to_string(n) + " polys of " + name + ", not " + std::to_string(arrays.num_polys()));
      if (p.wants("load." + name))
        only_peer(compare("load." + name, std::min(p.rounds, 3),
                          {{"concino", [&] { return seconds_of([&] { return concino::load<mesh>(path); }); }},
                           {peer, [&] { return seconds_of([&] { return read(path); }); }}}));
      const double ours = held([&] { return concino::load<mesh>(path); }), theirs = held([&] { return read(path); });
      p.print({{"memory." + name, peer, "B/poly", theirs / static_cast<double>(n), ours / theirs}});
    }
  });
}

}  // namespace bench
