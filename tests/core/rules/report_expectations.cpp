#include "report_expectations.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <string>

namespace pcg {

namespace {

constexpr double tolerance = 1e-3;

double figure(const cga::DerivationResult &model, const cga::ModelReport &report, const std::string &what) {
	return what == "place" ? double(&report - model.reports.data()) : what == "sum" ? report.sum : what == "count" ? double(report.count) : what == "min" ? report.min : what == "max" ? report.max : NAN;
}

// most, first and last are of texts; first and last by their order.
std::string text_of(const cga::ModelReport &report, const std::string &what) {
	return report.texts.empty() ? "" : what == "most" ? std::string(report.most_frequent_text())
			: what == "first"						  ? report.texts.begin()->first
													  : report.texts.rbegin()->first;
}

bool fits(const cga::DerivationResult &model, const cga::ModelReport &report, std::istringstream line) {
	bool result = true;
	for (std::string what; line >> what;) {
		std::string text;
		const bool is_text = what == "most" || what == "first" || what == "last";
		result = result && (is_text ? bool(line >> std::quoted(text)) && text_of(report, what) == text : is_near(figure(model, report, what), read_number(line)));
	}
	return result;
}

} // namespace

bool is_near(double a, double b) {
	return std::abs(a - b) <= tolerance * std::max(1.0, std::abs(b));
}

bool is_near(glm::dvec3 a, glm::dvec3 b) {
	return is_near(a.x, b.x) && is_near(a.y, b.y) && is_near(a.z, b.z);
}

double read_number(std::istringstream &line) {
	double number = NAN;
	line >> number;
	return number;
}

bool has_report(const cga::DerivationResult &model, std::istringstream &line) {
	std::string name;
	line >> std::quoted(name);
	std::string rest;
	std::getline(line, rest);
	return std::ranges::any_of(model.reports,
			[&](const cga::ModelReport &report) { return report_name(model.reports, report) == name && fits(model, report, std::istringstream(rest)); });
}

} // namespace pcg
