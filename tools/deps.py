"""Reads deps.env, the only place for versions and pins."""

from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def read_deps(path=ROOT / "deps.env"):
    """Returns the NAME=VALUE lines as a dict; blank lines and # comments are skipped."""
    pairs = (line.split("=", 1) for line in path.read_text().splitlines() if line and not line.startswith("#"))
    return {name.strip(): value.strip().strip('"') for name, value in pairs}
