#include "core/io/geojson.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "core/geometry/box2.h"
#include "core/io/json_reader.h"

namespace pcg {

namespace {

constexpr double level_height = 3.0; // metres
constexpr double largest_coordinate = 1e7;

class GeoJsonReader {
public:
	std::vector<Footprint> footprints;

	void read(const JsonValue &root) {
		const std::optional<std::string> type = type_of(root);
		if (type == "Feature") {
			read_feature(root, 0);
		} else if (type == "FeatureCollection") {
			const std::optional<JsonValue> member = root.required("features");
			const auto features = member ? member->elements() : std::nullopt;
			for (size_t i = 0; features && i < features->size(); ++i) {
				read_feature((*features)[i], i);
			}
		} else if (type) {
			root.error("expected a FeatureCollection or a Feature, not a `" + *type + "`");
		}
		tell_left_out(root);
	}

private:
	static std::optional<std::string> type_of(const JsonValue &value) {
		const std::optional<JsonValue> member = value.is_object() ? value.required("type") : std::nullopt;
		return member ? member->text() : std::nullopt;
	}

	void read_feature(const JsonValue &feature, size_t number) {
		const std::optional<JsonValue> geometry = feature.is_object() ? feature.required("geometry") : std::nullopt;
		const bool is_nowhere = geometry && geometry->is_null(); // which the format allows
		const std::optional<std::string> type = geometry && !is_nowhere ? type_of(*geometry) : std::nullopt;
		if (type != "Polygon" && type != "MultiPolygon") {
			_other_geometries += type || is_nowhere ? 1 : 0;
			return;
		}
		Footprint footprint;
		footprint.name = "feature " + std::to_string(number);
		if (const std::optional<JsonValue> properties = feature.member("properties"); properties && !properties->is_null()) {
			read_properties(*properties, footprint);
		}
		const std::optional<JsonValue> coordinates = geometry->required("coordinates");
		if (coordinates && type == "Polygon") {
			read_polygon(*coordinates, footprint);
		} else if (const auto polygons = coordinates ? coordinates->elements() : std::nullopt) {
			for (const JsonValue &polygon : *polygons) {
				read_polygon(polygon, footprint);
			}
		}
	}

	static void read_properties(const JsonValue &properties, Footprint &footprint) {
		if (!properties.is_object()) {
			return;
		}
		const std::optional<JsonValue> height = properties.member("height"), levels = properties.member("building:levels");
		if (height && !height->is_null()) {
			footprint.height = float(read_number(*height));
		} else if (levels && !levels->is_null()) {
			footprint.height = float(level_height * read_number(*levels));
		}
		for (const char *key : { "use", "building" }) {
			const std::optional<JsonValue> use = properties.member(key);
			const std::optional<std::string> text = use && use->is_text() ? use->text() : std::nullopt;
			if (text && *text != "yes") {
				footprint.type = *text;
				return;
			}
		}
	}

	// What maps say of heights is often unclear: that is no reason to refuse a city.
	static double read_number(const JsonValue &value) {
		double number = -1.0;
		if (value.is_number()) {
			number = value.number(-INFINITY, INFINITY).value_or(-1.0);
		} else if (const std::optional<std::string> text = value.is_text() ? value.text() : std::nullopt) {
			std::from_chars(text->data(), text->data() + text->size(), number);
		}
		if (!(number >= 0.0 && number <= double(tallest_footprint))) {
			value.warning("bad-height", "this is no height from 0 to 2000 and is ignored", "write metres as a number");
			return 0.0;
		}
		return number;
	}

	void read_polygon(const JsonValue &polygon, Footprint footprint) {
		const auto rings = polygon.elements();
		if (rings && rings->empty()) {
			polygon.error("expected at least one ring of points");
		}
		if (!rings || rings->empty()) {
			return;
		}
		for (size_t i = 0; i < rings->size(); ++i) {
			std::optional<Loop2> loop = read_ring((*rings)[i]);
			if (!loop) {
				return;
			}
			if (i == 0) {
				footprint.outline = std::move(*loop);
			} else {
				footprint.holes.push_back(std::move(*loop));
			}
		}
		footprints.push_back(std::move(footprint));
	}

	// Counter-clockwise, holes, too: older files run either way.
	static std::optional<Loop2> read_ring(const JsonValue &ring) {
		const auto points = ring.elements();
		Loop2 loop;
		for (size_t i = 0; points && i < points->size(); ++i) {
			const std::optional<glm::dvec2> point = read_point((*points)[i]);
			if (!point) {
				return std::nullopt;
			}
			loop.push_back(*point);
		}
		if (points && (loop.size() < 4 || loop.front() != loop.back())) {
			ring.error("expected four points or more, of which the last is the first again", "close the ring");
		}
		if (!points || loop.size() < 4 || loop.front() != loop.back()) {
			return std::nullopt;
		}
		loop.pop_back();
		if (signed_area(loop) < 0.0) {
			std::reverse(loop.begin(), loop.end());
		}
		return loop;
	}

	static std::optional<glm::dvec2> read_point(const JsonValue &value) {
		const auto numbers = value.elements();
		if (!numbers) {
			return std::nullopt;
		}
		if (numbers->size() < 2) {
			value.error("expected two numbers or more: [x, y]");
			return std::nullopt;
		}
		const std::optional<double> x = (*numbers)[0].number(-largest_coordinate, largest_coordinate);
		const std::optional<double> y = x ? (*numbers)[1].number(-largest_coordinate, largest_coordinate) : std::nullopt;
		return y ? std::optional<glm::dvec2>({ *x, *y }) : std::nullopt;
	}

	void tell_left_out(const JsonValue &root) const {
		if (_other_geometries > 0) {
			root.warning("left-out", std::to_string(_other_geometries) + " features are neither Polygon nor MultiPolygon and are left out");
		}
	}

	size_t _other_geometries = 0;
};

// No building and no block is as wide as a degree; in metres the widest is wider than one.
bool is_guessed_in_degrees(const std::vector<Footprint> &footprints) {
	return std::all_of(footprints.begin(), footprints.end(), [](const Footprint &footprint) {
		const Box2 box = box_of(footprint.outline);
		return std::max(box.max.x - box.min.x, box.max.y - box.min.y) < 1.0;
	});
}

bool are_degrees(const std::vector<Footprint> &footprints) {
	for (const Footprint &footprint : footprints) {
		for (const glm::dvec2 &point : footprint.outline) {
			if (std::abs(point.x) > 180.0 || std::abs(point.y) > 90.0) {
				return false;
			}
		}
	}
	return true;
}

// So that the middle of the map is the origin. Degrees become metres by the ellipsoid's two radii of curvature there (WGS 84): over 10 km
// that is true to a few metres, over a district to centimetres.
void place(std::vector<Footprint> &footprints, bool is_in_degrees) {
	glm::dvec2 low(INFINITY), high(-INFINITY);
	for (const Footprint &footprint : footprints) {
		for (const glm::dvec2 &point : footprint.outline) {
			low = { std::min(low.x, point.x), std::min(low.y, point.y) };
			high = { std::max(high.x, point.x), std::max(high.y, point.y) };
		}
	}
	const glm::dvec2 middle = (low + high) / 2.0;
	glm::dvec2 scale(1.0);
	if (is_in_degrees) {
		constexpr double equator = 6378137.0, eccentricity_squared = 0.00669437999014, radians = std::numbers::pi / 180.0;
		const double sine = std::sin(middle.y * radians), w = 1.0 - eccentricity_squared * sine * sine;
		const double along_meridian = equator * (1.0 - eccentricity_squared) / (w * std::sqrt(w));
		scale = { radians * equator / std::sqrt(w) * std::cos(middle.y * radians), radians * along_meridian };
	}
	for (Footprint &footprint : footprints) {
		const auto place_loop = [&](Loop2 &loop) {
			for (glm::dvec2 &point : loop) {
				point = (point - middle) * scale;
			}
		};
		place_loop(footprint.outline);
		std::for_each(footprint.holes.begin(), footprint.holes.end(), place_loop);
	}
}

} // namespace

std::optional<std::vector<Footprint>> parse_geojson(std::string_view text, const std::string &file, Diagnostics &diagnostics, MapUnits units) {
	const size_t errors_before = diagnostics.error_count();
	const std::optional<nlohmann::json> document = parse_json(text, file, diagnostics);
	if (!document) {
		return std::nullopt;
	}
	const JsonValue root(*document, "", file, text, diagnostics);
	GeoJsonReader reader;
	reader.read(root);
	if (diagnostics.error_count() == errors_before && reader.footprints.empty()) {
		root.error("there is no Polygon in it");
	}
	const bool is_in_degrees = units == MapUnits::Degrees || (units == MapUnits::Guess && are_degrees(reader.footprints) && is_guessed_in_degrees(reader.footprints));
	if (diagnostics.error_count() == errors_before && is_in_degrees && !are_degrees(reader.footprints)) {
		root.error("a coordinate is no longitude from -180 to 180 and latitude from -90 to 90", "is the map in metres?");
	}
	if (diagnostics.error_count() != errors_before) {
		return std::nullopt;
	}
	place(reader.footprints, is_in_degrees);
	return std::move(reader.footprints);
}

} // namespace pcg
