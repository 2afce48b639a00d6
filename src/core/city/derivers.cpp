#include "core/city/derivers.h"

#include "core/cga/neighborhood.h"

namespace pcg {

Derivers::Derivers(const CityOptions &options) : _options(options.derive) {
	_options.cancel = _options.cancel != nullptr ? _options.cancel : options.work.cancel;
}

cga::DerivationResult Derivers::derive(const Program &program, const cga::InitialShape &shape, const cga::Neighbors &neighbors) {
	std::unique_ptr<cga::Deriver> deriver = take(program);
	cga::DerivationResult result = deriver->derive(shape, neighbors);
	give_back(program, std::move(deriver));
	return result;
}

bool Derivers::asks_inter(const Program &program) {
	const auto [place, is_new] = _asks_inter.emplace(&program, false);
	if (is_new) {
		place->second = cga::context_use(program).asks_inter();
	}
	return place->second;
}

std::shared_ptr<const cga::Occluders> Derivers::occluders(const Program &program, const cga::InitialShape &shape) {
	std::unique_ptr<cga::Deriver> deriver = take(program);
	std::shared_ptr<const cga::Occluders> result = deriver->occluders(shape);
	give_back(program, std::move(deriver));
	return result;
}

void Derivers::give_back(const Program &program, std::unique_ptr<cga::Deriver> deriver) {
	const std::lock_guard<std::mutex> lock(_mutex);
	_resting[&program].push_back(std::move(deriver));
}

std::unique_ptr<cga::Deriver> Derivers::take(const Program &program) {
	const std::lock_guard<std::mutex> lock(_mutex);
	std::vector<std::unique_ptr<cga::Deriver>> &resting = _resting[&program];
	if (resting.empty()) {
		return std::make_unique<cga::Deriver>(program, _options);
	}
	std::unique_ptr<cga::Deriver> deriver = std::move(resting.back());
	resting.pop_back();
	return deriver;
}

} // namespace pcg
