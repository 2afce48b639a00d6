#include "core/population/household_draw.h"

#include <algorithm>

#include "core/population/age_pyramid.h"

namespace pcg {

namespace {

constexpr double one_more = 0.25;
constexpr int youngest_parent = 18;
constexpr int oldest_parent = 45;
constexpr int couple_years_apart = 10;

struct AgeRange {
	int first;
	int last;
	bool is_empty() const { return last < first; }
	// The part that both have in common, or this one where there is none.
	AgeRange narrowed(AgeRange other) const {
		const AgeRange common{ std::max(first, other.first), std::min(last, other.last) };
		return common.is_empty() ? *this : common;
	}
};

Gender draw_gender(MemberGroup::Sex sex, Random &random) {
	if (sex == MemberGroup::Sex::Any) {
		return random.chance(0.5) ? Gender::Woman : Gender::Man;
	}
	return sex == MemberGroup::Sex::Woman ? Gender::Woman : Gender::Man;
}

int draw_count(const MemberGroup &group, Random &random, int room) {
	int count = group.count;
	while (group.is_open && count < room && random.chance(one_more)) {
		++count;
	}
	return count;
}

struct MinorAges {
	int youngest = 0;
	int oldest = 0;
};

// Minors are drawn first, because their ages narrow those of the adults.
MinorAges add_minors(std::vector<DrawnMember> &members, const HouseholdPattern &pattern, Random &random) {
	for (const MemberGroup &group : pattern.groups) {
		const int count = group.is_minor ? draw_count(group, random, max_members / 2) : 0;
		for (int i = 0; i < count; ++i) {
			const Gender gender = draw_gender(group.sex, random);
			members.push_back({ gender, draw_age(random, gender, group.min_age, group.max_age) });
		}
	}
	MinorAges ages;
	if (!members.empty()) {
		const auto by_age = [](const DrawnMember &a, const DrawnMember &b) { return a.age < b.age; };
		ages.youngest = std::min_element(members.begin(), members.end(), by_age)->age;
		ages.oldest = std::max_element(members.begin(), members.end(), by_age)->age;
	}
	return ages;
}

} // namespace

std::vector<DrawnMember> draw_members(const HouseholdPattern &pattern, Random &random) {
	std::vector<DrawnMember> minors;
	const MinorAges ages = add_minors(minors, pattern, random);
	int adults = 0;
	for (const MemberGroup &group : pattern.groups) {
		adults += group.is_minor ? 0 : group.count;
	}
	const bool is_pair = pattern.is_couple || (!minors.empty() && adults == 2);
	std::vector<DrawnMember> members;
	for (const MemberGroup &group : pattern.groups) {
		const int count = group.is_minor ? 0 : draw_count(group, random, max_members / 2);
		for (int i = 0; i < count; ++i) {
			const Gender gender = draw_gender(group.sex, random);
			AgeRange range{ group.min_age, group.max_age };
			if (members.empty()) {
				range = range.narrowed({ adult_age, oldest_age });
			}
			if (!minors.empty() && members.size() < 2) {
				range = range.narrowed({ ages.oldest + youngest_parent, ages.youngest + oldest_parent });
			}
			if (is_pair && members.size() == 1) {
				range = range.narrowed({ members[0].age - couple_years_apart, members[0].age + couple_years_apart });
			}
			members.push_back({ gender, draw_age(random, gender, range.first, range.last) });
		}
	}
	members.insert(members.end(), minors.begin(), minors.end());
	return members;
}

} // namespace pcg
