#include "core/io/json_place.h"

#include <algorithm>
#include <charconv>

namespace pcg {

namespace {

// Walks through a text that is known to be JSON; at the end of a text that is not, it stays there.
class Walker {
public:
	explicit Walker(std::string_view text) : _text(text) {}

	size_t at() {
		skip_space();
		return _at;
	}

	// From the beginning of an object to the value of its last member of that name, as readers take the last one. False: there is none.
	bool enter_member(std::string_view key) {
		size_t found = std::string_view::npos;
		for (bool is_first = true; open_next('{', '}', is_first); is_first = false) {
			const size_t start = at();
			skip_string();
			const std::string_view name = _text.substr(start, _at - start);
			skip_space();
			_at = std::min(_at + 1, _text.size()); // the colon
			if (name.size() == key.size() + 2 && name.substr(1, key.size()) == key) {
				found = at();
			}
			skip_value();
		}
		_at = std::min(found, _text.size());
		return found != std::string_view::npos;
	}

	bool enter_element(size_t index) {
		size_t i = 0;
		for (bool is_first = true; open_next('[', ']', is_first); is_first = false) {
			if (i++ == index) {
				return true;
			}
			skip_value();
		}
		return false;
	}

private:
	char peek() {
		skip_space();
		return _at < _text.size() ? _text[_at] : '\0';
	}

	// Behind the bracket or the comma in front of the next entry; false at the closing bracket.
	bool open_next(char open, char close, bool is_first) {
		if (peek() != (is_first ? open : ',')) {
			return false;
		}
		++_at;
		return peek() != close && peek() != '\0';
	}

	void skip_space() {
		while (_at < _text.size() && (_text[_at] == ' ' || _text[_at] == '\t' || _text[_at] == '\n' || _text[_at] == '\r')) {
			++_at;
		}
	}

	void skip_string() {
		for (++_at; _at < _text.size() && _text[_at] != '"'; ++_at) {
			_at += _text[_at] == '\\' ? 1 : 0;
		}
		_at = std::min(_at + 1, _text.size());
	}

	void skip_value() {
		size_t depth = 0;
		do {
			const char c = peek();
			if (c == '"') {
				skip_string();
			} else if (c == ',' || c == ':') {
				++_at;
			} else if (c == '{' || c == '[') {
				++depth;
				++_at;
			} else if (c == '}' || c == ']') {
				--depth;
				++_at;
			} else {
				_at = std::min(_text.find_first_of(",]} \t\r\n", _at), _text.size());
			}
		} while (depth > 0 && _at < _text.size());
	}

	std::string_view _text;
	size_t _at = 0;
};

} // namespace

size_t find_json_place(std::string_view text, std::string_view path) {
	Walker walker(text);
	size_t place = walker.at();
	while (!path.empty()) {
		bool is_there = false;
		if (path[0] == '[') {
			size_t index = 0;
			const size_t end = std::min(path.find(']'), path.size() - 1);
			std::from_chars(path.data() + 1, path.data() + end, index);
			path.remove_prefix(end + 1);
			is_there = walker.enter_element(index);
		} else {
			path.remove_prefix(path[0] == '.' ? 1 : 0);
			const std::string_view key = path.substr(0, path.find_first_of(".["));
			path.remove_prefix(key.size());
			is_there = walker.enter_member(key);
		}
		if (!is_there) {
			break;
		}
		place = walker.at();
	}
	return place;
}

} // namespace pcg
