#!/usr/bin/env bash
# A harmonic field on a real mesh, its picture, and a page to open in a browser, which has the name of the picture:
#   ./demo.sh [--print] [mesh] [picture.png]
# By default the Stanford bunny of Debian's glmark2-data, demo.png and demo.html. Installs what it needs and builds the program
# concino the first time, which takes two minutes on two cores. It then takes some seconds; with --print the picture has more samples
# and takes more time.
set -eu
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
. "$here/scripts/packages.sh"

print=
if [ "${1:-}" = --print ]; then print=--print; shift; fi
mesh=${1:-/usr/share/glmark2/models/bunny.obj}
picture=${2:-demo.png}
build=${CONCINO_DEMO_BUILD:-$here/build/demo}

needs=(build concino fmt program)  # Embree makes the picture faster where it is installed
[ $# -gt 0 ] || needs+=(bunny)
find_gcc >/dev/null || find_clang >/dev/null || needs+=(gcc)
install_parts "${needs[@]}"
compiler=$(find_gcc || find_clang) || { echo "no g++ 12 or clang++ 14 or later" >&2; exit 1; }

log=$(mktemp)
trap 'rm -f "$log"' EXIT
if ! (cd "$here" && cmake --preset release -B "$build" -D CMAKE_CXX_COMPILER="$compiler" &&
  cmake --build "$build" --target concino_program) >"$log" 2>&1; then
  cat "$log" >&2
  exit 1
fi
# shellcheck disable=SC2086  # no word if it is empty
"$build/tools/concino" demo $print "$mesh" "$picture"
