#include "godot/nodes/citizen_life.h"

namespace pcg {

void NoticeBoard::note(const Notice &notice) {
	if (_wanted[size_t(notice.kind)]) {
		_notices.push_back(notice);
	}
}

void NoticeBoard::on_event(const SimEvent &event) {
	Notice notice;
	notice.person = event.person;
	notice.building = event.place.building();
	switch (event.kind) {
		case SimEventKind::LeftBuilding: notice.kind = Notice::Kind::LeftBuilding; break;
		case SimEventKind::EnteredBuilding: notice.kind = Notice::Kind::EnteredBuilding; break;
		case SimEventKind::TaskStarted:
			notice.kind = Notice::Kind::TaskStarted;
			notice.task = _simulation ? _simulation->view(event.person).entry.kind : TaskKind::StayInside;
			break;
		default: return;
	}
	note(notice);
}

void NoticeBoard::spawn_agent(PersonId person, glm::vec3 position) {
	if (_bodies) {
		_bodies->spawn_agent(person, position);
	}
	note({ .kind = Notice::Kind::AgentSpawned, .person = person });
}

void NoticeBoard::walk_agent(PersonId person, std::span<const glm::vec3> path, float speed) {
	if (_bodies) {
		_bodies->walk_agent(person, path, speed);
	}
}

void NoticeBoard::place_agent(PersonId person, glm::vec3 position, glm::vec3 facing, AgentPose pose) {
	if (_bodies) {
		_bodies->place_agent(person, position, facing, pose);
	}
}

void NoticeBoard::free_agent(PersonId person) {
	if (_bodies) {
		_bodies->free_agent(person);
	}
	note({ .kind = Notice::Kind::AgentFreed, .person = person });
}

} // namespace pcg
