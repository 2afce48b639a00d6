"""The engine's classes: only those that the sources include, with their ancestors."""

from .functions import Signature, enum_cast, enum_text
from .names import snake_case
from .output import SourceGroups

_TEMPLATES = """template <typename T>
class Ref;
template <typename T>
class BitField;
template <typename T>
class TypedArray;
template <typename K, typename V>
class TypedDictionary;
"""


class EngineClass:
    def __init__(self, api, name, enabled):
        self.api = api
        self.name = name
        self.data = api.classes[name]
        self.parent = self.data.get("inherits")
        self.enums = self.data.get("enums", [])
        self.methods, self.virtuals, self.left_out = [], [], []
        for data in self.data.get("methods", []):
            self._sort_method(Signature(api, data), enabled)

    def _sort_method(self, method, enabled):
        if (self.name, method.name) == ("Node", "get_node"):
            method.name = "get_node_internal"  # As in upstream: get_node<T>() stands for it.
        missing = method.referenced_classes() - enabled
        if not method.is_supported():
            self.left_out.append(f"{method.name}: raw pointers")
        elif missing:
            self.left_out.append(f"{method.name}: include {', '.join(sorted(missing))}")
        elif method.data["is_virtual"]:
            self.virtuals.append(method)
        else:
            self.methods.append(method)

    def used_classes(self):
        used = set().union(*(m.referenced_classes() for m in self.methods + self.virtuals), set())
        return used - {self.name}

    def enum_owners(self):
        """Other classes whose enums stand in our signatures: their headers must come first."""
        found = set()
        for method in self.methods + self.virtuals:
            for type_name in method.types():
                if type_name.startswith(("enum::", "bitfield::")):
                    found |= self.api.referenced_classes(type_name)
        return found - {self.name}

    # Header

    def header_text(self):
        parent = snake_case(self.parent) if self.parent else "wrapped"
        includes = [f"godot_cpp/classes/{parent}.hpp"]
        if self.name not in ("Object", "RefCounted"):
            includes.append("godot_cpp/classes/ref.hpp")
        includes += [f"godot_cpp/classes/{snake_case(c)}.hpp" for c in sorted(self.enum_owners())]
        includes += ["godot_cpp/core/class_glue.hpp", "array"]
        forward = "".join(f"class {c};\n" for c in sorted(self.used_classes() | {"Object"}) if c != self.name)
        casts = "".join(enum_cast(e, self.name + "::") for e in self.enums)
        return ("#pragma once\n\n" + "".join(f"#include <{i}>\n" for i in includes)
                + f"\nnamespace godot {{\n\n{_TEMPLATES}{forward}\n{self._class_text()}\n}} // namespace godot\n\n"
                + casts)

    def _class_text(self):
        base = self.parent or "Wrapped"
        enums = "".join(enum_text(e, "\t") + "\n" for e in self.enums)
        constants = "".join(f"\tstatic constexpr int64_t {c['name']} = {c['value']};\n"
                            if abs(c["value"]) >= 2**31 else f"\tstatic constexpr int {c['name']} = {c['value']};\n"
                            for c in self.data.get("constants", []))
        left_out = "".join(f"\t// - {text}\n" for text in self.left_out)
        if left_out:
            left_out = "\n\t// Left out here, and why:\n" + left_out
        return (f"class {self.name} : public {base} {{\n\tGODOT_CPP_ENGINE_CLASS({self.name}, {base})\n\npublic:\n"
                + enums + constants + self._singleton() + self._declarations() + self._special()
                + self._register_virtuals() + left_out + "};\n")

    def _singleton(self):
        return f"\tstatic {self.name} *get_singleton();\n" if self.name in self.api.singletons else ""

    def _declarations(self):
        text = ""
        for method in self.methods:
            if method.is_vararg:
                text += self._vararg_declaration(method)
            else:
                text += f"\t{method.declaration()};\n"
        for method in self.virtuals:
            text += f"\tvirtual {method.declaration()};\n"
        return text

    def _vararg_declaration(self, method):
        call = f"{method.name}_internal(pointers.data(), int64_t(pointers.size()))"
        if method.returns == "void":
            inner = f"{call};"
        elif method.returns == "Variant":
            inner = f"return {call};"
        else:
            inner = f"return internal::VariantResult<{method.returns}>::take({call});"
        const = " const" if method.is_const else ""
        return (f"\tVariant {method.name}_internal(const Variant **p_args, int64_t p_count){const};\n"
                + method.vararg_template(inner, const))

    def _special(self):
        if self.name == "Node":
            return """	template <typename T>
	T *get_node(const NodePath &p_path) const {
		return Object::cast_to<T>(get_node_internal(p_path));
	}
"""
        if self.name != "Object":
            return ""
        return """	template <typename T>
	static T *cast_to(Object *p_object);
	template <typename T>
	static const T *cast_to(const Object *p_object);
"""

    def _register_virtuals(self):
        checks = "".join(f"""		if constexpr (!std::is_same_v<decltype(&B::{m.name}), decltype(&T::{m.name})>) {{
			internal::bind_virtual<T, &T::{m.name}>("{m.data['name']}", {m.data['hash']});
		}}
""" for m in self.virtuals)
        parent = f"\t\t{self.parent}::register_virtuals<T, B>();\n" if self.parent else ""
        return f"\n\ttemplate <class T, class B>\n\tstatic void register_virtuals() {{\n{parent}{checks}\t}}\n"

    # Source

    def source_text(self):
        headers = [self.name] + sorted(self.used_classes())
        includes = "".join(f"#include <godot_cpp/classes/{snake_case(c)}.hpp>\n" for c in headers)
        bodies = "".join(self._definition(m) for m in self.methods) + "".join(self._virtual(m) for m in self.virtuals)
        return (f"{includes}#include <godot_cpp/classes/ref.hpp>\n#include <godot_cpp/core/engine_call.hpp>\n"
                "#include <godot_cpp/core/type_info.hpp>\n\nnamespace godot {\n\n"
                f"{self._singleton_body()}{bodies}}} // namespace godot\n")

    def _find(self, method):
        return (f'\tstatic const GDExtensionMethodBindPtr method =\n'
                f'\t\t\tinternal::find_method("{self.name}", "{method.data["name"]}", {method.data["hash"]});\n')

    def _definition(self, method):
        owner = "nullptr" if method.is_static else "_owner"
        if method.is_vararg:
            const = " const" if method.is_const else ""
            return (f"Variant {self.name}::{method.name}_internal(const Variant **p_args, int64_t p_count){const} {{\n"
                    f"{self._find(method)}\treturn internal::call_method_varargs(method, {owner}, p_args, p_count);\n}}\n\n")
        result = "" if method.returns == "void" else "return "
        return (f"{method.declaration(self.name + '::', False)} {{\n{self._find(method)}"
                f"\t{result}internal::call_method<{method.returns}>(method, {owner}{method.argument_list()});\n}}\n\n")

    def _virtual(self, method):
        """What a class that overrides nothing does: nothing. The engine never calls it."""
        names = ", ".join(self.api.parameter_type(a) for a in method.arguments)
        const = " const" if method.is_const else ""
        space = "" if method.returns.endswith("*") else " "
        body = "" if method.returns == "void" else f"\treturn {_nothing(method.returns)};\n"
        return f"{method.returns}{space}{self.name}::{method.name}({names}){const} {{\n{body}}}\n\n"

    def _singleton_body(self):
        if self.name not in self.api.singletons:
            return ""
        return f"""{self.name} *{self.name}::get_singleton() {{
	static Object *singleton = nullptr;
	return static_cast<{self.name} *>(internal::find_singleton("{self.api.singletons[self.name]}", singleton));
}}

"""


def _nothing(cpp_type):
    if cpp_type.endswith("*"):
        return "nullptr"
    return f"{cpp_type}(0)" if cpp_type.startswith("BitField") else f"{cpp_type}{{}}"


def generate(output, api, names):
    """names: the classes to generate, closed under inheritance."""
    groups = SourceGroups("src/classes")
    for name in sorted(names):
        engine_class = EngineClass(api, name, names)
        output.write(f"include/godot_cpp/classes/{snake_case(name)}.hpp", engine_class.header_text())
        groups.add(name, engine_class.source_text())
    groups.write(output)
    output.write("src/class_registry.gen.cpp", _registry(api, sorted(names)))


def _registry(api, names):
    includes = "".join(f"#include <godot_cpp/classes/{snake_case(n)}.hpp>\n" for n in names)
    entries = "".join(f"\tregister_engine_class({n}::get_class_static(), {n}::_gde_callbacks());\n" for n in names)
    parent = next(m for m in api.classes["ClassDB"]["methods"] if m["name"] == "get_parent_class")
    return f"""{includes}#include <godot_cpp/core/wrapper_registry.hpp>

namespace godot::internal {{

const int64_t get_parent_class_hash = {parent['hash']};

void register_engine_classes() {{
{entries}}}

}} // namespace godot::internal
"""
