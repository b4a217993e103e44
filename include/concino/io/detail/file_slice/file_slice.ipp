// Bodies of file_slice.hpp: cuts slices out of binary mesh files.
#pragma once

#include <concino/core/error.hpp>
#include <concino/io/detail/file_slice/file_slice.hpp>
#include <concino/io/detail/medit/medit_sections.hpp>
#include <concino/io/detail/vtk_xml/vtk_signature.hpp>
#include <concino/io/file_text.hpp>

namespace concino::detail {

CONCINO_INLINE file_slice slice_of_file(const std::string& path, slice_choice choice, const load_options& options) {
  if (choice.slice >= choice.num_slices)
    core::throw_joined<invalid_argument>(
        {"load_slice: there is no slice ", choice.slice, " of ", choice.num_slices, "; slices count from 0"});
  if (options.repeated_verts != repeated_verts::refuse || options.corners_only)
    core::throw_joined<invalid_argument>(
        {"load_slice: options.repeated_verts and corners_only change the numbers of polys or verts; load the whole "
         "file"});
  file_text file(path, {.map = true});
  file_slice slice;
  slice.is_medit = is_binary_medit(file.text());
  if (slice.is_medit) cut_medit(file.text(), path, choice, slice);
  else if (is_vtk_xml(file.text(), "UnstructuredGrid")) cut_vtu(file.text(), path, choice, options.inflate, slice);
  else
    core::throw_joined<unsupported>(
        {path, ": slices are read of binary .vtu and .meshb files; convert it by save(m, path, {.binary = true})"});
  slice.name =
      choice.only_verts ? path : core::joined({path, " (slice ", choice.slice, " of ", choice.num_slices, ")"});
  file.close(path);
  return slice;
}

}  // namespace concino::detail
