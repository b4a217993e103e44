# Makes docs/messages.md of what test programs recorded (tests/support/recorded_messages.cpp), or compares that page with their records.
# usage: awk -f messages.awk record... > new.md               only what was recorded
#        awk -v page=messages.md -f messages.awk record... > new.md   also the rows of `page` of test files that recorded nothing, unless -v all=1
#        awk -v page=messages.md -v compare=1 -f messages.awk record...   prints the messages that `page` lacks; the exit code is 1 if there are some
# A record has four fields with tabs between them: the file of the test below tests/, the test case, the type thrown and the message.
#
# One row shows all messages that differ in numbers, quoted texts and names of files only, and all parse errors that differ only in what was found
# instead of what was expected. Its example is the shortest of them; messages of tests that choose their input at random or share it with other tests
# come last. A row of `page` stays as it is while its test provokes it, so that compilers and kinds of mesh, which change numbers, do not change the page.

BEGIN {
  FS = "\t"
  # Tests that throw errors of their own or say what is expected, and tests that are not part of every build.
  left_out = "^(core/(error|message|progress|residual|system_checks)|fields/heat_bands|io/text_cursor|testing/|agreement/)"
  damaged = "^(damaged formats|fuzz|zlib: damaged)"  # cases that break files at random: what they quote from them is noise
  last_choice = "^(adapters|archetypes|compiled|laws|out_of_memory)/|fuzz|corpus|random|_long_test"
  if (page != "") read_page()
}

# Messages about a file begin with its path, others with the name of a function.
function is_about_file(file, type, message) {
  return type == "io_error" || file ~ /^(io|out_of_memory)\// && message ~ /^[^ ]*: / && message !~ /^(load|save|read|write)_/
}

# As the page shows it: without paths, as code in a table.
function shown(file, type, message) {
  gsub(/[^ ':]*concino_test_[A-Za-z0-9]+\/?/, "", message)
  gsub(/ \/[^ ':]*\//, " ", message)
  if (type == "parse_error") sub(/^[^:]*:[0-9]+:/, "FILE:LINE:", message)
  else if (is_about_file(file, type, message)) sub(/^[^:]*: /, "FILE: ", message)
  gsub(/\\x5c/, "\\", message)
  gsub(/`/, "\\x60", message)
  gsub(/\|/, "\\|", message)
  return with_short_numbers(message)
}

# Decimals beyond the third digit depend on the compiler.
function with_short_numbers(message,    text, number) {
  while (match(message, /[0-9]+\.[0-9][0-9][0-9][0-9]+(e[-+]?[0-9]+)?/)) {
    number = substr(message, RSTART, RLENGTH)
    text = text substr(message, 1, RSTART - 1) sprintf("%.3g", number)
    message = substr(message, RSTART + RLENGTH)
  }
  return text message
}

function pattern(type, message) {
  if (type == "parse_error") sub(/, found ('.*|the end of the (line|file).*|another value.*|an empty file.*)$/, ", found ...", message)
  gsub(/'[^']*'/, "'...'", message)
  gsub(/[A-Za-z0-9_.-]*\.(obj|off|mesh|meshb|hedra|hybrid|tet|iv|mtl|txt|soup|tris|xyz|stl|ply)/, "file", message)
  gsub(/[-+]?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?|[-+]?(inf|nan)/, "0", message)
  gsub(/0(, 0)+/, "0", message)
  return type " " message
}

# The module is the folder of the test.
function section_of(file, message) {
  return message ~ /^FILE:/ ? "Files" : substr(file, 1, index(file, "/") - 1)
}

function consider(type, message, section, test,    key, order) {
  key = pattern(type, message)
  if (test == page_test[key]) {
    best[key] = ""
    row_section[key] = section
    row_text[key] = page_row[key]
    return
  }
  order = sprintf("%d %05d %s\t%s", substr(test, 2) ~ last_choice, length(message), message, test)
  if (key in best && best[key] <= order) return
  best[key] = order
  row_section[key] = section
  row_text[key] = "| `" message "` | " type " | " test " |"
}

function read_page(    row, section, cell, i, key) {
  while ((getline row < page) > 0) {
    if (row ~ /^## /) section = substr(row, 4)
    if (row !~ /^\| `.*\|$/ || split(row, cell, / \| /) != 3) continue
    i = ++num_old
    old_section[i] = section
    old_message[i] = substr(cell[1], 4, length(cell[1]) - 4)
    old_type[i] = cell[2]
    old_test[i] = substr(cell[3], 1, length(cell[3]) - 2)
    old_file[i] = substr(cell[3], 2, index(cell[3], "`:") - 2)
    key = pattern(old_type[i], old_message[i])
    page_row[key] = row
    page_test[key] = old_test[i]
  }
}

NF == 4 && $1 !~ left_out && $2 !~ damaged {
  message = shown($1, $3, $4)
  test = "`" $1 "`: " $2
  gsub(/\|/, "\\|", test)
  if (!compare) {
    has_run[$1] = 1
    consider($3, message, section_of($1, message), test)
  } else if (!(pattern($3, message) in page_row)) {
    page_row[pattern($3, message)] = ""
    print $3 ": " message " (" $1 ": " $2 ")"
    missing = 1
  }
}

function sort_rows(    i, key, text) {
  for (key in best) {
    text = row_section[key] "\t" row_text[key]
    for (i = ++num_rows; i > 1 && rows[i - 1] > text; --i) rows[i] = rows[i - 1]
    rows[i] = text
  }
}

function print_page(    i, row, section) {
  print "# Error messages\n"
  print "concino reports errors by exceptions derived from `concino::error` (`<concino/core/error.hpp>`). This page lists their messages by module, each with"
  print "its type and with a test that provokes it. Numbers, names and quoted texts in the messages are examples; `FILE` stands for the path of a file and `LINE`"
  print "for a line in it. The page is generated by the tests (target `docs_messages`)."
  for (i = 1; i <= num_rows; ++i) {
    split(rows[i], row, "\t")
    if (row[1] != section) {
      section = row[1]
      print "\n## " section "\n\n| message | type | provoked by |\n|---|---|---|"
    }
    print row[2]
  }
}

END {
  if (!compare) {
    for (i = 1; i <= num_old && !all; ++i)
      if (!(old_file[i] in has_run)) consider(old_type[i], old_message[i], old_section[i], old_test[i])
    sort_rows()
    print_page()
  }
  exit missing
}
