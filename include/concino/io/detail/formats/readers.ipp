// Compiles the readers of all formats into the compiled library.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/io/detail/abaqus/read_abaqus.hpp>
#include <concino/io/detail/gmsh/read_gmsh.hpp>
#include <concino/io/detail/hedra/read_hedra.hpp>
#include <concino/io/detail/hybrid/read_hybrid.hpp>
#include <concino/io/detail/iv/read_iv.hpp>
#include <concino/io/detail/medit/read_medit.hpp>
#include <concino/io/detail/obj/read_obj.hpp>
#include <concino/io/detail/off/read_off.hpp>
#include <concino/io/detail/openfoam/read_openfoam.hpp>
#include <concino/io/detail/ovm/read_ovm.hpp>
#include <concino/io/detail/ply/read_ply.hpp>
#include <concino/io/detail/pvtu/read_pvtu.hpp>
#include <concino/io/detail/stl/read_stl.hpp>
#include <concino/io/detail/tet/read_tet.hpp>
#include <concino/io/detail/tetgen/read_ele.hpp>
#include <concino/io/detail/tetgen/read_smesh.hpp>
#include <concino/io/detail/vtk/read_vtk.hpp>
#include <concino/io/detail/vtk_xml/read_vtp.hpp>
#include <concino/io/detail/vtk_xml/read_vtu.hpp>

#ifdef CONCINO_COMPILED
namespace concino {

template void hedra_format::read<volume_contents>(const read_context&, volume_contents&);
template void openfoam_format::read<volume_contents>(const read_context&, volume_contents&);
template void tet_format::read<volume_contents>(const read_context&, volume_contents&);
template void hybrid_format::read<volume_contents>(const read_context&, volume_contents&);
template void ovm_format::read<volume_contents>(const read_context&, volume_contents&);
template void medit_format::read<file_contents>(const read_context&, file_contents&);
template void medit_format::read<volume_contents>(const read_context&, volume_contents&);
template void vtk_format::read<file_contents>(const read_context&, file_contents&);
template void vtk_format::read<volume_contents>(const read_context&, volume_contents&);
template void vtu_format::read<file_contents>(const read_context&, file_contents&);
template void vtu_format::read<volume_contents>(const read_context&, volume_contents&);
template void pvtu_format::read<file_contents>(const read_context&, file_contents&);
template void pvtu_format::read<volume_contents>(const read_context&, volume_contents&);
template void gmsh_format::read<file_contents>(const read_context&, file_contents&);
template void gmsh_format::read<volume_contents>(const read_context&, volume_contents&);
template void ele_format::read<volume_contents>(const read_context&, volume_contents&);
template void abaqus_format::read<file_contents>(const read_context&, file_contents&);
template void abaqus_format::read<volume_contents>(const read_context&, volume_contents&);

// The readers are inline. Taking their addresses makes the compiler emit them here.
namespace {
[[gnu::used]] void (*const readers[])(const read_context&, file_contents&) = {&iv_format::read, &obj_format::read,
                                                                              &off_format::read, &ply_format::read,
                                                                              &stl_format::read, &vtp_format::read,
                                                                              &smesh_format::read, &poly_format::read};
}  // namespace

}  // namespace concino
#endif
