// Reads the dictionaries of OpenFOAM files: the header, and lists of named dictionaries such as those of patches.
#pragma once

#include <concino/io/detail/openfoam/foam_cursor.hpp>

#include <string>
#include <string_view>

namespace concino::detail {

/// Reads a string with its quotation marks.
inline std::string_view next_foam_string(foam_cursor& in) {
  const char* const from = in.at++;
  for (; !in.at_end() && *in.at != '"' && !is_line_end(*in.at); ++in.at)
    if (*in.at == '\\' && in.left() > 1 && !is_line_end(in.at[1])) ++in.at;
  if (in.at_end() || *in.at != '"') in.fail(from, "a string that ends on its line");
  ++in.at;
  return {from, static_cast<std::size_t>(in.at - from)};
}

/// Reads the name of an entry. Errors: parse_error if there is none; unsupported for a directive.
inline std::string_view next_foam_key(foam_cursor& in) {
  in.skip();
  const char* const from = in.at;
  const std::string_view key = !in.at_end() && *in.at == '"' ? next_foam_string(in) : in.next_word();
  if (key.empty()) in.fail(from, "the name of an entry");
  if (key[0] == '#')
    core::throw_joined<unsupported>({in.name(), ": line ", in.line_of(from), " has the directive ", key,
                                     "; directives are not evaluated, write what it stands for"});
  return key;
}

/// Reads the value of an entry with the `;` or `}` at its end, on one line: blanks, line ends and comments become one
/// blank. Errors: parse_error; unsupported for binary numbers.
inline std::string next_foam_value(foam_cursor& in) {
  in.skip();
  const char* const from = in.at;
  const bool is_dictionary = !in.at_end() && *in.at == '{';
  std::string text;
  std::size_t depth = 0;
  for (;;) {
    const char* const before = in.at;
    in.skip();
    if (in.at_end()) in.fail(from, {"a value that ends in ';'"}, {"the end of the file"});
    const char c = *in.at;
    if (in.at != before && !text.empty() && c != ';') text += ' ';
    if (c == '"') {
      text += next_foam_string(in);
      continue;
    }
    const std::string_view rest(in.at, static_cast<std::size_t>(in.left()));
    if (in.encoding.binary && rest.starts_with("List<") && !rest.starts_with("List<word>"))
      core::throw_joined<unsupported>(
          {in.name(), ": line ", in.line_of(in.at),
           " has a list of binary numbers in a dictionary; convert the case to text with foamFormatConvert"});
    if ((c == '}' || c == ')') && depth == 0) in.fail(in.at, "a ';' at the end of the entry");
    depth += c == '{' || c == '(';
    depth -= c == '}' || c == ')';
    text += c;
    ++in.at;
    if (depth == 0 && (c == ';' || (is_dictionary && c == '}'))) return text;
  }
}

/// The line of an entry: "type wall;".
inline std::string foam_line(std::string_view key, std::string_view value) {
  return core::joined({key, value == ";" ? "" : " ", value});
}

/// Calls use(key, position of the key) for each entry up to the `}` of a dictionary; use reads the value.
template<class Use>
void for_each_foam_entry(foam_cursor& in, const Use& use) {
  while (!in.next_is('}')) {
    if (in.at_end()) in.fail(in.at, "the '}' of a dictionary");
    const char* const position = in.at;
    use(next_foam_key(in), position);
  }
}

/// Calls use(name, position) for each dictionary of a list N(name { ... } ...); use reads its entries and the `}`.
template<class Use>
void for_each_foam_dictionary(foam_cursor& in, const char* what, const Use& use) {
  std::uint64_t n = in.next_count(what, in.file_size());
  if (n == 0 && in.at_end()) return;
  in.require('(', "the '(' of a list");
  for (; n > 0; --n) {
    in.skip();
    const char* const position = in.at;
    const std::string_view name = next_foam_key(in);
    in.require('{', "the '{' of a dictionary");
    use(name, position);
  }
  in.require(')', "the ')' after the last dictionary");
}

/// The number of bytes that follows `key` in the arch entry of a header, such as label=32.
inline std::size_t foam_number_size(const foam_cursor& in, const char* position, std::string_view arch,
                                    std::string_view key, std::size_t otherwise) {
  const std::size_t found = arch.find(key);
  if (found == arch.npos) return otherwise;
  const std::string_view bits = arch.substr(found + key.size());
  if (bits.starts_with("32")) return 4;
  if (bits.starts_with("64")) return 8;
  in.fail(position, {key, "32 or ", key, "64"});
}

/// Reads the header of a file, and sets the encoding.      Result: the class.
/// Errors: parse_error; unsupported for files of several processors.
inline std::string read_foam_header(foam_cursor& in) {
  in.skip();
  const char* const first = in.at;
  if (in.next_word() != "FoamFile") in.fail(first, "the header FoamFile { ... }");
  in.require('{', "the '{' of the header");
  std::string class_name;
  for_each_foam_entry(in, [&](std::string_view key, const char* position) {
    const std::string value = next_foam_value(in);
    const std::string_view text = std::string_view(value).substr(0, value.size() - 1);
    if (key == "class") class_name = text;
    if (key == "format") {
      if (text != "ascii" && text != "binary") in.fail(position, {"the format ascii or binary"}, {"'", text, "'"});
      in.encoding.binary = text == "binary";
    }
    if (key == "arch") {
      in.encoding.swapped = (text.find("MSB") == text.npos) == (std::endian::native == std::endian::big);
      in.encoding.label_size = foam_number_size(in, position, text, "label=", 4);
      in.encoding.scalar_size = foam_number_size(in, position, text, "scalar=", 8);
    }
  });
  if (class_name == "decomposedBlockData")
    core::throw_joined<unsupported>(
        {in.name(), ": holds the parts of several processors; put them together with reconstructParMesh"});
  return class_name;
}

}  // namespace concino::detail
