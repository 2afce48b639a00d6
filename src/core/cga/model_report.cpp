#include "core/cga/model_report.h"

#include <algorithm>

namespace pcg::cga {

void ModelReport::add(const Value &value) {
	if (value.is_text()) {
		const auto found = texts.find(value.text->view);
		++(found != texts.end() ? found : texts.emplace(value.text->view, 0).first)->second;
		++count;
		return;
	}
	const double number = value.is_number() ? value.number : value.boolean ? 1.0 : 0.0;
	min = count == 0 ? number : std::min(min, number);
	max = count == 0 ? number : std::max(max, number);
	sum += number;
	++count;
}

void ModelReport::merge(const ModelReport &other) {
	min = count == 0 ? other.min : std::min(min, other.min);
	max = count == 0 ? other.max : std::max(max, other.max);
	sum += other.sum;
	count += other.count;
	for (const auto &[text, times] : other.texts) {
		texts[text] += times;
	}
}

std::string_view ModelReport::most_frequent_text() const {
	const auto most = std::ranges::max_element(texts, {}, [](const auto &entry) { return entry.second; }); // the first of equal ones
	return most != texts.end() ? std::string_view(most->first) : std::string_view();
}

std::string report_name(const std::vector<ModelReport> &reports, const ModelReport &report) {
	const bool has_others = std::ranges::any_of(reports, [&](const ModelReport &other) { return other.key == report.key && other.type < report.type; });
	return !has_others ? report.key : report.key + (report.type == ValueType::Bool ? " (bool)" : " (text)");
}

} // namespace pcg::cga
