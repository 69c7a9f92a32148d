#!/bin/sh
# STAFF ONLY. Installs the Debian packages that are missing, then builds TARGET in build/release.
# Usage: grader/setup.sh TARGET [lint]    lint: also installs what .ci/run formats, tidies and builds with
set -eu

to_build() {
  sed 's/#.*//' <<'LIST'
g++                  # compiles the project, and submissions
cmake                # the build,
ninja-build          #   and what runs it
make                 # builds the handout as students do
pkg-config           # finds libseccomp and libsodium
libeigen3-dev        # Eigen: linear algebra
libgtest-dev         # GoogleTest: tests, public checks, grading suite
libbenchmark-dev     # Google Benchmark
libbullet-dev        # Bullet: its rope is what hair is timed beside
libstb-dev           # reads and writes images
libosmesa6           # OpenGL without a window: draws what is graded
libegl1              # the other way to it: tests compare both
libegl-mesa0
nlohmann-json3-dev   # JSON: exercises, courses, results
libcli11-dev         # the command line of hairgrade
libsundials-dev      # CVODE: how things really move, which errors are measured against
libarchive-dev       # reads and writes .zip and .tar.gz
libseccomp-dev       # the sandbox's system call filter
libsodium-dev        # seeds and fingerprints: HMAC, hashes
libxml2-dev          # tests read figures and pages with it
bubblewrap           # the sandbox
patch                # makes the sample class
LIST
}

to_lint() {
  sed 's/#.*//' <<'LIST'
clang                # the second compiler for the handout
clang-format         # layout
clang-tidy           # common mistakes, names,
python3              #   and what runs it
ccache               # remembers what was compiled
shellcheck           # these scripts
chromium             # opens the pages that studies write
LIST
}

install() {
  if [ "$(id -u)" -eq 0 ]; then
    sudo=
  elif command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
    sudo=sudo
  else
    echo "Packages are missing, and only root can install them. Run this as root, then try again:" >&2
    echo "  apt-get update && apt-get install --no-install-recommends $*" >&2
    exit 2
  fi
  echo "Installing $* (this can take a few minutes)" >&2
  # Somebody else's broken package source must not stop us: if ours is broken, the second command says so.
  $sudo apt-get -qq update </dev/null >/dev/null || true
  $sudo env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 \
    install --no-install-recommends "$@" </dev/null >/dev/null
}

wanted=$(to_build)
if [ "${2-}" = lint ]; then
  wanted="$wanted $(to_lint)"
fi

# shellcheck disable=SC2086 # a list of words
if command -v apt-get >/dev/null && command -v dpkg-query >/dev/null; then
  # shellcheck disable=SC2016 # dpkg-query's own variables
  installed=" $(dpkg-query -W -f '${Package}=${db:Status-Status} ' $wanted 2>/dev/null || true)"
  missing=
  for package in $wanted; do
    case $installed in
      *" $package=installed "*) ;;
      *) missing="$missing $package" ;;
    esac
  done
  if [ -n "$missing" ]; then
    install $missing
  fi
else
  echo "Not Debian or Ubuntu, so nothing is installed. Needed is what Debian calls" $wanted >&2
fi

top=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
cmake -S "$top" --preset release >/dev/null
if [ -t 1 ]; then
  cmake --build "$top/build/release" --target "$1"
else
  cmake --build "$top/build/release" --target "$1" -- --quiet
fi
