# Finds compilers, and installs the Debian packages of the parts that a script needs. Sourced by the scripts, which are in the folder above or below.

packages_list=$(dirname "${BASH_SOURCE[0]}")/../cmake/packages.txt

# The packages of the given parts, as cmake/packages.txt names them.
packages_of() {
  local part
  for part in "$@"; do
    awk -v part="$part" '$1 == part { found = 1; for (k = 2; k <= NF; k++) print $k } END { exit !found }' "$packages_list" || {
      echo "cmake/packages.txt has no part $part" >&2
      return 1
    }
  done
}

# The first compiler of the given names whose major version is at least $1.
find_compiler() {
  local least=$1 name version
  shift
  for name in "$@"; do
    command -v "$name" >/dev/null 2>&1 || continue
    version=$("$name" -dumpversion 2>/dev/null)
    if [ "${version%%.*}" -ge "$least" ] 2>/dev/null; then
      echo "$name"
      return 0
    fi
  done
  return 1
}
find_gcc() { find_compiler 12 g++-12 g++; }
find_clang() { find_compiler 14 clang++-14 clang++; }

# Installs what is missing of the packages of the given parts: as root, or by sudo where it asks for no password. Otherwise prints the line to type
# and fails. On a system without apt-get the packages are taken to be there under other names; CMake will tell.
install_parts() {
  local missing=() package as=() packages
  packages=$(packages_of "$@") || return 1
  command -v apt-get >/dev/null 2>&1 && command -v dpkg-query >/dev/null 2>&1 || return 0
  for package in $packages; do
    case "$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null)" in
      "install ok installed") ;;
      *) missing+=("$package") ;;
    esac
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  if [ "$(id -u)" -ne 0 ]; then
    if command -v sudo >/dev/null 2>&1 && sudo -n true >/dev/null 2>&1; then
      as=(sudo -n)
    else
      echo "These packages are missing. As root:" >&2
      echo "  apt-get install -y --no-install-recommends ${missing[*]}" >&2
      return 1
    fi
  fi
  echo "Installing: ${missing[*]}"
  local log
  log=$(mktemp)
  if "${as[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -q </dev/null >"$log" 2>&1 &&
    "${as[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}" </dev/null >>"$log" 2>&1; then
    rm -f "$log"
    return 0
  fi
  tail -n 30 "$log" >&2
  rm -f "$log"
  echo "apt-get could not install: ${missing[*]}" >&2
  return 1
}
