// Where the tests find real mesh files, which are no part of this repository, and how a test that cannot run is skipped by name.
#pragma once

#include <doctest/doctest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace concino::testing {

/// Says that the running test case does not test anything here. doctest has no such thing at run time: the case returns after this and
/// test.sh counts the line. Use: `if (!ready) return skip("why");`
inline void skip(const std::string& why) {
  const auto* test = doctest::getContextOptions()->currentTest;
  std::printf("SKIPPED: %s: %s\n", test ? test->m_name : "?", why.c_str());
  std::fflush(stdout);
}

/// $CONCINO_CORPUS, else ../shared/data beside the source tree; empty where there is none.
inline std::filesystem::path corpus_dir() {
  const char* named = std::getenv("CONCINO_CORPUS");
  const std::filesystem::path dir = named && *named ? named : CONCINO_TEST_DEFAULT_CORPUS;
  std::error_code none;
  return std::filesystem::is_directory(dir, none) ? dir : std::filesystem::path();
}

/// A file or folder of the corpus, such as "tri/bunny.obj"; empty where it is absent.
inline std::filesystem::path corpus(const std::filesystem::path& file) {
  const std::filesystem::path dir = corpus_dir();
  std::error_code none;
  return !dir.empty() && std::filesystem::exists(dir / file, none) ? dir / file : std::filesystem::path();
}

/// Whether `./test.sh --long` asked for the long form of tests that have one (more rounds, larger meshes).
inline bool long_run() {
  const char* asked = std::getenv("CONCINO_LONG");
  return asked && *asked && std::string(asked) != "0";
}

}  // namespace concino::testing

/// Declares `name` as the path of a file of the corpus, or skips the running test case by its name.
#define CONCINO_CORPUS_OR_SKIP(name, file)                                    \
  const std::filesystem::path name = ::concino::testing::corpus(file);        \
  if (name.empty()) return ::concino::testing::skip("no corpus file " file)
