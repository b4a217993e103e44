# Finds functions of more than 60 lines, from the line with the name to the closing brace, lambdas within included; they are cut into named steps.
# usage: awk -f check_lengths.awk [-v most=60] headers...     Prints file:line: how long it is; the exit code is 1 where one is too long.

BEGIN { if (!most) most = 60 }

FNR == 1 {
  depth = in_comment = in_directive = 0
  function_depth = -1
  statement = ""
}

# The line without comments and what stands in quotes; the first line of a raw string ends where it begins.
function code_of(line,    i, c, two, out) {
  out = ""
  for (i = 1; i <= length(line); ++i) {
    c = substr(line, i, 1)
    two = substr(line, i, 2)
    if (in_comment) {
      if (two == "*/") { in_comment = 0; ++i }
    } else if (two == "/*") {
      in_comment = 1
      ++i
    } else if (two == "//") {
      break
    } else if (c == "\"" || (c == "'" && out !~ /[0-9a-fA-F]$/)) {
      for (++i; i <= length(line) && substr(line, i, 1) != c; ++i)
        if (substr(line, i, 1) == "\\") ++i
      out = out "0"
    } else {
      out = out c
    }
  }
  return out
}

# Whether the brace after the statement begins the body of a function.
function begins_function() {
  sub(/^[ \t]*template[ \t]*<.*>[ \t]*$/, "", statement)
  return statement ~ /\(/ && statement !~ /^[ \t]*(namespace|enum)[^a-zA-Z_0-9]/ && statement !~ /(^|[ \t>])(struct|class|union)[ \t]+[A-Za-z_:0-9]+[^()]*$/ &&
         statement !~ /=[ \t]*$/
}

{
  if (in_directive || $0 ~ /^[ \t]*#/) {
    in_directive = $0 ~ /\\$/
    next
  }
  line = code_of($0)
  for (i = 1; i <= length(line); ++i) {
    c = substr(line, i, 1)
    if (c == "{") {
      if (function_depth < 0 && begins_function()) {
        function_depth = depth
        begin = first_line
        name = first_text
      }
      ++depth
      statement = ""
    } else if (c == "}") {
      if (--depth == function_depth) {
        function_depth = -1
        if (FNR - begin + 1 > most) {
          print FILENAME ":" begin ": " FNR - begin + 1 " lines: " name
          found = 1
        }
      }
      statement = ""
    } else if (c == ";" && function_depth < 0 && statement !~ /\([^)]*$/) {
      statement = ""
    } else {
      if (statement !~ /[^ \t]/ || (statement ~ /^[ \t]*template[ \t]*<.*>[ \t]*$/ && c ~ /[^ \t]/) || statement ~ /^[ \t]*requires[^{;]*$/) {
        if (c ~ /[^ \t]/ && first_line != FNR) {
          first_line = FNR
          first_text = $0
          sub(/^[ \t]+/, "", first_text)
        }
      }
      statement = statement c
    }
  }
  statement = statement " "
}
END { exit found }
