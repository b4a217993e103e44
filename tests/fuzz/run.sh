#!/usr/bin/env bash
# Fuzzes the readers of the library with libFuzzer, the address sanitizer and the undefined behaviour sanitizer.
#   tests/fuzz/run.sh SECONDS [reader...]    each reader for that many seconds; default: all (CONCINO_FUZZ=list <program> lists them); 0 only compiles,
#                                            without optimisation, as for up to 10 seconds
# Prints a line per reader, and the input and the report of what is found. Fails if anything is found.
# Environment: CONCINO_FUZZ_BUILD (default build/fuzz; keeps the inputs that were found interesting), CONCINO_CORPUS (default ../shared/data),
# CONCINO_FUZZ_PROGRAM (a built program, else it is compiled), CXX (clang++), CONCINO_JOBS (2: readers at a time).
set -u
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 1
. scripts/packages.sh

case "${1:-}" in
  '' | *[!0-9]*) sed -n '2,7s/^# //p' tests/fuzz/run.sh; exit 2 ;;
esac
seconds=$1
shift
build=${CONCINO_FUZZ_BUILD:-build/fuzz}
corpus=${CONCINO_CORPUS:-../shared/data}
mkdir -p "$build" || exit 1
build=$(cd "$build" && pwd)

# A program for a few seconds, as in test.sh, is not optimised: the compiler would take longer than it runs.
level=-O1 name=fuzz_readers
[ "$seconds" -gt 10 ] || level=-O0 name=fuzz_readers_O0
program=${CONCINO_FUZZ_PROGRAM:-$build/$name}
if [ -z "${CONCINO_FUZZ_PROGRAM:-}" ]; then
  newest=$(find concepts include tests/fuzz -type f -newer "$program" -print -quit 2>/dev/null)
  if [ ! -x "$program" ] || [ -n "$newest" ]; then
    cxx=${CXX:-$(find_clang)} || { echo "no clang++ 14 or later"; exit 1; }
    eigen=$(pkg-config --cflags eigen3 2>/dev/null || echo -I/usr/include/eigen3)
    "$cxx" -std=c++20 $level -g1 -fsanitize=fuzzer,address,undefined -fno-sanitize=function -fno-sanitize-recover=all -Iinclude -Iconcepts -Iadapters -Itests ${eigen//-I/-isystem } \
      tests/fuzz/fuzz_readers.cpp -lz -o "$program" || exit 1
  fi
fi
[ "$seconds" -gt 0 ] || exit 0
grep -qx "${1:-obj}" <(CONCINO_FUZZ=list "$program") || { echo "no reader ${1:-obj}; there are:"; CONCINO_FUZZ=list "$program"; exit 2; }

# The extensions of a reader's files, to find seeds in the corpus.
extensions() {
  case "$1" in
    medit) echo mesh ;;
    gmsh) echo msh ;;
    abaqus) echo inp ;;
    slices) echo cli ;;
    fields) echo txt ;;
    hybrid) echo hybrid HYBRID ;;
    *) echo "$1" ;;
  esac
}

# Runs of a few seconds, as in test.sh, try the same inputs each time; longer ones try others.
seed=0
[ "$seconds" -gt 10 ] || seed=1

# fuzz_reader <reader>
fuzz_reader() {
  local reader=$1 extension code speed
  local seeds=$build/$reader.seeds inputs=$build/$reader.inputs log=$build/$reader.log
  mkdir -p "$seeds" "$inputs"
  CONCINO_FUZZ=$reader CONCINO_FUZZ_SEEDS=$seeds "$program" || return 1
  for extension in $(extensions "$reader"); do
    [ ! -d "$corpus" ] || find "$corpus" -name "*.$extension" -size -32k -exec cp -f {} "$seeds" \; 2>/dev/null
  done
  chmod -R u+w "$seeds"
  CONCINO_FUZZ=$reader "$program" -seed=$seed -max_total_time="$seconds" -max_len=4096 -timeout=20 -rss_limit_mb=2048 -malloc_limit_mb=1024 -print_final_stats=1 \
    -dict=tests/fuzz/words.dict -artifact_prefix="$build/$reader-" "$inputs" "$seeds" >"$log" 2>&1
  code=$?
  speed=$(sed -n 's/^stat::average_exec_per_sec: *//p' "$log")
  if [ $code -eq 0 ]; then
    echo "$reader: nothing found in $seconds s, ${speed:-0} executions per second"
    return 0
  fi
  echo "$reader: FOUND, see $log"
  grep -aE -A 12 'FINDING|ERROR|runtime error|libc\+\+abi|terminate' "$log" | head -n 40
  grep -a 'Test unit written' "$log"
  return 1
}

export CONCINO_NUM_THREADS=1  # threads cost more than they gain on small meshes
jobs=${CONCINO_JOBS:-2}
failed=0 running=0
for reader in $(if [ $# -gt 0 ]; then echo "$@"; else CONCINO_FUZZ=list "$program"; fi); do
  if [ $running -ge "$jobs" ]; then
    wait -n || failed=1
    running=$((running - 1))
  fi
  fuzz_reader "$reader" &
  running=$((running + 1))
done
while [ $running -gt 0 ]; do
  wait -n || failed=1
  running=$((running - 1))
done
exit $failed
