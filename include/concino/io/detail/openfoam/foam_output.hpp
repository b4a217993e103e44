// Writes the headers and lists of OpenFOAM files, as text or as binary numbers.
#pragma once

#include <concino/io/text_sink.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace concino::detail {

/// A file of OpenFOAM. Labels have 32 bits and numbers 64 bits, in the byte order of the machine.
class foam_output {
  text_sink& out_;
  bool binary_;

 public:
  foam_output(text_sink& out, bool binary) : out_(out), binary_(binary) {}

  void header(std::string_view class_name, std::string_view object, std::string_view note = {}) {
    out_ << "FoamFile\n{\n    version     2.0;\n    format      " << (binary_ ? "binary" : "ascii")
         << ";\n    class       " << class_name << ";\n";
    if (binary_)
      out_ << "    arch        \"" << (std::endian::native == std::endian::little ? "LSB" : "MSB")
           << ";label=32;scalar=64\";\n";
    if (!note.empty()) out_ << "    note        \"" << note << "\";\n";
    out_ << "    location    \"constant/polyMesh\";\n    object      " << object << ";\n}\n\n";
  }

  void begin_list(std::size_t n) {
    out_ << n << '\n';
    if (!binary_) out_ << "(\n";
    else if (n != 0) out_ << '(';
  }
  void end_list(std::size_t n) {
    if (!binary_) out_ << ")\n";
    else if (n != 0) out_ << ")\n";
  }

  /// An entry of a list of numbers.
  template<class T>
  void binary(T x) {
    out_ << std::string_view(reinterpret_cast<const char*>(&x), sizeof x);
  }
  void label(std::size_t i) {
    if (binary_) binary(static_cast<std::int32_t>(i));
    else out_ << i << '\n';
  }
  void point(double x, double y, double z) {
    if (binary_) binary(x), binary(y), binary(z);
    else out_ << '(' << x << ' ' << y << ' ' << z << ")\n";
  }
};

}  // namespace concino::detail
