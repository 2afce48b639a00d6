extends Node
## What every headless test file extends: `extends "res://tests/godot/suite.gd"`, then methods named test_*.
##
## A fresh suite node stands in the tree for each method, so a test may add children, await frames and signals; what it
## added is freed afterwards. A method may be a coroutine. Override before_each() and after_each() where needed.

var failures := PackedStringArray()
var checks := 0


func before_each() -> void:
	pass


func after_each() -> void:
	pass


## Counts one expectation; `what` says what should have held.
func check(condition: bool, what: String) -> void:
	checks += 1
	if not condition:
		failures.append(what)


func check_equal(actual: Variant, expected: Variant, what: String) -> void:
	checks += 1
	if typeof(actual) != typeof(expected) or actual != expected:
		failures.append("%s: %s expected, %s found" % [what, var_to_str(expected), var_to_str(actual)])


func check_near(actual: float, expected: float, tolerance: float, what: String) -> void:
	checks += 1
	if not absf(actual - expected) <= tolerance:
		failures.append("%s: %s ± %s expected, %s found" % [what, expected, tolerance, actual])


## Any ERROR: or WARNING: line of the engine fails the run, save one that holds `text`. It must then also appear.
func expect_message(text: String) -> void:
	print("EXPECTED MESSAGE: ", text)
