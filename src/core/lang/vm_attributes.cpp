#include <algorithm>

#include "core/lang/opcode.h"
#include "core/lang/vm.h"

// Attributes: values, overrides, calls of an import with attributes of their own, and names that are made while running (CGA reference, sections 1.7 and 7.8).
namespace pcg {

namespace {

// Stands in an attribute's place while it is being evaluated.
const Value in_evaluation = Value::of_index(ValueType::Chunk, no_symbol);

bool is_in_evaluation(const Value &value) { return value.type == ValueType::Chunk; }

} // namespace

bool Vm::override_attribute(std::string_view name, Value value) {
	const int index = _program->find_attribute(name);
	if (index < 0) {
		return false;
	}
	const AttributeInfo &info = _program->attributes[size_t(index)];
	if (info.kind == AttributeInfo::Kind::Constant || (info.type != ValueType::Void && info.type != value.type)) {
		return false;
	}
	if (value.is_text()) { // The host's text need not live as long as the override.
		const uint32_t symbol = _program->find_text(value.text->view);
		if (symbol != no_symbol) {
			value = Value::of(&_program->texts[symbol]);
		} else {
			made().override_storage.emplace_back(value.text->view);
			_made->override_texts.push_back({ _made->override_storage.back(), no_symbol });
			value = Value::of(&_made->override_texts.back());
		}
	}
	_initial_attributes[size_t(index)] = value;
	_own_attributes[size_t(index)] = value;
	return true;
}

void Vm::clear_overrides() {
	reset_initial_attributes();
	std::copy(_initial_attributes.begin(), _initial_attributes.end(), _own_attributes.begin());
	if (_made) {
		_made->override_texts.clear();
		_made->override_storage.clear();
	}
}

Value Vm::attribute(int index) {
	if (index < 0 || size_t(index) >= _program->attributes.size()) {
		return Value();
	}
	return load_attribute(uint32_t(index));
}

void Vm::evaluate_attributes() {
	for (uint32_t i = 0; i < _program->attributes.size() && !_failed; ++i) {
		load_attribute(i);
	}
}

const Value &Vm::load_attribute(uint32_t index) {
	Value &value = _attributes[index];
	if (!value.is_void() && !is_in_evaluation(value)) {
		return value;
	}
	if (is_in_evaluation(value)) {
		fail("attribute-cycle", "the value of `" + _program->attributes[index].name + "` depends on itself",
				"give one of the values on the way a number or text of its own");
		return value;
	}
	value = in_evaluation;
	Value result = evaluate_attribute(index);
	return _attributes[index] = result;
}

Value Vm::evaluate_attribute(uint32_t index) {
	const AttributeInfo &info = _program->attributes[index];
	Border border;
	Value result;
	if (enter_native(border)) {
		Random own(_seed, hash_text(info.name));
		Random *const callers = _random;
		_random = &own;
		hide_slots();
		_base = uint32_t(_top - _stack);
		_address = uint32_t(info.code);
		if (run() == Stop::Returned && !_failed) {
			result = _top[-1];
		}
		_random = callers;
	}
	leave_native(border);
	return result;
}

// The attributes of the import are what its file says again, but for those that the call gives. They hold until the frame ends, and for what
// the host hands on from here: shapes carry their attributes.
bool Vm::begin_import(const ImportScope &scope, std::span<const Value> values) {
	_frames.push_back({ VmFrame::Kind::Import, 0, 0, _base, uint32_t(_trail.size()) });
	_outer_attributes.push_back(_attributes);
	_host->push_group(*this);
	Value *own = _host->copy_attributes(*this);
	if (own == nullptr) {
		made().import_attributes.emplace_back(_attributes, _attributes + _program->attributes.size());
		own = _made->import_attributes.back().data();
	}
	_attributes = own;
	for (uint32_t attribute : scope.attributes) {
		own[attribute] = _initial_attributes[attribute];
	}
	for (size_t i = 0; i < values.size(); ++i) {
		own[scope.overridden[i]] = values[i];
	}
	for (uint32_t attribute : scope.attributes) {
		if (!_failed) {
			load_attribute(attribute);
		}
	}
	return !_failed;
}

// A step that is no call of a rule or function is a block's or condition's, which a built-in asks for once for each of many.
bool Vm::fail_steps() {
	const OpCode last = _address > 0 ? _program->code[_address - 1].code : OpCode::End;
	const bool is_call = last == OpCode::CallRule || last == OpCode::CallHostRule || last == OpCode::CallUser;
	fail("step-limit", "gave up after " + std::to_string(_limits.max_steps) + " calls in one run",
			_native_depth > 1 || !is_call ? "blocks and conditions run inside of each other here, and their numbers multiply: ask once beforehand and keep the answer"
										  : "do rules call each other without an end?");
	return false;
}

Value Vm::find_target(std::string_view prefix, const Value &name) {
	const std::string_view text = name.is_text() ? name.text->view : std::string_view();
	const int attribute = _program->find_attribute(std::string(prefix) + std::string(text));
	if (attribute >= 0 && _program->attributes[size_t(attribute)].kind != AttributeInfo::Kind::Constant) {
		return Value::of_index(ValueType::Attribute, uint32_t(attribute));
	}
	const int variable = _program->dialect->find_variable(text);
	if (variable >= 0 && _program->dialect->variables[size_t(variable)].is_writable) {
		return Value::of_index(ValueType::Variable, uint32_t(variable));
	}
	return mismatch("unknown-name", "there is no attribute `" + std::string(text) + "` to set", Value());
}

Value Vm::find_word(std::string_view words, const Value &word) {
	const std::string_view wanted = word.is_text() ? word.text->view : std::string_view();
	uint32_t position = 0;
	for (size_t start = 0; start < words.size(); ++position) {
		const size_t end = std::min(words.find(' ', start), words.size());
		if (words.substr(start, end - start) == wanted) {
			return Value::of_index(ValueType::Word, position);
		}
		start = end + 1;
	}
	return mismatch("unknown-word", "`" + std::string(wanted) + "` is none of: " + std::string(words), Value::of_index(ValueType::Word, 0));
}

} // namespace pcg
