"""The Debian mirrors that this machine already uses, read from its own apt configuration.

Both forms of apt's sources are understood: deb822 (*.sources) and one line an entry (sources.list, *.list).
"""

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Mirror:
    uri: str
    keyring: str  # path of a key file, or "" for the keys that the machine trusts anyway


def _keyring(value):
    return value if value.startswith("/") and Path(value).is_file() else ""


def parse_deb822(text):
    """Yields (uri, keyring) for each enabled binary entry of a deb822 sources file."""
    for stanza in text.split("\n\n"):
        fields, name = {}, ""
        for line in stanza.splitlines():
            if line.startswith("#") or not line.strip():
                continue
            if line[0] in " \t":
                fields[name] = fields.get(name, "") + " " + line.strip()
            elif ":" in line:
                name, value = line.split(":", 1)
                name = name.strip().lower()
                fields[name] = value.strip()
        if fields.get("enabled", "yes").lower() == "no" or "deb" not in fields.get("types", "").split():
            continue
        for uri in fields.get("uris", "").split():
            yield uri, _keyring(fields.get("signed-by", ""))


def parse_one_line(text):
    """Yields (uri, keyring) for each `deb [options] uri suite component..` line."""
    for line in text.splitlines():
        line = line.split("#", 1)[0].strip()
        if not line.startswith(("deb ", "deb\t", "deb[")):
            continue
        rest, options = line[3:].strip(), ""
        if rest.startswith("["):
            options, _, rest = rest[1:].partition("]")
        signed_by = [o.split("=", 1)[1] for o in options.split() if o.lower().startswith("signed-by=")]
        if rest.split():
            yield rest.split()[0], _keyring(signed_by[0] if signed_by else "")


def read_mirrors(etc=Path("/etc/apt")):
    """Returns the mirrors in the order of the machine's files; security archives carry no engine and are left out."""
    found = []
    for path in [etc / "sources.list", *sorted((etc / "sources.list.d").glob("*"))]:
        if not path.is_file() or path.suffix not in (".list", ".sources"):
            continue
        parse = parse_deb822 if path.suffix == ".sources" else parse_one_line
        found += [Mirror(uri, key) for uri, key in parse(path.read_text(errors="replace"))]
    usable = [m for m in found if m.uri.split(":")[0] in ("http", "https", "file", "copy", "mirror", "mirror+file")]
    return list(dict.fromkeys(m for m in usable if "security" not in m.uri))
