"""Names: how API names become C++ names and file names."""

import re

_KEYWORDS = {
    "class", "default", "delete", "enum", "for", "if", "new", "namespace", "operator", "private", "protected",
    "public", "register", "return", "signed", "static", "struct", "switch", "template", "this", "typename", "union",
    "unsigned", "virtual", "while", "char", "short", "auto", "bool", "int", "float", "double", "void", "continue",
    "and", "or", "not", "xor",
}


def snake_case(name):
    """NavigationServer3D -> navigation_server3d, as in upstream's file names."""
    name = re.sub("(.)([A-Z][a-z]+)", r"\1_\2", name)
    name = re.sub("([a-z0-9])([A-Z])", r"\1_\2", name)
    return name.replace("2_D", "2D").replace("3_D", "3D").replace("4_D", "4D").lower()


def function_name(name):
    if name == "typeof":
        return "type_of"
    return name + "_" if name in _KEYWORDS else name


def argument_name(name):
    return "p_" + name
