// What reading and writing files needs of the operating system. Two files define it: posix_files.ipp for POSIX systems,
// and standard_files.ipp, which needs the standard library only, for all others. No other header of this module calls
// the system.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/files/file_handle.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace concino::detail {

enum class file_kind { none, regular, folder, pipe, other };

/// What the system says about a file. Two are equal if they are of the same file, which has not changed in between.
struct file_status {
  file_kind kind = file_kind::none;
  std::uint64_t size = 0;                    // in bytes; 0 if unknown
  std::uint64_t device = 0, number = 0;      // identify the file
  std::int64_t seconds = 0, nanoseconds = 0;  // the time at which it was written
  bool operator==(const file_status&) const = default;
};

/// The status of the file at that path, or of the file that a link there refers to. The kind is none if there is no
/// file, and errno is the reason.
file_status status_of(const std::string& path);
/// The same, but a link is a file of another kind.
file_status status_of_link(const std::string& path);
/// The status of an open file. The path must be that with which it was opened.
file_status status_of(file_handle file, const std::string& path);

// Where these functions return no_file, false, null or a number below 0, they have failed, and errno is the reason.

/// Opens a file to read it. Opening a pipe does not wait for a writer.
file_handle open_to_read(const std::string& path);
/// Lets read_some() wait for the writer of a pipe.
bool wait_for_writer(file_handle file);
/// Reads up to n bytes.      Result: how many; 0 at the end of the file, and below 0 if it cannot be read.
std::ptrdiff_t read_some(file_handle file, char* to, std::size_t n);
/// Writes n bytes.      Result: whether all are written.
bool write_all(file_handle file, const char* from, std::size_t n);
void close_file(file_handle file) noexcept;
/// Removes a file, or a link.
bool remove_file(const std::string& path) noexcept;
/// Gives a file another name in the same folder; a file of that name is replaced.      Result: whether it has it.
bool rename_file(const std::string& path, const std::string& new_path) noexcept;
/// Creates a folder in an existing one.      Result: whether there is a new folder.
bool create_folder(const std::string& path);
/// Removes a folder if it is empty.
bool remove_folder(const std::string& path) noexcept;

/// Maps a file of n > 0 bytes, which stays open. Needs: can_map_files.      Result: its bytes, or null.
const char* map_file(file_handle file, std::size_t n);
void unmap_file(const char* bytes, std::size_t n) noexcept;

/// The path with `/` between folders.
std::string with_slashes(const std::string& path);
/// The absolute path of an existing file with all links followed; empty if there is none.
std::string real_path(const std::string& path);
/// The path that a link refers to; empty if there is no link.
std::string link_target(const std::string& path);

/// Closes a file at the end of a scope.
class open_file {
  file_handle file_;

 public:
  explicit open_file(file_handle file) : file_(file) {}
  open_file(const open_file&) = delete;
  open_file& operator=(const open_file&) = delete;
  ~open_file() {
    if (file_ != no_file) close_file(file_);
  }
  file_handle handle() const { return file_; }
  bool is_open() const { return file_ != no_file; }
  /// The handle, which the caller closes.
  file_handle release() { return std::exchange(file_, no_file); }
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/io/detail/files/posix_atomic_file.ipp>
#include <concino/io/detail/files/posix_files.ipp>
#include <concino/io/detail/files/standard_files.ipp>
#include <concino/io/detail/files/standard_folders.ipp>
#endif
