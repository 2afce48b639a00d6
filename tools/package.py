#!/usr/bin/env python3
"""Zips addons/pcg, as the Asset Library wants it: the same input gives the same bytes, whatever the clock says."""

import sys
import zipfile
from pathlib import Path

from deps import ROOT, read_deps

ADDON = ROOT / "addons/pcg"
EPOCH = (1980, 1, 1, 0, 0, 0)  # the earliest time that a zip can hold


def entries():
    """Yields (name in the archive, file) in order; README and LICENSE travel inside the addon."""
    files = {f"addons/pcg/{path.relative_to(ADDON).as_posix()}": path for path in ADDON.rglob("*") if path.is_file()}
    for name in ("README.md", "LICENSE.md"):
        files.setdefault(f"addons/pcg/{name}", ROOT / name)
    yield from sorted(files.items())


def write_package(target):
    target.parent.mkdir(exist_ok=True)
    partial = target.with_suffix(".tmp")
    with zipfile.ZipFile(partial, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name, path in entries():
            entry = zipfile.ZipInfo(name, EPOCH)
            entry.external_attr = (0o755 if name.endswith(".so") else 0o644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, path.read_bytes())
    partial.replace(target)


def main():
    if not list(ADDON.glob("bin/libpcg.*")) or not (ADDON / "pcg.gdextension").is_file():
        print("package: the addon is not built; ./dev package builds it first", file=sys.stderr)
        return 1
    target = ROOT / "out" / f"pcg-{read_deps()['VERSION']}.zip"
    write_package(target)
    print(f"package: {target.relative_to(ROOT)}, {target.stat().st_size // 1024} KiB")
    return 0


if __name__ == "__main__":
    sys.exit(main())
