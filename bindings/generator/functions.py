"""Pieces common to every kind of generated function."""

from .names import argument_name, function_name


class Signature:
    """One function of the API: C++ types, names, defaults."""

    def __init__(self, api, data):
        self.api = api
        self.data = data
        self.name = function_name(data["name"])
        self.engine_name = data["name"]
        self.arguments = data.get("arguments", [])
        value = data.get("return_value", {"type": data.get("return_type", "void")})
        self.returned_type = value["type"]
        self.returns = api.cpp_type(value["type"], value.get("meta"))
        self.is_vararg = data.get("is_vararg", False)
        self.is_static = data.get("is_static", False)
        self.is_const = data.get("is_const", False) and not self.is_static

    def types(self):
        return [self.returned_type] + [a["type"] for a in self.arguments]

    def is_supported(self):
        return all(self.api.is_supported(t) for t in self.types())

    def referenced_classes(self):
        return set().union(*(self.api.referenced_classes(t) for t in self.types()))

    def parameters(self, defaults, count=None):
        parts = []
        for argument in self.arguments[:count]:
            text = _join(self.api.parameter_type(argument), argument_name(argument["name"]))
            if defaults and "default_value" in argument:
                text += " = " + self.api.default_value(argument)
            parts.append(text)
        return ", ".join(parts)

    def argument_list(self):
        return "".join(", " + argument_name(a["name"]) for a in self.arguments)

    def declaration(self, scope="", defaults=True, count=None):
        """scope: "" in a class body, "Node::" for a definition."""
        static = "static " if self.is_static and not scope else ""
        const = " const" if self.is_const else ""
        returns = self.returns
        return f"{static}{_join(returns, scope + self.name)}({self.parameters(defaults, count)}){const}"

    def vararg_template(self, pass_on, const=""):
        """A template that gathers its arguments as Variants; pass_on gets `pointers.data()` and their number."""
        fixed = self.parameters(False)
        names = "".join(f"Variant({argument_name(a['name'])}), " for a in self.arguments)
        count = f"{len(self.arguments)} + sizeof...(Args)"
        parameters = (fixed + ", " if fixed else "") + "const Args &...p_args"
        static = "static " if self.is_static else ""
        return f"""	template <typename... Args>
	{static}{_join(self.returns, self.name)}({parameters}){const} {{
		std::array<Variant, {count}> values{{ {names}Variant(p_args)... }};
		std::array<const Variant *, {count}> pointers;
		for (size_t i = 0; i < values.size(); i++) {{
			pointers[i] = &values[i];
		}}
		{pass_on}
	}}
"""


def _join(cpp_type, name):
    return cpp_type + name if cpp_type.endswith(("*", "&")) else f"{cpp_type} {name}"


def enum_text(enum, indent):
    values = "".join(f"{indent}\t{value['name']} = {value['value']},\n" for value in enum["values"])
    return f"{indent}enum {enum['name'].rpartition('.')[2]} {{\n{values}{indent}}};\n"


def enum_cast(enum, owner=""):
    kind = "BITFIELD" if enum.get("is_bitfield") else "ENUM"
    return f"VARIANT_{kind}_CAST({owner}{enum['name']})\n"
