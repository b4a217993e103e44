// Runs a compiler as a process of its own and returns its CPU seconds and peak memory.
#pragma once

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bench {

struct compilation {
  double user_seconds, system_seconds, megabytes;
};

struct precompiled_header {
  compilation cost;
  std::vector<std::string> flags;  // for compilations that use it
};

/// The lines of a file without the empty ones.
inline std::vector<std::string> lines_of(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(path + " cannot be read");
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

struct compiler {
  std::string name, path;

  /// Compiles one file into an object. The driver runs the compiler proper and the assembler as children and waits for them, so the figures of wait4 for
  /// the driver include them: the seconds of all, and the memory of the largest.
  compilation compile(const std::string& source, const std::vector<std::string>& flags, const std::string& object) const {
    std::vector<std::string> words = {path, "-std=c++20", "-I" CONCINO_INCLUDE, "-I" CONCINO_CONCEPTS, "-isystem", CONCINO_EIGEN};
    words.insert(words.end(), flags.begin(), flags.end());
    words.insert(words.end(), {"-c", source, "-o", object});
    std::vector<char*> command;
    for (std::string& word : words) command.push_back(word.data());
    command.push_back(nullptr);
    const ::pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("cannot start a process for the compiler");
    if (child == 0) {
      ::execv(command[0], command.data());
      ::_exit(127);
    }
    int status = 0;
    ::rusage used = {};
    while (::wait4(child, &status, 0, &used) != child)
      if (errno != EINTR) throw std::runtime_error("waiting for the compiler failed");
    if (status != 0) throw std::runtime_error(source + " does not compile with " + name);
    const auto seconds = [](const ::timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
    return {seconds(used.ru_utime), seconds(used.ru_stime), static_cast<double>(used.ru_maxrss) / 1024};
  }

  /// Precompiles the headers <a>|<b>|... as CMake does: one header at `path_of_header` includes all of them, and each file then includes it first.
  precompiled_header precompile(const std::string& headers, std::vector<std::string> flags, const std::string& path_of_header) const {
    std::ofstream out(path_of_header);
    std::istringstream in(headers);
    for (std::string header; std::getline(in, header, '|');) out << "#include " << header << '\n';
    out.close();
    if (!out) throw std::runtime_error(path_of_header + " cannot be written");
    flags.insert(flags.end(), {"-x", "c++-header"});
    const bool is_clang = name.find("clang") != std::string::npos;
    const std::string precompiled = path_of_header + (is_clang ? ".pch" : ".gch");
    const compilation cost = compile(path_of_header, flags, precompiled);
    if (is_clang) return {cost, {"-include-pch", precompiled}};
    return {cost, {"-Winvalid-pch", "-Werror=invalid-pch", "-include", path_of_header}};
  }
};

/// The compilers in the string name=path|name=path. The first one built this program.
inline std::vector<compiler> compilers_of(const std::string& list) {
  std::vector<compiler> all;
  std::istringstream in(list);
  for (std::string word; std::getline(in, word, '|');) {
    const auto end = word.find('=');
    all.push_back({word.substr(0, end), word.substr(end + 1)});
  }
  return all;
}

}  // namespace bench
