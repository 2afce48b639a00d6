#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/cga/dialect.h"
#include "core/cga/instances.h"
#include "core/cga/neighborhood.h"
#include "core/io/file_assets.h"
#include "core/io/rule_loader.h"
#include "appearance_expectations.h"
#include "face_measures.h"
#include "report_expectations.h"

// Runs every file of tests/rules/cga against the `// expect` lines at its top. The format is in tests/rules/cga/README.md.
namespace {

using namespace pcg;

struct RuleTest {
	std::string path;
	cga::InitialShape shape = cga::InitialShape::rectangle(10.0, 10.0);
	std::vector<cga::InitialShape> neighbors; // built by the same rules
	cga::DeriveOptions options;
	std::vector<std::string> expectations;
};

struct Outcome {
	cga::DerivationResult model;
	Diagnostics diagnostics; // of loading and deriving
	size_t next_print = 0; // behind the one that was met last
};

std::vector<glm::dvec3> read_points(std::istringstream &line) {
	std::vector<glm::dvec3> points;
	char comma = 0;
	for (glm::dvec3 point; line >> point.x >> comma >> point.y >> comma >> point.z;) {
		points.push_back(point);
	}
	return points;
}

std::vector<glm::dvec2> read_uvs(std::istringstream &line) {
	std::vector<glm::dvec2> uvs;
	char comma = 0;
	for (glm::dvec2 uv; line >> uv.x >> comma >> uv.y;) {
		uvs.push_back(uv);
	}
	return uvs;
}

void read_lot(std::istringstream &line, RuleTest &test) {
	const std::string rest = line.str().substr(size_t(line.tellg()));
	double width = 0.0, depth = 0.0;
	if (std::sscanf(rest.c_str(), " %lfx%lf", &width, &depth) == 2) {
		test.shape.faces = cga::InitialShape::rectangle(width, depth).faces;
	} else {
		test.shape.faces = { { read_points(line), {} } };
	}
}

// "12x8 at 15,0,0": where its front left corner lies.
void read_neighbor(const std::string &text, RuleTest &test) {
	double width = 0.0, depth = 0.0;
	glm::dvec3 at(0.0);
	REQUIRE_MESSAGE(std::sscanf(text.c_str(), "neighbor %lfx%lf at %lf,%lf,%lf", &width, &depth, &at.x, &at.y, &at.z) == 5, test.path << ": " << text);
	test.neighbors.push_back(cga::InitialShape::rectangle(width, depth));
	for (glm::dvec3 &point : test.neighbors.back().faces[0].outline) {
		point += at;
	}
}

void read_attribute(std::istringstream &line, RuleTest &test) {
	std::string name, value;
	line >> name >> value;
	char *end = nullptr;
	const double number = std::strtod(value.c_str(), &end);
	if (*end == '\0') {
		test.shape.attributes.push_back({ name, number });
	} else if (value == "true" || value == "false") {
		test.shape.attributes.push_back({ name, value == "true" });
	} else {
		test.shape.attributes.push_back({ name, value });
	}
}

void read_limit(std::istringstream &line, RuleTest &test) {
	std::string name;
	uint32_t value = 0;
	line >> name >> value;
	cga::DeriveLimits &limits = test.options.limits;
	if (name == "shapes") {
		limits.max_shapes = value;
	} else if (name == "repeats") {
		limits.max_repeats = value;
	} else if (name == "depth") {
		limits.max_depth = value;
	} else {
		FAIL_CHECK(test.path << ": unknown limit " << name);
	}
}

void read_directive(const std::string &text, RuleTest &test) {
	std::istringstream line(text);
	std::string word;
	line >> word;
	if (word == "expect") {
		test.expectations.push_back(text.substr(text.find("expect") + 7));
	} else if (word == "lot") {
		read_lot(line, test);
	} else if (word == "neighbor") {
		read_neighbor(text, test);
	} else if (word == "hole") {
		test.shape.faces[0].holes.push_back(read_points(line));
	} else if (word == "uvs") {
		test.shape.faces[0].uvs = read_uvs(line);
	} else if (word == "streets") {
		for (float width = 0.0f; line >> width;) {
			test.shape.street_widths.push_back(width);
		}
	} else if (word == "seed") {
		line >> test.shape.seed;
	} else if (word == "start") {
		line >> test.shape.start_rule;
	} else if (word == "attr") {
		read_attribute(line, test);
	} else if (word == "assets") {
		static const FileAssets assets;
		test.options.assets = &assets;
	} else if (word == "limit") {
		read_limit(line, test);
	}
}

RuleTest read_test(const std::filesystem::path &path) {
	RuleTest test;
	test.path = path.string();
	std::ifstream file(path);
	for (std::string line; std::getline(file, line);) {
		if (line.starts_with("// ")) {
			read_directive(line.substr(3), test);
		}
	}
	return test;
}

glm::dvec3 read_vector(std::istringstream &line) {
	glm::dvec3 vector(0.0);
	line >> vector.x >> vector.y >> vector.z;
	return vector;
}

// "at 1 2 3 facing 0 0 1 area 4": each thing of the list must fit all keys of the line.
struct Keys {
	std::vector<std::pair<std::string, glm::dvec3>> values;

	explicit Keys(std::istringstream &line) {
		for (std::string key; line >> key;) {
			const bool is_vector = key == "at" || key == "facing" || key == "ambient" || key == "specular" || key == "emissive";
			const auto read_uv = [&] {
				const double u = read_number(line);
				return glm::dvec3(u, read_number(line), 0.0);
			};
			values.emplace_back(key, is_vector ? read_vector(line) : key.starts_with("uv") ? read_uv() : glm::dvec3(read_number(line)));
		}
	}
	template <typename Get> bool fits(Get get) const {
		return std::ranges::all_of(values, [&](const auto &pair) { return is_near(get(pair.first), pair.second); });
	}
};

bool has_face(const cga::DerivationResult &model, std::istringstream &line) {
	const Keys keys(line);
	return std::ranges::any_of(model.mesh.faces, [&](const MeshFace &face) {
		return keys.fits([&](const std::string &key) {
			return key == "at" ? middle(model.mesh, face)
					: key == "facing" ? glm::dvec3(face.normal)
					: key == "area" ? glm::dvec3(face_area(model.mesh, face))
					: key == "corners" ? glm::dvec3(double(model.mesh.loop(face.first_loop).size()))
					: key == "loops" ? glm::dvec3(face.loop_count)
					: key.starts_with("uv") ? corner_uv(model.mesh, face, key)
											: material_value(model.materials[face.material], key);
		});
	});
}

bool has_entrance(const cga::DerivationResult &model, std::istringstream &line) {
	std::string type;
	line >> type;
	const Keys keys(line);
	return std::ranges::any_of(model.entrances, [&](const cga::ModelEntrance &entrance) {
		return entrance.type == type && keys.fits([&](const std::string &key) {
			return key == "at" ? glm::dvec3(entrance.position) : key == "facing" ? glm::dvec3(entrance.facing)
					: key == "capacity"											  ? glm::dvec3(entrance.capacity)
																				  : glm::dvec3(NAN);
		});
	});
}

bool has_zone(const cga::DerivationResult &model, std::istringstream &line) {
	std::string type;
	line >> type;
	const Keys keys(line);
	return std::ranges::any_of(model.zones, [&](const cga::ModelZone &zone) {
		return zone.type == type && keys.fits([&](const std::string &key) {
			return key == "height" ? glm::dvec3(zone.height) : key == "area" ? glm::dvec3(polygon_area(zone.polygon))
					: key == "corners"										  ? glm::dvec3(double(zone.polygon.size()))
					: key == "bottom"										  ? glm::dvec3(zone.polygon[0].y)
																			  : glm::dvec3(NAN);
		});
	});
}

bool has_object(const cga::DerivationResult &model, std::istringstream &line) {
	std::string tag;
	line >> tag;
	const Keys keys(line);
	return std::ranges::any_of(model.objects, [&](const cga::ModelObject &object) {
		return object.tag == tag && keys.fits([&](const std::string &key) {
			return key == "at" ? glm::dvec3(object.frame[3]) : key == "faces" ? glm::dvec3(double(object.mesh.faces.size()))
					: key == "places"										  ? glm::dvec3(double(object.places.size()))
					: key == "parent"										  ? glm::dvec3(object.parent)
																			  : glm::dvec3(NAN);
		});
	});
}

bool has_place(const cga::DerivationResult &model, std::istringstream &line) {
	const Keys keys(line);
	return std::ranges::any_of(model.objects, [&](const cga::ModelObject &object) {
		return std::ranges::any_of(object.places, [&](const cga::ModelPlace &place) {
			return keys.fits([&](const std::string &key) { return glm::dvec3(key == "at" ? place.position : place.facing); });
		});
	});
}

bool has_bounds(const cga::DerivationResult &model, std::istringstream &line) {
	glm::dvec3 low(INFINITY), high(-INFINITY);
	for (const glm::vec3 &point : model.mesh.positions) {
		low = glm::min(low, glm::dvec3(point));
		high = glm::max(high, glm::dvec3(point));
	}
	const glm::dvec3 wanted_low = read_vector(line);
	return is_near(low, wanted_low) && is_near(high, read_vector(line));
}

bool has_diagnostic(const Outcome &outcome, Severity severity, std::istringstream &line) {
	std::string id;
	line >> id;
	return std::ranges::any_of(outcome.diagnostics.list(), [&](const Diagnostic &d) { return d.severity == severity && d.id == id; });
}

// In the order of the lines that expect them.
bool has_print(Outcome &outcome, std::string_view text) {
	const auto &prints = outcome.model.prints;
	const auto found = std::find(prints.begin() + ptrdiff_t(outcome.next_print), prints.end(), text);
	if (found == prints.end()) {
		return false;
	}
	outcome.next_print = size_t(found - prints.begin()) + 1;
	return true;
}

double quantity(const cga::DerivationResult &model, const std::string &what) {
	return what == "faces" ? double(model.mesh.faces.size())
			: what == "area" ? area(model.mesh)
			: what == "leaves" ? double(model.leaf_count)
			: what == "materials" ? double(model.materials.size())
			: what == "entrances" ? double(model.entrances.size())
			: what == "zones" ? double(model.zones.size())
			: what == "objects" ? double(model.objects.size())
								: NAN;
}

bool is_met(Outcome &outcome, const std::string &expectation) {
	const cga::DerivationResult &model = outcome.model;
	std::istringstream line(expectation);
	std::string what;
	line >> what;
	if (what == "face") {
		return has_face(model, line);
	}
	if (what == "entrance") {
		return has_entrance(model, line);
	}
	if (what == "zone") {
		return has_zone(model, line);
	}
	if (what == "object") {
		return has_object(model, line);
	}
	if (what == "place") {
		return has_place(model, line);
	}
	if (what == "report") {
		return has_report(model, line);
	}
	if (what == "texture") {
		return has_texture(model, line);
	}
	if (what == "bounds") {
		return has_bounds(model, line);
	}
	if (what == "warning" || what == "error") {
		return has_diagnostic(outcome, what == "error" ? Severity::Error : Severity::Warning, line);
	}
	if (what == "print") {
		return has_print(outcome, std::string_view(expectation).substr(6));
	}
	return is_near(read_number(line), quantity(model, what));
}

Outcome run(const RuleTest &test) {
	Outcome outcome;
	const auto program = load_program(test.path, cga::cga_dialect(), outcome.diagnostics);
	if (program != nullptr) {
		std::vector<cga::InitialShape> shapes = test.neighbors;
		shapes.push_back(test.shape);
		outcome.model = cga::written_out(std::move(cga::derive_all(*program, shapes, test.options, { 1, {}, nullptr }).back()));
		outcome.diagnostics.append(outcome.model.diagnostics);
	}
	return outcome;
}

void check(const RuleTest &test) {
	Outcome outcome = run(test);
	bool expects_trouble = false;
	for (const std::string &expectation : test.expectations) {
		INFO(test.path << ": expect " << expectation << "\n" << to_text(outcome.diagnostics));
		CHECK(is_met(outcome, expectation));
		expects_trouble |= expectation.starts_with("warning") || expectation.starts_with("error");
	}
	INFO(test.path << "\n" << to_text(outcome.diagnostics));
	CHECK((expects_trouble || outcome.diagnostics.is_empty()));
	CHECK(!test.expectations.empty());
}

} // namespace

TEST_CASE("every rule file of tests/rules/cga makes what it says it makes") {
	std::vector<std::filesystem::path> paths;
	std::error_code error;
	for (const auto &entry : std::filesystem::directory_iterator("tests/rules/cga", error)) {
		if (entry.path().extension() == ".cga") {
			paths.push_back(entry.path());
		}
	}
	REQUIRE_MESSAGE(!paths.empty(), "run the tests from the top of the repository");
	std::ranges::sort(paths);
	for (const auto &path : paths) {
		check(read_test(path));
	}
}
