#include "core/cga/scatter.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "core/cga/context.h"
#include "core/cga/operations/operations.h"
#include "core/geometry/polygon.h"

// scatter(domain, number, distribution) { body } (CGA reference, section 4.9).
namespace pcg::cga {

namespace {

enum class Domain : uint32_t { Surface, Volume, Scope };

// Where in the scope the distribution has its middle: center front back left right top bottom.
glm::dvec3 mean_of(uint32_t word, glm::dvec3 size) {
	static constexpr glm::dvec3 places[] = { { 0.5, 0.5, 0.5 }, { 0.5, 0.5, 1.0 }, { 0.5, 0.5, 0.0 }, { 0.0, 0.5, 0.5 }, { 1.0, 0.5, 0.5 },
		{ 0.5, 1.0, 0.5 }, { 0.5, 0.0, 0.5 } };
	return size * places[word];
}

Bell bell_of(Context &context, const Args &args) {
	const glm::dvec3 size = context.shape.size;
	const bool is_given = args.count() > 4;
	const double deviation = is_given ? std::abs(context.finite(args[4])) : 0.16;
	const bool is_relative = !is_given || args[4].size_kind == SizeKind::Relative;
	return { mean_of(args.count() > 3 ? args[3].word : 0, size), is_relative ? deviation * glm::abs(size) : glm::dvec3(deviation) };
}

ScatterPoint draw(const Scatter &scatter, Domain domain, Random &random, glm::dvec3 size, const Bell *bell) {
	switch (domain) {
		case Domain::Surface:
			return bell != nullptr ? scatter.on_surface(random, *bell) : scatter.on_surface(random);
		case Domain::Volume:
			return bell != nullptr ? scatter.in_volume(random, *bell) : scatter.in_volume(random);
		default:
			return { bell != nullptr ? Scatter::in_box(random, size, *bell) : Scatter::in_box(random, size) };
	}
}

const Geometry *one_point(Context &context) {
	context.builder.clear();
	context.builder.add_point(glm::dvec3(0.0));
	context.builder.end_loop(1);
	context.builder.end_face();
	return context.builder.finish(context.arena, false);
}

// Size 0; on a surface y is its normal.
Shape point_shape(const Shape &parent, const Geometry *point, const ScatterPoint &place, Domain domain) {
	Shape child = parent;
	child.geometry = point;
	child.geometry_offset = glm::dvec3(0.0);
	child.geometry_scale = glm::dvec3(1.0);
	child.size = glm::dvec3(0.0);
	child.position = parent.position + parent.rotation * place.position;
	if (domain == Domain::Surface) {
		child.rotation = parent.rotation * axes_from_y(place.normal, { 1.0, 0.0, 0.0 });
	}
	return child;
}

Flow scatter(Vm &vm, const Args &args) {
	Context &context = Context::of(vm);
	context.mark_replaced();
	const Geometry *geometry = baked(context.shape, context.arena);
	if (geometry == nullptr || args.block == nullptr) {
		return Flow::Next;
	}
	const Scatter places(*geometry);
	Domain domain = Domain(args[0].word);
	if (domain == Domain::Volume && !geometry->is_closed) {
		domain = Domain::Surface;
	}
	if (domain != Domain::Scope && !places.has_surface()) {
		domain = Domain::Scope;
	}
	const bool is_gaussian = args[2].word == 1;
	const Bell bell = bell_of(context, args);
	const Geometry *point = one_point(context);
	const Shape parent = context.shape;
	const double wanted = std::min(context.finite(args[1]), double(context.limits().max_shapes) + 1.0);
	if (wanted < 1.0) {
		vm.warn("not-positive", "no point is scattered: their number must be 1 or more"); // CGA changelog 2017.0
	}
	for (double i = 1.0; i <= wanted; i += 1.0) {
		const ScatterPoint place = draw(places, domain, vm.random(), parent.size, is_gaussian ? &bell : nullptr);
		const Shape child = point_shape(parent, point, place, domain);
		for (const BlockEntry &entry : vm.entries(*args.block)) {
			if (context.run_child(child, entry.body) != Flow::Next) {
				return Flow::Stop;
			}
		}
	}
	return Flow::Next;
}

} // namespace

void add_scatter_operations(Dialect &dialect) {
	using enum ParamKind;
	dialect.operations.push_back({ "scatter",
			{ { "domain", Word, "surface volume scope" }, { "nPoints", Number }, { "distribution", Word, "uniform gaussian" },
					{ "mean", Word, "center front back left right top bottom", true }, { "stddev", Size, {}, true } },
			BlockKind::Bodies, scatter,
			"Makes shapes without a size at random places on the surface (y is its normal), in the volume or in the scope: everywhere alike, or "
			"thicker around a place of the scope (standard deviation in metres, or with ' of the scope's sizes; '0.16 if nothing is said)." });
}

} // namespace pcg::cga
