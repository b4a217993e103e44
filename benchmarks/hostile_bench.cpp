// Measures files that are constructed to take long: the seconds per megabyte to load, to validate and to check the laws. No input may take more than 5 s per
// megabyte plus 1 s, even with the address sanitizer (build with -DCMAKE_CXX_FLAGS=-fsanitize=address). An input that takes longer is stopped and fails the
// program. Checking the laws takes as long as visiting all neighbours of all elements, so it is skipped where these are many more than the bytes of the file.
// The files of the folder $CONCINO_CORPUS are measured too, unchanged and damaged.
#include "support/program.hpp"

#include <concino/concepts/facets.hpp>
#include <concino/io.hpp>
#include <concino/validate.hpp>

#include <array>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>

namespace {

namespace file_format = concino::file_format;
using concino::format_id;

struct input {
  std::string name;
  format_id format;
  std::string text;
  std::size_t bytes = 0;  // of the text and of the other files of this input
};

std::string operator""_s(const char* s, std::size_t n) { return {s, n}; }
std::string str(std::size_t i) { return std::to_string(i); }

/// n points in general position.
std::string points(std::size_t n, const char* head, const char* tail) {
  std::mt19937 random(7);
  std::string s;
  for (std::size_t i = 0; i < n; ++i) {
    s += head;
    for (int k = 0; k < 3; ++k) s += str(random() % 1000) + (k < 2 ? " " : "");
    s += tail;
  }
  return s;
}
std::string medit(std::size_t verts, const std::string& cells, std::size_t n) {
  return "MeshVersionFormatted 2\nDimension 3\nVertices " + str(verts) + "\n" + points(verts, "", " 0\n") + "Tetrahedra " + str(n) + "\n" + cells + "End\n";
}

std::vector<input> inputs(const bench::program& p) {
  const auto size = [&](std::size_t n) { return p.data.tiny ? std::max<std::size_t>(n / 100, 8) : n; };
  std::vector<input> all;
  const auto add = [&](const char* name, format_id f, std::string text, std::size_t more = 0) {
    const std::size_t bytes = text.size() + more;
    all.push_back({name, f, std::move(text), bytes});
  };
  std::string s;
  {
    const std::size_t n = size(20'000);
    s.clear();
    for (std::size_t i = 0; i < n; ++i) s += "1 2 3 " + str(i + 4) + " 0\n";
    add("tets_on_one_face", file_format::medit, medit(n + 3, s, n));
  }
  {
    const std::size_t n = size(32'000);
    s.clear();
    for (std::size_t i = 0; i < n; ++i) s += "1 2 " + str(2 * i + 3) + " " + str(2 * i + 4) + " 0\n";
    add("tets_on_one_edge", file_format::medit, medit(2 * n + 2, s, n));
  }
  {
    const std::size_t n = size(1'600);
    s = points(3, "v ", "\n");
    for (std::size_t i = 0; i < n; ++i) s += "f 1 2 3\n";
    add("equal_triangles", file_format::obj, s);
    s = points(n + 2, "v ", "\n");
    for (std::size_t i = 0; i < 10 * n; ++i) s += "f 1 2 " + str(i % n + 3) + "\n";
    add("triangles_on_one_edge", file_format::obj, s);
    s = points(2 * n + 1, "v ", "\n");
    for (std::size_t i = 0; i < 10 * n; ++i) s += "f 1 " + str(2 * (i % n) + 2) + " " + str(2 * (i % n) + 3) + "\n";
    add("triangles_at_one_vert", file_format::obj, s);
  }
  {
    const std::size_t n = size(300'000);
    s = "OFF " + str(n) + " 1 0\n" + points(n, "", "\n") + str(n);
    for (std::size_t i = 0; i < n; ++i) s += " " + str(i);
    add("polygon_of_many_verts", file_format::off, s + "\n");
  }
  {
    const std::size_t n = size(35'000);
    s = str(n + 2) + " " + str(2 * n) + " 1\n" + points(n + 2, "", "\n");
    for (std::size_t i = 0; i < n; ++i)
      for (const std::size_t apex : {n + 1, n + 2}) s += "3 " + str(apex) + " " + str(i + 1) + " " + str((i + 1) % n + 1) + "\n";
    s += str(2 * n);
    for (std::size_t i = 0; i < 2 * n; ++i) s += (i % 2 ? " -" : " ") + str(i + 1);
    add("polyhedron_of_many_faces", file_format::hedra, s + "\n");
  }
  {
    const std::size_t n = size(50'000);
    s = str(n) + " 1 " + str(n) + "\n" + points(n, "", "\n") + str(n);
    for (std::size_t i = 0; i < n; ++i) s += " " + str(i + 1);
    s += "\n";
    for (std::size_t i = 0; i < n; ++i) s += "1 1\n";
    add("polyhedra_on_one_large_face", file_format::hedra, s);
  }
  {
    const std::size_t n = size(2'000);
    std::string library;
    for (std::size_t i = 0; i < n; ++i) library += "newmtl m" + str(i) + "\nKd 0.5 0.5 0.5\n";
    std::FILE* const f = std::fopen(p.file("a.mtl").c_str(), "w");
    if (!f || std::fwrite(library.data(), 1, library.size(), f) != library.size() || std::fclose(f) != 0) throw std::runtime_error("cannot write a.mtl");
    s.clear();
    for (std::size_t i = 0; i < n; ++i) s += "mtllib a.mtl\n";
    add("one_library_many_times", file_format::obj, s + points(3, "v ", "\n") + "usemtl m1\nf 1 2 3\n", library.size());
    s = "mtllib";
    for (std::size_t i = 0; i < 50 * n; ++i) s += " b" + str(i);
    add("many_missing_libraries", file_format::obj, s + "\n" + points(3, "v ", "\n") + "usemtl m1\nf 1 2 3\n");
  }
  {
    const std::size_t n = size(60'000);
    const auto face = [](std::size_t i) { return "f " + str(i + 1) + " " + str(i + 2) + " " + str(i + 3) + "\n"; };
    s = "g " + std::string(8 * n, 'g') + "\n" + points(n + 2, "v ", "\n");
    for (std::size_t i = 0; i < n; ++i) s += face(i);
    add("long_name_of_many_polys", file_format::obj, s);
    s = points(n + 2, "v ", "\n");
    for (std::size_t i = 0; i < n; ++i) s += "usemtl " + str(i) + "\n" + face(i);
    add("many_names", file_format::obj, s);
    s = "mtllib bad.mtl\n" + points(3, "v ", "\n") + "usemtl m\nf 1 2 3\n";
    std::string library = "newmtl m\n";
    for (std::size_t i = 0; i < 2 * n; ++i) library += "Kd x\n";
    std::FILE* const f = std::fopen(p.file("bad.mtl").c_str(), "w");
    if (!f || std::fwrite(library.data(), 1, library.size(), f) != library.size() || std::fclose(f) != 0) throw std::runtime_error("cannot write bad.mtl");
    add("library_of_bad_lines", file_format::obj, s, library.size());
  }
  {
    const std::size_t n = size(1'000'000);
    add("long_line", file_format::obj, "# " + std::string(n, 'x') + "\n" + points(3, "v ", "\n") + "f 1 2 3\n");
    add("long_number", file_format::off, "OFF 3 1 0\n0." + std::string(n, '1') + " 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    add("blank_lines", file_format::off, "OFF 3 1 0\n" + std::string(n, '\n') + points(3, "", "\n") + "3 0 1 2\n");
    s.clear();
    for (std::size_t i = 0; i < n / 2; ++i) s += "\\\n";
    add("joined_lines", file_format::obj, points(3, "v ", "\n") + "f 1 2 " + s + "3\n");
    s = "MeshVersionFormatted 2 Dimension 3 Vertices 3 " + points(3, "", " 0\n");
    for (std::size_t i = 0; i < n / 16; ++i) s += "Tetrahedra 0\nX" + str(i % 10) + " 1\n";
    add("many_sections", file_format::medit, s + "Triangles 1 1 2 3 0 End");
    s = "OFF 1000 " + str(n / 20) + " 0\n" + points(1000, "", "\n");
    for (std::size_t i = 0; i < n / 20; ++i) s += i % 2 ? "3 0 1\n2\n" : "4 5 6\n7 8\n";
    add("polys_over_two_lines", file_format::off, s);
  }
  for (const char* count : {"999999", "4294967294", "4294967295", "999999999999999999"}) {
    add("huge_count", file_format::off, "OFF "_s + count + " " + count + " 0\n");
    add("huge_poly", file_format::off, "OFF 3 1 0\n" + points(3, "", "\n") + count + " 0 1 2\n");
    add("huge_count", file_format::medit, "MeshVersionFormatted 2 Dimension 3 Vertices "_s + count + " 0 0 0 0");
    add("huge_count", file_format::hedra, ""_s + count + " " + count + " " + count + "\n0 0 0\n");
  }
  return all;
}

struct seconds {
  double load = 0, laws = 0;
};

/// An upper bound of the number of neighbours and corners of all polys: a facet with k polys counts k^2, and its verts k times.
template<class M>
double num_neighbours(const M& m) {
  double sum = 0;
  for (const auto x : concino::facets(m)) {
    const auto k = static_cast<double>(concino::num_elements(concino::adj_facet2p(m, x)));
    sum += k * (k + static_cast<double>(concino::num_elements(concino::adj_facet2v(m, x))));
  }
  return sum;
}

seconds measure(const input& in, const std::string& path) {
  seconds s;
  const double start = bench::process_seconds();
  try {
    const auto any = concino::load_any(path, {.format = in.format});
    std::visit(
        [&](const auto& m) {
          (void)concino::validate(m);
          s.load = bench::process_seconds() - start;
          if (num_neighbours(m) > 100 * (static_cast<double>(in.bytes) + 1e6)) return;
          const double before = bench::process_seconds();
          (void)concino::check_laws(m);
          s.laws = bench::process_seconds() - before;
        },
        any);
  } catch (const concino::error&) {  // damaged files may be refused
    if (s.load == 0) s.load = bench::process_seconds() - start;
  }
  return s;
}

/// Runs in a process of its own, which is stopped when it takes more than `limit` for both.
bool measure_apart(const input& in, const std::string& path, double limit, seconds& result) {
  int ends[2];
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
  const ::pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    const auto most = static_cast<::rlim_t>(2 * limit + 1);
    const ::rlimit cpu{most, most};
    ::setrlimit(RLIMIT_CPU, &cpu);
    int code = 1;
    try {
      const seconds s = measure(in, path);
      code = ::write(ends[1], &s, sizeof s) == sizeof s ? 0 : 1;
    } catch (const std::exception& e) {
      std::fprintf(stderr, "%s: %s\n", in.name.c_str(), e.what());
    }
    ::_exit(code);
  }
  ::close(ends[1]);
  const bool answered = ::read(ends[0], &result, sizeof result) == sizeof result;
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  return answered && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Changes digits, pieces and the end of a text at random.
std::string damaged(std::string text, std::mt19937& random) {
  if (text.empty()) return text;
  const auto place = [&] { return static_cast<std::size_t>(random()) % text.size(); };
  for (std::size_t i = 0; i < 3 + text.size() / 2000; ++i) {
    const std::size_t at = place();
    if (text[at] >= '0' && text[at] <= '9') text[at] = static_cast<char>('0' + random() % 10);
  }
  const std::size_t from = place(), n = std::min<std::size_t>(random() % 2000, text.size() - from);
  if (random() % 2) text.insert(place(), text.substr(from, n));
  if (random() % 4 == 0) text.resize(place());
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    std::size_t exceeded = 0, refused = 0;
    const auto run = [&](const input& in, bool quiet) {
      const std::string path = p.file("input");
      std::FILE* const f = std::fopen(path.c_str(), "wb");
      if (!f || std::fwrite(in.text.data(), 1, in.text.size(), f) != in.text.size() || std::fclose(f) != 0) throw std::runtime_error("cannot write " + path);
      const double megabytes = static_cast<double>(in.bytes) / 1e6, limit = 5 * megabytes + 1;
      seconds s;
      const bool ended = measure_apart(in, path, limit, s);
      if (!ended || s.load > limit || s.laws > limit) {
        ++exceeded;
        if (ended) std::fprintf(stderr, "hostile.%s: %.2f MB: load and validate %.2f s, check_laws %.2f s; the limit is %.2f s\n", in.name.c_str(), megabytes, s.load, s.laws, limit);
        else std::fprintf(stderr, "hostile.%s: %.2f MB: stopped after %.0f s; the limit is %.2f s\n", in.name.c_str(), megabytes, 2 * limit + 1, limit);
      } else if (!quiet) {
        p.print({{"hostile." + in.name, "concino", "s", s.load, 1}});
        if (s.laws > 0) p.print({{"hostile.laws." + in.name, "concino", "s", s.laws, 1}});
      }
    };
    for (const input& in : inputs(p))
      if (p.wants("hostile." + in.name)) run(in, false);

    const char* const corpus = std::getenv("CONCINO_CORPUS");
    if (corpus && *corpus && p.wants("hostile.corpus")) {
      std::mt19937 random(1);
      std::size_t files = 0;
      for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus)) {
        if (!entry.is_regular_file() || entry.file_size() > (p.data.tiny ? 20'000u : 1'000'000u)) continue;
        input in{"corpus." + entry.path().filename().string(), file_format::by_extension, {}};
        try {
          in.format = concino::standard_formats.ids()[concino::detail::chosen_for(entry.path().string(), concino::standard_formats, {})];
        } catch (const concino::unsupported&) {
          ++refused;
          continue;
        }
        std::FILE* const f = std::fopen(entry.path().c_str(), "rb");
        if (!f) continue;
        in.text.resize(entry.file_size());
        in.text.resize(std::fread(in.text.data(), 1, in.text.size(), f));
        std::fclose(f);
        const std::string whole = in.text;
        ++files;
        for (int i = 0; i <= (p.data.tiny ? 1 : 4); ++i) {
          in.bytes = in.text.size();
          run(in, true);
          in.text = damaged(whole, random);
        }
      }
      std::fprintf(stderr, "%zu files of the corpus measured, %zu of other formats skipped\n", files, refused);
    }
    if (exceeded) throw std::runtime_error(str(exceeded) + " inputs take more than 5 s per megabyte plus 1 s");
  });
}
