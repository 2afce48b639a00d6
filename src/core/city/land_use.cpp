#include "core/city/land_use.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/random.h"

namespace pcg {

namespace {

bool check(const std::vector<LandUse> &uses, Diagnostics &diagnostics) {
	double sum = 0.0;
	for (const LandUse &use : uses) {
		if (use.type.empty() || !std::isfinite(use.weight) || use.weight < 0.0) {
			diagnostics.error("bad-land-use", "land use `" + use.type + "` needs a name and a weight that is zero or more",
					"mend the list of types and weights");
			return false;
		}
		sum += use.weight;
	}
	if (!(sum > 0.0) || !std::isfinite(sum)) {
		diagnostics.error("bad-land-use", "there is no type of lot to choose from", "give at least one type a weight above zero");
		return false;
	}
	return true;
}

// How many of `lots` each use gets: its share rounded down, what is left over to the largest remainders.
std::vector<size_t> share_out(const std::vector<LandUse> &uses, size_t lots) {
	double sum = 0.0;
	for (const LandUse &use : uses) {
		sum += use.weight;
	}
	std::vector<size_t> counts(uses.size());
	std::vector<double> remainders(uses.size());
	size_t given = 0;
	for (size_t i = 0; i < uses.size(); ++i) {
		const double share = double(lots) * uses[i].weight / sum;
		counts[i] = std::min(size_t(share), lots - given);
		remainders[i] = share - double(counts[i]);
		given += counts[i];
	}
	std::vector<size_t> order(uses.size());
	std::iota(order.begin(), order.end(), 0);
	std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return remainders[a] > remainders[b]; });
	for (size_t i = 0; given < lots; i = (i + 1) % order.size()) {
		if (uses[order[i]].weight > 0.0) {
			++counts[order[i]];
			++given;
		}
	}
	return counts;
}

// Takes from the richest for those that should be there and are not.
void help_the_missing(const std::vector<LandUse> &uses, std::vector<size_t> &counts, Diagnostics &diagnostics) {
	for (size_t i = 0; i < uses.size(); ++i) {
		if (counts[i] > 0 || uses[i].weight <= 0.0) {
			continue;
		}
		const auto richest = std::max_element(counts.begin(), counts.end());
		if (*richest > 1) {
			--*richest;
			++counts[i];
		} else {
			diagnostics.warning("too-few-lots", "there is no lot left for the type `" + uses[i].type + "`",
					"make the layout larger or the list of types shorter");
		}
	}
}

void assign(const std::vector<size_t> &lots, const std::vector<LandUse> &uses, Random random, std::vector<std::string> &types,
		Diagnostics &diagnostics) {
	std::vector<size_t> counts = share_out(uses, lots.size());
	help_the_missing(uses, counts, diagnostics);
	std::vector<size_t> deck;
	for (size_t i = 0; i < uses.size(); ++i) {
		deck.insert(deck.end(), counts[i], i);
	}
	for (size_t i = deck.size(); i > 1; --i) {
		std::swap(deck[i - 1], deck[random.index(i)]);
	}
	for (size_t i = 0; i < lots.size(); ++i) {
		types[lots[i]] = uses[deck[i]].type;
	}
}

// What each use weighs at a place, 1 in all; all 0 where nothing may stand.
std::vector<double> shares_at(const std::vector<LandUse> &uses, glm::vec2 position, bool is_painted) {
	std::vector<double> shares;
	double sum = 0.0;
	for (const LandUse &use : uses) {
		shares.push_back(use.weight * (is_painted && use.map ? double(use.map->at(position)) : 1.0));
		sum += shares.back();
	}
	for (double &share : shares) {
		share = sum > 0.0 ? share / sum : 0.0;
	}
	return shares;
}

// One of those that lag behind what they should have by now, the more likely the more it weighs here; so numbers are met as well as places.
size_t choose(const std::vector<double> &shares, const std::vector<double> &owed, Random &random) {
	double sum = 0.0;
	size_t likeliest = 0;
	std::vector<double> chances(shares.size());
	for (size_t i = 0; i < shares.size(); ++i) {
		chances[i] = shares[i] * std::max(0.0, owed[i]);
		sum += chances[i];
		likeliest = shares[i] > shares[likeliest] ? i : likeliest;
	}
	double left = random.uniform(0.0, sum);
	for (size_t i = 0; i < shares.size() && sum > 0.0; ++i) {
		left -= chances[i];
		if (chances[i] > 0.0 && left < 0.0) {
			return i;
		}
	}
	return likeliest;
}

// Types that should be there and are not get the place where they weigh most, from a type that has others.
void help_the_missing(const std::vector<LandUse> &uses, const std::vector<std::vector<double>> &shares, std::vector<size_t> &chosen, Diagnostics &diagnostics) {
	std::vector<size_t> counts(uses.size());
	for (const size_t use : chosen) {
		++counts[use];
	}
	for (size_t i = 0; i < uses.size(); ++i) {
		if (counts[i] > 0 || uses[i].weight <= 0.0) {
			continue;
		}
		size_t best = chosen.size();
		for (size_t lot = 0; lot < chosen.size(); ++lot) {
			const bool is_better = best == chosen.size() || shares[lot][i] > shares[best][i];
			best = counts[chosen[lot]] > 1 && shares[lot][i] > 0.0 && is_better ? lot : best;
		}
		if (best < chosen.size()) {
			--counts[chosen[best]];
			++counts[i];
			chosen[best] = i;
		} else {
			diagnostics.warning("too-few-lots", "there is no lot left for the type `" + uses[i].type + "` where its map is not black",
					"make the layout larger, the list of types shorter or the map brighter");
		}
	}
}

void assign_painted(const std::vector<size_t> &lots, std::span<const glm::vec2> positions, const std::vector<LandUse> &uses, Random random,
		std::vector<std::string> &types, Diagnostics &diagnostics) {
	std::vector<size_t> order(lots.size()), chosen(lots.size());
	std::iota(order.begin(), order.end(), 0);
	for (size_t i = order.size(); i > 1; --i) {
		std::swap(order[i - 1], order[random.index(i)]);
	}
	std::vector<std::vector<double>> shares(lots.size());
	std::vector<double> owed(uses.size());
	size_t black = 0;
	for (const size_t i : order) {
		shares[i] = shares_at(uses, positions[lots[i]], true);
		if (std::all_of(shares[i].begin(), shares[i].end(), [](double share) { return share == 0.0; })) {
			++black;
			shares[i] = shares_at(uses, positions[lots[i]], false);
		}
		for (size_t use = 0; use < uses.size(); ++use) {
			owed[use] += shares[i][use];
		}
		chosen[i] = choose(shares[i], owed, random);
		owed[chosen[i]] -= 1.0;
	}
	if (black > 0) {
		diagnostics.warning("black-land-use", "on " + std::to_string(black) + (black == 1 ? " lot" : " lots") + " the maps of all types are black, so weights alone decide there",
				"paint them for at least one type, or leave one type without a map");
	}
	help_the_missing(uses, shares, chosen, diagnostics);
	for (size_t i = 0; i < lots.size(); ++i) {
		types[lots[i]] = uses[chosen[i]].type;
	}
}

bool contains(const District &district, glm::vec2 position) {
	return position.x >= district.min.x && position.x <= district.max.x && position.y >= district.min.y && position.y <= district.max.y;
}

} // namespace

float WeightMap::at(glm::vec2 position) const {
	const auto pixel = [&](float fraction, uint32_t count) { return std::clamp(fraction * float(count) - 0.5f, 0.0f, float(count - 1)); };
	const float x = pixel(position.x, width), y = pixel(position.y, height);
	const uint32_t x0 = uint32_t(x), y0 = uint32_t(y), x1 = std::min(x0 + 1, width - 1), y1 = std::min(y0 + 1, height - 1);
	const auto row = [&](uint32_t at_y) { return std::lerp(values[at_y * width + x0], values[at_y * width + x1], x - float(x0)); };
	return std::lerp(row(y0), row(y1), y - float(y0));
}

std::vector<LandUse> default_land_use() {
	return { { "house", 0.46 }, { "row_house", 0.1 }, { "apartment", 0.1 }, { "workplace", 0.08 }, { "office_tower", 0.02 }, { "workshop", 0.03 },
		{ "shop", 0.05 }, { "supermarket", 0.01 }, { "restaurant", 0.02 }, { "school", 0.03 }, { "town_hall", 0.01 }, { "park", 0.07 },
		{ "plaza", 0.02 } };
}

std::vector<District> quadrant_districts() {
	return { { { 0.0f, 0.0f }, { 0.5f, 0.5f }, { { "house", 0.95 }, { "park", 0.05 } } },
		{ { 0.5f, 0.5f }, { 1.0f, 1.0f }, { { "workplace", 0.95 }, { "park", 0.05 } } },
		{ { 0.5f, 0.0f }, { 1.0f, 0.5f }, { { "shop", 0.9 }, { "park", 0.1 } } },
		{ { 0.0f, 0.5f }, { 0.5f, 1.0f }, { { "school", 0.9 }, { "park", 0.1 } } } };
}

std::vector<std::string> assign_land_use(std::span<const glm::vec2> positions, const std::vector<LandUse> &uses,
		const std::vector<District> &districts, uint64_t seed, Diagnostics &diagnostics) {
	// One group of lots for each district, and last those outside all of them.
	std::vector<std::vector<size_t>> groups(districts.size() + 1);
	for (size_t i = 0; i < positions.size(); ++i) {
		size_t group = 0;
		while (group < districts.size() && !contains(districts[group], positions[i])) {
			++group;
		}
		groups[group].push_back(i);
	}
	std::vector<std::string> types(positions.size());
	for (size_t group = 0; group < groups.size(); ++group) {
		const std::vector<LandUse> &of_group = group < districts.size() ? districts[group].uses : uses;
		if (groups[group].empty()) {
			continue;
		}
		if (!check(of_group, diagnostics)) {
			return {};
		}
		const Random random(derive_seed(seed, hash_text("land use")), group);
		if (std::any_of(of_group.begin(), of_group.end(), [](const LandUse &use) { return use.map != nullptr; })) {
			assign_painted(groups[group], positions, of_group, random, types, diagnostics);
		} else {
			assign(groups[group], of_group, random, types, diagnostics);
		}
	}
	return types;
}

} // namespace pcg
