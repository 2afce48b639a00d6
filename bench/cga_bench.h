#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "bench/figure.h"
#include "core/cga/derivation.h"
#include "core/cga/dialect.h"
#include "core/io/file_assets.h"
#include "core/io/rule_loader.h"

// What the benches of derivations share: rules to derive, and the models and pictures that they name, made here.
namespace pcg::bench {

// Boxes as text of an OBJ file, with texture coordinates and two materials.
class ObjText {
public:
	// Without the two faces across `open_axis`; -1: with all.
	void box(glm::dvec3 low, glm::dvec3 high, int open_axis = -1) {
		static constexpr int faces[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };
		for (int corner = 0; corner < 8; ++corner) {
			line("v %g %g %g\n", (corner & 1 ? high : low).x, (corner & 2 ? high : low).y, (corner & 4 ? high : low).z);
		}
		_text += _boxes % 4 == 3 ? "usemtl detail\n" : "usemtl body\n";
		for (int i = 0; i < 6; ++i) {
			if (i / 2 != open_axis) {
				line("f %g/1 %g/2 %g/3", 8.0 * _boxes + faces[i][0] + 1, 8.0 * _boxes + faces[i][1] + 1, 8.0 * _boxes + faces[i][2] + 1);
				line(" %g/4\n", 8.0 * _boxes + faces[i][3] + 1, 0.0, 0.0);
			}
		}
		++_boxes;
	}
	// Bars around a hole, and as many upright ones within.
	static std::string frame(int upright_bars) {
		ObjText text;
		text.box({ 0.0, 0.0, 0.0 }, { 1.0, 0.06, 0.1 }, 0);
		text.box({ 0.0, 0.94, 0.0 }, { 1.0, 1.0, 0.1 }, 0);
		text.box({ 0.0, 0.06, 0.0 }, { 0.06, 0.94, 0.1 }, 1);
		text.box({ 0.94, 0.06, 0.0 }, { 1.0, 0.94, 0.1 }, 1);
		for (int i = 0; i < upright_bars; ++i) {
			const double x = (i + 1.0) / (upright_bars + 1.0);
			text.box({ x - 0.02, 0.06, 0.02 }, { x + 0.02, 0.94, 0.08 }, 1);
		}
		return text._text;
	}
	// Boxes one on the other.
	static std::string pile(int boxes) {
		ObjText text;
		for (int i = 0; i < boxes; ++i) {
			const double inset = 0.06 * (i % 3);
			text.box({ inset, double(i) / boxes, inset }, { 1.0 - inset, (i + 1.0) / boxes, 1.0 - inset });
		}
		return text._text;
	}

private:
	void line(const char *format, double a, double b, double c) {
		char buffer[128];
		std::snprintf(buffer, sizeof(buffer), format, a, b, c);
		_text += buffer;
	}

	std::string _text = "mtllib model.mtl\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
	int _boxes = 0;
};

// An RGB picture of one pixel, as far as its size and kind are asked for.
inline std::string png_text() {
	return std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x8\2\0\0\0\x90wS\xde\0\0\0\0IEND\xae" "B`\x82", 45);
}

// In the files of a project around bench/rules/.
inline std::shared_ptr<const FileTree> asset_files() {
	auto files = std::make_shared<MemoryTree>();
	const std::string folder = "bench/assets/";
	const std::pair<const char *, std::string> models[] = { { "windows/frame", ObjText::frame(0) }, { "windows/casement", ObjText::frame(1) },
		{ "windows/double_casement", ObjText::frame(3) }, { "windows/dormer_window", ObjText::frame(1) }, { "balconies/railing", ObjText::frame(8) },
		{ "balconies/bracket", ObjText::pile(3) }, { "balconies/planter", ObjText::pile(2) }, { "doors/panel_door", ObjText::frame(2) },
		{ "roofs/chimney", ObjText::pile(5) }, { "roofs/dormer_window", ObjText::frame(1) }, { "roofs/aerial", ObjText::pile(4) } };
	for (const auto &[name, text] : models) {
		files->add(folder + name + ".obj", text);
		files->add(folder + std::string(name).substr(0, std::string(name).find('/')) + "/model.mtl",
				"newmtl body\nKd 0.8 0.8 0.8\nnewmtl detail\nKd 0.3 0.3 0.35\nmap_Kd detail.png\n");
		files->add(folder + std::string(name).substr(0, std::string(name).find('/')) + "/detail.png", png_text());
	}
	for (const char *name : { "facades/plaster_a.png", "facades/plaster_b.png", "facades/stone.png", "facades/dirt.png", "windows/glass.png",
				 "windows/curtain.png", "roofs/slate.png", "roofs/gravel.png", "shops/display.png", "street/paving.png" }) {
		files->add(folder + name, png_text());
	}
	return files;
}

inline cga::DeriveOptions options() {
	static const FileAssets assets({}, asset_files());
	cga::DeriveOptions result;
	result.assets = &assets;
	return result;
}

inline std::shared_ptr<const Program> compiled(const std::string &text) {
	MemorySourceProvider provider;
	provider.add("bench/rules/bench.cga", text);
	Diagnostics diagnostics;
	auto program = load_program("bench/rules/bench.cga", cga::cga_dialect(), provider, diagnostics);
	std::fputs(to_text(diagnostics).c_str(), stderr);
	return program;
}

inline std::shared_ptr<const Program> loaded(const std::string &name) {
	Diagnostics diagnostics;
	auto program = load_program("bench/rules/" + name + ".cga", cga::cga_dialect(), diagnostics);
	std::fputs(to_text(diagnostics).c_str(), stderr);
	return program;
}

// Lots that belong to the files in bench/rules/: square, so many metres wide.
struct Building {
	const char *name;
	double width;
};
constexpr Building buildings[] = { { "tower", 36.0 }, { "building", 44.0 } };

} // namespace pcg::bench
