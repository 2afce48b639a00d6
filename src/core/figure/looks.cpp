#include "core/figure/looks.h"

#include "core/base/random.h"
#include "core/population/names.h"

namespace pcg {

namespace {

constexpr float adult_age = 15.0f; // from here on a body has an adult's size
constexpr float elder_age = 65.0f;

// Of each of hair_colors(), then white; gray and white are those of the old.
constexpr glm::vec3 hair_tones[8] = { { 0.06f, 0.045f, 0.04f }, { 0.12f, 0.075f, 0.05f }, { 0.2f, 0.11f, 0.06f }, { 0.32f, 0.19f, 0.09f },
	{ 0.55f, 0.38f, 0.17f }, { 0.42f, 0.14f, 0.06f }, { 0.5f, 0.5f, 0.5f }, { 0.8f, 0.79f, 0.77f } };
constexpr glm::vec3 skin_tones[8] = { { 0.87f, 0.68f, 0.56f }, { 0.82f, 0.6f, 0.47f }, { 0.74f, 0.52f, 0.39f }, { 0.63f, 0.42f, 0.3f },
	{ 0.5f, 0.32f, 0.22f }, { 0.38f, 0.23f, 0.15f }, { 0.28f, 0.17f, 0.12f }, { 0.9f, 0.74f, 0.64f } };

} // namespace

Looks looks_of(const Population &population, PersonId id) {
	const Person &person = population.person(id);
	const FigureAge age = person.age < adult_age ? FigureAge::Child : (person.age < elder_age ? FigureAge::Adult : FigureAge::Elder);
	Looks looks;
	looks.kind = uint8_t((person.gender == Gender::Woman ? 3 : 0) + int(age));
	looks.hair = age == FigureAge::Elder ? uint8_t(6 + index_of(id) % 2) : uint8_t(population.household(person.household).hair_color % hair_colors().size());
	looks.skin = uint8_t(mix64(index_of(person.household)) % 8);
	const NamedColor &top = clothes_colors()[person.clothes_color % clothes_colors().size()];
	looks.top = glm::vec3(top.red, top.green, top.blue) / 255.0f;
	return looks;
}

Figure make_figure_of_kind(size_t kind) { return make_figure(kind >= 3, FigureAge(kind % 3)); }

glm::vec3 hair_tone(uint8_t hair) { return hair_tones[hair % 8]; }

glm::vec3 skin_tone(uint8_t skin) { return skin_tones[skin % 8]; }

} // namespace pcg
