# Finds public functions without a contract, fields of options without a comment, and adapters that do not say what they need.
# usage: awk -f check_contracts.awk headers...     Prints file:line: what is missing; the exit code is 1 where something is.
#
# A contract is a comment above a function with the four labels Needs: Result: Cost: Errors: (and Source: for a published method).
#   - It holds for the functions below it up to the next blank line, and for overloads of the same name that follow without a comment.
#     A function among them may say in a comment without labels how it differs.
#   - At the top of a header it holds for all functions of the header whose comments have no labels.
#   - Public is what stands in namespace concino or one within it, but for `detail` and `core` (what the modules share), in a header outside of the
#     folders detail/.
#   - Function objects (inline constexpr struct x_verb {...} x{}) count as functions.
# It is not asked of
#   - deleted functions: they say what to write instead;
#   - operators and members of classes: the class says what it is;
#   - consteval functions: they cost nothing and cannot fail when a program runs; a comment must say what they do.
# Options are the structs named ..._options, in folders detail/ too: every field has a comment with its unit, range or meaning, after it or above it.
# Adapters are the headers of adapters/concino/adapters/: the comment at the top says what is adapted, and Needs: which library and what of it.
#
# With -v functions=1 it checks nothing, but prints the file and the name of each public function, once for each header.
# With -v prose=1 it checks nothing, but prints the text of what users read: comments at the top of headers and comments that begin with /// in
# public namespaces. A line is file, line and text with tabs between them; an empty text ends a comment.

BEGIN { split("Needs Result Cost Errors", labels, " ") }

function complain(at, what) {
  if (prose || functions) return
  print FILENAME ":" at ": " what
  found = 1
}

function has_label(text, label) { return text ~ ("(^|[ \n/])" label ":") }

function missing_labels(text,    i, missing) {
  for (i = 1; i <= 4; ++i)
    if (!has_label(text, labels[i])) missing = missing " " labels[i] ":"
  return missing
}

function has_some_label(text,    i) {
  for (i = 1; i <= 4; ++i)
    if (has_label(text, labels[i])) return 1
  return 0
}

# What follows template<...> in a declaration.
function without_template(s,    i, depth, c) {
  sub(/^[ \t]+/, "", s)
  while (s ~ /^template[ \t]*</) {
    sub(/^template[ \t]*</, "", s)
    depth = 1
    for (i = 1; i <= length(s) && depth > 0; ++i) {
      c = substr(s, i, 1)
      if (c == "<") ++depth
      else if (c == ">" && substr(s, i - 1, 1) != "-") --depth
    }
    s = substr(s, i)
    sub(/^[ \t]+/, "", s)
  }
  return s
}

# Whether the next { begins the body of a requires-expression.
function awaits_requirements(s,    i, depth, c) {
  sub(/[ \t]+$/, "", s)
  if (s ~ /(^|[^a-zA-Z_0-9])requires$/) return 1
  if (s !~ /\)$/) return 0
  for (i = length(s); i > 0; --i) {
    c = substr(s, i, 1)
    if (c == ")") ++depth
    else if (c == "(" && --depth == 0) break
  }
  return substr(s, 1, i - 1) ~ /(^|[^a-zA-Z_0-9])requires[ \t]*$/
}

# The name of the function that s declares, or "".
function function_name(s,    i, c, depth, before, word, rest) {
  s = without_template(s)
  if (s ~ /^(struct|class|enum|union|using|typedef|namespace|static_assert|concept|friend|extern|CONCINO_[A-Z_]*)[^a-z_0-9]/) return ""
  if (s ~ /=[ \t]*delete[ \t]*$/) return ""
  for (i = 1; i <= length(s); ++i) {
    c = substr(s, i, 1)
    if (c == ")") --depth
    if (c != "(") continue
    if (depth++ > 0) continue
    if (substr(s, i + 1) ~ /^[ \t]*[0-9{]/) return ""  # a variable and its value
    before = substr(s, 1, i - 1)
    if (before ~ /[^=<>!]=[^=]/ || before ~ /(^|[^a-zA-Z_0-9])operator[^a-zA-Z_0-9]*$/) return ""
    if (!match(before, /[A-Za-z_][A-Za-z_0-9]*[ \t]*$/)) continue
    word = substr(before, RSTART)
    sub(/[ \t]+$/, "", word)
    rest = substr(before, 1, RSTART - 1)
    # a member defined outside of its class, or part of a requires-clause
    if (rest ~ /::[ \t]*$/ || rest !~ /[^ \t]/ || rest ~ /(requires|&&|\|\||!)[ \t]*$/) continue
    if (word !~ /^(requires|decltype|noexcept|alignas|explicit|sizeof)$/) return word
  }
  return ""
}

# Prints a line of a comment without its slashes; what is no comment ends it.
function print_prose(line) {
  if (line !~ /^[ \t]*\/\//) {
    if (prose_open) print FILENAME "\t" FNR "\t"
    prose_open = 0
    return
  }
  sub(/^[ \t]*\/\/\/?/, "", line)
  print FILENAME "\t" FNR "\t" line
  prose_open = 1
}

# Called at the end of each declaration of a namespace, with the comment above it in `above`.
function declared(    name, contract, missing) {
  if (n_detail > 0 || in_detail_folder || statement !~ /[^ \t]/) return
  if (statement ~ /^[ \t]*inline constexpr struct [a-z_0-9]+_verb[^a-z_0-9]/) {
    name = statement
    sub(/_verb.*/, "", name)
    sub(/.* /, "", name)
  } else {
    name = function_name(statement)
  }
  if (name == "") {
    if (statement !~ /=[ \t]*delete[ \t]*$/) group = ""
    return
  }
  if (functions && !((FILENAME, name) in printed)) {
    printed[FILENAME, name] = 1
    print FILENAME "\t" name
  }
  contract = above
  if (contract == "" && group == "" && name == last_name) contract = last_contract
  else if (!has_some_label(contract) && group != "") contract = group
  if (!has_some_label(contract) && missing_labels(top) == "") {
    contract = top
  } else if (statement ~ /(^|[ \t])consteval[ \t]/) {
    if (contract == "") complain(first_line, name " has no comment")
  } else if ((missing = missing_labels(contract)) != "") {
    complain(first_line, name " lacks" missing)
  }
  last_name = name
  last_contract = contract
  group = contract
}

function is_options(s) {
  return without_template(s) ~ /^struct [a-z_0-9]*_options[ \t]*(:[^:].*)?$/ && n_detail == 0
}

FNR == 1 {
  n_namespaces = n_detail = parens = skipping = continued = in_options = 0
  statement = comment = group = last_name = top = ""
  in_top = 1
  in_detail_folder = FILENAME ~ /\/concino\/(.*\/)?detail\//
  is_adapter = FILENAME ~ /adapters\/concino\/adapters\/[^\/]*$/
}

prose && !in_detail_folder {
  is_public = in_top || ($0 ~ /^[ \t]*\/\/\// && n_detail == 0)
  print_prose(is_public ? $0 : "")
}

{
  line = $0
  if (in_top) {
    if (line ~ /^\/\//) {
      top = top "\n" line
      next
    }
    in_top = 0
    if (top == "") complain(1, "does not begin with a comment")
    else if (is_adapter && !has_label(top, "Needs")) complain(1, "the comment at the top lacks Needs:")
  }
  if (continued || line ~ /^[ \t]*#/) {
    continued = line ~ /\\$/
    next
  }
  gsub(/\\\\|\\"|\\'/, "", line)  # escaped quotes
  gsub(/'[^']'/, "0", line)       # characters
  gsub(/"[^"]*"/, "0", line)      # texts
  gsub(/\/\*([^*]|\*[^\/])*\*\//, "", line)
  if (line ~ /^[ \t]*\/\//) {
    if (statement == "") comment = comment "\n" line
    if (in_options && field == "") field_comment = 1
    next
  }
  commented = line ~ /\/\//
  sub(/\/\/.*/, "", line)
  if (line ~ /^[ \t]*$/) {
    if (statement == "") comment = group = ""
    field_comment = 0
    next
  }
  n = length(line)
  for (p = 1; p <= n; ++p) {
    c = substr(line, p, 1)
    if (skipping > 0) {  # in the body of a function, a class or a requires-expression
      if (c == "{") ++skipping
      else if (c == "}" && --skipping == 0) {
        in_options = 0
        if (!within_requires) statement = ""
      } else if (in_options && skipping == 1 && c != " ") {
        if (field == "") field_line = FNR
        if (c != ";") {
          field = field c
          continue
        }
        if (!commented && !field_comment && field !~ /^(using|static|friend)|operator/) {
          sub(/[={].*/, "", field)
          complain(field_line, "a field of " options " has no comment: " $0)
        }
        field = ""
        field_comment = 0
      }
      continue
    }
    if (c == "(") ++parens
    else if (c == ")") --parens
    if (parens == 0 && c == "{") {
      if (statement ~ /^[ \t]*(inline[ \t]+)?namespace([ \t]|$)/) {
        is_detail[++n_namespaces] = statement ~ /(^|[ \t:])(detail|core)([ \t:]|$)/
        n_detail += is_detail[n_namespaces]
        statement = comment = group = last_name = ""
        continue
      }
      skipping = 1
      within_requires = awaits_requirements(statement)
      if (within_requires) continue
      in_options = is_options(statement)
      if (in_options) {
        options = without_template(statement)
        sub(/^struct /, "", options)
        sub(/[ \t:].*/, "", options)
        field = ""
        field_comment = 0
      }
      declared()
      continue
    }
    if (parens == 0 && c == "}") {
      n_detail -= is_detail[n_namespaces--]
      statement = comment = group = ""
      continue
    }
    if (parens == 0 && c == ";") {
      declared()
      statement = ""
      continue
    }
    if (statement == "") {
      if (c == " ") continue
      first_line = FNR
      above = comment
      comment = ""
    }
    statement = statement c
  }
  if (statement != "") statement = statement " "
}

END { exit found ? 1 : 0 }
