#include <algorithm>
#include <string>
#include <vector>

#include "core/cga/functions/functions.h"
#include "core/lang/vm.h"

// String lists: items in one text, each followed by a semicolon (CGA reference, section 8.1). Where the last one is missing, the item is there for
// sizes and indices, but as in CityEngine's own library nothing finds it that goes by how items end; a list in which nothing is found stays as it is.
namespace pcg::cga {

namespace {

using Items = std::vector<std::string_view>;

Items items_of(std::string_view list) {
	Items items;
	while (!list.empty()) {
		const size_t end = std::min(list.find(';'), list.size());
		items.push_back(list.substr(0, end));
		list.remove_prefix(std::min(end + 1, list.size()));
	}
	return items;
}

Items items_at(const Args &args) { return items_of(text_at(args, 0)); }

Value make_list(Vm &vm, const Items &items) {
	std::string text;
	for (const std::string_view item : items) {
		text.append(item) += ';';
	}
	return Value::of(vm.make_text(text));
}

Value item_at(Vm &vm, const Items &items, double index) {
	const bool is_there = index >= 0.0 && index < double(items.size());
	return Value::of(vm.make_text(is_there ? items[size_t(index)] : std::string_view()));
}

// With * in front or behind anything may stand there.
bool fits(std::string_view pattern, std::string_view item) {
	const bool is_open_before = pattern.starts_with('*');
	pattern.remove_prefix(is_open_before ? 1 : 0);
	const bool is_open_behind = pattern.ends_with('*');
	pattern.remove_suffix(is_open_behind ? 1 : 0);
	if (is_open_before && is_open_behind) {
		return item.find(pattern) != std::string_view::npos;
	}
	return is_open_before ? item.ends_with(pattern) : is_open_behind ? item.starts_with(pattern) : item == pattern;
}

Value list_item(Vm &vm, const Args &args) { return item_at(vm, items_at(args), args[1].number); }
Value list_first(Vm &vm, const Args &args) { return item_at(vm, items_at(args), 0.0); }
Value list_last(Vm &vm, const Args &args) { return item_at(vm, items_at(args), double(items_at(args).size()) - 1.0); }
Value list_size(Vm &, const Args &args) { return Value::of(double(items_at(args).size())); }

Value list_random(Vm &vm, const Args &args) {
	const Items items = items_at(args);
	return item_at(vm, items, double(vm.random().index(items.size())));
}

// Number of the first item that fits; that of items: none.
size_t place_of(const Items &items, const Args &args) {
	const std::string_view list = text_at(args, 0), pattern = text_at(args, 1);
	const size_t first = size_t(std::ranges::find_if(items, [&](std::string_view item) { return fits(pattern, item); }) - items.begin());
	const bool is_open = first + 1 == items.size() && !list.ends_with(';') && !pattern.ends_with('*');
	return is_open ? items.size() : first;
}

Value list_index(Vm &, const Args &args) {
	const Items items = items_at(args);
	const size_t place = place_of(items, args);
	return Value::of(place == items.size() ? -1.0 : double(place));
}

Value list_count(Vm &, const Args &args) {
	const Items items = items_at(args);
	const auto from = items.begin() + long(place_of(items, args));
	return Value::of(double(std::count_if(from, items.end(), [&](std::string_view item) { return fits(text_at(args, 1), item); })));
}

Value list_range(Vm &vm, const Args &args) {
	const Items items = items_at(args);
	Items chosen;
	for (size_t i = 0; i < items.size(); ++i) {
		if (double(i) >= args[1].number && double(i) < args[2].number) {
			chosen.push_back(items[i]);
		}
	}
	return make_list(vm, chosen);
}

Value list_add(Vm &vm, const Args &args) {
	Items items = items_at(args);
	const Items more = items_of(text_at(args, 1));
	items.insert(items.end(), more.begin(), more.end());
	return make_list(vm, items);
}

Value list_remove(Vm &vm, const Args &args) {
	Items items = items_at(args);
	const size_t place = place_of(items, args);
	if (place == items.size()) {
		return args[0];
	}
	items.erase(items.begin() + long(place));
	return make_list(vm, items);
}

template <bool keeps> Value list_filter(Vm &vm, const Args &args) {
	Items items = items_at(args);
	if (place_of(items, args) == items.size()) {
		return keeps ? Value::of(vm.make_text("")) : args[0];
	}
	std::erase_if(items, [&](std::string_view item) { return fits(text_at(args, 1), item) != keeps; });
	return make_list(vm, items);
}

Value list_clean(Vm &vm, const Args &args) {
	Items items = items_at(args);
	std::erase_if(items, [](std::string_view item) { return item.empty(); });
	return make_list(vm, items);
}

Value list_terminate(Vm &vm, const Args &args) { return make_list(vm, items_at(args)); }

Value list_to_array(Vm &vm, const Args &args) {
	std::vector<Value> values;
	for (const std::string_view item : items_at(args)) {
		if (values.size() < max_array_size) {
			values.push_back(Value::of(vm.make_text(item)));
		}
	}
	return Value::of(vm.make_array(values, 1, ValueType::Text));
}

Value list_from_array(Vm &vm, const Args &args) {
	const ArrayData &array = *args[0].array;
	std::string text;
	for (uint32_t i = 0; i < array.size(); ++i) {
		text += value_text(array.values[i]) + ";";
	}
	return Value::of(vm.make_text(text));
}

} // namespace

void add_list_functions(Dialect &dialect) {
	using enum ParamKind;
	auto &functions = dialect.functions;
	const ParamSpec list = { "list", Text }, item = { "item", Text }, index = { "index", Number };
	constexpr ValueType text = ValueType::Text, number = ValueType::Number;
	functions.push_back({ "listItem", { list, index }, text, list_item, "The item of that number, from 0, of a list such as \"a;b;c;\"; empty if there is none." });
	functions.push_back({ "listFirst", { list }, text, list_first, "The first item of a list." });
	functions.push_back({ "listLast", { list }, text, list_last, "The last item of a list." });
	functions.push_back({ "listRandom", { list }, text, list_random, "Any item of a list, all equally likely." });
	functions.push_back({ "listSize", { list }, number, list_size, "How many items a list has." });
	functions.push_back({ "listIndex", { list, item }, number, list_index, "Number of the first item that fits, or -1; * at its ends stands for anything." });
	functions.push_back({ "listCount", { list, item }, number, list_count, "How many items fit; * at its ends stands for anything." });
	functions.push_back({ "listRange", { list, { "from", Number }, { "to", Number } }, text, list_range, "The items from one number to before another." });
	functions.push_back({ "listAdd", { list, item }, text, list_add, "The list with one item more, or with those of another list." });
	functions.push_back({ "listRemove", { list, item }, text, list_remove, "The list without the first item that fits; * at its ends stands for anything." });
	functions.push_back({ "listRemoveAll", { list, item }, text, list_filter<false>, "The list without all items that fit." });
	functions.push_back({ "listRetainAll", { list, item }, text, list_filter<true>, "The items of the list that fit." });
	functions.push_back({ "listClean", { list }, text, list_clean, "The list without empty items, with its last semicolon." });
	functions.push_back({ "listTerminate", { list }, text, list_terminate, "The list with its last semicolon." });
	functions.push_back({ "listToArray", { list }, ValueType::Array, list_to_array, "The items as an array of texts." });
	functions.push_back({ "listFromArray", { { "array", Array } }, text, list_from_array, "The elements of an array as a list." });
}

} // namespace pcg::cga
