#!/usr/bin/env bash
# What clang-tidy says of the headers, by the checks of .clang-tidy; fails if it says anything. Adapters are left out: they need their libraries.
# usage: scripts/clang_tidy.sh <scratch folder>
set -u
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1
scratch=${1:?usage: scripts/clang_tidy.sh <scratch folder>}
tidy=$(command -v clang-tidy-14 || command -v clang-tidy) || { echo "no clang-tidy (Debian: clang-tidy-14)"; exit 1; }
mkdir -p "$scratch" || exit 1
for header in $(find concepts include -name '*.hpp' -not -path '*/detail/*' | sort | sed -E 's,^(concepts|include)/,,'); do echo "#include <$header>"; done >"$scratch/all_headers.cpp"
"$tidy" --quiet --config-file=.clang-tidy "$scratch/all_headers.cpp" -- -std=c++20 -Iinclude -Iconcepts -isystem /usr/include/eigen3 2>"$scratch/errors.txt" ||
  { cat "$scratch/errors.txt"; exit 1; }
