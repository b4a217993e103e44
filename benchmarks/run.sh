#!/bin/sh
# Builds the benchmarks for this processor, runs them all, prints one table and writes the same as JSON.
# usage: benchmarks/run.sh [--json FILE] [--build FOLDER] [options of the programs: --rounds 5, --only load.tri1m, --base bunny.obj, --tiny]
# With --tiny, each program compares its results with those of its peers on small meshes.
set -eu
export CONCINO_NUM_THREADS=${CONCINO_NUM_THREADS:-1}  # one thread, as the peers and the loops by hand
source=$(cd "$(dirname "$0")/.." && pwd)
build=$source/build/benchmarks
json=
options=
while [ $# -gt 0 ]; do
  case $1 in
    --json) json=$2; shift 2 ;;
    --build) build=$2; shift 2 ;;
    *) options="$options $1"; shift ;;
  esac
done
json=${json:-$build/benchmarks.json}

mkdir -p "$build"
cmake -S "$source" -B "$build" -DCMAKE_BUILD_TYPE=Release -DCONCINO_BUILD_BENCHMARKS=ON \
  -DCONCINO_BUILD_TESTS=OFF -DCONCINO_BUILD_EXAMPLES=OFF -DCONCINO_BUILD_TOOLS=OFF > "$build/log" 2>&1 || { cat "$build/log"; exit 1; }
cmake --build "$build" --target benchmarks >> "$build/log" 2>&1 || { cat "$build/log"; exit 1; }

rows=
# With large pages, so that the first access to memory costs the same for all.
for program in $(cat "$build/benchmarks/programs"); do
  # shellcheck disable=SC2086  # options are words
  GLIBC_TUNABLES=glibc.malloc.hugetlb=1 "$build/benchmarks/$program" --out "$build/$program.tsv" $options
  rows="$rows $build/$program.tsv"
done
# shellcheck disable=SC2086
awk -v json="$json" -v about="$(sed -n 's/^CMAKE_CXX_COMPILER:[^=]*=//p' "$build/CMakeCache.txt"), $(date +%F)" \
  -f "$source/benchmarks/report.awk" "$source/benchmarks/budgets.tsv" $rows
echo "written: $json"
