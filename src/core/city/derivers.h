#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "core/city/city_generator.h"

namespace pcg {

// Interpreters at rest, by program: a thread takes one for a lot or a piece of street and gives it back, so that there are never more than threads.
class Derivers {
public:
	// Cancelling the city ends what is being built, too.
	explicit Derivers(const CityOptions &options);

	cga::DerivationResult derive(const Program &program, const cga::InitialShape &shape, const cga::Neighbors &neighbors = {});
	std::shared_ptr<const cga::Occluders> occluders(const Program &program, const cga::InitialShape &shape);
	// For one thread only.
	bool asks_inter(const Program &program);

private:
	void give_back(const Program &program, std::unique_ptr<cga::Deriver> deriver);
	std::unique_ptr<cga::Deriver> take(const Program &program);

	cga::DeriveOptions _options;
	std::map<const Program *, bool> _asks_inter;
	std::mutex _mutex;
	std::map<const Program *, std::vector<std::unique_ptr<cga::Deriver>>> _resting;
};

} // namespace pcg
