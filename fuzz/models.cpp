#include "core/io/asset_reader.h"
#include "core/io/image_info.h"
#include "core/io/mtl.h"
#include "core/io/obj.h"
#include "core/io/picture.h"
#include "core/io/text_asset.h"
#include "fuzz/fuzz.h"

using namespace pcg;

namespace {

constexpr AssetLimits limits{ .bytes = 1 << 20, .faces = 10'000 };

void read_model(const char *path, std::string bytes) {
	MemoryTree files;
	files.add("model.mtl", "newmtl red\nKd 1 0 0\nmap_Kd red.png\n");
	files.add(path, std::move(bytes));
	read_asset(files, path, limits);
	static_cast<void>(read_picture(files, std::string(path) + "#0", limits.bytes));
}

} // namespace

// The first byte says what kind of file that a rule may name the others are.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
	if (size == 0) {
		return 0;
	}
	const std::string text = fuzz::text_of(data + 1, size - 1);
	Diagnostics diagnostics;
	switch (data[0]) {
		case 'o': read_model("model.obj", text); break;
		case 'f': parse_obj(text, "model.obj", diagnostics); break;
		case 'g': read_model("model.gltf", text); break;
		case 'b': read_model("model.glb", text); break;
		case 'm': parse_mtl(text, "model.mtl"); break;
		case 't': parse_table(decode_text(text)); break;
		default:
			// Few pixels, so that time goes into readers.
			if (const ImageInfo info = read_image_info(text); uint64_t(info.size.x) * info.size.y < 100'000) {
				decode_picture(text);
			}
	}
	to_text(diagnostics);
	return 0;
}
