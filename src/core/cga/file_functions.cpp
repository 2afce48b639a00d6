#include <algorithm>
#include <cmath>
#include <string>

#include "core/cga/context.h"
#include "core/cga/operations/inserted.h"
#include "core/cga/operations/operations.h"

// Functions about files, assets and pictures (CGA reference, section 8.5).
namespace pcg::cga {

namespace {

std::string_view text_at(const Args &args, size_t i) {
	return args[i].is_text() ? args[i].text->view : std::string_view();
}

// The rule file that names what a function is asked about.
uint32_t file_of(Vm &vm) {
	return vm.place().file;
}

// --- Names

// Backslashes part folders only where no slash does; endings go by the last dot of the whole path (CityEngine's own library).
std::string_view file_name(std::string_view path) {
	return path.substr(path.find_last_of(path.find('/') == std::string_view::npos ? '\\' : '/') + 1);
}

Value name_of(Vm &vm, const Args &args) { return Value::of(vm.make_text(file_name(text_at(args, 0)))); }

Value directory_of(Vm &vm, const Args &args) {
	const std::string_view path = text_at(args, 0);
	return Value::of(vm.make_text(path.substr(0, path.size() - file_name(path).size())));
}

Value extension_of(Vm &vm, const Args &args) {
	const std::string_view path = text_at(args, 0);
	const size_t dot = path.find_last_of('.');
	return Value::of(vm.make_text(dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1)));
}

Value base_name_of(Vm &vm, const Args &args) {
	const std::string_view name = file_name(text_at(args, 0));
	return Value::of(vm.make_text(name.substr(0, name.find_last_of('.'))));
}

// --- Searching

const AssetStore::FileList &search(Vm &vm, const Args &args) {
	const AssetStore::FileList &list = Context::of(vm).assets.search(text_at(args, 0), file_of(vm));
	if (list.items.empty()) {
		vm.warn("missing-file", "no file fits \"" + std::string(text_at(args, 0)) + "\"", "searches begin in the project's folder assets, and in the project itself");
	}
	return list;
}

Value exists(Vm &vm, const Args &args) {
	const std::string_view name = text_at(args, 0);
	return Value::of(is_built_in(name) || Context::of(vm).assets.has_file(name, file_of(vm)));
}

Value search_list(Vm &vm, const Args &args) { return Value::of(&Context::of(vm).assets.search(text_at(args, 0), file_of(vm)).joined); }

Value array_of(Vm &vm, const std::vector<const Text *> &texts) {
	std::vector<Value> values;
	for (const Text *text : texts) {
		values.push_back(Value::of(text));
	}
	return Value::of(vm.make_array(values, 1, ValueType::Text));
}

Value search_array(Vm &vm, const Args &args) {
	std::vector<const Text *> texts;
	for (const Text &item : Context::of(vm).assets.search(text_at(args, 0), file_of(vm)).items) {
		texts.push_back(&item);
	}
	return array_of(vm, texts);
}

Value pick(Vm &vm, const std::vector<const Text *> &texts) {
	return Value::of(texts.empty() ? vm.make_text({}) : texts[vm.random().index(texts.size())]);
}

Value random_file(Vm &vm, const Args &args) {
	const AssetStore::FileList &list = search(vm, args);
	return Value::of(list.items.empty() ? vm.make_text({}) : &list.items[vm.random().index(list.items.size())]);
}

// --- Measuring

const AssetStore::Model &measured_model(Vm &vm, std::string_view name) {
	Context &context = Context::of(vm);
	AssetStore::Model &model = context.assets.model(name, file_of(vm));
	if (!model.is_usable() && context.assets.is_first_time(model)) {
		vm.warn_each("missing-asset", "there is no asset \"" + std::string(name) + "\" to measure", "its sizes are taken as 0");
	}
	return model;
}

Value asset_info(Vm &vm, const Args &args) {
	const uint32_t what = args[1].word; // sx sy sz tx ty tz
	const std::string_view name = text_at(args, 0);
	if (name.starts_with("builtin:")) {
		return Value::of(what < 3 ? 1.0 : 0.0);
	}
	const AssetStore::Model &model = measured_model(vm, name);
	return Value::of(what < 3 ? model.size()[int(what)] : model.low[int(what) - 3]);
}

Value image_info(Vm &vm, const Args &args) {
	const glm::uvec2 size = Context::of(vm).assets.image_size(text_at(args, 0), file_of(vm));
	if (size.x == 0) {
		vm.warn("missing-texture", "there is no picture \"" + std::string(text_at(args, 0)) + "\" to measure", "its sizes are taken as 0");
	}
	return Value::of(double(size[int(args[1].word)]));
}

// --- Choosing

// The axes of "xz", as they are named; empty: it names no axes.
std::vector<int> axes_of(std::string_view word) {
	std::vector<int> axes;
	for (char c : word) {
		if (c < 'x' || c > 'z') {
			return {};
		}
		axes.push_back(c - 'x');
	}
	return axes;
}

constexpr std::string_view ratio_words = "xy xz yz xyz yx zx zy";
constexpr std::string_view size_words = "x y z xy xz yz xyz yx zx zy";

std::string_view nth_word(std::string_view words, uint32_t index) {
	for (; index > 0; --index) {
		words.remove_prefix(std::min(words.find(' ') + 1, words.size()));
	}
	return words.substr(0, words.find(' '));
}

struct Scored {
	const Text *file = nullptr;
	double error = INFINITY;
};

// How far a thing must be scaled to fill the scope, by axis, as logarithms: twice as large is as far off as half as large. Axes on which both are
// flat say nothing.
struct Scales {
	double least = INFINITY, most = -INFINITY;

	void add(double scope, double thing) {
		if (scope == 0.0 && thing == 0.0) {
			return;
		}
		const double scale = std::log(std::abs(scope) / std::abs(thing)); // infinite if one of them is flat
		least = std::min(least, scale);
		most = std::max(most, scale);
	}
	double ratio_error() const { return most >= least ? (std::isinf(most) || std::isinf(least) ? INFINITY : most - least) : 0.0; }
	double size_error() const { return most >= least ? std::max(std::abs(most), std::abs(least)) : 0.0; }
	// 0.1: scaled by 0.9 to 1.1 at most.
	bool is_within(double error) const { return most < least || (std::exp(most) <= 1.0 + error + 1e-9 && std::exp(least) >= 1.0 - error - 1e-9); }
};

enum class Measure : uint8_t { AssetRatio, AssetSize, ImageRatio };

Scales scales_of(Vm &vm, std::string_view file, const std::vector<int> &axes, Measure measure) {
	const glm::dvec3 scope = Context::of(vm).shape.size;
	Scales scales;
	if (measure == Measure::ImageRatio) {
		const glm::uvec2 pixels = Context::of(vm).assets.image_size(file, file_of(vm));
		for (int i = 0; i < 2 && size_t(i) < axes.size(); ++i) {
			scales.add(scope[axes[size_t(i)]], double(pixels[i]));
		}
		return scales;
	}
	const glm::dvec3 size = measured_model(vm, file).size();
	for (int axis : axes) {
		scales.add(scope[axis], size[axis]);
	}
	return scales;
}

// Best first; equal ones stay in order. Those beyond `max_error` are left out; 0: none.
std::vector<Scored> sorted(Vm &vm, const std::vector<const Text *> &files, std::string_view axes_word, Measure measure, double max_error) {
	const std::vector<int> axes = axes_of(axes_word);
	if (axes.empty()) {
		vm.warn("unknown-word", "\"" + std::string(axes_word) + "\" names no axes", "such as \"xy\"");
	}
	std::vector<Scored> result;
	for (const Text *file : files) {
		const Scales scales = scales_of(vm, file->view, axes, measure);
		if (max_error <= 0.0 || scales.is_within(max_error)) {
			result.push_back({ file, measure == Measure::AssetSize ? scales.size_error() : scales.ratio_error() });
		}
	}
	std::ranges::stable_sort(result, {}, &Scored::error);
	return result;
}

std::vector<const Text *> found_files(Vm &vm, const Args &args) {
	std::vector<const Text *> files;
	for (const Text &item : search(vm, args).items) {
		files.push_back(&item);
	}
	return files;
}

// assetsSortSize and the like: of a list in a text, or of an array.
template <Measure measure> Value sort_files(Vm &vm, const Args &args) {
	std::vector<const Text *> files;
	if (args[0].is_array()) {
		const ArrayData &array = *args[0].array;
		for (uint32_t i = 0; i < array.size(); ++i) {
			files.push_back(array.values[i].is_text() ? array.values[i].text : vm.make_text({}));
		}
	} else {
		std::string_view rest = text_at(args, 0);
		while (!rest.empty()) {
			const size_t end = std::min(rest.find(';'), rest.size());
			files.push_back(vm.make_text(rest.substr(0, end)));
			rest.remove_prefix(std::min(end + 1, rest.size()));
		}
	}
	const std::string_view axes = nth_word(measure == Measure::AssetSize ? size_words : ratio_words, args[1].word);
	std::vector<const Text *> result;
	std::string joined;
	for (const Scored &scored : sorted(vm, files, axes, measure, args.number_or(2, 0.0))) {
		result.push_back(scored.file);
		joined.append(scored.file->view).append(";");
	}
	return args[0].is_array() ? array_of(vm, result) : Value::of(vm.make_text(joined));
}

// One of the best n; pictures of equal error count as one.
template <Measure measure> Value best_file(Vm &vm, const Args &args) {
	const std::vector<Scored> files = sorted(vm, found_files(vm, args), text_at(args, 1), measure, 0.0);
	const double wanted = std::clamp(args.number_or(2, 1.0), 1.0, 1e6);
	std::vector<const Text *> best;
	for (const Scored &scored : files) {
		const bool is_tied = measure == Measure::ImageRatio && args.count() == 2 && scored.error <= files.front().error + 1e-9;
		if (double(best.size()) + 1.0 <= wanted || is_tied) {
			best.push_back(scored.file);
		}
	}
	return best.size() == 1 ? Value::of(best.front()) : pick(vm, best);
}

Value fitting_file(Vm &vm, const Args &args) {
	std::vector<const Text *> fitting;
	for (const Scored &scored : sorted(vm, found_files(vm, args), text_at(args, 1), Measure::AssetSize, args.number(2))) {
		fitting.push_back(scored.file);
	}
	return pick(vm, fitting);
}

// --- Reading

Value read_text(Vm &vm, const Args &args) {
	const Text *text = Context::of(vm).assets.text(text_at(args, 0), file_of(vm));
	if (text == nullptr) {
		vm.warn("missing-file", "there is no file \"" + std::string(text_at(args, 0)) + "\" to read", "an empty text is taken instead");
		return Value::of(vm.make_text({}));
	}
	return Value::of(text);
}

template <bool has_numbers> Value read_table(Vm &vm, const Args &args) {
	const AssetStore::Table *table = Context::of(vm).assets.table(text_at(args, 0), file_of(vm));
	if (table == nullptr) {
		vm.warn("missing-file", "there is no table \"" + std::string(text_at(args, 0)) + "\" to read", "an empty array is taken instead");
		return Value::of(vm.make_array({}, 1, has_numbers ? ValueType::Number : ValueType::Text));
	}
	return Value::of(has_numbers ? &table->number_array : &table->text_array);
}

void add_choosing_functions(Dialect &dialect) {
	constexpr ValueType Void = ValueType::Void;
	auto &functions = dialect.functions;
	const ParamSpec list = { "files", ParamKind::Any }, query = { "query", ParamKind::Text }, axes = { "axes", ParamKind::Text };
	const ParamSpec ratio = { "axes", ParamKind::Word, ratio_words }, size = { "axes", ParamKind::Word, size_words };
	const ParamSpec best = { "n", ParamKind::Number }, error = { "maxScaleError", ParamKind::Number };
	functions.push_back({ "assetsSortRatio", { list, ratio }, Void, sort_files<Measure::AssetRatio>, "The models of a list or an array, those first whose proportions are most like the scope's." });
	functions.push_back({ "assetsSortSize", { list, size, error }, Void, sort_files<Measure::AssetSize>,
			"The models of a list or an array, those first whose size is most like the scope's; with an error above 0 only those that need be scaled no more than that (0.1: by 10 %)." });
	functions.push_back({ "imagesSortRatio", { list, ratio }, Void, sort_files<Measure::ImageRatio>, "The pictures of a list or an array, those first whose proportions are most like the scope's." });
	functions.push_back({ "assetBestRatio", { query, axes }, ValueType::Text, best_file<Measure::AssetRatio>, "Of the models that a search finds the one whose proportions are most like the scope's." });
	functions.push_back({ "assetBestSize", { query, axes }, ValueType::Text, best_file<Measure::AssetSize>, "Of the models that a search finds the one whose size is most like the scope's." });
	functions.push_back({ "assetApproxRatio", { query, axes, best }, ValueType::Text, best_file<Measure::AssetRatio>, "At random one of the n models whose proportions are most like the scope's." });
	functions.push_back({ "assetApproxSize", { query, axes, best }, ValueType::Text, best_file<Measure::AssetSize>, "At random one of the n models whose size is most like the scope's." });
	functions.push_back({ "assetFitSize", { query, axes, error }, ValueType::Text, fitting_file, "At random one of the models that need be scaled no more than the error says (0.1: by 10 %); 0 allows all." });
	functions.push_back({ "imageBestRatio", { query, axes }, ValueType::Text, best_file<Measure::ImageRatio>, "Of the pictures that a search finds one whose proportions are most like the scope's." });
	functions.push_back({ "imageApproxRatio", { query, axes, best }, ValueType::Text, best_file<Measure::ImageRatio>, "At random one of the n pictures whose proportions are most like the scope's." });
}

} // namespace

void add_file_functions(Dialect &dialect) {
	using enum ParamKind;
	auto &functions = dialect.functions;
	const ParamSpec path = { "path", Text }, query = { "query", Text };
	functions.push_back({ "fileName", { path }, ValueType::Text, name_of, "The path without its folders." });
	functions.push_back({ "fileBasename", { path }, ValueType::Text, base_name_of, "The path without its folders and its ending." });
	functions.push_back({ "fileDirectory", { path }, ValueType::Text, directory_of, "The folders of a path, with the slash behind the last." });
	functions.push_back({ "fileExtension", { path }, ValueType::Text, extension_of, "The ending of a path, without its dot." });
	functions.push_back({ "fileExists", { path }, ValueType::Bool, exists, "Whether there is such a file, sought as i() seeks assets." });
	functions.push_back({ "fileSearch", { query }, ValueType::Text, search_list,
			"The files that fit a query, as a list in alphabetical order: * and ? stand for any characters, $ begins a regular expression, blanks mean and." });
	functions.push_back({ "filesSearch", { query }, ValueType::Array, search_array, "The same as an array." });
	functions.push_back({ "fileRandom", { query }, ValueType::Text, random_file, "At random one of the files that fit a query." });
	functions.push_back({ "assetInfo", { path, { "what", Word, "sx sy sz tx ty tz" } }, ValueType::Number, asset_info, "Size of a model, or the lowest corner of its bounding box, metres." });
	functions.push_back({ "imageInfo", { path, { "what", Word, "sx sy" } }, ValueType::Number, image_info, "Width (sx) or height (sy) of a picture, pixels." });
	functions.push_back({ "readTextFile", { path }, ValueType::Text, read_text, "The content of a text file." });
	functions.push_back({ "readStringTable", { path }, ValueType::Array, read_table<false>, "The rows of a table of comma-separated values." });
	functions.push_back({ "readFloatTable", { path }, ValueType::Array, read_table<true>, "The same as numbers; not a number where there is none." });
	add_choosing_functions(dialect);
}

} // namespace pcg::cga
