"""Writes addons/pcg/pcg.gdextension from its template, deps.env and the icons that are there."""

from pathlib import Path

from deps import ROOT, read_deps


def write_manifest(target, source, env):
    """An SCons action; an icon is named after the class that it stands for."""
    values = read_deps()
    icons = sorted((ROOT / "addons/pcg/icons").glob("*.svg"))
    values["ICONS"] = "\n".join(f'{icon.stem} = "res://addons/pcg/icons/{icon.name}"' for icon in icons)
    text = Path(str(source[0])).read_text()
    for name, value in values.items():
        text = text.replace(f"@{name}@", value)
    Path(str(target[0])).write_text(text.rstrip() + "\n")
