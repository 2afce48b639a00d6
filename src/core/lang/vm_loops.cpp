#include <algorithm>
#include <cstddef>

#include "core/lang/opcode.h"
#include "core/lang/vm.h"

// Rules whose last command calls a rule, themselves even: loops that must not pile up frames.
namespace pcg {

// Whether a rule that goes on there has nothing left to do.
bool Vm::only_ends(uint32_t address) const {
	while (_program->code[address].code == OpCode::Jump) {
		address += 1 + uint32_t(_program->code[address].operand);
	}
	return _program->code[address].code == OpCode::End;
}

void Vm::drop_finished_callers() {
	if (_native_depth != 1 || _program->dialect->locals != Dialect::Locals::Dynamic) {
		return;
	}
	size_t kept = 0;
	for (VmFrame frame : _frames) {
		const bool was_last_call = kept > 1 && frame.kind == VmFrame::Kind::Rule && _frames[kept - 1].kind == VmFrame::Kind::Rule &&
				only_ends(frame.return_address);
		if (was_last_call) { // returns for its caller, too
			const VmFrame &caller = _frames[--kept];
			frame.return_address = caller.return_address;
			frame.base = caller.base;
			frame.trail_mark = caller.trail_mark;
			--_call_depth;
		}
		_frames[kept++] = frame;
	}
	if (kept < _frames.size()) {
		_frames.resize(kept);
		drop_repeated_trail();
	}
}

// What one frame restores twice: the older value counts.
void Vm::drop_repeated_trail() {
	size_t from = _frames[0].trail_mark, to = from;
	for (size_t i = 0; i < _frames.size(); ++i) {
		const size_t end = i + 1 < _frames.size() ? _frames[i + 1].trail_mark : _trail.size();
		const size_t first = to;
		for (; from < end; ++from) {
			const bool is_repeated = std::any_of(_trail.begin() + ptrdiff_t(first), _trail.begin() + ptrdiff_t(to),
					[&](const VmTrailEntry &entry) { return entry.slot == _trail[from].slot; });
			if (!is_repeated) {
				_trail[to++] = _trail[from];
			}
		}
		_frames[i].trail_mark = uint32_t(first);
	}
	_trail.erase(_trail.begin() + ptrdiff_t(to), _trail.end());
}

} // namespace pcg
