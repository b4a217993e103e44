#!/usr/bin/env bash
# Tries the README's commands where nothing is installed: in a new Debian 12 root, on a copy of the last commit.
#   scripts/bare_machine.sh          ./demo.sh as a user without rights, who is told what to install, and as root; ./test.sh as root, who also builds
#                                    and runs a program with the library that is installed
#   scripts/bare_machine.sh --demo   ./demo.sh alone
# Needs root, and mmdebstrap, which it installs. Environment: CONCINO_BARE_BUILD (default build/bare: the root, some 5 GB after ./test.sh, and the logs),
# CONCINO_JOBS.
set -u
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1
. scripts/packages.sh

demo_only=0
case "${1:-}" in
  '') ;;
  --demo) demo_only=1 ;;
  *) sed -n '2,7s/^# //p' "$0"; exit 2 ;;
esac
[ "$(id -u)" -eq 0 ] || { echo "scripts/bare_machine.sh needs root" >&2; exit 1; }
install_parts bare_root || exit 1

build=${CONCINO_BARE_BUILD:-build/bare}
mkdir -p "$build" || exit 1
build=$(cd "$build" && pwd)
root=$build/root
unmount() { umount "$root/proc" 2>/dev/null; }
unmount
rm -rf --one-file-system "$root"

say() { printf '[%4d s] %s\n' $SECONDS "$*"; }
fail() {
  say "FAILED: $*"
  exit 1
}
trap unmount EXIT
trap 'exit 1' INT TERM

say "a new Debian 12 root"
mmdebstrap --variant=apt bookworm "$root" >"$build/mmdebstrap.log" 2>&1 || { tail "$build/mmdebstrap.log"; fail "mmdebstrap"; }
cp /etc/resolv.conf "$root/etc/resolv.conf"
for file in /etc/apt/apt.conf.d/*; do # how packages are reached from here
  [ -e "$root/etc/apt/apt.conf.d/${file##*/}" ] || cp "$file" "$root/etc/apt/apt.conf.d/"
done
mount -t proc proc "$root/proc" || fail "mount"
mkdir -p "$root/home/new/concino"
git archive HEAD | tar -x -C "$root/home/new/concino" || fail "git archive"
chroot "$root" useradd --home-dir /home/new new && chroot "$root" chown -R new: /home/new || fail "useradd"

# inside <user> <log> <command>: runs it in the checkout, with an environment of its own.
inside() {
  local user=$1 log=$build/$2.log home=/root
  [ "$user" = root ] || home=/home/$user
  chroot --userspec="$user" "$root" env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME="$home" LC_ALL=C.UTF-8 \
    CONCINO_JOBS="${CONCINO_JOBS:-2}" bash -c "cd /home/new/concino && $3" >"$log" 2>&1
}
show() { tail -n 40 "$build/$1.log"; }

say "./demo.sh as a user without rights, where packages are missing"
! inside new demo_refused ./demo.sh || fail "the demo runs although packages are missing"
line=$(sed -n 's/^  \(apt-get install .*\)/\1/p' "$build/demo_refused.log")
[ -n "$line" ] || { show demo_refused; fail "the demo does not print the line to type"; }
say "root types: $line"
inside root typed "apt-get update -q && $line </dev/null" || { show typed; fail "the line does not install"; }
say "./demo.sh as root"
inside root demo ./demo.sh && head -c 8 "$root/home/new/concino/demo.png" | grep -q PNG || { show demo; fail "the demo"; }
! grep Installing "$build/demo.log" || fail "the line to type lacks packages"
grep -E '^(extrema|render)' "$build/demo.log"
[ $demo_only -eq 0 ] || exit 0

say "./test.sh as root"
inside root test ./test.sh || { show test; fail "./test.sh"; }
tail -n 1 "$build/test.log"

say "a program with the installed library"
inside root consumer '
  . scripts/packages.sh && CXX=$(find_gcc || find_clang) && export CXX &&
  cmake --preset release -B build/installed -D CONCINO_BUILD_TOOLS=OFF && cmake --build build/installed && cmake --install build/installed --prefix /opt/concino &&
  cmake -G Ninja -S tests/consumers/find_package -B build/consumer -D CMAKE_PREFIX_PATH=/opt/concino -D CONCINO_LINK=compiled -D CONCINO_SOURCE="$PWD" &&
  cmake --build build/consumer && build/consumer/consumer' || { show consumer; fail "the program of a user"; }
say "done"
