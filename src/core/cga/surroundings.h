#pragma once

#include <memory>
#include <vector>

#include "core/cga/derivation.h"
#include "core/cga/neighborhood.h"
#include "core/cga/occluders.h"

// Context queries of one derivation, and the recording that later passes and neighbours answer from (CGA reference: cga_context). Shapes of
// the same initial shape are asked in two passes: the first gives default answers and is recorded, the second asks that record.
namespace pcg::cga {

enum class QueryTarget : uint8_t { Intra, Inter, All };
enum class OcclusionKind : uint8_t { Inside, Overlaps, Touches };
enum class Comparison : uint8_t { Northernmost, Southernmost, Easternmost, Westernmost, Highest, Lowest, Largest, Smallest };

class Surroundings {
public:
	// Of a new initial shape, which lies in `bounds`; nothing is recorded or known of its own tree yet.
	void begin(const Neighbors &neighbors, double occlusion_distance);
	// What the passes from here on make is recorded.
	void start_recording();
	void set_place(Bounds3 bounds, glm::dvec3 origin); // of each pass, once its initial shape is known
	// Ends the recording; `is_asked`: queries are answered from it from here on.
	std::shared_ptr<const Occluders> finish_recording(bool is_asked);

	// The next child of a shape; its places mean something only while this is active.
	bool is_active() const { return _recording != nullptr || _known != nullptr; }
	TreePlace child(TreePlace parent, uint64_t child_index);
	bool is_recording() const { return _recording != nullptr; }
	void record(const Shape &shape, uint64_t label);

	// Of the current shape.
	bool occlusion(OcclusionKind kind, QueryTarget target, uint64_t label, const Shape &shape);
	double minimum_distance(QueryTarget target, uint64_t label, const Shape &shape);
	double count(QueryTarget target, uint64_t label);
	double rank(QueryTarget target, uint64_t label, Comparison comparison, const Shape &shape);

private:
	template <typename Visit> void for_each_labeled(QueryTarget target, uint64_t label, Visit visit);
	const std::vector<const Occluders *> &near();

	Neighbors _neighbors;
	double _distance = 1.0;
	Bounds3 _bounds;
	glm::dvec3 _origin{ 0.0 };
	std::shared_ptr<Occluders> _recording;
	std::shared_ptr<const Occluders> _known;
	std::vector<const Occluders *> _near;
	bool _has_near = false;
};

} // namespace pcg::cga
