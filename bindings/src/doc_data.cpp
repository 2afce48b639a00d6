#include <godot_cpp/core/doc_data.hpp>

#include <algorithm>

#include <godot_cpp/godot.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>

namespace godot::internal {

namespace {

constexpr int64_t deflate = 1; // FileAccess::COMPRESSION_DEFLATE, which reads zlib's format

struct DocData {
	const unsigned char *data = nullptr;
	int compressed_size = 0;
	int uncompressed_size = 0;
};

// Constant-initialized, so it is there whenever the generated source registers its pages.
constinit DocData doc_data;

} // namespace

DocDataRegistration::DocDataRegistration(const char *, int p_uncompressed_size, int p_compressed_size,
                                         const unsigned char *p_data) {
	doc_data = { p_data, p_compressed_size, p_uncompressed_size };
}

void load_doc_data() {
	if (!doc_data.data) {
		return;
	}
	PackedByteArray packed;
	packed.resize(doc_data.compressed_size);
	std::copy_n(doc_data.data, doc_data.compressed_size, packed.ptrw());
	const PackedByteArray pages = packed.decompress(doc_data.uncompressed_size, deflate);
	engine.editor_help_load_xml_from_utf8_chars_and_len(reinterpret_cast<const char *>(pages.ptr()), pages.size());
}

} // namespace godot::internal
