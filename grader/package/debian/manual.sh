#!/bin/sh
# STAFF ONLY. Makes a manual page of a program's help: manual.sh PROGRAM VERSION PAGE.GZ
set -eu
name=$("$1" --help | sed -n 's/^[a-z]*: //p; q')
[ -n "$name" ] || name=$("$1" --help | head -1)
help2man --no-info --no-discard-stderr --version-string "$(basename "$1") $2" --name "$name" "$1" | gzip -9nc >"$3"
