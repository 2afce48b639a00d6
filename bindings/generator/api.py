"""The API dump as Python objects, and how its types and default values are written in C++."""

import json
import re

from .names import snake_case

# Plain C++ structs, written by hand under include/godot_cpp/variant.
MATH_TYPES = {
    "Vector2", "Vector2i", "Rect2", "Rect2i", "Vector3", "Vector3i", "Transform2D", "Vector4", "Vector4i", "Plane",
    "Quaternion", "AABB", "Basis", "Transform3D", "Projection", "Color",
}
_NUMBERS = {"int": "int64_t", "float": "double", "bool": "bool"}
_METAS = {"float": "float", "double": "double", "char16": "char16_t", "char32": "char32_t"}
_METAS.update({f"{sign}int{bits}": f"{sign}int{bits}_t" for sign in ("", "u") for bits in (8, 16, 32, 64)})


class Api:
    def __init__(self, path, precision=None):
        with open(path, encoding="utf-8") as file:
            data = json.load(file)
        self.version = data["header"]["version_full_name"]
        precision = precision or data["header"].get("precision", "single")
        sizes = "double_64" if precision == "double" else "float_64"
        self.sizes = next({s["name"]: s["size"] for s in block["sizes"]} for block in data["builtin_class_sizes"]
                          if block["build_configuration"] == sizes)
        self.classes = {c["name"]: c for c in data["classes"]}
        self.singletons = {s["type"]: s["name"] for s in data["singletons"]}
        self.builtins = {c["name"]: c for c in data["builtin_classes"]}
        self.opaque = {n for n, c in self.builtins.items() if n not in MATH_TYPES and n not in _NUMBERS and n != "Nil"}
        self.global_enums = data["global_enums"]
        self.utilities = data["utility_functions"]
        # Upstream has the engine's own ClassDB under another name, and so would we if it were needed.
        self.by_header = {snake_case(name): name for name in self.classes if name != "ClassDB"}

    def lineage(self, name):
        """The class and its ancestors, nearest first."""
        while name:
            yield name
            name = self.classes[name].get("inherits")

    # Types

    def referenced_classes(self, type_name):
        """Engine classes that a signature with this type needs to know."""
        name = element_type(type_name)
        if is_enum(name):
            owner = name.split("::")[1].rpartition(".")[0]
            return {owner} if owner in self.classes else set()
        if name.startswith("typeddictionary::"):
            parts = name.split("::")[1].split(";")
            return set().union(*(self.referenced_classes(part) for part in parts))
        return {name} & self.classes.keys()

    def is_supported(self, type_name):
        """Raw pointers (native structures, untyped memory) are not."""
        return not type_name.endswith("*")

    def cpp_type(self, type_name, meta=None):
        if type_name in _NUMBERS:
            return _METAS.get(meta, _NUMBERS[type_name])
        if type_name in ("void", "Nil"):
            return "void"
        if type_name.startswith("enum::"):
            return type_name[6:].replace(".", "::")
        if type_name.startswith("bitfield::"):
            return f"BitField<{type_name[10:].replace('.', '::')}>"
        if type_name.startswith("typedarray::"):
            return f"TypedArray<{self._element(element_type(type_name))}>"
        if type_name.startswith("typeddictionary::"):
            key, value = (self._element(element_type(t)) for t in type_name.split("::", 1)[1].split(";"))
            return f"TypedDictionary<{key}, {value}>"
        if type_name in self.classes:
            return f"Ref<{type_name}>" if self.classes[type_name]["is_refcounted"] else f"{type_name} *"
        return type_name

    def _element(self, type_name):
        return type_name if type_name in self.classes else self.cpp_type(type_name)

    def parameter_type(self, argument):
        cpp = self.cpp_type(argument["type"], argument.get("meta"))
        by_value = argument["type"] in _NUMBERS or is_enum(argument["type"]) or cpp.endswith("*")
        return cpp if by_value else f"const {cpp} &"

    def default_value(self, argument):
        """The C++ expression of an argument's default."""
        text, kind = argument["default_value"], argument["type"]
        cpp = self.cpp_type(kind, argument.get("meta"))
        if is_enum(kind):
            return f"{cpp}({text})" if kind.startswith("bitfield") else f"static_cast<{cpp}>({text})"
        if kind == "Variant":
            return "Variant()" if text == "null" else f"Variant({text})"
        if text == "null":
            return "nullptr"
        if text in ("[]", "{}") or text.startswith(("Array[", "Dictionary[")):
            return "{}"
        if kind in _NUMBERS:
            return text
        literal = re.fullmatch(r'(?:&|\^|StringName|NodePath|)\(?(".*")\)?', text)
        if literal:
            return literal[1] if literal[1] != '""' else f"{cpp}()"
        return "Transform2D()" if text.startswith("Transform2D") else _known_constructor(text)


def _known_constructor(text):
    """Identity transforms are written out number by number; the C++ default is the identity."""
    if text.startswith(("Transform3D", "Basis", "Projection", "Quaternion")):
        return text.split("(")[0] + "()"
    return text


def is_enum(type_name):
    return type_name.startswith(("enum::", "bitfield::"))


def element_type(type_name):
    """typedarray::24/17:RID -> RID; other types are themselves."""
    if type_name.startswith("typedarray::"):
        type_name = type_name[12:]
    return type_name.rpartition(":")[2] if re.match(r"\d+/\d+:", type_name) else type_name
