"""Global enums and the functions that belong to no class."""

from .functions import Signature, enum_cast, enum_text


def generate(output, api):
    enums = [e for e in api.global_enums if not e["name"].startswith("Variant.")]
    output.write("include/godot_cpp/classes/global_constants.hpp",
                 "#pragma once\n\n#include <godot_cpp/core/enum_info.hpp>\n\nnamespace godot {\n\n"
                 + "\n".join(enum_text(e, "") for e in enums) + "\n} // namespace godot\n\n"
                 + "".join(enum_cast(e) for e in enums))
    output.write("include/godot_cpp/classes/global_constants_binds.hpp",
                 "#pragma once\n\n#include <godot_cpp/classes/global_constants.hpp>\n")
    _utilities(output, api)


def _utilities(output, api):
    declared, defined = "", ""
    for data in api.utilities:
        function = Signature(api, dict(data, is_static=True))
        find = f'internal::find_utility("{data["name"]}", {data["hash"]})'
        if function.is_vararg:
            declared += _vararg(function)
            defined += _vararg_definition(function, find)
            continue
        result = "" if function.returns == "void" else "return "
        declared += f"\t{function.declaration()};\n"
        defined += f"""{function.declaration('UtilityFunctions::', False)} {{
	static const GDExtensionPtrUtilityFunction function = {find};
	{result}internal::call_utility<{function.returns}>(function{function.argument_list()});
}}

"""
    output.write("include/godot_cpp/variant/utility_functions.hpp", f"""#pragma once

#include <godot_cpp/variant/variant.hpp>

#include <array>

namespace godot {{

class UtilityFunctions {{
public:
{declared}}};

}} // namespace godot
""")
    output.write("src/utility_functions.gen.cpp", f"""#include <godot_cpp/variant/utility_functions.hpp>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/core/engine_call.hpp>

namespace godot {{

{defined}}} // namespace godot
""")


def _vararg(function):
    result = "" if function.returns == "void" else "return "
    inner = f"{result}{function.name}_internal(pointers.data(), int32_t(pointers.size()));"
    private = f"\tstatic {function.returns} {function.name}_internal(const Variant **p_args, int32_t p_count);\n"
    return private + function.vararg_template(inner)


def _vararg_definition(function, find):
    result = "" if function.returns == "void" else f"\t{function.returns} result{{}};\n"
    pointer = "nullptr" if function.returns == "void" else "&result"
    finish = "" if function.returns == "void" else "\treturn result;\n"
    return f"""{function.returns} UtilityFunctions::{function.name}_internal(const Variant **p_args, int32_t p_count) {{
	static const GDExtensionPtrUtilityFunction function = {find};
{result}	function({pointer}, reinterpret_cast<const GDExtensionConstTypePtr *>(p_args), p_count);
{finish}}}

"""
