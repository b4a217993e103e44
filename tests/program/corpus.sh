#!/usr/bin/env bash
# Every file of the corpus, the malformed ones too, through the commands of the program: documented exit codes, and a sentence if something is wrong.
#   corpus.sh <program> <source folder>
set -u
program=$1
corpus=${CONCINO_CORPUS:-$2/../shared/data}
[ -d "$corpus/bad" ] || { echo "SKIPPED: program/corpus: $corpus is absent"; exit 0; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0 runs=0

# allow <codes> <argument...>: runs the program, which returns one of the codes; if it is above 1, it says why in a line.
allow() {
  local codes=$1 got
  shift
  "$program" "$@" >"$work/out" 2>"$work/err" </dev/null
  got=$?
  runs=$((runs + 1))
  if [[ " $codes " != *" $got "* ]]; then
    echo "FAILED: concino $*: exit code $got: $(head -c 300 "$work/err")"
    failures=$((failures + 1))
  elif [ $got -gt 1 ] && ! tail -n 1 "$work/err" | grep -q '^concino: .'; then
    echo "FAILED: concino $*: exit code $got without a sentence"
    failures=$((failures + 1))
  fi
  return $got
}

while IFS= read -r file; do
  allow "0 3" info "$file" || continue
  allow "0 1" validate "$file"
  for extension in obj off ply stl vtu vtk mesh tet hedra hybrid ovm; do
    rm -f "$work/to.$extension"
    allow "0 4" convert "$file" "$work/to.$extension" || continue
    allow 0 info "$work/to.$extension"
  done
  allow "0 3 4" repair "$file" "$work/mended.vtu" --merge 0 --orient --fill 8 --collapse
  allow "0 3" render "$file" -o "$work/x.png" --size 64x48 --quality draft --edges
done < <(find "$corpus" -type f -size -1000k \( -name '*.obj' -o -name '*.off' -o -name '*.mesh' -o -name '*.meshb' -o -name '*.vtk' -o -name '*.vtu' \
  -o -name '*.vtp' -o -name '*.tet' -o -name '*.hedra' -o -name '*.hybrid' -o -name '*.iv' -o -name '*.ply' -o -name '*.stl' -o -name '*.ovm' \) | sort)
echo "$runs calls"
[ $runs -gt 100 ] || { echo "FAILED: only $runs calls"; exit 1; }
[ $failures -eq 0 ]
