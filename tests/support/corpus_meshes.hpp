// All meshes of the corpus in the formats that concino reads, with their known measures.
#pragma once

#include <concino/io/load_any.hpp>

#include <support/corpus.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

namespace concino::testing {

/// A row of INDEX.tsv.
struct corpus_row {
  std::filesystem::path file;
  std::string name;
  double area = 0, volume = 0;  // columns area_vec and volume_ctr; 0 where empty
  std::map<std::string, std::string> column = {};  // every column, by its name
};

/// The rows whose files can be read, without files that are broken on purpose; empty without a corpus.
inline std::vector<corpus_row> corpus_meshes() {
  std::vector<corpus_row> rows;
  const auto index = corpus("INDEX.tsv");
  if (index.empty()) return rows;
  std::ifstream in(index);
  std::string line;
  std::vector<std::string> names;
  const auto split = [](const std::string& text) {
    std::vector<std::string> cells;
    std::stringstream s(text);
    for (std::string cell; std::getline(s, cell, '\t');) cells.push_back(cell);
    return cells;
  };
  while (std::getline(in, line)) {
    const auto cells = split(line);
    if (names.empty()) {
      names = cells;
      continue;
    }
    const auto cell = [&](const char* name) {
      const auto i = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
      return i < cells.size() ? cells[i] : std::string();
    };
    const auto number = [&](const char* name) {
      double x = 0;
      std::istringstream(cell(name)) >> x;
      return x;
    };
    const std::filesystem::path path = corpus(cell("path"));
    const auto extension = path.extension();
    if (cell("path").rfind("bad/", 0) == 0) continue;  // broken files, for tests of readers
    if (extension == ".obj" || extension == ".off" || extension == ".mesh" || extension == ".hedra") {
      rows.push_back({path, cell("path"), number("area_vec"), number("volume_ctr")});
      for (const std::string& name : names) rows.back().column[name] = cell(name.c_str());
    }
  }
  return rows;
}

/// Calls f(mesh) for the meshes whose files are small, in long runs for most.
template<class F>
void for_each_small_corpus_mesh(const F& f) {
  for (const corpus_row& row : corpus_meshes()) {
    if (std::filesystem::file_size(row.file) > (long_run() ? 3000000 : 100000)) continue;
    CAPTURE(row.name);
    std::visit(f, load_any(row.file.string()));
  }
}

}  // namespace concino::testing
