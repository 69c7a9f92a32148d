#!/bin/sh
# STAFF ONLY. Gradescope runs it once, as root with a network, when it makes the image: it installs packages,
# builds, and grades the reference (or stubs, before the deadline), so that a hand-in compiles only itself.
set -eu
source=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
sh "$source/hair/grader/setup.sh"
# /usr/bin/g++ compiles all. Ubuntu 22.04's is older than grading needs, and it has 12, too.
if ! /usr/bin/g++ -ftrivial-auto-var-init=pattern -fsyntax-only -x c++ /dev/null 2>/dev/null; then
  DEBIAN_FRONTEND=noninteractive apt-get -qq install --no-install-recommends g++-12 </dev/null >/dev/null
  ln -sf g++-12 /usr/bin/g++
fi
sh "$source/hair/grader/setup.sh" "$PARTS"
chmod -R go= "$source"

# The cache then has precompiled headers, and the reference's results.
warm=$(mktemp -d)
mkdir "$warm/submission"
cp "$source/hair/reference/"*/*.cpp "$warm/submission"
echo '{"created_at": "-", "users": [{"id": 1}]}' >"$warm/submission_metadata.json"
sh "$source/run_autograder" "$warm"
rm -rf "$warm"
chmod -R go= "$source"
