"""STAFF ONLY. What .ci/alone and .ci/tidy have found is kept below ~/.cache for 30 days after its last use."""

import contextlib
import os
import pathlib
import time

KEPT_DAYS = 30


def folder(name):
    """The folder of that name, made if it is missing, without what is old."""
    path = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") / name
    path.mkdir(parents=True, exist_ok=True)
    for kept in path.iterdir():
        with contextlib.suppress(FileNotFoundError):  # another run has removed or renamed it
            if kept.stat().st_mtime < time.time() - KEPT_DAYS * 86400:
                kept.unlink()
    return path
