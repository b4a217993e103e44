// Reads the tags of XML files as VTK writes them: elements, attributes, comments, and the five entities. It needs no
// memory but for names.
#pragma once

#include <concino/io/text_cursor.hpp>

#include <cstring>
#include <string>
#include <string_view>

namespace concino::detail {

struct xml_tag {
  const char* at = nullptr;  // the <
  std::string_view name;
  std::string_view attributes;
  bool begins = false, ends = false;  // <a>, </a>; both: <a/>
};

class xml_scanner : public text_cursor {
 public:
  using text_cursor::text_cursor;

  /// Reads the next tag, and stops behind it. Returns false at the end of the text. Errors: parse_error for what is no
  /// such XML.
  bool next(xml_tag& tag) {
    for (;;) {
      const auto* const open = left() ? static_cast<const char*>(std::memchr(at, '<', left())) : nullptr;
      if (!open) {
        at = end();
        return false;
      }
      at = open + 1;
      if (starts_with("!--")) skip_to("-->", "--> at the end of a comment");
      else if (starts_with("?")) skip_to("?>", "?> at the end of a declaration");
      else if (starts_with("!")) fail(open, "a tag; document types and sections of characters are not supported");
      else return read_tag(open, tag);
    }
  }

  /// The value of an attribute, with its entities replaced. Returns false if there is none.
  bool attribute(const xml_tag& tag, std::string_view name, std::string& value) const {
    const char *p = tag.attributes.data(), *const last = p + tag.attributes.size();
    while (p != last) {
      while (p != last && is_space(*p)) ++p;
      const char* const first = p;
      while (p != last && *p != '=' && !is_space(*p)) ++p;
      const std::string_view found(first, static_cast<std::size_t>(p - first));
      while (p != last && is_space(*p)) ++p;
      if (found.empty() && p == last) return false;
      if (p == last || *p != '=') fail(first, "an attribute, name=\"value\"");
      ++p;
      while (p != last && is_space(*p)) ++p;
      if (p == last || (*p != '"' && *p != '\'')) fail(first, "an attribute, name=\"value\"");
      const char* const from = p + 1;
      const auto* const to = static_cast<const char*>(std::memchr(from, *p, static_cast<std::size_t>(last - from)));
      if (!to) fail(first, "an attribute, name=\"value\"");
      p = to + 1;
      if (found == name) {
        value = decoded(from, to);
        return true;
      }
    }
    return false;
  }

 private:
  bool starts_with(std::string_view text) const {
    return left() >= text.size() && std::string_view(at, text.size()) == text;
  }
  void skip_to(std::string_view text, const char* expected) {
    const std::size_t found = std::string_view(at, left()).find(text);
    if (found == std::string_view::npos) fail(at - 1, expected);
    at += found + text.size();
  }

  bool read_tag(const char* open, xml_tag& tag) {
    tag = {};
    tag.at = open;
    tag.begins = at == end() || *at != '/';
    if (!tag.begins) ++at;
    const char* const first = at;
    while (!at_end() && *at != '>' && *at != '/' && *at != '<' && !is_space(*at)) ++at;
    tag.name = {first, static_cast<std::size_t>(at - first)};
    if (tag.name.empty()) fail(open, "the name of a tag");
    const char* const rest = at;
    for (char quote = 0; !at_end(); ++at) {
      if (quote) quote = *at == quote ? '\0' : quote;
      else if (*at == '"' || *at == '\'') quote = *at;
      else if (*at == '>') break;
      else if (*at == '<') fail(at, "> at the end of the tag before");
    }
    if (at_end()) fail(open, {"> at the end of a tag"}, {"the end of the file"});
    const bool is_empty = at[-1] == '/';
    tag.ends = !tag.begins || is_empty;
    tag.attributes = {rest, static_cast<std::size_t>(at - rest) - (is_empty && at - rest > 0 ? 1 : 0)};
    ++at;
    return true;
  }

  static std::string decoded(const char* from, const char* to) {
    constexpr std::string_view names[] = {"&amp;", "&lt;", "&gt;", "&quot;", "&apos;"};
    std::string s;
    while (from != to) {
      std::size_t k = 0;
      while (k < 5 && !std::string_view(from, static_cast<std::size_t>(to - from)).starts_with(names[k])) ++k;
      s += k < 5 ? "&<>\"'"[k] : *from;
      from += k < 5 ? names[k].size() : 1;
    }
    return s;
  }
};

/// Replaces characters that attributes cannot contain by entities.
inline std::string xml_text(std::string_view text) {
  std::string s;
  for (const char c : text) {
    if (c == '&') s += "&amp;";
    else if (c == '<') s += "&lt;";
    else if (c == '>') s += "&gt;";
    else if (c == '"') s += "&quot;";
    else s += c;
  }
  return s;
}

}  // namespace concino::detail
