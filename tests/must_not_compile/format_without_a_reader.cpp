// expect in 10 lines: concino: Format needs read: static void read.const read_context
// Text to flat arrays.
#include <concino/io/format.hpp>

struct soup {
  static constexpr std::string_view name = "soup";
  static constexpr std::string_view extensions[] = {".soup"};
  static constexpr bool holds_surfaces = true, holds_volumes = false;
  static void write(concino::write_context&, concino::flat_mesh&);
};
int main() { concino::explain_format<soup>(); }
