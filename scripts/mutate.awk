# Mutates a header. Every place of a small change (an operator, a constant, an index, a condition) gets a number, in the order of the text;
# a place may have two. A list of them, one per line with tabs between number, header, line, how, change and text, goes to the file `list`.
#   -v first=N   the number of the first
#   -v only=0    prints the header with all of them in it, to be switched on at run time by scripts/mutants.hpp; not in lines named in the
#                file `unfit`, which are compiled one by one (their `how` is "text", of the others "switch")
#   -v only=N    prints the header with that mutant alone, as text
# It knows the style of this repository: blanks around binary operators, none inside template brackets or before & and * of types.
BEGIN {
  id = first
  while (unfit != "" && (getline line_number < unfit) > 0) is_unfit[line_number] = 1
  split("< less <= >=|<= less_equal < >|> greater >= <=|>= greater_equal > <|== equal !=|!= unequal ==|+ plus -|- minus +|* times /|/ over *|% modulo /|& bit_and OR|<< shift_left >>|>> shift_right <<", rows, "|")
  for (r in rows) { split(rows[r], part, " "); name_of[part[1]] = part[2]; other[part[1]] = part[3]; second[part[1]] = part[4] }
  other["&"] = "|"
  name_of["|"] = "bit_or"; other["|"] = "&"
  assign["+="] = "add -="; assign["-="] = "subtract +="; assign["*="] = "multiply /="; assign["/="] = "divide *="
}

# A place: what stands there, what stands there with a switch (@ for the number, $ for the next), one or two texts and what they are called.
function place(original, switched, text1, change1, text2, change2,   out) {
  out = original
  if (only == 0 && !unfit_here) { out = switched; gsub(/@/, id, out); gsub(/\$/, id + 1, out) }
  if (only == id) out = text1
  note(change1)
  if (change2 != "") {
    if (only == id) out = text2
    note(change2)
  }
  return out
}
function note(change) {
  if (++times[change] > 1) change = change " #" times[change]
  if (only == 0 && list != "") print id "\t" header "\t" FNR "\t" (unfit_here ? "text" : "switch") "\t" change "\t" trimmed > list
  ++id
}

# What only makes room changes no result.
/\.reserve\(|reserve_(facets|large)\(/ { print; next }
# A condition of the compiler's that goes on in the next line.
unfinished { if (/;$/) unfinished = 0; print; next }
/^(template<.*> )?concept |^ *static_assert/ && !/;( *\/\/.*)?$/ { unfinished = 1 }
/^ *(#|\/\/|template<|using |case |default:|enum |friend )|concept |^ *virtual .* = 0;|requires|static_assert|[^_a-z]assert\(|operator ?[<>=!+*\/%&|-]+ ?\(/ { print; next }
/^ *(inline |static )*constexpr [^(]*( = |\{)|if constexpr|^ *[A-Za-z_:0-9]+ [a-z_]+\[[^;]*\];|<[A-Za-z_:0-9]+, [A-Za-z_]+ [-+] [0-9]+>/ { all_text = 1 }
{
  # Constants over several lines, up to the semicolon; those that are computed, up to the brace.
  if (constant != "") {
    all_text = 1
    if ($0 ~ constant) constant = ""
  } else if (/^ *(inline |static )*constexpr [^(]*( = |\{)/ && !/[;}]( *\/\/.*)?$/) {
    constant = /\[\] \{$/ ? "^ *}\\(" : ";( *//.*)?$"
  }
  trimmed = $0; sub(/^ +/, "", trimmed)
  unfit_here = is_unfit[FNR] || all_text
  all_text = 0
  split("", times)
  print mutated($0)
}

function mutated(s,   out, i, n, c, prev, rest, token, op, width, inner, literal, k, was_unfit) {
  out = ""
  n = length(s)
  for (i = 1; i <= n;) {
    c = substr(s, i, 1)
    prev = i > 1 ? substr(s, i - 1, 1) : " "
    rest = substr(s, i)
    if (rest ~ /^\/\//) { out = out rest; break }
    if (rest ~ /^\[\[/) { width = index(rest, "]]") + 1; out = out substr(rest, 1, width); i += width; continue }
    if (c == "\"") {                                             # a string
      for (k = i + 1; k <= n && substr(s, k, 1) != "\""; ++k) if (substr(s, k, 1) == "\\") ++k
      out = out substr(s, i, k - i + 1); i = k + 1; continue
    }
    if (c == "'") {                                              # a character
      for (k = i + 1; k <= n && substr(s, k, 1) != "'"; ++k) if (substr(s, k, 1) == "\\") ++k
      literal = substr(s, i, k - i + 1)
      out = out place(literal, "mutant::number(@, " literal ")", "static_cast<char>(" literal " + 1)", literal " -> the next"); i = k + 1; continue
    }
    if (prev !~ /[A-Za-z0-9_.']/ && match(rest, /^(0x[0-9A-Fa-f']+|[0-9][0-9']*(\.[0-9]+)?(e[-+]?[0-9]+)?)[uUlLf]*/)) {
      literal = substr(rest, 1, RLENGTH)
      # Sizes of arrays and arguments of templates are constants.
      was_unfit = unfit_here
      k = substr(rest, RLENGTH + 1, 1)
      if ((k == "]" && out ~ /(^ *|\()(const )?[A-Za-z_:0-9]+ [a-z_]+\[$/) || ((k == ">" || k == ",") && out ~ /[A-Za-z_]<([A-Za-z_:<>0-9]+, )*$/)) unfit_here = 1
      if (literal ~ /^0(\.0)?[uUlLf]*$/) out = out place(literal, "mutant::number(@, " literal ")", "(" literal " + 1)", literal " -> +1")
      else out = out place(literal, "mutant::number_both_ways(@, " literal ")", "(" literal " + 1)", literal " -> +1", "(" literal " - 1)", literal " -> -1")
      unfit_here = was_unfit
      i += RLENGTH; continue
    }
    if (prev !~ /[A-Za-z0-9_]/ && match(rest, /^[A-Za-z_][A-Za-z0-9_]*/)) {
      token = substr(rest, 1, RLENGTH)
      if (token == "true" || token == "false") {
        op = token == "true" ? "false" : "true"
        was_unfit = unfit_here
        if (substr(rest, RLENGTH + 1, 1) ~ /[>,]/ && out ~ /[A-Za-z_]<([A-Za-z_:<>0-9]+, )*$/) unfit_here = 1
        out = out place(token, "mutant::truth(@, " token ")", op, token " -> " op)
        unfit_here = was_unfit
      } else if ((token == "if" || token == "while") && (inner = simple_condition(substr(rest, RLENGTH + 1))) != "") {
        out = out token " (" place("", "mutant::condition(@)->*", "!", "condition -> not"); RLENGTH = length(token) + 2
      } else out = out token
      i += RLENGTH; continue
    }
    if (c == "(" || c == "{" || c == "[") { logical[++nesting] = "" }
    if (c == ")" || c == "}" || c == "]") { if (nesting > 0) --nesting }
    if (c == ";" || c == "," || c == "?" || c == "=") logical[nesting] = ""

    # x[i] and x[v.raw()]
    if (c == "[" && prev ~ /[A-Za-z0-9_)\]]/ && match(rest, /^\[[a-z_][a-z0-9_]*(\.raw\(\))?\]/)) {
      inner = substr(rest, 2, RLENGTH - 2)
      out = out "[" place(inner, "mutant::index(@, " inner ")", inner " + 1", "index " inner " -> +1") "]"
      --nesting; i += RLENGTH; continue
    }
    # binary operators, with blanks around
    if (prev == " " && match(rest, /^([<>=!+*\/%-]=|&&|\|\||<<|>>|[<>+*\/%&|?-])( |$)/)) {
      op = rest; sub(/ .*/, "", op); width = length(op)
      if (op == "&&") {
        if (logical[nesting] != op) out = out place("", "| mutant::yes(@) ", "| true ", "left of && -> true")
        out = out "&&" place("", " mutant::yes(@) |", " true |", "right of && -> true")
        logical[nesting] = op
      } else if (op == "||") {
        if (logical[nesting] != op) out = out place("", "& mutant::no(@) ", "& false ", "left of || -> false")
        out = out "||" place("", " mutant::no(@) &", " false &", "right of || -> false")
        logical[nesting] = op
      } else if (op == "?") {
        out = out place("?", "&& !mutant::on(@) || mutant::on($) ?", "&& false ?", "? -> false", "|| true ?", "? -> true")
      } else if (op in assign && rest !~ /^\+= "/) {
        split(assign[op], op_part, " ")
        out = out place(op, op " mutant::" op_part[1] "(@) " op, op_part[2], op " -> " op_part[2])
      } else if (op in name_of) {
        if (op == "+" && (out ~ /"[ ]*$/ || rest ~ /^\+ *("|number_text|std::string|std::to_string|detail::number_text|name_of|$)/)) out = out op  # of strings
        else if (second[op] != "") out = out place(op, op " mutant::" name_of[op] "(@) " op, other[op], op " -> " other[op], second[op], op " -> " second[op])
        else out = out place(op, op " mutant::" name_of[op] "(@) " op, other[op], op " -> " other[op])
      } else out = out op
      i += width; continue
    }
    # before an operand
    if (c == "!" && rest ~ /^![A-Za-z_(*]/) { out = out place("!", "mutant::negation(@)->*", "!!", "! -> none"); ++i; continue }
    if (c == "-" && prev ~ /[ (,{\[]/ && rest ~ /^-[A-Za-z0-9_(*]/) { out = out place("-", "mutant::sign(@)->*", "+", "- -> none"); ++i; continue }
    if (rest ~ /^\+\+[A-Za-z_(*]/ && prev ~ /[ (,\[]/) { out = out place("++", "mutant::increment(@)->*", "--", "++ -> twice"); i += 2; continue }
    if (rest ~ /^--[A-Za-z_(*]/ && prev ~ /[ (,\[]/) { out = out place("--", "mutant::decrement(@)->*", "++", "-- -> twice"); i += 2; continue }
    if (rest ~ /^\+\+[^A-Za-z_(*]/ && prev ~ /[A-Za-z0-9_)\]]/ && out !~ /(^|[^A-Za-z0-9_)\]] ?)\*[a-z_]+$/) {
      out = out place("++", "->*mutant::increment_after(@)", "--", "++ -> twice"); i += 2; continue
    }
    out = out c
    ++i
  }
  return out
}

# What stands in the parentheses after if or while, where it is one call or name without an operator.
function simple_condition(s,   k, level, c, inner) {
  if (s !~ /^ \([A-Za-z_*]/) return ""
  for (k = 2; k <= length(s); ++k) {
    c = substr(s, k, 1)
    if (c == "(") ++level
    if (c == ")" && --level == 0) break
  }
  if (level != 0) return ""
  inner = substr(s, 3, k - 3)
  if (inner ~ /[;"']/) return ""
  c = inner
  gsub(/, /, ",", c)
  return c ~ / / ? "" : inner
}
