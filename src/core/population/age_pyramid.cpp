#include "core/population/age_pyramid.h"

#include <algorithm>
#include <array>

namespace pcg {

namespace {

struct AgeBand {
	int first;
	int end; // one behind the last year
	double men;
	double women;
	bool is_declining; // in a straight line to nobody at `end`
};

constexpr std::array<AgeBand, 5> bands{ {
		{ 0, 15, 31'374'555, 30'034'371, false },
		{ 15, 25, 21'931'368, 21'006'463, false },
		{ 25, 55, 64'893'670, 64'564'565, false },
		{ 55, 65, 20'690'736, 22'091'808, false },
		{ 65, 100, 25'014'147, 31'037'419, true },
} };

double people_of_age(const AgeBand &band, Gender gender, int age) {
	const double people = gender == Gender::Man ? band.men : band.women;
	const int years = band.end - band.first;
	if (!band.is_declining) {
		return people / years;
	}
	return people * 2.0 * (band.end - age) / (double(years) * (years + 1));
}

double people_of_age(Gender gender, int age) {
	for (const AgeBand &band : bands) {
		if (age >= band.first && age < band.end) {
			return people_of_age(band, gender, age);
		}
	}
	return 0.0;
}

} // namespace

int draw_age(Random &random, Gender gender, int first, int last) {
	first = std::clamp(first, 0, oldest_age);
	last = std::clamp(last, first, oldest_age);
	double total = 0.0;
	for (int age = first; age <= last; ++age) {
		total += people_of_age(gender, age);
	}
	double rest = random.uniform() * total;
	for (int age = first; age < last; ++age) {
		rest -= people_of_age(gender, age);
		if (rest < 0.0) {
			return age;
		}
	}
	return last;
}

double share_per_mille(int age) {
	double total = 0.0;
	for (const AgeBand &band : bands) {
		total += band.men + band.women;
	}
	return 1000.0 * (people_of_age(Gender::Man, age) + people_of_age(Gender::Woman, age)) / total;
}

} // namespace pcg
