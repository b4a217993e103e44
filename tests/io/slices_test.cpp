#include <concino/io/slices.hpp>

#include <concino/core/error.hpp>

#include <support/corpus.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

double length_of(std::span<const slice_point> line, bool closed) {
  double sum = 0;
  for (std::size_t i = closed ? 0 : 1; i < line.size(); ++i) {
    const slice_point &a = line[i == 0 ? line.size() - 1 : i - 1], &b = line[i];
    sum += std::hypot(b[0] - a[0], b[1] - a[1]);
  }
  return sum;
}

double area_of(std::span<const slice_point> line) {
  double sum = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const slice_point &a = line[i == 0 ? line.size() - 1 : i - 1], &b = line[i];
    sum += (a[0] * b[1] - a[1] * b[0]) / 2;
  }
  return sum;
}

struct other_slice_format {
  static constexpr std::string_view name = "soup", extensions[] = {".soup"};
};

/// The figures of INDEX.tsv.
struct slice_facts {
  std::size_t layers = 0, inner = 0, outer = 0, open = 0, positive_outer = 0, positive_inner = 0;
  double length_inner = 0, length_outer = 0, length_open = 0, net_area = 0, first_net_area = 0;
};

slice_facts facts_of(const slices& s) {
  slice_facts f;
  f.layers = s.layers.size();
  for (const slice_layer& layer : s.layers) {
    for (std::size_t i = 0; i < layer.inner.size(); ++i) {
      f.length_inner += length_of(layer.inner[i], true);
      f.net_area -= std::abs(area_of(layer.inner[i]));
      f.positive_inner += area_of(layer.inner[i]) > 0;
    }
    for (std::size_t i = 0; i < layer.outer.size(); ++i) {
      f.length_outer += length_of(layer.outer[i], true);
      f.net_area += std::abs(area_of(layer.outer[i]));
      f.positive_outer += area_of(layer.outer[i]) > 0;
    }
    for (std::size_t i = 0; i < layer.open.size(); ++i) f.length_open += length_of(layer.open[i], false);
    f.inner += layer.inner.size();
    f.outer += layer.outer.size();
    f.open += layer.open.size();
    if (&layer == &s.layers.front()) f.first_net_area = f.net_area;
  }
  return f;
}

/// The line of the parse_error that a text causes; 0 if it is read.
std::size_t error_line(const std::string& text, std::string* message = nullptr) {
  try {
    load_slices_text(text);
  } catch (const parse_error& e) {
    if (message) *message = e.what();
    return e.line;
  }
  return 0;
}

std::string cli_text(const std::string& geometry, const std::string& header = "$$UNITS/1\n") {
  return "$$HEADERSTART\n$$ASCII\n" + header + "$$HEADEREND\n$$GEOMETRYSTART\n" + geometry + "$$GEOMETRYEND\n";
}

slices sample_slices() {
  slices s;
  s.units = 0.005;
  s.version = 200;
  s.date = "070493";
  s.dimension = std::array<double, 6>{0, 0, 0, 10, 10.5, 3};
  s.labels = {{1, "part one"}, {2, "supports"}};
  for (int k = 0; k < 3; ++k) {
    slice_layer& layer = s.layers.emplace_back();
    layer.z = 20 * k * s.units;
    const auto at = [&](double x, double y) { return slice_point{x * s.units, y * s.units}; };
    layer.outer.push_back(std::vector<slice_point>{at(0, 0), at(2000, 0), at(2000, 2100), at(0, 2100)}, 1);
    layer.inner.push_back(std::vector<slice_point>{at(100, 100), at(100, 300), at(333, 77)}, 1);
    layer.inner.push_back(std::vector<slice_point>{at(500, 500), at(500, 600), at(612, 500)}, -7);
    layer.open.push_back(std::vector<slice_point>{at(1, 2), at(3, 4), at(1, 2)}, 2);
    layer.hatches.push_back(std::vector<slice_point>{at(0, 10), at(2000, 10), at(0, 20), at(2000, 20)}, 1);
  }
  return s;
}

/// Whether the slices are read, or cause a typed error; what is read must be writable and read back equal.
bool slices_survive(const std::string& text) {
  slices s;
  try {
    s = load_slices_text(text);
  } catch (const parse_error& e) {
    return e.line >= 1;
  }
  return load_slices_text(save_slices_text(s)).layers == s.layers;
}

void put_bytes(std::string& to, std::uint32_t x, int bytes, bool big = false) {
  for (int i = 0; i < bytes; ++i) to += static_cast<char>(x >> 8 * (big ? bytes - 1 - i : i));
}
void put_real(std::string& to, float x, bool big = false) { put_bytes(to, std::bit_cast<std::uint32_t>(x), 4, big); }

/// Two layers with all six commands; `align`: 0 none, 1 at the ends of commands, 2 after their codes.
std::string binary_text(int align = 0, const std::string& after_header = "", bool big = false) {
  const std::string header = std::string("$$HEADERSTART\n$$BINARY\n$$UNITS/0.5\n$$LAYERS/2\n") + (align ? "$$ALIGN\n" : "") + "$$HEADEREND" + after_header;
  std::string data;
  const auto pad = [&](int when) {
    while (align == when && data.size() % 4 != 0) data += '\0';
  };
  const auto code = [&](std::uint32_t c) {
    pad(1);
    put_bytes(data, c, 2, big);
    pad(2);
  };
  code(127);
  put_real(data, 1.5f, big);
  code(129);
  for (const std::uint32_t x : {7u, 1u, 4u, 0u, 0u, 10u, 0u, 10u, 65535u, 0u, 0u}) put_bytes(data, x, 2, big);
  code(130);
  for (const std::uint32_t x : {0xFFFFFFFFu, 0u, 3u}) put_bytes(data, x, 4, big);
  for (const float x : {1.f, 2.f, -3.25f, 4.f, 5.f, 6.f}) put_real(data, x, big);
  code(128);
  put_bytes(data, 40000, 2, big);
  code(131);
  for (const std::uint32_t x : {3u, 1u, 1u, 2u, 3u, 4u}) put_bytes(data, x, 2, big);
  code(132);
  for (const std::uint32_t x : {4u, 1u}) put_bytes(data, x, 4, big);
  for (const float x : {.5f, 1.f, 2.f, 4.f}) put_real(data, x, big);
  code(130);
  for (const std::uint32_t x : {5u, 2u, 1u}) put_bytes(data, x, 4, big);
  for (const float x : {8.f, 9.f}) put_real(data, x, big);
  pad(1);
  return header + data;
}

}  // namespace

TEST_CASE("slices: the files of the corpus have the figures of the index") {
  struct row {
    const char* file;
    slice_facts facts;
    double first_z, last_z;
  };
  const row rows[] = {{"slices/T_supported.cli", {60, 0, 60, 384, 60, 0, 0, 336, 76.8, 108, 1}, 0, 5.9},
                      {"slices/nugear_coarse.cli", {19, 92, 119, 0, 119, 0, 1484.75675818, 3044.81002412, 0, 10087.4693177, 274.30989007}, 9.9, 26.099998},
                      {"slices/torus_coarse.cli", {10, 10, 10, 0, 10, 0, 11111.6427691, 18585.4460037, 0, 1756170, 82026}, 32, 174}};
  for (const row& r : rows) {
    const std::string path = corpus(r.file);
    if (path.empty()) return skip(std::string("no corpus file ") + r.file);
    CAPTURE(r.file);
    load_report report;
    const slices s = load_slices(path, {.report = &report, .map = true});
    CHECK(report.notes.empty());
    CHECK(report.skipped.empty());
    CHECK(s.units == 1);
    CHECK(s.layers.front().z == r.first_z);
    CHECK(s.layers.back().z == r.last_z);
    const slice_facts f = facts_of(s);
    CHECK(f.layers == r.facts.layers);
    CHECK(f.inner == r.facts.inner);
    CHECK(f.outer == r.facts.outer);
    CHECK(f.open == r.facts.open);
    CHECK(f.positive_outer == r.facts.positive_outer);
    CHECK(f.positive_inner == r.facts.positive_inner);
    CHECK(f.length_inner == doctest::Approx(r.facts.length_inner).epsilon(1e-10));
    CHECK(f.length_outer == doctest::Approx(r.facts.length_outer).epsilon(1e-10));
    CHECK(f.length_open == doctest::Approx(r.facts.length_open).epsilon(1e-10));
    CHECK(f.net_area == doctest::Approx(r.facts.net_area).epsilon(1e-10));
    CHECK(f.first_net_area == doctest::Approx(r.facts.first_net_area).epsilon(1e-10));

    const std::string first = save_slices_text(s);
    CHECK(load_slices_text(first) == s);
    CHECK(save_slices_text(load_slices_text(first)) == first);
    const std::string binary = save_slices_text(s, {.binary = true});
    CHECK(save_slices_text(load_slices_text(binary), {.binary = true}) == binary);
    CHECK(facts_of(load_slices_text(binary)).net_area == doctest::Approx(r.facts.net_area).epsilon(1e-4));
  }
}

TEST_CASE("slices: bad files of the corpus are errors with their lines") {
  CONCINO_CORPUS_OR_SKIP(few_points, "bad/cli_point_count_mismatch.cli");
  CONCINO_CORPUS_OR_SKIP(no_layer, "bad/cli_polyline_before_layer.cli");
  const auto message_of = [](const std::string& path) {
    try {
      load_slices(path);
    } catch (const parse_error& e) {
      return std::to_string(e.line) + " " + e.expected + " | " + e.found;
    }
    return std::string();
  };
  CHECK(message_of(few_points) == "8 8 coordinates of 4 points | 6, and then the end of the line");
  CHECK(message_of(no_layer) == "7 $$LAYER before the first line of a layer | '$$POLYLINE/0,1,4,0,0,1,0,0,1,0,0'");
}

TEST_CASE("slices: units multiply x, y and z; contours are closed; labels name ids") {
  load_report report;
  const slices s = load_slices_text(
      "$$HEADERSTART\n$$ASCII\n$$UNITS/0.5\n$$VERSION/200\n$$DATE/070493\n$$DIMENSION/0,0,0,1,2,3\n$$LABEL/3,a part \n$$LAYERS/1\n$$HEADEREND\n$$GEOMETRYSTART\n"
      "$$LAYER/3\n$$POLYLINE/3,1,4,0,0,1,0,0,1,0,0\n$$POLYLINE/4,0,3,1,1,2,2,3,3\n$$POLYLINE/3,2,3,1,1,2,2,1,1\n$$HATCHES/3,2,0,1,2,3,4,5,6,7\n$$GEOMETRYEND\n",
      {.report = &report});
  CHECK(s.units == 0.5);
  CHECK(s.version == 200);
  CHECK(s.date == "070493");
  CHECK(s.dimension == std::array<double, 6>{0, 0, 0, 1, 2, 3});
  CHECK(s.label_of(3) == "a part");
  CHECK(s.label_of(4).empty());
  REQUIRE(s.layers.size() == 1);
  const slice_layer& layer = s.layers[0];
  CHECK(layer.z == 1.5);
  REQUIRE(layer.outer.size() == 1);
  CHECK(layer.outer.points == std::vector<slice_point>{{0, 0}, {.5, 0}, {0, .5}});
  CHECK(layer.outer.ids == std::vector<std::int32_t>{3});
  CHECK(layer.inner.points == std::vector<slice_point>{{.5, .5}, {1, 1}, {1.5, 1.5}});
  CHECK(layer.open.points == std::vector<slice_point>{{.5, .5}, {1, 1}, {.5, .5}});
  CHECK(layer.hatches.points == std::vector<slice_point>{{0, .5}, {1, 1.5}, {2, 2.5}, {3, 3.5}});
  CHECK(layer.hatches[0].size() == 4);
  REQUIRE(report.notes.size() == 1);
  CHECK(report.notes[0] == "1 closed contours do not repeat their first point at the end; they are closed all the same");
}

TEST_CASE("slices: dialects are read and reported") {
  load_report report;
  const slices s = load_slices_text(
      "\n//a//$$HEADERSTART // units // $$UNITS/2//mm// $$COLOUR/7\r\n$$COLOUR/8\r\nfree text\r\n$$USERDATA/x,9,$$LAYER/1 $$USERDATA/none\r\n$$HEADEREND"
      "\r\n//start//$$LAYER/ 1.5,\r\n$$POLYLINE/ 0, 2,//n// 2 ,\r\n1 , +2,\r\n3e0,4\r\n$$POWER/5\r\n$$HATCHES/1,0\r\n$$POLYLINE/1,1,0\r\n$$END\r\n$$GEOMETRYEND\r\nmore",
      {.report = &report});
  REQUIRE(s.layers.size() == 1);
  CHECK(s.layers[0].z == 3);
  CHECK(s.layers[0].open.points == std::vector<slice_point>{{2, 4}, {6, 8}});
  CHECK(s.layers[0].hatches.size() == 1);
  CHECK(s.layers[0].hatches.points.empty());
  CHECK(s.layers[0].outer[0].empty());
  CHECK(report.skipped == std::vector<std::string>{"what follows the end of the geometry, from line 16 on", "2 unknown commands $$COLOUR",
                                                   "1 parts of the header that are not commands", "1 unknown commands $$POWER", "2 blocks of $$USERDATA"});
  CHECK(report.notes == std::vector<std::string>{"the header has neither $$ASCII nor $$BINARY; the geometry was read as text",
                                                 "the geometry begins without $$GEOMETRYSTART", "the header has no $$LAYERS"});
  load_slices_text(cli_text("$$LAYER/1\n", "$$LAYERS/3\n"), {.report = &report});
  CHECK(report.notes ==
        std::vector<std::string>{"the header has no $$UNITS; coordinates were read as millimetres", "$$LAYERS states 3 layers, but the file has 1"});
  CHECK(load_slices_text(cli_text("")).layers.empty());
}

TEST_CASE("slices: errors name the line") {
  CHECK(error_line("") == 1);
  CHECK(error_line("OFF\n3 1 0\n") == 1);
  CHECK(error_line("$$HEADERSTART\n$$ASCII\n") == 2);
  CHECK(error_line("$$HEADERSTART\n$$UNITS/0\n") == 2);
  CHECK(error_line("$$HEADERSTART\n$$UNITS/inf\n") == 2);
  CHECK(error_line("$$HEADERSTART\n$$UNITS 5\n") == 2);
  CHECK(error_line("$$HEADERSTART\n//\n//\n\n//x\n") == 5);
  CHECK(error_line("$$HEADERSTART\n$$LAYERS/-1\n") == 2);
  CHECK(error_line("$$HEADERSTART\n$$LABEL/1\n") == 2);
  CHECK(error_line("$$HEADERSTART\n$$DIMENSION/1,2,3\n") == 2);
  CHECK(error_line("$$HEADERSTART\n$$HEADEREND\n$$POLYLINE/1,1,0\n") == 3);
  CHECK(error_line(cli_text("$$LAYER/nan\n")) == 6);
  CHECK(error_line(cli_text("$$LAYER/1e308\n", "$$UNITS/10\n")) == 6);
  CHECK(error_line(cli_text("$$LAYER/1 2\n")) == 6);
  CHECK(error_line(cli_text("$$LAYER/1\n$$POLYLINE/0,3,0\n")) == 7);
  CHECK(error_line(cli_text("$$LAYER/1\n$$POLYLINE/0,1,-1\n")) == 7);
  CHECK(error_line(cli_text("$$LAYER/1\n$$POLYLINE/0,1\n")) == 7);
  CHECK(error_line(cli_text("$$LAYER/1\n$$POLYLINE/99999999999,1,0\n")) == 7);
  CHECK(error_line(cli_text("$$LAYER/1\n$$POLYLINE/0,1,1,2,x\n")) == 7);
  CHECK(error_line(cli_text("$$LAYER/1\n$$POLYLINE/0,1,1,2,inf\n")) == 7);
  CHECK(error_line(cli_text("$$LAYER/1\n$$POLYLINE/0,1,1,2,3,4\n")) == 7);
  CHECK(error_line(cli_text("$$LAYER/1\n$$HATCHES/0,1,1,2,3\n")) == 7);
  CHECK(error_line(cli_text("$$LAYER/1\n$$POLYLINE/0,1,1000000000000000000,2,3\n")) == 7);
  CHECK(error_line("$$HEADERSTART\n$$ASCII\n$$HEADEREND\n$$GEOMETRYSTART\n$$LAYER/1\n") == 5);  // no end
  CHECK_THROWS_AS(load_slices("no/such/file.cli"), io_error);
  CHECK_THROWS_AS(load_slices_text(cli_text(""), {.format = format_id(file_format::cli), .progress = [](double, const char*) { return false; }}), cancelled);
}

TEST_CASE("slices: numbers are written back bit by bit, in the units of the file where that is possible") {
  const temporary_folder folder;
  const slices s = sample_slices();
  save_report report;
  save_slices(s, folder / "a.cli", {.report = &report});
  CHECK(report.notes.empty());
  CHECK(report.lost.empty());
  const std::string text = read_file(folder / "a.cli");
  CHECK(text.starts_with("$$HEADERSTART\n$$ASCII\n$$UNITS/0.005\n$$VERSION/200\n$$DATE/070493\n$$DIMENSION/0,0,0,10,10.5,3\n$$LAYERS/3\n$$LABEL/1,part one\n"
                         "$$LABEL/2,supports\n$$HEADEREND\n$$GEOMETRYSTART\n$$LAYER/0\n$$POLYLINE/1,1,5,0,0,2000,0,2000,2100,0,2100,0,0\n"));
  CHECK(load_slices(folder / "a.cli") == s);
  save_slices(load_slices(folder / "a.cli"), folder / "b.cli");
  CHECK(read_file(folder / "b.cli") == text);

  std::mt19937 random(5);
  std::uniform_real_distribution<double> real(-1000, 1000);
  slices any = s;
  any.units = 0.3;
  for (slice_point& p : any.layers[1].open.points) p = {real(random), std::ldexp(real(random), -900)};
  for (int i = 0; i < 500; ++i) any.layers[2].hatches.points.insert(any.layers[2].hatches.points.end(), 2, {real(random), real(random)});
  any.layers[2].hatches.ends.back() += 1000;
  any.layers[0].outer.points[0] = {std::numeric_limits<double>::denorm_min(), -0.0};
  const std::string in_mm = save_slices_text(any, {.report = &report});
  REQUIRE(report.notes.size() == 1);
  const slices back = load_slices_text(in_mm);
  CHECK(back.units == 1);
  CHECK(back.layers == any.layers);
  CHECK(std::signbit(back.layers[0].outer.points[0][1]));
  CHECK(save_slices_text(back, {.report = &report}) == in_mm);
  CHECK(report.notes.empty());
}

TEST_CASE("slices: random numbers in random units are multiples again") {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> real(-1, 1);
  std::size_t num_exact = 0;
  for (int round = 0; round < 2000; ++round) {
    const double units = std::ldexp(1 + std::abs(real(random)), static_cast<int>(random() % 40) - 20);
    const double x = std::ldexp(real(random), static_cast<int>(random() % 40) - 20) * units;
    slices s;
    s.units = units;
    s.layers.emplace_back().z = x;
    save_report report;
    const slices back = load_slices_text(save_slices_text(s, {.report = &report}));
    CHECK(back.layers[0].z == x);
    num_exact += report.notes.empty();
  }
  CHECK(num_exact == 2000);
}

TEST_CASE("slices: binary files, with all commands and alignments and in both byte orders") {
  const slices plain = load_slices_text(binary_text());
  CHECK(plain.units == 0.5);
  REQUIRE(plain.layers.size() == 2);
  CHECK(plain.layers[0].z == 0.75);
  CHECK(plain.layers[0].outer.points == std::vector<slice_point>{{0, 0}, {5, 0}, {5, 32767.5}});
  CHECK(plain.layers[0].outer.ids[0] == 7);
  CHECK(plain.layers[0].inner.points == std::vector<slice_point>{{.5, 1}, {-1.625, 2}, {2.5, 3}});
  CHECK(plain.layers[0].inner.ids[0] == -1);
  CHECK(plain.layers[1].z == 20000);
  CHECK(plain.layers[1].hatches.points == std::vector<slice_point>{{.5, 1}, {1.5, 2}, {.25, .5}, {1, 2}});
  CHECK(plain.layers[1].hatches.ids == std::vector<std::int32_t>{3, 4});
  CHECK(plain.layers[1].open.points == std::vector<slice_point>{{4, 4.5}});
  for (const int align : {0, 1, 2})
    for (const char* after : {"", "\n", "\r\n"})
      for (const bool big : {false, true}) {
        CAPTURE(align);
        CAPTURE(big);
        load_report report;
        CHECK(load_slices_text(binary_text(align, after, big), {.report = &report}) == plain);
        CHECK(report.notes.size() == std::size_t{1} + (align == 2) + (*after != 0) + big);  // one contour does not repeat its first point
      }

  save_report report;
  const std::string saved = save_slices_text(plain, {.report = &report, .binary = true});
  CHECK(report.lost.empty());
  CHECK(load_slices_text(saved) == plain);
  CHECK(save_slices_text(load_slices_text(saved), {.binary = true}) == saved);

  const std::string rounded = save_slices_text(sample_slices(), {.report = &report, .binary = true});
  CHECK(report.lost.empty());  // integers of units
  slices thirds = sample_slices();
  thirds.layers[0].z = 1 / 3.0;
  const std::string third = save_slices_text(thirds, {.report = &report, .binary = true});
  CHECK(report.lost == std::vector<std::string>{"1 numbers were rounded to floats"});
  CHECK(save_slices_text(load_slices_text(third), {.binary = true}) == third);
  CHECK_THROWS_AS(save_slices_text(thirds, {.binary = true, .strict = true}), unsupported);
  thirds.layers[0].z = 1e300;
  CHECK_THROWS_AS(save_slices_text(thirds, {.binary = true}), unsupported);
}

TEST_CASE("slices: errors in binary files name the byte") {
  const std::string text = binary_text();
  const std::size_t begin = text.find("$$HEADEREND") + 11;
  std::string message;
  CHECK(error_line(text.substr(0, text.size() - 1), &message) == 5);
  CHECK(message.find("at byte " + std::to_string(text.size() - 12)) != std::string::npos);
  std::string bad = text;
  bad[begin] = 5;
  CHECK(error_line(bad, &message) == 5);
  CHECK(message.find("at byte " + std::to_string(begin)) != std::string::npos);
  bad = text;
  bad[begin + 6] = 5;  // the second command
  CHECK(error_line(bad, &message) == 5);
  CHECK(message.find("at byte " + std::to_string(begin + 6)) != std::string::npos);
  bad = text;
  bad[begin + 10] = 3;  // a direction
  CHECK(error_line(bad, &message) == 5);
  CHECK(message.find("at byte " + std::to_string(begin + 10)) != std::string::npos);
  bad = text;
  bad.replace(begin + 40, 4, "\xFF\xFF\xFF\xFF");  // the number of points of the second polyline
  CHECK(error_line(bad, &message) == 5);
  CHECK(message.find("instead of 4294967295") != std::string::npos);
  bad = text;
  bad.replace(begin + 2, 4, std::string("\0\0\x80\x7F", 4));  // an infinite z
  CHECK(error_line(bad, &message) == 5);
  CHECK(message.find("finite") != std::string::npos);
  CHECK(error_line(text.substr(0, begin), &message) == 5);  // two layers are stated
  CHECK(error_line("$$HEADERSTART $$BINARY $$HEADEREND") == 0);
}

TEST_CASE("slices: what cannot be written is an error, and changes no file") {
  const temporary_folder folder;
  write_file(folder / "a.cli", "old");
  const auto refused = [&](auto change, const save_options& options = {}) {
    slices s = sample_slices();
    change(s);
    try {
      save_slices(s, folder / "a.cli", options);
    } catch (const invalid_argument&) {
      return read_file(folder / "a.cli") == "old" && folder.num_files() == 1;
    }
    return false;
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(refused([](slices& s) { s.units = 0; }));
  CHECK(refused([](slices& s) { s.units = nan; }));
  CHECK(refused([](slices& s) { s.version = -1; }));
  CHECK(refused([](slices& s) { s.date = "a\nb"; }));
  CHECK(refused([](slices& s) { s.labels[0].text = "a//b"; }));
  CHECK(refused([](slices& s) { s.labels[0].text = " a"; }));
  CHECK(refused([](slices& s) { s.dimension->back() = nan; }));
  CHECK(refused([](slices& s) { s.layers[1].z = nan; }));
  CHECK(refused([](slices& s) { s.layers[1].open.points[0][1] = nan; }));
  CHECK(refused([](slices& s) { s.layers[1].open.ends[0] = 9; }));
  CHECK(refused([](slices& s) { s.layers[1].open.points.push_back({}); }));
  CHECK(refused([](slices& s) { s.layers[1].open.ids.clear(); }));
  CHECK(refused([](slices& s) { s.layers[1].hatches.points.pop_back(), --s.layers[1].hatches.ends[0]; }));
  CHECK_THROWS_AS(save_slices(sample_slices(), folder / "a.cli", {.format = other_slice_format{}}), unsupported);
  CHECK_THROWS_AS(load_slices(folder / "a.cli", {.format = other_slice_format{}}), unsupported);
  CHECK_THROWS_AS(save_slices(sample_slices(), folder / "a.cli", {.progress = [](double, const char*) { return false; }}), cancelled);
  CHECK(read_file(folder / "a.cli") == "old");
}

TEST_CASE("slices: truncated and changed files are read or are errors") {
  std::vector<std::string> texts = {save_slices_text(sample_slices()), save_slices_text(sample_slices(), {.binary = true}), binary_text(), binary_text(1),
                                    binary_text(2, "\n", true)};
  for (const char* file : {"slices/T_supported.cli", "slices/nugear_coarse.cli", "slices/torus_coarse.cli"})
    if (const std::string path = corpus(file); !path.empty()) texts.push_back(read_file(path));
  std::mt19937 random(11);
  for (const std::string& text : texts) {
    for (std::size_t i = 0; i < 10; ++i) CHECK(slices_survive(text.substr(0, text.size() * i / 10)));
    for (int i = 0; i < 100; ++i) CHECK(slices_survive(text.substr(0, random() % text.size())));
    const int rounds = text.size() < 5000 ? 1000 : long_run() ? 1000 : 20;
    for (int i = 0; i < rounds; ++i) {
      std::string changed = text;
      changed[random() % text.size()] = static_cast<char>(random());
      CHECK(slices_survive(changed));
    }
  }
}
