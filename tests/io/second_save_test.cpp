// Random OBJ files, put together from lines that writers may confuse: what is saved in any format and read back is saved in the same way again.
#include <concino/io/load.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh/polygonmesh.hpp>

#include <support/formats.hpp>
#include <support/corpus.hpp>

#include <doctest/doctest.h>

#include <initializer_list>
#include <random>
#include <string>
#include <string_view>

using namespace concino;
using namespace concino::testing;

namespace {

class random_obj {
  std::mt19937 random_;
  std::string text_;
  unsigned verts_ = 0, textures_ = 0, normals_ = 0;

  unsigned below(unsigned n) { return static_cast<unsigned>(random_()) % n; }
  std::string_view one_of(std::initializer_list<std::string_view> all) { return all.begin()[below(static_cast<unsigned>(all.size()))]; }
  std::string number() {
    if (below(8)) return std::string(one_of({"0", "1", "-1", "0.5", "1e-3", ".25", "3", "-0.1"}));
    return std::string(one_of({"-0.0", "5e-324", "1e-310", "1.7976931348623157e308", "1e39", "0.1000000014901161193847656", "9007199254740993", "3.4028236e38", "1e-46", "1e-400",
                               "16777217", "0.3333333333333333148", "255", "256", "2147483648"}));
  }
  std::string numbers(unsigned n) {
    std::string all;
    while (n-- > 0) (all += ' ') += number();
    return all;
  }
  /// Names that become equal, or look like the names of labels and colours, once a writer has replaced characters.
  std::string name() {
    std::string s(one_of({"label_1", "label_2", "label_-3", "label\t1", "label\x01" "2", "label_01", "color_1", "color\t1", "a", "b", "a\tb", "a_b", "a\x02" "b", "a#b", "a #b", "\\x",
                          "_x", "\x7f", "", "  ", "\\\na", "_a", "label_2147483648", "\\\nlabel_1", "\"q\" <&>", "None", "a b"}));
    if (below(60) == 0) s += std::string(998 + below(6), 'x');
    return s;
  }
  std::string corner(unsigned v, unsigned form) {
    std::string s = below(8) ? std::to_string(v + 1) : std::to_string(static_cast<int>(v) - static_cast<int>(verts_));
    const std::string t = textures_ && (form & 1) ? std::to_string(1 + below(textures_)) : "", n = normals_ && (form & 2) ? std::to_string(1 + below(normals_)) : "";
    if (!t.empty() || !n.empty()) s += '/' + t;
    if (!n.empty()) s += '/' + n;
    return s;
  }
  void face() {
    if (verts_ < 3) return;
    unsigned size = 3 + (below(3) == 0 ? below(verts_ - 2) : 0);
    unsigned v = below(verts_), form = below(4);
    text_ += 'f';
    while (size-- > 0) {
      if (below(6) == 0) form = below(4);
      (text_ += ' ') += corner(v, form);
      v = (v + 1) % verts_;
    }
    text_ += '\n';
  }
  void line() {
    switch (below(16)) {
      case 0: text_ += "v" + numbers(3) + (below(4) ? "" : numbers(below(5))) + '\n', ++verts_; break;
      case 1: text_ += "v" + numbers(3) + " 1 0.5 0" + '\n', ++verts_; break;
      case 2: text_ += "vt" + (below(8) ? numbers(1 + below(3)) : std::string(one_of({" nan nan", " 1e999", "", " 1 -nan"}))) + '\n', ++textures_; break;
      case 3: text_ += "vn" + (below(8) ? numbers(3) : std::string(one_of({" nan nan nan", " inf 0 0", " 1"}))) + '\n', ++normals_; break;
      case 4: text_ += "o " + name() + '\n'; break;
      case 5: text_ += "g " + name() + '\n'; break;
      case 6: text_ += (below(4) ? "usemtl " : "mtllib ") + name() + '\n'; break;
      case 7: text_ += one_of({"s 1\n", "s off\n", "l 1 2\n", "p 1\n", "# c \\\n", "mtllib a.mtl b.mtl\n", "mtllib a\tb\n", "mtllib\n", "g\n", "o\n", "usemtl\n", "\\\n", "vp 1 2\n"}); break;
      default: face();
    }
  }

 public:
  explicit random_obj(unsigned seed) : random_(seed) {}
  std::string text() {
    for (unsigned n = 3 + below(4); n > 0; --n, ++verts_) text_ += "v" + numbers(3) + '\n';
    for (unsigned n = 2 + below(14); n > 0; --n) line();
    return text_;
  }
};

/// A sentence about a difference, or nothing.
std::string difference_after_saving(const polygonmesh& m, format_id format, bool binary) {
  std::string first;
  try {
    first = save_text(m, format, {.binary = binary});
  } catch (const unsupported&) {
    return {};
  } catch (const invalid_mesh&) {
    return {};
  }
  const polygonmesh back = load_text<polygonmesh>(first, format);
  const std::string second = save_text(back, format, {.binary = binary});
  return first == second ? std::string() : core::joined({format.name(), binary ? ", binary:\n" : ":\n", first, "\nand then:\n", second});
}

}  // namespace

TEST_CASE("second save: random OBJ files") {
  const unsigned rounds = long_run() ? 50'000 : 500;
  std::size_t read = 0, failed = 0;
  for (unsigned seed = 1; seed <= rounds && failed < 5; ++seed) {
    const std::string text = random_obj(seed).text();
    polygonmesh m;
    try {
      m = load_text<polygonmesh>(text, file_format::obj);
    } catch (const parse_error&) {
      continue;
    }
    ++read;
    for (const format_id format : formats_with_reader(standard_formats))
      for (const bool binary : {false, true}) {
        const std::string difference = difference_after_saving(m, format, binary);
        if (difference.empty()) continue;
        ++failed;
        CAPTURE(text);
        FAIL_CHECK(difference);
      }
  }
  CHECK(failed == 0);
  CHECK(read > rounds / 2);
}
