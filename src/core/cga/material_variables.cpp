#include "core/cga/material_variables.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/cga/context.h"

// What rules read and set of their material (CGA reference: attr_material, section 7.2).
namespace pcg::cga {

namespace {

using Writer = bool (*)(Context &context, const Value &value);

struct Row {
	std::string name;
	ValueType type = ValueType::Number;
	VariableHandler read = nullptr;
	Writer write = nullptr;
	std::string help;
};

const Look &look_of(Vm &vm) {
	return *Context::of(vm).shape.look;
}

// What an inserted model brought for its first face, which is not the one that closes a cut; nullptr if there is none or if a rule has set that part since.
const Material *brought(Context &context, uint32_t bit) {
	const Geometry *geometry = context.shape.geometry;
	if ((context.shape.look->parts & bit) != 0 || geometry == nullptr) {
		return nullptr;
	}
	const std::span faces(geometry->faces, geometry->face_count);
	const auto face = std::ranges::find_if(faces, [](uint16_t material) { return material != 0; }, &GeometryFace::material);
	return face != faces.end() ? context.model.materials().asset(face->material) : nullptr;
}
const Material *brought(Context &context, LookPart part) { return brought(context, bit_of(part)); }

bool read_number(Context &context, const Value &value, double most, float &target) {
	if (!value.is_number()) {
		return false;
	}
	target = float(std::clamp(context.finite(value), 0.0, most));
	return true;
}

// Stored with single precision: the number that was given, as far as it has few digits or is a step of 255.
Value as_given(float stored) {
	const double step = std::round(double(stored) * 255.0) / 255.0;
	if (float(step) == stored) {
		return Value::of(step);
	}
	std::array<char, 32> digits;
	const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), stored);
	double result = 0.0;
	std::from_chars(digits.data(), end.ptr, result);
	return Value::of(result);
}

// --- Colours and factors

// A member of Look and the one of Material that says the same.
template <auto of_look, auto of_material, LookPart part_> struct Colour {
	static constexpr auto member = of_look;
	static constexpr LookPart part = part_;

	static auto read(Vm &vm) -> std::remove_cvref_t<decltype(std::declval<Look>().*of_look)> {
		const Material *material = brought(Context::of(vm), part);
		return material != nullptr ? material->*of_material : look_of(vm).*of_look;
	}
};
using Diffuse = Colour<&Look::color, &Material::color, LookPart::Color>;
using Opacity = Colour<&Look::color, &Material::color, LookPart::Opacity>;
using Ambient = Colour<&Look::ambient, &Material::ambient, LookPart::Ambient>;
using Specular = Colour<&Look::specular, &Material::specular, LookPart::Specular>;
using Emissive = Colour<&Look::emissive, &Material::emissive, LookPart::Emissive>;

template <typename Of, int channel> Value read_channel(Vm &vm) { return as_given(Of::read(vm)[channel]); }
// The other channels stay as they are read.
template <typename Of, int channel> bool write_channel(Context &context, const Value &value) {
	const auto old = Of::read(context.vm);
	Look &look = context.own_look();
	look.mark(Of::part);
	for (int i = channel < 3 ? 0 : 3; i < (channel < 3 ? 3 : 4); ++i) {
		(look.*Of::member)[i] = old[i];
	}
	return read_number(context, value, 1.0, (look.*Of::member)[channel]);
}

template <float Look::*member, float Material::*of_material, LookPart part> Value read_factor(Vm &vm) {
	const Material *material = brought(Context::of(vm), part);
	return as_given(material != nullptr ? material->*of_material : look_of(vm).*member);
}
template <float Look::*member, LookPart part, int most> bool write_factor(Context &context, const Value &value) {
	Look &look = context.own_look();
	look.mark(part);
	return read_number(context, value, most, look.*member);
}

Value color_text(Vm &vm, glm::vec3 color) {
	constexpr std::string_view digits = "0123456789abcdef";
	std::string result = "#";
	for (int i = 0; i < 3; ++i) {
		const int value = int(std::lround(color[i] * 255.0f));
		result += digits[size_t(value / 16)];
		result += digits[size_t(value % 16)];
	}
	return Value::of(vm.make_text(result));
}
template <typename Of> Value read_color_text(Vm &vm) { return color_text(vm, glm::vec3(Of::read(vm))); }
template <typename Of> bool write_color_text(Context &context, const Value &value) {
	glm::vec4 color = context.shape.look->color;
	if (!value.is_text() || !context.read_color(*value.text, color)) {
		return false;
	}
	Look &look = context.own_look();
	look.mark(Of::part);
	for (int i = 0; i < 3; ++i) {
		(look.*Of::member)[i] = color[i];
	}
	return true;
}

// --- Name, shader, sides

template <uint32_t Look::*member, std::string Material::*of_material, LookPart part> Value read_text(Vm &vm) {
	const Material *material = brought(Context::of(vm), part);
	const TextPool &texts = Context::of(vm).model.materials().texts();
	return Value::of(vm.make_text(material != nullptr ? std::string_view(material->*of_material) : texts.text(look_of(vm).*member)));
}
template <uint32_t Look::*member, LookPart part> bool write_text(Context &context, const Value &value) {
	if (!value.is_text()) {
		return false;
	}
	Look &look = context.own_look();
	look.*member = context.model.materials().texts().intern(*value.text);
	look.mark(part);
	return true;
}
Value read_shader(Vm &vm) {
	const Value shader = read_text<&Look::shader, &Material::shader, LookPart::Shader>(vm);
	return shader.text->view.empty() ? Value::of(vm.make_text("CityEngineShader")) : shader;
}

// How the opacity map is used follows from the map itself.
Value read_opacity_mode(Vm &vm) { return Value::of(vm.make_text("blend")); }
Value read_opacity_cutoff(Vm &) { return Value::of(0.5); }
bool ignore(Context &context, const Value &) {
	context.vm.warn("not-supported", "material.opacitymap.mode and .cutoff are accepted, without effect");
	return true;
}

Value read_double_sided(Vm &vm) {
	const Material *material = brought(Context::of(vm), LookPart::DoubleSided);
	return Value::of(material != nullptr ? material->is_double_sided : look_of(vm).is_double_sided);
}
bool write_double_sided(Context &context, const Value &value) {
	if (!value.is_bool()) {
		return false;
	}
	Look &look = context.own_look();
	look.is_double_sided = value.boolean;
	look.mark(LookPart::DoubleSided);
	return true;
}

// --- Maps

// A copy of the look's textures, to be changed.
TextureSlots &own_textures(Context &context, Look &look) {
	static constexpr TextureSlots nothing;
	TextureSlots *slots = context.arena.copy(look.textures != nullptr ? look.textures : &nothing, 1);
	look.textures = slots;
	return *slots;
}

void put_texture(Look &look, TextureSlots &textures, TextureUse use, const TextureFiles::Entry &entry) {
	look.parts |= bit_of(use);
	textures.slots[size_t(use)].file = entry.file;
	textures.slots[size_t(use)].path = entry.path;
}

constexpr std::array<std::string_view, texture_use_count> map_names = { "colormap", "bumpmap", "dirtmap", "specularmap", "opacitymap", "normalmap",
	"emissivemap", "occlusionmap", "roughnessmap", "metallicmap" };

struct MapField {
	std::string_view suffix;
	float TextureSlot::*member;
	float TextureMap::*of_map;
	std::string_view help;
};
constexpr std::array<MapField, 5> map_fields = { { { ".su", &TextureSlot::scale_u, &TextureMap::scale_u, "Scale along u." },
		{ ".sv", &TextureSlot::scale_v, &TextureMap::scale_v, "Scale along v." }, { ".tu", &TextureSlot::shift_u, &TextureMap::shift_u, "Shift along u." },
		{ ".tv", &TextureSlot::shift_v, &TextureMap::shift_v, "Shift along v." }, { ".rw", &TextureSlot::turn, &TextureMap::turn, "Turn, degrees." } } };

// What the model brought in that place.
template <size_t use> TextureMap brought_map(const Material &material) {
	const TextureMap *map = material.map(TextureUse(use));
	return map != nullptr ? *map : TextureMap();
}

template <size_t use> Value read_map(Vm &vm) {
	if (const Material *material = brought(Context::of(vm), bit_of(TextureUse(use)))) {
		return Value::of(vm.make_text(brought_map<use>(*material).file));
	}
	const uint32_t file = look_of(vm).texture(TextureUse(use)).file;
	return Value::of(vm.make_text(Context::of(vm).model.materials().texts().text(file)));
}
template <size_t use> bool write_map(Context &context, const Value &value) {
	if (!value.is_text()) {
		return false;
	}
	const TextureFiles::Entry entry = context.texture_files.find(context, *value.text);
	Look &look = context.own_look();
	put_texture(look, own_textures(context, look), TextureUse(use), entry);
	return true;
}
template <size_t use, size_t field> Value read_map_field(Vm &vm) {
	const Material *material = brought(Context::of(vm), bit_of(TextureUse(use)));
	const TextureSlot &slot = look_of(vm).texture(TextureUse(use));
	return as_given(material != nullptr && !slot.is_placed ? brought_map<use>(*material).*map_fields[field].of_map : slot.*map_fields[field].member);
}
template <size_t use, size_t field> bool write_map_field(Context &context, const Value &value) {
	if (!value.is_number()) {
		return false;
	}
	const Material *material = brought(context, bit_of(TextureUse(use)));
	Look &look = context.own_look();
	TextureSlot &slot = own_textures(context, look).slots[use];
	if (material != nullptr && !slot.is_placed) { // the model's pictures stay, and the other numbers those of the first
		const TextureMap map = brought_map<use>(*material);
		slot = { 0, 0, map.scale_u, map.scale_v, map.shift_u, map.shift_v, map.turn, 1 };
	}
	slot.is_placed = 1;
	slot.*map_fields[field].member = float(context.finite(value));
	return true;
}

template <size_t use, size_t... fields> void add_map_fields(std::vector<Row> &rows, std::index_sequence<fields...>) {
	(rows.push_back({ "material." + std::string(map_names[use]) + std::string(map_fields[fields].suffix), ValueType::Number, read_map_field<use, fields>,
			 write_map_field<use, fields>, std::string(map_fields[fields].help) }),
			...);
}
template <size_t use> void add_map(std::vector<Row> &rows) {
	rows.push_back({ "material." + std::string(map_names[use]), ValueType::Text, read_map<use>, write_map<use>, "File of the picture; empty: none." });
	add_map_fields<use>(rows, std::make_index_sequence<map_fields.size()>());
}
template <size_t... uses> void add_maps(std::vector<Row> &rows, std::index_sequence<uses...>) {
	(add_map<uses>(rows), ...);
}

template <typename Of> void add_color(std::vector<Row> &rows, const std::string &name, const std::string &what) {
	constexpr ValueType number = ValueType::Number;
	rows.push_back({ name + ".r", number, read_channel<Of, 0>, write_channel<Of, 0>, "Red of the " + what + ", 0 to 1." });
	rows.push_back({ name + ".g", number, read_channel<Of, 1>, write_channel<Of, 1>, "Green of the " + what + ", 0 to 1." });
	rows.push_back({ name + ".b", number, read_channel<Of, 2>, write_channel<Of, 2>, "Blue of the " + what + ", 0 to 1." });
	rows.push_back({ name + ".rgb", ValueType::Text, read_color_text<Of>, write_color_text<Of>, "The " + what + " as \"#rrggbb\"." });
}

template <float Look::*member, float Material::*of_material, LookPart part, int most>
void add_factor(std::vector<Row> &rows, const std::string &name, const std::string &help) {
	rows.push_back({ name, ValueType::Number, read_factor<member, of_material, part>, write_factor<member, part, most>, help });
}

std::vector<Row> make_rows() {
	constexpr ValueType number = ValueType::Number, text = ValueType::Text;
	std::vector<Row> rows;
	add_color<Diffuse>(rows, "material.color", "colour");
	add_color<Ambient>(rows, "material.ambient", "ambient colour");
	add_color<Specular>(rows, "material.specular", "colour of highlights");
	add_color<Emissive>(rows, "material.emissive", "light that the surface gives off");
	rows.push_back({ "material.opacity", number, read_channel<Opacity, 3>, write_channel<Opacity, 3>, "0 is clear, 1 is solid." });
	rows.push_back({ "material.color.a", number, read_channel<Opacity, 3>, write_channel<Opacity, 3>, "The old name of material.opacity." });
	add_factor<&Look::shininess, &Material::shininess, LookPart::Shininess, 128>(rows, "material.shininess", "How narrow highlights are, 0 to 128.");
	add_factor<&Look::reflectivity, &Material::reflectivity, LookPart::Reflectivity, 1>(rows, "material.reflectivity",
			"0 to 1; together with the specular colour.");
	add_factor<&Look::bump_value, &Material::bump_value, LookPart::BumpValue, 1000>(rows, "material.bumpValue", "Height of the bump map.");
	add_factor<&Look::metallic, &Material::metallic, LookPart::Metallic, 1>(rows, "material.metallic", "0 or 1.");
	add_factor<&Look::roughness, &Material::roughness, LookPart::Roughness, 1>(rows, "material.roughness", "0 is a mirror, 1 is dull.");
	rows.push_back({ "material.doubleSided", ValueType::Bool, read_double_sided, write_double_sided, "Whether faces are seen from behind too." });
	rows.push_back({ "material.name", text, read_text<&Look::name, &Material::name, LookPart::Name>, write_text<&Look::name, LookPart::Name>,
			"The name in exported files." });
	rows.push_back({ "material.shader", text, read_shader, write_text<&Look::shader, LookPart::Shader>, "CityEngine's name of the shader; kept, without effect." });
	add_maps(rows, std::make_index_sequence<texture_use_count>());
	rows.push_back({ "material.opacitymap.mode", text, read_opacity_mode, ignore, "Accepted, without effect: always \"blend\"." });
	rows.push_back({ "material.opacitymap.cutoff", number, read_opacity_cutoff, ignore, "Accepted, without effect: always 0.5." });
	return rows;
}

const std::vector<Row> &all_rows() {
	static const std::vector<Row> rows = make_rows();
	return rows;
}

} // namespace

void add_material_variables(Dialect &dialect) {
	for (const Row &row : all_rows()) {
		dialect.variables.push_back({ row.name, row.type, row.read, row.help, true });
	}
}

bool write_material_variable(Vm &vm, uint32_t index, const Value &value) {
	return index < all_rows().size() && all_rows()[index].write(Context::of(vm), value);
}

// The opacity map is the same picture if that has an alpha channel, else there is none.
void set_color_texture(Context &context, const Text &name) {
	const TextureFiles::Entry entry = context.texture_files.find(context, name);
	Look &look = context.own_look();
	TextureSlots &textures = own_textures(context, look);
	put_texture(look, textures, TextureUse::Color, entry);
	put_texture(look, textures, TextureUse::Opacity, entry.has_alpha ? entry : TextureFiles::Entry());
}

} // namespace pcg::cga
