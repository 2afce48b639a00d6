// Walks through cities of every kind of layout, ours and Detour's on the same ground with the same costs, one after the other. Built only where
// Recast and Detour are installed (Debian: librecast-dev). Prints one JSON object a figure.
#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <optional>
#include <string>

#include <recastnavigation/DetourNavMesh.h>
#include <recastnavigation/DetourNavMeshBuilder.h>
#include <recastnavigation/DetourNavMeshQuery.h>
#include <recastnavigation/Recast.h>

#include "bench/figure.h"
#include "bench/house_rules.h"
#include "core/base/random.h"
#include "core/cga/dialect.h"
#include "core/city/city_generator.h"
#include "core/city/walkable.h"
#include "core/io/rule_loader.h"
#include "core/navigation/path_finder.h"

using namespace pcg;

namespace {

constexpr int queries = 10000;

std::optional<City> make_city(LayoutKind kind) {
	Diagnostics diagnostics;
	MemorySourceProvider sources;
	sources.add("house.cga", std::string(house_rules));
	const RulesByType rules = { { "", { load_program("house.cga", cga::cga_dialect(), sources, diagnostics), {}, {} } } };
	LayoutParameters parameters;
	parameters.kind = kind;
	return generate_city(*make_layout(layout_for_lots(300, parameters), diagnostics), rules, {}, diagnostics);
}

struct Triangles {
	std::vector<float> vertices;
	std::vector<int> indices;
	std::vector<unsigned char> areas;

	void add(const std::vector<glm::vec3> &polygon, unsigned char area) {
		const int first = int(vertices.size() / 3);
		for (const glm::vec3 &corner : polygon) {
			vertices.insert(vertices.end(), { corner.x, corner.y, corner.z });
		}
		for (int i = 1; i + 1 < int(polygon.size()); ++i) {
			indices.insert(indices.end(), { first, first + i, first + i + 1 });
			areas.push_back(area);
		}
	}
};

// Areas are 1 = pavement, 2 = crossing, 3 = carriageway, 4 = lot.
Triangles triangles_of(const City &city) {
	Triangles triangles;
	for (const Ground &ground : city.layout.ground) {
		triangles.add(ground.polygon, ground.kind == GroundKind::Pavement ? 1 : (ground.kind == GroundKind::Crossing ? 2 : 3));
	}
	for (const LotBuild &lot : city.lots) {
		for (const std::vector<glm::vec3> &piece : lot.free_ground) {
			triangles.add(piece, 4);
		}
	}
	return triangles;
}

constexpr float cell = 0.5f, cell_height = 0.2f; // metres

rcPolyMesh *bake(Triangles &triangles) {
	rcContext context(false);
	float low[3], high[3];
	int width = 0, depth = 0;
	rcCalcBounds(triangles.vertices.data(), int(triangles.vertices.size() / 3), low, high);
	low[1] -= 1.0f;
	high[1] += 3.0f;
	rcCalcGridSize(low, high, cell, &width, &depth);
	rcHeightfield *field = rcAllocHeightfield();
	rcCreateHeightfield(&context, *field, width, depth, low, high, cell, cell_height);
	rcRasterizeTriangles(&context, triangles.vertices.data(), int(triangles.vertices.size() / 3), triangles.indices.data(), triangles.areas.data(),
			int(triangles.areas.size()), *field, 2);
	rcCompactHeightfield *compact = rcAllocCompactHeightfield();
	rcBuildCompactHeightfield(&context, 9, 2, *field, *compact);
	rcBuildDistanceField(&context, *compact);
	rcBuildRegions(&context, *compact, 0, 8, 400);
	rcContourSet *contours = rcAllocContourSet();
	rcBuildContours(&context, *compact, 1.3f, 24, *contours);
	rcPolyMesh *mesh = rcAllocPolyMesh();
	rcBuildPolyMesh(&context, *contours, 6, *mesh);
	rcFreeContourSet(contours);
	rcFreeCompactHeightfield(compact);
	rcFreeHeightField(field);
	return mesh;
}

bool fill(dtNavMesh &mesh, rcPolyMesh &polygons) {
	std::fill_n(polygons.flags, polygons.npolys, 1);
	dtNavMeshCreateParams parameters{};
	parameters.verts = polygons.verts;
	parameters.vertCount = polygons.nverts;
	parameters.polys = polygons.polys;
	parameters.polyAreas = polygons.areas;
	parameters.polyFlags = polygons.flags;
	parameters.polyCount = polygons.npolys;
	parameters.nvp = polygons.nvp;
	parameters.walkableHeight = 1.8f;
	parameters.walkableClimb = 0.4f;
	rcVcopy(parameters.bmin, polygons.bmin);
	rcVcopy(parameters.bmax, polygons.bmax);
	parameters.cs = cell;
	parameters.ch = cell_height;
	parameters.buildBvTree = true;
	unsigned char *data = nullptr;
	int size = 0;
	return dtCreateNavMeshData(&parameters, &data, &size) && dtStatusSucceed(mesh.init(data, size, DT_TILE_FREE_DATA));
}

struct Walks {
	double seconds = 0.0;
	std::vector<double> lengths; // 0 = no way
};

Walks walk_ours(const NavMesh &mesh, const std::vector<glm::vec3> &ends) {
	std::vector<NavPoint> points;
	for (const glm::vec3 &end : ends) {
		points.push_back(mesh.nearest(end, 2.0f));
	}
	Walks walks;
	PathFinder finder(mesh);
	const std::clock_t start = std::clock();
	for (size_t i = 0; i < points.size(); i += 2) {
		walks.lengths.push_back(finder.find(points[i], points[i + 1]) ? finder.length() : 0.0);
	}
	walks.seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
	return walks;
}

double length_of(const float *points, int count) {
	double sum = 0.0;
	for (int i = 1; i < count; ++i) {
		sum += std::hypot(points[3 * i] - points[3 * i - 3], points[3 * i + 2] - points[3 * i - 1]);
	}
	return sum;
}

Walks walk_detour(const dtNavMesh &mesh, const std::vector<glm::vec3> &ends) {
	dtNavMeshQuery query;
	query.init(&mesh, 8192);
	dtQueryFilter filter;
	const GroundCosts costs;
	filter.setAreaCost(1, costs.pavement);
	filter.setAreaCost(2, costs.crossing);
	filter.setAreaCost(3, costs.street);
	filter.setAreaCost(4, costs.lot);
	const float reach[3] = { 2.0f, 2.0f, 2.0f };
	std::vector<dtPolyRef> polygons(ends.size());
	std::vector<glm::vec3> points(ends.size());
	for (size_t i = 0; i < ends.size(); ++i) {
		query.findNearestPoly(&ends[i].x, reach, &filter, &polygons[i], &points[i].x);
	}
	constexpr int longest = 512;
	dtPolyRef corridor[longest];
	float corners[3 * longest];
	Walks walks;
	const std::clock_t start = std::clock();
	for (size_t i = 0; i < points.size(); i += 2) {
		int count = 0, corner_count = 0;
		query.findPath(polygons[i], polygons[i + 1], &points[i].x, &points[i + 1].x, &filter, corridor, &count, longest);
		query.findStraightPath(&points[i].x, &points[i + 1].x, corridor, count, corners, nullptr, nullptr, &corner_count, longest);
		const bool is_there = count > 0 && corridor[count - 1] == polygons[i + 1];
		walks.lengths.push_back(is_there ? length_of(corners, corner_count) : 0.0);
	}
	walks.seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
	return walks;
}

bool compare(LayoutKind kind, const char *name) {
	const std::optional<City> city = make_city(kind);
	Triangles triangles = triangles_of(*city);
	const std::unique_ptr<rcPolyMesh, void (*)(rcPolyMesh *)> polygons(bake(triangles), rcFreePolyMesh);
	const std::unique_ptr<dtNavMesh, void (*)(dtNavMesh *)> detour(dtAllocNavMesh(), dtFreeNavMesh);
	if (!fill(*detour, *polygons)) {
		std::fputs("detour_bench: Detour took no mesh\n", stderr);
		return false;
	}
	Random random(1);
	std::vector<glm::vec3> ends;
	for (int i = 0; i < 2 * queries; ++i) {
		ends.push_back(city->model.entrances()[random.index(city->model.entrances().size())].position);
	}
	const Walks ours = walk_ours(city_nav_mesh(*city), ends), theirs = walk_detour(*detour, ends);
	double our_metres = 0.0, their_metres = 0.0;
	for (size_t i = 0; i < ours.lengths.size(); ++i) {
		const bool have_both = ours.lengths[i] > 0.0 && theirs.lengths[i] > 0.0;
		our_metres += have_both ? ours.lengths[i] : 0.0;
		their_metres += have_both ? theirs.lengths[i] : 0.0;
	}
	bench::print(std::string("path query, ") + name + " of 300 lots", ours.seconds / queries * 1e6, "us", theirs.seconds / queries * 1e6);
	bench::print(std::string("length of those paths, ") + name, our_metres / queries, "m", their_metres / queries);
	return true;
}

} // namespace

int main() {
	const bool is_good = compare(LayoutKind::Grid, "grid") && compare(LayoutKind::Radial, "radial city") && compare(LayoutKind::Grown, "grown city");
	return is_good ? 0 : 1;
}
