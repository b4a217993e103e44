# Finds `if constexpr` on the kind or the dimension of a mesh that do not say why: a comment on the same line, or on the line above, says what differs.
# Where only facets are looked for, the verbs do: facets(m), adj_p2facet(m, p) and the others need no such branch.
# usage: awk -f check_branches.awk headers...     Prints file:line: what it is; the exit code is 1 where something is.
FNR == 1 { above = "" }
/if constexpr \(.*(SurfaceMesh|VolumeMesh|TriMesh|QuadMesh|TetMesh|HexMesh|dimension|arity)/ && !/\/\// && above !~ /^[ \t]*\/\// && !/requirement::first_missing/ {
  print FILENAME ":" FNR ": " $0
  found = 1
}
{ above = $0 }
END { exit found }
