// expect in 10 lines: concino: Format needs write: static void write.write_context
// Flat arrays to text.
#include <concino/io/format.hpp>

struct soup {
  static constexpr std::string_view name = "soup";
  static constexpr std::string_view extensions[] = {".soup"};
  static constexpr bool holds_surfaces = true, holds_volumes = false;
  static void read(const concino::read_context&, concino::file_contents&);
};
int main() { concino::explain_format<soup>(); }
