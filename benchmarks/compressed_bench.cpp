// Measures the readers of compressed files: from a text in memory to flat arrays. The floor is zlib alone: its uncompress() of the same blocks, each into the
// same 32 KiB, which stay in the cache.
#include "support/compressed_vtu.hpp"
#include "support/program.hpp"

#include <concino/adapters/zlib.hpp>
#include <concino/io.hpp>
#include <concino/mesh.hpp>

#include <utility>
#include <vector>

#include <zlib.h>

namespace {

/// Where the compressed blocks of a file are, and their size when decompressed.
struct block {
  const unsigned char* from;
  std::size_t compressed_size, size;
};

std::vector<block> blocks_of(const std::string& text, const std::string& compressed_text) {
  std::vector<block> all;
  const char* at = compressed_text.data() + compressed_text.find("<AppendedData");
  at = compressed_text.data() + compressed_text.find('_', static_cast<std::size_t>(at - compressed_text.data())) + 1;
  bench::for_each_array(text, [&](std::size_t, std::string_view bytes) {
    std::uint32_t header[3];
    std::memcpy(header, at, sizeof header);
    const char* sizes = at + sizeof header;
    at = sizes + 4 * header[0];
    for (std::uint32_t i = 0; i < header[0]; ++i) {
      std::uint32_t n = 0;
      std::memcpy(&n, sizes + 4 * i, 4);
      all.push_back({reinterpret_cast<const unsigned char*>(at), n, std::min<std::size_t>(header[1], bytes.size() - std::size_t{i} * header[1])});
      at += n;
    }
  });
  return all;
}

template<class Arrays, class M>
void measure(const bench::program& p, const std::string& mesh, const M& m) {
  const std::string work = "parse.vtu-compressed." + mesh;
  if (!p.wants(work)) return;
  const std::string text = concino::save_text(m, concino::file_format::vtu, {.binary = true}), small = bench::compressed(text);
  const auto read = [&] { return concino::load_text<Arrays>(small, concino::file_format::vtu, {.inflate = concino::zlib_inflate}); };
  if (read().points != concino::load_text<Arrays>(text, concino::file_format::vtu).points) throw std::runtime_error(work + ": other points");
  const auto blocks = blocks_of(text, small);
  std::vector<unsigned char> room(32768);
  const auto floor = [&] {
    return bench::seconds_of([&] {
      unsigned sum = 0;
      for (const block& b : blocks) {
        uLongf size = b.size;
        if (uncompress(room.data(), &size, b.from, b.compressed_size) != Z_OK || size != b.size) throw std::runtime_error(work + ": zlib refuses a block");
        sum += room[0];
      }
      return sum;
    });
  };
  const auto rows = bench::compare(work, p.rounds, {{"floor", floor}, {"concino", [&] { return bench::seconds_of(read); }}});
  p.print(rows);
  for (const bench::row& r : rows)
    if (r.contender == "concino") p.print({{"parse_speed.vtu-compressed." + mesh, "concino", "MB/s", static_cast<double>(text.size()) / 1e6 / r.value, 1}});
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    using namespace concino;
    measure<surface_arrays>(p, "tri1m", trimesh(p.data.tri1m()));
    measure<cell_arrays>(p, "tet1m", tetmesh(p.data.tet1m()));
    measure<polyhedra_arrays>(p, "dual200k", polyhedralmesh(p.data.dual200k()));
  });
}
