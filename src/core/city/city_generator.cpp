#include "core/city/city_generator.h"

#include <algorithm>
#include <map>

#include "core/cga/neighborhood.h"
#include "core/city/city_bytes.h"
#include "core/city/derivers.h"
#include "core/city/lot_messages.h"
#include "core/city/lot_semantics.h"
#include "core/city/street_builder.h"
#include "core/lang/program.h"

namespace pcg {

namespace {

const LotRules *rules_of(const RulesByType &rules, const std::string &type) {
	auto found = rules.find(type);
	if (found == rules.end()) {
		found = rules.find("");
	}
	return found != rules.end() && found->second.program ? &found->second : nullptr;
}

bool has_height(const Program &program) {
	return std::any_of(program.attributes.begin(), program.attributes.end(), [](const AttributeInfo &attribute) {
		return attribute.kind == AttributeInfo::Kind::Attribute && attribute.name == "height";
	});
}

cga::InitialShape initial_shape(const Layout &layout, LotId id, const LotRules &rules) {
	const Lot &lot = layout.lot(id);
	std::vector<glm::dvec3> outline(lot.polygon.begin(), lot.polygon.end());
	cga::InitialShape shape = cga::InitialShape::of(std::move(outline), lot.seed);
	for (const std::vector<glm::vec3> &hole : lot.holes) {
		shape.faces[0].holes.emplace_back(hole.begin(), hole.end());
	}
	shape.street_widths = lot.street_widths;
	shape.name = lot_name(layout, id);
	shape.start_rule = rules.start_rule;
	shape.attributes = rules.attributes;
	if (lot.height > 0.0f && rules.program && has_height(*rules.program)) {
		shape.attributes.push_back({ "height", double(lot.height) });
	}
	return shape;
}

// What the rules of some lots may ask of others; empty if they ask nothing (CGA reference: inter queries).
using LotOccluders = std::vector<std::shared_ptr<const cga::Occluders>>;

// Null pointers where nobody of `lots` looks. What a lot shows to others is built without looking at others, so their order does not matter.
LotOccluders occluders_for(const City &city, std::span<const size_t> lots, const RulesByType &rules, const CityOptions &options, Derivers &derivers) {
	std::vector<cga::InitialShape> shapes(city.lots.size());
	std::vector<cga::DeriveJob> jobs(city.lots.size());
	for (size_t i = 0; i < jobs.size(); ++i) {
		const LotRules *lot_rules = rules_of(rules, city.layout.lots[i].type);
		shapes[i] = initial_shape(city.layout, LotId(i), lot_rules ? *lot_rules : LotRules());
		jobs[i] = { lot_rules ? lot_rules->program.get() : nullptr, &shapes[i] };
	}
	const std::vector<bool> is_asked = cga::asked_about(jobs, lots, options.derive.occlusion_distance);
	LotOccluders result(jobs.size());
	WorkOptions work = options.work;
	work.progress = {};
	parallel_for(jobs.size(), work, [&](size_t i) {
		if (is_asked[i] && jobs[i].program) {
			result[i] = derivers.occluders(*jobs[i].program, shapes[i]);
		}
	});
	return result;
}

LotOccluders occluders_for_asking(const City &city, const RulesByType &rules, const CityOptions &options, Derivers &derivers) {
	std::vector<size_t> asking;
	for (size_t i = 0; i < city.lots.size(); ++i) {
		const LotRules *lot_rules = rules_of(rules, city.layout.lots[i].type);
		if (lot_rules && derivers.asks_inter(*lot_rules->program)) {
			asking.push_back(i);
		}
	}
	return asking.empty() ? LotOccluders() : occluders_for(city, asking, rules, options, derivers);
}

void build_lot(City &city, LotId id, const LotRules &rules, const LotOccluders &occluders, const CityOptions &options, Derivers &derivers) {
	LotBuild &build = city.lots[index_of(id)];
	build.model = derivers.derive(*rules.program, initial_shape(city.layout, id, rules), { occluders, index_of(id) });
	build.free_ground = free_ground(city.layout.lot(id), build.model, options.free_ground);
}

// Where a lot cannot be used as what it is: neither a door nor a zone of its own type (a park).
bool is_useless(const City &city, LotId id) {
	const cga::DerivationResult &model = city.lots[index_of(id)].model;
	const std::string &type = city.layout.lot(id).type;
	const auto is_own_zone = [&](const cga::ModelZone &zone) { return zone.type == type; };
	return model.entrances.empty() && std::none_of(model.zones.begin(), model.zones.end(), is_own_zone);
}

// Takes the messages of a freshly built lot, and adds our own.
void collect_messages(City &city, LotId id, LotMessages &messages) {
	LotBuild &build = city.lots[index_of(id)];
	const std::string name = lot_name(city.layout, id);
	messages.add(name, build.model.diagnostics);
	build.model.diagnostics = Diagnostics();
	if (is_useless(city, id)) {
		const std::string &type = city.layout.lot(id).type;
		Diagnostic warning{ Severity::Warning, "no-entrance", {}, 0, 0, {}, {}, {} };
		warning.message = "its rules make neither an entrance nor a zone of type `" + type + "`, so nobody can go there";
		warning.hint = "call entrance(\"" + type + "\") where the door is, or zone(\"" + type + "\")";
		messages.add(name, std::move(warning));
	}
}

void report_missing_rules(const Layout &layout, const RulesByType &rules, Diagnostics &diagnostics) {
	std::map<std::string, size_t> missing;
	for (const Lot &lot : layout.lots) {
		if (!rules_of(rules, lot.type)) {
			++missing[lot.type];
		}
	}
	for (const auto &[type, count] : missing) {
		diagnostics.error("no-rules", "there are no rules for the lot type `" + type + "`, so " + std::to_string(count) +
						" lots stay empty", "name a rule file for this type, or one for all types without their own");
	}
}

// On a lot without rules nothing stands.
void leave_empty(City &city, LotId id, const CityOptions &options) {
	city.lots[index_of(id)].free_ground = free_ground(city.layout.lot(id), cga::DerivationResult(), options.free_ground);
}

} // namespace

std::optional<City> generate_city(Layout layout, const RulesByType &rules, const CityOptions &options, Diagnostics &diagnostics) {
	City city;
	city.layout = std::move(layout);
	city.model.origin = fingerprint_of(city.layout);
	city.lots.resize(city.layout.lots.size());
	city.ground.streets.resize(city.layout.tiles.size());
	city.ground.blocks.resize(city.layout.blocks.size());
	report_missing_rules(city.layout, rules, diagnostics);
	Derivers derivers(options);
	const LotOccluders occluders = occluders_for_asking(city, rules, options, derivers);
	StreetBuilder streets(city.layout, options);
	const bool is_done = parallel_for(city.lots.size() + streets.part_count(), options.work, [&](size_t i) {
		if (i >= city.lots.size()) {
			streets.build(i - city.lots.size(), city.ground, derivers);
		} else if (const LotRules *lot_rules = rules_of(rules, city.layout.lots[i].type)) {
			build_lot(city, LotId(i), *lot_rules, occluders, options, derivers);
		} else {
			leave_empty(city, LotId(i), options);
		}
	});
	if (!is_done) {
		return std::nullopt;
	}
	LotMessages messages;
	for (size_t i = 0; i < city.lots.size(); ++i) {
		register_lot(city, LotId(i));
		if (rules_of(rules, city.layout.lots[i].type)) {
			collect_messages(city, LotId(i), messages);
		}
	}
	messages.hand_over(diagnostics);
	streets.report(diagnostics);
	register_ground(city, diagnostics);
	return city;
}

bool regenerate_lot(City &city, LotId lot, const RulesByType &rules, const CityOptions &options, Diagnostics &diagnostics) {
	const LotRules *lot_rules = index_of(lot) < city.lots.size() ? rules_of(rules, city.layout.lot(lot).type) : nullptr;
	if (!lot_rules) {
		diagnostics.error("no-rules", "there are no rules for this lot", "name a rule file for its type");
		return false;
	}
	Derivers derivers(options);
	LotOccluders occluders;
	if (derivers.asks_inter(*lot_rules->program)) {
		const size_t asking = index_of(lot);
		occluders = occluders_for(city, { &asking, 1 }, rules, options, derivers);
	}
	build_lot(city, lot, *lot_rules, occluders, options, derivers);
	unregister_lot(city, lot);
	register_lot(city, lot);
	LotMessages messages;
	collect_messages(city, lot, messages);
	messages.hand_over(diagnostics);
	return true;
}

} // namespace pcg
