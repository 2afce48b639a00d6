#include "core/sim/observer.h"

#include <array>

namespace pcg {

namespace {

// In the order of SimEventKind.
constexpr std::array<std::string_view, sim_event_kind_count> names{ "task-started", "left-building", "entered-building", "set-out", "arrived",
	"used-object", "left-object", "floating-task-started", "rule-ended", "rule-cut", "arrived-late", "patience-ran-out", "unreachable",
	"no-free-place", "rule-failed", "goal-changed", "added", "removed", "taken-over", "released" };
static_assert(!names.back().empty());

} // namespace

std::string_view event_name(SimEventKind kind) { return size_t(kind) < names.size() ? names[size_t(kind)] : std::string_view(); }

} // namespace pcg
