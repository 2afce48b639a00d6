#include <optional>
#include <string>

#include "core/agenda/generation_context.h"
#include "core/agenda/operations/constant_checks.h"
#include "core/agenda/operations/operations.h"
#include "core/base/day_names.h"

namespace pcg::agenda {

namespace {

std::string_view trimmed(std::string_view text) {
	while (!text.empty() && text.front() == ' ') {
		text.remove_prefix(1);
	}
	while (!text.empty() && text.back() == ' ') {
		text.remove_suffix(1);
	}
	return text;
}

// "mon" or "monday", in any case.
std::optional<int> day_number(std::string_view text) {
	for (size_t day = 0; day < day_names.size(); ++day) {
		bool is_same = text.size() == 3 || text.size() == day_names[day].size();
		for (size_t i = 0; is_same && i < text.size(); ++i) {
			is_same = (text[i] | 0x20) == day_names[day][i];
		}
		if (is_same) {
			return int(day);
		}
	}
	return std::nullopt;
}

// "mon", "mon-fri", "fri-mon" (over the weekend).
std::optional<DayMask> range_mask(std::string_view text) {
	const size_t dash = text.find('-');
	const std::optional<int> first = day_number(trimmed(text.substr(0, dash)));
	const std::optional<int> last = dash == std::string_view::npos ? first : day_number(trimmed(text.substr(dash + 1)));
	if (!first || !last) {
		return std::nullopt;
	}
	DayMask mask = 0;
	for (int day = *first;; day = (day + 1) % 7) {
		mask |= DayMask(1u << day);
		if (day == *last) {
			return mask;
		}
	}
}

std::optional<DayMask> days_mask(std::string_view text, std::string_view &culprit) {
	DayMask mask = 0;
	while (true) {
		const size_t comma = text.find(',');
		culprit = trimmed(text.substr(0, comma));
		const std::optional<DayMask> range = range_mask(culprit);
		if (!range) {
			return std::nullopt;
		}
		mask |= *range;
		if (comma == std::string_view::npos) {
			return mask;
		}
		text.remove_prefix(comma + 1);
	}
}

CallProblem unknown_day(std::string_view culprit) {
	return { "unknown-day", "'" + std::string(culprit) + "' is no day, so nothing is inserted there",
		"days are mon tue wed thu fri sat sun, as in \"mon-fri\" or \"sat,sun\"", 0 };
}

// Within one rule; others are called from many places (GenerationContext::note_inner_days).
std::optional<CallProblem> check_days(const KnownCall &call) {
	if (!call.arguments[0].is_text()) {
		return std::nullopt;
	}
	std::string_view culprit;
	const std::optional<DayMask> mask = days_mask(call.arguments[0].text->view, culprit);
	if (!mask) {
		return unknown_day(culprit);
	}
	DayMask outer = all_days;
	for (const Value &around : call.around) {
		outer &= around.is_text() ? days_mask(around.text->view, culprit).value_or(all_days) : all_days;
	}
	if (outer == 0 || (outer & *mask) != 0) {
		return std::nullopt;
	}
	CallProblem problem = no_days(outer);
	problem.argument = 0;
	return problem;
}

Flow days(Vm &vm, const Args &args) {
	GenerationContext *context = writing_context(vm);
	if (context == nullptr) {
		return Flow::Next;
	}
	std::string_view culprit;
	const std::optional<DayMask> mask = days_mask(args[0].text->view, culprit);
	if (!mask) {
		warn(vm, unknown_day(culprit));
		return Flow::Next;
	}
	const DayMask outer = context->named_days(), inner = outer & *mask;
	if (outer != all_days) {
		context->note_inner_days(vm.address(), outer, inner);
	}
	if ((context->days() & inner) == 0) {
		return Flow::Next;
	}
	context->set_named_days(inner);
	Flow flow = Flow::Next;
	for (const BlockEntry &entry : vm.entries(*args.block)) {
		flow = vm.run_body(entry.body);
		if (flow == Flow::Stop) {
			break;
		}
	}
	context->set_named_days(outer);
	return flow;
}

} // namespace

void add_days(Dialect &dialect) {
	dialect.operations.push_back({ "days", { { "days", ParamKind::Text } }, BlockKind::Bodies, days,
			"days(\"mon-fri\") { actions }: entries written inside apply to those days only; outside of it to all seven.", Phase::Generation,
			nullptr, check_days });
}

} // namespace pcg::agenda
