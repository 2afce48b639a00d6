#!/usr/bin/env bash
# Builds the bindings' test extension and runs its tests in the headless engine: run.sh GODOT
# The last line is "N passed, N failed". Any error of the engine that is not expected, and any leak, counts as failed.
set -eu
godot=$(realpath "$(command -v "${1:?usage: run.sh GODOT}")")
here=$(cd "$(dirname "$0")" && pwd)
build=$here/../../build/bindings-tests
project=$build/project
log=$build/log.txt

scons -Q --silent -C "$here" -j"$(nproc)" godot="$godot" "${@:2}" >&2

rm -rf "$project"
mkdir -p "$project/bin" "$project/.godot" "$build/home"
cp "$here"/project/* "$project/"
cp "$build/libprobe.so" "$project/bin/"
echo "res://probe.gdextension" >"$project/.godot/extension_list.cfg"

status=0
HOME=$build/home timeout 120 "$godot" --headless --verbose --path "$project" --script main.gd >"$log" 2>&1 || status=$?

# Expected errors say so in their first line.
unexpected=$(grep -nE '^(SCRIPT )?ERROR:|^WARNING:|Leaked instance|Orphan StringName|ObjectDB instances leaked|still in use at exit|handle_crash' "$log" |
	grep -v 'expected' || true)
counts=$(grep -E '^[0-9]+ passed, [0-9]+ failed$' "$log" || echo "0 passed, 1 failed")
passed=${counts%% passed*}
failed=${counts#* passed, }
failed=${failed% failed}
grep -E '^FAILED' "$log" || true

complain() {
	echo "FAILED: $1"
	failed=$((failed + 1))
}
grep -q '^bindings tests: end$' "$log" || complain "the run did not reach its end (status $status); see $log"
[ "$status" -eq 0 ] || [ "$failed" -gt 0 ] || complain "the engine ended with status $status"
[ "$(grep -c 'expected' "$log")" -ge 6 ] || complain "the error macros did not report what they should"
[ -z "$unexpected" ] || complain "the engine reported: $unexpected"

# Upstream's list of classes must say what the addon's sources include.
top=$here/../..
if python3 "$here/../generate.py" --api "$build/api/extension_api.json" --sources "$top/src/godot" \
	--profile "$top/build_profile.json" --check; then
	passed=$((passed + 1))
else
	complain "build_profile.json and the sources differ"
fi
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
