#!/usr/bin/env python3
"""Zips addons/pcg, as the Asset Library wants it, with the rules that ship and what its user reads: the same input gives the same bytes,
whatever the clock says."""

import re
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

from deps import ROOT, read_deps

ADDON = ROOT / "addons/pcg"
EPOCH = (1980, 1, 1, 0, 0, 0)  # the earliest time that a zip can hold

# Copied into the addon with the places that they have here, so that links between them hold. Identities stay behind (`.uid` files, and the line
# in `.import` files): who copies a rule file or a picture into a game would have two files of one identity.
TRAVELLING = ("README.md", "LICENSE.md", "CHANGELOG.md", "docs/.gdignore", "docs/language-*.md", "docs/citizens.md", "docs/troubleshooting.md",
               "docs/getting-started.md", "docs/cookbook.md", "docs/performance.md", "docs/images/editor_*.png", "rules/**/*")
# What README.md says of this repository alone stands between these comments.
OF_REPOSITORY = re.compile(rb"\n<!-- repository -->\n.*?<!-- /repository -->(?=\n)", re.DOTALL)


def entries():
    """Yields (name in the archive, content) in order."""
    files = {path.relative_to(ADDON): path for path in ADDON.rglob("*") if path.is_file()}
    for pattern in TRAVELLING:
        found = (path for path in ROOT.glob(pattern) if path.is_file())
        files |= {path.relative_to(ROOT): path for path in found if path.suffix != ".uid"}
    for name, path in sorted(files.items()):
        yield f"addons/pcg/{name.as_posix()}", content_of(path)


def content_of(path):
    content = path.read_bytes()
    if path.suffix == ".md":
        return OF_REPOSITORY.sub(b"", content)
    if path.suffix == ".import" and ADDON not in path.parents:
        return re.sub(rb"^uid=.*\n", b"", content, flags=re.MULTILINE)
    if content.startswith(b"\x7fELF"):  # what a debugger wants is two thirds of it
        with tempfile.NamedTemporaryFile() as stripped:
            subprocess.run(["strip", "--strip-debug", "-o", stripped.name, path], check=True)
            return Path(stripped.name).read_bytes()
    return content


def write_package(target):
    target.parent.mkdir(exist_ok=True)
    partial = target.with_suffix(".tmp")
    with zipfile.ZipFile(partial, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name, content in entries():
            entry = zipfile.ZipInfo(name, EPOCH)
            entry.external_attr = (0o755 if name.endswith(".so") else 0o644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)
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
