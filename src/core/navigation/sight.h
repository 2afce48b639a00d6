#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/navigation/corners.h"
#include "core/navigation/nav_mesh.h"
#include "core/navigation/plan.h"

// What can be seen from a place: cones of sight spread from polygon to polygon, narrowed by each gap they pass. Nobody sees from one kind of ground
// into another, so each straight walk is of one cost a metre; walks change the ground at corners. Use one for each thread; the mesh and the corners must
// outlive it.
namespace pcg {

struct SeenCorner {
	uint32_t corner = no_corner;
	float cost = 0.0f; // of the straight walk there
};

using CornerWalks = std::vector<std::vector<SeenCorner>>; // by the corner that they begin at

class Sight {
public:
	Sight(const NavMesh &mesh, const Corners &corners) : _mesh(&mesh), _corners(&corners), _places(corners.count()), _entries(mesh.polygon_count()) {}

	// The corners seen at which a shortest walk that comes from here may bend, each once. Valid until the next call.
	std::span<const SeenCorner> look(const NavPoint &from);
	// The same from a corner, which these polygons touch, for walks that bend here, too.
	std::span<const SeenCorner> look(uint32_t corner, std::span<const uint32_t> polygons);
	// Of the last look: all that it depends on lies in this part of the plan, or touches it.
	PlanBox extent() const;
	// Calls `action(polygon)` for those that the last look came into; perhaps several times for one.
	void for_polygons(auto action) const {
		std::for_each(_starts.begin(), _starts.end(), action);
		std::for_each(_cones.begin(), _cones.end(), [&](const Cone &cone) { action(cone.polygon); });
	}
	// Looks end after so many cones, whatever is still to be seen; what lies near has been seen then. Streets need a tenth of them, 137 parks side by side
	// 4,900, but where polygons are piled on one another cones go round for minutes.
	static constexpr size_t most_cones = 1 << 13;
	void limit(size_t cones) { _limit = cones; }
	// Of the last look.
	bool is_cut_short() const { return _cones.size() >= _limit; }
	size_t cone_count() const { return _cones.size(); }
	// Of these, the ones that came into a polygon in directions in which another is in it already. On plain ground there are none but at seams.
	size_t overlapping_count() const { return _overlapping; }
	// What the straight walk costs; infinity if `to` cannot be seen.
	float straight(const NavPoint &from, const NavPoint &to);

private:
	static constexpr uint32_t no_cone = 0xFFFFFFFF;
	static constexpr uint32_t not_seen = 0xFFFFFFFF;

	// Of the plan, from the root.
	struct Ray {
		float x = 0.0f, z = 0.0f;
	};
	// Sight into a polygon through a gap, or what of the gap is not hidden.
	struct Cone {
		uint32_t polygon, link; // that it came through
		uint32_t source; // of the link
		uint32_t earlier; // another cone into this polygon; no_cone if it is the first
		Ray left, right;
	};
	struct Place {
		uint32_t look = 0; // counts only if this is the number of the running one
		uint32_t seen = not_seen; // index of what was seen
	};
	struct Entry {
		uint32_t look = 0; // as in Place
		uint32_t last = 0; // cone that came into the polygon; no_cone if the root touches it
	};

	void begin(glm::vec3 root, uint32_t corner);
	void spread();
	void look_around(uint32_t polygon);
	void look_through(uint32_t cone);
	void enter(uint32_t source, uint32_t link, Ray left, Ray right);
	void see(uint32_t corner);
	bool is_known(uint32_t polygon, Ray left, Ray right) const;
	static bool overlap(const Cone &cone, Ray left, Ray right) { return turn(cone.right, left) > slack_of(left) && turn(cone.left, right) < -slack_of(right); }
	bool is_needless(Ray left, Ray right) const;
	Ray ray_to(glm::vec3 point) const { return { point.x - _root.x, point.z - _root.z }; }
	// Positive if the second ray lies left of the first.
	static float turn(Ray first, Ray second) { return second.x * first.z - second.z * first.x; }
	static float slack_of(Ray ray);
	void aim_into(uint32_t polygon);

	const NavMesh *_mesh;
	const Corners *_corners;
	std::vector<Place> _places; // by corner
	std::vector<Entry> _entries; // by polygon
	uint32_t _look = 0;
	glm::vec3 _root{ 0.0f };
	uint32_t _root_corner = no_corner; // if it is one
	float _ground = 1.0f; // cost of a metre
	std::vector<uint32_t> _starts; // polygons that touch the root
	std::vector<Cone> _cones;
	size_t _overlapping = 0;
	size_t _limit = most_cones;
	std::vector<SeenCorner> _seen;
	// When looking for one point only: it, and the polygons that touch it.
	bool _has_aim = false;
	glm::vec3 _aim{ 0.0f };
	std::vector<uint32_t> _aim_polygons;
	float _aim_cost = 0.0f;
};

} // namespace pcg
