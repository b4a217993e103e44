// Damaged files of the corpus: every reader returns something valid or throws a typed error, whatever was cut off or changed, in less than 1 GiB of memory.
// Sanitizers check this too. The long run cuts off every file at each tenth and at 100 random bytes, and changes 1,000 random bytes, one at a time, of each
// file up to 100 kB. The short run takes the same cuts of files up to 10 kB, each tenth and 5 random bytes of those up to 150 kB, and changes 1,000 bytes of
// files up to 1.5 kB and 200 of those up to 5 kB.
#include <concino/io/load.hpp>
#include <concino/io/skeleton.hpp>
#include <concino/io/slices.hpp>

#include <concino/io/detail/obj/read_mtl.hpp>
#include <concino/io/detail/values/read_field.hpp>

#include <support/corpus.hpp>
#include <support/memory_limit.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <random>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// A file of the corpus, and what reads it. `read` throws what the reader throws.
struct corpus_text {
  std::string path;
  void (*read)(std::string_view, format_id);
  format_id format;
  std::string text;
};

template<class Arrays>
bool holds_surface_or_volume(std::string_view text, format_id format) {
  try {
    load_text<Arrays>(text, format);
  } catch (const unsupported&) {
    return false;
  }
  return true;
}
void read_any_mesh(std::string_view text, format_id format) {
  if (!holds_surface_or_volume<surface_arrays>(text, format)) load_text<polyhedra_arrays>(text, format);
}
void read_any_skeleton(std::string_view text, format_id format) { load_skeleton_text(text, {.format = format}); }
void read_any_slices(std::string_view text, format_id) { load_slices_text(text); }
void read_any_field(std::string_view text, format_id) {
  concino::detail::read_field(text, "text", {.count = 8447}, [](const concino::detail::file_field_value&) {});  // as tri/sphere.obj has verts
}
void read_any_library(std::string_view text, format_id) {
  concino::detail::material_library library;
  load_report report;
  concino::detail::read_mtl(text, "text", library, report);
}

/// The files of the corpus in all formats of the library, meshes and others, up to a size.
std::vector<corpus_text> corpus_texts(std::size_t largest) {
  std::vector<corpus_text> all;
  if (corpus_dir().empty()) return all;
  const auto add = [&](const std::filesystem::path& path, void (*read)(std::string_view, format_id), format_id format = {}) {
    std::ifstream in(path, std::ios::binary);
    all.push_back({path.string(), read, format, {std::istreambuf_iterator<char>(in), {}}});
  };
  const auto add_if = [&](const std::filesystem::path& path, auto format, void (*read)(std::string_view, format_id)) {
    if (std::any_of(std::begin(format.extensions), std::end(format.extensions), [&](std::string_view e) { return path.extension() == e; })) add(path, read, format);
  };
  for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus_dir())) {
    if (!entry.is_regular_file() || entry.file_size() > largest) continue;
    [&]<class... F>(format_list<F...>) { (add_if(entry.path(), F{}, read_any_mesh), ...); }(standard_formats);
    add_if(entry.path(), file_format::cg, read_any_skeleton);
    add_if(entry.path(), file_format::skel, read_any_skeleton);
    if (entry.path().extension() == ".cli") add(entry.path(), read_any_slices);
    if (entry.path().extension() == ".mtl") add(entry.path(), read_any_library);
    if (entry.path().filename() == "sphere_greatcircle_from_v0.txt") add(entry.path(), read_any_field);
  }
  std::sort(all.begin(), all.end(), [](const corpus_text& a, const corpus_text& b) { return a.path < b.path; });
  return all;
}

/// Whether a text is read, or refused by an error of a documented type. The memory ends at the end of the text.
bool is_read_or_refused(const corpus_text& file, std::string_view text) {
  const std::unique_ptr<char[]> exact(new char[text.size()]);
  std::copy(text.begin(), text.end(), exact.get());
  try {
    file.read({exact.get(), text.size()}, file.format);
  } catch (const parse_error& e) {
    return e.line >= 1;
  } catch (const unsupported&) {
  } catch (const invalid_mesh&) {
  }
  return true;
}

}  // namespace

TEST_CASE("damaged corpus: files cut off at each tenth and at random bytes") {
  const auto all = corpus_texts(long_run() ? ~std::size_t{0} : 150'000);
  if (all.empty()) return skip("no corpus");
  const memory_limit one_gib(std::size_t{1} << 30);
  std::mt19937 random(31);
  std::size_t cuts = 0;
  for (const corpus_text& file : all) {
    CAPTURE(file.path);
    const auto cut_at = [&](std::size_t size) {
      CHECK(is_read_or_refused(file, std::string_view(file.text).substr(0, size)));
      ++cuts;
    };
    for (std::size_t k = 0; k < 10; ++k) cut_at(file.text.size() * k / 10);
    const std::size_t n = long_run() || file.text.size() < 10'000 ? 100 : 5;
    for (std::size_t k = 0; k < n && !file.text.empty(); ++k) cut_at(random() % file.text.size());
  }
  if (long_run()) CHECK(cuts >= 10'000);
  CHECK(!one_gib.was_exceeded());
}

TEST_CASE("damaged corpus: small files with one changed byte") {
  const auto all = corpus_texts(long_run() ? 100'000 : 5'000);
  if (all.empty()) return skip("no corpus");
  const memory_limit one_gib(std::size_t{1} << 30);
  std::mt19937 random(32);
  for (const corpus_text& file : all) {
    CAPTURE(file.path);
    const int changes = long_run() || file.text.size() < 1'500 ? 1000 : 200;
    std::string text = file.text;
    for (int k = 0; k < changes && !text.empty(); ++k) {
      char& changed = text[random() % text.size()];
      const char before = changed;
      changed = static_cast<char>(random());
      CHECK(is_read_or_refused(file, text));
      changed = before;
    }
  }
  CHECK(!one_gib.was_exceeded());
}

TEST_CASE("damaged corpus: numbers replaced by huge or negative ones") {
  const auto all = corpus_texts(5'000);
  if (all.empty()) return skip("no corpus");
  const memory_limit one_gib(std::size_t{1} << 30);
  std::mt19937 random(33);
  for (const corpus_text& file : all) {
    CAPTURE(file.path);
    std::vector<std::size_t> numbers;  // where they begin
    for (std::size_t i = 1; i < file.text.size(); ++i)
      if (file.text[i] >= '0' && file.text[i] <= '9' && (file.text[i - 1] == ' ' || file.text[i - 1] == '\n')) numbers.push_back(i);
    for (int k = 0; k < 100 && !numbers.empty(); ++k) {
      std::string text = file.text;
      const std::size_t from = numbers[k < 12 && static_cast<std::size_t>(k) < numbers.size() ? static_cast<std::size_t>(k) : random() % numbers.size()];
      const std::size_t to = std::min(text.find_first_of(" \r\n", from), text.size());
      const char* const huge[] = {"4294967294", "4294967295", "999999999999999999", "18446744073709551616", "-1", "-9223372036854775808", "1e308"};
      text.replace(from, to - from, huge[random() % std::size(huge)]);
      CHECK(is_read_or_refused(file, text));
    }
  }
  CHECK(!one_gib.was_exceeded());
}
