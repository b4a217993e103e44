# Prints docs/agreement.md with a new table between <!-- agreement --> and <!-- end of agreement -->, generated from the records of the tests of agreement:
#   awk -f table.awk rows.txt docs/agreement.md record...
# A cell is + if every model of the column ran the algorithms and agreed. Otherwise it lists the models that did: surfaces, volumes, or names of polys.
# The last column names the concept if archetypes and users' meshes ran. Columns without a record, such as those of libraries that are not installed,
# remain as they are on the page.
BEGIN {
  FS = "|"
  columns = split("trimesh|quadmesh|polygonmesh|tetmesh|hexmesh|polyhedralmesh|OpenMesh|CGAL::Surface_mesh|CGAL::Polyhedron_3|CGAL volumes|Eigen, span|Boost.Graph|views|your mesh", column, "|")
}
FNR == 1 { ++file }
file == 1 {
  if ($0 ~ /^#/) next
  ++rows
  algorithms[rows] = $1; text[rows] = $2; needs[rows] = $3
  split($1, names, ",")
  for (i in names) is_row[names[i]] = 1
  next
}
file == 2 {
  page[++lines] = $0
  if ($0 ~ /^\|/) {
    cells = split($0, cell, "|")
    for (i = 3; i < cells; ++i) { gsub(/^ +| +$/, "", cell[i]); old[trim(cell[2]), i - 2] = cell[i] }
  }
  next
}
{
  known[$1] = 1
  if (!(($1, $3) in model)) { model[$1, $3] = $4; order[$1, ++models[$1]] = $3 }
  if (!($2 in is_row)) { print "rows.txt has no row for " $2 > "/dev/stderr"; failed = 1 }
  if ($5 == "ran") ran[$1, $3, $2] = 1
}
function trim(s) { gsub(/^ +| +$/, "", s); return s }
function ran_all(c, m, row,   names, n, i) {
  n = split(algorithms[row], names, ",")
  for (i = 1; i <= n; ++i) if (!((c, m, names[i]) in ran)) return 0
  return 1
}
function cell_of(c, row,   i, m, all, some, by_dimension, list, of) {
  all = 1; by_dimension["2"] = by_dimension["3"] = ""
  for (i = 1; i <= models[c]; ++i) {
    m = order[c, i]
    of = model[c, m]
    if (ran_all(c, m, row)) { some = 1; list = list (list == "" ? "" : ", ") m; by_dimension[of] = by_dimension[of] "y" }
    else { all = 0; by_dimension[of] = by_dimension[of] "n" }
  }
  if (!some) return ""
  if (all) return "+"
  if (by_dimension["2"] ~ /^y+$/ && by_dimension["3"] ~ /^n+$/) return "surfaces"
  if (by_dimension["3"] ~ /^y+$/ && by_dimension["2"] ~ /^n+$/) return "volumes"
  return list
}
function row_line(row,   line, i, c) {
  line = "| " text[row] " |"
  for (i = 1; i <= columns; ++i) {
    c = column[i]
    if (c == "your mesh" && (c in known) && ("archetypes" in known))
      c = cell_of("archetypes", row) != "" && cell_of("your mesh", row) != "" ? needs[row] : ""
    else if (c != "your mesh" && (c in known)) c = cell_of(c, row)
    else c = old[text[row], i]
    line = line (c == "" ? " |" : " " c " |")
  }
  return line
}
END {
  if (failed) exit 1
  for (i = 1; i <= lines; ++i) {
    if (page[i] == "<!-- end of agreement -->") inside = 0
    if (!inside) print page[i]
    if (page[i] == "<!-- agreement -->") {
      inside = found = 1
      head = "| |"; rule = "|---|"
      for (c = 1; c <= columns; ++c) {
        head = head " " column[c] " |"
        rule = rule (c == columns ? "---|" : ":-:|")
      }
      print head; print rule
      for (row = 1; row <= rows; ++row) print row_line(row)
    }
  }
  if (!found) { print "docs/agreement.md has no <!-- agreement -->" > "/dev/stderr"; exit 1 }
}
