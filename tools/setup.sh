# What ./dev's commands need, each seen to once: Debian packages, the engine, the build, the engine's import of the project.
# Sourced by ./dev in the repository root. A second call of anything here does nothing needless.

# Each package with a command or a file by which it is recognised, wherever that came from.
PACKAGES="
g++ ${CXX:-g++}
scons scons
ccache ccache
python3 python3
libglm-dev /usr/include/glm/glm.hpp
libtinygltf-dev /usr/include/tiny_gltf.h
nlohmann-json3-dev /usr/include/nlohmann/json.hpp
libstb-dev /usr/include/stb/stb_image_write.h
doctest-dev /usr/include/doctest/doctest.h
"
. ./deps.env
export PYTHONDONTWRITEBYTECODE=1
mkdir -p build out
: >build/.gdignore
: >out/.gdignore

say() { echo "dev: $*" >&2; }

fail() {
	say "$*"
	exit 1
}

need_command() { command -v "$1" >/dev/null || fail "$1 is missing; install it (Debian: apt-get install $1)"; }

# Runs a command with its output in a log, and says every five seconds that it is still at it.
with_progress() {
	local log=$1 label=$2 started=$SECONDS status=0
	shift 2
	say "$label"
	"$@" </dev/null >"$log" 2>&1 &
	local child=$!
	while kill -0 $child 2>/dev/null; do
		sleep 0.1
		(((SECONDS - started) % 5 != 4)) || { sleep 1 && say "  $((SECONDS - started)) s"; }
	done
	wait $child || status=$?
	return $status
}

missing_packages() {
	local package probe
	while read -r package probe; do
		case $probe in
		"") ;;
		/*) [ -e "$probe" ] || echo "$package" ;;
		*) command -v "${probe%% *}" >/dev/null || echo "$package" ;;
		esac
	done <<<"$PACKAGES"
}

need_packages() {
	local missing
	missing=$(missing_packages | xargs)
	[ -n "$missing" ] || return 0
	command -v apt-get >/dev/null ||
		fail "missing, under their Debian names: $missing. Install them (vcpkg.json lists the libraries) and call again."
	if [ "$(id -u)" != 0 ]; then
		say "these packages are missing; this installs them:"
		echo "sudo apt-get install $missing" >&2
		exit 1
	fi
	export DEBIAN_FRONTEND=noninteractive
	with_progress build/apt.log "updating the package lists" apt-get update -q || true
	with_progress build/apt.log "installing $missing" apt-get install -y -q --no-install-recommends $missing || {
		tail -n 20 build/apt.log >&2
		fail "apt-get could not install them. Is there a network?"
	}
}

# A screen in memory, for pictures and tests of the editor. Who cannot have one goes without, and is told what is left out where that is.
want_screen() {
	local PACKAGES="
xvfb xvfb-run
xauth xauth"
	if [ -n "$(missing_packages)" ] && command -v apt-get >/dev/null && [ "$(id -u)" = 0 ]; then
		(need_packages) || say "going on without a screen in memory"
	fi
}

# Sets GODOT to the engine and sees that build/api describes it.
need_engine() {
	GODOT=$(python3 tools/engine.py dump) || exit 1
	export GODOT
}

build() {
	scons -Q "$@" 2>&1 | sed -u '/is up to date\.$/d; / 0 files changed/d' >&2 || {
		say "the build failed"
		return 1
	}
}

# The engine with a home of its own, so that no run reads or leaves anything in the user's.
headless() {
	local home=$PWD/build/home
	mkdir -p "$home"
	XDG_DATA_HOME=$home XDG_CONFIG_HOME=$home XDG_CACHE_HOME=$home "$@"
}

# The engine loads the extensions that .godot/extension_list.cfg names; on a fresh checkout nothing has written it yet.
need_import() {
	local list=.godot/extension_list.cfg manifest=res://addons/pcg/pcg.gdextension stamp=.godot/imported.stamp changed
	mkdir -p .godot
	grep -qsx "$manifest" $list || echo "$manifest" >$list
	changed=$(find project.godot addons demo rules tests/godot -newer $stamp -print -quit 2>&1 || true)
	[ -n "$changed" ] || return 0
	with_progress build/import.log "the engine imports the project" headless "$GODOT" --headless --path . --import || {
		cat build/import.log >&2
		[ -e .godot/global_script_class_cache.cfg ] || fail "the engine could not import the project"
		say "the engine stopped while importing, after what matters was done; going on"
	}
	touch $stamp
}
