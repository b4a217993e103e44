// expect in 10 lines: concino: write is there, but is not static
// A format is a type; there is no object of it to ask.
#include <concino/io/format.hpp>

struct soup {
  static constexpr std::string_view name = "soup";
  static constexpr std::string_view extensions[] = {".soup"};
  static constexpr bool holds_surfaces = true, holds_volumes = false;
  static void read(const concino::read_context&, concino::file_contents&);
  void write(concino::write_context&, concino::flat_mesh&);
};
int main() { concino::explain_format<soup>(); }
