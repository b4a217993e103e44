// Damaged files of the corpus: readers return a mesh or throw a typed error, whatever was cut off or changed. Sanitizers check this too.
#include <concino/io/load.hpp>

#include <support/corpus.hpp>
#include <support/formats.hpp>

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

/// A file of the corpus in a format of the library.
struct corpus_text {
  std::string path;
  format_id format;
  std::string text;
};

std::vector<corpus_text> corpus_texts(std::size_t largest) {
  std::vector<corpus_text> all;
  if (corpus_dir().empty()) return all;
  const auto add = [&](const std::filesystem::path& path, auto format) {
    if (std::none_of(std::begin(format.extensions), std::end(format.extensions), [&](std::string_view e) { return path.extension() == e; })) return;
    std::ifstream in(path, std::ios::binary);
    all.push_back({path.string(), format, {std::istreambuf_iterator<char>(in), {}}});
  };
  for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus_dir()))
    if (entry.is_regular_file() && entry.file_size() <= largest)
      [&]<class... F>(format_list<F...>) { (add(entry.path(), F{}), ...); }(standard_formats);
  std::sort(all.begin(), all.end(), [](const corpus_text& a, const corpus_text& b) { return a.path < b.path; });
  return all;
}

/// Reads a surface, or else a volume. The memory ends at the end of the text.
bool is_read_or_refused(std::string_view text, format_id format) {
  const std::unique_ptr<char[]> exact(new char[text.size()]);
  std::copy(text.begin(), text.end(), exact.get());
  const auto outcome = [&](auto read) {
    try {
      read();
    } catch (const parse_error& e) {
      return e.line >= 1;
    } catch (const unsupported&) {
    } catch (const invalid_mesh&) {
    }
    return true;
  };
  return outcome([&] { load_text<surface_arrays>({exact.get(), text.size()}, format); }) &&
         outcome([&] { load_text<polyhedra_arrays>({exact.get(), text.size()}, format); });
}

std::size_t largest_file() { return long_run() ? 5'000'000 : 150'000; }

}  // namespace

TEST_CASE("damaged corpus: files cut off at each tenth and at random bytes") {
  const auto all = corpus_texts(largest_file());
  if (all.empty()) return skip("no corpus");
  std::mt19937 random(31);
  for (const corpus_text& file : all) {
    CAPTURE(file.path);
    for (std::size_t k = 0; k < 10; ++k) CHECK(is_read_or_refused(std::string_view(file.text).substr(0, file.text.size() * k / 10), file.format));
    const std::size_t cuts = long_run() || file.text.size() < 10'000 ? 100 : 5;
    for (std::size_t k = 0; k < cuts && !file.text.empty(); ++k)
      CHECK(is_read_or_refused(std::string_view(file.text).substr(0, random() % file.text.size()), file.format));
  }
}

TEST_CASE("damaged corpus: small files with one changed byte") {
  const auto all = corpus_texts(long_run() ? 100'000 : 5'000);
  if (all.empty()) return skip("no corpus");
  std::mt19937 random(32);
  for (const corpus_text& file : all) {
    CAPTURE(file.path);
    const int changes = long_run() || file.text.size() < 1'500 ? 1000 : 200;
    for (int k = 0; k < changes && !file.text.empty(); ++k) {
      std::string text = file.text;
      text[random() % text.size()] = static_cast<char>(random());
      CHECK(is_read_or_refused(text, file.format));
    }
  }
}

TEST_CASE("damaged corpus: numbers replaced by huge or negative ones") {
  const auto all = corpus_texts(5'000);
  if (all.empty()) return skip("no corpus");
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
      CHECK(is_read_or_refused(text, file.format));
    }
  }
}
