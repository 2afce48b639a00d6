"""Debian's own Godot package with every library it needs, unpacked into a folder, with nothing of the system touched.

The folder afterwards: `godot` (what everybody runs: a small script), `root/` (the unpacked packages), `location` (where
the folder was when the executable was patched). It is built in a temporary folder and renamed at the end, under a lock:
an interrupted fetch leaves nothing that looks finished.
"""

import fcntl
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from apt_sources import read_mirrors
from deps import read_deps

# patchelf comes along so that the machine need not have it; it runs from the unpacked folder.
PACKAGES = """godot patchelf libgl1 libgl1-mesa-dri libglx-mesa0 libegl1 libegl-mesa0 mesa-vulkan-drivers
libvulkan1""".split()
NOT_NEEDED = """./usr/share/doc ./usr/share/man ./usr/share/locale ./usr/share/lintian ./usr/share/bug ./usr/share/info
./usr/share/bash-completion ./usr/share/zsh ./usr/share/perl5 ./usr/share/debconf ./usr/share/misc ./usr/sbin ./var
./usr/lib/systemd ./usr/lib/udev ./usr/share/icons ./usr/share/applications ./usr/share/metainfo""".split()
DISK_NEEDED = 1_100_000_000  # bytes: 180 MB of packages and 650 MB unpacked, with some air

WRAPPER = """#!/bin/sh
# Debian's Godot on the libraries that came with it. The graphics drivers are found beside it, not on the system.
here=$(dirname "$(readlink -f "$0")")
root=$here/root
lib=$root/usr/lib/@TRIPLET@
: "${LIBGL_DRIVERS_PATH:=$lib/dri}" "${GBM_BACKENDS_PATH:=$lib/gbm}"
: "${__EGL_VENDOR_LIBRARY_DIRS:=$root/usr/share/glvnd/egl_vendor.d:/usr/share/glvnd/egl_vendor.d}"
if [ -z "${VK_DRIVER_FILES:-}" ]; then
\tfor icd in "$root"/usr/share/vulkan/icd.d/*.json /usr/share/vulkan/icd.d/nvidia*.json /etc/vulkan/icd.d/nvidia*.json; do
\t\t[ -e "$icd" ] && VK_DRIVER_FILES=${VK_DRIVER_FILES:+$VK_DRIVER_FILES:}$icd
\tdone
fi
[ -e /etc/fonts/fonts.conf ] || export FONTCONFIG_PATH="${FONTCONFIG_PATH:-$root/etc/fonts}"
export LIBGL_DRIVERS_PATH GBM_BACKENDS_PATH __EGL_VENDOR_LIBRARY_DIRS VK_DRIVER_FILES
exec "$root/usr/bin/godot" "$@"
"""


class FetchError(Exception):
    """Something that the user can mend; the text says how."""


def say(text):
    print(f"engine: {text}", file=sys.stderr, flush=True)


def is_ready(directory):
    location = directory / "location"
    ready = os.access(directory / "godot", os.X_OK) and location.is_file()
    return ready and location.read_text() == str(directory)


def fetch(directory):
    """Returns the path of the executable in `directory`, after fetching it if it is not there. Raises FetchError."""
    if is_ready(directory):
        return directory / "godot"
    try:
        directory.mkdir(parents=True, exist_ok=True)
        lock = open(directory / "lock", "w", encoding="utf-8")
    except OSError as error:
        raise FetchError(f"{directory} cannot be written ({error.strerror}); set PCG_ENGINE_DIR.") from error
    with lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            say(f"waiting for another fetch into {directory}")
            fcntl.flock(lock, fcntl.LOCK_EX)
        if not is_ready(directory):
            fetch_locked(directory)
    return directory / "godot"


def fetch_locked(directory):
    for leftover in directory.glob("fetch-*"):
        shutil.rmtree(leftover, ignore_errors=True)
    (directory / "godot").unlink(missing_ok=True)
    if (directory / "root/usr/bin/godot").is_file():  # The folder was moved: only the interpreter's path is stale.
        say(f"{directory} was moved; adjusting it")
        finish(directory)
        return
    check_machine(directory)
    work = Path(tempfile.mkdtemp(prefix="fetch-", dir=directory))
    try:
        packages = download(work)
        unpack(packages, work / "root")
        (work / "root").rename(directory / "root")
        finish(directory)
    finally:
        shutil.rmtree(work, ignore_errors=True)


def check_machine(directory):
    for tool in ("apt-get", "dpkg-deb", "dpkg"):
        if not shutil.which(tool):
            raise FetchError(f"{tool} is missing: this is not Debian. Install Godot 4.6 or newer and set GODOT to it.")
    free = shutil.disk_usage(directory).free
    if free < DISK_NEEDED:
        raise FetchError(f"{directory} has {free // 1_000_000} MB free and {DISK_NEEDED // 1_000_000} MB are needed. "
                         "Make room, or set PCG_ENGINE_DIR to a folder on another disk.")


def apt(work, *arguments):
    """The command line of an apt-get that sees only the folder `work` and the machine's proxy and keys."""
    return ["apt-get", "-c", str(work / "apt.conf"), "-qq", "-y", *arguments]


def prepare_apt(work, mirror, suite):
    for folder in ("state/lists/partial", "cache/archives/partial"):
        (work / folder).mkdir(parents=True, exist_ok=True)
    (work / "status").write_text("")
    signed_by = f"[signed-by={mirror.keyring}] " if mirror.keyring else ""
    (work / "sources.list").write_text(f"deb {signed_by}{mirror.uri} {suite} main\n")
    settings = {
        "Dir::State": work / "state", "Dir::State::status": work / "status", "Dir::Cache": work / "cache",
        "Dir::Etc::sourcelist": work / "sources.list", "Dir::Etc::sourceparts": "/dev/null",
        "Dir::Etc::preferences": "/dev/null", "Dir::Etc::preferencesparts": "/dev/null",
        "APT::Sandbox::User": "root", "APT::Install-Recommends": "false", "Acquire::Languages": "none",
        "Acquire::IndexTargets::deb::DEP-11::DefaultEnabled": "false", "Acquire::Retries": "3",
    }
    lines = ["#clear APT::Update::Post-Invoke;", "#clear APT::Update::Post-Invoke-Success;", "#clear DPkg::Post-Invoke;"]
    (work / "apt.conf").write_text("\n".join(lines + [f'{k} "{v}";' for k, v in settings.items()]) + "\n")


def download(work):
    """Returns the .deb files of the engine and of everything it depends on; apt checks signatures and sums."""
    mirrors = read_mirrors()
    if not mirrors:
        raise FetchError("no Debian mirror in this machine's apt sources. Install Godot 4.6 or newer and set GODOT.")
    reasons = []
    for suite in read_deps()["ENGINE_SUITES"].split():
        for mirror in mirrors:
            prepare_apt(work, mirror, suite)
            say(f"looking for Godot in Debian {suite}")
            done = subprocess.run(apt(work, "update", "-o", "APT::Update::Error-Mode=any"), capture_output=True, text=True,
                                  check=False, stdin=subprocess.DEVNULL)
            if done.returncode == 0:
                problem = download_packages(work)
                if not problem:
                    return sorted((work / "cache/archives").glob("*.deb"))
                reasons.append(problem)
            else:
                reasons.append(done.stderr.strip())
    raise FetchError("Godot could not be fetched from the machine's Debian mirror. Is there a network? Otherwise install "
                     "Godot 4.6 or newer and set GODOT to it. apt-get said:\n" + "\n".join(reasons))


def download_packages(work):
    """Downloads into work/cache/archives, showing how far it is; returns what went wrong, or an empty string."""
    listing = subprocess.run(apt(work, "--print-uris", "install", *PACKAGES), capture_output=True, text=True, check=False)
    if listing.returncode != 0:
        return listing.stderr.strip()
    total = sum(int(line.split()[2]) for line in listing.stdout.splitlines() if line.startswith("'")) // 1_000_000
    with open(work / "log", "w+", encoding="utf-8") as log:
        child = subprocess.Popen(apt(work, "--download-only", "install", *PACKAGES), stdout=log, stderr=log,
                                 stdin=subprocess.DEVNULL)
        try:
            shown = time.monotonic()
            say(f"downloading Godot and its libraries, {total} MB, once")
            while child.poll() is None:
                time.sleep(0.2)
                if time.monotonic() - shown > 3:
                    shown = time.monotonic()
                    say(f"  {folder_size(work / 'cache/archives') // 1_000_000} of {total} MB")
        finally:
            if child.poll() is None:
                child.terminate()
                child.wait()
        log.seek(0)
        return "" if child.returncode == 0 else log.read().strip()


def folder_size(folder):
    total = 0
    for path in folder.rglob("*"):
        try:
            total += path.stat().st_size
        except FileNotFoundError:
            pass  # apt has just renamed it out of partial/
    return total


def unpack(packages, root):
    root.mkdir()
    for directory in ("usr/bin", "usr/lib", "usr/lib64"):
        (root / directory).mkdir(parents=True)
    for link in ("bin", "lib", "lib64"):  # as on every Debian: packages may still name the old places
        (root / link).symlink_to("usr/" + link)
    excludes = [f"--exclude={path}" for path in NOT_NEEDED]
    say(f"unpacking {len(packages)} packages")
    for package in packages:
        contents = subprocess.Popen(["dpkg-deb", "--fsys-tarfile", package], stdout=subprocess.PIPE)
        tar = subprocess.run(["tar", "-x", "-C", root, "--no-same-owner", "--keep-directory-symlink", *excludes],
                             stdin=contents.stdout, capture_output=True, text=True, check=False)
        contents.stdout.close()
        if contents.wait() != 0 or tar.returncode != 0:
            raise FetchError(f"{package.name} could not be unpacked: {tar.stderr.strip()}")
        package.unlink()


def fetch_templates(directory, version):
    """Debian's export templates for its engine of `version` (what --version prints), by kind, made to run on that engine's libraries."""
    package_version = version.partition("debian")[2]
    if not package_version or not is_ready(directory):
        raise FetchError(f"export templates are fetched for Debian's own Godot only, and {version or 'this engine'} is another: "
                         "unset GODOT, or export from the editor with the templates of that engine.")
    templates = {kind: directory / f"templates/{package_version}/godot-template-{kind}" for kind in ("debug", "release")}
    if not all(path.is_file() for path in templates.values()):
        work = Path(tempfile.mkdtemp(prefix="fetch-", dir=directory))
        try:
            download_templates(work, package_version, templates)
        finally:
            shutil.rmtree(work, ignore_errors=True)
    return templates


def download_templates(work, package_version, templates):
    wanted = [f"{path.name}={package_version}" for path in templates.values()]
    for suite in read_deps()["ENGINE_SUITES"].split():
        for mirror in read_mirrors():
            prepare_apt(work, mirror, suite)
            subprocess.run(apt(work, "update"), capture_output=True, check=False, stdin=subprocess.DEVNULL)
            say(f"downloading the export templates of Debian {suite}")
            if subprocess.run(apt(work, "download", *wanted), cwd=work, capture_output=True, check=False).returncode == 0:
                unpack(sorted(work.glob("*.deb")), work / "root")
                for path in templates.values():
                    path.parent.mkdir(parents=True, exist_ok=True)
                    use_libraries(work.parent / "root", work / "root/usr/bin" / path.name)
                    (work / "root/usr/bin" / path.name).rename(path)
                return
    raise FetchError(f"no Debian mirror has the export templates {package_version}. Is there a network?")


def use_libraries(root, program):
    """Makes a program of the engine's release run on the engine's unpacked libraries from wherever it lies on this machine."""
    library, loader, patchelf = patching(root)
    subprocess.run([*patchelf, "--set-interpreter", loader, "--force-rpath", "--set-rpath", library, program], check=True)


def patching(root):
    """The folder of the unpacked libraries, their loader, and the command line of the patchelf among them."""
    library = next(root.glob("usr/lib/*/libc.so.6")).parent
    loader = next(root.glob("usr/lib*/ld-linux*"), None) or next(library.glob("ld-linux*"))
    return library, loader, [loader, "--library-path", library, root / "usr/bin/patchelf"]


def finish(directory):
    """Makes the unpacked executable use the unpacked libraries, and writes the script that everybody runs."""
    root = directory / "root"
    library, loader, patchelf = patching(root)
    program = root / "usr/bin/godot"
    try:
        subprocess.run([*patchelf, "--set-interpreter", loader, "--force-rpath", "--set-rpath",
                        f"$ORIGIN/../lib/{library.name}", program], check=True)
        for path in with_paths_of_their_own(library, patchelf):
            subprocess.run([*patchelf, "--force-rpath", "--set-rpath", "$ORIGIN:$ORIGIN/pulseaudio", path], check=True)
    except subprocess.CalledProcessError as error:
        raise FetchError(f"patchelf failed on the unpacked engine; delete {directory} and try again.") from error
    wrapper = directory / "godot.tmp"
    wrapper.write_text(WRAPPER.replace("@TRIPLET@", library.name))
    wrapper.chmod(0o755)
    (directory / "location").write_text(str(directory))
    wrapper.rename(directory / "godot")
    say(f"ready: {directory / 'godot'}")


def with_paths_of_their_own(library, patchelf):
    """The libraries whose own RUNPATH would hide the executable's RPATH: libpulse and libLLVM are the known ones."""
    for path in sorted(library.glob("*.so*")):
        if path.is_symlink() or not path.is_file():
            continue
        shown = subprocess.run([*patchelf, "--print-rpath", path], capture_output=True, text=True, check=False)
        if shown.returncode == 0 and shown.stdout.strip():
            yield path
