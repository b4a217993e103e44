// Reads and writes mesh files in all formats of <concino/io/formats.hpp>, slices (CLI), curve skeletons, and functions
// on verts or polys as text.
#pragma once

#include <concino/io/atomic_file.hpp>
#include <concino/io/cell_builder.hpp>
#include <concino/io/field.hpp>
#include <concino/io/file_contents.hpp>
#include <concino/io/file_text.hpp>
#include <concino/io/flat_mesh.hpp>
#include <concino/io/format.hpp>
#include <concino/io/format_id.hpp>
#include <concino/io/formats.hpp>
#include <concino/io/hedra.hpp>
#include <concino/io/hybrid.hpp>
#include <concino/io/iv.hpp>
#include <concino/io/load.hpp>
#include <concino/io/load_any.hpp>
#include <concino/io/material_table.hpp>
#include <concino/io/medit.hpp>
#include <concino/io/numbers.hpp>
#include <concino/io/obj.hpp>
#include <concino/io/off.hpp>
#include <concino/io/options.hpp>
#include <concino/io/ply.hpp>
#include <concino/io/save.hpp>
#include <concino/io/skeleton.hpp>
#include <concino/io/skeleton_graph.hpp>
#include <concino/io/slice_layer.hpp>
#include <concino/io/slices.hpp>
#include <concino/io/stl.hpp>
#include <concino/io/tet.hpp>
#include <concino/io/text_cursor.hpp>
#include <concino/io/text_sink.hpp>
#include <concino/io/vtk.hpp>
#include <concino/io/vtp.hpp>
#include <concino/io/vtu.hpp>
#include <concino/io/write_context.hpp>
