// What may be asked of load and save, and what they tell beside the mesh.
#pragma once

#include <concino/core/progress.hpp>
#include <concino/io/format_id.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace concino {

/// What a reader did not take as it stood. One sentence an entry.
struct load_report {
  std::size_t reoriented_polys = 0;  // cells whose verts were put into the standard order or whose faces were turned outward
  std::vector<std::string> skipped;  // in the file, not in the mesh
  std::vector<std::string> notes;    // anything else worth knowing
};

/// What a writer could not say in the format. One sentence an entry.
struct save_report {
  std::vector<std::string> lost;   // in the mesh, not in the file
  std::vector<std::string> notes;  // anything else worth knowing
};

struct load_options {
  format_id format = {};                   // one of the formats that the call knows; by default the extension says which
  concino::load_report* report = nullptr;  // filled in if given; cleared first
  concino::progress progress = {};         // told the fraction of the file read
  /// Files are mapped into memory, not read: loading is about a tenth faster, but a file that shrinks meanwhile may end the program by
  /// SIGBUS. Read files cannot; both are an io_error where the size is another at the end.
  bool map = false;
};

struct save_options {
  format_id format = {};                   // one of the formats that the call knows; by default the extension says which
  concino::save_report* report = nullptr;  // filled in if given; cleared first
  concino::progress progress = {};         // told the fraction of the elements written
  bool binary = false;                     // .off: 32-bit numbers, so coordinates are rounded to floats; unsupported by formats without a binary form
  bool sync = false;                       // what is written reaches the disk before it replaces a file; else the system decides when
};

/// Of what writes a file and has nothing else to choose.
struct file_options {
  bool sync = false;  // as in save_options
};

}  // namespace concino
