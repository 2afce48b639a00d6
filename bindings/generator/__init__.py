"""Writes the generated half of the bindings from the engine's API dump."""
