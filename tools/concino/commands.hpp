// The commands of the program and their options. Each returns the exit code.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace program {

/// What the program returns.
enum exit_code : int { done = 0, defects_found = 1, wrong_usage = 2, unreadable_input = 3, not_written = 4 };

/// Ends the program with a message.
struct failure {
  exit_code code;
  std::string message;
};

struct info_options {
  std::string file;
  bool json = false;
};
struct validate_options {
  std::string file;
  bool all = false;
};
struct convert_options {
  std::string from, to, kind;
  bool strict = false, binary = false, as_triangles = false, as_boundary = false, corners_only = false;
};
struct repair_options {
  std::string from, to;
  std::optional<double> merge;
  std::size_t fill = 0;
  bool orient = false, split = false, collapse = false, remove_intersecting = false;
};
enum class picture_quality { draft, normal, print };
struct render_options {
  std::string file, to, field, slice;
  bool edges = false;
  std::size_t width = 1600, height = 1200;
  picture_quality quality = picture_quality::normal;
};
struct harmonic_options {
  std::string file, to;
  std::vector<std::pair<std::size_t, double>> values;  // vert and value
};
struct geodesic_options {
  std::string file, to;
  std::vector<std::size_t> from;
};

struct demo_options {
  std::string file, picture;
  bool for_print = false;
};

int info(const info_options& options);
int validate(const validate_options& options);
int convert(const convert_options& options);
int repair(const repair_options& options);
int render(const render_options& options);
int view(const render_options& options);
int harmonic(const harmonic_options& options);
int geodesic(const geodesic_options& options);
int demo(const demo_options& options);

}  // namespace program
