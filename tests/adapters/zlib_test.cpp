#include <concino/adapters/zlib.hpp>
#include <concino/io/load.hpp>
#include <concino/io/save.hpp>
#include <concino/io/vtu.hpp>
#include <concino/mesh/tetmesh.hpp>

#include <support/corpus.hpp>

#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

#include <zlib.h>

using namespace concino;
using namespace concino::testing;

namespace {

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string s(size, '\0');
  compress(reinterpret_cast<Bytef*>(s.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()));
  s.resize(size);
  return s;
}

template<class T>
std::string bytes_of_numbers(const std::vector<T>& all) { return {reinterpret_cast<const char*>(all.data()), all.size() * sizeof(T)}; }

/// An array in blocks of `block` bytes, with the sizes before them as integers of type Word.
template<class Word>
std::string in_blocks(const std::string& bytes, std::size_t block) {
  std::vector<Word> header = {0, static_cast<Word>(block), static_cast<Word>(bytes.size() % block)};
  std::string data;
  for (std::size_t i = 0; i < bytes.size();) {
    const std::string one = deflated(bytes.substr(i, block));
    i += std::min(block, bytes.size() - i);
    ++header[0];
    header.push_back(static_cast<Word>(one.size()));
    data += one;
  }
  return bytes_of_numbers(header) + data;
}

/// One tet, compressed, in appended raw arrays.
template<class Word = std::uint32_t>
std::string compressed_tet(std::size_t block) {
  std::string appended;
  const auto array = [&](const std::string& type, const std::string& name, const std::string& bytes) {
    const std::string tag = "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" + (name == "Points" ? "3" : "1") + "\" format=\"appended\" offset=\"" + std::to_string(appended.size()) + "\"/>";
    appended += in_blocks<Word>(bytes, block);
    return tag;
  };
  const std::string tags = "<Points>" + array("Float64", "Points", bytes_of_numbers<double>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.1})) + "</Points><Cells>" +
                           array("Int64", "connectivity", bytes_of_numbers<std::int64_t>({0, 1, 2, 3})) + array("Int64", "offsets", bytes_of_numbers<std::int64_t>({4})) +
                           array("UInt8", "types", "\x0a") + "</Cells>";
  return "<VTKFile type=\"UnstructuredGrid\" compressor=\"vtkZLibDataCompressor\" header_type=\"UInt" + std::to_string(8 * sizeof(Word)) + "\"><UnstructuredGrid><Piece NumberOfPoints=\"4\" NumberOfCells=\"1\">" + tags +
         "</Piece></UnstructuredGrid><AppendedData encoding=\"raw\">_" + appended + "</AppendedData></VTKFile>";
}

}  // namespace

TEST_CASE("zlib: inflates data of exactly the stated size") {
  std::string text;
  for (unsigned i = 0; i < 100000; ++i) text += static_cast<char>(i * i >> 3);
  const std::string small = deflated(text);
  std::string out(text.size(), '\0');
  const auto inflates = [&](const std::string& data, std::size_t size) {
    std::vector<unsigned char> exact(size + 1, 7);  // one more byte, which must not change
    const std::vector<unsigned char> from(data.begin(), data.end());
    const bool is = zlib_inflate(from.data(), from.size(), exact.data(), size);
    CHECK(exact[size] == 7);
    if (is) out.assign(exact.begin(), exact.end() - 1);
    return is;
  };
  CHECK(inflates(small, text.size()));
  CHECK((out == text));
  CHECK(!inflates(small, text.size() - 1));
  CHECK(!inflates(small, text.size() + 1));
  CHECK(!inflates(small.substr(0, small.size() - 1), text.size()));
  CHECK(!inflates(small + "x", text.size()));
  CHECK(!inflates("not zlib", 8));
  CHECK(!inflates("", 0));
  CHECK(inflates(deflated(""), 0));
}

TEST_CASE("zlib: refuses what zlib refuses, whichever bit is wrong") {
  std::string text;
  for (unsigned i = 0; i < 300; ++i) text += static_cast<char>(i * i >> 3);
  std::string data = deflated(text);
  for (std::size_t bit = 0; bit < 8 * data.size(); ++bit) {
    data[bit / 8] = static_cast<char>(data[bit / 8] ^ 1 << bit % 8);
    std::vector<unsigned char> ours(text.size()), theirs(text.size());
    const auto* const from = reinterpret_cast<const unsigned char*>(data.data());
    uLongf size = text.size();
    const bool is_valid = uncompress(theirs.data(), &size, from, static_cast<uLong>(data.size())) == Z_OK && size == text.size();
    CHECK_MESSAGE(zlib_inflate(from, data.size(), ours.data(), ours.size()) == is_valid, "bit ", bit);
    data[bit / 8] = static_cast<char>(data[bit / 8] ^ 1 << bit % 8);
  }
}

TEST_CASE("zlib: the stated size of blocks can be any number, if there is one block only") {
  const auto m = load_text<tetmesh>(compressed_tet<std::uint64_t>(~std::size_t{0}), file_format::vtu, {.inflate = zlib_inflate});
  CHECK(num_polys(m) == 1);
}

TEST_CASE("zlib: compressed .vtu files are read, in blocks of any size") {
  for (const std::size_t block : {std::size_t{5}, std::size_t{8}, std::size_t{24}, std::size_t{96}, std::size_t{32768}}) {
    const auto m = load_text<tetmesh>(compressed_tet(block), file_format::vtu, {.inflate = zlib_inflate});
    CHECK(num_polys(m) == 1);
    CHECK(point(m, vert_id{3}).z == 0.1);
  }
  CHECK_THROWS_WITH_AS(load_text<tetmesh>(compressed_tet(96), file_format::vtu),
                       "text: the arrays are compressed: include <concino/adapters/zlib.hpp> (Debian's zlib1g-dev, link -lz), and load with {.inflate = zlib_inflate}", unsupported);
}

TEST_CASE("zlib: damaged compressed files are errors, and cost no memory") {
  const std::string text = compressed_tet(24);
  std::mt19937 random(7);
  std::size_t errors = 0, loaded = 0;
  for (std::size_t i = 0; i < 4000; ++i) {
    std::string damaged = text;
    damaged[random() % text.size()] = static_cast<char>(random());
    if (i % 4 == 0) damaged.resize(random() % text.size());
    try {
      load_text<tetmesh>(damaged, file_format::vtu, {.inflate = zlib_inflate});
      ++loaded;
    } catch (const error&) {
      ++errors;
    }
  }
  CHECK(errors > 1000);
  CHECK(loaded > 100);
  // sizes that zlib data cannot have: refused before anything is allocated
  const std::string bomb = "<VTKFile type=\"UnstructuredGrid\" compressor=\"vtkZLibDataCompressor\"><UnstructuredGrid><Piece NumberOfPoints=\"100000000\" NumberOfCells=\"0\"><Points><DataArray "
                           "type=\"Float64\" NumberOfComponents=\"3\" format=\"appended\" offset=\"0\"/></Points></Piece></UnstructuredGrid><AppendedData encoding=\"raw\">_" +
                           bytes_of_numbers<std::uint32_t>({1, 2400000000u, 0, 100}) + std::string(100, 'x') + "</AppendedData></VTKFile>";
  CHECK_THROWS_WITH_AS(load_text<tetmesh>(bomb, file_format::vtu, {.inflate = zlib_inflate}),
                       "text:1: expected sizes that zlib data can have, found 2400000000 bytes from 100 in the array \"\"", parse_error);
}

TEST_CASE("zlib: the compressed file of the corpus holds the mesh of the other") {
  CONCINO_CORPUS_OR_SKIP(text, "tet/quarter_crown_ascii.vtu");
  CONCINO_CORPUS_OR_SKIP(binary, "tet/quarter_crown_binary.vtu");
  const tetmesh a = load<tetmesh>(text), b = load<tetmesh>(binary, {.inflate = zlib_inflate});
  CHECK(num_verts(b) == 222);
  CHECK(num_polys(b) == 650);
  CHECK(num_faces(b) == 1499);
  std::size_t wrong = 0;
  for (const auto v : verts(a)) wrong += !(norm(point(a, v) - point(b, v)) < 1e-10);  // the text has twelve digits
  CHECK(wrong == 0);
  CHECK(find_poly_property<std::int64_t>(b, "id")[poly_id{649}] == find_poly_property<std::int64_t>(a, "id")[poly_id{649}]);
  CHECK(find_vert_property<double>(b, "z"));
}
