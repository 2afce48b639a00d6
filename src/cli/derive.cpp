#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>

#include <glm/common.hpp>
#include <nlohmann/json.hpp>

#include "cli/args.h"
#include "core/cga/derivation.h"
#include "core/cga/dialect.h"
#include "core/io/atomic_file.h"
#include "core/io/file_assets.h"
#include "core/io/gltf.h"
#include "core/io/obj.h"
#include "core/io/rule_loader.h"

namespace pcg::cli {

extern const Command derive_command;

namespace {

using nlohmann::json;

json to_json(glm::vec3 vector) {
	return { vector.x, vector.y, vector.z };
}

json entrances_json(const cga::DerivationResult &model) {
	json list = json::array();
	for (const cga::ModelEntrance &entrance : model.entrances) {
		list.push_back({ { "type", entrance.type }, { "position", to_json(entrance.position) }, { "facing", to_json(entrance.facing) }, { "capacity", entrance.capacity } });
	}
	return list;
}

json zones_json(const cga::DerivationResult &model) {
	json list = json::array();
	for (const cga::ModelZone &zone : model.zones) {
		json polygon = json::array();
		for (const glm::vec3 &point : zone.polygon) {
			polygon.push_back(to_json(point));
		}
		list.push_back({ { "type", zone.type }, { "height", zone.height }, { "polygon", polygon } });
	}
	return list;
}

json objects_json(const cga::DerivationResult &model) {
	json list = json::array();
	for (const cga::ModelObject &object : model.objects) {
		json places = json::array();
		for (const cga::ModelPlace &place : object.places) {
			places.push_back({ { "position", to_json(place.position) }, { "facing", to_json(place.facing) } });
		}
		list.push_back({ { "type", object.tag }, { "position", to_json(glm::vec3(object.frame[3])) }, { "faces", object.mesh.faces.size() },
				{ "parent", object.parent }, { "places", places } });
	}
	return list;
}

json reports_json(const cga::DerivationResult &model) {
	json map = json::object();
	for (const cga::ModelReport &report : model.reports) {
		map[report.key] = { { "n", report.count }, { "sum", report.sum }, { "min", report.min }, { "max", report.max },
			{ "avg", report.sum / double(std::max<uint64_t>(report.count, 1)) } };
	}
	return map;
}

json diagnostics_json(const Diagnostics &diagnostics) {
	json list = json::array();
	for (const Diagnostic &d : diagnostics.list()) {
		list.push_back({ { "severity", d.severity == Severity::Error ? "error" : "warning" }, { "id", d.id }, { "file", d.file }, { "line", d.line },
				{ "column", d.column }, { "message", d.message }, { "hint", d.hint } });
	}
	return list;
}

json materials_json(const cga::DerivationResult &model) {
	json list = json::array();
	for (const Material &material : model.materials) {
		list.push_back({ { "color", { material.color.r, material.color.g, material.color.b, material.color.a } }, { "roughness", material.roughness },
				{ "metallic", material.metallic } });
	}
	return list;
}

json bounds_json(const Mesh &mesh) {
	if (mesh.positions.empty()) {
		return nullptr;
	}
	glm::vec3 low = mesh.positions[0], high = low;
	for (const glm::vec3 &point : mesh.positions) {
		low = glm::min(low, point);
		high = glm::max(high, point);
	}
	return { to_json(low), to_json(high) };
}

// Faces, vertices, area and bounds are those of the lot's own mesh; the objects' faces are in their list.
json report_json(const cga::DerivationResult &model, const Diagnostics &diagnostics, double seconds) {
	return { { "faces", model.mesh.faces.size() }, { "vertices", model.mesh.positions.size() }, { "area", area(model.mesh) }, { "bbox", bounds_json(model.mesh) },
		{ "shapes", model.shape_count }, { "leaves", model.leaf_count }, { "materials", materials_json(model) }, { "reports", reports_json(model) },
		{ "prints", model.prints }, { "entrances", entrances_json(model) }, { "zones", zones_json(model) }, { "objects", objects_json(model) },
		{ "diagnostics", diagnostics_json(diagnostics) }, { "seconds", seconds } };
}

void print_summary(const cga::DerivationResult &model, double seconds) {
	std::printf("%zu faces, %.1f m2, %zu materials, %llu shapes, %.2f ms\n", model.mesh.faces.size(), area(model.mesh), model.materials.size(),
			static_cast<unsigned long long>(model.shape_count), seconds * 1000.0);
	for (const cga::ModelEntrance &entrance : model.entrances) {
		std::printf("entrance %s at %.2f %.2f %.2f, capacity %u\n", entrance.type.c_str(), entrance.position.x, entrance.position.y, entrance.position.z,
				entrance.capacity);
	}
	for (const cga::ModelZone &zone : model.zones) {
		std::printf("zone %s, %zu corners, %.2f m high\n", zone.type.c_str(), zone.polygon.size(), zone.height);
	}
	for (const cga::ModelObject &object : model.objects) {
		std::printf("object %s at %.2f %.2f %.2f, %zu places\n", object.tag.c_str(), object.frame[3].x, object.frame[3].y, object.frame[3].z, object.places.size());
	}
	for (const cga::ModelReport &report : model.reports) {
		std::printf("report %s: n %llu sum %g min %g max %g\n", report.key.c_str(), static_cast<unsigned long long>(report.count), report.sum, report.min,
				report.max);
	}
	for (const std::string &line : model.prints) {
		std::printf("%s\n", line.c_str());
	}
}

// As triangles in world coordinates, one OBJ object for the lot and one for each of its objects.
std::string obj_text(const cga::DerivationResult &model) {
	std::string text;
	char line[96];
	size_t first = 1;
	const auto add_mesh = [&](const Mesh &mesh, const glm::mat4 &frame, const std::string &name) {
		text += "o " + name + "\n";
		for (const MeshSurface &surface : make_surfaces(mesh)) {
			for (const glm::vec3 &point : surface.positions) {
				const glm::vec4 world = frame * glm::vec4(point, 1.0f);
				std::snprintf(line, sizeof line, "v %.6g %.6g %.6g\n", world.x, world.y, world.z);
				text += line;
			}
			for (size_t i = 0; i + 2 < surface.indices.size(); i += 3) {
				std::snprintf(line, sizeof line, "f %zu %zu %zu\n", first + surface.indices[i], first + surface.indices[i + 1], first + surface.indices[i + 2]);
				text += line;
			}
			first += surface.positions.size();
		}
	};
	add_mesh(model.mesh, glm::mat4(1.0f), "lot");
	for (size_t i = 0; i < model.objects.size(); ++i) {
		add_mesh(model.objects[i].mesh, model.objects[i].frame, "object_" + std::to_string(i));
	}
	return text;
}

bool write_model(const cga::DerivationResult &model, const std::string &path, Diagnostics &diagnostics) {
	return path.ends_with(".obj") ? write_file(path, obj_text(model), diagnostics) : write_glb(model, "lot", path, diagnostics);
}

cga::InitialShape::AttributeValue attribute_value(const std::string &text) {
	double number = 0.0;
	const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
	if (error == std::errc() && end == text.data() + text.size()) {
		return number;
	}
	if (text == "true" || text == "false") {
		return text == "true";
	}
	return text;
}

struct Request {
	std::string rules, footprint, out, report;
	std::vector<std::string> asset_folders;
	cga::InitialShape shape;
	int64_t repeat = 1;
};

Request read_request(Args &args) {
	args.require_positional(1, 1, "a rule file");
	Request request;
	request.rules = args.positional().empty() ? "" : args.positional()[0];
	request.footprint = args.text("--shape");
	request.out = args.text("--out");
	request.report = args.text("--json");
	request.asset_folders = args.all("--assets");
	request.repeat = args.whole("--repeat", 1, 1, 1'000'000);
	const auto [width, depth] = args.size("--lot", { 20.0, 20.0 });
	request.shape = cga::InitialShape::rectangle(width, depth, uint64_t(args.whole("--seed", 1)));
	request.shape.start_rule = args.text("--start");
	request.shape.name = "lot";
	for (const std::string &setting : args.all("--attr")) {
		const size_t equals = setting.find('=');
		if (equals == std::string::npos || equals == 0) {
			args.problem("--attr wants NAME=VALUE, not " + setting);
			continue;
		}
		request.shape.attributes.emplace_back(setting.substr(0, equals), attribute_value(setting.substr(equals + 1)));
	}
	if (!request.out.empty() && !request.out.ends_with(".glb") && !request.out.ends_with(".obj")) {
		args.problem("--out writes .glb or .obj files, not " + request.out);
	}
	return request;
}

bool load_footprint(Request &request, Diagnostics &diagnostics) {
	if (request.footprint.empty()) {
		return true;
	}
	const std::optional<ObjPolygons> polygons = load_obj(request.footprint, diagnostics);
	if (!polygons) {
		return false;
	}
	request.shape.faces.clear();
	for (const std::vector<glm::dvec3> &face : polygons->faces) {
		request.shape.faces.push_back({ face, {} });
	}
	return true;
}

cga::DerivationResult derive_timed(const Program &program, const Request &request, double &seconds) {
	const FileAssets assets(request.asset_folders);
	cga::DeriveOptions options;
	options.assets = &assets;
	cga::Deriver deriver(program, options);
	cga::DerivationResult model;
	const auto start = std::chrono::steady_clock::now();
	for (int64_t i = 0; i < request.repeat; ++i) {
		model = deriver.derive(request.shape);
	}
	seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / double(request.repeat);
	return model;
}

int run_derive(std::span<const std::string_view> raw) {
	Args args(raw,
			{ { "--shape", "FILE" }, { "--lot", "WxD" }, { "--start", "RULE" }, { "--attr", "NAME=VALUE" }, { "--seed", "N" }, { "--repeat", "N" }, { "--assets", "DIR" },
					{ "--out", "FILE" }, { "--json", "FILE" } });
	Request request = read_request(args);
	if (!args.is_valid()) {
		return args.report(derive_command);
	}
	Diagnostics diagnostics;
	const auto program = load_program(request.rules, cga::cga_dialect(), diagnostics);
	bool is_done = program != nullptr && load_footprint(request, diagnostics);
	if (is_done) {
		double seconds = 0.0;
		const cga::DerivationResult model = derive_timed(*program, request, seconds);
		diagnostics.append(model.diagnostics);
		is_done = !diagnostics.has_errors();
		if (request.report != "-") {
			print_summary(model, seconds);
		}
		is_done = is_done && (request.out.empty() || write_model(model, request.out, diagnostics));
		if (!request.report.empty()) {
			const std::string text = report_json(model, diagnostics, seconds).dump(1, '\t', false, json::error_handler_t::replace) + "\n";
			is_done &= request.report == "-" ? std::fwrite(text.data(), 1, text.size(), stdout) == text.size() : write_file(request.report, text, diagnostics);
		}
	}
	std::fputs(to_text(diagnostics).c_str(), stderr);
	return is_done ? 0 : 1;
}

} // namespace

const Command derive_command = {
	"derive",
	"pcg derive RULE.cga [--shape FOOTPRINT.obj | --lot 20x30] [--start RULE] [--attr NAME=VALUE].. [--seed N]\n"
	"           [--assets DIR].. [--repeat N] [--out MODEL.glb|MODEL.obj] [--json REPORT.json]\n"
	"  Derives one lot by a rule file and tells what came out: faces, entrances, zones, objects, reports.\n"
	"  --shape FILE      polygons of an OBJ file; without it a rectangle at the origin\n"
	"  --lot WxD         its width and depth in metres (20x20)\n"
	"  --start RULE      the rule to start with, instead of the file's @StartRule\n"
	"  --attr NAME=VALUE value of an attribute; may be given several times\n"
	"  --seed N          other seed, other model (1)\n"
	"  --assets DIR      folder with models and pictures, beside the rule file's project; may be given several times\n"
	"  --repeat N        derives N times, for timing; tells the mean\n"
	"  --out FILE        the model\n"
	"  --json FILE       everything as JSON; - for standard output\n",
	"derive one lot by a shape grammar",
	run_derive,
};

} // namespace pcg::cli
