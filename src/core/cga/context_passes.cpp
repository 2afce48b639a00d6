#include "core/cga/context.h"
#include "core/cga/initial_shape.h"

// A derivation is one pass over the rules, or two where shapes ask about others of the same initial shape: the first gives default answers and is
// recorded, the second asks that record.
namespace pcg::cga {

DerivationResult Context::derive(const InitialShape &initial_shape, const Neighbors &neighbors) {
	begin(initial_shape, neighbors);
	if (_context_use.intra) {
		surroundings.start_recording();
		rehearse(initial_shape);
		surroundings.finish_recording(true);
	}
	run_pass(initial_shape);
	return model.take();
}

std::shared_ptr<const Occluders> Context::occluders(const InitialShape &initial_shape) {
	begin(initial_shape, {});
	surroundings.start_recording();
	rehearse(initial_shape);
	if (_context_use.intra) {
		surroundings.finish_recording(true);
		surroundings.start_recording();
		rehearse(initial_shape);
	}
	return surroundings.finish_recording(false);
}

// A pass of which only the recording counts.
void Context::rehearse(const InitialShape &initial_shape) {
	_is_rehearsal = true;
	run_pass(initial_shape);
	_is_rehearsal = false;
}

void Context::begin(const InitialShape &initial_shape, const Neighbors &neighbors) {
	surroundings.begin(neighbors, _options.occlusion_distance);
	_start = std::chrono::steady_clock::now();
	_initial_shape = &initial_shape;
}

void Context::run_pass(const InitialShape &initial_shape) {
	if (set_up(initial_shape)) {
		surroundings.set_place(world_bounds(shape, _lot.origin), _lot.origin);
		const RuleId start = start_rule();
		if (is_valid(start)) {
			run_rules(start);
		}
	}
}

} // namespace pcg::cga
