#!/usr/bin/env bash
# Are the tests any good? Changes one sign, index, comparison, bound, condition or constant of a header at a time and runs the tests of
# this header: some test must fail. Prints each mutant that no test noticed, and a sum. Fails if there are any but those that
# scripts/equivalent_mutants.txt explains.
#   scripts/mutate.sh                  all headers of the table below
#   scripts/mutate.sh read_obj bfs     these headers
#   scripts/mutate.sh --text 1000      up to 1000 of those that have to be compiled one by one, not one for each header
#   scripts/mutate.sh --kinds bfs      also: does a test of each kind of mesh find it, where the tests of that kind come there?
#   scripts/mutate.sh --show 123 bfs   what mutant 123 of bfs is, and what the tests say about it
# Environment: CONCINO_MUTATE_BUILD (default build/mutate), CONCINO_JOBS (2).
# How: scripts/mutants.hpp. Works on a copy of the tree. A mutant that does not compile does not count; one that runs into an endless loop
# is found. Output stands in the build folder: <header>/result.tsv has one line for each mutant.
set -u
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1
. scripts/packages.sh

# header below include/concino, or .ipp file of that name if there is one: tests that answer for it, below tests; those that find most come first.
table='
io/detail/obj/read_obj            io/detail/obj/read_obj io/detail/obj/read_mtl io/load io/detail/values/name_runs
io/detail/obj/obj_cursor          io/detail/obj/read_obj
io/detail/obj/obj_names           io/detail/obj/read_obj io/load
io/detail/obj/obj_corner_values   io/detail/obj/obj_corner_values
io/detail/off/read_off            io/detail/off/read_off io/load
io/detail/off/off_cursor          io/detail/off/read_off
io/detail/off/off_binary          io/detail/off/read_off
io/detail/medit/read_medit          io/detail/medit/read_medit io/load
io/detail/medit/medit_text          io/detail/medit/read_medit
io/detail/medit/medit_binary        io/detail/medit/medit_binary
io/detail/medit/medit_marks         io/detail/medit/read_medit io/detail/medit/write_medit
io/detail/medit/medit_output        io/detail/medit/medit_binary io/detail/medit/write_medit
io/detail/medit/write_medit         io/detail/medit/write_medit io/save
io/detail/hedra/read_hedra          io/detail/hedra/read_hedra io/load
io/detail/tet/read_tet            io/detail/tet/read_tet
io/detail/iv/read_iv             io/detail/iv/read_iv
io/detail/iv/iv_cursor           io/detail/iv/read_iv
io/detail/hybrid/read_hybrid         io/detail/hybrid/read_hybrid
io/detail/cells/polyhedra_reader    io/detail/hedra/read_hedra io/detail/hybrid/read_hybrid io/load
io/detail/cells/orient              io/detail/cells/orient io/detail/hedra/read_hedra io/load
io/detail/cells/polyhedra_builder   io/detail/cells/polyhedra_builder io/cell_builder io/detail/vtk_xml/read_vtu
io/detail/obj/read_mtl            io/detail/obj/read_mtl io/detail/obj/material_library_file io/detail/obj/write_mtl
io/detail/obj/write_mtl           io/detail/obj/write_mtl io/detail/obj/material_library_file
io/detail/obj/material_library_file        io/detail/obj/material_library_file io/killed_save io/detail/obj/write_mtl
core/hash_bytes      core/hash_bytes
mesh/correspondence   mesh/correspondence_edges mesh/correspondence_corners mesh/correspondence
mesh/detail/properties/correspondence   mesh/correspondence_edges mesh/correspondence_corners mesh/correspondence
mesh/corner_property  mesh/corner_property
mesh/property_set     mesh/detail/properties/property_set mesh/property mesh/correspondence
mesh/detail/properties/column mesh/detail/properties/property_set mesh/property mesh/correspondence
mesh/detail/properties/property_set     mesh/detail/properties/property_set mesh/property mesh/correspondence
io/detail/formats/choose_format   io/format io/load
io/detail/values/name_runs       io/detail/obj/read_obj io/detail/obj/read_mtl io/load
io/detail/formats/load_with       io/format io/load io/load_any
io/detail/formats/save_with       io/format io/save
io/detail/formats/flat_mesh_of    io/flat_mesh io/save
io/flat_mesh              io/flat_mesh io/save
io/write_context          io/save io/detail/off/write_off
io/file_text           io/file_text
io/detail/files/file_text     io/file_text
io/numbers             io/numbers io/detail/obj/read_obj
io/detail/text/decimals     io/numbers io/detail/obj/read_obj
io/text_cursor         io/text_cursor io/detail/obj/read_obj io/detail/medit/read_medit io/detail/hedra/read_hedra
io/detail/text/characters   io/text_cursor io/detail/obj/read_obj
io/detail/cells/corners      io/detail/cells/corners io/detail/obj/read_obj io/detail/medit/read_medit io/detail/hedra/read_hedra
fields/harmonic_map    fields/harmonic_map fields/harmonic_map_archetypes fields/prepared
fields/poisson         fields/poisson fields/poisson_fluxes fields/prepared
fields/detail/problems/dirichlet    fields/harmonic_map fields/poisson fields/prepared fields/laplace_system fields/smooth
fields/detail/problems/laplace_system   fields/laplace_system fields/smooth fields/poisson fields/harmonic_map fields/harmonic_map_archetypes
fields/detail/heat/distance_bounds  fields/heat_geodesics fields/heat_geodesics_sources fields/heat_geodesics_scale fields/heat_geodesics_archetypes
fields/detail/heat/distance_graph   fields/heat_geodesics fields/heat_geodesics_sources fields/heat_geodesics_scale fields/heat_geodesics_archetypes
fields/detail/problems/scaled_mesh  fields/heat_geodesics_scale fields/heat_geodesics
fields/detail/heat/euclidean_distance    fields/heat_geodesics_sources fields/heat_geodesics
fields/detail/problems/masses   fields/poisson fields/poisson_fluxes
fields/detail/problems/neumann  fields/poisson_fluxes
operators/detail/cotangent_weights operators/cotangent operators/laplacian
operators/stiffness    operators/stiffness operators/discretisation operators/laplacian
operators/laplacian    operators/laplacian
operators/mass_matrix  operators/mass_matrix
operators/poly_mass_matrix operators/poly_mass_matrix
operators/gradient     operators/gradient
operators/gradient_matrix  operators/gradient_matrix operators/gradient
operators/vert_gradient_matrix operators/vert_gradient_matrix
operators/divergence   operators/divergence
operators/divergence_matrix    operators/divergence_matrix
core/assembly  operators/laplacian operators/gradient_matrix fields/harmonic_map
operators/detail/element_assembly  operators/mass_matrix operators/laplacian
operators/detail/compressed_columns    core/poly_chunks operators/poly_mass_matrix operators/gradient_matrix operators/divergence_matrix
operators/corner_gradients  operators/corner_gradients operators/gradient_matrix
operators/detail/de_goes   operators/de_goes
operators/detail/poly_operator operators/mass_matrix operators/laplacian
core/poly_chunks   core/poly_chunks operators/gradient
core/detail/product     core/product fields/smooth fields/harmonic_map
operators/simplex_gradients operators/corner_gradients operators/gradient_matrix operators/divergence_matrix
operators/detail/simplex_weights   operators/laplacian
operators/detail/virtual_elements  operators/detail/virtual_elements operators/mass_matrix operators/laplacian
operators/detail/virtual_refinement    operators/virtual_refinement
solve/auto_solver      solve/auto_solver
solve/detail/iterative/auto_solver solve/auto_solver
optimize/constrained      optimize/constrained
solve/ldlt             solve/ldlt solve/auto_solver
solve/detail/direct/ldlt       solve/ldlt solve/auto_solver
solve/llt              solve/llt
optimize/qp               optimize/qp
solve/qr               solve/qr optimize/least_squares
solve/solve_columns    solve/solve_columns
optimize/solve_with_values    optimize/solve_with_values
optimize/detail/known_values    optimize/solve_with_values optimize/least_squares
solve/detail/iterative/energy_gains  solve/detail/iterative/energy_gains
solve/detail/iterative/penalty_rows  solve/detail/iterative/penalty_rows solve/iterative_accuracy
core/equilibrate   core/equilibrate solve/qr
core/residual  core/residual optimize/solve_with_values fields/laplace_system fields/harmonic_map
core/detail/residual    core/residual optimize/solve_with_values fields/laplace_system fields/harmonic_map
core/system_checks core/system_checks solve/ldlt solve/lu solve/qr optimize/constrained
core/detail/system_checks core/system_checks solve/ldlt solve/lu solve/qr optimize/constrained
validate/detail/hex_orders mesh/corner_orders validate/minimal
validate/detail/facet_laws laws/broken_laws
validate/detail/halfedge_laws validate/halfedge_links concepts/halfedge_kernel
mesh/corner_orders     mesh/corner_orders
mesh/surface_tables    mesh/native_mesh edit/elements mesh/indexed_base validate/check_laws
mesh/detail/tables/surface_tables mesh/native_mesh edit/elements mesh/indexed_base validate/check_laws
mesh/cell_tables       mesh/cell_tables mesh/native_mesh edit/elements mesh/support/standard_cells validate/check_laws validate/dense_meshes
mesh/detail/tables/cell_tables_build mesh/cell_tables mesh/native_mesh edit/elements mesh/support/standard_cells validate/check_laws validate/dense_meshes
mesh/detail/tables/cell_tables_edit mesh/cell_tables mesh/native_mesh edit/elements mesh/support/standard_cells validate/check_laws validate/dense_meshes
mesh/detail/tables/cell_tables_fans mesh/cell_tables mesh/native_mesh edit/elements mesh/support/standard_cells validate/check_laws validate/dense_meshes
mesh/detail/tables/visited_faces mesh/cell_tables mesh/native_mesh edit/elements mesh/support/standard_cells validate/check_laws validate/dense_meshes
mesh/detail/edits/cell_tables_rewire mesh/cell_tables_rewire
mesh/detail/edits/cell_cavity mesh/cell_tables_rewire
mesh/detail/edits/new_poly_links mesh/cell_tables_rewire
mesh/detail/edits/cavity_faces mesh/cell_tables_rewire
mesh/detail/edits/cavity_edges mesh/surface_rewire mesh/cell_tables_rewire mesh/polyhedra_tables_rewire
mesh/detail/edits/cavity_changes mesh/surface_rewire mesh/cell_tables_rewire mesh/polyhedra_tables_rewire
mesh/detail/edits/cavity_input mesh/surface_rewire mesh/cell_tables_rewire mesh/polyhedra_tables_rewire
mesh/detail/edits/surface_rewire mesh/surface_rewire
mesh/detail/edits/surface_cavity mesh/surface_rewire
mesh/detail/edits/polyhedra_cavity mesh/polyhedra_tables_rewire
mesh/detail/edits/polyhedra_tables_rewire mesh/polyhedra_tables_rewire
mesh/polyhedra_tables  mesh/native_mesh edit/elements mesh/indexed_base validate/check_laws validate/dense_meshes
mesh/detail/tables/polyhedra_tables_build mesh/native_mesh edit/elements mesh/indexed_base validate/check_laws validate/dense_meshes
mesh/detail/tables/polyhedra_tables_edit mesh/native_mesh edit/elements mesh/indexed_base
mesh/detail/facets/facet_adjacency mesh/detail/facets/facet_adjacency mesh/cell_tables mesh/native_mesh edit/elements validate/check_laws validate/dense_meshes
mesh/detail/facets/facet_incidence mesh/detail/facets/facet_adjacency mesh/cell_tables mesh/native_mesh edit/elements validate/check_laws validate/dense_meshes
mesh/detail/facets/facet_edits mesh/detail/facets/facet_adjacency mesh/surface_rewire mesh/cell_tables_rewire mesh/polyhedra_tables_rewire
mesh/detail/facets/facet_marks mesh/detail/facets/facet_adjacency validate/dense_meshes
mesh/detail/facets/non_manifold_facets mesh/detail/facets/facet_adjacency validate/dense_meshes
mesh/detail/facets/adjacent_polys mesh/detail/facets/facet_adjacency validate/dense_meshes
mesh/detail/rows/row_lookup        mesh/detail/rows/row_lookup mesh/detail/facets/facet_adjacency validate/dense_meshes
mesh/detail/rows/jagged_array              mesh/detail/rows/jagged_array mesh/native_mesh edit/elements
mesh/detail/tables/compaction           edit/garbage_collect
mesh/detail/tables/surface_compact      edit/garbage_collect
mesh/detail/tables/cell_tables_compact  edit/garbage_collect
mesh/detail/tables/polyhedra_compact    edit/garbage_collect
edit/garbage_collect             edit/garbage_collect
edit/remove_unreferenced         edit/remove_unreferenced
edit/flip_winding                edit/flip_winding
mesh/detail/tables/vertex_incidence             mesh/native_mesh edit/elements
mesh/detail/tables/checks            mesh/native_mesh edit/elements
mesh/support/face_merger       mesh/support/face_merger mesh/support/face_soup io/cell_builder
mesh/support/face_soup         mesh/support/face_soup io/load io/detail/medit/read_medit validate/dense_meshes
mesh/detail/cells/to_polyhedra mesh/support/face_soup io/load
graph/dijkstra         graph/dijkstra graph/predecessors graph/shortest_path
graph/bfs              graph/bfs graph/predecessors
core/indexed_heap    core/indexed_heap graph/dijkstra
graph/detail/lengths   graph/dijkstra
graph/detail/targets   graph/bfs graph/dijkstra
graph/detail/crossings graph/bfs graph/dijkstra graph/predecessors
graph/detail/any_iterator     graph/boost
graph/detail/edge_numbers  graph/boost
graph/detail/corners   graph/cut_along graph/boundary_loops
graph/disjoint_sets   graph/disjoint_sets graph/spanning_tree
lines/detail/cells/flat_cell      lines/detail/cells/flat_cell lines/integral_line
lines/detail/cells/line_signs     lines/integral_line
lines/detail/follow/cycle_detector lines/integral_line
lines/detail/follow/line_recorder  lines/integral_line lines/evenly_spaced_lines
lines/detail/cells/polygon_reader lines/integral_line lines/field_at_verts
lines/detail/cells/polyhedron_reader lines/detail/cells/flat_cell lines/integral_line lines/field_at_verts
lines/detail/cells/surface_exits  lines/integral_line
lines/detail/cells/volume_exits   lines/integral_line
lines/detail/follow/surface_line_walker lines/integral_line
lines/detail/follow/surface_line_crossing lines/integral_line
lines/detail/follow/volume_line_walker  lines/integral_line
lines/detail/follow/volume_line_crossing lines/integral_line
lines/detail/follow/volume_line_position lines/integral_line
lines/detail/follow/vert_field_walker   lines/field_at_verts
lines/detail/geodesics/geodesic_walker     lines/trace_geodesic lines/straighten
lines/detail/geodesics/geodesic_start      lines/trace_geodesic
lines/detail/geodesics/flip_out            lines/straighten
lines/detail/geodesics/intrinsic_triangles lines/straighten
'

root=$PWD
build=${CONCINO_MUTATE_BUILD:-build/mutate}
jobs=${CONCINO_JOBS:-2}
show=0
by_kind=0
most_text=1
wanted=()
while [ $# -gt 0 ]; do
  case "$1" in
    --text) most_text=${2:?} && shift ;;
    --kinds) by_kind=1 ;;
    --show) show=${2:?} && shift ;;
    -*) sed -n '2,13s/^# //p' "$0"; [ "$1" = --help ] && exit 0 || exit 2 ;;
    *) wanted+=("$1") ;;
  esac
  shift
done
mkdir -p "$build" && build=$(cd "$build" && pwd) || exit 1
compiler=$(find_gcc) || { echo "no g++ 12 or later"; exit 1; }
eigen=$(pkg-config --cflags-only-I eigen3 2>/dev/null) || eigen=-I/usr/include/eigen3
eigen=${eigen//-I/-isystem}

tree=$build/tree
rm -rf "$tree"
mkdir -p "$tree" && cp -r adapters concepts include tests "$tree" || exit 1
# Failed assertions of the standard library end the program: a mutant that reads out of bounds is found. Each program runs hundreds of times,
# so it is worth optimising a little.
flags=(-std=c++20 -O1 -w -Wno-narrowing -fmax-errors=0 -D_GLIBCXX_ASSERTIONS -DCONCINO_TEST_DEFAULT_CORPUS=\"none\" -DCONCINO_TEST_SMALL_CORPUS=\"$tree/tests/small_corpus\" $eigen -I"$tree/tests")
roots=(-I"$tree/concepts" -I"$tree/include" -I"$tree/adapters")

# What every test includes and no mutant is in, compiled once.
printf '#include "%s/scripts/mutants.hpp"\n#include <%s>\n' "$root" doctest/doctest.h >"$build/common.hpp"
printf '#include <%s>\n' Eigen/Sparse algorithm charconv cmath filesystem fstream memory random set span string string_view vector >>"$build/common.hpp"
"$compiler" "${flags[@]}" -x c++-header "$build/common.hpp" -o "$build/common.hpp.gch" &&
  "$compiler" "${flags[@]}" -c "$tree/tests/main.cpp" -o "$build/main.o" || exit 1

# compile <overlay of include/> <test> <program> <log>
compile() {
  "$compiler" "${flags[@]}" -I"$1" "${roots[@]}" -include "$build/common.hpp" "$tree/tests/$2_test.cpp" "$build/main.o" -o "$3" -lpthread >"$4" 2>&1
}

# limited <test> <program> [argument...]: in a few times the processor time that the test needs without a mutant, however busy the machine is.
limited() {
  local seconds
  seconds=$(cat "$build/work/$1.limit")
  shift
  ( ulimit -v 4000000 -t "$seconds"; CONCINO_CORPUS=/nonexistent timeout -k 1 $((60 * seconds)) "$@" --abort-after=1 -nv ) >/dev/null 2>&1
}

# mutant <id>: runs the tests that met it, until one fails. Prints "id killed|survived|unmet by", or nothing if it is none.
mutant() {
  local id=$1 test met=0 status
  for test in $tests; do
    grep -qx "$id" "$build/work/$test.met" || continue
    met=1
    CONCINO_MUTANT=$id limited "$test" "$build/work/$test.run"
    status=$?
    if [ $status -ne 0 ]; then
      case $status in 124 | 137 | 152) echo "$id killed $test timeout" ;; *) echo "$id killed $test" ;; esac
      return
    fi
  done
  [ $met -eq 0 ] && for test in $tests; do grep -qx -e "-$id" "$build/work/$test.met" && return; done
  [ $met -eq 1 ] && echo "$id survived" || echo "$id unmet"
}

# mutant_by_kind <id>: prints "id kind" for each kind of mesh whose tests met it and did not fail.
kinds='trimesh quadmesh polygonmesh tetmesh hexmesh polyhedralmesh'
mutant_by_kind() {
  local id=$1 test kind met found
  for kind in $kinds; do
    met=0 found=0
    for test in $tests; do
      grep -qx "$id" "$build/work/$test.$kind.met" || continue
      met=1
      CONCINO_MUTANT=$id limited "$test" "$build/work/$test.run" --test-case="*<concino::$kind>*" || { found=1; break; }
    done
    [ $met -eq 0 ] || [ $found -eq 1 ] || echo "$id $kind"
  done
}

# as_text <id>: the same with the change in the text, compiled alone.
as_text() {
  local id=$1 test place=$work/text.$1
  mkdir -p "$place/concino/$(dirname "$header")"
  awk -v first="$first" -v only="$id" -v header="$header" -f scripts/mutate.awk "$tree/include/concino/$(file_of "$header")" >"$place/concino/$(file_of "$header")"
  local verdict=survived
  for test in $tests; do
    if ! compile "$place" "$test" "$place/run" "$place/log"; then
      verdict=uncompiled
      break
    fi
    if ! limited "$test" "$place/run"; then
      verdict="killed $test"
      break
    fi
  done
  rm -rf "$place"
  echo "$id $verdict text"
}
# file_of <header>: with its extension.
file_of() {
  [ -e "$tree/include/concino/$1.ipp" ] && echo "$1.ipp" || echo "$1.hpp"
}
export -f limited mutant mutant_by_kind as_text compile file_of
export kinds

# All wanted headers with all their mutants in them, and every test of the table compiled with those, once. Lines that do not compile so
# are left as they were, and the rest is tried again.
headers=() all_tests=()
declare -A tests_of first_of
while read -r header tests; do
  [ -n "$header" ] || continue
  if [ ${#wanted[@]} -gt 0 ]; then
    case " ${wanted[*]} " in *" $(basename "$header") "* | *" $header "*) ;; *) continue ;; esac
  fi
  headers+=("$header")
  tests_of[$header]=$tests
  for test in $tests; do
    case " ${all_tests[*]} " in *" $test "*) ;; *) all_tests+=("$test") ;; esac
  done
done <<<"$table"
[ ${#headers[@]} -gt 0 ] || { echo "no such header: ${wanted[*]}"; exit 2; }
work=$build/work
overlay=$work/overlay
rm -rf "$work"
for header in "${headers[@]}"; do
  mkdir -p "$overlay/concino/$(dirname "$header")" "$work/$header"
  : >"$work/$header/unfit"
done
for test in "${all_tests[@]}"; do mkdir -p "$(dirname "$work/$test")"; done
switch() {
  local header first=1
  for header in "${headers[@]}"; do
    first_of[$header]=$first
    awk -v first="$first" -v only=0 -v header="$header" -v list="$work/$header/list.tsv" -v unfit="$work/$header/unfit" -f scripts/mutate.awk \
      "$tree/include/concino/$(file_of "$header")" >"$overlay/concino/$(file_of "$header")" || exit 1
    first=$((first + $(wc -l <"$work/$header/list.tsv")))
  done
}
switch
for test in "${all_tests[@]}"; do
  while [ "$(jobs -rp | wc -l)" -ge "$jobs" ]; do sleep 0.2; done
  compile "$overlay" "$test" "$work/$test.run" "$work/$test.log" &
done
wait
missing=()
for test in "${all_tests[@]}"; do
  for round in 1 2 3 4 5 6 7 8; do
    [ -x "$work/$test.run" ] && break
    [ $round -eq 1 ] && cp "$work/$test.log" "$work/log" || { compile "$overlay" "$test" "$work/$test.run" "$work/log" && break; }
    changed=0
    for header in "${headers[@]}"; do
      sed -nE "s|.*overlay/concino/$header\.[hi]pp:([0-9]+):[0-9]+: +error: .*|\1|p" "$work/log"
    done | grep -q . && pattern='[0-9]+: +error: .*' || pattern='.*'
    for header in "${headers[@]}"; do
      sed -nE "s|.*overlay/concino/$header\.[hi]pp:([0-9]+):$pattern|\1|p" "$work/log" | sort -u - "$work/$header/unfit" >"$work/unfit"
      cmp -s "$work/unfit" "$work/$header/unfit" || { changed=1; mv "$work/unfit" "$work/$header/unfit"; }
    done
    [ $changed -eq 1 ] || [ $round -eq 1 ] || { cat "$work/log"; break; }
    switch
  done
  TIMEFORMAT=%U
  if ! { time CONCINO_CORPUS=/nonexistent CONCINO_MUTANTS_MET=$work/$test.met "$work/$test.run" >"$work/log" 2>&1; } 2>"$work/seconds"; then
    cat "$work/log"
    echo "$test fails or does not compile without any mutant"
    missing+=("$test")
  fi
  if [ $by_kind -eq 1 ]; then
    for kind in $kinds; do
      CONCINO_CORPUS=/nonexistent CONCINO_MUTANTS_MET=$work/$test.$kind.met "$work/$test.run" --test-case="*<concino::$kind>*" >/dev/null 2>&1
    done
  fi
  awk '{ print int(2 + 5 * $1) }' "$work/seconds" >"$work/$test.limit"
done
echo "compiled ${#all_tests[@]} tests with all mutants of ${#headers[@]} headers ($SECONDS s)"

killed_of_all=0 survivors_of_all=0 explained_of_all=0
for header in "${headers[@]}"; do
  start=$SECONDS
  work=$build/work/$header
  tests=${tests_of[$header]}
  first=${first_of[$header]}
  export work tests header first tree build compiler
  if [ "$show" -ne 0 ]; then
    awk -F'\t' -v id="$show" '$1 == id' "$work/list.tsv"
    for test in $tests; do CONCINO_MUTANT=$show "$build/work/$test.run" -nv; done
    continue
  fi
  cut -f1 "$work/list.tsv" | xargs -P "$jobs" -I{} bash -c 'mutant {}' >"$work/verdicts" 2>/dev/null
  # An index of a type that has no next is no mutant. Constants that the compiler needs are compiled one by one.
  awk -F'\t' 'NR == FNR { split($0, part, " "); if (part[2] == "unmet") unmet[part[1]] = 1; next } !($1 in unmet) || ($4 == "switch" && $5 ~ /^index /) { next }
    $4 == "text" { print $1 > text; next } { print $1, "survived unmet" }' text="$work/text.all" "$work/verdicts" "$work/list.tsv" >"$work/verdicts.all"
  grep -v ' unmet$' "$work/verdicts" >>"$work/verdicts.all"
  # Not all of those, unless asked for: evenly chosen.
  [ ! -e "$work/text.all" ] || awk -v n="$(grep -c . "$work/text.all")" -v most="$most_text" 'int(NR * most / n) != int((NR - 1) * most / n) || n <= most' "$work/text.all" >"$work/text"
  [ ! -e "$work/text" ] || while read -r id; do as_text "$id"; done <"$work/text" >>"$work/verdicts.all" 2>/dev/null
  awk -F'\t' -v OFS='\t' 'NR == FNR { i = index($0, " "); verdict[substr($0, 1, i - 1)] = substr($0, i + 1); next } ($1 in verdict) { print $1, verdict[$1], $2 ":" $3, $5, $6 }' \
    "$work/verdicts.all" "$work/list.tsv" >"$work/result.tsv"

  # Lines of equivalent_mutants.txt: header, change (* for any), part of the line, reason; with tabs between. One of them that is not used
  # may be of a mutant that was not chosen to be compiled.
  awk -F'\t' -v header="$header" -v survivors="$work/survivors" -v results="$work/result.tsv" -v list="$work/list.tsv" '
    function explains(i, how, line) { return (change[i] == "*" || change[i] == how) && index(line, text[i]) }
    BEGIN { printf "" > survivors }
    FILENAME != results { if ($0 !~ /^#/ && NF == 4 && $1 == header) { ++n; change[n] = $2; text[n] = $3 } next }
    $2 ~ /^killed/ { ++killed; next }
    $2 ~ /^uncompiled/ { next }
    {
      for (i = 1; i <= n; ++i) if (explains(i, $4, $5)) { ++explained; used[i] = 1; next }
      ++survived
      print > survivors
    }
    END {
      while ((getline <list) > 0) if ($4 == "text") for (i = 1; i <= n; ++i) if (explains(i, $5, $6)) used[i] = 1
      for (i = 1; i <= n; ++i) if (!used[i]) print header ": explained, but there is no such survivor: " change[i] " in " text[i] > "/dev/stderr"
      print killed + 0, survived + 0, explained + 0
    }' scripts/equivalent_mutants.txt "$work/result.tsv" >"$work/counts" || exit 1
  read -r killed survived explained <"$work/counts"
  awk -F'\t' '{ print "survivor: " $3 ": " $4 "    " $5 ($2 ~ /unmet/ ? "    (no test comes here)" : "") "  [" $1 "]" }' "$work/survivors"
  printf '%-28s %4d mutants, %4d killed, %3d survived, %3d equivalent  (%d s)\n' "$header" $((killed + survived + explained)) "$killed" "$survived" "$explained" $((SECONDS - start))
  if [ $by_kind -eq 1 ]; then
    awk -F'\t' '$2 ~ /^killed/ && $2 !~ /text/ { print $1 }' "$work/result.tsv" | xargs -P "$jobs" -I{} bash -c 'mutant_by_kind {}' >"$work/by_kind" 2>/dev/null
    awk -F'\t' 'NR == FNR { split($0, part, " "); kinds[part[1]] = kinds[part[1]] " " part[2]; next } $1 in kinds { print "not found by tests of" kinds[$1] ": " $3 ": " $4 "    " $5 }' \
      "$work/by_kind" "$work/result.tsv"
  fi
  killed_of_all=$((killed_of_all + killed)) survivors_of_all=$((survivors_of_all + survived)) explained_of_all=$((explained_of_all + explained))
done
echo "$((killed_of_all + survivors_of_all + explained_of_all)) mutants, $killed_of_all killed, $survivors_of_all survived, $explained_of_all equivalent"
[ "$survivors_of_all" -eq 0 ] && [ ${#missing[@]} -eq 0 ]
