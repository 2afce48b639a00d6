#include "core/cga/material_variables.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
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

template <auto member, int channel> Value read_channel(Vm &vm) { return as_given((look_of(vm).*member)[channel]); }
template <auto member, int channel, LookPart part> bool write_channel(Context &context, const Value &value) {
	Look &look = context.own_look();
	look.mark(part);
	return read_number(context, value, 1.0, (look.*member)[channel]);
}

template <float Look::*member> Value read_factor(Vm &vm) { return as_given(look_of(vm).*member); }
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
template <auto member> Value read_color_text(Vm &vm) { return color_text(vm, glm::vec3(look_of(vm).*member)); }
template <auto member, LookPart part> bool write_color_text(Context &context, const Value &value) {
	glm::vec4 color = context.shape.look->color;
	if (!value.is_text() || !context.read_color(*value.text, color)) {
		return false;
	}
	Look &look = context.own_look();
	look.mark(part);
	for (int i = 0; i < 3; ++i) {
		(look.*member)[i] = color[i];
	}
	return true;
}

// --- Name, shader, sides

template <uint32_t Look::*member> Value read_text(Vm &vm) {
	return Value::of(vm.make_text(Context::of(vm).model.materials().texts().text(look_of(vm).*member)));
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
Value read_shader(Vm &vm) { return look_of(vm).shader == 0 ? Value::of(vm.make_text("CityEngineShader")) : read_text<&Look::shader>(vm); }

// How the opacity map is used follows from the map itself.
Value read_opacity_mode(Vm &vm) { return Value::of(vm.make_text("blend")); }
Value read_opacity_cutoff(Vm &) { return Value::of(0.5); }
bool ignore(Context &context, const Value &) {
	context.vm.warn("not-supported", "material.opacitymap.mode and .cutoff are accepted, without effect");
	return true;
}

Value read_double_sided(Vm &vm) { return Value::of(look_of(vm).is_double_sided); }
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
	std::string_view help;
};
constexpr std::array<MapField, 5> map_fields = { { { ".su", &TextureSlot::scale_u, "Scale along u." }, { ".sv", &TextureSlot::scale_v, "Scale along v." },
		{ ".tu", &TextureSlot::shift_u, "Shift along u." }, { ".tv", &TextureSlot::shift_v, "Shift along v." },
		{ ".rw", &TextureSlot::turn, "Turn, degrees." } } };

template <size_t use> Value read_map(Vm &vm) {
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
	return as_given(look_of(vm).texture(TextureUse(use)).*map_fields[field].member);
}
template <size_t use, size_t field> bool write_map_field(Context &context, const Value &value) {
	if (!value.is_number()) {
		return false;
	}
	own_textures(context, context.own_look()).slots[use].*map_fields[field].member = float(context.finite(value));
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

template <auto member, LookPart part> void add_color(std::vector<Row> &rows, const std::string &name, const std::string &what) {
	constexpr ValueType number = ValueType::Number;
	rows.push_back({ name + ".r", number, read_channel<member, 0>, write_channel<member, 0, part>, "Red of the " + what + ", 0 to 1." });
	rows.push_back({ name + ".g", number, read_channel<member, 1>, write_channel<member, 1, part>, "Green of the " + what + ", 0 to 1." });
	rows.push_back({ name + ".b", number, read_channel<member, 2>, write_channel<member, 2, part>, "Blue of the " + what + ", 0 to 1." });
	rows.push_back({ name + ".rgb", ValueType::Text, read_color_text<member>, write_color_text<member, part>, "The " + what + " as \"#rrggbb\"." });
}

std::vector<Row> make_rows() {
	constexpr ValueType number = ValueType::Number, text = ValueType::Text;
	std::vector<Row> rows;
	add_color<&Look::color, LookPart::Color>(rows, "material.color", "colour");
	add_color<&Look::ambient, LookPart::Ambient>(rows, "material.ambient", "ambient colour");
	add_color<&Look::specular, LookPart::Specular>(rows, "material.specular", "colour of highlights");
	add_color<&Look::emissive, LookPart::Emissive>(rows, "material.emissive", "light that the surface gives off");
	rows.push_back({ "material.opacity", number, read_channel<&Look::color, 3>, write_channel<&Look::color, 3, LookPart::Opacity>, "0 is clear, 1 is solid." });
	rows.push_back({ "material.color.a", number, read_channel<&Look::color, 3>, write_channel<&Look::color, 3, LookPart::Opacity>, "The old name of material.opacity." });
	rows.push_back({ "material.shininess", number, read_factor<&Look::shininess>, write_factor<&Look::shininess, LookPart::Shininess, 128>,
			"How narrow highlights are, 0 to 128." });
	rows.push_back({ "material.reflectivity", number, read_factor<&Look::reflectivity>, write_factor<&Look::reflectivity, LookPart::Reflectivity, 1>,
			"0 to 1; together with the specular colour." });
	rows.push_back({ "material.bumpValue", number, read_factor<&Look::bump_value>, write_factor<&Look::bump_value, LookPart::BumpValue, 1000>,
			"Height of the bump map." });
	rows.push_back({ "material.metallic", number, read_factor<&Look::metallic>, write_factor<&Look::metallic, LookPart::Metallic, 1>, "0 or 1." });
	rows.push_back({ "material.roughness", number, read_factor<&Look::roughness>, write_factor<&Look::roughness, LookPart::Roughness, 1>,
			"0 is a mirror, 1 is dull." });
	rows.push_back({ "material.doubleSided", ValueType::Bool, read_double_sided, write_double_sided, "Whether faces are seen from behind too." });
	rows.push_back({ "material.name", text, read_text<&Look::name>, write_text<&Look::name, LookPart::Name>, "The name in exported files." });
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
