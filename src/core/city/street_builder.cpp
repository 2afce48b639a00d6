#include "core/city/street_builder.h"

#include <set>

#include "core/city/lot_semantics.h"
#include "core/city/model_merge.h"
#include "core/lang/program.h"

namespace pcg {

namespace {

// What the rules ask for of what a piece says about itself. Values of another type than theirs are left out: the name is theirs.
std::vector<AttributeOverride> asked_for(const Program &program, const std::vector<AttributeOverride> &attributes) {
	std::vector<AttributeOverride> result;
	for (const AttributeOverride &attribute : attributes) {
		if (program.find_attribute(attribute.name) >= 0 && !attribute_problem(program, attribute)) {
			result.push_back(attribute);
		}
	}
	return result;
}

} // namespace

StreetBuilder::StreetBuilder(const Layout &layout, const CityOptions &options)
	: _layout(layout), _rules(options.streets), _shapes(layout), _groups(group_ground(layout)), _messages(part_count()) {}

bool StreetBuilder::can_build(const std::string &start_rule) const {
	const Program *program = _rules.program.get();
	const RuleId rule = program ? program->find_rule(start_rule) : RuleId::Invalid;
	return rule != RuleId::Invalid && !program->rules[size_t(rule)].is_leaf_symbol;
}

cga::DerivationResult StreetBuilder::build_piece(uint32_t piece, Derivers &derivers, Diagnostics &diagnostics) const {
	ModelMerge whole;
	for (cga::InitialShape &shape : _rules.program ? _shapes.of(piece) : std::vector<cga::InitialShape>()) {
		if (!can_build(shape.start_rule)) {
			return plain_ground(_layout.ground[piece]);
		}
		shape.attributes = asked_for(*_rules.program, shape.attributes);
		shape.attributes.insert(shape.attributes.end(), _rules.attributes.begin(), _rules.attributes.end());
		const cga::DerivationResult part = derivers.derive(*_rules.program, shape);
		diagnostics.append(part.diagnostics);
		whole.add(part);
	}
	return _rules.program && !diagnostics.has_errors() ? whole.take() : plain_ground(_layout.ground[piece]);
}

void StreetBuilder::build(size_t part, PublicGround &ground, Derivers &derivers) {
	const bool is_street = part < _groups.streets.size();
	const size_t index = is_street ? part : part - _groups.streets.size();
	ModelMerge whole;
	if (!is_street) {
		whole.add(lot_ground(_layout, _layout.blocks[index]));
	}
	for (const uint32_t piece : is_street ? _groups.streets[index] : _groups.blocks[index]) {
		Diagnostics diagnostics;
		whole.add(build_piece(piece, derivers, diagnostics));
		if (!diagnostics.is_empty()) {
			_messages[part].emplace_back(piece, std::move(diagnostics));
		}
	}
	(is_street ? ground.streets : ground.blocks)[index].model = whole.take();
}

void StreetBuilder::report(Diagnostics &diagnostics) const {
	LotMessages messages("piece");
	for (const auto &part : _messages) {
		for (const auto &[piece, of_piece] : part) {
			messages.add(_shapes.name_of(piece), of_piece);
		}
	}
	messages.hand_over(diagnostics);
	std::set<std::string> missing;
	for (uint32_t i = 0; _rules.program && i < _layout.ground.size(); ++i) {
		const std::string start_rule = start_rule_of(_layout.ground[i]);
		if (!can_build(start_rule) && missing.insert(start_rule).second) {
			diagnostics.warning("no-street-rule", "the street rules have no rule `" + start_rule + "`, so such ground is plain",
					"write this rule, or use rules that have it");
		}
	}
}

void register_ground(City &city, Diagnostics &diagnostics) {
	size_t doors = 0;
	for (std::vector<GroundBuild> *builds : { &city.ground.streets, &city.ground.blocks }) {
		for (GroundBuild &build : *builds) {
			build.zones = add_zones(city, build.model, LotId::Invalid);
			build.objects = add_objects(city, build.model, LotId::Invalid);
			doors += build.model.entrances.size();
		}
	}
	if (doors > 0) {
		diagnostics.warning("street-entrance", "the street rules make " + std::to_string(doors) + " entrances, which lead nowhere: streets have no buildings",
				"call zone() or use @Object there");
	}
}

} // namespace pcg
