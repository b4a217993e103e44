#!/usr/bin/env bash
# Runs every command of the program on good, bad and missing files:  commands.sh <program> <source folder>
set -u
program=$1 small=$2/tests/small_corpus
corpus=${CONCINO_CORPUS:-$2/../shared/data}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# expect <code> <argument...>: runs the program; its output is in $work/out and $work/err.
expect() {
  local code=$1 got
  shift
  "$program" "$@" >"$work/out" 2>"$work/err" </dev/null
  got=$?
  [ "$got" -eq "$code" ] || fail "concino $*: exit code $got, expected $code: $(head -c 500 "$work/err")"
}
# says <out|err> <regular expression>: what the last command wrote.
says() { grep -qE -- "$2" "$work/$1" || fail "standard $1 lacks '$2': $(head -c 500 "$work/$1")"; }
# value <name>: a number in the JSON object of the last command.
value() { sed -n "s/^  \"$1\": \([^,]*\),*$/\1/p" "$work/out"; }
equal() { [ "$2" = "$3" ] || fail "$1 is $2, expected $3"; }

# info: the figures of INDEX.tsv
files=()
declare -A kinds=([tri]=trimesh [quad]=quadmesh [polygon]=polygonmesh [tet]=tetmesh [hex]=hexmesh [polyhedral]=polyhedralmesh)
while IFS=$'\t' read -r file kind verts _ edges faces cells euler components loops _ _ _ area _; do
  expect 0 info --json "$small/$file"
  [ $kind = polygon ] || equal "kind of $file" "$(value kind)" "\"${kinds[$kind]}\""  # some polygons are all quads
  equal "verts of $file" "$(value verts)" "$verts"
  equal "edges of $file" "$(value edges)" "$edges"
  equal "components of $file" "$(value components)" "$components"
  if [ "$cells" = 0 ]; then
    equal "polys of $file" "$(value polys)" "$faces"
    equal "Euler characteristic of $file" "$(value euler)" "$euler"
    case $kind in tri) awk -v x="$(value area)" -v y="$area" 'BEGIN { exit !((x - y) ^ 2 <= 1e-16 * y ^ 2) }' || fail "area of $file" ;; esac
  else
    equal "faces of $file" "$(value faces)" "$faces"
    equal "polys of $file" "$(value polys)" "$cells"
  fi
  files+=("$file")
done < <(awk -F '\t' -v OFS='\t' 'NR > 1 { for (k = 1; k <= NF; k++) if ($k == "") $k = "-"; print }' "$small/INDEX.tsv")
[ ${#files[@]} -gt 20 ] || fail "only ${#files[@]} files"
expect 0 info "$small/tri/ball.obj"
says out '^kind +trimesh$'

# validate
expect 0 validate "$small/tri/ball.obj"
says out '^no defects$'
printf 'OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 2 1 3\n3 0 1 2\n' >"$work/double.off"
expect 1 validate "$work/double.off"
says out '^duplicated element: poly 2 has the same verts as poly 0'
expect 1 validate --all "$work/double.off"

# convert: to formats that hold the mesh and back; what cannot be held is said, or refused
for file in "${files[@]}"; do
  for extension in vtu vtk; do
    expect 0 convert "$small/$file" "$work/to.$extension"
    "$program" info --json "$work/to.$extension" 2>/dev/null | sed -n '/"verts"/,/"orientable"/p' >"$work/there"
    "$program" info --json "$small/$file" 2>/dev/null | sed -n '/"verts"/,/"orientable"/p' >"$work/here"
    cmp -s "$work/here" "$work/there" || fail "$file differs after its way through .$extension"
  done
done
# folders of OpenFOAM: FILE is the polyMesh or the case
expect 0 convert "$small/hex/block.mesh" "$work/case/constant/polyMesh"
for folder in "$work/case" "$work/case/" "$work/case/constant/polyMesh"; do
  expect 0 info --json "$folder"
  equal "kind of a case" "$(value kind)" '"hexmesh"'
  expect 0 validate "$folder"
done
expect 0 convert "$work/case" "$work/block.vtu" --kind polyhedralmesh
expect 4 convert "$small/tri/ball.obj" "$work/other/polyMesh"
says err 'polyMesh cannot hold surfaces'
[ ! -e "$work/other" ] || fail "a folder of a mesh that was refused"
expect 0 convert "$small/quad/tube.off" "$work/triangles.stl" --as-triangles
says err 'lost: '
expect 4 convert "$small/quad/tube.off" "$work/quads.stl"
says err 'cannot hold'
expect 4 convert "$small/quad/tube.off" "$work/triangles.stl" --as-triangles --strict
volume=$small/hex/block.mesh
expect 4 convert "$volume" "$work/boundary.off"
says err 'as_boundary'
expect 0 convert "$volume" "$work/boundary.off" --as-boundary
says err 'lost: '
expect 0 info --json "$work/boundary.off"
expect 0 convert "$volume" "$work/boundary.glb" --as-boundary --as-triangles
expect 3 info "$work/boundary.glb"
expect 0 convert "$small/quad/tube.off" "$work/tube.obj" --kind trimesh
expect 0 info --json "$work/tube.obj"
equal "kind after --kind trimesh" "$(value kind)" '"trimesh"'
expect 0 convert "$small/hex/block.mesh" "$work/block.vtu" --kind tetmesh
expect 4 convert "$small/hex/block.mesh" "$work/block.vtu" --kind trimesh
says err 'volume'
expect 4 convert "$small/tri/ball.obj" "$work/no/such/folder.obj"
expect 2 convert "$small/tri/ball.obj" "$work/x.obj" --kind trimeshes

# render and view
expect 0 render "$small/polyhedral/kelvin_cells.hedra" -o "$work/x.png" --size 80x60 --quality draft --slice x=0.5 --edges
[ "$(head -c 4 "$work/x.png" | tail -c 3)" = PNG ] || fail "render wrote no picture"
expect 0 geodesic "$small/tri/ball.obj" --from 0,5 -o "$work/distance.vtu"
expect 0 render "$work/distance.vtu" -o "$work/x.html" --field distance
grep -q '<canvas' "$work/x.html" || fail "render wrote no page"
expect 2 render "$work/distance.vtu" -o "$work/y.png" --field nothing
says err 'no property nothing'
expect 2 render "$small/tri/ball.obj" -o "$work/x.jpeg"
for size in 80 80x 80x0 80x60x 0x0 70000x3; do expect 2 render "$small/tri/ball.obj" -o "$work/z.png" --size $size; done
for slice in x x=a w=0.1 x=; do expect 2 render "$small/tri/ball.obj" -o "$work/z.png" --slice "$slice"; done
[ ! -e "$work/z.png" ] || fail "a refused command wrote a picture"
expect 4 render "$small/tri/ball.obj" -o "$work/no/such/folder.png" --size 8x6 --quality draft
unset DISPLAY WAYLAND_DISPLAY
TMPDIR=$work expect 0 view "$small/tri/ball.obj"
grep -q '<canvas' "$(cat "$work/out")" || fail "view wrote no page"

# repair
printf 'OFF\n6 3 0\n0 0 0\n1 0 0\n0 1 0\n1 0 1e-9\n0 1 1e-9\n1 1 0\n3 0 1 2\n3 3 4 5\n3 0 1 2\n' >"$work/torn.off"
expect 0 repair "$work/torn.off" "$work/mended.off" --merge 1e-6 --orient
says out '^done: .*merged|^done: .*verts'
expect 0 validate "$work/mended.off"
expect 0 info --json "$work/mended.off"
equal "verts after --merge" "$(value verts)" 4
equal "polys without the double one" "$(value polys)" 2
expect 0 repair "$small/tri/ball.obj" "$work/ball.obj"
says out '^nothing to do$'
expect 2 repair "$work/torn.off" "$work/mended.off" --merge -1
expect 2 repair "$work/torn.off" "$work/mended.off" --fill 4x
expect 4 repair "$work/torn.off" "$work/no/such/folder.off" --merge 0
printf 'OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n' >"$work/open.off"
expect 0 repair "$work/open.off" "$work/closed.off" --fill 3
expect 0 info --json "$work/closed.off"
equal "polys with a filled hole" "$(value polys)" 4

# harmonic
expect 0 harmonic "$small/tri/ball.obj" --values 0=0,7=1
equal "a value at each vert" "$(grep -c . "$work/out")" "$("$program" info --json "$small/tri/ball.obj" | sed -n 's/^  "verts": \(.*\),/\1/p')"
equal "the value at vert 0" "$(head -n 1 "$work/out")" 0
equal "the value at vert 7" "$(sed -n 8p "$work/out")" 1
expect 0 harmonic "$small/hex/block.mesh" --values 0=0,79=1 -o "$work/field.vtk"
expect 0 info "$work/field.vtk"
says out 'harmonic of verts \(double\)'
for values in 0 0=x x=0 -1=0 0=0,1000000=1; do expect 2 harmonic "$small/tri/ball.obj" --values=$values; done

# geodesic
expect 0 geodesic "$small/tri/ball.obj" --from 0
equal "distances" "$(grep -c . "$work/out")" "$("$program" info --json "$small/tri/ball.obj" | sed -n 's/^  "verts": \(.*\),/\1/p')"
equal "the distance from itself" "$(head -n 1 "$work/out")" 0
expect 0 geodesic "$small/tet/cube.mesh" --from 0 -o "$work/distance.txt"
expect 2 geodesic "$small/tri/ball.obj" --from 1000000
says err 'there is no vert 1000000'
expect 4 geodesic "$small/tri/ball.obj" --from 0 -o "$work/distance.obj"

# demo
expect 0 demo "$small/tri/ball.obj" "$work/demo.png"
says out '^extrema +0 at vert [0-9]+, 1 at vert [0-9]+$'
for extension in png html txt; do [ -s "$work/demo.$extension" ] || fail "the demo writes no .$extension"; done
expect 2 demo "$small/tri/ball.obj" "$work/demo.jpg"
expect 3 demo "$work/nothing.obj" "$work/demo.png"
expect 4 demo "$small/tri/ball.obj" "$work/no/such/demo.png"

# usage, and files that cannot be read
expect 0 --version
says out '^concino [0-9]+\.[0-9]+'
expect 0 --help
for command in info validate convert repair render view harmonic geodesic demo; do
  expect 0 $command --help
  says out 'Example:'
  expect 2 $command
  expect 2 $command --nonsense
done
expect 2
expect 2 nonsense
for command in "info" "validate" "view" "geodesic --from 0"; do
  # shellcheck disable=SC2086  # words
  expect 3 $command "$work/nothing.obj"
  says err '^concino: .*nothing\.obj'
  [ "$(grep -c . "$work/err")" -eq 1 ] || fail "$command says more than a sentence of a missing file"
done
expect 3 info "$work"
[ -d "$corpus/bad" ] || echo "SKIPPED: program/commands: files of bad/: $corpus/bad is absent"
for file in "$corpus"/bad/*; do
  [ -f "$file" ] || continue
  for command in info validate; do
    "$program" $command "$file" >"$work/out" 2>"$work/err"
    case $? in 0 | 1 | 3) ;; *) fail "concino $command $file: $(head -c 300 "$work/err")" ;; esac
  done
done

[ $failures -eq 0 ] || exit 1
echo "all commands do what they should"
