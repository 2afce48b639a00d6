#include "core/lang/compiler.h"

// Warnings about what is sound but can have no effect.
namespace pcg {

void Compiler::warn_unused_rules() {}
void Compiler::warn_phases() {}

} // namespace pcg
