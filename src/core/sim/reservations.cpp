#include "core/sim/reservations.h"

#include <algorithm>

namespace pcg {

void Reservations::update(const CityModel &city) {
	if (_first_place.empty()) {
		_first_place.push_back(0);
	}
	for (size_t i = _first_place.size() - 1; i < city.objects().size(); ++i) {
		const size_t places = std::min<size_t>(city.objects()[i].places.size(), none);
		_first_place.push_back(uint32_t(_first_place.back() + places));
	}
	_holders.resize(_first_place.back(), PersonId::Invalid);
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
	const size_t i = index_of(object);
	if (i + 1 >= _first_place.size() || _first_place[i] + place >= _first_place[i + 1] ||
			is_valid(_holders[_first_place[i] + place])) {
		return false;
	}
	_holders[_first_place[i] + place] = person;
	return true;
}

void Reservations::release(ObjectId object, uint8_t place) {
	_holders[_first_place[index_of(object)] + place] = PersonId::Invalid;
}

bool Reservations::is_free(const CityModel &city, ObjectId object) const {
	const size_t i = index_of(object);
	if (i + 1 >= _first_place.size() || city.object(object).is_removed) {
		return false;
	}
	const auto end = _holders.begin() + _first_place[i + 1];
	return std::find(_holders.begin() + _first_place[i], end, PersonId::Invalid) != end;
}

PersonId Reservations::holder(ObjectId object, uint8_t place) const {
	const size_t i = index_of(object);
	if (i + 1 >= _first_place.size() || _first_place[i] + place >= _first_place[i + 1]) {
		return PersonId::Invalid;
	}
	return _holders[_first_place[i] + place];
}

} // namespace pcg
