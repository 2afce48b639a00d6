#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/agenda/context.h"
#include "core/agenda/task.h"
#include "core/base/diagnostic.h"
#include "core/base/random.h"
#include "core/lang/dialect.h"

// Functions and operations that a host adds to the agenda language (PCG language, section 4): a game that knows which shops are open lets rules
// ask isOpen(shop). Name, number and types of arguments are checked when a rule file is loaded, like those of everything built in.
namespace pcg {

enum class HostType : uint8_t { Number, Bool, Text };
using HostValue = std::variant<double, bool, std::string>; // in the order of HostType

struct HostParam {
	std::string name;
	HostType type = HostType::Number;
	bool is_optional = false; // only at the end of the list
};

// One call of a host's function or operation. Arguments are of the types that were registered.
class HostCall {
public:
	HostCall(Vm &vm, const Args &args, std::string_view name) : _vm(vm), _args(args), _name(name) {}

	size_t count() const { return _args.count(); } // optional arguments may be missing
	double number(size_t i) const { return _args.number(i); }
	bool truth(size_t i) const { return _args[i].boolean; }
	std::string_view text(size_t i) const { return _args[i].text->view; }

	const agenda::Context &context() const { return agenda::context_of(_vm); } // household, focused person, city; is_simulating()
	Random &random() const { return _vm.random(); } // the household's stream, or the person's at simulation time
	// Ends the household's rules, or the delayed rule, with an error at the place of the call.
	void fail(std::string message, std::string hint = {}) const { _vm.fail("host-error", std::move(message), std::move(hint)); }
	void warn(std::string message, std::string hint = {}) const { _vm.warn("host-warning", std::move(message), std::move(hint)); }
	// For operations: an entry of the focused person, as from goToBuilding(t0, t1, building), with the days and requirements that hold at the call.
	// Does nothing while the simulation runs.
	void insert(TaskKind kind, double start, double end, uint32_t target) const;

private:
	Vm &_vm;
	const Args &_args;
	std::string_view _name;
};

// While agendas are generated `call` is called from several threads at once, unless WorkOptions::threads is 1.
struct HostFunction {
	std::string name;
	std::vector<HostParam> params;
	HostType result = HostType::Number;
	std::function<HostValue(HostCall &)> call;
	std::string help;
};

struct HostOperation {
	std::string name;
	std::vector<HostParam> params;
	Phase phase = Phase::Generation;
	std::function<void(HostCall &)> call;
	std::string help;
};

// A dialect with what a host added. Outlives the programs that are compiled for it.
class HostDialect {
public:
	explicit HostDialect(const Dialect &base) : _dialect(base) {}
	HostDialect(const HostDialect &) = delete;
	HostDialect &operator=(const HostDialect &) = delete;

	// False, with an error: the name is no name or taken, an optional parameter stands before one that is not, or `call` is empty.
	bool add(HostFunction function, Diagnostics &diagnostics);
	bool add(HostOperation operation, Diagnostics &diagnostics);
	const Dialect &dialect() const { return _dialect; }

private:
	template <typename Spec> bool is_sound(const Spec &spec, Diagnostics &diagnostics) const;

	Dialect _dialect;
	std::deque<HostFunction> _functions; // never move: the dialect refers to them
	std::deque<HostOperation> _operations;
};

} // namespace pcg
