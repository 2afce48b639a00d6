#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include <glm/common.hpp>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/cga/color.h"
#include "core/cga/functions/functions.h"
#include "core/lang/vm.h"

// Colours as texts: "#rrggbb" or "#rrggbboo" (CGA reference, section 8.1).
namespace pcg::cga {

namespace {

// Opacity is 0 where the text is too short to have one.
glm::dvec4 color_at(const Args &args, size_t i) {
	glm::vec4 color(0.0f);
	parse_color(text_at(args, i), color);
	return glm::round(glm::dvec4(color) * 255.0) / 255.0;
}

// Hue in degrees, saturation and value (Smith 1978).
glm::dvec3 to_hsv(glm::dvec4 color) {
	const double high = std::max({ color.r, color.g, color.b }), low = std::min({ color.r, color.g, color.b });
	const double range = high - low;
	double hue = 0.0;
	if (range > 0.0 && high == color.r) {
		hue = std::fmod((color.g - color.b) / range + 6.0, 6.0);
	} else if (range > 0.0) {
		hue = high == color.g ? (color.b - color.r) / range + 2.0 : (color.r - color.g) / range + 4.0;
	}
	return { hue * 60.0, high > 0.0 ? range / high : 0.0, high };
}

glm::dvec3 from_hsv(double hue, double saturation, double value) {
	const double turned = std::isfinite(hue) ? std::fmod(std::fmod(hue, 360.0) + 360.0, 360.0) / 60.0 : 0.0;
	const auto channel = [&](double shift) {
		const double k = std::fmod(shift + turned, 6.0);
		return value - value * saturation * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
	};
	return { channel(5.0), channel(3.0), channel(1.0) };
}

double unit(double x) { return x > 0.0 ? std::min(x, 1.0) : 0.0; }

Value hex(Vm &vm, std::span<const double> channels) {
	constexpr std::string_view digits = "0123456789ABCDEF";
	std::string text = "#";
	for (const double channel : channels) {
		const size_t byte = size_t(std::lround(unit(channel) * 255.0));
		text += digits[byte / 16];
		text += digits[byte % 16];
	}
	return Value::of(vm.make_text(text));
}

template <int channel> Value color_channel(Vm &, const Args &args) { return Value::of(color_at(args, 0)[channel]); }
template <int part> Value color_hsv(Vm &, const Args &args) { return Value::of(to_hsv(color_at(args, 0))[part]); }

Value rgb_to_hex(Vm &vm, const Args &args) {
	std::array<double, 4> channels{};
	for (size_t i = 0; i < args.count(); ++i) {
		channels[i] = args.number(i);
	}
	return hex(vm, std::span(channels).first(args.count()));
}

Value hsv_to_hex(Vm &vm, const Args &args) {
	const glm::dvec3 color = from_hsv(args.number(0), unit(args.number(1)), unit(args.number(2)));
	const std::array<double, 4> channels = { color.r, color.g, color.b, args.number_or(3, 1.0) };
	return hex(vm, std::span(channels).first(args.count()));
}

// CityEngine's ramps have 36 colours, on straight lines between a few of them.
constexpr size_t ramp_size = 36;

struct RampKey {
	size_t place; // 0 to 35
	glm::u8vec3 color;
};

struct Ramp {
	std::string_view name;
	std::span<const RampKey> keys;
};

constexpr RampKey white_to_black[] = { { 0, { 255, 255, 255 } }, { 35, { 0, 0, 0 } } };
constexpr RampKey green_to_red[] = { { 0, { 59, 168, 0 } }, { 17, { 255, 255, 0 } }, { 35, { 255, 0, 0 } } };
constexpr RampKey yellow_to_red[] = { { 0, { 245, 245, 0 } }, { 35, { 245, 0, 0 } } };
constexpr RampKey red_to_blue[] = { { 0, { 196, 69, 57 } }, { 17, { 250, 252, 187 } }, { 35, { 54, 97, 207 } } };
constexpr RampKey orange_to_blue[] = { { 0, { 255, 200, 0 } }, { 8, { 255, 115, 15 } }, { 17, { 255, 0, 81 } }, { 26, { 232, 0, 162 } }, { 35, { 0, 0, 255 } } };
constexpr RampKey brown_to_blue[] = { { 0, { 156, 86, 33 } }, { 17, { 255, 255, 191 } }, { 35, { 33, 130, 145 } } };
constexpr RampKey spectrum[] = { { 0, { 185, 82, 164 } }, { 5, { 60, 83, 163 } }, { 10, { 57, 191, 239 } }, { 13, { 107, 191, 69 } }, { 15, { 168, 208, 54 } },
	{ 20, { 251, 238, 36 } }, { 25, { 241, 109, 32 } }, { 30, { 239, 54, 36 } }, { 35, { 237, 39, 38 } } };

constexpr Ramp ramps[] = { { "whiteToBlack", white_to_black }, { "greenToRed", green_to_red }, { "yellowToRed", yellow_to_red },
	{ "redToBlue", red_to_blue }, { "orangeToBlue", orange_to_blue }, { "brownToBlue", brown_to_blue }, { "spectrum", spectrum } };

// Whole steps of a channel, rounded down.
glm::dvec3 ramp_color(std::span<const RampKey> keys, size_t place) {
	size_t next = 1;
	while (next + 1 < keys.size() && keys[next].place < place) {
		++next;
	}
	const RampKey &from = keys[next - 1], &to = keys[next];
	const double share = double(place - from.place) / double(to.place - from.place);
	return glm::floor(glm::mix(glm::dvec3(from.color), glm::dvec3(to.color), share) + 1e-9) / 255.0;
}

Value color_ramp(Vm &vm, const Args &args) {
	const double at = unit(args.number(1));
	const std::string_view name = text_at(args, 0);
	glm::dvec3 color(0.0);
	const auto ramp = std::ranges::find(ramps, name, &Ramp::name);
	if (ramp == std::end(ramps)) {
		vm.warn("unknown-ramp", "there is no ramp of colours `" + std::string(name) + "`; black is taken",
				"whiteToBlack greenToRed yellowToRed redToBlue orangeToBlue brownToBlue spectrum");
	} else {
		color = ramp_color(ramp->keys, std::min(size_t(at * ramp_size), ramp_size - 1));
	}
	return hex(vm, std::array{ color.r, color.g, color.b });
}

} // namespace

void add_color_functions(Dialect &dialect) {
	using enum ParamKind;
	auto &functions = dialect.functions;
	const ParamSpec color = { "color", Text };
	const ParamSpec r = { "r", Number }, g = { "g", Number }, b = { "b", Number }, o = { "opacity", Number };
	const ParamSpec h = { "hue", Number }, s = { "saturation", Number }, v = { "value", Number };
	constexpr ValueType number = ValueType::Number, text = ValueType::Text;
	functions.push_back({ "colorHexToR", { color }, number, color_channel<0>, "Red of \"#rrggbb\", 0 to 1." });
	functions.push_back({ "colorHexToG", { color }, number, color_channel<1>, "Green of \"#rrggbb\", 0 to 1." });
	functions.push_back({ "colorHexToB", { color }, number, color_channel<2>, "Blue of \"#rrggbb\", 0 to 1." });
	functions.push_back({ "colorHexToO", { color }, number, color_channel<3>, "Opacity of \"#rrggbboo\", 0 to 1; 0 where it is not given." });
	functions.push_back({ "colorHexToH", { color }, number, color_hsv<0>, "Hue of \"#rrggbb\", degrees from 0 to 360." });
	functions.push_back({ "colorHexToS", { color }, number, color_hsv<1>, "Saturation of \"#rrggbb\", 0 to 1." });
	functions.push_back({ "colorHexToV", { color }, number, color_hsv<2>, "Brightness (value) of \"#rrggbb\", 0 to 1." });
	functions.push_back({ "colorRGBToHex", { r, g, b }, text, rgb_to_hex, "\"#rrggbb\" of channels from 0 to 1." });
	functions.push_back({ "colorRGBOToHex", { r, g, b, o }, text, rgb_to_hex, "\"#rrggbboo\" of channels from 0 to 1." });
	functions.push_back({ "colorHSVToHex", { h, s, v }, text, hsv_to_hex, "\"#rrggbb\" of a hue in degrees, saturation and value from 0 to 1." });
	functions.push_back({ "colorHSVOToHex", { h, s, v, o }, text, hsv_to_hex, "\"#rrggbboo\" of a hue in degrees, the rest from 0 to 1." });
	functions.push_back({ "colorRamp", { { "ramp", Text }, { "at", Number } }, text, color_ramp,
			"Colour of a ramp at a place from 0 to 1: whiteToBlack, greenToRed, yellowToRed, redToBlue, orangeToBlue, brownToBlue, spectrum." });
}

} // namespace pcg::cga
