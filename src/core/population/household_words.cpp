#include "core/population/household_words.h"

#include <algorithm>
#include <cctype>

#include "core/population/descriptor_words.h"

namespace pcg {

using namespace descriptor_words;

namespace {

class Reader {
public:
	Reader(std::string_view descriptor, int adult_from) : _words(split_words(descriptor)), _adult_from(adult_from) {}

	Result<HouseholdPattern> read() {
		while (_at < _words.size() && _problem.empty() && !_is_too_large) {
			read_next();
		}
		check();
		if (_is_too_large) {
			return too_large_household();
		}
		if (!_problem.empty()) {
			Diagnostic diagnostic;
			diagnostic.id = "unknown-household-words";
			diagnostic.message = _problem;
			diagnostic.hint = std::string(understood_household_words());
			return diagnostic;
		}
		return _pattern;
	}

private:
	std::string_view word(size_t ahead = 0) const {
		return _at + ahead < _words.size() ? std::string_view(_words[_at + ahead]) : std::string_view();
	}
	// Takes all these words, or none.
	bool take(std::string_view phrase) {
		const Words expected = split_words(phrase);
		for (size_t i = 0; i < expected.size(); ++i) {
			if (word(i) != expected[i]) {
				return false;
			}
		}
		_at += expected.size();
		return true;
	}
	bool take_or_more() {
		return take("or more") || take("or over") || take("and over") || take("and more") || take("or older") ||
				take("and older") || take("years or over") || take("years and over") || take("years or more") ||
				take("years or older") || take("years and older");
	}

	void read_next() {
		if (read_phrase() || read_count() || read_ages() || read_noun()) {
			return;
		}
		if (is_one_of(word(), filler_words)) {
			++_at;
			return;
		}
		_problem = "the words '" + std::string(word()) + "' of this household are not understood";
	}

	// Set phrases of census tables.
	bool read_phrase() {
		if (take("no spouse partner present") || take("no spouse partner") || take("no partner") || take("no spouse present") ||
				take("no spouse") || take("without partner")) {
			return true;
		}
		if (take("with or without minors") || take("with or without children") || take("with or without minor children")) {
			add({ 0, true, MemberGroup::Sex::Any, true, 0, minor_max() });
			return true;
		}
		if (take("without own children under 18") || take("without children under 18") || take("without own children") ||
				take("without children") || take("without minors") || take("without minor children") || take("no own children") ||
				take("no minors") || take("no children") || take("no minor children") || take("no kids")) {
			return true;
		}
		if (take("living alone") || take("alone")) {
			_is_alone = true;
			return true;
		}
		if (take("male householder") || take("female householder")) {
			add(adults(1, false, word_before_is_male() ? MemberGroup::Sex::Man : MemberGroup::Sex::Woman));
			return true;
		}
		return false;
	}
	bool word_before_is_male() const { return _words[_at - 2] == "male"; }

	bool read_count() {
		if (take("at least")) {
			_is_at_least = true;
			return true;
		}
		if (starts_ages()) {
			return false;
		}
		const std::optional<int> number = number_of(word());
		if (!number) {
			return false;
		}
		++_at;
		if (*number > max_members) {
			_is_too_large = true;
			return true;
		}
		flush_count();
		_count = *number;
		_is_open = take_or_more();
		return true;
	}

	// "16 to 64", "65 or over", "under 18", with or without "aged".
	bool starts_ages() const {
		const bool is_digits = !word().empty() && std::isdigit(static_cast<unsigned char>(word()[0]));
		if (!is_digits) {
			return false;
		}
		const bool is_range = word(1) == "to" || word(1) == "and";
		const bool has_unit = word(1) == "years" || word(1) == "year";
		const bool follows_people = _count < 0 && !_pattern.groups.empty();
		return is_range || has_unit || (follows_people && (word(1) == "or" || number_of(word()).value_or(0) > max_members));
	}

	bool read_ages() {
		const size_t start = _at;
		const bool is_told = take("aged") || take("of age") || take("ages") || take("age") || take("between");
		const bool is_under = take("under") || take("below");
		take("of");
		if (const std::optional<int> low = number_of(word()); low && (is_told || is_under || starts_ages())) {
			++_at;
			int first = is_under ? 0 : *low;
			int last = is_under ? *low - 1 : *low;
			if (take_or_more()) {
				last = oldest;
			} else if (!is_under && (take("to") || take("and"))) {
				const std::optional<int> high = number_of(word());
				if (!high || *high < first || *high > 120) {
					_problem = "an age range needs two ages, the smaller first";
					return true;
				}
				last = std::min(*high, oldest);
				++_at;
			}
			take("years");
			set_ages(first, last);
			return true;
		}
		_at = start;
		return false;
	}

	void set_ages(int first, int last) {
		if (first > oldest || last < first) {
			_problem = "nobody can be of age " + std::to_string(first);
			return;
		}
		if (_count >= 0 && _is_at_least) {
			split_last(uint8_t(_count), uint8_t(first), uint8_t(last));
		} else if (_count >= 0) { // "one aged 16-34"
			MemberGroup group = adults(_count, _is_open, MemberGroup::Sex::Any);
			group.min_age = uint8_t(first);
			group.max_age = uint8_t(last);
			add(group);
		} else if (!_pattern.groups.empty()) {
			for (size_t i = _last_group; i < _pattern.groups.size(); ++i) {
				_pattern.groups[i].min_age = uint8_t(first);
				_pattern.groups[i].max_age = uint8_t(last);
			}
		} else {
			_problem = "ages stand before the person they belong to";
		}
		forget_count();
	}

	// "Two adults, at least one aged 65 or over": that many of the group before.
	void split_last(uint8_t count, uint8_t first, uint8_t last) {
		if (_pattern.groups.empty() || _pattern.groups.back().count < count) {
			_problem = "'at least " + std::to_string(int(count)) + "' is more than the persons before it";
			return;
		}
		MemberGroup part = _pattern.groups.back();
		_pattern.groups.back().count = uint8_t(part.count - count);
		part.count = count;
		part.is_open = false;
		part.min_age = first;
		part.max_age = last;
		_pattern.groups.insert(_pattern.groups.end() - 1, part);
	}

	bool read_noun() {
		const std::string_view noun = word();
		if (is_one_of(noun, "adult") && is_one_of(word(1), "woman women man men male female couple couples")) {
			++_at; // "adult woman"
			return true;
		}
		if (is_one_of(noun, "minor") && is_one_of(word(1), "child children kid kids boy boys girl girls son daughter")) {
			++_at;
			return true;
		}
		if (is_one_of(noun, elder_words)) {
			++_at;
			_is_elder = true;
			if (is_people_noun(word()) || word() == "adult") {
				return true; // "elderly woman"
			}
			return finish_people(MemberGroup::Sex::Any, noun);
		}
		if (is_one_of(noun, couple_words)) {
			++_at;
			add_couple();
			return true;
		}
		return read_plain_noun(noun);
	}

	static bool is_people_noun(std::string_view noun) {
		return is_one_of(noun, adult_words) || is_one_of(noun, woman_words) || is_one_of(noun, man_words) || is_one_of(noun, couple_words);
	}

	bool read_plain_noun(std::string_view noun) {
		const bool is_boy = is_one_of(noun, boy_words);
		const bool is_girl = is_one_of(noun, girl_words);
		if (is_boy || is_girl || is_one_of(noun, minor_words)) {
			++_at;
			const bool is_counted = _count >= 0;
			const MemberGroup::Sex sex = is_boy ? MemberGroup::Sex::Man : is_girl ? MemberGroup::Sex::Woman : MemberGroup::Sex::Any;
			add({ uint8_t(is_counted ? _count : 1), is_counted ? _is_open : is_plural(noun), sex, true, 0, minor_max() });
			return true;
		}
		for (const auto &[list, sex] : { std::pair{ adult_words, MemberGroup::Sex::Any }, { woman_words, MemberGroup::Sex::Woman },
					 { man_words, MemberGroup::Sex::Man } }) {
			if (is_one_of(noun, list)) {
				++_at;
				return finish_people(sex, noun);
			}
		}
		return false;
	}

	bool finish_people(MemberGroup::Sex sex, std::string_view noun) {
		if (_count < 0 && is_plural(noun)) {
			_problem = "how many '" + std::string(noun) + "' there are is missing";
			return true;
		}
		add(adults(_count < 0 ? 1 : _count, _is_open, sex));
		return true;
	}

	MemberGroup adults(int count, bool is_open, MemberGroup::Sex sex) const {
		return { uint8_t(count), is_open, sex, false, uint8_t(_is_elder ? elder_age : _adult_from), uint8_t(oldest) };
	}
	uint8_t minor_max() const { return uint8_t(_adult_from - 1); }

	void add(MemberGroup group) {
		group.is_open = group.is_open || (_is_at_least && _count >= 0);
		_last_group = _pattern.groups.size();
		_pattern.groups.push_back(group);
		_is_elder = false;
		forget_count();
	}
	void add_couple() {
		if (_count > 1) {
			_problem = "a household of several couples has to be told by columns";
			return;
		}
		const bool is_elder = _is_elder;
		add(adults(1, false, MemberGroup::Sex::Woman));
		_is_elder = is_elder;
		add(adults(1, false, MemberGroup::Sex::Man));
		--_last_group;
		_pattern.is_couple = true;
	}
	void forget_count() {
		_count = -1;
		_is_open = false;
		_is_at_least = false;
	}
	void flush_count() {
		if (_count > 0) {
			_problem = "the number " + std::to_string(_count) + " stands before nothing";
		}
	}

	void check() {
		if (!_problem.empty() || _is_too_large) {
			return;
		}
		flush_count();
		int total = 0;
		int grown = 0;
		for (const MemberGroup &group : _pattern.groups) {
			total += group.count;
			grown += group.is_minor ? 0 : group.count;
		}
		if (grown == 0 && _problem.empty()) {
			_problem = total == 0 ? "this names nobody who lives in the household" : "a household needs at least one adult";
		} else if (_is_alone && total != 1) {
			_problem = "'alone' does not go with " + std::to_string(total) + " members";
		} else {
			_is_too_large = total > max_members && _problem.empty();
		}
	}

	static constexpr int oldest = 99;

	Words _words;
	int _adult_from;
	size_t _at = 0;
	HouseholdPattern _pattern;
	std::string _problem;
	bool _is_too_large = false;
	size_t _last_group = 0; // ages that follow belong to the groups from here on
	int _count = -1; // the number read before the noun it belongs to; -1 = none
	bool _is_open = false;
	bool _is_at_least = false;
	bool _is_elder = false;
	bool _is_alone = false;
};

} // namespace

Diagnostic too_large_household() {
	Diagnostic diagnostic;
	diagnostic.severity = Severity::Warning;
	diagnostic.id = "household-too-large";
	diagnostic.message = "a household larger than " + std::to_string(max_members) + " members is left out";
	diagnostic.hint = "write smaller households in its place";
	return diagnostic;
}

Result<HouseholdPattern> read_household_words(std::string_view descriptor, int adult_from) {
	Result<HouseholdPattern> result = Reader(descriptor, adult_from).read();
	if (result) {
		result->descriptor = std::string(descriptor);
	}
	return result;
}

std::string_view understood_household_words() {
	return "understood are numbers (one .. ten, 'or more', 'no'), adults, women, men, couple, parents, elders, minors, children, "
		   "'householder', 'living alone', and ages ('aged 16-64', '65 or over', 'under 18'); any other household can be told by the "
		   "columns adults, elders, minors, women, men, min_age, max_age, adult_from";
}

} // namespace pcg
