#include <concino/io/load_any.hpp>

#include <support/reading.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>

using namespace concino;
using namespace concino::testing;

namespace {

const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string faces_text = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
const std::string tet = "OFF\n4 4 6\n" + points + faces_text;
const std::vector<unsigned> tet_verts = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};

surface_arrays off(const std::string& text, load_report* report = nullptr) {
  return load_alone<surface_arrays>(text, file_format::off, {.report = report}, "t.off");
}
polygonmesh mesh(const std::string& text, load_report* report = nullptr) {
  return load_text<polygonmesh>(text, file_format::off, {.report = report}, "t.off");
}
std::size_t line(const std::string& text) { return bad_line<surface_arrays>(text, file_format::off); }
bool is_tet(const surface_arrays& s) {
  return s.points.size() == 4 && s.points[1] == vec3{1, 0, 0} && s.points[3] == vec3{0, 0, 1} && s.arity == 3 && s.offsets.empty() && raw(s.verts) == tet_verts;
}
std::vector<std::string> names(const polygonmesh& m) {
  std::vector<std::string> r;
  for (const property_info& p : property_list(m)) r.push_back(std::string(to_string(p.kind)) + ' ' + p.name);
  return r;
}
using list = std::vector<std::string>;

/// Integers and floats as 32 bits, big-endian.
struct bytes {
  std::string text;
  bytes& i(std::int64_t x) {
    for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>((static_cast<std::uint32_t>(x) >> shift) & 255);
    return *this;
  }
  bytes& f(std::initializer_list<float> all) {
    for (const float x : all) i(std::bit_cast<std::uint32_t>(x));
    return *this;
  }
};

/// The same, little-endian.
std::string little(const bytes& b) {
  std::string text = b.text;
  for (std::size_t i = 0; i + 4 <= text.size(); i += 4) std::reverse(text.begin() + static_cast<std::ptrdiff_t>(i), text.begin() + static_cast<std::ptrdiff_t>(i + 4));
  return text;
}

}  // namespace

TEST_CASE("read_off: reads points and polys, with any line ends") {
  for (const std::string end : {"\n", "\r\n", "\r"})
    for (const std::string& last : {end, std::string()}) {
      const std::string text = with_line_ends(tet, end);
      CHECK(is_tet(off(text.substr(0, text.size() - end.size()) + last)));
    }
  CHECK(names(mesh(tet)).empty());
  load_report r;
  off(tet, &r);
  CHECK(r.skipped.empty());
  CHECK(r.notes.empty());
}

TEST_CASE("read_off: the header may lack OFF or the number of edges, and contain comments") {
  const std::string rest = points + faces_text;
  for (const std::string head : {"OFF 4 4 6\n", "4 4 6\n", "4 4\n", "OFF\n4 4\n", "OFF 4 4\n", "OFF\n4\n4\n6\n", "OFF#c\n# c\n\n 4 4 # c\n",
                                 "\xEF\xBB\xBFOFF\n4 4 -1\n", " # c\nOFF\n4 4 # 6\n6\n"})
    CHECK_MESSAGE(is_tet(off(head + rest)), head);
  CHECK(is_tet(off("OFF # c\n#\n4 4 0 # c\n# 9 9 9\n0 0 0#\n\n1 0 0 # 5\n0 1 0\n0 0 1\n3 0 2 1# c\n3 0 1 3\n#\n3 1 2 3\n3 0 3 2 #")));
  CHECK(off("OFF\n0 0 0\n").points.empty());
  CHECK(off("OFF 0 0").num_polys() == 0);
  CHECK(off("OFF\n2 0\n1 2 3\n4 5 6\n").points[1] == vec3{4, 5, 6});
}

TEST_CASE("read_off: line breaks may be between any two numbers") {
  CHECK(is_tet(off("OFF 4 4 6 0 0 0 1 0 0 0 1 0 0 0 1 3 0 2 1 3 0 1 3 3 1 2 3 3 0 3 2")));
  CHECK(is_tet(off("OFF\n4 4 6\n0 0 0 1 0 0\n0 1 0 0 0 1\n" + faces_text)));
  CHECK(is_tet(off("OFF\n4 4 6\n0\n0\n0\n1 0 0 0 1 0 0 0\n1\n3 0\n2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2")));
  const auto m = mesh("OFF\n4 2 0\n0 0 0 1 0 0\n0 1 0 0 0 1\n3 0 1 2 7\n3 0 1 3\n");
  CHECK(names(m) == list{"poly label"});
  // the verts of a poly may continue on the next line
  CHECK(off("OFF\n4 2 0\n" + points + "4 0 1\n2 3 # c\n3 0\n# c\n1\n2\n").num_polys() == 2);
}

TEST_CASE("read_off: stores offsets only if polys have different sizes") {
  CHECK(off("OFF\n4 2 0\n" + points + "4 0 1 2 3\n4 3 2 1 0\n").arity == 4);
  const auto mixed = off("OFF\n4 3 0\n" + points + "3 0 1 2\n4 0 1 2 3\n3 1 2 3\n");
  CHECK(mixed.arity == 0);
  CHECK(mixed.offsets == std::vector<std::uint32_t>{0, 3, 7, 10});
  std::string many = "OFF\n4 10000 0\n" + points;
  for (int i = 0; i < 10000; ++i) many += i % 2 ? "3 0 1 2\n" : "4 0 1 2 3\n";
  CHECK(off(many).verts.size() == 35000);
}

TEST_CASE("read_off: reads the properties of every valid prefix of OFF, and rejects others") {
  const std::string poly = "3 0 1 2\n";
  struct row {
    std::string prefix, vert;
    list properties;
  };
  for (const row& r : {row{"", "", {}},
                       {"N", " 0 0 1", {"vert normal"}},
                       {"C", " 0.5 0.25 1 1.0", {"vert color"}},
                       {"ST", " 8 9", {"vert texture"}},
                       {"CN", " 0 0 1 0.5 0.25 1 1.0", {"vert color", "vert normal"}},
                       {"STN", " 0 0 1 8 9", {"vert normal", "vert texture"}},
                       {"STC", " 0.5 0.25 1 1.0 8 9", {"vert color", "vert texture"}},
                       {"STCN", " 0 0 1 0.5 0.25 1 1.0 8 9", {"vert color", "vert normal", "vert texture"}}})
    for (const std::string four : {"", "4"})
      for (const std::string n : {"", "n"}) {
        CAPTURE(r.prefix + four + n);
        const std::string w = four.empty() ? "" : " 2", unit = four.empty() ? "1" : "2";
        std::string text = r.prefix + four + n + "OFF\n" + (n.empty() ? "" : "3\n") + "3 1 0\n";
        for (const std::string x : {"0 0 0", "U 0 0", "0 U 0"}) {
          std::string p = x;
          if (const auto at = p.find('U'); at != p.npos) p.replace(at, 1, unit);
          text += p + w + r.vert + '\n';
        }
        load_report report;
        const polygonmesh m = mesh(text + poly, &report);
        CHECK(report.skipped.empty());
        CHECK(point(m, vert_id{1}) == vec3{1, 0, 0});
        CHECK(point(m, vert_id{2}) == vec3{0, 1, 0});
        CHECK(names(m) == r.properties);
        for (const std::string& p : r.properties) {
          if (p == "vert color") CHECK(find_vert_property<rgba>(m, "color")[vert_id{2}] == rgba{0.5f, 0.25f, 1, 1});
          if (p == "vert normal") CHECK(find_vert_property<vec3>(m, "normal")[vert_id{2}] == vec3{0, 0, 1});
          if (p == "vert texture")
            CHECK(find_vert_property<std::array<double, 2>>(m, "texture")[vert_id{2}] == std::array<double, 2>{8, 9});
        }
      }
  for (const std::string bad : {"NCNOFF", "CSTOFF", "nOF", "OOFF", "off", "4COFF", "OFFX", "CCOFF", "n4OFF", "44OFF", "PLY"})
    CHECK_MESSAGE(line("# c\n" + bad + "\n3\n0 0 0\n") == 2, bad);
}

TEST_CASE("read_off: points may have any dimension, and a weight that divides them") {
  load_report r;
  CHECK(off("nOFF\n2\n3 1 0\n5 6\n1 0\n0 1\n3 0 1 2\n", &r).points[0] == vec3{5, 6, 0});
  CHECK(r.skipped.empty());
  CHECK(off("nOFF 1 2 0\n5\n6\n").points[1] == vec3{6, 0, 0});
  CHECK(off("nOFF\n5\n1 0 0\n1 2 3 4 5\n", &r).points[0] == vec3{1, 2, 3});
  CHECK(r.skipped == list{"coordinates beyond the third, of 5"});
  CHECK(off("4nOFF\n2\n1 0 0\n1 2 4\n").points[0] == vec3{0.25, 0.5, 0});
  CHECK(line("nOFF\n0\n1 0 0\n") == 2);
  CHECK(line("nOFF\n999999999999\n1 0 0\n") == 2);
  CHECK(line("4OFF\n1 0 0\n1 2 3 0\n") == 3);
  CHECK(line("4OFF\n1 0 0\n1 2 3 1e-320\n") == 3);
}

TEST_CASE("read_off: the numbers after a poly are a label, or a colour of integers or reals") {
  load_report r;
  const std::string head = "OFF\n4 8 0\n" + points;
  const auto m = mesh(head +
                          "3 0 1 2\n3 0 1 2 -7\n3 0 1 2 255 0 51\n3 0 1 2 0 255 0 102 # c\n3 0 1 2 1.0 0 0.5\n3 0 1 2 0 0 1e0 .5\n"
                          "3 0 1 2 1 2\n3 0 1 2 .5\n",
                      &r);
  const auto color = find_poly_property<rgba>(m, "color");
  const rgba expected[] = {{}, {}, {1, 0, 0.2f}, {0, 1, 0, 0.4f}, {1, 0, 0.5f}, {0, 0, 1, 0.5f}, {}, {}};
  for (unsigned p = 0; p < 8; ++p) CHECK(color[poly_id{p}] == expected[p]);
  const auto label = find_poly_property<int>(m, "label");
  CHECK(label[poly_id{1}] == -7);
  CHECK(label[poly_id{0}] == 0);
  CHECK(r.skipped == list{"2 polys with numbers after the corners that are not a colour"});
  for (const std::string bad : {"256 0 0", "-1 0 0", "1 2 x", "nan 0 0", "3000000000", "0 0 0 300"})
    CHECK_MESSAGE(line("OFF\n4 2 0\n" + points + "3 0 1 2\n3 0 1 2 " + bad + "\n") == 8, bad);
  load_text<surface_arrays>(head + faces_text + faces_text.substr(0, 8) + "3 0 1 2 1\n3 0 1 2 0 0 0\n3 0 1 2\n", file_format::off,
                            {.report = &r});
  CHECK(r.skipped == list{"labels of polys", "colours of polys"});
}

TEST_CASE("read_off: colours of verts have three or four numbers, integers or reals") {
  load_report r;
  const auto color = [&](const std::string& a, const std::string& b) {
    const auto m = mesh("COFF\n2 0 0\n0 0 0 " + a + "\n1 0 0 " + b + "\n", &r);
    return find_vert_property<rgba>(m, "color")[vert_id{0}];
  };
  CHECK(color("255 0 0", "0 255 51") == rgba{1, 0, 0});
  CHECK(color("255 0 51 0", "0 255 0 102") == rgba{1, 0, 0.2f, 0});
  CHECK(r.notes.empty());
  CHECK(color("1 0 0 1", "0.5 0 0 1") == rgba{1, 0, 0});
  CHECK(r.notes.size() == 1);
  CHECK(color("1 0 0", "0 0 1") == rgba{1, 0, 0});
  CHECK(color("1 0 0 0", "0 0 2 0") == rgba_of_bytes(1, 0, 0, 0));
  CHECK(line("COFF\n1 0 0\n0 0 0 256 0 0 0\n") == 3);
  CHECK(line("COFF\n2 0 0\n0 0 0 1 0 0 0\n0 0 0 1 0\n") == 4);
}

TEST_CASE("read_off: surplus numbers after verts are skipped and reported") {
  load_report r;
  const auto s = off("OFF\n3 1 0\n0 0 0 9 9 9\n1 0 0\n0 1 0 0.5\n3 0 1 2\n", &r);
  CHECK(s.points[2] == vec3{0, 1, 0});
  CHECK(s.num_polys() == 1);
  CHECK(r.skipped == list{"2 verts with more numbers than the header says"});
  CHECK(line("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0 x\n3 0 1 2\n") == 5);
}

TEST_CASE("read_off: text after the last poly is skipped and reported") {
  load_report r;
  off(tet + "\n# c\n3 0 1 2\n", &r);
  CHECK(r.skipped == list{"what follows the last poly, from line 13 on"});
}

TEST_CASE("read_off: errors name the line") {
  CHECK(line("") == 1);
  CHECK(line(" \n# c\n") == 2);
  CHECK(line("OFF") == 1);
  CHECK(line("OFF BINARY") == 1);
  CHECK(line("OFF\n4\n") == 2);
  CHECK(line("OFF\n-4 4 0\n" + points) == 2);
  CHECK(line("OFF\n4 -4 0\n" + points) == 2);
  CHECK(line("OFF\n4.5 4 0\n" + points) == 2);
  CHECK(line("OFF\n4 4 x\n" + points + faces_text) == 2);
  CHECK(line("OFF\n4000000000 4 0\n" + points) == 2);
  CHECK(line("OFF\n4 999999999999999999 0\n" + points) == 2);
  CHECK(line("OFF\n4 4 99999999999999999999\n" + points + faces_text) == 2);
  for (const std::string bad : {"1 O 0", "1 0", "nan 0 0", "0 0 inf", "1e999 0 0", "1,0,0"})
    CHECK_MESSAGE(line("OFF\n4 4 0\n0 0 0\n" + bad + "\n0 1 0\n0 0 1\n" + faces_text) == 4, bad);
  for (const std::string bad :
       {"3 0 1 4", "3 0 1 -1", "3 0 1", "2 0 1", "0", "-3 0 1 2", "3 0 1 1", "3 0 1 2.0", "3 0 1 x", "x", "99999999 0 1 2"})
    CHECK_MESSAGE(line("OFF\n4 3 0\n" + points + "3 0 1 2\n" + bad + "\n3 0 1 2\n") == 8, bad);
  CHECK(line("OFF\n4 2 0\n" + points + "3 0 1 2\n") == 7);
  CHECK(line("OFF\n4 4 0\n0 0\n1 0 0\n0 1 0\n0 0 1\n" + faces_text) == 3);
  CHECK(line("OFF\n0 1 0\n3 0 1 2\n") == 3);
}

TEST_CASE("read_off: comments begin with # and may be between any two numbers") {
  const std::string vert_rows[] = {"0 0 0", "1 0 0", "0 1 0", "0 0 1"}, poly_rows[] = {"3 0 2 1", "3 0 1 3", "3 1 2 3", "3 0 3 2"};
  for (const std::string head : {"OFF", "nOFF\n3"})
    for (const bool free : {false, true}) {
      std::vector<std::string> parts{"OFF"};
      if (head != "OFF") parts = {"nOFF", "3"};
      const auto add = [&](const std::string& numbers) {
        if (!free) return parts.push_back(numbers);
        for (std::size_t i = 0; i < numbers.size(); i += 2) parts.push_back(numbers.substr(i, 1));
      };
      parts.push_back("4");
      parts.push_back("4");
      parts.push_back("6");
      for (const std::string& v : vert_rows) add(v);
      for (const std::string& p : poly_rows) add(p);
      for (std::size_t i = 0; i < parts.size(); ++i) {
        std::string commented, wrong;
        for (std::size_t k = 0; k < parts.size(); ++k) {
          commented += (k == i ? "# c\n" : "") + parts[k] + '\n';
          wrong += (k == i ? "$ c\n" : "") + parts[k] + '\n';
        }
        CHECK_MESSAGE(is_tet(off(commented)), commented);
        CHECK_MESSAGE(line(wrong) > 0, wrong);
      }
    }
  CHECK(is_tet(off("OFF\n4 4\n6# c\n" + points + faces_text)));
  CHECK(off("nOFF\n2\n2 0\n7\n5 6\n1 2\n").points[0] == vec3{5, 6, 0});
  CHECK(off("nOFF 4\n0 0").points.empty());
}

TEST_CASE("read_off: the first vert and the number of lines decide whether lines separate elements") {
  load_report r;
  CHECK(off("OFF\n3 1 0\n# c\n0 0 0\n1 0 0 9\n0 1 0\n3 0 1 2\nmore\n", &r).points[2] == vec3{0, 1, 0});
  CHECK(off("OFF\n3 1 0\n0 0 0 9\n1 0 0\n0 1 0\n3 0 1 2\nmore\n", &r).points[2] == vec3{0, 1, 0});
  for (const std::string empty : {"# c\n", "  \n", "\n", "# c # d\n"}) CHECK(off("OFF\n2 0\n0 0 0 1 2 3\n" + empty).points[1] == vec3{1, 2, 3});
  CHECK(line("OFF\n3 0\n0.00000\n0.00000\n0.00000\n") == 3);
  CHECK(is_tet(off("OFF\n4 4 6\n0 0 0 1 0 0\n0 1 0 0 0 1\n3 0 2 1 3 0\n1 3 3 1 2 3 3 0 3 2")));
  CHECK(off("OFF\n4 2 0\n" + points + "3 0 1 2\n4 0 1\n2 3\n").num_polys() == 2);
  CHECK(line("OFF\n4 2 0\n" + points + "4 0 1\n2 3\n") == 7);
  const auto m = mesh("COFF 2 0 0 0 0 0 0 0 255 255 1 0 0 255 0 0 255");
  CHECK(point(m, vert_id{1}) == vec3{1, 0, 0});
  CHECK(find_vert_property<rgba>(m, "color")[vert_id{0}] == rgba{0, 0, 1});
}

TEST_CASE("read_off: counts may be as large as the rest of the file can hold, and no larger") {
  CHECK(line("OFF\n2 0 0\n0 0 0\n") == 3);
  CHECK(line("OFF\n2 0 0\n0 0 0") == 2);
  CHECK(line("OFF\n100 0 0\n0 0 0\n") == 2);
  CHECK(line("COFF\n2 0\n0 0 0 0 0 0    \n") == 2);
  CHECK(line("OFF\n0 2\n3 0 1 2\n    ") == 2);
  std::string many = "OFF 3 100 0 0 0 0 0 0 0 0 0 0", colors = "COFF\n20 0\n";
  for (int i = 0; i < 100; ++i) many += "\n3 0 1 2";
  for (int i = 0; i < 20; ++i) colors += "0 0 0 1 1 1\n";
  CHECK(off(many).num_polys() == 100);
  CHECK(off(colors).points.size() == 20);
}

TEST_CASE("read_off: messages name what was expected and what was found") {
  const auto says = [](const std::string& text) { return complaint<surface_arrays>(text, file_format::off); };
  CHECK(says("OFF\n4 1 0\n" + points + "3 0 1 4\n") == "7: the index of a vert from 0 to 3 | '4'");
  CHECK(says("OFF\n0 1 0\n3 0 1 2\n") == "3: no polys, because there are no verts | '0'");
  CHECK(says("OFF BINARY 3\n") == "1: the end of the line after BINARY | '3'");
  CHECK(says("OFF BINAR") == "1: the number of verts | 'BINAR'");
}

TEST_CASE("read_off: colours and labels are right at the ends of their ranges") {
  const auto colors = [](const std::string& numbers) {
    const auto m = mesh("OFF\n4 1 0\n" + points + "3 0 1 2 " + numbers + "\n");
    const auto color = find_poly_property<rgba>(m, "color");
    return color ? color[poly_id{0}] : rgba{9, 9, 9, 9};
  };
  CHECK(colors("+255 0 +0") == rgba{1, 0, 0});
  CHECK(colors("0.5 -0.5 2") == rgba{0.5f, -0.5f, 2});
  CHECK(colors("300.0 0 0") == rgba{300, 0, 0});
  CHECK(colors("1 2 3 4 5") == rgba{9, 9, 9, 9});
  CHECK(colors("1 2 3 4 5 6") == rgba{9, 9, 9, 9});
  const auto label = [](const std::string& number) {
    const auto m = mesh("OFF\n4 1 0\n" + points + "3 0 1 2 " + number + "\n");
    return find_poly_property<int>(m, "label")[poly_id{0}];
  };
  CHECK(label("-2147483648") == std::numeric_limits<int>::min());
  CHECK(label("2147483647") == std::numeric_limits<int>::max());
  for (const std::string bad : {"-2147483649", "2147483648", "0 -1 0", "0 0 -1", "0 0 0 -1", "0 256 0", "0 0 256"})
    CHECK_MESSAGE(line("OFF\n4 1 0\n" + points + "3 0 1 2 " + bad + "\n") == 7, bad);
  for (const std::string large : {"2 0 0 0", "0 2 0 0", "0 0 2 0", "0 0 0 2"}) {
    const auto m = mesh("COFF\n2 0\n0 0 0 1 0 0 0\n0 0 0 " + large + "\n");
    CHECK_MESSAGE(find_vert_property<rgba>(m, "color")[vert_id{0}] == rgba_of_bytes(1, 0, 0, 0), large);
  }
  load_report r;
  CHECK(off("4OFF\n1 0 0\n2 4 6 2\n").points[0] == vec3{1, 2, 3});
  off("nOFF\n4\n1 0 0\n1 2 3 4\n", &r);
  CHECK(r.skipped == list{"coordinates beyond the third, of 4"});
  CHECK(off("OFF 0 0").offsets == std::vector<std::uint32_t>{0});
  CHECK(off("OFF 0 0").arity == 0);
}

TEST_CASE("read_off: the error names the line of the first poly that the mesh cannot hold") {
  const std::string both = "OFF\n4 2 0\n" + points + "3 0 1 2\n4 0 1 2 3\n";
  CHECK(bad_line<trimesh>(both, file_format::off) == 8);
  CHECK(bad_line<quadmesh>(both, file_format::off) == 7);
  CHECK(num_polys(mesh(both)) == 2);
  CHECK(num_verts(load_text<trimesh>("OFF\n1 0\n0 0 0\n", file_format::off)) == 1);
  CHECK_THROWS_AS(load_text<tetmesh>(both, file_format::off), unsupported);
  const temporary_folder dir;
  write_file(dir / "a.Off", tet);
  CHECK(load_any(dir / "a.Off").index() == 0);
  write_file(dir / "a.off", both);
  CHECK(load_any(dir / "a.off").index() == 2);
}

TEST_CASE("read_off: reads binary files, and rejects truncated and invalid ones") {
  bytes b;
  b.i(4).i(3).i(0).f({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
  b.i(3).i(0).i(2).i(1).i(0);
  b.i(3).i(0).i(1).i(3).i(3).f({0.5f, 0, 1});
  b.i(4).i(0).i(1).i(2).i(3).i(1).f({6});
  for (const std::string head : {"OFF BINARY\n", "OFF BINARY\r", "OFF BINARY\r\n", "# c\nOFF  BINARY \n"}) {
    load_report r;
    const auto m = mesh(head + b.text, &r);
    CHECK(num_verts(m) == 4);
    CHECK(point(m, vert_id{3}) == vec3{0, 0, 1});
    CHECK(raw(adj_p2v(m, poly_id{2})) == std::vector<unsigned>{0, 1, 2, 3});
    CHECK(find_poly_property<rgba>(m, "color")[poly_id{1}] == rgba{0.5f, 0, 1});
    CHECK(find_poly_property<rgba>(m, "color")[poly_id{2}] == rgba{});
    CHECK(find_poly_property<int>(m, "label")[poly_id{2}] == 6);
    CHECK(r.skipped.empty());
    for (std::size_t n = 0; n < b.text.size(); ++n) CHECK(line(head + b.text.substr(0, n)) > 0);
    off(head + b.text + "more", &r);
    CHECK(r.skipped[0] == "4 bytes after the last poly");
  }
  bytes all;
  all.i(3).i(1).i(0).i(0);
  all.f({1, 2, 3, 2, 0, 0, 1, 0.5f, 0.25f, 0, 1, 8, 9});
  const auto m = mesh("STCN4nOFF BINARY\n" + bytes().i(3).i(1).i(0).i(0).text + all.text.substr(16));
  CHECK(point(m, vert_id{0}) == vec3{0.5, 1, 1.5});
  CHECK(find_vert_property<vec3>(m, "normal")[vert_id{0}] == vec3{0, 0, 1});
  CHECK(find_vert_property<rgba>(m, "color")[vert_id{0}] == rgba{0.5f, 0.25f, 0, 1});
  CHECK(find_vert_property<std::array<double, 2>>(m, "texture")[vert_id{0}] == std::array<double, 2>{8, 9});
  const auto fails = [](const bytes& x) { return line("OFF BINARY\n" + x.text) == 1; };
  CHECK(fails(bytes().i(-1).i(0).i(0)));
  CHECK(fails(bytes().i(2000000000).i(0).i(0)));
  CHECK(fails(bytes().i(0).i(2000000000).i(0)));
  const auto one = [](const bytes& poly) {
    bytes x;
    x.i(3).i(1).i(0).f({0, 0, 0, 1, 0, 0, 0, 1, 0});
    x.text += poly.text;
    return x;
  };
  CHECK(!fails(one(bytes().i(3).i(0).i(1).i(2).i(0))));
  CHECK(fails(one(bytes().i(3).i(0).i(1).i(3).i(0))));
  CHECK(fails(one(bytes().i(3).i(0).i(1).i(1).i(0))));
  CHECK(fails(one(bytes().i(2).i(0).i(1).i(0).i(0))));
  CHECK(fails(one(bytes().i(3).i(0).i(1).i(2).i(5).f({0, 0, 0, 0, 0}))));
  CHECK(fails(bytes().i(1).i(0).i(0).f({0, std::numeric_limits<float>::infinity(), 0})));
  CHECK(line("OFF BINARY 3\n") == 1);
}

TEST_CASE("read_off: binary: messages name the byte; counts may be as large as the file can hold") {
  const auto says = [](const std::string& text) { return complaint<surface_arrays>(text, file_format::off); };
  const std::string head = "OFF BINARY\n", too_many = ", no more than the rest of the file can hold | another value at byte ";
  CHECK(says(head + bytes().i(-1).i(0).i(0).text) == "1: the number of verts, not negative | another value at byte 11");
  CHECK(says(head + bytes().i(0x80000000).i(0).i(0).text) == "1: the number of verts, not negative | another value at byte 11");
  CHECK(says(head + bytes().i(0x7FFFFFFF).i(0).i(0).text) == "1: the number of verts" + too_many + "11");
  CHECK(says(head + bytes().i(2).i(0).i(0).f({0, 0, 0}).text) == "1: the number of verts" + too_many + "11");
  CHECK(says("4" + head + bytes().i(3).i(0).i(0).text + std::string(32, '\0')) == "1: the number of verts" + too_many + "12");
  CHECK(says("N" + head + bytes().i(3).i(0).i(0).text + std::string(56, '\0')) == "1: the number of verts" + too_many + "12");
  CHECK(says("C" + head + bytes().i(3).i(0).i(0).text + std::string(66, '\0')) == "1: the number of verts" + too_many + "12");
  CHECK(says("ST" + head + bytes().i(3).i(0).i(0).text + std::string(40, '\0')) == "1: the number of verts" + too_many + "13");
  CHECK(says(head + bytes().i(2).i(2).i(0).f({0, 0, 0, 0, 0, 0}).text + std::string(10, '\0')) == "1: the number of polys" + too_many + "15");
  CHECK(says(head + bytes().i(0).i(0).text) == "1: the number of edges | the end of the file at byte 19");
  CHECK(says(head + bytes().i(1).i(0).i(0).f({0, INFINITY, 0}).text) == "1: a finite number | another value at byte 27");
  CHECK(says("n" + head + bytes().i(0).i(0).i(0).i(0).text) == "1: the dimension of the space, at least 1 | another value at byte 12");
  CHECK(says("4" + head + bytes().i(1).i(0).i(0).f({1, 2, 3, 0}).text) == "1: a weight w by which x y z can be divided | another value at byte 36");
  const std::string three = head + bytes().i(3).i(1).i(0).f({0, 0, 0, 1, 0, 0, 0, 1, 0}).text;
  CHECK(says(three + bytes().i(2).i(0).i(1).i(0).i(0).text) == "1: a poly of at least three verts | another value at byte 59");
  CHECK(says(three + bytes().i(4).i(0).i(1).i(2).text) == "1: the number of verts of a poly" + too_many + "59");
  CHECK(says(three + bytes().i(3).i(0).i(1).i(3).i(0).text) == "1: the index of a vert below 3 | another value at byte 71");
  CHECK(says(three + bytes().i(3).i(0).i(1).i(1).i(0).text) == "1: different verts at the corners of a poly (or set options.repeated_verts) | vert 1 twice");
  CHECK(says(three + bytes().i(3).i(0).i(1).i(2).i(5).text + std::string(20, '\0')) ==
        "1: a colour of at most 4 numbers | another value at byte 75");
  CHECK(says("# c\r\nOFF BINARY\r\n" + bytes().i(-1).i(0).i(0).text) == "2: the number of verts, not negative | another value at byte 17");
  CHECK(complaint<trimesh>("OFF 4 1 0\n" + points + "4 0 1 2 3\n", file_format::off) ==
        "6: a triangle (polygonmesh and load_any take any polygon) | a polygon of 4 corners");

  CHECK(off("n" + head + bytes().i(12).i(0).i(0).i(0).text).points.empty());
  CHECK(off("n" + head + bytes().i(1).i(1).i(0).i(0).f({7}).text).points[0] == vec3{7, 0, 0});
  CHECK(off("n" + head + bytes().i(5).i(1).i(0).i(0).f({1, 2, 3, 4, 5}).text).points[0] == vec3{1, 2, 3});
  bytes colors, triangles, ring;
  colors.i(10).i(0).i(0);
  for (int i = 0; i < 10; ++i) colors.f({0, 0, 0, 1, 1, 1, 1});
  CHECK(off("C" + head + colors.text).points.size() == 10);
  triangles.i(3).i(50).i(0).f({0, 0, 0, 1, 0, 0, 0, 1, 0});
  for (int i = 0; i < 50; ++i) triangles.i(3).i(0).i(1).i(2).i(0);
  CHECK(off(head + triangles.text).num_polys() == 50);
  ring.i(30).i(1).i(0);
  for (int i = 0; i < 30; ++i) ring.f({static_cast<float>(i), 0, 0});
  ring.i(30);
  for (int i = 0; i < 30; ++i) ring.i(i);
  CHECK(off(head + ring.i(0).text).verts.size() == 30);
}

TEST_CASE("read_off: binary: the numbers after a poly are a colour or a label; others are reported") {
  bytes b;
  b.i(3).i(7).i(0).f({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const auto poly = [&]() -> bytes& { return b.i(3).i(0).i(1).i(2); };
  poly().i(4).f({0.5f, 0.25f, 1, 0.75f});
  poly().i(1).f({0.5f});
  poly().i(1).f({2147483648.0f});
  poly().i(2).f({1, 2});
  poly().i(1).f({-2147483520.0f});
  poly().i(3).f({1, 0, 0.5f});
  poly().i(0);
  load_report r;
  const auto m = mesh("OFF BINARY\n" + b.text, &r);
  const auto color = find_poly_property<rgba>(m, "color");
  CHECK(color[poly_id{0}] == rgba{0.5f, 0.25f, 1, 0.75f});
  CHECK(color[poly_id{5}] == rgba{1, 0, 0.5f});
  CHECK(color[poly_id{6}] == rgba{});
  CHECK(find_poly_property<int>(m, "label")[poly_id{4}] == -2147483520);
  CHECK(find_poly_property<int>(m, "label")[poly_id{1}] == 0);
  CHECK(r.skipped == list{"3 polys with numbers after the corners that are not a colour"});
}

TEST_CASE("read_off: binary: little-endian numbers are recognised and reported") {
  bytes b;
  b.i(4).i(2).i(0).f({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
  b.i(3).i(0).i(2).i(1).i(0);
  b.i(4).i(0).i(1).i(2).i(3).i(1).f({6});
  load_report r;
  const std::string text = "OFF BINARY\n" + little(b);
  const auto m = mesh(text, &r);
  CHECK(r.notes == list{"the numbers of the binary file are little-endian; those of OFF are big-endian"});
  CHECK(num_verts(m) == 4);
  CHECK(point(m, vert_id{3}) == vec3{0, 0, 1});
  CHECK(raw(adj_p2v(m, poly_id{1})) == std::vector<unsigned>{0, 1, 2, 3});
  CHECK(find_poly_property<int>(m, "label")[poly_id{1}] == 6);
  for (std::size_t n = 0; n < text.size() - 11; ++n) CHECK(line(text.substr(0, 11 + n)) > 0);
  mesh("OFF BINARY\n" + b.text, &r);
  CHECK(r.notes.empty());
  mesh(text + "more", &r);
  CHECK(r.skipped[0] == "4 bytes after the last poly");

  bytes dimension;
  dimension.i(2).i(3).i(1).i(0).f({1, 2, 3, 4, 5, 6}).i(3).i(0).i(1).i(2).i(0);
  CHECK(point(mesh("nOFF BINARY\n" + little(dimension)), vert_id{2}) == vec3{5, 6, 0});
  // The counts are possible in both byte orders, as 65536 is 256 in the other order. The numbers are big-endian if the polys are valid that way.
  for (const bool is_little : {false, true}) {
    bytes both;
    both.i(65536).i(65536).i(0);
    for (int i = 0; i < 65536; ++i) both.f({1, 2, static_cast<float>(i)});
    for (int i = 0; i < 65536; ++i) both.i(3).i(i).i(i == 0).i(i < 2 ? 2 : 1).i(0);
    const auto many = mesh("OFF BINARY\n" + (is_little ? little(both) : both.text), &r);
    CHECK(num_polys(many) == 65536);
    CHECK(point(many, vert_id{65535}) == vec3{1, 2, 65535});
    CHECK(r.notes.size() == is_little);
  }
  mesh("OFF BINARY\n" + bytes().i(0).i(0).i(0).text, &r);
  CHECK(r.notes.empty());
}

TEST_CASE("read_off: binary: numbers are little-endian only if the whole file is valid that way") {
  const std::string head = "OFF BINARY\n", no_verts = "1: the number of verts, no more than the rest of the file can hold | another value at byte 11";
  const auto says = [](const std::string& text) { return complaint<surface_arrays>(text, file_format::off); };
  const auto is_little = [](const std::string& text) {
    load_report r;
    off(text, &r);
    return r.notes.size() == 1;
  };
  bytes colored;
  colored.i(4).i(4).i(0).f({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
  colored.i(3).i(0).i(2).i(1).i(4).f({0.5f, 0.25f, 1, 0.75f});
  colored.i(4).i(0).i(1).i(2).i(3).i(1).f({6});
  colored.i(3).i(0).i(1).i(3).i(0);
  colored.i(3).i(1).i(2).i(3).i(3).f({1, 0, 0.5f});
  CHECK(!is_little(head + colored.text));
  const std::string text = little(colored);
  CHECK(is_little(head + text));
  const auto m = mesh(head + text);
  CHECK(find_poly_property<rgba>(m, "color")[poly_id{0}] == rgba{0.5f, 0.25f, 1, 0.75f});
  CHECK(find_poly_property<rgba>(m, "color")[poly_id{3}] == rgba{1, 0, 0.5f});
  CHECK(raw(adj_p2v(m, poly_id{3})) == std::vector<unsigned>{1, 2, 3});

  // A truncated file is valid in neither order, and is read as big-endian.
  for (std::size_t n = 0; n < text.size(); ++n) {
    const std::string cut = head + text.substr(0, n);
    CHECK(says(cut) == (n < 4 ? "1: the number of verts | the end of the file at byte " + std::to_string(11 + n) : no_verts));
  }
  const std::size_t both_counts = 8, begin_of_polys = 60, least_of_polys = 80;
  for (std::size_t n = begin_of_polys; n < colored.text.size(); ++n) {
    const std::string found = says(head + colored.text.substr(0, n));
    if (n < both_counts + least_of_polys) CHECK(found == "1: the number of polys, no more than the rest of the file can hold | another value at byte 15");
    else CHECK_MESSAGE((found.find(" of a ") != found.npos || found.starts_with("1: a number | the end of the file")), found);
  }

  // Files with points only, up to the last byte.
  CHECK(is_little(head + little(bytes().i(2).i(0).i(0).f({0, 0, 0, 1, 2, 3}))));
  CHECK(off(head + little(bytes().i(2).i(0).i(0).f({0, 0, 0, 1, 2, 3}))).points[1] == vec3{1, 2, 3});
  // An invalid poly, as the only one, the last or the first.
  const auto with = [&](std::initializer_list<bytes> all) {
    bytes b;
    b.i(3).i(static_cast<std::int64_t>(all.size())).i(0).f({0, 0, 0, 1, 0, 0, 0, 1, 0});
    for (const bytes& p : all) b.text += p.text;
    return head + little(b) + std::string(40, '\0');
  };
  const bytes good = bytes().i(3).i(0).i(1).i(2).i(0);
  CHECK(is_little(with({good})));
  CHECK(is_little(with({good, good})));
  CHECK(is_little(with({bytes().i(3).i(0).i(1).i(2).i(4).f({0, 0, 0, 0}), good})));
  for (const bytes& bad : {bytes().i(2).i(0).i(1).i(0), bytes().i(0).i(0), bytes().i(1000), bytes().i(3).i(0).i(1).i(2).i(5).f({0, 0, 0, 0, 0}),
                           bytes().i(3).i(0).i(1).i(2).i(1000)}) {
    CHECK(says(with({bad})) == no_verts);
    CHECK(says(with({good, bad})) == no_verts);
    CHECK(says(with({bad, good})) == no_verts);
  }

  // With the dimension of the space in the header.
  const std::string dimension = "1: the dimension of the space, at least 1 | the end of the file at byte ";
  for (std::size_t n = 0; n < 4; ++n) CHECK(says("n" + head + std::string(4, '\0').substr(0, n)) == dimension + std::to_string(12 + n));
  CHECK(says("n" + head + std::string(16, '\0')) == "1: the dimension of the space, at least 1 | another value at byte 12");
  const std::string plane = little(bytes().i(2).i(1).i(0).i(0).f({5, 6}));
  CHECK(is_little("n" + head + plane));
  for (std::size_t n = 4; n < plane.size(); ++n)
    CHECK(says("n" + head + plane.substr(0, n)) == "1: the dimension of the space, at least 1, no more than the rest of the file can hold | another value at byte 12");
  CHECK(says("n" + head + bytes().i(1).i(0).i(0).text) == "1: the number of edges | the end of the file at byte 24");
}
