#!/bin/sh
# Writes the page of save_html as a header, from its sources in page/:
#   scripts/assemble_page.sh page > include/concino/render/detail/page/page_text.hpp
# Comments that fill a line and indentation are left out. {{title}} and {{data}} stay: save_html fills them in.
set -eu
export LC_ALL=C
cd "$1"
scripts="data vectors camera mesh cut polygons fields things programs parts draw pick panel input main"

without_comments() { sed -e 's|^[[:space:]]*||' -e '/^\/\//d' -e '/^$/d' "$@"; }
without_glsl_comments() { without_comments "$1" | sed 's|[[:space:]]*//.*||'; }

assembled() {
  while IFS= read -r line; do
    case $line in
    '{{css}}') without_comments page.css ;;
    '{{script}}')
      printf '(() => {\n"use strict";\nconst shaders = { surface_vert: `'
      without_glsl_comments surface.vert
      printf '`, surface_frag: `'
      without_glsl_comments surface.frag
      printf '` };\n'
      for s in $scripts; do without_comments "$s.js"; done
      printf '})();\n'
      ;;
    *) printf '%s\n' "$line" ;;
    esac
  done <page.html
}

cat <<'END'
// The page of save_html, assembled from page/ by scripts/assemble_page.sh: change it there.
#pragma once

#include <array>
#include <string_view>

namespace concino::detail {

// clang-format off
/// The parts before the title, between title and data, and after the data.
inline constexpr std::string_view page_start = R"page(
END
assembled | awk '
  { sub(/\{\{title\}\}/, ")page\";\ninline constexpr std::string_view page_middle = R\"page(") }
  /^\{\{data\}\}$/ { print ")page\";\ninline constexpr std::array page_end = {"; size = 0; printf "std::string_view(R\"page("; in_data = 1; next }
  { size += length($0) + 1
    if (in_data && size > 12000) { printf ")page\"),\nstd::string_view(R\"page("; size = 0 }
    print }'
cat <<'END'
)page")};
// clang-format on

}  // namespace concino::detail
END
