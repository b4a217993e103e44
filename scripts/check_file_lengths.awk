# Finds files of more than 250 lines: they are cut along a seam of what they do. Tables of numbers may be longer.
# usage: awk -f check_file_lengths.awk [-v most=250] files...     Prints file: lines; the exit code is 1 where a file is too long.
BEGIN {
  if (!most) most = 250
  longer["font_table.hpp"] = 1  # the outlines of the letters
  longer["page_text.hpp"] = 1   # a web page, assembled from page/
}
function report(    name) {
  name = file
  sub(/^.*\//, "", name)
  if (lines <= most || name in longer) return
  print file ": " lines " lines"
  found = 1
}
FNR == 1 {
  report()
  file = FILENAME
}
{ lines = FNR }
END {
  report()
  exit found
}
