// Readers never crash, hang, read out of bounds or return an invalid mesh, whatever the text. Sanitizers check this too.
#include <concino/io/load.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>

using namespace concino;

namespace {

std::size_t fuzz_rounds() {
  const char* const asked = std::getenv("CONCINO_LONG");
  return asked && *asked && std::string(asked) != "0" ? 40000 : 2000;
}

struct seed {
  format_id format;
  std::string text;
};

/// A tet in a binary MEDIT file of version 2, with a triangle, a ridge and a corner.
std::string binary_medit(bool big) {
  std::string text;
  const auto put = [&](std::initializer_list<std::int32_t> numbers) {
    for (const std::int32_t x : numbers)
      for (unsigned k = 0; k < 4; ++k) text += static_cast<char>(x >> 8 * (big ? 3 - k : k) & 0xff);
  };
  const auto section = [&](std::int32_t code, std::int32_t n, std::initializer_list<std::int32_t> numbers) {
    put({code, static_cast<std::int32_t>(text.size() + 12 + 4 * numbers.size()), n});
    put(numbers);
  };
  put({1, 2, 3, 20, 3});
  put({4, static_cast<std::int32_t>(text.size() + 12 + 4 * 28), 4});
  for (int v = 0; v < 4; ++v) {
    for (int k = 1; k < 4; ++k)  // 1.0 or 0.0
      if (big) put({v == k ? 0x3ff00000 : 0, 0});
      else put({0, v == k ? 0x3ff00000 : 0});
    put({v});
  }
  section(6, 1, {1, 3, 2, 5});
  section(5, 1, {1, 2, 0});
  section(8, 1, {1, 2, 3, 4, 7});
  section(14, 1, {1});
  section(13, 1, {4});
  put({54, 0});
  return text;
}

/// A triangle in a binary file of Gmsh of version 4.1, with an entity of a group and values.
std::string binary_gmsh(bool big) {
  std::string text = "$MeshFormat\n4.1 1 4\n";
  const auto put = [&](unsigned bytes, std::initializer_list<std::uint64_t> numbers) {
    for (const std::uint64_t x : numbers)
      for (unsigned k = 0; k < bytes; ++k) text += static_cast<char>(x >> 8 * (big ? bytes - 1 - k : k) & 0xff);
  };
  const std::uint64_t one = std::uint64_t{0x3ff} << 52;
  put(4, {1});
  text += "\n$EndMeshFormat\n$Entities\n";
  put(4, {0, 0, 1, 0, 1}), put(8, {0, 0, 0, one, one, 0}), put(4, {1, 3, 0});
  text += "\n$EndEntities\n$Nodes\n";
  put(4, {1, 4, 1, 9, 2, 1, 0, 4, 1, 2, 3, 9}), put(8, {0, 0, 0, one, 0, 0, one, one, 0, 0, one, 0});
  text += "\n$EndNodes\n$Elements\n";
  put(4, {1, 2, 1, 2, 2, 1, 2, 2, 1, 1, 2, 3, 2, 1, 3, 9});
  text += "\n$EndElements\n$ElementData\n1\n\"v\"\n0\n3\n0\n1\n1\n";
  put(4, {2}), put(8, {one});
  return text + "\n$EndElementData\n";
}

const seed seeds[] = {
    {file_format::obj,
     "# cube corner\nv 0 0 0\nv 1.5 0 0 1.0\nv 0 1e0 0\nv 0 0 .25\nvt 0 1\nvn 0 0 1\nusemtl a\ng b c\nf 1 3 2\nf 1/1 2/1 4/1\nf -3//1 3//1 "
     "\\\n-1//-1\nf 1/1/1 4/1/1 3/1/1\nl 1 2\n"},
    {file_format::obj, "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nv 0.12345678901234567 2 3\r\nf 1 2 3 4\r\nf 1 2 3\r\nf 5 4 3 2 1\r\n"},
    {file_format::obj,
     "mtllib a.mtl b.mtl\no a b\nv 0 0 0 1 0.5 0\nv 1 0 0\nv 0 1 0 0 0 1\ng label_1\nf 1 2 3\ng label_-2\\\n\nusemtl color_1\nf 3 2 1\ng x "
     "# c\nusemtl\nf 1 "
     "3 2\n"},
    {file_format::off,
     "# c\nOFF\n4 4 6 # e\n0 0 0\n1.5 0 0\n0 1e0 0\n0 0 .25 1\n3 0 2 1 7\n3 0 1 3 255 0 51\n4 0 1 2 3 0.5 0 1 1.0 # c\n3 1\n2 3\n"},
    {file_format::off,
     "STCN4nOFF\n3\n3 1\n0 0 0 1 0 0 1 1 0 0 1 .5 .5\n1 0 0 1 0 0 1 0.5 0 0 1 0 0\n0 1 0 2 0 0 1 255 0 0 1 1 1\n3 0 1 2\n"},
    {file_format::off, "4 2 0 0 0 0 1 0 0 1 1 0 0 1 0 4 0 1 2 3 3 0 1 2"},
    {file_format::off, std::string("COFF BINARY\n\0\0\0\3\0\0\0\1\0\0\0\0", 24) + std::string(84, '\0') +
                           std::string("\0\0\0\3\0\0\0\0\0\0\0\1\0\0\0\2\0\0\0\3\x3f\x80\0\0\0\0\0\0\0\0\0\0", 32)},
    {file_format::medit,
     "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n0 0 0 0\n1 0 0 1\n0 1 0 0\n0 0 1 0\n1 1 1 2\nEdges 1\n1 2 0\nTriangles 1\n1 2 3 "
     "0\nTetrahedra\n2\n1 2 3 4 7\n2 3 4 5 0\nEnd\n"},
    {file_format::medit,
     "MeshVersionFormatted 1 Dimension 3 # c\nHexahedra 1 1 2 3 4 5 6 7 8 0\nVertices 10 0 0 0 0 1 0 0 0 1 1 0 0 0 1 0 0\n0 0 1 0 1 0 1 0 "
     "1 1 1 0 0 1 1 0\n.5 .5 2 0 2 0 0 0\n"
     "Pyramids 1 5 6 7 8 9 1\nPrisms 1 1 2 3 5 6 7 2 Tetrahedra 1 1 2 10 9 0\nEnd"},
    {file_format::medit,
     "MeshVersionFormatted 1\nDimension\n2\nVertices\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\nTriangles 1\n1 2 3 0\nQuadrilaterals\n1\n1 2 3 4 "
     "0\nEnd"},
    {file_format::medit,
     "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\nEdges 2\n1 2 3\n3 1 0\nTriangles 1\n1 3 2 4\nCorners 1\n2\nRidges 1\n2\n"
     "RequiredTriangles 1\n1\nNormals 1\n0 0 1\nNormalAtVertices 1\n4 1\nTetrahedra 1\n1 2 3 4 0\nEnd\n"},
    {file_format::medit, binary_medit(false)},
    {file_format::medit, binary_medit(true)},
    {file_format::hedra,
     "5 7 2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 -1\n3 1 3 2\n3 1 2 4\n3 2 3 4\n3 1 4 3\n3 1 2 5\n3 2 3 5\n3 1 3 5\n4 1 2 3 4\n4 -1 5 6 -7\n"},
    {file_format::iv,
     "#Inventor V2.1 ascii\n# c\nSeparator {\n  DEF p Coordinate3 { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0, ] }\n  IndexedFaceSet { coordIndex [ 0, 1, 2, "
     "-1, 0, 2, 3 ] materialIndex [ 1, 2 ] }\n  Separator { VertexProperty { vertex [0 0 1,1 0 1,.5 1 1] }\n IndexedFaceSet { coordIndex [0,1,2,-1] } }\n  USE p\n "
     " Label { label \"a \\\" }\" }\n  IndexedFaceSet { vertexProperty VertexProperty { vertex [ 5 5 5 6 5 5 5 6 5 6 6 5] } coordIndex [ 0 1 3 2 -1 ] } }\n"},
    {file_format::tet, "5 vertices\n2 tets\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n4 0 1 2 3\n4 1 3 2 4\n"},
    {file_format::tet,
     "10 vertices 5 cells # c\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n.5 .5 2\n2 0 0\n8 0 1 2 3 4 5 6 7\n5 4 5 7 6 8\n# C 4 5 7 6\n6 1 5 9 3 7 2\n"
     "4 9 1 3 8\n"},
    {file_format::hybrid,
     "5 7 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 -1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n3 0 1 4\n3 1 2 4\n3 0 2 4\n4 0 1 2 3\n4 1 1 1 1\n4 0 4 5 "
     "6\n4 0 1 1 0\n0\n0\n"},
    {file_format::vtk,
     "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nFIELD f 1\nT 1 1 double\n.5\nPOINTS 9 float\n0 0 0 1 0 0 1 1 0 0 1 0\n0 0 1 1 0 1 1 1 1 0 1 1\n.5 .5 2\n"
     "CELLS 6 51\n8 0 1 2 3 4 5 6 7\n22 5 4 4 5 6 7 3 4 5 8 3 5 6 8 3 6 7 8 3 4 7 8\n4 0 1 2 3\n1 8\n4 0 1 3 4\n6 0 1 2 4 5 6\nCELL_TYPES 6\n12 42 9 1 10 13\n"
     "CELL_DATA 6\nSCALARS s int 1\nLOOKUP_TABLE default\n1 2 3 4 5 6\nPOINT_DATA 9\nFIELD FieldData 2\na 1 9 float\n1 2 3 4 5 6 7 8 9\nb 1 9 bit\n1 0 1 0 1 0 1 0 1\nMETADATA\nX\n\n"},
    {file_format::vtk,
     "# vtk DataFile Version 5.1\nt\nASCII\nDATASET POLYDATA\nPOINTS 5 double\n0 0 0 1 0 0 1 1 0 0 1 0\n0 0 1\nVERTICES 2 1\nOFFSETS vtktypeint64\n0 1\nCONNECTIVITY vtktypeint64\n4\nPOLYGONS 3 "
     "7\nOFFSETS vtktypeint64\n0 3 7\nCONNECTIVITY vtktypeint64\n0 1 4 0 1 2 3\nTRIANGLE_STRIPS 1 5\n4 0 1 3 2\nCELL_DATA 4\nNORMALS n float\n0 0 1 0 0 1 0 0 1 0 0 1\nCOLOR_SCALARS c 3\n0 0 1 0 0 1 0 0 1 0 0 1\n"},
    {file_format::vtk, std::string("# vtk DataFile Version 3.0\nt\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n") + std::string("\0\0\0\0\0\0\0\0\0\0\0\0\x3f\x80\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x3f\x80\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x3f\x80\0\0", 48) +
                           "\nCELLS 1 5\n" + std::string("\0\0\0\4\0\0\0\0\0\0\0\1\0\0\0\2\0\0\0\3", 20) + "\nCELL_TYPES 1\n" + std::string("\0\0\0\x0a", 4) +
                           "\nPOINT_DATA 4\nFIELD f 2\nb 1 4 bit\n" + "P" + "\ns 1 2 string\n\xc1x\xc1y\nSCALARS q unsigned_char 1\nLOOKUP_TABLE default\nabcd"},
    {file_format::vtu,
     "<?xml version='1.0'?>\n<!-- c -->\n<VTKFile type=\"UnstructuredGrid\">\n<UnstructuredGrid><Piece NumberOfPoints=\"9\" NumberOfCells=\"3\">\n<Points><DataArray type=\"Float32\" NumberOfComponents='3' "
     "format=\"ascii\">0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1 .5 .5 2</DataArray></Points><Cells>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 3 4 5 6 7 4 5 6 7 8 0 1 2"
     "</DataArray><DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">8 13 16</DataArray><DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">12 42 5</DataArray><DataArray type=\"Int64\" "
     "Name=\"faces\" format=\"ascii\">5 4 4 5 6 7 3 4 5 8 3 5 6 8 3 6 7 8 3 4 7 8</DataArray><DataArray type=\"Int64\" Name=\"faceoffsets\" format=\"ascii\">-1 22 -1</DataArray></Cells>\n<CellData>"
     "<DataArray type=\"Int8\" Name=\"a&lt;\" format=\"ascii\">1 2 3</DataArray><DataArray type=\"UInt8\" Name=\"vtkGhostType\" format=\"ascii\">0 0 1</DataArray></CellData></Piece>\n<Piece "
     "NumberOfPoints=\"3\" NumberOfCells=\"1\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"binary\">SAAAAA==AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA8D8AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAADwPwAAAAAAAAAA"
     "</DataArray></Points><Cells><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2</DataArray><DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3</DataArray><DataArray "
     "type=\"UInt8\" Name=\"types\" format=\"ascii\">5</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>"},
    {file_format::vtp, std::string("<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\"><PolyData><Piece NumberOfPoints=\"3\" NumberOfPolys=\"1\"><PointData TCoords=\"t\"><DataArray type=\"UInt8\" Name=\"t\" "
                                   "NumberOfComponents=\"2\" format=\"appended\" offset=\"44\"/></PointData><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"appended\" "
                                   "offset=\"0\"/></Points><Polys><DataArray type=\"UInt8\" Name=\"connectivity\" format=\"appended\" offset=\"54\"/><DataArray type=\"UInt8\" Name=\"offsets\" format=\"appended\" "
                                   "offset=\"61\"/></Polys></Piece></PolyData><AppendedData encoding=\"raw\">_") +
                           std::string("\x24\0\0\0" "\0\0\0\0\0\0\0\0\0\0\0\0" "\0\0\x80\x3f\0\0\0\0\0\0\0\0" "\0\0\0\0\0\0\x80\x3f\0\0\0\0" "abcd" "\6\0\0\0" "\1\2\3\4\5\6" "\3\0\0\0" "\0\1\2" "\1\0\0\0" "\3", 66) +
                           "</AppendedData></VTKFile>"},
    {file_format::ply,
     "ply\nformat ascii 1.0\ncomment TextureFile a.png\nelement vertex 5\nproperty float x\nproperty float y\nproperty double z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
     "property float v_x\nproperty float v_y\nelement face 2\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\nproperty list short char tags\nelement edge 1\n"
     "property int vertex1\nproperty int vertex2\nproperty short k\nelement tristrips 1\nproperty list int int vertex_indices\nelement x 1\nproperty list char int a%62\nend_header\n"
     "0 0 0 1 2 3 .5 nan\n1 0 0 1 2 3 1 2\n1 1 0 0 0 0 0 0\n0 1e0 0 9 9 9 1 1\n.5 .5 2 255 0 0 1 1\n4 0 1 2 3 8 0 0 1 0 1 1 0 1 1 -5\n3 0 1 4 0 2 7 8\n1 0 9\n6 0 1 4 -1 2 3\n1 5\n"},
    {file_format::ply, std::string("ply\r\nformat binary_big_endian 1.0\r\nelement vertex 3\r\nproperty float x\r\nproperty float y\r\nproperty short z\r\nelement face 1\r\n"
                                   "property list uchar ushort vertex_index\r\nproperty list uchar double w\r\nend_header\r\n") +
                           std::string("\0\0\0\0\0\0\0\0\0\0\x3f\x80\0\0\0\0\0\0\0\0\0\0\0\0\x3f\x80\0\0\0\1\3\0\0\0\1\0\2\1\x3f\xf0\0\0\0\0\0\0", 46)},
    {file_format::stl, "solid a b\nfacet normal 0 0 nan\nouter loop\nvertex 0 0 0\nvertex 1.5 0 0\nvertex 0 1e0 .25\nendloop\nendfacet\nendsolid\nsolid\nfacet normal 0 0 1\nouter loop\n"
                       "vertex -0 0 0\nvertex 1.5 0 0\nvertex 5 5 5\nendloop\nendfacet\nendsolid\n"},
    {file_format::ovm, "OVM ASCII # c\nVertices\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 .25\nEdges\n7\n0 1\n1 2\n2 0\n0 3\n1 3\n2 3\n3 0\nFaces\n4\n3 5 3 1\n3 0 8 7\n3 2 10 9\n3 6 11 4\nPolyhedra\n1\n"
                       "4 0 2 5 6\nVProp string \"a b\"\n0:\n3:#\n:\n1:x\n2:yy\nEProp double \"d\"\n0 1 2 3 4 5 nan\nHEProp bool \"b\"\n0 1 0 1 0 1 0 1 0 1 0 1 0 1\n"
                       "FProp vec3d \"normal\"\n0 0 1 0 0 1 0 0 1 0 0 1\nCProp vector_double \"v\"\n2 3 4\nCProp vector_vh \"w\"\n1 2\nMProp char \"c\"\n#\n"},
    {file_format::stl, "solid" + std::string(75, ' ') + std::string("\1\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0\7\1", 54)},
    {file_format::gmsh,
     "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 7 \"a b\"\n$EndPhysicalNames\n$Entities\n1 1 1 1\n4 0 0 0 1 5\n2 0 0 0 1 0 0 1 -8 2 4 -5\n1 0 0 0 1 1 0 2 5 6 1 2\n"
     "7 0 0 0 1 1 1 1 7 2 1 2\n$EndEntities\n$PartitionedEntities\n2\n1\n5 1\n0 0 1 0\n3 2 1 1 2 0 0 0 1 1 1 1 9 0\n$EndPartitionedEntities\n$Nodes\n2 5 3 90\n3 7 0 4\n10\n20\n7\n90\n"
     "0 0 0\n1 0 0\n0 1 0\n0 0 1\n2 1 1 1\n3\n0 0 -1 .5 .25\n$EndNodes\n$Elements\n5 6 1 90\n0 4 15 1\n1 10\n1 2 1 1\n2 20 10\n2 1 2 1\n90 7 20 10\n2 3 2 1\n5 10 20 90\n3 7 4 2\n"
     "8 10 20 7 90\n9 10 7 20 3\n$EndElements\n$NodeData\n1\n\"t\"\n1\n0.5\n3\n0\n3\n2\n10 1 2 3\n3 4 5 6\n$EndNodeData\n$ElementData\n1\n\"e\"\n0\n3\n0\n1\n3\n8 1\n90 2\n2 3\n"
     "$EndElementData\n$Periodic\n0\n$EndPeriodic\n"},
    {file_format::gmsh, "$Comments\nx\n$EndComments\n$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n9 0 0 1\n$EndNodes\n$Elements\n5\n1 2 2 4 1 1 2 3\n"
                        "2 2 2 5 1 1 2 3\n3 3 4 6 2 1 2 1 2 9 3\n4 1 1 9 1 2\n5 15 0 9\n$EndElements\n"},
    {file_format::gmsh, binary_gmsh(false)},
    {file_format::gmsh, binary_gmsh(true)},
    {file_format::smesh, "# a tent\n5 3 1 1\n1 0 0 0 .5 1\n2 1 0 0 0 2\n3 1 1 0 0 3\n4 0 1 0 0 4\n5 0 0 1e0 0 -5\n3 1\n4 1 2\n 3 4 -7 # the floor\n3 1 2 5 8\n2 4 1\n1\n1 .5 .5 .1\n1\n1 .2 .2 .2 5 0.1\n"},
    {file_format::poly, "5 3 0 1\n0 0 0 0 1\n1 1 0 0 2\n2 1 1 0 3\n3 0 1 0 4\n4 0 0 1 5\n3 1\n1 0 -7\n4 0 1 2 3\n2 0 8\n3 0 1 4\n3 3 0 4\n2 0 9\n3 2 1 4\n2 2 4\n0\n"},
    {file_format::abaqus, "*NODE, NSET=all\n1, 0, 0\n2, 1, 0\n3, 1, 1D0\n 400 , 0, 1,\n*Element, type = s4r,\n elset=\"a b\"\n1, 1, 2,\n3, 400\n** c\n*ELEMENT, TYPE=S3\n2, 1, 2, 3\n*NSET,NSET=n,GENERATE\n1,3,2\n*ELSET,ELSET=e\na b, 2\n"},
    {file_format::abaqus, "*PART,NAME=p\n*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n*ELEMENT,TYPE=C3D8\n1,1,2,3,4,5,6,7,8\n*END PART\n*ASSEMBLY\n*INSTANCE,NAME=i,PART=P\n"
                          "0,0,0\n*END INSTANCE\n*NSET,NSET=a,INSTANCE=I\n1\n*ELSET,ELSET=b\ni.1\n"},
};

bool holds_together(const surface_arrays& a) {
  if (a.arity ? !a.offsets.empty() || a.verts.size() % a.arity
              : a.offsets.empty() || a.offsets.front() != 0 || a.offsets.back() != a.verts.size())
    return false;
  for (std::size_t i = 1; i < a.offsets.size(); ++i)
    if (a.offsets[i] < a.offsets[i - 1] + 3) return false;
  return std::all_of(a.verts.begin(), a.verts.end(), [&](vert_id v) { return v.raw() < a.points.size(); });
}
bool holds_together(const cell_arrays& a) {
  return (a.arity == 4 || a.arity == 8) && a.verts.size() % a.arity == 0 &&
         std::all_of(a.verts.begin(), a.verts.end(), [&](vert_id v) { return v.raw() < a.points.size(); });
}
bool holds_together(const polyhedra_arrays& a) {
  return !a.face_offsets.empty() && !a.poly_offsets.empty() && a.face_offsets.back() == a.face_verts.size() &&
         a.poly_offsets.back() == a.poly_faces.size() && a.outward.size() == a.poly_faces.size() &&
         std::all_of(a.face_verts.begin(), a.face_verts.end(), [&](vert_id v) { return v.raw() < a.points.size(); }) &&
         std::all_of(a.poly_faces.begin(), a.poly_faces.end(), [&](face_id f) { return f.raw() < a.num_faces(); });
}

/// Whether reading M gives a valid mesh, a parse_error in a line of the text, or `unsupported`. The memory ends at the end of the text.
template<class M>
bool survives(const std::string& text, format_id format) {
  const std::unique_ptr<char[]> exact(new char[text.size()]);
  std::copy(text.begin(), text.end(), exact.get());
  try {
    const M m = load_text<M>({exact.get(), text.size()}, format);
    for (const vec3& p : m.points)
      if (!is_finite(p)) return false;
    return holds_together(m);
  } catch (const parse_error& e) {
    const auto lines = static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; })) + 1;
    return e.line >= 1 && e.line <= lines;
  } catch (const unsupported&) {
    return true;
  }
}

/// Reads a text as a volume, or as a surface if it holds one.
void load_any_arrays(const std::string& text, format_id format) {
  try {
    load_text<polyhedra_arrays>(text, format);
  } catch (const unsupported&) {
    load_text<surface_arrays>(text, format);
  }
}

bool survives_all(const std::string& text, format_id format) {
  return survives<surface_arrays>(text, format) && survives<cell_arrays>(text, format) && survives<polyhedra_arrays>(text, format);
}

}  // namespace

TEST_CASE("fuzz: the files of .vtk, .vtu, .vtp, .ply, .stl, .msh, .ovm, .smesh, .poly and .inp that are changed below are valid") {
  for (const seed& s : seeds)
    for (const format_id f : {format_id(file_format::vtk), format_id(file_format::vtu), format_id(file_format::vtp), format_id(file_format::ply), format_id(file_format::stl),
                              format_id(file_format::gmsh), format_id(file_format::ovm), format_id(file_format::smesh), format_id(file_format::poly),
                              format_id(file_format::abaqus)})
      if (s.format == f) CHECK_NOTHROW(load_any_arrays(s.text, f));
}

TEST_CASE("fuzz: every truncation of a file is read or is an error") {
  for (const seed& s : seeds)
    for (std::size_t n = 0; n <= s.text.size(); ++n) CHECK(survives_all(s.text.substr(0, n), s.format));
}

TEST_CASE("fuzz: files with changed, removed and repeated bytes are read or are errors") {
  std::mt19937 random(20);
  const auto below = [&](std::size_t n) { return n ? static_cast<std::size_t>(random()) % n : 0; };
  const std::string likely("0123456789-+.eE/\\#\n\r\t vf\0\x80nai", 29);
  std::size_t failed = 0;
  for (std::size_t round = 0; round < fuzz_rounds(); ++round) {
    const seed& s = seeds[round % std::size(seeds)];
    std::string text = s.text;
    for (std::size_t k = 1 + below(4); k > 0 && !text.empty(); --k) {
      const std::size_t at = below(text.size()), n = 1 + below(12);
      switch (below(5)) {
        case 0:
          text[at] = static_cast<char>(random());
          break;
        case 1:
          text[at] = likely[below(likely.size())];
          break;
        case 2:
          text.erase(at, n);
          break;
        case 3:
          text.insert(at, text.substr(below(text.size()), n));
          break;
        default:
          text.insert(at, 1 + below(20), likely[below(10)]);
      }
    }
    if (below(8) == 0) text.resize(below(text.size() + 1));
    if (!survives_all(text, s.format)) {
      ++failed;
      FAIL_CHECK(text);
    }
  }
  CHECK(failed == 0);
}

TEST_CASE("fuzz: a text in another format, or an empty one, is read or is an error") {
  for (const seed& s : seeds)
    for (const format_id f : standard_formats.ids()) CHECK(survives_all(s.text, f));
  std::mt19937 random(4);
  for (const format_id f : standard_formats.ids())
    for (int i = 0; i < 200; ++i) {
      std::string noise(static_cast<std::size_t>(i), ' ');
      for (char& c : noise) c = static_cast<char>(random());
      CHECK(survives_all(noise, f));
    }
}
