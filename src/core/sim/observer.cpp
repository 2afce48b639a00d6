#include "core/sim/observer.h"

namespace pcg {

std::string_view event_name(SimEventKind kind) {
	switch (kind) {
		case SimEventKind::TaskStarted:
			return "task-started";
		case SimEventKind::LeftBuilding:
			return "left-building";
		case SimEventKind::EnteredBuilding:
			return "entered-building";
		case SimEventKind::SetOut:
			return "set-out";
		case SimEventKind::Arrived:
			return "arrived";
		case SimEventKind::UsedObject:
			return "used-object";
		case SimEventKind::LeftObject:
			return "left-object";
		case SimEventKind::FloatingTaskStarted:
			return "floating-task-started";
		case SimEventKind::RuleEnded:
			return "rule-ended";
		case SimEventKind::RuleCut:
			return "rule-cut";
		case SimEventKind::ArrivedLate:
			return "arrived-late";
		case SimEventKind::PatienceRanOut:
			return "patience-ran-out";
		case SimEventKind::Unreachable:
			return "unreachable";
		case SimEventKind::NoFreePlace:
			return "no-free-place";
		case SimEventKind::RuleFailed:
			return "rule-failed";
	}
	return "";
}

} // namespace pcg
