// Finds the mesh files of the corpus, real ones or the small ones of tests/small_corpus, and skips test cases whose files are missing.
#pragma once

#include <doctest/doctest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

namespace concino::testing {

#ifdef _WIN32
/// A path that converts to std::string, as that of the standard library does on other systems.
struct corpus_path : std::filesystem::path {
  using std::filesystem::path::path;
  corpus_path(std::filesystem::path p) : std::filesystem::path(std::move(p)) {}
  operator std::string() const { return generic_string(); }
};
#else
using corpus_path = std::filesystem::path;
#endif

/// Reports that the running test case is skipped. doctest cannot skip at run time, so the case returns, and test.sh counts the line.
/// Use: `if (!ready) return skip("why");`
inline void skip(const std::string& why) {
  const auto* test = doctest::getContextOptions()->currentTest;
  std::printf("SKIPPED: %s: %s\n", test ? test->m_name : "?", why.c_str());
  std::fflush(stdout);
}

/// The folder $CONCINO_CORPUS, else ../shared/data beside the source tree, else tests/small_corpus, which is part of the repository.
inline std::filesystem::path corpus_dir() {
  const char* named = std::getenv("CONCINO_CORPUS");
  const std::filesystem::path dir = named && *named ? named : CONCINO_TEST_DEFAULT_CORPUS;
  std::error_code none;
  return std::filesystem::is_directory(dir, none) ? dir : std::filesystem::path(CONCINO_TEST_SMALL_CORPUS);
}

/// The path of a file or folder of the corpus, such as "tri/bunny.obj"; empty if it is absent.
inline corpus_path corpus(const std::filesystem::path& file) {
  const std::filesystem::path path = corpus_dir() / file;
  std::error_code none;
  return std::filesystem::exists(path, none) ? path : std::filesystem::path();
}

/// Whether tests run in their long form (more rounds, larger meshes), as with `./test.sh --long`.
inline bool long_run() {
  const char* asked = std::getenv("CONCINO_LONG");
  return asked && *asked && std::string(asked) != "0";
}

/// How many random meshes of each kind the tests of graph algorithms look at.
inline unsigned num_random_meshes() { return long_run() ? 1000 : 200; }

}  // namespace concino::testing

/// Declares `name` as the path of a file of the corpus, or skips the running test case by its name.
#define CONCINO_CORPUS_OR_SKIP(name, file)                                       \
  const ::concino::testing::corpus_path name = ::concino::testing::corpus(file); \
  if (name.empty()) return ::concino::testing::skip("no corpus file " file)
