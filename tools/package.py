#!/usr/bin/env python3
"""Makes two zips in out/: addons/pcg, as the Asset Library wants it, with the rules that ship and what its user reads; and a project that
opens at once, with the demo. The same input gives the same bytes, whatever the clock says."""

import re
import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

from deps import ROOT, read_deps

ADDON = ROOT / "addons/pcg"
EPOCH = (1980, 1, 1, 0, 0, 0)  # the earliest time that a zip can hold

# Copied into the addon with the places that they have here, so that links between them hold. Identities stay behind (`.uid` files, and the line
# in `.import` files): who copies a rule file or a picture into a game would have two files of one identity. The demo's project has them where
# they are here, and with their identities, which its scenes know.
TRAVELLING = ("README.md", "LICENSE.md", "CHANGELOG.md", "docs/.gdignore", "docs/language-*.md", "docs/*-by-example.md", "docs/citizens.md", "docs/troubleshooting.md",
               "docs/getting-started.md", "docs/cookbook.md", "docs/performance.md", "docs/images/editor_*.png", "rules/**/*")
# What README.md says of this repository alone stands between these comments.
OF_REPOSITORY = re.compile(rb"\n<!-- repository -->\n.*?<!-- /repository -->(?=\n)", re.DOTALL)


DEMO = ("project.godot", "demo/**/*")
STRIP = {b"\x7fELF": "strip", b"MZ": "x86_64-w64-mingw32-strip"}  # by how a library begins


def files_of(*patterns):
    return [path for pattern in patterns for path in ROOT.glob(pattern) if path.is_file()]


def addon_entries():
    """Yields (name in the archive, content) in order."""
    files = {path.relative_to(ADDON): path for path in files_of("addons/pcg/**/*")}
    files |= {path.relative_to(ROOT): path for path in files_of(*TRAVELLING) if path.suffix != ".uid"}
    for name, path in sorted(files.items()):
        content = content_of(path)
        if path.suffix == ".import" and ADDON not in path.parents:
            content = re.sub(rb"^uid=.*\n", b"", content, flags=re.MULTILINE)
        yield f"addons/pcg/{name.as_posix()}", content


def demo_entries():
    for path in sorted(set(files_of("addons/pcg/**/*", *TRAVELLING, *DEMO))):
        yield path.relative_to(ROOT).as_posix(), content_of(path)


def content_of(path):
    content = path.read_bytes()
    if path.suffix == ".md":
        return OF_REPOSITORY.sub(b"", content)
    if path.parent == ADDON / "bin":
        return stripped(path, content)
    return content


def stripped(path, content):
    """The library without what a debugger wants, two thirds of it; as it is where this machine has no tool for its kind."""
    tool = next((shutil.which(tool) for start, tool in STRIP.items() if content.startswith(start)), None)
    if not tool:
        return content
    with tempfile.NamedTemporaryFile() as target:
        subprocess.run([tool, "--strip-debug", "-o", target.name, path], check=True)
        return Path(target.name).read_bytes()


def write_package(target, entries):
    target.parent.mkdir(exist_ok=True)
    partial = target.with_suffix(".tmp")
    with zipfile.ZipFile(partial, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name, content in entries:
            entry = zipfile.ZipInfo(name, EPOCH)
            entry.external_attr = (0o755 if name.endswith(".so") else 0o644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)
    partial.replace(target)
    print(f"package: {target.parent.name}/{target.name}, {target.stat().st_size // 1024} KiB")


def main():
    if not list(ADDON.glob("bin/libpcg.*")) or not (ADDON / "pcg.gdextension").is_file():
        print("package: the addon is not built; ./dev package builds it first", file=sys.stderr)
        return 1
    version = read_deps()["VERSION"]
    write_package(ROOT / f"out/pcg-{version}.zip", addon_entries())
    write_package(ROOT / f"out/pcg-{version}-demo.zip", demo_entries())
    return 0


if __name__ == "__main__":
    sys.exit(main())
