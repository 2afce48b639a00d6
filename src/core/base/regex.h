#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Patterns in file searches. All states are followed at once (Thompson 1968), so that no pattern takes more than pattern times text; the
// standard library's engine backtracks on the machine's stack and throws.
namespace pcg {

// `*` any characters, `?` one character; everything else is itself. The whole text must fit.
bool matches_wildcard(std::string_view pattern, std::string_view text);

// . [a-z] [^a-z] \d \w \s \D \W \S ( ) (?: ) | * + ? {2} {2,} {2,5} ^ $ and \ before any sign. Bytes, not characters.
class Regex {
public:
	// Nothing: the pattern is wrong, or larger than a few thousand steps.
	static std::optional<Regex> compile(std::string_view pattern);

	bool matches_all(std::string_view text) const;
	// Length of the longest match that begins at `start`; npos if there is none.
	size_t match_at(std::string_view text, size_t start) const;

private:
	friend class RegexCompiler;
	enum class Op : uint8_t { Byte, Set, Split, Jump, Begin, End, Match };
	struct Step {
		Op op = Op::Match;
		int32_t a = 0; // Byte: its value; Set: its number; Split, Jump: how far from here
		int32_t b = 0; // Split: the other way
	};
	using Set = std::vector<bool>; // by byte

	void follow(std::vector<uint32_t> &states, std::vector<uint32_t> &marks, uint32_t mark, uint32_t step, std::string_view text, size_t at) const;

	std::vector<Step> _steps;
	std::vector<Set> _sets;
};

} // namespace pcg
