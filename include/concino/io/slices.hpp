// Reads and writes slices of a part for layered manufacturing: files of the Common Layer Interface (.cli), as text or
// binary.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/options.hpp>
#include <concino/io/slice_layer.hpp>

#include <string>
#include <string_view>

namespace concino {

namespace file_format {

/// The name of the format of slices, for messages and options.
struct cli_format {
  static constexpr std::string_view name = "cli";
  static constexpr std::string_view extensions[] = {".cli"};
};
inline constexpr cli_format cli{};

}  // namespace file_format

/// Reads slices from a file of the Common Layer Interface 2.0, text or binary, whatever its extension.
/// Needs:  a file that begins with $$HEADERSTART.
/// Result: the layers, with x, y and z multiplied by the units of the file. The last point of a closed contour is
///         dropped if it repeats the first one; a contour that does not is closed all the same, which options.report
///         notes. So are missing or wrong $$LAYERS, and a missing $$UNITS (1 is assumed). Skipped and reported:
///         $$USERDATA, and commands that are not in the format. Binary files may be aligned ($$ALIGN) after each
///         command or after its code, may have a line end after $$HEADEREND, and may be big-endian.
/// Cost:   one pass over the file. Memory: at most that of the result, and the file.
/// Errors: io_error if the file cannot be read. parse_error with the line, and in binary data with the byte, if it
///         breaks the format: a number that is not finite, more points than the file holds, a line before the first
///         layer, no end of the geometry. unsupported if options.format is another format. cancelled.
slices load_slices(const std::string& path, const load_options& options = {});

/// Reads slices from a string in memory. Messages call the text `name`.
/// Needs:  as load_slices.
/// Result: as load_slices.
/// Cost:   as load_slices.
/// Errors: as load_slices, except io_error.
slices load_slices_text(std::string_view text, const load_options& options = {}, std::string_view name = "text");

/// Writes slices to a file of the Common Layer Interface 2.0, whatever its extension: as text, or binary if
/// options.binary is true.
/// Needs:  slices with units > 0 and finite coordinates; an even number of points in each group of hatches.
/// Result: the complete file, which replaces an existing one. In each layer outer contours come first, then inner ones,
///         open lines and hatches. Text gives back the same numbers: if a coordinate is not a multiple of the units
///         that a double can hold, the file is written in units of 1 mm, which options.report notes. Binary files hold
///         floats; options.report says how many numbers were rounded.
/// Cost:   O(number of points).
/// Errors: invalid_argument for slices that break the needs, and for labels and dates with line ends, $$ or //.
///         unsupported if options.format is another format, if a number is too large for a binary file, or if numbers
///         would be rounded and options.strict is set. io_error if the file cannot be written. cancelled.
void save_slices(const slices& s, const std::string& path, const save_options& options = {});

/// The contents of the file that save_slices writes.
/// Needs:  as save_slices.
/// Result: as save_slices, in memory.
/// Cost:   as save_slices.
/// Errors: as save_slices, except io_error.
std::string save_slices_text(const slices& s, const save_options& options = {});

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/io/detail/slices/slices.ipp>
#endif
