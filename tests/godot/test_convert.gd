extends "res://tests/godot/suite.gd"
## Values go through the core's types and come back the same.

const PROBE := &"PCGConvertProbe"


## The probe is an internal class: GDScript does not know its name.
func _round_trip(value: Variant) -> Variant:
	return ClassDB.class_call_static(PROBE, &"round_trip", value)


func test_vectors_and_colors_come_back() -> void:
	check_equal(_round_trip(Vector2(1.5, -2.25)), Vector2(1.5, -2.25), "Vector2")
	check_equal(_round_trip(Vector3(1.5, -2.25, 1e6)), Vector3(1.5, -2.25, 1e6), "Vector3")
	check_equal(_round_trip(Color(0.25, 0.5, 1.0, 0.75)), Color(0.25, 0.5, 1.0, 0.75), "Color")


func test_text_comes_back_with_all_its_letters() -> void:
	for text: String in ["", "plain", "Straße, café, Ωmega, 家族, 🏙", "two\nlines\tand a tab"]:
		check_equal(_round_trip(text), text, "String")
	var texts := PackedStringArray(["a", "", "ü"])
	check_equal(_round_trip(texts), texts, "PackedStringArray")


func test_lists_of_points_come_back_in_order() -> void:
	var points := PackedVector3Array([Vector3(0, 1, 2), Vector3(-3, 4.5, 6), Vector3(7, 8, -9)])
	check_equal(_round_trip(points), points, "PackedVector3Array")
	check_equal(_round_trip(PackedVector3Array()), PackedVector3Array(), "no points")


func test_upright_frames_come_back_whichever_way_they_look() -> void:
	for degrees: float in [0.0, 30.0, 90.0, 180.0, 271.0]:
		var frame := Transform3D(Basis(Vector3.UP, deg_to_rad(degrees)), Vector3(3, 0.5, -7))
		var back: Transform3D = _round_trip(frame)
		check(back.is_equal_approx(frame), "a frame turned by %s degrees: %s became %s" % [degrees, frame, back])


func test_attribute_overrides_keep_their_kind() -> void:
	var attributes := {"height": 12.5, "is_shop": true, "style": "brick"}
	check_equal(_round_trip(attributes), attributes, "Dictionary")
	check_equal(_round_trip({"floors": 3}), {"floors": 3.0}, "whole numbers become numbers")


func test_an_attribute_of_another_kind_is_left_out_with_a_message() -> void:
	expect_message("attribute \"where\" must be a number, true or false, or text")
	check_equal(_round_trip({"where": Vector3.ONE, "height": 1.0}), {"height": 1.0}, "Dictionary")


func test_a_diagnostic_keeps_its_place() -> void:
	var found: Dictionary = ClassDB.class_call_static(PROBE, &"sample_diagnostic")
	var expected := {"severity": "warning", "id": "sample", "file": "ä.cga", "line": 3, "column": 7, "message": "a message",
			"hint": "a hint", "source": "Lot --> X"}
	check_equal(found, expected, "Dictionary")
