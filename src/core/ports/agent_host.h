#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "core/base/ids.h"

// What the simulation asks of the world: bodies for people outdoors. The default does nothing, so that a city lives without being shown.
namespace pcg {

enum class AgentPose : uint8_t { Stand, Walk, Sit };

class AgentHost {
public:
	virtual ~AgentHost() = default;

	// The person stepped outdoors at `position` and needs a body.
	virtual void spawn_agent(PersonId, glm::vec3 /*position*/) {}
	// It sets out along `path` (first point = where it is) at `speed` m/s, at the simulated time of this call.
	virtual void walk_agent(PersonId, std::span<const glm::vec3> /*path*/, float /*speed*/) {}
	// It stands or sits at `position`, looking along `facing`.
	virtual void place_agent(PersonId, glm::vec3 /*position*/, glm::vec3 /*facing*/, AgentPose) {}
	// It went inside; the body is not needed any more.
	virtual void free_agent(PersonId) {}
};

} // namespace pcg
