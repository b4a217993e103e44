#!/usr/bin/env bash
# Checks names and sentences: no header declares a name of scripts/words.txt, and no sentence of the pages and of the contracts has more than 40 words.
#   scripts/check_words.sh [--names | --sentences] [file...]   prints file:line: what is wrong; the exit code is 1 where something is
#   scripts/check_words.sh --statistics [file...]              prints how long sentences are, by file and in all, and those of more than 40 words
# Without files: the pages of the repository and the headers of concepts/, include/ and adapters/. Names need Universal Ctags: without it the exit
# code is 3. scripts/sentences.awk says what a sentence is, scripts/check_contracts.awk which comments of a header are contracts.
set -u
scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd) || exit 1

what=all
case "${1-}" in
  --names | --sentences | --statistics) what=${1#--}; shift ;;
  -*) sed -n '2,6s/^# //p' "$0"; exit 2 ;;
esac
if [ $# -eq 0 ]; then
  cd "$scripts/.." || exit 1
  mapfile -t files < <(ls README.md CONTRIBUTING.md CHANGELOG.md docs/*.md tests/README.md; find concepts include adapters -name '*.[hi]pp' | sort)
else
  files=("$@")
fi
pages=() headers=() sources=()
for file in "${files[@]}"; do
  case "$file" in
    *.md) pages+=("$file") ;;
    *.hpp) headers+=("$file") sources+=("$file") ;;
    *) sources+=("$file") ;;
  esac
done
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT

# What is declared in the sources: name, kind, file and line, with tabs between them. Requires-clauses, which ctags cannot read, are left out, and
# concepts are declared as variables. The file's own name counts too.
declared_names() {
  cp --parents "${sources[@]}" "$scratch" || return 1
  cd "$scratch" || return 1
  sed -E -i 's/^ *requires .*$//; s/(^|[^A-Za-z_0-9])concept ([A-Za-z_0-9]+) *=/\1constexpr bool \2 =/' "${sources[@]/#/./}"
  printf '%s\n' "${sources[@]}" | awk '{ name = $0; sub(/.*\//, "", name); sub(/\.[^.]*$/, "", name); print name "\tfile\t" $0 "\t1" }'
  printf '%s\n' "${sources[@]/#/./}" | "$ctags" -x --_xformat='%N	%K	%F	%n' --languages=C++ --langmap=C++:.hpp.ipp --kinds-C++=+p-hn -L - |
    sed 's,	\./,	,'
}

# Fails with 1 where a name is wrong, with 3 where there is no Universal Ctags.
check_names() {
  local ctags
  [ ${#sources[@]} -gt 0 ] || return 0
  ctags=$(command -v ctags-universal || command -v ctags) && "$ctags" --version | grep -q 'Universal Ctags' || {
    echo "no Universal Ctags (Debian: universal-ctags): names are not checked" >&2
    return 3
  }
  (declared_names) | sort -u -t '	' -k3,3 -k4,4n -k1,1 | awk -v table="$scripts/words.txt" -f "$scripts/check_names.awk"
}

prose() {
  [ ${#pages[@]} -eq 0 ] || awk -f "$scripts/markdown_prose.awk" "${pages[@]}"
  [ ${#headers[@]} -eq 0 ] || awk -v prose=1 -f "$scripts/check_contracts.awk" "${headers[@]}"
}

wrong=0
if [ $what = all ] || [ $what = names ]; then
  check_names || wrong=$?
fi
if [ $what = all ] || [ $what = sentences ]; then
  prose | awk -f "$scripts/sentences.awk" || wrong=1
fi
if [ $what = statistics ]; then
  prose >"$scratch/prose"
  awk -v statistics=1 -f "$scripts/sentences.awk" "$scratch/prose"
  awk -f "$scripts/sentences.awk" "$scratch/prose"
fi
exit $wrong
