# Finds `if constexpr` on the kind or the dimension of a mesh that do not say why: a comment on the same line, or on the line above, says what differs.
# Where only facets are looked for, the verbs do: facets(m), adj_p2facet(m, p) and the others need no such branch.
# usage: awk -f check_branches.awk headers...     Prints file:line: what it is; the exit code is 1 where something is.
function report() {
  if (open != "") print open
  found = found || open != ""
  open = ""
}
FNR == 1 {
  report()
  above = ""
}
/^[ \t]*requirement::first_missing/ { open = "" }
{ report() }
/if constexpr \(.*(SurfaceMesh|VolumeMesh|TriMesh|QuadMesh|TetMesh|HexMesh|dimension|arity)/ && !/\/\// && above !~ /^[ \t]*\/\// && !/requirement::first_missing/ {
  open = FILENAME ":" FNR ": " $0  # the explanation of a concept may follow
}
{ above = $0 }
END {
  report()
  exit found
}
