#include "godot/convert_looks.h"

#include <godot_cpp/variant/color.hpp>

#include "core/population/names.h"
#include "godot/convert.h"

using namespace godot;

namespace pcg {

namespace {

Color to_color(glm::vec3 tone) { return Color(tone.x, tone.y, tone.z); }

} // namespace

Dictionary to_godot(const Population &population, PersonId id, const Looks &looks) {
	static constexpr const char *ages[] = { "child", "adult", "elder" };
	Dictionary result;
	result["name"] = to_godot(std::string_view(full_name(population, id)));
	result["gender"] = looks.kind >= 3 ? "woman" : "man";
	result["age_group"] = ages[looks.kind % 3];
	result["age"] = int64_t(population.person(id).age);
	result["height"] = make_figure_of_kind(looks.kind).height;
	result["hair_color"] = to_color(hair_tone(looks.hair));
	result["skin_color"] = to_color(skin_tone(looks.skin));
	result["clothes_color"] = to_color(looks.top);
	return result;
}

} // namespace pcg
