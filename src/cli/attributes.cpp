#include "cli/attributes.h"

#include <charconv>
#include <cmath>

namespace pcg::cli {

namespace {

bool is_not_finite(const std::string &text) {
	double number = 0.0;
	const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
	return error == std::errc() && end == text.data() + text.size() && !std::isfinite(number);
}

} // namespace

std::vector<AttributeText> read_attributes(Args &args) {
	std::vector<AttributeText> result;
	for (const std::string &setting : args.all("--attr")) {
		const size_t equals = setting.find('=');
		if (equals == std::string::npos || equals == 0) {
			args.problem("--attr wants NAME=VALUE, not " + setting);
			continue;
		}
		result.push_back({ setting.substr(0, equals), setting.substr(equals + 1) });
		if (is_not_finite(result.back().value)) {
			args.problem("--attr " + setting + ": rules cannot reckon with " + result.back().value);
		}
	}
	return result;
}

std::vector<AttributeOverride> attributes_of(const Program &program, const std::vector<AttributeText> &texts) {
	std::vector<AttributeOverride> result;
	for (const AttributeText &text : texts) {
		result.push_back({ text.name, attribute_value(program, text.name, text.value) });
	}
	return result;
}

} // namespace pcg::cli
