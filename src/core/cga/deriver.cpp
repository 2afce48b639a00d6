#include "core/cga/context.h"
#include "core/cga/derivation.h"

namespace pcg::cga {

struct Deriver::State {
	Context context;
};

Deriver::Deriver(const Program &program, const DeriveOptions &options) : _state(new State{ Context(program, options) }) {}

Deriver::~Deriver() = default;

DerivationResult Deriver::derive(const InitialShape &shape, const Neighbors &neighbors) {
	return _state->context.derive(shape, neighbors);
}

std::shared_ptr<const Occluders> Deriver::occluders(const InitialShape &shape) {
	return _state->context.occluders(shape);
}

DerivationResult derive(const Program &program, const InitialShape &shape, const DeriveOptions &options) {
	return Deriver(program, options).derive(shape);
}

} // namespace pcg::cga
