# Finds links in Markdown pages to files or headings that do not exist.
# usage: awk -f check_links.awk pages...     Prints file:line: the link; the exit code is 1 where there is one.
# A link is [text](address) outside of code; addresses with a colon, such as https://, are left out. Headings have the names that GitHub gives them.

# The name of a heading in links: small letters, digits and hyphens.
function anchor_of(heading) {
  sub(/^#+ +/, "", heading)
  while (match(heading, /\]\([^)]*\)/)) heading = substr(heading, 1, RSTART - 1) substr(heading, RSTART + RLENGTH)
  heading = tolower(heading)
  gsub(/[^a-z0-9 _-]/, "", heading)
  gsub(/ /, "-", heading)
  return heading
}

function read_headings(page,    line, fenced) {
  if (page in is_read) return
  is_read[page] = 1
  while ((getline line < page) > 0) {
    if (line ~ /^[ \t]*```/) fenced = !fenced
    else if (!fenced && line ~ /^#+ /) headings[page, anchor_of(line)] = 1
  }
  close(page)
}

function exists(path) {
  if (!(path in known)) known[path] = system("test -e '" path "'") == 0
  return known[path]
}

function check(address,    folder, path, anchor) {
  if (address ~ /:/) return
  folder = FILENAME
  if (!sub(/\/[^\/]*$/, "/", folder)) folder = ""
  path = anchor = address
  sub(/#.*/, "", path)
  if (!sub(/^[^#]*#/, "", anchor)) anchor = ""
  path = path == "" ? FILENAME : folder path
  if (!exists(path)) {
    print FILENAME ":" FNR ": " address ": no such file"
    found = 1
  } else if (anchor != "") {
    read_headings(path)
    if (!((path, anchor) in headings)) {
      print FILENAME ":" FNR ": " address ": no such heading"
      found = 1
    }
  }
}

FNR == 1 { fenced = 0 }
/^[ \t]*```/ { fenced = !fenced; next }
fenced || /^    / { next }
{
  line = $0
  gsub(/`[^`]*`/, "code", line)
  while (match(line, /\]\([^) ]*\)/)) {
    address = substr(line, RSTART + 2, RLENGTH - 3)
    line = substr(line, RSTART + RLENGTH)
    check(address)
  }
}
END { exit found }
