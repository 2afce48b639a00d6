#include "cli/derive_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <glm/common.hpp>
#include <nlohmann/json.hpp>

#include "core/cga/instances.h"

namespace pcg::cli {

namespace {

using json = nlohmann::ordered_json;

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
	std::vector<size_t> faces;
	for (const cga::ModelObject &object : model.objects) {
		faces.push_back(object.mesh.faces.size());
	}
	for (const cga::ModelInstance &instance : model.instances) {
		if (instance.object >= 0) {
			faces[size_t(instance.object)] += model.prototypes[instance.prototype].mesh->faces.size();
		}
	}
	for (const cga::ModelObject &object : model.objects) {
		json places = json::array();
		for (const cga::ModelPlace &place : object.places) {
			places.push_back({ { "position", to_json(place.position) }, { "facing", to_json(place.facing) } });
		}
		list.push_back({ { "type", object.tag }, { "position", to_json(glm::vec3(object.frame[3])) }, { "faces", faces[list.size()] },
				{ "parent", object.parent }, { "places", places } });
	}
	return list;
}

json reports_json(const cga::DerivationResult &model) {
	json map = json::object(); // in order of first use
	for (const cga::ModelReport &report : model.reports) {
		const std::string name = report_name(model.reports, report);
		if (report.type == ValueType::Text) {
			map[name] = { { "n", report.count }, { "sum", report.most_frequent_text() }, { "min", report.texts.begin()->first },
				{ "max", report.texts.rbegin()->first }, { "avg", report.most_frequent_text() } };
			continue;
		}
		map[name] = { { "n", report.count }, { "sum", report.sum }, { "min", report.min }, { "max", report.max },
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

// Of the lot's mesh and its instances.
struct Figures {
	size_t faces = 0;
	double surface = 0.0;
	glm::vec3 low{ INFINITY }, high{ -INFINITY };

	explicit Figures(const cga::DerivationResult &model) {
		add(model.mesh);
		Mesh written;
		for (const cga::ModelInstance &instance : model.instances) {
			if (instance.object < 0) {
				written = Mesh();
				cga::append(written, model, instance);
				add(written);
			}
		}
	}
	json bounds() const { return faces == 0 ? json() : json{ to_json(low), to_json(high) }; }

private:
	void add(const Mesh &mesh) {
		faces += mesh.faces.size();
		surface += area(mesh);
		for (const glm::vec3 &point : mesh.positions) {
			low = glm::min(low, point);
			high = glm::max(high, point);
		}
	}
};

json shapes_json(const DeriveOutcome &outcome) {
	json list = json::array();
	for (size_t i = 0; i < outcome.models.size(); ++i) {
		const cga::DerivationResult &model = outcome.models[i];
		const Figures figures(model);
		list.push_back({ { "name", outcome.names[i] }, { "faces", figures.faces }, { "vertices", model.vertex_count }, { "area", figures.surface },
				{ "bbox", figures.bounds() }, { "reports", reports_json(model) } });
	}
	return list;
}

void add_reports(cga::DerivationResult &sum, const cga::DerivationResult &model) {
	for (const cga::ModelReport &report : model.reports) {
		const auto is_same = [&](const cga::ModelReport &other) { return other.key == report.key && other.type == report.type; };
		const auto found = std::ranges::find_if(sum.reports, is_same);
		if (found == sum.reports.end()) {
			sum.reports.push_back(report);
		} else {
			found->merge(report);
		}
	}
}

// With all instances.
void add_objects(cga::DerivationResult &sum, const cga::DerivationResult &model, uint32_t material_offset) {
	const int32_t first = int32_t(sum.objects.size());
	for (cga::ModelInstance instance : model.instances) {
		instance.prototype += uint32_t(sum.prototypes.size());
		instance.object += instance.object >= 0 ? first : 0;
		sum.instances.push_back(instance);
	}
	for (cga::ModelPrototype prototype : model.prototypes) {
		for (uint32_t &material : prototype.materials) {
			material += material_offset;
		}
		sum.prototypes.push_back(std::move(prototype));
	}
	for (cga::ModelObject object : model.objects) {
		for (MeshFace &face : object.mesh.faces) {
			face.material += material_offset;
		}
		object.parent += object.parent >= 0 ? first : 0;
		sum.objects.push_back(std::move(object));
	}
}

// The same message of many shapes is told once.
void add_diagnostics(Diagnostics &sum, const Diagnostics &more) {
	for (const Diagnostic &diagnostic : more.list()) {
		const bool is_known = std::ranges::any_of(sum.list(), [&](const Diagnostic &other) {
			return other.id == diagnostic.id && other.file == diagnostic.file && other.line == diagnostic.line && other.column == diagnostic.column &&
					other.message == diagnostic.message;
		});
		if (!is_known) {
			sum.add(diagnostic);
		}
	}
}

} // namespace

cga::DerivationResult sum_of(std::span<const cga::DerivationResult> models) {
	cga::DerivationResult sum;
	for (const cga::DerivationResult &model : models) {
		const uint32_t offset = uint32_t(sum.materials.size());
		append(sum.mesh, model.mesh, offset);
		sum.materials.insert(sum.materials.end(), model.materials.begin(), model.materials.end());
		sum.entrances.insert(sum.entrances.end(), model.entrances.begin(), model.entrances.end());
		sum.zones.insert(sum.zones.end(), model.zones.begin(), model.zones.end());
		sum.prints.insert(sum.prints.end(), model.prints.begin(), model.prints.end());
		add_objects(sum, model, offset);
		add_reports(sum, model);
		add_diagnostics(sum.diagnostics, model.diagnostics);
		sum.shape_count += model.shape_count;
		sum.leaf_count += model.leaf_count;
		sum.face_count += model.face_count;
		sum.vertex_count += model.vertex_count;
	}
	return sum;
}

std::string report_json(const DeriveOutcome &outcome, const Diagnostics &diagnostics) {
	const cga::DerivationResult &model = outcome.sum;
	const Figures figures(model);
	const json document = { { "faces", figures.faces }, { "vertices", model.vertex_count }, { "area", figures.surface }, { "bbox", figures.bounds() }, { "shapes", model.shape_count }, { "leaves", model.leaf_count }, { "materials", materials_json(model) },
		{ "reports", reports_json(model) }, { "prints", model.prints }, { "entrances", entrances_json(model) }, { "zones", zones_json(model) },
		{ "objects", objects_json(model) }, { "initial_shapes", shapes_json(outcome) }, { "diagnostics", diagnostics_json(diagnostics) },
		{ "seconds", outcome.seconds } };
	return document.dump(1, '\t', false, json::error_handler_t::replace) + "\n";
}

void print_summary(const DeriveOutcome &outcome) {
	const cga::DerivationResult &model = outcome.sum;
	const Figures figures(model);
	std::printf("%zu faces, %.1f m2, %zu materials, %llu shapes, %.2f ms\n", figures.faces, figures.surface, model.materials.size(),
			static_cast<unsigned long long>(model.shape_count), outcome.seconds * 1000.0);
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
		const std::string name = report_name(model.reports, report);
		const auto count = static_cast<unsigned long long>(report.count);
		if (report.type == ValueType::Text) {
			std::printf("report %s: n %llu most \"%s\" min \"%s\" max \"%s\"\n", name.c_str(), count, std::string(report.most_frequent_text()).c_str(),
					report.texts.begin()->first.c_str(), report.texts.rbegin()->first.c_str());
		} else {
			std::printf("report %s: n %llu sum %g min %g max %g\n", name.c_str(), count, report.sum, report.min, report.max);
		}
	}
	for (const std::string &line : model.prints) {
		std::printf("%s\n", line.c_str());
	}
}

std::string obj_text(const DeriveOutcome &outcome) {
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
	size_t object_count = 0;
	for (size_t i = 0; i < outcome.models.size(); ++i) {
		const cga::DerivationResult model = cga::written_out(outcome.models[i]);
		add_mesh(model.mesh, glm::mat4(1.0f), outcome.names[i]);
		for (const cga::ModelObject &object : model.objects) {
			add_mesh(object.mesh, object.frame, "object_" + std::to_string(object_count++));
		}
	}
	return text;
}

} // namespace pcg::cli
