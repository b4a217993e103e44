# The Debian packages that concino's scripts use, and how they are installed. Sourced by test.sh and demo.sh.

packages_core=(cmake ninja-build libeigen3-dev libboost-dev libfmt-dev)
packages_demo=("${packages_core[@]}" libembree-dev glmark2-data)
packages_test=("${packages_demo[@]}" libstb-dev doctest-dev libclang-rt-14-dev lld libopenmesh-dev libcgal-dev libsuitesparse-dev libspectra-dev libtet1.5-dev zlib1g-dev python3-meshio universal-ctags)
packages_long=(clang-tidy-14 doxygen)

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

# Installs what is missing of the given packages: as root, or by sudo where it asks for no password. Otherwise prints the line to type
# and fails. On a system without apt-get the packages are taken to be there under other names; CMake will tell.
install_packages() {
  local missing=() package as=()
  command -v apt-get >/dev/null 2>&1 && command -v dpkg-query >/dev/null 2>&1 || return 0
  for package in "$@"; do
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
