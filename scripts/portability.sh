#!/usr/bin/env bash
# Compiles every public header alone for another standard library or system, with warnings as errors, and runs tests there; fails if one fails.
# usage: scripts/portability.sh libcxx|windows <build folder> [headers|tests]
#   libcxx    clang++ with libc++: all headers, adapters too, and one file of tests of each module
#   windows   MinGW: all headers, and those of adapters that need headers only; the tests of concepts, graph, operators and fields, and of files, by wine64
# Where something is absent, it prints SKIPPED and what it leaves out. Environment: CONCINO_JOBS (2).
set -u
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1
. scripts/packages.sh
usage() { sed -n '3,5s/^# //p' "$0"; exit 2; }
[ $# -eq 2 ] || [[ ${3:-} =~ ^(headers|tests)$ ]] || usage
jobs=${CONCINO_JOBS:-2}
source_folder=$PWD
mkdir -p "$2/logs" "$2/objects" && build=$(cd "$2" && pwd) || exit 1
failures=$build/failures.txt
: >"$failures"

warnings=(-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror)
flags=(-std=c++20 -O0 -DFMT_HEADER_ONLY -I"$source_folder/concepts" -I"$source_folder/include" -I"$source_folder/adapters"
  -I"$source_folder/tests" -isystem /usr/include/eigen3 -DCONCINO_TEST_FEW_KINDS
  "-DCONCINO_TEST_DEFAULT_CORPUS=\"$source_folder/tests/small_corpus\"" "-DCONCINO_TEST_SMALL_CORPUS=\"$source_folder/tests/small_corpus\"")

case $1 in
  libcxx)
    compiler=$(find_clang) || { echo "SKIPPED: libc++: no clang++ 14 or later"; exit 0; }
    flags+=(-stdlib=libc++ -isystem /usr/include/suitesparse -isystem /usr/include/lib3mf)
    link=(-pthread)
    if ! echo '#include <vector>' | "$compiler" "${flags[@]}" -x c++ -fsyntax-only - 2>/dev/null; then
      echo "SKIPPED: libc++: not installed (Debian: $(packages_of libcxx | xargs))"
      exit 0
    fi
    adapters='*.hpp'
    run=()
    ;;
  windows)
    compiler=x86_64-w64-mingw32-g++-posix
    command -v $compiler >/dev/null || { echo "SKIPPED: Windows: no $compiler (Debian: $(packages_of windows | xargs))"; exit 0; }
    # Headers of this system must not be found, so only those of libraries are in the include path.
    mkdir -p "$build/include"
    for library in boost doctest fmt Spectra stb tetgen.h; do ln -sfn /usr/include/$library "$build/include/$library"; done
    flags+=(-isystem "$build/include")
    link=(-static)
    adapters='^(boost_graph|doctest|eigen|spectra|span|stb|tetgen)\.hpp$'
    wine=$(command -v wine64 || ls /usr/lib/wine/wine64 2>/dev/null) || wine=
    run=("$wine")
    export WINEPREFIX=$build/wine WINEDEBUG=-all
    ;;
  *) usage ;;
esac

# compile <what> <argument...>: one call of the compiler. Prints its messages and notes <what> if it fails.
compile() {
  local what=$1 log=$build/logs/${1//\//_}.txt
  shift
  "$compiler" "${flags[@]}" "${warnings[@]}" "$@" >"$log" 2>&1 && return
  echo "$what does not compile:"
  grep -E 'error' "$log" | head -n 5
  echo "$what" >>"$failures"
}

# in_turn <command...>: runs it in the background as soon as fewer than $jobs run.
in_turn() {
  while [ "$(jobs -rp | wc -l)" -ge "$jobs" ]; do wait -n; done
  "$@" &
}

header() {
  echo "#include <$1>" >"$build/objects/${1//\//_}.cpp"
  compile "$1" -fsyntax-only "$build/objects/${1//\//_}.cpp"
}

public_headers() {
  (cd concepts && find concino -name '*.hpp' -not -path '*/detail/*'; cd ../include && find concino -name '*.hpp' -not -path '*/detail/*') | sort
  (cd adapters/concino/adapters && ls ./*.hpp) | sed 's,^\./,,' | { [ "$adapters" = '*.hpp' ] && cat || grep -E "$adapters"; } | sed 's,^,concino/adapters/,'
}

# program <name> <source...>: compiles and links tests.
program() {
  local name=$1 object objects=() source
  shift
  for source in tests/main.cpp "$@"; do
    object=$build/objects/${name}_$(basename "$source" .cpp).o
    objects+=("$object")
    rm -f "$object"
    in_turn compile "$source" "${options[@]}" -c "$source" -o "$object"
  done
  wait
  "$compiler" "${flags[@]}" "${objects[@]}" "${link[@]}" -o "$build/$name.exe" >"$build/logs/$name.link.txt" 2>&1 || { echo "$name does not link" | tee -a "$failures"; return 1; }
}

# tests <name> <source...>: compiles, links and runs tests.
tests() {
  local name=$1
  program "$@" || return
  "${run[@]}" "$build/$name.exe" --no-path-filenames=1 >"$build/logs/$name.run.txt" 2>&1 && return
  echo "the tests $name fail:"
  grep -vE '^SKIPPED' "$build/logs/$name.run.txt" | head -n 40
  echo "$name" >>"$failures"
}

options=()
if [ "${3:-headers}" = headers ]; then
  for h in $(public_headers); do in_turn header "$h"; done
  wait
fi

if [ "${3:-tests}" != tests ]; then
  :
elif [ "$1" = libcxx ]; then
  for file in concepts/verbs core/parallel mesh/native_mesh geometry/measure quality/poly_quality graph/components validate/check_laws operators/laplacian \
    solve/ldlt optimize/qp edit/edge_flip level_sets/isolines convert/convert remesh/decimate fields/harmonic_map lines/trace_geodesic generate/grid \
    testing/conformance io/numbers io/save render/png; do
    tests "${file//\//_}" "tests/${file}_test.cpp"
  done
elif [ -z "$wine" ]; then
  echo "SKIPPED: Windows: no wine64 to run tests (Debian: $(packages_of wine | xargs))"
else
  tests standard_files tests/io/standard_files.cpp
  # The usual format of objects holds fewer sections than a batch has. The names of all sections of an object are limited to 10 MB, which functions that are
  # not inlined exceed.
  options=(-Wa,-mbig-obj -O1)
  batch_size=60000
  for folder in concepts graph operators fields; do
    # shellcheck disable=SC2046
    tests "$folder" $(cd "$build" && cmake -D tests="$source_folder/tests/$folder" -D CONCINO_TEST_BATCH_SIZE=$batch_size -P "$source_folder/scripts/test_batches.cmake")
  done
fi

[ ! -s "$failures" ] || { echo "$(wc -l <"$failures") failures; logs: $build/logs"; exit 1; }
