#include "core/base/regex.h"

#include <algorithm>

namespace pcg {

bool matches_wildcard(std::string_view pattern, std::string_view text) {
	size_t p = 0, t = 0, star = std::string_view::npos, resume = 0;
	while (t < text.size()) {
		if (p < pattern.size() && pattern[p] == '*') {
			star = p++;
			resume = t;
		} else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
			++p;
			++t;
		} else if (star != std::string_view::npos) {
			p = star + 1;
			t = ++resume;
		} else {
			return false;
		}
	}
	return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

// Jumps are relative, so that a piece can be moved and copied as it is.
class RegexCompiler {
public:
	RegexCompiler(std::string_view pattern, Regex &regex) : _text(pattern), _regex(regex) {}

	bool run() {
		parse_choice(0);
		_has_failed |= _at < _text.size();
		_regex._steps.push_back({ Regex::Op::Match });
		return !_has_failed;
	}

private:
	using Op = Regex::Op;
	static constexpr size_t max_steps = 5000;
	static constexpr int max_depth = 100;

	bool is_at(char c) const { return _at < _text.size() && _text[_at] == c; }
	bool take(char c) {
		const bool is_taken = is_at(c);
		_at += is_taken ? 1 : 0;
		return is_taken;
	}
	size_t size() const { return _regex._steps.size(); }

	void emit(Op op, int64_t a = 0, int64_t b = 0) {
		if (size() >= max_steps) {
			_has_failed = true;
			return;
		}
		_regex._steps.push_back({ op, int32_t(a), int32_t(b) });
	}
	void insert(size_t at, Op op, int64_t a, int64_t b) {
		_regex._steps.insert(_regex._steps.begin() + std::ptrdiff_t(at), { op, int32_t(a), int32_t(b) });
	}

	void parse_choice(int depth) {
		_has_failed |= depth > max_depth;
		const size_t first = size();
		parse_sequence(depth);
		if (!_has_failed && take('|')) {
			insert(first, Op::Split, 1, int64_t(size() - first) + 2);
			const size_t jump = size();
			emit(Op::Jump);
			parse_choice(depth + 1);
			if (!_has_failed) {
				_regex._steps[jump].a = int32_t(size() - jump);
			}
		}
	}

	void parse_sequence(int depth) {
		while (!_has_failed && _at < _text.size() && !is_at('|') && !is_at(')')) {
			const size_t first = size();
			parse_atom(depth);
			while (!_has_failed && parse_repeat(first)) {
			}
		}
	}

	void parse_atom(int depth) {
		const char c = _text[_at++];
		if (c == '(') {
			if (_text.substr(_at, 2) == "?:") {
				_at += 2;
			}
			parse_choice(depth + 1);
			_has_failed |= !take(')');
		} else if (c == '[') {
			parse_set();
		} else if (c == '.') {
			emit_set(Regex::Set(256, true));
		} else if (c == '^' || c == '$') {
			emit(c == '^' ? Op::Begin : Op::End);
		} else if (c == '\\' && _at < _text.size()) {
			const char name = _text[_at++];
			Regex::Set set(256, false);
			add_class(set, name) ? emit_set(std::move(set)) : emit(Op::Byte, uint8_t(name));
		} else {
			_has_failed |= c == '*' || c == '+' || c == '?' || c == '\\';
			emit(Op::Byte, uint8_t(c));
		}
	}

	void emit_set(Regex::Set set) {
		_regex._sets.push_back(std::move(set));
		emit(Op::Set, int64_t(_regex._sets.size()) - 1);
	}

	// \d and the like; false: the sign means itself.
	static bool add_class(Regex::Set &set, char name) {
		const char lower = char(name | 0x20);
		if (lower != 'd' && lower != 'w' && lower != 's') {
			return false;
		}
		for (int i = 0; i < 256; ++i) {
			const bool is_digit = i >= '0' && i <= '9';
			const bool is_word = is_digit || (i >= 'a' && i <= 'z') || (i >= 'A' && i <= 'Z') || i == '_';
			const bool is_space = i == ' ' || (i >= '\t' && i <= '\r');
			const bool is_in = lower == 'd' ? is_digit : lower == 'w' ? is_word : is_space;
			set[size_t(i)] = set[size_t(i)] || is_in == (lower == name);
		}
		return true;
	}

	void parse_set() {
		Regex::Set set(256, false);
		const bool is_negated = take('^');
		for (bool is_first = true; _at < _text.size() && (is_first || !is_at(']')); is_first = false) {
			char low = _text[_at++];
			if (low == '\\' && _at < _text.size()) {
				low = _text[_at++];
				if (add_class(set, low)) {
					continue;
				}
			}
			char high = low;
			if (is_at('-') && _at + 1 < _text.size() && _text[_at + 1] != ']') {
				high = _text[_at + 1];
				_at += 2;
			}
			for (int i = uint8_t(low); i <= uint8_t(high); ++i) {
				set[size_t(i)] = true;
			}
		}
		_has_failed |= !take(']');
		if (is_negated) {
			set.flip();
		}
		emit_set(std::move(set));
	}

	size_t parse_number() {
		size_t number = 0;
		while (_at < _text.size() && _text[_at] >= '0' && _text[_at] <= '9') {
			number = std::min<size_t>(number * 10 + size_t(_text[_at++] - '0'), max_steps);
		}
		return number;
	}

	// What follows the piece from `first`; false: nothing that repeats it.
	bool parse_repeat(size_t first) {
		const size_t mark = _at;
		size_t least = 0, most = max_steps;
		if (take('+')) {
			least = 1;
		} else if (take('?')) {
			most = 1;
		} else if (take('{')) {
			least = parse_number();
			most = take(',') ? (is_at('}') ? max_steps : parse_number()) : least;
			_has_failed |= !take('}') || mark + 2 >= _at || most < least;
		} else if (!take('*')) {
			return false;
		}
		repeat(first, least, most);
		return true;
	}

	void repeat(size_t first, size_t least, size_t most) {
		const std::vector<Regex::Step> piece(_regex._steps.begin() + std::ptrdiff_t(first), _regex._steps.end());
		_regex._steps.resize(first);
		const int64_t length = int64_t(piece.size());
		const size_t copies = most == max_steps ? least + 1 : most;
		_has_failed |= first + copies * (piece.size() + 2) > max_steps;
		for (size_t i = 0; i < copies && !_has_failed; ++i) {
			const bool is_loop = most == max_steps && i == least;
			if (i >= least) {
				emit(Op::Split, 1, length + (is_loop ? 2 : 1));
			}
			_regex._steps.insert(_regex._steps.end(), piece.begin(), piece.end());
			if (is_loop) {
				emit(Op::Jump, -length - 1);
			}
		}
	}

	std::string_view _text;
	Regex &_regex;
	size_t _at = 0;
	bool _has_failed = false;
};

std::optional<Regex> Regex::compile(std::string_view pattern) {
	Regex regex;
	return RegexCompiler(pattern, regex).run() ? std::optional(std::move(regex)) : std::nullopt;
}

// Adds what can be reached from `step` without reading.
void Regex::follow(std::vector<uint32_t> &states, std::vector<uint32_t> &marks, uint32_t mark, uint32_t step, std::string_view text, size_t at) const {
	std::vector<uint32_t> open = { step };
	while (!open.empty()) {
		const uint32_t i = open.back();
		open.pop_back();
		if (marks[i] == mark) {
			continue;
		}
		marks[i] = mark;
		const Step &s = _steps[i];
		if (s.op == Op::Split || s.op == Op::Jump) {
			open.push_back(uint32_t(int64_t(i) + s.a));
			if (s.op == Op::Split) {
				open.push_back(uint32_t(int64_t(i) + s.b));
			}
		} else if (s.op == Op::Begin || s.op == Op::End) {
			if (s.op == Op::Begin ? at == 0 : at == text.size()) {
				open.push_back(i + 1);
			}
		} else {
			states.push_back(i);
		}
	}
}

size_t Regex::match_at(std::string_view text, size_t start) const {
	std::vector<uint32_t> states, next, marks(_steps.size(), 0);
	uint32_t mark = 1;
	size_t best = std::string_view::npos;
	follow(states, marks, mark, 0, text, start);
	for (size_t at = start; !states.empty(); ++at) {
		next.clear();
		++mark;
		for (uint32_t i : states) {
			const Step &s = _steps[i];
			if (s.op == Op::Match) {
				best = at - start;
			} else if (at < text.size() && (s.op == Op::Byte ? uint8_t(text[at]) == s.a : bool(_sets[size_t(s.a)][uint8_t(text[at])]))) {
				follow(next, marks, mark, i + 1, text, at + 1);
			}
		}
		states.swap(next);
	}
	return best;
}

bool Regex::matches_all(std::string_view text) const {
	return match_at(text, 0) == text.size();
}

} // namespace pcg
