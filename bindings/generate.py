#!/usr/bin/env python3
"""Generates the bindings that a set of sources needs from the engine's API dump.

usage: generate.py --api extension_api.json --interface gdextension_interface.h --sources DIR [DIR ...] --out DIR
       generate.py --api extension_api.json --sources DIR [DIR ...] --profile build_profile.json [--check]

The first form writes OUT/include and OUT/src; files that would not change keep their time stamps. The second writes
(or with --check only compares) the list of engine classes that upstream's build profile wants.
"""

import argparse
import hashlib
import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from generator import builtins, classes, globals, interface, sources  # noqa: E402
from generator.api import Api  # noqa: E402
from generator.output import Output  # noqa: E402


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--api", required=True, help="the engine's --dump-extension-api")
    parser.add_argument("--interface", help="the engine's --dump-gdextension-interface")
    parser.add_argument("--sources", nargs="+", required=True, help="folders whose #includes choose the classes")
    parser.add_argument("--out", help="where to write the generated files")
    parser.add_argument("--precision", choices=("single", "double"), help="of real_t; default: as in the dump")
    parser.add_argument("--profile", help="write upstream's build profile here")
    parser.add_argument("--check", action="store_true", help="with --profile: write nothing, fail if a class is missing")
    return parser.parse_args(arguments)


def generate_all(api, options, included):
    output = Output(options.out)
    interface.generate(output, options.interface)
    builtins.generate(output, api)
    globals.generate(output, api)
    names = sources.with_ancestors(api, included)
    classes.generate(output, api, names)
    output.remove_others()
    print(f"bindings: {len(names)} engine classes, {output.changed} files changed ({api.version})")


def inputs_key(options, headers):
    """Changes whenever the generated files may change."""
    key = hashlib.sha256(repr((sorted(headers), options.precision)).encode())
    for path in (options.api, options.interface):
        status = os.stat(path)
        key.update(f"{status.st_size} {status.st_mtime_ns}".encode())
    for path in sorted(Path(__file__).resolve().parent.glob("**/*.py")):
        key.update(path.read_bytes())
    return key.hexdigest()


def generate_if_changed(options, headers):
    stamp = Path(options.out) / "inputs.txt"
    key = inputs_key(options, headers)
    if stamp.exists() and stamp.read_text() == key:
        return
    api = Api(options.api, options.precision)
    generate_all(api, options, sources.classes_of(api, headers))
    stamp.write_text(key)


def write_profile(path, names):
    Path(path).write_text(sources.profile_text(names), encoding="utf-8")
    return 0


def check_profile(path, names):
    """A class too many only costs upstream's build a second; one too few breaks it."""
    listed = sources.profile_classes(path)
    for name in sorted(listed - names):
        print(f"{path}: nothing includes {name} any more")
    for name in sorted(names - listed):
        print(f"{path}: {name} is missing; run bindings/generate.py as bindings/README.md says")
    return 1 if names - listed else 0


def main(arguments):
    options = parse_arguments(arguments)
    headers = sources.included_headers(options.sources)
    if options.out:
        if not options.interface:
            raise SystemExit("--out needs --interface")
        generate_if_changed(options, headers)
    if options.profile:
        names = sources.profile_names(sources.classes_of(Api(options.api), headers))
        return (check_profile if options.check else write_profile)(options.profile, names)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
