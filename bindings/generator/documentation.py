"""The classes' help for the editor, as a source that carries it inside the library."""

import zlib
from pathlib import Path


def write_source(target, pages):
    """Joins the XML pages and writes a C++ source that registers them, compressed, when the library is loaded."""
    text = b"".join(Path(page).read_bytes() for page in pages)
    packed = zlib.compress(text, 9)
    rows = [", ".join(str(byte) for byte in packed[i:i + 32]) for i in range(0, len(packed), 32)]
    Path(target).write_text(f"""#include <godot_cpp/godot.hpp>

namespace {{

const unsigned char pages[] = {{
\t{f",{chr(10)}{chr(9)}".join(rows)}
}};

const godot::internal::DocDataRegistration registration("{zlib.crc32(text):08x}", {len(text)}, {len(packed)}, pages);

}} // namespace
""", encoding="utf-8")


def build(target, source, env):
    """Action of the SCons builder, which has upstream's name: GodotCPPDocData."""
    write_source(str(target[0]), [str(page) for page in source])
