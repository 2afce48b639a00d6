#include "core/agenda/task.h"

namespace pcg {

std::string_view task_kind_name(TaskKind kind) {
	switch (kind) {
		case TaskKind::StayInside:
			return "stayInside";
		case TaskKind::GoToBuilding:
			return "goToBuilding";
		case TaskKind::Accompany:
			return "accompany";
		case TaskKind::DelayedRule:
			return "delayedRule";
		case TaskKind::FloatingSlot:
			return "floatingSlot";
	}
	return "";
}

} // namespace pcg
