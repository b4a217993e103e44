# Prints the text of Markdown pages as scripts/sentences.awk reads it: a line is file, line and text with tabs between them; an empty text ends a
# paragraph. Code blocks, tables, headings, comments, pictures and the marks of lists are left out.
# usage: awk -f markdown_prose.awk pages...

function prose(text) { print FILENAME "\t" FNR "\t" text }

# [text](address) becomes text.
function without_links(line,    at, text) {
  while (match(line, /\[[^]]*\]\([^)]*\)/)) {
    text = substr(line, RSTART + 1, RLENGTH - 1)
    sub(/\].*/, "", text)
    line = substr(line, 1, RSTART - 1) text substr(line, RSTART + RLENGTH)
  }
  return line
}

FNR == 1 { fenced = code = commented = 0; blank = 1 }

/^[ \t]*```/ {
  fenced = !fenced
  prose("")
  next
}
fenced { next }

{
  line = $0
  gsub(/<!--([^-]|-[^-])*-->/, "", line)
  if (commented && sub(/^.*-->/, "", line)) commented = 0
  if (commented) next
  if (sub(/<!--.*/, "", line)) commented = 1
  if (line !~ /[^ \t]/) {
    prose("")
    blank = 1
    next
  }
  code = line ~ /^(    |\t)/ && (blank || code)
  blank = 0
  if (code || line ~ /^[ \t]*(\||#|---|!\[)/) {
    prose("")
    next
  }
  if (sub(/^[ \t]*([-*+]|[0-9]+\.)[ \t]+/, "", line)) prose("")
  gsub(/!\[[^]]*\]\([^)]*\)/, "", line)
  line = without_links(line)
  gsub(/\*\*/, "", line)
  prose(line)
}
