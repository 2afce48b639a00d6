"""The checks of layers and sizes see what they are meant to see; each case was worked out by reading it."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import check_layers  # noqa: E402
import check_size  # noqa: E402

TABLE = """| Room | What | May include |
|---|---|---|
| `src/core/base` | words | std, GLM |
| `src/core/lang` | words | base |
| `src/core/io` | words | anything in core; only io's own |
| `src/core/sim` | words | base, lang. Never io |
| `src/godot` | words | core, godot-cpp |
"""


class Layers(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        (self.root / "table.md").write_text(TABLE)
        self.saved = check_layers.ROOT, check_layers.MAY_INCLUDE
        check_layers.ROOT, check_layers.MAY_INCLUDE = self.root, check_layers.read_table(self.root / "table.md")
        self.addCleanup(self.restore)

    def restore(self):
        check_layers.ROOT, check_layers.MAY_INCLUDE = self.saved

    def problems(self, name, text):
        path = self.root / "src" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return list(check_layers.check_file(path))

    def test_own_room_and_allowed_rooms_pass(self):
        text = '#include "core/sim/clock.h"\n#include "core/lang/value.h"\n#include <vector>\n#include <glm/glm.hpp>\n'
        self.assertEqual(self.problems("core/sim/x.cpp", text), [])
        self.assertEqual(self.problems("godot/nodes/x.cpp", '#include "core/io/y.h"\n#include <godot_cpp/a.hpp>\n'), [])

    def test_a_forbidden_room_is_named_with_file_and_line(self):
        self.assertEqual(self.problems("core/lang/x.h", '\n#include "core/sim/clock.h"\n'),
                         ['src/core/lang/x.h:2: core/lang must not include "core/sim/clock.h"'])

    def test_engine_and_file_libraries_stay_in_their_rooms(self):
        self.assertEqual(len(self.problems("core/sim/x.cpp", "#include <godot_cpp/a.hpp>\n#include <tiny_gltf.h>\n")), 2)
        self.assertEqual(self.problems("core/io/x.cpp", "#include <tiny_gltf.h>\n#include <fstream>\n"), [])
        self.assertEqual(len(self.problems("core/sim/x.cpp", "#include <fstream>\n")), 1)

    def test_unportable_randomness_and_exceptions_are_found_in_code_but_not_in_comments(self):
        self.assertEqual(len(self.problems("core/sim/x.cpp", "int a = std::rand();\nvoid f() { throw 1; }\n")), 2)
        self.assertEqual(self.problems("core/sim/x.cpp", '// std::rand()\n/* throw 1 */ const char *s = "try {";\n'), [])

    def test_a_folder_outside_the_table_is_a_problem(self):
        self.assertEqual(len(self.problems("core/new/x.h", "")), 1)


class Sizes(unittest.TestCase):
    def functions(self, text):
        return list(check_size.cpp_functions(text))

    def test_functions_in_namespaces_and_classes_are_found_with_their_lines(self):
        text = "namespace a {\nstruct B : C {\n\tint f(int x = {}) const noexcept {\n\t\treturn x;\n\t}\n};\nvoid g() {\n}\n}\n"
        self.assertEqual(self.functions(text), [(3, 5), (7, 8)])

    def test_what_a_constructor_sets_is_not_its_body(self):
        self.assertEqual(self.functions("struct B {\n\tB(int a) : x{a}, y{} {\n\t\tf({1});\n\t}\n};\n"), [(2, 4)])

    def test_data_and_types_are_not_functions(self):
        self.assertEqual(self.functions("const Row T[] = {\n{f(1), 2},\n};\nenum class E { A };\nstruct alignas(8) S {};\n"), [])

    def test_braces_in_strings_comments_and_macros_do_not_count(self):
        text = "void f() { // {\n\tg(\"{\", '{', R\"({)\");\n}\n#define M {\nvoid h() {\n}\n"
        self.assertEqual(self.functions(text), [(1, 3), (5, 6)])

    def test_gdscript_functions_end_before_the_next_statement_at_the_margin(self):
        self.assertEqual(list(check_size.gdscript_functions("func a():\n\tpass\n\n\nvar x\nstatic func b():\n\tpass\n")),
                         [(1, 2), (6, 7)])


if __name__ == "__main__":
    unittest.main()
