#include "core/city/lot_division.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>

#include "core/geometry/polygon.h"

namespace pcg {

namespace {

// Of the wanted measures: what a lot must have at least.
constexpr double least_share = 0.45;
constexpr double least_area_share = 0.4;
// Inner corners sharper than this are cut off; flatter ones hardly show.
const double flat_turn = std::sin(20.0 * std::numbers::pi / 180.0);
constexpr double snap_share = 0.05; // of a lot's shorter side, 0.5 m at most: a cut this near to a corner goes through it

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }
glm::dvec2 left_of(glm::dvec2 direction) { return { -direction.y, direction.x }; }

struct Edge {
	glm::dvec2 from, to;
	glm::dvec2 direction() const { return (to - from) / std::max(length(), 1e-12); }
	double length() const { return glm::distance(from, to); }
};

Edge edge_of(const Parcel &parcel, size_t i) { return { parcel.outline[i], parcel.outline[(i + 1) % parcel.outline.size()] }; }

// The longest edge on a street; the number of edges if there is none.
size_t front_of(const Parcel &parcel) {
	size_t front = parcel.outline.size();
	for (size_t i = 0; i < parcel.outline.size(); ++i) {
		if (parcel.street_widths[i] > 0.0f && (front == parcel.outline.size() || edge_of(parcel, i).length() > edge_of(parcel, front).length())) {
			front = i;
		}
	}
	return front;
}

// A box along the front: u along it, v into the land.
struct FrontBox {
	glm::dvec2 origin{ 0.0 }, u{ 1.0, 0.0 }, v{ 0.0, 1.0 };
	double width = 0.0, depth = 0.0;
};

FrontBox box_of(const Parcel &parcel, size_t front) {
	FrontBox box;
	const Edge edge = edge_of(parcel, front);
	box.u = edge.direction();
	box.v = left_of(box.u);
	glm::dvec2 low(INFINITY), high(-INFINITY);
	for (const glm::dvec2 &corner : parcel.outline) {
		const glm::dvec2 place{ glm::dot(corner - edge.from, box.u), glm::dot(corner - edge.from, box.v) };
		low = { std::min(low.x, place.x), std::min(low.y, place.y) };
		high = { std::max(high.x, place.x), std::max(high.y, place.y) };
	}
	box.origin = edge.from + box.u * low.x + box.v * low.y;
	box.width = high.x - low.x;
	box.depth = high.y - low.y;
	return box;
}

bool is_lot(const Parcel &parcel, const LotSize &size) {
	const size_t front = front_of(parcel);
	if (front == parcel.outline.size() || edge_of(parcel, front).length() < least_share * size.front) {
		return false;
	}
	const FrontBox box = box_of(parcel, front);
	return box.width >= least_share * size.front && box.depth >= least_share * size.depth &&
			signed_area(parcel.outline) / 2.0 >= least_area_share * size.front * size.depth;
}

// How much street there is along `u` for each metre of the land's width; what counts for rows of lots.
double row_share(const Parcel &parcel, glm::dvec2 u) {
	double low = INFINITY, high = -INFINITY, street = 0.0;
	for (size_t i = 0; i < parcel.outline.size(); ++i) {
		low = std::min(low, glm::dot(parcel.outline[i], u));
		high = std::max(high, glm::dot(parcel.outline[i], u));
		const double along = std::abs(glm::dot(edge_of(parcel, i).direction(), u));
		street += parcel.street_widths[i] > 0.0f && along > 0.7 ? edge_of(parcel, i).length() * along : 0.0;
	}
	return street / std::max(high - low, 1e-12);
}

// A place on the outline: on edge `edge`, `t` of the way along it.
struct Place {
	size_t edge;
	double t;
};

glm::dvec2 point_at(const Parcel &parcel, Place place) {
	const Edge edge = edge_of(parcel, place.edge);
	return edge.from + (edge.to - edge.from) * place.t;
}

Parcel part_between(const Parcel &whole, Place from, Place to) {
	Parcel part;
	const size_t count = whole.outline.size();
	if (from.t < 1.0) {
		part.outline.push_back(point_at(whole, from));
		part.street_widths.push_back(whole.street_widths[from.edge]);
	}
	for (size_t i = (from.edge + 1) % count;; i = (i + 1) % count) {
		if (i == to.edge && to.t <= 0.0) {
			part.outline.push_back(whole.outline[i]);
			part.street_widths.push_back(0.0f);
			return part;
		}
		part.outline.push_back(whole.outline[i]);
		part.street_widths.push_back(whole.street_widths[i]);
		if (i == to.edge) {
			part.outline.push_back(point_at(whole, to));
			part.street_widths.push_back(0.0f);
			return part;
		}
	}
}

Place snapped(const Parcel &parcel, Place place, double snap) {
	const double length = edge_of(parcel, place.edge).length();
	if (place.t * length < snap) {
		return { place.edge, 0.0 };
	}
	if ((1.0 - place.t) * length < snap) {
		return { (place.edge + 1) % parcel.outline.size(), 0.0 };
	}
	return place;
}

// A cut that passes a corner as near as this would leave a needle there, which shuts the lot beside it off from its street.
bool is_clear(const Parcel &whole, Place a, Place b, double distance) {
	const glm::dvec2 from = point_at(whole, a), along = point_at(whole, b) - from;
	for (size_t i = 0; i < whole.outline.size(); ++i) {
		const bool is_end = (i == a.edge && a.t <= 0.0) || (i == b.edge && b.t <= 0.0);
		const glm::dvec2 to = whole.outline[i] - from;
		const double t = std::clamp(glm::dot(to, along) / std::max(glm::dot(along, along), 1e-12), 0.0, 1.0);
		if (!is_end && glm::distance(to, along * t) < distance) {
			return false;
		}
	}
	return true;
}

using Halves = std::pair<Parcel, Parcel>;

// Nothing where the two places lie on one edge, or the cut between them would nearly touch a corner.
std::optional<Halves> split_between(const Parcel &whole, Place a, Place b, double snap) {
	a = snapped(whole, a, snap);
	b = snapped(whole, b, snap);
	Halves halves{ part_between(whole, a, b), part_between(whole, b, a) };
	if (a.edge == b.edge || halves.first.outline.size() < 3 || halves.second.outline.size() < 3 || !is_clear(whole, a, b, snap / 2.0)) {
		return std::nullopt;
	}
	return halves;
}

// Where the line crosses the outline, in the line's direction.
std::vector<std::pair<double, Place>> crossings(const Parcel &parcel, glm::dvec2 origin, glm::dvec2 direction) {
	std::vector<std::pair<double, Place>> found;
	for (size_t i = 0; i < parcel.outline.size(); ++i) {
		const Edge edge = edge_of(parcel, i);
		const double from = cross(direction, edge.from - origin), to = cross(direction, edge.to - origin);
		if ((from >= 0.0) != (to >= 0.0)) {
			const double t = from / (from - to);
			found.push_back({ glm::dot(edge.from + (edge.to - edge.from) * t - origin, direction), { i, t } });
		}
	}
	std::sort(found.begin(), found.end(), [](const auto &a, const auto &b) { return a.first < b.first; });
	return found;
}

std::optional<Halves> split_along(const Parcel &whole, glm::dvec2 origin, glm::dvec2 direction, double snap) {
	const auto found = crossings(whole, origin, direction);
	return found.size() < 2 ? std::nullopt : split_between(whole, found[0].second, found[1].second, snap);
}

// From a corner inwards to the first edge in the way.
std::optional<Halves> split_from(const Parcel &whole, size_t corner, glm::dvec2 direction, double snap) {
	for (const auto &[metres, place] : crossings(whole, whole.outline[corner], direction)) {
		const bool is_own = place.edge == corner || (place.edge + 1) % whole.outline.size() == corner;
		if (metres > snap && !is_own) {
			return split_between(whole, { corner, 0.0 }, place, snap);
		}
	}
	return std::nullopt;
}

class Divider {
public:
	Divider(const LotSize &size, Random random) :
			_size(size), _random(random), _snap(std::min(0.5, snap_share * std::min(size.front, size.depth))) {}

	std::vector<Parcel> divide(const Parcel &land) {
		std::vector<Parcel> waiting{ land }, lots;
		while (!waiting.empty()) {
			Parcel part = std::move(waiting.back());
			waiting.pop_back();
			if (std::optional<Halves> halves = split(part)) {
				waiting.push_back(std::move(halves->second));
				waiting.push_back(std::move(halves->first));
			} else {
				lots.push_back(std::move(part));
			}
		}
		return lots;
	}

private:
	bool are_lots(const std::optional<Halves> &halves) const { return halves && is_lot(halves->first, _size) && is_lot(halves->second, _size); }

	std::optional<Halves> split(const Parcel &part) {
		const FrontBox box = box_of(part, front_of(part));
		const double across = box.width / _size.front, deep = box.depth / _size.depth;
		if (std::optional<Halves> halves = cut_inner_corner(part)) {
			return halves;
		}
		if (std::optional<Halves> halves = deep >= 1.5 ? split_rows(part, box) : std::nullopt) {
			return halves;
		}
		if (std::optional<Halves> halves = across >= 1.5 ? split_row(part, box) : std::nullopt) {
			return halves;
		}
		return deep >= 1.8 ? split_deep(part, box) : std::nullopt;
	}

	double moved(double share, double parts) { return share + _size.jitter * _random.uniform(-1.0, 1.0) / parts; }

	// Back to back, each row with its own street.
	std::optional<Halves> split_rows(const Parcel &part, const FrontBox &box) {
		const double v = box.depth * moved(0.5, box.depth / _size.depth);
		std::optional<Halves> halves = split_along(part, box.origin + box.v * v, box.u, _snap);
		const bool is_good = are_lots(halves) && row_share(halves->first, box.u) >= 0.5 && row_share(halves->second, box.u) >= 0.5;
		return is_good ? halves : std::nullopt;
	}

	// Side by side. Where the middle leaves one half without a street, farther out.
	std::optional<Halves> split_row(const Parcel &part, const FrontBox &box) {
		const int count = std::max(2, int(std::round(box.width / _size.front)));
		for (int step = 0; step < count; ++step) {
			const int index = count / 2 + (step % 2 == 0 ? step / 2 : -(step + 1) / 2);
			const double u = box.width * moved(double(index) / count, count);
			std::optional<Halves> halves = split_along(part, box.origin + box.u * u, box.v, _snap);
			if (are_lots(halves)) {
				return halves;
			}
		}
		return std::nullopt;
	}

	// A deep part with streets at its sides only.
	std::optional<Halves> split_deep(const Parcel &part, const FrontBox &box) {
		std::optional<Halves> halves = split_along(part, box.origin + box.v * (box.depth * moved(0.5, box.depth / _size.depth)), box.u, _snap);
		return are_lots(halves) ? halves : std::nullopt;
	}

	// Towards convex parts: on with one of the corner's edges, whichever way is shorter.
	std::optional<Halves> cut_inner_corner(const Parcel &part) {
		const size_t count = part.outline.size();
		for (size_t i = 0; i < count; ++i) {
			const glm::dvec2 in = edge_of(part, (i + count - 1) % count).direction(), out = edge_of(part, i).direction();
			if (cross(in, out) > -flat_turn) {
				continue;
			}
			for (const glm::dvec2 direction : { in, -out, glm::normalize(in - out) }) {
				std::optional<Halves> halves = split_from(part, i, direction, _snap);
				if (are_lots(halves)) {
					return halves;
				}
			}
		}
		return std::nullopt;
	}

	LotSize _size;
	Random _random;
	double _snap; // metres
};

void begin_with_front(Parcel &parcel) {
	const size_t front = front_of(parcel);
	std::rotate(parcel.outline.begin(), parcel.outline.begin() + ptrdiff_t(front), parcel.outline.end());
	std::rotate(parcel.street_widths.begin(), parcel.street_widths.begin() + ptrdiff_t(front), parcel.street_widths.end());
}

} // namespace

std::vector<Parcel> divide_land(const Parcel &land, const LotSize &size, Random random) {
	if (!is_lot(land, size)) {
		return {};
	}
	std::vector<Parcel> lots = Divider(size, random).divide(land);
	for (Parcel &lot : lots) {
		begin_with_front(lot);
	}
	return lots;
}

std::vector<Parcel> divide_rows(const Parcel &land, uint32_t along, uint32_t deep) {
	const auto corner = [&](uint32_t column, uint32_t row) {
		const double s = double(column) / along, t = double(row) / deep;
		return glm::mix(glm::mix(land.outline[0], land.outline[1], s), glm::mix(land.outline[3], land.outline[2], s), t);
	};
	std::vector<Parcel> lots;
	for (uint32_t row = 0; row < deep; ++row) {
		for (uint32_t column = 0; column < along; ++column) {
			const auto street = [&](size_t edge, bool is_outer) { return is_outer ? land.street_widths[edge] : 0.0f; };
			Parcel lot{ { corner(column, row), corner(column + 1, row), corner(column + 1, row + 1), corner(column, row + 1) },
				{ street(0, row == 0), street(1, column + 1 == along), street(2, row + 1 == deep), street(3, column == 0) } };
			if (row > 0) { // looks to the other side
				std::rotate(lot.outline.begin(), lot.outline.begin() + 2, lot.outline.end());
				std::rotate(lot.street_widths.begin(), lot.street_widths.begin() + 2, lot.street_widths.end());
			}
			lots.push_back(std::move(lot));
		}
	}
	return lots;
}

} // namespace pcg
