#include "core/population/names.h"

#include <array>

namespace pcg {

namespace {

constexpr std::string_view women_names[] = { "Ada", "Alba", "Alice", "Amara", "Ana", "Anna", "Aria", "Beatriz", "Carla",
	"Carmen", "Chloe", "Clara", "Diana", "Elena", "Eliza", "Emma", "Eva", "Fatima", "Flora", "Gloria", "Grace", "Hana",
	"Helen", "Ida", "Ines", "Iris", "Isabel", "Jana", "Joana", "Julia", "Laia", "Laura", "Lea", "Lena", "Lucia", "Maia",
	"Maria", "Marta", "Mei", "Mila", "Mireia", "Nadia", "Nina", "Nora", "Nuria", "Olga", "Olivia", "Paula", "Rosa", "Ruth",
	"Sara", "Sofia", "Stella", "Teresa", "Vera", "Yasmin", "Zoe" };

constexpr std::string_view men_names[] = { "Adam", "Adrian", "Alan", "Albert", "Alex", "Amir", "Andres", "Anton", "Ben",
	"Boris", "Bruno", "Carlos", "Cesar", "Daniel", "David", "Diego", "Emil", "Enric", "Erik", "Felix", "Frank", "George",
	"Hugo", "Ian", "Ivan", "Jack", "Jaime", "Jan", "Javier", "Joan", "Jonas", "Jorge", "Jose", "Karl", "Leo", "Liam",
	"Luca", "Luis", "Marc", "Mario", "Martin", "Max", "Miguel", "Noah", "Omar", "Oscar", "Pablo", "Pau", "Pedro", "Peter",
	"Ravi", "Samuel", "Simon", "Tariq", "Theo", "Tomas", "Victor" };

constexpr std::string_view families[] = { "Abad", "Alonso", "Baker", "Bauer", "Bell", "Blanco", "Brown", "Campos", "Carter",
	"Castro", "Chen", "Clark", "Cook", "Costa", "Cruz", "Diaz", "Evans", "Ferrer", "Fischer", "Fuentes", "Garcia", "Gil",
	"Gomez", "Green", "Gray", "Haddad", "Hall", "Hill", "Ibarra", "Jones", "Kaya", "Khan", "King", "Kovacs", "Lee", "Lopez",
	"Marin", "Marsh", "Martin", "Mendez", "Meyer", "Molina", "Moore", "Mora", "Navarro", "Novak", "Ortega", "Patel", "Perez",
	"Pons", "Prat", "Ramos", "Reyes", "Rivera", "Roca", "Romero", "Rossi", "Ruiz", "Sala", "Sanchez", "Santos", "Serra",
	"Silva", "Smith", "Soler", "Soto", "Suarez", "Tanaka", "Taylor", "Torres", "Vega", "Vidal", "Vila", "Walker", "Ward",
	"Weber", "White", "Wood", "Young", "Zapata" };

constexpr NamedColor hairs[] = { { "black", 28, 24, 22 }, { "dark brown", 62, 42, 30 }, { "brown", 98, 66, 42 },
	{ "light brown", 140, 100, 64 }, { "blond", 205, 170, 110 }, { "red", 150, 66, 34 }, { "gray", 150, 150, 150 } };

constexpr NamedColor clothes[] = { { "white", 232, 232, 228 }, { "black", 36, 36, 40 }, { "gray", 128, 130, 134 },
	{ "navy", 38, 52, 96 }, { "blue", 62, 110, 180 }, { "sky", 130, 180, 220 }, { "teal", 40, 130, 130 },
	{ "green", 70, 136, 72 }, { "olive", 116, 120, 60 }, { "yellow", 222, 190, 72 }, { "orange", 214, 128, 50 },
	{ "red", 186, 52, 48 }, { "wine", 116, 36, 56 }, { "pink", 214, 136, 160 }, { "violet", 116, 80, 156 },
	{ "brown", 110, 78, 54 } };

std::string_view name_at(const Population &population, std::span<const std::string_view> list, uint32_t index) {
	return index < list.size() ? list[index] : std::string_view(population.names[index - list.size()]);
}

} // namespace

std::span<const std::string_view> first_names(Gender gender) {
	if (gender == Gender::Woman) {
		return women_names;
	}
	return men_names;
}

std::span<const std::string_view> family_names() { return families; }
std::span<const NamedColor> hair_colors() { return hairs; }
uint8_t draw_hair_color(Random &random) { return uint8_t(random.index(std::size(hairs) - 1)); } // gray stands last
std::span<const NamedColor> clothes_colors() { return clothes; }

std::string_view first_name(const Population &population, PersonId id) {
	const Person &person = population.person(id);
	return name_at(population, first_names(person.gender), person.name);
}

std::string_view family_name(const Population &population, HouseholdId id) {
	return name_at(population, family_names(), population.household(id).family_name);
}

std::string full_name(const Population &population, PersonId id) {
	return std::string(first_name(population, id)) + " " + std::string(family_name(population, population.person(id).household));
}

} // namespace pcg
