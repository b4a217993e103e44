// expect in 10 lines: concino: Format needs extensions: static constexpr std::string_view extensions
// What the names of its files end in.
#include <concino/io/format.hpp>

struct soup {
  static constexpr std::string_view name = "soup";
  static constexpr bool holds_surfaces = true, holds_volumes = false;
  static void read(const concino::read_context&, concino::file_contents&);
  static void write(concino::write_context&, concino::flat_mesh&);
};
int main() { concino::explain_format<soup>(); }
