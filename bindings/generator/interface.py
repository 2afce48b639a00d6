"""The engine's C interface: one struct with every function, filled by name at load time."""

import re


def functions(header_text):
    """Name and function-pointer type of every current function of the interface header."""
    found = []
    for comment in re.finditer(r"/\*\*(.*?)\*/\s*typedef [^;]*?\(\*(GDExtensions?Interface\w+)\)", header_text, re.S):
        name = re.search(r"@name (\w+)", comment[1])
        if name and "@deprecated" not in comment[1]:
            found.append((name[1], comment[2]))
    if len(found) < 100:
        raise SystemExit("gdextension_interface.h: fewer than 100 functions found; has its format changed?")
    return found


def generate(output, interface_path):
    text = open(interface_path, encoding="utf-8").read()
    output.write("include/gdextension_interface.h", text, banner=False)
    found = functions(text)
    members = "".join(f"\t{kind} {name} = nullptr;\n" for name, kind in found)
    output.write("include/godot_cpp/core/interface.gen.hpp", f"""#pragma once

#include <gdextension_interface.h>

namespace godot::internal {{

struct EngineInterface {{
{members}
	void load(GDExtensionInterfaceGetProcAddress p_get_proc_address);
}};

}} // namespace godot::internal
""")
    loads = "".join(f'\t{name} = reinterpret_cast<{kind}>(p_get_proc_address("{name}"));\n' for name, kind in found)
    output.write("src/interface.gen.cpp", f"""#include <godot_cpp/core/interface.gen.hpp>

namespace godot::internal {{

void EngineInterface::load(GDExtensionInterfaceGetProcAddress p_get_proc_address) {{
{loads}}}

}} // namespace godot::internal
""")
