#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/base/ids.h"
#include "core/lang/dialect.h"
#include "core/lang/source.h"
#include "core/lang/value.h"

// A rule set compiled for one dialect: flat code, no names left to look up while it runs. Immutable after compilation and shared by threads.
namespace pcg {

// Where a piece of source stands. `file` indexes Program::files.
struct SourcePlace {
	uint32_t file = 0;
	uint32_t line = 0;
	uint32_t column = 0;
};

enum class OpCode : uint8_t;

struct Instruction {
	OpCode code;
	uint8_t count = 0; // arguments
	uint16_t extra = 0;
	uint32_t operand = 0;
};
static_assert(sizeof(Instruction) == 8);

// A piece of code by the address of its first instruction; it ends with a Return.
enum class Chunk : uint32_t { None = 0xFFFFFFFF };

struct Annotation {
	std::string name; // "Range", without the @
	std::vector<std::string> arguments; // text of each, strings without quotes; "min=0" keeps its name
};

struct RuleInfo {
	std::string name; // with the import's prefix: "day.Household"
	std::vector<std::string> params;
	Chunk code = Chunk::None;
	SourcePlace place;
	std::vector<Annotation> annotations;
	bool is_start = false;
	bool is_replaced = false; // a style or an importing file has another rule of this name: nothing finds this one by it
	bool is_leaf_symbol = false; // CGA: a called name without a rule
	bool has_paper_arrow = false; // written with `->` as in the paper's listings, which CityEngine does not know
};

// A rule or a function as the interpreter calls it.
struct Callable {
	Chunk code = Chunk::None;
	uint32_t param_count = 0;
	uint32_t frame_size = 0; // with lexical locals: parameters and `with` values, which lie on the stack while it runs
	uint32_t first_slot = 0; // with dynamic locals: the slots of its parameters lie at Program::param_slots[first_slot..]
};

// `attr` and plain names may be overridden by the host, `const` may not.
struct AttributeInfo {
	std::string name;
	enum class Kind : uint8_t { Attribute, Plain, Constant } kind = Kind::Attribute;
	Chunk code = Chunk::None;
	SourcePlace place;
	std::vector<Annotation> annotations;
	ValueType type = ValueType::Void; // as far as known without running
	std::string default_text; // the value as the rules write it
};

// One entry of a selector block. Entries of one block lie one behind the other in Program::entries.
struct BlockEntry {
	enum class Kind : uint8_t { Body, Repeat, Group } kind = Kind::Body; // Repeat and Group hold a nested block: {..}* and {..}
	enum class Separator : uint8_t { Each, All, Connected } separator = Separator::Each; // ':' '=' '=:'
	// Size, predicate or selector expression. A selector that is one bare name has its symbol in `word` ("front", "street.back", "all"),
	// and a head too if the rule set defines that name: the dialect's own selectors come first. A split entry without a size has neither.
	Chunk head = Chunk::None;
	uint32_t word = no_symbol; // index in Program::texts
	Chunk depth = Chunk::None; // size : depth : body
	Chunk body = Chunk::None; // of functions an expression
	uint32_t block = 0; // of Repeat and Group: index in Program::blocks
	SourcePlace place;
};

struct Block {
	uint32_t first_entry = 0;
	uint32_t entry_count = 0;
	bool is_repeated = false; // the `*` behind the block
};

// The attributes that a call such as imp(a = 1).Rule gives anew, and which of them get the values that are written there.
struct ImportScope {
	std::vector<uint32_t> attributes;
	std::vector<uint32_t> overridden;
};

struct Program {
	const Dialect *dialect = nullptr; // outlives the program
	std::vector<std::string> files;
	std::vector<Instruction> code;
	std::vector<SourcePlace> places; // one for each instruction
	std::vector<Value> constants;
	std::vector<Callable> callables; // rules first, by RuleId; then user functions
	std::vector<uint32_t> param_slots;
	std::deque<Text> texts; // the text table; a symbol is an index here
	std::vector<RuleInfo> rules;
	std::vector<AttributeInfo> attributes;
	std::vector<Block> blocks;
	std::vector<BlockEntry> entries;
	std::vector<ImportScope> import_scopes;
	std::vector<std::string> styles; // of the main file, in its order, without Default
	uint32_t slot_count = 0; // dynamic locals
	std::vector<std::string> slot_names;
	uint32_t max_stack = 0; // values that any one chunk needs at most
	uint64_t fingerprint = 0; // of code and constants: saved runs fit no other program
	RuleId start_rule = RuleId::Invalid; // the default start, the first that is marked; Invalid if none is
	std::deque<std::string> text_storage; // owns what `texts` views
	std::vector<std::vector<Value>> array_storage; // owns what constant arrays view
	std::deque<ArrayData> arrays;
	std::vector<std::shared_ptr<const Source>> sources; // same order as `files`: for the lines in run-time messages

	// Invalid if there is none. Matching is exact.
	RuleId find_rule(std::string_view name, size_t param_count = 0) const;
	// The symbol of a text that the rules mention, or no_symbol: for hosts that look names up once per program.
	uint32_t find_text(std::string_view text) const;
	// -1 if there is none.
	int find_attribute(std::string_view name) const;
};

// For hosts that need a default start: `start_rule`, or an error that says where one could be marked (PCG language, section 1).
RuleId require_start_rule(const Program &program, Diagnostics &diagnostics);

} // namespace pcg
