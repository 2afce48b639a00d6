#include "core/sim/reservations.h"

#include <algorithm>

namespace pcg {

void Reservations::update(const CityModel &city) {
	const std::vector<uint32_t> old_first = std::move(_first_place);
	const std::vector<PersonId> old_holders = std::move(_holders);
	_first_place.assign(1, 0);
	_holders.clear();
	for (size_t i = 0; i < city.objects().size(); ++i) {
		const uint32_t places = uint32_t(std::min<size_t>(city.objects()[i].places.size(), none));
		const bool is_known = i + 1 < old_first.size();
		const uint32_t kept = is_known ? std::min(places, old_first[i + 1] - old_first[i]) : 0;
		const auto first = old_holders.begin() + (is_known ? old_first[i] : 0);
		_holders.insert(_holders.end(), first, first + kept);
		_first_place.push_back(_first_place.back() + places);
		_holders.resize(_first_place.back(), PersonId::Invalid);
	}
}

uint32_t Reservations::place_count(ObjectId object) const {
	const size_t i = index_of(object);
	return i + 1 < _first_place.size() ? _first_place[i + 1] - _first_place[i] : 0;
}

void Reservations::clear() { std::fill(_holders.begin(), _holders.end(), PersonId::Invalid); }

uint8_t Reservations::take(const CityModel &city, ObjectId object, PersonId person) {
	if (!is_free(city, object)) {
		return none;
	}
	const auto first = _holders.begin() + _first_place[index_of(object)];
	const auto place = std::find(first, _holders.begin() + _first_place[index_of(object) + 1], PersonId::Invalid);
	*place = person;
	return uint8_t(place - first);
}

bool Reservations::put(ObjectId object, uint8_t place, PersonId person) {
	if (place >= place_count(object) || is_valid(_holders[_first_place[index_of(object)] + place])) {
		return false;
	}
	_holders[_first_place[index_of(object)] + place] = person;
	return true;
}

void Reservations::release(ObjectId object, uint8_t place) {
	if (place < place_count(object)) {
		_holders[_first_place[index_of(object)] + place] = PersonId::Invalid;
	}
}

bool Reservations::is_free(const CityModel &city, ObjectId object) const {
	const uint32_t count = place_count(object);
	if (count == 0 || city.object(object).is_removed || city.object(object).places.size() < count) {
		return false; // the last: it lost places and nobody was told yet
	}
	const auto first = _holders.begin() + _first_place[index_of(object)];
	return std::find(first, first + count, PersonId::Invalid) != first + count;
}

PersonId Reservations::holder(ObjectId object, uint8_t place) const {
	return place < place_count(object) ? _holders[_first_place[index_of(object)] + place] : PersonId::Invalid;
}

} // namespace pcg
