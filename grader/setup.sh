#!/bin/sh
# STAFF ONLY. Installs the Debian packages that are missing, then builds TARGETs in build/release.
# Usage: grader/setup.sh [--with pages|study|check|browser|lint|nightly] [TARGET...]
#   Without --with: packages for grading and hairlab. pages: also for the handout's texts as pages.
#   study: also for the reference solutions of studies. check: also for tests and benchmarks.
#   browser: also browsers for tests. lint: also for .ci/run.
#   nightly: also for .ci/nightly.
set -eu
if [ "${1-}" = --help ]; then
  sed -n '/^set /q; s/^# STAFF ONLY\. //p; s/^# / /p' "$0"
  exit
fi

to_grade() {
  sed 's/#.*//' <<'LIST'
g++                  # compiles the project, and submissions
cmake                # the build
ninja-build          # runs the build
pkg-config           # finds libseccomp, libsodium, libutf8proc and yaml-cpp
libeigen3-dev        # Eigen: linear algebra
libgtest-dev         # GoogleTest: tests, public checks, grading suite
libstb-dev           # writes pictures
libosmesa6           # OpenGL without a window: draws graded scenes
nlohmann-json3-dev   # JSON: exercises, courses, results
libcli11-dev         # the command line of hairgrade
libarchive-dev       # reads and writes .zip and .tar.gz
libpng-dev           # reads pictures; its zlib packs them
libsqlite3-dev       # the record of a class
libyaml-cpp-dev      # reads Gradescope's export
libseccomp-dev       # the sandbox's system call filter
libsodium-dev        # seeds and fingerprints: HMAC, hashes
libutf8proc-dev      # letters of names: one form for each, lower case
libhowardhinnant-date-dev # clocks of time zones
bubblewrap           # the sandbox
libmicrohttpd-dev    # hairlab live, hairgrade review: serve their pages
similarity-tester    # sim: pairs of hand-ins that share code
LIST
}

to_make_pages() {
  sed 's/#.*//' <<'LIST'
nodejs               # runs these two
katex                # formulas
node-marked          # Markdown
fonts-lmodern        # the formulas' font
fonttools            # takes its glyphs out of it
python3-brotli       # packs them
LIST
}

to_study() {
  sed 's/#.*//' <<'LIST'
libsundials-dev      # CVODE: accurate motions
LIST
}

to_check() {
  sed 's/#.*//' <<'LIST'
make                 # builds the handout as students do
libxml2-dev          # reads figures and pages
libegl1              # the other way to OpenGL: both draw the same
libegl-mesa0
libbenchmark-dev     # Google Benchmark
libhwy-dev           # Highway: vectors of the engine for full heads
LIST
}

to_browse() {
  sed 's/#.*//' <<'LIST'
chromium             # opens pages
chromium-driver      # controls chromium
firefox-esr          # opens the handout's pages
python3-selenium     # tests of pages
LIST
}

to_lint() {
  sed 's/#.*//' <<'LIST'
ccache               # remembers compiled files
clang                # the second compiler for the handout
libclang-rt-dev      # clang's sanitisers and libFuzzer
clang-format         # layout
libc++-dev           # macOS's standard library
libc++abi-dev        # its low level, for students' builds
clang-tidy           # common mistakes, names
python3              # runs clang-tidy
shellcheck           # these scripts
LIST
}

to_night() {
  sed 's/#.*//' <<'LIST'
g++-aarch64-linux-gnu # builds the checks for ARM
qemu-user            # runs them
dpkg-dev             # the Debian package: the libraries that it needs,
help2man             # manuals,
lintian              # and its rules
slurm-wlm            # a cluster on this machine
munge                # its keys
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
  # Another broken package source must not stop us: if ours is broken, the second command says so.
  $sudo apt-get -qq update </dev/null >/dev/null || true
  $sudo env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 \
    install --no-install-recommends "$@" </dev/null >/dev/null
}

with=
if [ "${1-}" = --with ]; then
  with=${2-}
  shift "$(($# < 2 ? 1 : 2))"
fi
wanted=$(to_grade)
case $with in
  '') ;;
  pages) wanted="$wanted $(to_make_pages)" ;;
  study) wanted="$wanted $(to_study)" ;;
  check) wanted="$wanted $(to_study) $(to_check)" ;;
  browser) wanted="$wanted $(to_make_pages) $(to_study) $(to_check) $(to_browse)" ;;
  lint) wanted="$wanted $(to_make_pages) $(to_study) $(to_check) $(to_browse) $(to_lint)" ;;
  nightly) wanted="$wanted $(to_make_pages) $(to_study) $(to_check) $(to_browse) $(to_lint) $(to_night)" ;;
  *)
    echo "grader/setup.sh: --with takes pages, study, check, browser, lint or nightly, not \"$with\"" >&2
    exit 2
    ;;
esac

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

if [ $# -eq 0 ]; then
  exit
fi

top=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
case $top in
  # handout/cmake/folder.cmake refuses others.
  *\\*)
    echo "grader/setup.sh: \"$top\" can't be built in: CMake takes a \\ in a folder's name for a /; move it to another folder" >&2
    exit 2
    ;;
esac
# Builds tests and benchmarks if their packages were installed once.
tests=
case $with in
  check | browser | lint | nightly) tests=ON ;;
  *) [ -f "$top/build/release/CMakeCache.txt" ] || tests=OFF ;;
esac
cmake -S "$top" --preset release ${tests:+-DBUILD_TESTING=$tests -DHAIR_BENCHMARKS=$tests} >/dev/null
if [ -t 1 ]; then
  cmake --build "$top/build/release" --parallel --target "$@"
else
  cmake --build "$top/build/release" --parallel --target "$@" -- --quiet
fi
