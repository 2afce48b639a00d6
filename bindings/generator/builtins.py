"""The built-in types that only the engine can look into: String, Array, Callable, the packed arrays..."""

from .functions import Signature
from .names import argument_name, snake_case
from .output import SourceGroups

_OPERATORS = {"==": "EQUAL", "!=": "NOT_EQUAL", "<": "LESS", "<=": "LESS_EQUAL", ">": "GREATER",
              ">=": "GREATER_EQUAL", "+": "ADD"}
_ELEMENTS = {"Byte": "uint8_t", "Int32": "int32_t", "Int64": "int64_t", "Float32": "float", "Float64": "double"}
# Hand-written members, included into the class body.
_WITH_EXTRAS = {"Array", "Callable", "Dictionary", "NodePath", "String", "StringName"}


def packed_element(name):
    if not name.startswith("Packed"):
        return None
    element = name[len("Packed"):-len("Array")]
    return _ELEMENTS.get(element, element)


class BuiltinClass:
    def __init__(self, api, name):
        self.api = api
        self.name = name
        self.data = api.builtins[name]
        self.snake = snake_case(name)
        self.type = "GDEXTENSION_VARIANT_TYPE_" + self.snake.upper()
        self.element = packed_element(name)
        self.methods = [Signature(api, m) for m in self.data.get("methods", [])]
        self.declared = []
        self.defined = []

    def add(self, declaration, definition):
        self.declared.append(f"\t{declaration};\n")
        self.defined.append(definition + "\n\n")

    def build(self):
        self._life()
        self._constructors()
        self._operators()
        for method in self.methods:
            if not method.is_vararg:
                self._method(method)
        if self.element:
            self._packed()

    def _life(self):
        name = self.name
        get = "internal::engine.variant_get_ptr_"
        destructor = f"{name}::~{name}() = default;\n\n"
        if self.data["has_destructor"]:
            destructor = f"""{name}::~{name}() {{
	static const GDExtensionPtrDestructor destructor = {get}destructor({self.type});
	destructor(opaque);
}}

"""
        self.defined.append(f"""{name}::{name}({name} &&p_other) : {name}() {{
	std::swap(opaque, p_other.opaque);
}}

{destructor}{name} &{name}::operator=(const {name} &p_other) {{
	if (this != &p_other) {{
		{name} copy(p_other);
		std::swap(opaque, copy.opaque);
	}}
	return *this;
}}

{name} &{name}::operator=({name} &&p_other) {{
	std::swap(opaque, p_other.opaque);
	return *this;
}}

""")
        self.declared.append(f"\t{name}({name} &&p_other);\n\t~{name}();\n"
                             f"\t{name} &operator=(const {name} &p_other);\n\t{name} &operator=({name} &&p_other);\n")

    def _constructors(self):
        for constructor in self.data["constructors"]:
            arguments = constructor.get("arguments", [])
            signature = Signature(self.api, {"name": self.name, "arguments": arguments})
            parameters = signature.parameters(False)
            passed = signature.argument_list()
            explicit = "explicit " if len(arguments) == 1 and arguments[0]["type"] in self.api.classes else ""
            self.add(f"{explicit}{self.name}({parameters})", f"""{self.name}::{self.name}({parameters}) {{
	static const GDExtensionPtrConstructor constructor =
			internal::engine.variant_get_ptr_constructor({self.type}, {constructor['index']});
	internal::construct(constructor, opaque{passed});
}}""")

    def _operators(self):
        for operator in self.data["operators"]:
            right = operator.get("right_type")
            if operator["name"] not in _OPERATORS or right in (None, "Variant"):
                continue
            returns = self.api.cpp_type(operator["return_type"])
            head = f"operator{operator['name']}(const {right} &p_other) const"
            right_type = "GDEXTENSION_VARIANT_TYPE_" + snake_case(right).upper()
            self.add(f"{returns} {head}", f"""{returns} {self.name}::{head} {{
	static const GDExtensionPtrOperatorEvaluator evaluator = internal::engine.variant_get_ptr_operator_evaluator(
			GDEXTENSION_VARIANT_OP_{_OPERATORS[operator['name']]}, {self.type}, {right_type});
	return internal::call_operator<{returns}>(evaluator, opaque, p_other);
}}""")

    def _method(self, method):
        base = "nullptr" if method.is_static else "opaque"
        result = "" if method.returns == "void" else "return "
        declaration = method.declaration(defaults=not self._needs_overloads(method))
        self.add(declaration, f"""{method.declaration(self.name + '::', False)} {{
	static const GDExtensionPtrBuiltInMethod method =
			internal::find_builtin_method({self.type}, "{method.data['name']}", {method.data['hash']});
	{result}internal::call_builtin<{method.returns}>(method, {base}{method.argument_list()});
}}""")
        if self._needs_overloads(method):
            self._shorter_overloads(method)

    def _needs_overloads(self, method):
        """Other opaque types are not complete in these headers, so a default of one becomes a shorter overload."""
        incomplete = (self.api.opaque | {"Variant"}) - {self.name}
        return any(a["type"] in incomplete and "default_value" in a for a in method.arguments)

    def _shorter_overloads(self, method):
        first = next(i for i, a in enumerate(method.arguments) if "default_value" in a)
        for count in range(first, len(method.arguments)):
            given = [argument_name(a["name"]) for a in method.arguments[:count]]
            given += [self.api.default_value(a) for a in method.arguments[count:]]
            self.add(method.declaration(defaults=False, count=count),
                     f"{method.declaration(self.name + '::', False, count)} {{\n"
                     f"\treturn {method.name}({', '.join(given)});\n}}")

    def _packed(self):
        name, element = self.name, self.element
        index = f"internal::engine.{self.snake}_operator_index"
        self.declared.append(f"""	{name}(std::initializer_list<{element}> p_init);
	const {element} *begin() const {{ return ptr(); }}
	const {element} *end() const {{ return ptr() + size(); }}
	{element} *begin() {{ return ptrw(); }}
	{element} *end() {{ return ptrw() + size(); }}
""")
        self.defined.append(f"""{name}::{name}(std::initializer_list<{element}> p_init) : {name}() {{
	resize(int64_t(p_init.size()));
	std::copy(p_init.begin(), p_init.end(), ptrw());
}}

""")
        cast = f"reinterpret_cast<{element} *>"
        const_cast = f"reinterpret_cast<const {element} *>"
        self.add(f"const {element} &operator[](int64_t p_index) const",
                 f"const {element} &{name}::operator[](int64_t p_index) const {{\n"
                 f"\treturn *{const_cast}({index}_const(opaque, p_index));\n}}")
        self.add(f"{element} &operator[](int64_t p_index)",
                 f"{element} &{name}::operator[](int64_t p_index) {{\n\treturn *{cast}({index}(opaque, p_index));\n}}")
        self.add(f"const {element} *ptr() const",
                 f"const {element} *{name}::ptr() const {{\n\treturn {const_cast}({index}_const(opaque, 0));\n}}")
        self.add(f"{element} *ptrw()",
                 f"{element} *{name}::ptrw() {{\n\treturn {cast}({index}(opaque, 0));\n}}")

    def header_text(self):
        used = set().union(*(m.types() for m in self.methods)) | {self.element}
        includes = sorted(f"godot_cpp/variant/{snake_case(t)}.hpp" for t in used
                          if t in self.api.builtins and t not in self.api.opaque and t[0].isupper() and t != "Nil")
        if self.element in self.api.opaque:
            includes.append(f"godot_cpp/variant/{snake_case(self.element)}.hpp")
        forward = "".join(f"class {n};\n" for n in sorted(self.api.opaque | {"Object", "Variant"}) if n != self.name)
        includes = ["godot_cpp/core/defs.hpp", "godot_cpp/godot.hpp"] + includes
        lines = ["#pragma once\n"] + [f"#include <{i}>" for i in includes]
        if self.name == "String":
            lines.append("#include <godot_cpp/variant/char_string.hpp>")
        varargs = "".join(_vararg_declaration(m) for m in self.methods if m.is_vararg)
        extra = f"\n#include <godot_cpp/variant/extra/{self.snake}.inc>\n" if self.name in _WITH_EXTRAS else ""
        return "\n".join(lines) + f"""

namespace godot {{

{forward}
class {self.name} {{
	alignas(8) uint8_t opaque[{self.api.sizes[self.name]}] = {{}};

public:
	GDExtensionTypePtr _native_ptr() const {{ return const_cast<uint8_t *>(opaque); }}

{''.join(self.declared)}{varargs}{extra}}};

}} // namespace godot
"""

    def source_text(self):
        return f"""#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/core/engine_call.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <algorithm>

namespace godot {{

{''.join(self.defined)}}} // namespace godot
"""


def _vararg_declaration(method):
    fixed = method.parameters(False)
    const = " const" if method.is_const else ""
    return (f"\ttemplate <typename... Args>\n\t{method.returns} {method.name}"
            f"({fixed + ', ' if fixed else ''}const Args &...p_args){const};\n")


def _vararg_definition(owner, method):
    """Callable::call and the like, once Variant is known."""
    const = " const" if method.is_const else ""
    finish = "" if method.returns == "void" else "\n\treturn result;"
    result = "nullptr" if method.returns == "void" else "&result"
    fixed = method.parameters(False)
    names = "".join(f"Variant({argument_name(a['name'])}), " for a in method.arguments)
    count = f"{len(method.arguments)} + sizeof...(Args)" if method.arguments else "sizeof...(Args)"
    parameters = (fixed + ", " if fixed else "") + "const Args &...p_args"
    return f"""template <typename... Args>
{method.returns} {owner.name}::{method.name}({parameters}){const} {{
	static const GDExtensionPtrBuiltInMethod method =
			internal::find_builtin_method({owner.type}, "{method.data['name']}", {method.data['hash']});
	std::array<Variant, {count}> values{{ {names}Variant(p_args)... }};
	std::array<GDExtensionConstTypePtr, {count}> pointers;
	for (size_t i = 0; i < values.size(); i++) {{
		pointers[i] = &values[i];
	}}
	{'' if method.returns == 'void' else method.returns + ' result;'}
	method(_native_ptr(), pointers.data(), {result}, int32_t(pointers.size()));{finish}
}}

"""


def generate(output, api):
    varargs = ""
    groups = SourceGroups("src/builtins")
    for name in sorted(api.opaque):
        built = BuiltinClass(api, name)
        built.build()
        output.write(f"include/godot_cpp/variant/{built.snake}.hpp", built.header_text())
        groups.add(name, built.source_text())
        varargs += "".join(_vararg_definition(built, m) for m in built.methods if m.is_vararg)
    groups.write(output)
    output.write("include/godot_cpp/variant/builtin_vararg_methods.gen.hpp",
                 "#pragma once\n\nnamespace godot {\n\nnamespace internal {\n\n"
                 "GDExtensionPtrBuiltInMethod find_builtin_method(GDExtensionVariantType p_type, const char *p_method,\n"
                 "\t\tint64_t p_hash);\n\n} // namespace internal\n\n"
                 + varargs + "} // namespace godot\n")
    output.write("include/godot_cpp/variant/variant_size.gen.hpp",
                 f"#pragma once\n\n#define GODOT_CPP_VARIANT_SIZE {api.sizes['Variant']}\n")
