#!/usr/bin/env bash
# Builds and runs the tests, after installing what they need. The last line says how many passed, failed and were skipped. On two cores:
#   ./test.sh          the tests, with clang++ and without sanitizers: 12 minutes
#   ./test.sh --full   all tests with clang++ and sanitizers, programs too, and each algorithm on each model of mesh; lessons; g++; users' projects,
#                      every header alone, fuzzing, the demo on a bare machine: up to 45 minutes. What continuous integration runs
#   ./test.sh --long   all tests with both compilers, and libc++, Windows, clang-tidy, the reference, mutations, runs of many steps, the benchmarks on
#                      tiny data, all of scripts/bare_machine.sh: hours
# Environment: CONCINO_CORPUS (folder of real mesh files; default ../shared/data), CONCINO_TEST_BUILD (default build/test), CONCINO_JOBS (2).
set -u
cd "$(dirname "${BASH_SOURCE[0]}")" || exit 1
. scripts/packages.sh

full=0 long=0
for argument in "$@"; do
  case "$argument" in
    --full) full=1 ;;
    --long) long=1 ;;
    *) sed -n '2,8s/^# //p' "$0"; [ "$argument" = --help ] && exit 0 || exit 2 ;;
  esac
done

build=${CONCINO_TEST_BUILD:-build/test}
jobs=${CONCINO_JOBS:-2}
mkdir -p "$build" || exit 1
passed=0 failed=0 finished=0
skipped_names=$build/skipped.txt
: >"$skipped_names"

finish() {
  [ $finished -eq 1 ] || failed=$((failed + 1))
  local skipped
  skipped=$(sort -u "$skipped_names" | grep -c .)
  if [ "$skipped" -gt 0 ]; then
    echo
    echo "Skipped:"
    sort -u "$skipped_names" | sed 's/^/  /'
  fi
  echo
  echo "$passed passed, $failed failed, $skipped skipped"
  [ "$failed" -eq 0 ] || exit 1
  exit 0
}
background=
trap finish EXIT
trap '[ -z "$background" ] || kill -- "-$background"; exit 1' INT TERM

say() { printf '[%3d s] %s\n' $SECONDS "$*"; }

# configure <folder> <preset> <compiler> [option...]
configure() {
  local dir=$build/$1 preset=$2 compiler=$3
  shift 3
  say "$compiler: configure ($preset)"
  if ! cmake --preset "$preset" -B "$dir" -D CMAKE_CXX_COMPILER="$compiler" -D CMAKE_COMPILE_WARNING_AS_ERROR=ON "${linker[@]}" "$@" >"$dir.configure.log" 2>&1; then
    cat "$dir.configure.log"
    failed=$((failed + 1))
    return 1
  fi
}

# Compilers take memory from the C library in large pages and keep it. Page faults take clang++ up to a quarter of its time otherwise.
memory=glibc.malloc.hugetlb=1:glibc.malloc.top_pad=67108864:glibc.malloc.trim_threshold=1073741824:glibc.malloc.mmap_threshold=536870912

# make <folder> <what> [target...]: keeps going after an error, shows the errors, counts each file that does not build.
make() {
  local dir=$build/$1 what=$2 errors
  shift 2
  say "$what"
  GLIBC_TUNABLES=$memory cmake --build "$dir" --parallel "$jobs" --target "${@:-all}" -- -k 0 >"$dir.build.log" 2>&1 && return 0
  awk '/^\[[0-9]+\/[0-9]+\]/ { show = 0 } /^FAILED: / { show = 1 } show' "$dir.build.log" | head -n 200
  errors=$(grep -c '^FAILED: ' "$dir.build.log")
  failed=$((failed + (errors > 0 ? errors : 1)))
  say "does not build; whole log: $dir.build.log"
  return 1
}

# check <folder> <what> [ctest option...]: runs, shows the output of what failed, adds to the counts. A doctest program counts as its cases.
check() {
  local dir=$build/$1 what=$2 counts
  shift 2
  say "$what"
  ctest --test-dir "$dir" -j "$jobs" "$@" >"$dir.ctest.log" 2>&1
  counts=$(awk -v skips="$skipped_names" -f scripts/count_tests.awk "$dir/Testing/Temporary/LastTest.log" 2>"$dir.failures.log")
  cat "$dir.failures.log"
  passed=$((passed + ${counts% *}))
  failed=$((failed + ${counts#* }))
}

needs=(build concino fmt bunny doctest ctags lld meshio boost_graph cgal cholmod clipper distributed eigen embree lib3mf metis openmesh parallel_bgl petsc spectra stb tetgen zlib)
find_clang >/dev/null || needs+=(clang)
if [ $((full + long)) -gt 0 ]; then
  needs+=(sanitizers vtk browser program)
  find_gcc >/dev/null || needs+=(gcc)
fi
[ $long -eq 0 ] || needs+=(tidy reference libcxx windows openfoam)
install_parts "${needs[@]}" || exit 1
[ $long -eq 0 ] || install_parts wine || echo "the tests for Windows are compiled, and do not run"
clang=$(find_clang) || { echo "no clang++ 14 or later"; exit 1; }
[ $((full + long)) -eq 0 ] || gcc=$(find_gcc) || { echo "no g++ 12 or later"; exit 1; }

linker=()
! command -v ld.lld >/dev/null || linker=(-D CMAKE_EXE_LINKER_FLAGS=-fuse-ld=lld)  # links eighty programs in a sixth of the time

selection=(-LE 'long|full|consumers')
[ $full -eq 0 ] || selection=(-LE long)
if [ $long -eq 1 ]; then
  export CONCINO_LONG=1
  selection=()
fi

# whole <folder> <preset> <compiler> [option...]: builds and runs all that the options leave.
whole() {
  configure "$@" || return
  make "$1" "$3: build ($2)"
  check "$1" "$3: run ($2)" "${selection[@]}"
}

# headers <folder> <compiler> [option...]: every header compiles alone. What one forgets to include, either compiler finds.
headers() {
  configure "$1" dev-clang "$2" -D CONCINO_BUILD_TESTS=OFF -D CONCINO_BUILD_EXAMPLES=OFF -D CONCINO_BUILD_TOOLS=OFF -D CONCINO_BUILD_COMPILED=OFF "${@:3}" || return
  make "$1" "$2: every header alone" all_verify_interface_header_sets && passed=$((passed + 1))
}

export CONCINO_FUZZ_BUILD=$build/fuzz  # also where the target fuzz_readers builds the program

# fuzz <seconds>: every reader for that long. What is found is in the folder that the log names; each finding becomes a test.
fuzz() {
  say "$clang: fuzz every reader for $1 s"
  if CXX=$clang tests/fuzz/run.sh "$1" >"$build/fuzz.log" 2>&1; then
    passed=$((passed + 1))
  else
    grep -v ': nothing found' "$build/fuzz.log"
    failed=$((failed + 1))
  fi
}

batches=(-D CONCINO_TEST_BATCHES=ON)  # a batch of files at a time

# without <folder...>: the option that leaves these folders of tests out.
without() { local IFS=';'; echo "-DCONCINO_TEST_WITHOUT=$*"; }

# What only --full builds: lessons and programs, the matrix of algorithms and models, pages in a browser, the figures of the paper, an allocation that
# fails at every place, calls that must not compile, and checks of what headers define.
quick=(-D CONCINO_BUILD_EXAMPLES=OFF -D CONCINO_BUILD_TOOLS=OFF
  "$(without agreement browser compiled gallery must_not_compile out_of_memory program headers/twice_and_linked)")

# In --full, all tests are built with clang++ and sanitizers. g++, which takes more than twice as long, builds the tests of the concepts, and projects of
# users, one of which calls every public function.
with_gcc=" archetypes concepts consumers headers "
left_out=(gallery headers/twice_and_linked)
for folder in tests/*/; do
  folder=$(basename "$folder")
  [[ $with_gcc == *" $folder "* ]] || left_out+=("$folder")
done
fewer=(-D CONCINO_TEST_FEW_KINDS=ON -D CONCINO_BUILD_EXAMPLES=OFF -D CONCINO_BUILD_TOOLS=OFF "$(without "${left_out[@]}")")

# build_sanitized: all that clang++ compiles, in one call of ninja. Lessons compile in half of the time without sanitizers.
build_sanitized() {
  configure sanitized sanitized "$clang" "${batches[@]}" -D CONCINO_SANITIZE_EXAMPLES=OFF || return
  make sanitized "$clang: build (sanitized), every public header alone, the fuzzer" all headers_alone fuzz_readers && passed=$((passed + 1))
}

# with_both: clang++ builds in the background with all jobs while g++ builds and runs with half of them, so that no core waits for the last file of a part.
with_both() {
  local counts=$build/sanitized.counts
  rm -f "$counts"
  set -m  # a process group, which can be ended
  (
    renice -n 10 -p $BASHPID >/dev/null
    passed=0 failed=0
    build_sanitized
    echo "$passed $failed" >"$counts"
  ) &
  background=$!
  set +m
  [ "$jobs" -gt 1 ] || wait $background
  jobs=$(((jobs + 1) / 2)) whole gcc dev-gcc "$gcc" "${batches[@]}" "${fewer[@]}"
  wait $background
  background=
  read -r built not_built <"$counts" || { built=0 not_built=1; }
  passed=$((passed + built))
  failed=$((failed + not_built))
  selection=(-LE 'long|consumers')
  # Who allocated a block is not recorded, and freed blocks are kept back by the megabyte, not by hundreds: a third of the time of many tests.
  ASAN_OPTIONS=malloc_context_size=1:quarantine_size_mb=16 check sanitized "$clang: run (sanitized)" "${selection[@]}"
}

# benchmarks <compiler>: builds them and runs them on tiny data, where each compares its results with those of its peers.
benchmarks() {
  say "$1: benchmarks on tiny data"
  if CXX=$1 CMAKE_BUILD_PARALLEL_LEVEL=$jobs benchmarks/run.sh --build "$build/benchmarks" --tiny --rounds 1 >"$build/benchmarks.log" 2>&1; then
    passed=$((passed + 1))
  else
    grep -E 'error|FAILED' "$build/benchmarks.log" | head -n 50
    say "the benchmarks fail; whole log: $build/benchmarks.log"
    failed=$((failed + 1))
  fi
}

# bare_machine [--demo]: the README's commands where nothing is installed.
bare_machine() {
  say "a bare machine"
  if [ "$(id -u)" -ne 0 ] || ! command -v mmdebstrap >/dev/null; then
    echo "bare_machine: needs root and mmdebstrap (Debian: $(packages_of bare_root))" >>"$skipped_names"
  elif CONCINO_BARE_BUILD=$build/bare scripts/bare_machine.sh "$@" >"$build/bare.log" 2>&1; then
    passed=$((passed + 1))
  else
    cat "$build/bare.log"
    failed=$((failed + 1))
  fi
}

# portability <libcxx|windows> <what>: every header alone, and tests, with another standard library or for another system.
portability() {
  say "$2"
  if CONCINO_JOBS=$jobs scripts/portability.sh "$1" "$build/$1" >"$build/$1.log" 2>&1; then
    passed=$((passed + 1))
  else
    cat "$build/$1.log"
    failed=$((failed + 1))
  fi
  sed -n 's/^SKIPPED: //p' "$build/$1.log" >>"$skipped_names"
}

if [ $long -eq 1 ]; then
  whole gcc dev-gcc "$gcc"
  whole clang dev-clang "$clang"
  headers headers_gcc "$gcc" -D CONCINO_VERIFY_DETAILS=ON
  headers headers_clang "$clang" -D CONCINO_VERIFY_DETAILS=ON
  portability libcxx "$clang with libc++: every header alone, and a file of tests of each module"
  portability windows "Windows: every header alone, and tests under Wine"
  whole asan asan "$clang" "${batches[@]}"
  fuzz 300
  say "clang-tidy"
  scripts/clang_tidy.sh "$build/clang-tidy" && passed=$((passed + 1)) || failed=$((failed + 1))
  say "the reference"
  (cat docs/Doxyfile; echo "OUTPUT_DIRECTORY = $build/reference") | doxygen - && passed=$((passed + 1)) || failed=$((failed + 1))
  benchmarks "$gcc"
  say "$gcc: mutations"
  CONCINO_MUTATE_BUILD=$build/mutate CONCINO_JOBS=$jobs scripts/mutate.sh && passed=$((passed + 1)) || failed=$((failed + 1))
  bare_machine
elif [ $full -eq 1 ]; then
  with_both
  fuzz 5
  bare_machine --demo
else
  whole plain dev-clang "$clang" "${batches[@]}" -D CONCINO_TEST_FEW_KINDS=ON "${quick[@]}"
fi
say "done"
finished=1
