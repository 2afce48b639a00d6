// Counts what one thread takes from the heap, for scripts: loaded before the engine (LD_PRELOAD), it answers for two environment variables,
// PCG_ALLOCATIONS (of everybody) and PCG_PLUGIN_ALLOCATIONS (called by the plugin itself), with the counts of the thread that asks.
#include <cstdint>
#include <cstdio>
#include <cstring>

#include <dlfcn.h>
#include <link.h>

extern "C" {
void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *memory, size_t size);
}

namespace {

thread_local uint64_t all = 0, by_plugin = 0;
uintptr_t plugin_begin = 0, plugin_end = 0;

void count(const void *caller) {
	const uintptr_t address = reinterpret_cast<uintptr_t>(caller);
	++all;
	by_plugin += address >= plugin_begin && address < plugin_end;
}

int find_plugin(dl_phdr_info *library, size_t, void *) {
	if (std::strstr(library->dlpi_name, "libpcg") == nullptr) {
		return 0;
	}
	for (int i = 0; i < library->dlpi_phnum; ++i) {
		const auto &part = library->dlpi_phdr[i];
		if (part.p_type == PT_LOAD && (part.p_flags & PF_X) != 0) {
			plugin_begin = library->dlpi_addr + part.p_vaddr;
			plugin_end = plugin_begin + part.p_memsz;
		}
	}
	return 1;
}

} // namespace

#pragma GCC visibility push(default) // the build hides everything else
extern "C" {

void *malloc(size_t size) {
	count(__builtin_return_address(0));
	return __libc_malloc(size);
}

void *calloc(size_t number, size_t size) {
	count(__builtin_return_address(0));
	return __libc_calloc(number, size);
}

void *realloc(void *memory, size_t size) {
	count(__builtin_return_address(0));
	return __libc_realloc(memory, size);
}

char *getenv(const char *name) {
	using Getenv = char *(*)(const char *);
	static const Getenv next = reinterpret_cast<Getenv>(dlsym(RTLD_NEXT, "getenv"));
	static thread_local char text[24];
	const bool is_plugins = std::strcmp(name, "PCG_PLUGIN_ALLOCATIONS") == 0;
	if (!is_plugins && std::strcmp(name, "PCG_ALLOCATIONS") != 0) {
		return next(name);
	}
	if (plugin_end == 0) {
		dl_iterate_phdr(find_plugin, nullptr);
	}
	std::snprintf(text, sizeof(text), "%llu", static_cast<unsigned long long>(is_plugins ? by_plugin : all));
	return text;
}

} // extern "C"
#pragma GCC visibility pop
