#include "core/population/descriptor_words.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace pcg::descriptor_words {

Words split_words(std::string_view text) {
	Words words;
	std::string word;
	const auto finish = [&] {
		if (!word.empty()) {
			words.push_back(word);
			word.clear();
		}
	};
	for (size_t i = 0; i < text.size(); ++i) {
		const unsigned char c = static_cast<unsigned char>(text[i]);
		const bool is_after_number = !word.empty() && std::isdigit(static_cast<unsigned char>(word.back()));
		if (std::isalnum(c) || c >= 0x80) {
			word += char(std::tolower(c));
			continue;
		}
		finish();
		if (c == '+') {
			words.insert(words.end(), { "or", "more" });
		} else if (c == '-' && is_after_number && i + 1 < text.size() && std::isdigit(static_cast<unsigned char>(text[i + 1]))) {
			words.push_back("to");
		}
	}
	finish();
	return words;
}

bool is_one_of(std::string_view word, std::string_view list) {
	size_t start = 0;
	while (start < list.size()) {
		const size_t end = std::min(list.find(' ', start), list.size());
		if (list.substr(start, end - start) == word) {
			return true;
		}
		start = end + 1;
	}
	return false;
}

bool is_plural(std::string_view word) {
	return is_one_of(word, "adults persons people members parents women mothers females ladies men fathers males gentlemen elders "
						   "elderly seniors pensioners minors children kids boys sons girls daughters");
}

std::optional<int> number_of(std::string_view word) {
	constexpr int most_told = 1'000'000; // of digits; far beyond any household or age
	constexpr std::array<std::string_view, 11> names{ "no", "one", "two", "three", "four", "five", "six", "seven", "eight",
		"nine", "ten" };
	for (size_t i = 0; i < names.size(); ++i) {
		if (word == names[i]) {
			return int(i);
		}
	}
	if (word == "a" || word == "an") {
		return 1;
	}
	if (word.empty() || !std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; })) {
		return std::nullopt;
	}
	int number = 0;
	for (char c : word) {
		number = std::min(number * 10 + (c - '0'), most_told);
	}
	return number;
}

} // namespace pcg::descriptor_words
