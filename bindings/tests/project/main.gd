## Tests of the bindings, run by run.sh. What only C++ can see is checked in ProbeChecks.
extends SceneTree

var _passed := 0
var _failed := 0


func _initialize() -> void:
	_test_own_checks()
	_test_values()
	_test_methods()
	_test_properties()
	_test_signals_and_enums()
	_test_objects()
	_test_resources()
	_test_lifetime()
	await _test_in_tree()
	print("%d passed, %d failed" % [_passed, _failed])
	print("bindings tests: end")
	quit(0 if _failed == 0 else 1)


func _check(is_true: bool, sentence: String) -> void:
	if is_true:
		_passed += 1
	else:
		_failed += 1
		print("FAILED: ", sentence)


func _test_own_checks() -> void:
	var checks := ProbeChecks.new()
	for method: Dictionary in checks.get_method_list():
		var title: String = method.name
		if not title.begins_with("run_"):
			continue
		for sentence: String in checks.call(title):
			_check(false, title + ": " + sentence)
	_passed += checks.get_passed()


func _test_values() -> void:
	var samples := {
		"bool": true, "int8": -128, "int16": -32768, "int32": -2147483648, "int64": -9223372036854775808,
		"uint8": 255, "uint16": 65535, "uint32": 4294967295, "uint64": 9223372036854775807, "float": 0.5, "double": 0.1,
		"string": "Straße 東京 🚶", "string_name": &"name", "node_path": ^"A/B:c",
		"vector2": Vector2(1.5, -2), "vector2i": Vector2i(1, -2), "rect2": Rect2(1, 2, 3, 4), "rect2i": Rect2i(1, 2, 3, 4),
		"vector3": Vector3(1, 2, 3), "vector3i": Vector3i(1, 2, 3), "transform2d": Transform2D(0.5, Vector2(1, 2)),
		"vector4": Vector4(1, 2, 3, 4), "vector4i": Vector4i(1, 2, 3, 4), "plane": Plane(1, 2, 3, 4),
		"quaternion": Quaternion(0.1, 0.2, 0.3, 0.9), "aabb": AABB(Vector3(1, 2, 3), Vector3(4, 5, 6)),
		"basis": Basis(Vector3(1, 2, 3), Vector3(4, 5, 6), Vector3(7, 8, 10)),
		"transform3d": Transform3D(Basis.IDENTITY.rotated(Vector3.UP, 1), Vector3(1, 2, 3)),
		"projection": Projection(Vector4(1, 2, 3, 4), Vector4(5, 6, 7, 8), Vector4(9, 1, 2, 3), Vector4(4, 5, 6, 7)),
		"color": Color(0.1, 0.2, 0.3, 0.4), "rid": RID(), "callable": _passed_count, "signal": process_frame,
		"dictionary": {"a": [1, 2]}, "array": [1, "b", null], "bytes": PackedByteArray([1, 2]),
		"int32s": PackedInt32Array([1, -2]), "int64s": PackedInt64Array([1, -2]),
		"float32s": PackedFloat32Array([0.5]), "float64s": PackedFloat64Array([0.1]),
		"strings": PackedStringArray(["ä", "b"]), "vector2s": PackedVector2Array([Vector2(1, 2)]),
		"vector3s": PackedVector3Array([Vector3(1, 2, 3)]), "colors": PackedColorArray([Color.RED]),
		"vector4s": PackedVector4Array([Vector4(1, 2, 3, 4)]),
	}
	var values := ProbeValues.new()
	for type: String in samples:
		var sample: Variant = samples[type]
		var echoed: Variant = values.call("echo_" + type, sample)
		_check(typeof(echoed) == typeof(sample) and echoed == sample, type + " comes back from a call")
		var kept: Variant = values.echo_variant(sample)
		_check(typeof(kept) == typeof(sample) and kept == sample, type + " comes back as a Variant")
	_test_values_by_fast_call(values)
	_check(values.echo_variant(null) == null, "null comes back")
	var refusal: Variant = Callable(values, "name_of").callv([null])
	_check(refusal == "null", "null is a Node")


# Typed GDScript calls go by pointers instead of Variants.
func _test_values_by_fast_call(values: ProbeValues) -> void:
	var text: String = "ö" + str(_passed)
	_check(ProbeValues.echo_string(text) == text, "fast: String")
	var vector := Vector3(1, 2, 3)
	_check(ProbeValues.echo_vector3(vector) == vector, "fast: Vector3")
	var whole: int = -5
	_check(ProbeValues.echo_int8(whole) == -5 and ProbeValues.echo_int64(whole) == -5, "fast: int")
	_check(ProbeValues.echo_uint32(4000000000) == 4000000000, "fast: uint32")
	var real: float = 0.25
	_check(ProbeValues.echo_float(real) == 0.25 and ProbeValues.echo_double(real) == 0.25, "fast: float")
	_check(ProbeValues.echo_bool(true) and not ProbeValues.echo_bool(false), "fast: bool")
	var list: Array = [1, 2]
	_check(is_same(ProbeValues.echo_array(list), list), "fast: Array stays the same Array")
	var points := PackedVector3Array([vector])
	_check(ProbeValues.echo_vector3s(points) == points, "fast: PackedVector3Array")
	var transform := Transform3D(Basis.IDENTITY, vector)
	_check(ProbeValues.echo_transform3d(transform) == transform, "fast: Transform3D")
	var nodes: Array[Node] = [root]
	_check(values.echo_nodes(nodes) == nodes and values.echo_nodes(nodes).is_typed(),
			"fast: typed Array of objects")
	var typed: Array[Vector3] = [vector]
	_check(values.echo_points(typed) == typed, "fast: typed Array of values")
	var counts: Dictionary[String, int] = {"a": 1}
	_check(values.echo_counts(counts) == counts, "fast: typed Dictionary")
	var numbers: Array[int] = values.make_numbers()
	_check(numbers == [3, 4] and numbers.is_typed(), "fast: a typed Array made in C++")


func _passed_count() -> int:
	return _passed


func _test_methods() -> void:
	var node := ProbeNode.new()
	_check(node.describe("ab") == "abab", "default arguments fill in from the end")
	_check(node.describe("ab", 3) == "ababab" and node.describe("ab", 1, true) == "AB", "and can be given")
	_check(ProbeNode.add(1) == 11 and ProbeNode.add(1, 2) == 3, "static methods")
	var info := _method_info(node, "describe")
	_check(info.args[1].name == "times" and info.default_args == [2, false],
			"names and defaults are known to the engine")
	_check(info.flags & METHOD_FLAG_CONST, "const methods are const")
	_check(_method_info(ProbeValues.new(), "echo_nodes").args[0].hint_string == "Node",
			"a typed Array names its element")
	_check(not ClassDB.can_instantiate("ProbeShape") and ClassDB.class_exists("ProbeShape"),
			"an abstract class cannot be made")
	_check(not ClassDB.class_exists("Nonsense") and ClassDB.is_parent_class("ProbeChild", "ProbeNode"),
			"inheritance is known")
	node.free()


func _method_info(object: Object, title: String) -> Dictionary:
	for method in object.get_method_list():
		if method.name == title:
			return method
	return {}


func _test_properties() -> void:
	var node := ProbeNode.new()
	_check(node.speed == 1.5, "a property has its C++ default")
	node.speed = 3
	_check(node.get("speed") == 3.0, "and can be set")
	node.second_slot = 8
	_check(node.get_slot(1) == 8 and node.first_slot == 0, "indexed properties")
	_check(node.get_slot(5) == -1, "a bad index is refused")
	_check(ClassDB.class_get_property_default_value("ProbeNode", "speed") == 1.5,
			"the engine knows the default")
	_check(_property(node, "speed").hint_string == "0,10,0.1", "the hint")
	node.mode = ProbeNode.MODE_BUSY
	_check(_property(node, "speed").hint_string == "0,20,0.1", "_validate_property changes it")
	node.set("dynamic", "x")
	_check(node.get("dynamic") == "x" and _property(node, "dynamic").hint == PROPERTY_HINT_MULTILINE_TEXT,
			"_set, _get and the list")
	_check(node.property_can_revert("dynamic") and node.property_get_revert("dynamic") == "reverted",
			"revert")
	_check(not node.property_can_revert("speed"), "only where it says so")
	_check(str(node) == "<probe 1 probe>", "_to_string")
	_check(_property(node, "Motion").usage == PROPERTY_USAGE_GROUP, "groups")
	_check(_property(node, "State").usage == PROPERTY_USAGE_SUBGROUP, "subgroups")
	node.free()
	var child := ProbeChild.new()
	child.set("dynamic", "inherited")
	_check(child.get("dynamic") == "inherited" and child.speed == 1.5,
			"a descendant inherits properties of both kinds")
	child.free()


func _property(object: Object, title: String) -> Dictionary:
	for property in object.get_property_list():
		if property.name == title:
			return property
	return {}


func _test_signals_and_enums() -> void:
	var node := ProbeNode.new()
	var heard := []
	node.speed_changed.connect(func(speed: float, sender: Node) -> void: heard.append_array([speed, sender]))
	node.speed = 4.5
	_check(heard == [4.5, node], "a signal arrives with its arguments")
	_check(ProbeNode.MODE_BUSY == 1 and ProbeNode.LIMIT == 7 and ProbeNode.PART_LEG == 2, "constants")
	_check(ProbeNode.Mode.MODE_BUSY == 1, "enums have their names")
	_check("Mode" in ClassDB.class_get_enum_list("ProbeNode", true), "the engine lists them")
	_check(ClassDB.is_class_enum_bitfield("ProbeNode", "Parts"), "bit fields")
	_check(not ClassDB.is_class_enum_bitfield("ProbeNode", "Mode"), "which other enums are not")
	var typed: ProbeNode.Mode = node.get_mode()
	node.set_mode(ProbeNode.MODE_BUSY)
	node.parts = ProbeNode.PART_ARM | ProbeNode.PART_LEG
	_check(typed == ProbeNode.MODE_IDLE and node.get_mode() == 1 and node.get_parts() == 3,
			"enums cross both ways")
	_check(_method_info(node, "set_mode").args[0].class_name == &"ProbeNode.Mode", "a method names its enum")
	node.free()


func _test_objects() -> void:
	var checks := ProbeChecks.new()
	var values := ProbeValues.new()
	var plain := Node.new()
	plain.name = "plain"
	_check(checks.wrapper_of(plain) == checks.wrapper_of(plain), "an engine object keeps its wrapper")
	_check(checks.wrapper_of(plain) != checks.wrapper_of(root), "and another has another")
	_check(values.echo_node(plain) == plain and values.echo_object(root) == root, "objects come back")
	_check(values.name_of(plain) == "plain" and values.name_of(null) == "null", "and are what they are")
	var mesh := BoxMesh.new()
	_check(values.echo_resource(mesh) == mesh, "a Ref comes back")
	_check(checks.reference_count_of(mesh) == 2,
			"and counts as it should: here and there " + str(checks.reference_count_of(mesh)))
	_check(mesh.get_reference_count() == 1, "afterwards only here")
	var script_made: Resource = (load("res://note.gd") as GDScript).new()
	_check(values.echo_resource(script_made) == script_made and script_made.call("shout") == "NOTE",
			"a resource made in GDScript")
	var child: ProbeNode = (load("res://scripted.gd") as GDScript).new()
	_check(child.describe("x") == "xx" and child.call("twice") == 3.0, "a script extends a class of ours")
	child.free()
	plain.free()
	var runtime := ClassDB.instantiate("ProbeRuntimeNode") as Node
	_check(runtime != null and not runtime.is_class("ProbeNode"), "a runtime class is a class in the game")
	runtime.free()


func _test_resources() -> void:
	var resource := ProbeResource.new()
	resource.text = "läuft"
	_check(ResourceSaver.save(resource, "user://sample.probe") == OK, "a saver in C++ saves")
	_check(FileAccess.get_file_as_string("user://sample.probe") == "läuft", "what it should")
	var loaded := load("user://sample.probe") as ProbeResource
	_check(loaded != null and loaded.text == "läuft" and loaded.resource_path == "user://sample.probe",
			"a loader in C++ loads")
	_check(load("user://sample.probe") == loaded, "and the engine caches")
	_check(ResourceLoader.get_recognized_extensions_for_type("ProbeResource").has("probe"),
			"the extension is known")
	var copy := loaded.duplicate() as ProbeResource
	_check(copy != null and copy != loaded and copy.text == "läuft", "the engine duplicates our resource")


func _test_lifetime() -> void:
	var objects := Performance.get_monitor(Performance.OBJECT_COUNT)
	var alive := ProbeNode.get_alive()
	ProbeChecks.new().churn(10000)
	_check(ProbeNode.get_alive() == alive, "10,000 nodes made and freed in C++ are gone")
	for i in 10000:
		var node := ProbeNode.new()
		node.set_meta("resource", ProbeResource.new())
		node.free()
	_check(ProbeNode.get_alive() == alive, "10,000 made and freed in GDScript too")
	_check(Performance.get_monitor(Performance.OBJECT_COUNT) == objects,
			"the engine counts as many objects as before")


func _test_in_tree() -> void:
	await process_frame
	var child := ProbeChild.new()
	root.add_child(child)
	root.remove_child(child)
	_check(child.get_heard() == PackedStringArray(["made", "entered", "child entered", "child left", "left"]),
			"notifications come to the parent class first, on the way out last: " + str(child.get_heard()))
	child.free()
	var node := ProbeNode.new()
	root.add_child(node)
	await process_frame
	await process_frame
	_check(node.get_ready_count() == 1, "_ready came once")
	_check(node.get_processed() > 0.0, "_process comes every frame")
	_check(get_nodes_in_group("probes") == [node], "groups joined in the constructor hold")
	node.queue_free()
	await process_frame
	_check(not is_instance_valid(node), "queue_free frees")
