#pragma once

#include <cassert>
#include <optional>
#include <utility>

#include "core/base/diagnostic.h"

namespace pcg {

// Either a value or the one reason why there is none. For steps that can have many reasons, pass a Diagnostics instead.
template <typename T> class [[nodiscard]] Result {
public:
	Result(T value) : _value(std::move(value)) {}
	Result(Diagnostic diagnostic) : _diagnostic(std::move(diagnostic)) {}

	bool is_ok() const { return _value.has_value(); }
	explicit operator bool() const { return is_ok(); }
	T &value() {
		assert(is_ok());
		return *_value;
	}
	const T &value() const {
		assert(is_ok());
		return *_value;
	}
	T &operator*() { return value(); }
	const T &operator*() const { return value(); }
	T *operator->() { return &value(); }
	const T *operator->() const { return &value(); }
	// Only of a Result that is not ok.
	const Diagnostic &diagnostic() const {
		assert(!is_ok());
		return _diagnostic;
	}

private:
	std::optional<T> _value;
	Diagnostic _diagnostic;
};

} // namespace pcg
