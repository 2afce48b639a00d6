// The checks of values: text, containers, Variants and mathematics.
#include "probe_checks.h"

#include <godot_cpp/core/class_db.hpp>

using namespace godot;

PackedStringArray ProbeChecks::run_strings() {
	_failed.clear();
	const String umlaut = String::utf8("Straße 7 – 東京 🚶");
	check(umlaut.length() == 15, "UTF-8 is counted in characters");
	check(String(umlaut.utf8().get_data()) != umlaut && String::utf8(umlaut.utf8().get_data()) == umlaut,
	      "UTF-8 there and back");
	check(umlaut.utf8().length() == 25, "UTF-8 is 25 bytes long");
	check(umlaut[4] == U'ß' && umlaut[14] == char32_t(0x1F6B6), "characters are code points");
	check(String::utf8("abcdef", 3) == "abc", "a length cuts off");
	check(String("caf\xe9").length() == 4, "a plain literal is Latin-1");
	check(String(U"\U0001F6B6").length() == 1 && String(L"wide") == "wide", "wide literals");
	String text = "a";
	text += "b";
	text += String("c");
	text += U'd';
	check(text == "abcd" && text + "e" == "abcde" && "z" + text == String("zabcd"), "text grows");
	text[0] = U'A';
	check(text == "Abcd", "a character can be replaced");
	check(vformat("%s has %d of %.1f", "x", 3, 2.5) == "x has 3 of 2.5", "vformat fills in");
	check(String("%s-%s") % Array::make(1, "b") == "1-b" && String("<%d>") % 5 == "<5>", "so does %");
	check(itos(-5) == "-5" && String::num(1.5) == "1.5" && String::num_int64(255, 16) == "ff", "numbers as text");
	check(String("12.5").to_float() == 12.5 && String("42x").is_valid_int() == false, "text as numbers");
	check(String("a,b,,c").split(",").size() == 4 && String("a,b,,c").split(",", false).size() == 3, "split");
	check(String("/a/b.txt").get_file() == "b.txt" && String("a") < String("b"), "files and order");
	check(String() == "" && String().is_empty() && String("").utf8().get_data()[0] == 0, "empty text");
	const StringName name = "walk";
	check(name == StringName("walk") && name != StringName("run") && String(name) == "walk", "names");
	const NodePath path("A/B:position");
	check(path.get_name_count() == 2 && path.get_subname(0) == StringName("position"), "node paths");
	return _failed;
}

// Long because it is a list: one check after the other.
PackedStringArray ProbeChecks::run_containers() {
	_failed.clear();
	Array array = {1, "two", Vector3(3, 3, 3)};
	Array shared = array;
	shared[0] = 10;
	check(array.size() == 3 && array[0] == Variant(10), "an Array is shared");
	int64_t seen = 0;
	for (const Variant &item : static_cast<const Array &>(array)) {
		seen += item.get_type();
	}
	check(seen == Variant::INT + Variant::STRING + Variant::VECTOR3, "an Array can be walked");
	Array moved = std::move(shared);
	check(moved.size() == 3 && shared.is_empty(), "a moved-from Array is empty and usable");

	Dictionary dictionary;
	dictionary["a"] = 1;
	dictionary[Vector2i(1, 2)] = "cell";
	check(dictionary.size() == 2 && dictionary.has(Vector2i(1, 2)) && dictionary.get("b", 9) == Variant(9),
	      "a Dictionary");
	check(dictionary.keys()[0] == Variant("a"), "keeps its order");

	PackedVector3Array points;
	points.resize(3);
	for (int64_t i = 0; i < points.size(); i++) {
		points.ptrw()[i] = Vector3(real_t(i), 0, 0);
	}
	PackedVector3Array copy = points;
	copy[1] = Vector3(9, 9, 9);
	check(points[1] == Vector3(1, 0, 0) && copy[1] == Vector3(9, 9, 9), "packed arrays are values");
	real_t sum = 0;
	for (const Vector3 &point : points) {
		sum += point.x;
	}
	check(sum == 3, "a packed array can be walked");
	check(PackedByteArray().ptr() == nullptr && PackedByteArray().is_empty(), "an empty packed array has no data");
	PackedStringArray words = {"b", "a"};
	words.sort();
	check(String(",").join(words) == "a,b", "packed strings");
	PackedInt32Array numbers = {5, 6};
	numbers.append(7);
	check(numbers.size() == 3 && numbers[2] == 7 && numbers == PackedInt32Array({5, 6, 7}), "packed numbers");
	TypedArray<Node> nodes;
	check(nodes.is_typed() && nodes.get_typed_class_name() == StringName("Node"), "a TypedArray has a type");
	return _failed;
}

PackedStringArray ProbeChecks::run_variants() {
	_failed.clear();
	Variant value = 5;
	check(value.get_type() == Variant::INT && int(value) == 5 && double(value) == 5.0, "a number converts to a number");
	check(String(value) == "5" && value != Variant(5.0), "to text; but 5 is not 5.0");
	check(Variant().get_type() == Variant::NIL && !Variant(), "an empty Variant is null and false");
	value = String("text");
	check(value.get_type() == Variant::STRING && Vector3(value) == Vector3(), "a wrong type gives the default");
	bool valid = false;
	Variant element = Variant(Array::make(1, 2)).get(1, &valid);
	check(valid && int(element) == 2, "get by index");
	check(Variant("abc").call("length") == Variant(3), "a method by name");
	Variant result;
	Variant::evaluate(Variant::OP_ADD, 2, 3, result, valid);
	check(valid && int(result) == 5, "operators");
	check(Variant(PROPERTY_HINT_RANGE) == Variant(1), "an enum is a number");
	Variant iterator;
	Variant three = 3;
	int count = 0;
	for (bool more = three.iter_init(iterator, valid); more; more = three.iter_next(iterator, valid)) {
		count += int(three.iter_get(iterator, valid));
	}
	check(count == 3, "iteration");
	check(Variant::get_type_name(Variant::PACKED_VECTOR4_ARRAY) == "PackedVector4Array", "types have names");
	Variant moved = std::move(value);
	check(String(moved) == "text", "moving keeps the value");
	check(Variant(1) < Variant(2) && Variant("k").hash() == Variant("k").hash(), "order and hash");
	return _failed;
}

PackedStringArray ProbeChecks::run_math() {
	_failed.clear();
	const Vector3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
	check(x.cross(y) == z && x.dot(y) == 0 && (x + y * 2 - z / 2) == Vector3(1, 2, -0.5), "vector arithmetic");
	check(2.0f * x == Vector3(2, 0, 0) && -x == Vector3(-1, 0, 0) && Vector3(3, 4, 0).length() == 5, "and more");
	check(x.rotated(z, real_t(Math_PI / 2)).is_equal_approx(y), "rotation turns x to y about z");
	check(Vector2(1, 0).rotated(real_t(Math_PI / 2)).is_equal_approx(Vector2(0, 1)), "in the plane too");
	check(Vector2i(7, 9) / 2 == Vector2i(3, 4) && Vector3i(7, 8, 9) % 4 == Vector3i(3, 0, 1), "whole numbers");
	const Basis turn(z, real_t(Math_PI / 2));
	check(turn.xform(x).is_equal_approx(y) && turn.get_column(0).is_equal_approx(y),
	      "a basis maps x to its first column");
	check((turn * turn.inverse()).is_equal_approx(Basis()) && Math::is_equal_approx(turn.determinant(), real_t(1)),
	      "inverse");
	check(Basis(x * 2, y * 3, z * 4).get_scale().is_equal_approx(Vector3(2, 3, 4)), "scale");
	check(Quaternion(z, real_t(Math_PI / 2)).xform(x).is_equal_approx(y), "a quaternion rotates alike");
	check(Basis(turn.get_quaternion()).is_equal_approx(turn), "basis to quaternion and back");
	const Transform3D move(turn, Vector3(5, 0, 0));
	check(move.xform(x).is_equal_approx(Vector3(5, 1, 0)) &&
	              (move.affine_inverse() * move).is_equal_approx(Transform3D()),
	      "transforms");
	check(AABB(Vector3(), Vector3(2, 2, 2)).intersection(AABB(x, Vector3(2, 2, 2))) == AABB(x, Vector3(1, 2, 2)),
	      "boxes");
	check(Rect2(0, 0, 2, 2).has_point(Vector2(1, 1)) && !Rect2(0, 0, 2, 2).has_point(Vector2(2, 2)), "rectangles");
	check(Plane(y, 2).distance_to(Vector3(0, 5, 0)) == 3, "planes");
	check(Color("#ff0000") == Color(1, 0, 0) && Color(1, 0, 0).to_html(false) == "ff0000", "colors");
	check(String(Vector3(1, 2, 3)) == "(1.0, 2.0, 3.0)", "vectors as text");
	return _failed;
}

// The same question to our own functions and to the engine's, by way of a Variant.
// Long because it is a list: one function after the other.
PackedStringArray ProbeChecks::run_math_against_engine() {
	_failed.clear();
	const Basis basis = Basis::from_euler(Vector3(0.3f, -1.1f, 2.0f)).scaled(Vector3(1, 2, 0.5f));
	const Transform3D transform(basis, Vector3(4, -5, 6));
	const Vector3 v(0.7f, -2, 3);
	auto ask = [](const Variant &p_value, const char *p_method, auto... p_args) {
		return Variant(p_value).call(p_method, p_args...);
	};
	check(basis.inverse().is_equal_approx(ask(basis, "inverse")), "Basis.inverse");
	check(basis.orthonormalized().is_equal_approx(ask(basis, "orthonormalized")), "Basis.orthonormalized");
	check(basis.get_scale().is_equal_approx(ask(basis, "get_scale")), "Basis.get_scale");
	check(basis.scaled(v).is_equal_approx(ask(basis, "scaled", v)), "Basis.scaled");
	const Basis turned = basis.orthonormalized();
	check(turned.get_quaternion().is_equal_approx(ask(turned, "get_rotation_quaternion")), "Basis.get_quaternion");
	for (int order = EULER_ORDER_XYZ; order <= EULER_ORDER_ZYX; order++) {
		const Basis ours = Basis::from_euler(Vector3(0.3f, -0.4f, 0.5f), EulerOrder(order));
		check(ours.get_euler(EulerOrder(order)).is_equal_approx(Vector3(0.3f, -0.4f, 0.5f)),
		      "Basis.from_euler in each order");
	}
	check(Basis::looking_at(v).is_equal_approx(Transform3D().looking_at(v).basis), "Basis.looking_at");
	check(Transform3D(ask(Transform3D(), "looking_at", v)).basis.is_equal_approx(Basis::looking_at(v)),
	      "like the engine");
	check(transform.affine_inverse().is_equal_approx(ask(transform, "affine_inverse")), "Transform3D.affine_inverse");
	check(transform.rotated(v.normalized(), 0.4f).is_equal_approx(ask(transform, "rotated", v.normalized(), 0.4)),
	      "rotated");
	check(transform.scaled(v).is_equal_approx(ask(transform, "scaled", v)), "Transform3D.scaled");
	check(transform.translated_local(v).is_equal_approx(ask(transform, "translated_local", v)), "translated_local");
	const Transform2D flat(0.6f, Vector2(3, 4));
	check(flat.affine_inverse().is_equal_approx(ask(flat, "affine_inverse")), "Transform2D.affine_inverse");
	check(flat.rotated(0.3f).is_equal_approx(ask(flat, "rotated", 0.3)), "Transform2D.rotated");
	const Quaternion a(Vector3(0, 1, 0), 0.5f), b(v.normalized(), 1.2f);
	check(a.slerp(b, 0.3f).is_equal_approx(ask(a, "slerp", b, 0.3)), "Quaternion.slerp");
	check(Plane(v, Vector3(1, 1, 0), Vector3(0, 2, 5))
	              .is_equal_approx(Plane(ask(Plane(v, Vector3(1, 1, 0), Vector3(0, 2, 5)), "normalized"))),
	      "a plane of three points is normalized");
	check(v.reflect(Vector3(0, 1, 0)).is_equal_approx(ask(v, "reflect", Vector3(0, 1, 0))), "Vector3.reflect");
	check(v.slide(Vector3(0, 1, 0)).is_equal_approx(ask(v, "slide", Vector3(0, 1, 0))), "Vector3.slide");
	check(v.snapped(Vector3(0.5f, 0.5f, 0.5f)).is_equal_approx(ask(v, "snapped", Vector3(0.5f, 0.5f, 0.5f))),
	      "Vector3.snapped");
	check(Vector2(1, 2).orthogonal() == Vector2(ask(Vector2(1, 2), "orthogonal")), "Vector2.orthogonal");
	const Color color(0.2f, 0.4f, 0.6f, 0.8f);
	check(color.lightened(0.3f).is_equal_approx(ask(color, "lightened", 0.3)), "Color.lightened");
	check(color.to_rgba32() == uint32_t(ask(color, "to_rgba32")), "Color.to_rgba32");
	check(Math::is_equal_approx(color.get_luminance(), float(ask(color, "get_luminance"))), "Color.get_luminance");
	return _failed;
}
