#include "core/lang/dialect.h"

#include <algorithm>

namespace pcg {

namespace {

bool takes(const std::vector<ParamSpec> &params, size_t argument_count) {
	size_t required = 0;
	bool is_open = false;
	for (const ParamSpec &param : params) {
		required += param.is_optional || param.is_repeated ? 0 : 1;
		is_open |= param.is_repeated;
	}
	return argument_count >= required && (is_open || argument_count <= params.size());
}

template <typename Spec> int find_spec(const std::vector<Spec> &specs, std::string_view name, size_t argument_count) {
	for (size_t i = 0; i < specs.size(); ++i) {
		if (specs[i].name == name && takes(specs[i].params, argument_count)) {
			return int(i);
		}
	}
	return -1;
}

template <typename Spec> bool has_spec(const std::vector<Spec> &specs, std::string_view name) {
	for (const Spec &spec : specs) {
		if (spec.name == name) {
			return true;
		}
	}
	return false;
}

} // namespace

int Dialect::find_function(std::string_view function_name, size_t argument_count) const {
	return find_spec(functions, function_name, argument_count);
}

int Dialect::find_operation(std::string_view operation_name, size_t argument_count) const {
	return find_spec(operations, operation_name, argument_count);
}

int Dialect::find_variable(std::string_view variable_name) const {
	for (size_t i = 0; i < variables.size(); ++i) {
		if (variables[i].name == variable_name) {
			return int(i);
		}
	}
	return -1;
}

bool Dialect::has_function(std::string_view function_name) const { return has_spec(functions, function_name); }
bool Dialect::has_operation(std::string_view operation_name) const { return has_spec(operations, operation_name); }

bool Dialect::takes_rule(std::string_view operation_name) const {
	return std::ranges::any_of(operations, [&](const OperationSpec &spec) { return spec.takes_rule && spec.name == operation_name; });
}

bool Dialect::takes_conditions(std::string_view operation_name) const {
	return std::ranges::any_of(operations, [&](const OperationSpec &spec) { return spec.block == BlockKind::Predicates && spec.name == operation_name; });
}

void add_annotations(Dialect &dialect) {
	std::vector<AnnotationSpec> &annotations = dialect.annotations;
	annotations.push_back({ "StartRule", "", "Marks the rule that begins." });
	annotations.push_back({ "Group", "(\"name\" [, order])", "The attributes from here on stand in that group." });
	annotations.push_back({ "Range", "(min=0, max=1 [, stepsize=0.1])", "What the attribute may be; @Range(\"a\", \"b\") lists texts." });
	annotations.push_back({ "Enum", "(\"a\", \"b\")", "The values to choose from." });
	annotations.push_back({ "Color", "", "The attribute is a colour, \"#rrggbb\"." });
	annotations.push_back({ "File", "(\"png\")", "The attribute is the path of a file." });
	annotations.push_back({ "Description", "(\"text\")", "What the attribute means." });
	annotations.push_back({ "Order", "(number)", "Where the attribute or rule stands among the others." });
	annotations.push_back({ "Hidden", "", "The attribute is not shown." });
	annotations.push_back({ "Percent", "", "The attribute is a part of one." });
	annotations.push_back({ "Angle", "", "The attribute is an angle in degrees." });
	annotations.push_back({ "Distance", "", "The attribute is a length in metres." });
}

} // namespace pcg
