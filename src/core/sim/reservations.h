#pragma once

#include <cstdint>
#include <vector>

#include "core/base/ids.h"
#include "core/semantics/city_model.h"

namespace pcg {

// Who holds which place of which object: one person a place, from goToObject on (PCG language, section 6).
class Reservations {
public:
	static constexpr uint8_t none = 0xFF; // objects with more places use the first 255

	// Takes in what was added to the city or got other places since; keeps what is held where that place still is.
	void update(const CityModel &city);
	void clear();
	// The lowest free place of the object, now held by the person; `none` if there is none, or no such object.
	uint8_t take(const CityModel &city, ObjectId object, PersonId person);
	// That place; false if there is none, or somebody else has it.
	bool put(ObjectId object, uint8_t place, PersonId person);
	void release(ObjectId object, uint8_t place); // nothing, if there is no such place any more
	bool is_free(const CityModel &city, ObjectId object) const;
	// Invalid when free.
	PersonId holder(ObjectId object, uint8_t place) const;

private:
	uint32_t place_count(ObjectId object) const; // as of the last update

	std::vector<uint32_t> _first_place; // object count + 1
	std::vector<PersonId> _holders;
};

} // namespace pcg
