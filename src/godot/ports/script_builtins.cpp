#include "godot/ports/script_builtins.h"

#include <map>

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/main_loop.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/string_name.hpp>

#include "core/agenda/host_builtins.h"
#include "core/sim/dialect.h"
#include "godot/convert.h"

using namespace godot;

namespace pcg {

namespace {

struct ScriptBuiltin {
	std::vector<HostParam> params;
	int result = -1; // a HostType; -1: an operation
};

// Name to Callable. Kept by the main loop, since that goes before the languages do: a Callable of a script must not outlive its language.
Dictionary callables() {
	const StringName key("_pcg_script_builtins");
	MainLoop *loop = Engine::get_singleton()->get_main_loop();
	if (loop == nullptr) {
		return Dictionary();
	}
	if (!loop->has_meta(key)) {
		loop->set_meta(key, Dictionary());
	}
	return loop->get_meta(key);
}

HostDialect &host_dialect() {
	static HostDialect host(pcg_dialect());
	return host;
}

std::map<std::string, ScriptBuiltin> &builtins() {
	static std::map<std::string, ScriptBuiltin> all;
	return all;
}

// -1: the agenda language has no such type.
int host_type(int64_t type) {
	switch (type) {
		case Variant::INT:
		case Variant::FLOAT:
			return int(HostType::Number);
		case Variant::BOOL:
			return int(HostType::Bool);
		case Variant::STRING:
			return int(HostType::Text);
		default:
			return -1;
	}
}

bool read_params(const std::string &name, const Dictionary &parameters, std::vector<HostParam> &params, Diagnostics &diagnostics) {
	const Array names = parameters.keys();
	for (int64_t i = 0; i < names.size(); ++i) {
		const int type = parameters[names[i]].get_type() == Variant::INT ? host_type(parameters[names[i]]) : -1;
		if (type < 0) {
			diagnostics.error("host-parameters", "parameter '" + from_godot(String(names[i])) + "' of '" + name + "' has no type of the agenda language",
					"give TYPE_FLOAT, TYPE_INT, TYPE_BOOL or TYPE_STRING, as in { \"building\": TYPE_INT }");
			return false;
		}
		params.push_back({ from_godot(String(names[i])), HostType(type), false });
	}
	return true;
}

bool is_same(const ScriptBuiltin &a, const ScriptBuiltin &b) {
	if (a.result != b.result || a.params.size() != b.params.size()) {
		return false;
	}
	for (size_t i = 0; i < a.params.size(); ++i) {
		if (a.params[i].type != b.params[i].type) {
			return false;
		}
	}
	return true;
}

// What the script gives; fails the call where it is gone.
Variant call_script(HostCall &call, const std::string &name) {
	const ScriptBuiltin &builtin = builtins()[name];
	const godot::Callable callable = callables().get(to_godot(std::string_view(name)), godot::Callable());
	if (!callable.is_valid()) {
		call.fail("the script behind '" + name + "' is gone", "add it anew before the rules run");
		return Variant();
	}
	Array arguments;
	const PersonId person = call.context().focus();
	arguments.push_back(is_valid(person) ? int64_t(index_of(person)) : int64_t(-1));
	for (size_t i = 0; i < call.count(); ++i) {
		switch (builtin.params[i].type) {
			case HostType::Number:
				arguments.push_back(call.number(i));
				break;
			case HostType::Bool:
				arguments.push_back(call.truth(i));
				break;
			case HostType::Text:
				arguments.push_back(to_godot(call.text(i)));
				break;
		}
	}
	return callable.callv(arguments);
}

HostValue function_value(HostCall &call, const std::string &name) {
	const Variant value = call_script(call, name);
	const int type = host_type(value.get_type());
	if (type != builtins()[name].result) {
		call.fail("the script behind '" + name + "' gave " + from_godot(Variant::get_type_name(value.get_type())) + " and not what was promised",
				"give back a value of the type that it was added with");
		return 0.0;
	}
	switch (HostType(type)) {
		case HostType::Number:
			return double(value);
		case HostType::Bool:
			return bool(value);
		case HostType::Text:
			return from_godot(String(value));
	}
	return 0.0;
}

void write_entry(HostCall &call, const std::string &name, const Dictionary &entry) {
	const String kind = entry.get("kind", "goToBuilding");
	const BuildingId building = call.context().building_of(double(entry.get("building", -1)));
	if ((kind != "goToBuilding" && kind != "stayInside") || !is_valid(building) || !entry.has("start") || !entry.has("end")) {
		call.fail("the script behind '" + name + "' gave an entry that is none",
				"an entry has a `kind` (\"goToBuilding\" or \"stayInside\"), a `building`, a `start` and an `end`");
		return;
	}
	call.insert(kind == "stayInside" ? TaskKind::StayInside : TaskKind::GoToBuilding, double(entry["start"]), double(entry["end"]), index_of(building));
}

void run_operation(HostCall &call, const std::string &name) {
	const Variant given = call_script(call, name);
	Array entries;
	if (given.get_type() == Variant::ARRAY) {
		entries = given;
	} else if (given.get_type() == Variant::DICTIONARY) {
		entries.push_back(given);
	}
	for (int64_t i = 0; i < entries.size(); ++i) {
		write_entry(call, name, entries[i]);
	}
}

// False: it is new, and the language has to learn it.
bool is_known(const std::string &name, const ScriptBuiltin &builtin) {
	const auto known = builtins().find(name);
	return known != builtins().end() && is_same(known->second, builtin);
}

} // namespace

const Dialect &agenda_dialect() { return host_dialect().dialect(); }
bool has_script_builtins() { return !builtins().empty(); }

bool add_script_function(const String &p_name, const Dictionary &parameters, Variant::Type result, const godot::Callable &function, Diagnostics &diagnostics) {
	const std::string name = from_godot(p_name);
	ScriptBuiltin builtin;
	builtin.result = host_type(result);
	if (builtin.result < 0) {
		diagnostics.error("host-parameters", "'" + name + "' has a result that the agenda language does not know", "give TYPE_FLOAT, TYPE_BOOL or TYPE_STRING");
		return false;
	}
	if (!read_params(name, parameters, builtin.params, diagnostics)) {
		return false;
	}
	if (!is_known(name, builtin)) {
		const auto call = [name](HostCall &host_call) { return function_value(host_call, name); };
		if (!host_dialect().add(HostFunction{ name, builtin.params, HostType(builtin.result), call, "Added by a script." }, diagnostics)) {
			return false;
		}
		builtins()[name] = builtin;
	}
	callables()[p_name] = function;
	return true;
}

bool add_script_operation(const String &p_name, const Dictionary &parameters, const godot::Callable &function, Diagnostics &diagnostics) {
	const std::string name = from_godot(p_name);
	ScriptBuiltin builtin;
	if (!read_params(name, parameters, builtin.params, diagnostics)) {
		return false;
	}
	if (!is_known(name, builtin)) {
		const auto call = [name](HostCall &host_call) { run_operation(host_call, name); };
		if (!host_dialect().add(HostOperation{ name, builtin.params, Phase::Generation, call, "Added by a script." }, diagnostics)) {
			return false;
		}
		builtins()[name] = builtin;
	}
	callables()[p_name] = function;
	return true;
}

} // namespace pcg
