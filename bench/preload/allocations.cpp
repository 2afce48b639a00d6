// Counts what one thread takes from the heap, for scripts: loaded before the engine (LD_PRELOAD), it answers for two environment variables,
// PCG_ALLOCATIONS (of everybody) and PCG_PLUGIN_ALLOCATIONS (called by the plugin itself), with the counts of the thread that asks.
#include <cstdint>
#include <cstdio>
#include <cstring>

#include <dlfcn.h>
#include <link.h>
#include <sys/mman.h>

extern "C" {
void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *memory, size_t size);
}

namespace {

thread_local uint64_t all = 0, by_plugin = 0;
bool has_plugin = false;

void *plugin_malloc(size_t size) {
	++all, ++by_plugin;
	return __libc_malloc(size);
}

void *plugin_calloc(size_t number, size_t size) {
	++all, ++by_plugin;
	return __libc_calloc(number, size);
}

void *plugin_realloc(void *memory, size_t size) {
	++all, ++by_plugin;
	return __libc_realloc(memory, size);
}

// The engine loads plugins so that they find the C library's own functions first: theirs are put into the plugin's table of imported functions.
void redirect(uintptr_t base, const ElfW(Rela) *begin, size_t bytes, const ElfW(Sym) *symbols, const char *names) {
	static const struct {
		const char *name;
		void *function;
	} wanted[] = { { "malloc", reinterpret_cast<void *>(plugin_malloc) }, { "calloc", reinterpret_cast<void *>(plugin_calloc) },
		{ "realloc", reinterpret_cast<void *>(plugin_realloc) } };
	for (const ElfW(Rela) *entry = begin; entry != begin + bytes / sizeof(*entry); ++entry) {
		const uint32_t symbol = uint32_t(ELF64_R_SYM(entry->r_info));
		for (const auto &one : wanted) {
			if (symbol != 0 && std::strcmp(names + symbols[symbol].st_name, one.name) == 0) {
				const uintptr_t slot = base + entry->r_offset, page = slot & ~uintptr_t(4095);
				mprotect(reinterpret_cast<void *>(page), 8192, PROT_READ | PROT_WRITE);
				*reinterpret_cast<void **>(slot) = one.function;
			}
		}
	}
}

int find_plugin(dl_phdr_info *library, size_t, void *) {
	if (std::strstr(library->dlpi_name, "libpcg") == nullptr) {
		return 0;
	}
	has_plugin = true;
	uintptr_t found[DT_NUM] = {}; // of the dynamic section, by tag
	for (int i = 0; i < library->dlpi_phnum; ++i) {
		if (library->dlpi_phdr[i].p_type == PT_DYNAMIC) {
			for (const auto *tag = reinterpret_cast<const ElfW(Dyn) *>(library->dlpi_addr + library->dlpi_phdr[i].p_vaddr); tag->d_tag != DT_NULL; ++tag) {
				if (tag->d_tag < DT_NUM) {
					found[tag->d_tag] = tag->d_un.d_ptr;
				}
			}
		}
	}
	const auto *symbols = reinterpret_cast<const ElfW(Sym) *>(found[DT_SYMTAB]);
	const char *names = reinterpret_cast<const char *>(found[DT_STRTAB]);
	redirect(library->dlpi_addr, reinterpret_cast<const ElfW(Rela) *>(found[DT_JMPREL]), found[DT_PLTRELSZ], symbols, names);
	redirect(library->dlpi_addr, reinterpret_cast<const ElfW(Rela) *>(found[DT_RELA]), found[DT_RELASZ], symbols, names);
	return 1;
}

} // namespace

#pragma GCC visibility push(default) // the build hides everything else
extern "C" {

void *malloc(size_t size) {
	++all;
	return __libc_malloc(size);
}

void *calloc(size_t number, size_t size) {
	++all;
	return __libc_calloc(number, size);
}

void *realloc(void *memory, size_t size) {
	++all;
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
	if (!has_plugin) {
		dl_iterate_phdr(find_plugin, nullptr);
	}
	std::snprintf(text, sizeof(text), "%llu", static_cast<unsigned long long>(is_plugins ? by_plugin : all));
	return text;
}

} // extern "C"
#pragma GCC visibility pop
