#include "cli/footprints.h"

#include "core/io/atomic_file.h"
#include "core/io/obj.h"

namespace pcg::cli {

namespace {

struct Group {
	std::string name;
	std::vector<size_t> faces; // numbers of `f` lines
};

// Which faces belong together. The reader of OBJ files has found them sound by then.
std::vector<Group> groups_of(std::string_view text) {
	std::vector<Group> groups;
	size_t face = 0;
	bool is_named = false;
	while (!text.empty()) {
		const size_t end = std::min(text.find('\n'), text.size());
		std::string_view line = text.substr(0, end);
		text.remove_prefix(std::min(end + 1, text.size()));
		line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
		const std::string_view word = line.substr(0, line.find_first_of(" \t\r"));
		if (word == "o" || word == "g") {
			const size_t start = std::min(line.find_first_not_of(" \t\r", 1), line.size());
			groups.push_back({ std::string(line.substr(start, line.find_last_not_of(" \t\r") + 1 - start)), {} });
			is_named = true;
		} else if (word == "f" || word == "fo") {
			if (!is_named) {
				groups.push_back({ "shape " + std::to_string(face), {} });
			}
			groups.back().faces.push_back(face++);
		}
	}
	std::erase_if(groups, [](const Group &group) { return group.faces.empty(); });
	return groups;
}

} // namespace

std::optional<std::vector<cga::InitialShape>> load_footprints(const std::string &path, Diagnostics &diagnostics) {
	const Result<std::string> text = read_file(path);
	if (!text) {
		diagnostics.add(text.diagnostic());
		return std::nullopt;
	}
	const std::optional<ObjPolygons> polygons = parse_obj(*text, path, diagnostics);
	if (!polygons) {
		return std::nullopt;
	}
	std::vector<cga::InitialShape> shapes;
	for (const Group &group : groups_of(*text)) {
		cga::InitialShape &shape = shapes.emplace_back();
		shape.name = group.name;
		for (const size_t face : group.faces) {
			if (face < polygons->faces.size()) {
				shape.faces.push_back({ polygons->faces[face], {}, polygons->uvs[face] });
			}
		}
	}
	return shapes;
}

} // namespace pcg::cli
