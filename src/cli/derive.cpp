#include <chrono>
#include <cstdio>
#include <memory>

#include "cli/args.h"
#include "cli/attributes.h"
#include "cli/derive_report.h"
#include "cli/file_names.h"
#include "cli/footprints.h"
#include "core/base/random.h"
#include "core/cga/derivation.h"
#include "core/cga/dialect.h"
#include "core/cga/neighborhood.h"
#include "core/io/atomic_file.h"
#include "core/io/file_assets.h"
#include "core/io/gltf.h"
#include "core/io/rule_loader.h"

namespace pcg::cli {

extern const Command derive_command;

namespace {

struct Request {
	std::string rules, footprint, out, report, start, style;
	std::vector<std::string> asset_folders;
	std::vector<AttributeText> attributes;
	std::pair<double, double> lot;
	uint64_t seed = 1;
	int64_t repeat = 1;
	uint32_t threads = 0;
};

Request read_request(Args &args) {
	args.require_positional(1, 1, "a rule file");
	Request request;
	request.rules = args.positional().empty() ? "" : args.positional()[0];
	request.footprint = args.text("--shape");
	request.out = args.text("--out");
	request.report = args.text("--json");
	request.start = args.text("--start");
	request.style = args.text("--style");
	request.asset_folders = args.all("--assets");
	request.repeat = args.whole("--repeat", 1, 1, 1'000'000);
	request.threads = uint32_t(args.whole("--threads", 0, 0, 1024));
	request.seed = uint64_t(args.whole("--seed", 1));
	request.lot = args.size("--lot", { 20.0, 20.0 });
	if (args.has("--shape") && args.has("--lot")) {
		args.problem("give either --shape or --lot");
	}
	request.attributes = read_attributes(args);
	if (!request.out.empty() && !request.out.ends_with(".glb") && !request.out.ends_with(".obj")) {
		args.problem("--out writes .glb or .obj files, not " + request.out);
	}
	const NamedFile inputs[] = { { "the rule file", request.rules }, { "--shape", request.footprint } };
	const NamedFile outputs[] = { { "--out", request.out }, { "--json", request.report } };
	check_outputs(args, inputs, outputs);
	return request;
}

bool make_shapes(const Request &request, const Program &program, std::vector<cga::InitialShape> &shapes, Diagnostics &diagnostics) {
	if (request.footprint.empty()) {
		shapes = { cga::InitialShape::rectangle(request.lot.first, request.lot.second) };
		shapes[0].name = "lot";
	} else if (auto loaded = load_footprints(request.footprint, diagnostics)) {
		shapes = std::move(*loaded);
	} else {
		return false;
	}
	for (size_t i = 0; i < shapes.size(); ++i) {
		shapes[i].seed = i == 0 ? request.seed : derive_seed(request.seed, i);
		shapes[i].start_rule = request.start;
		shapes[i].attributes = attributes_of(program, request.attributes);
	}
	return true;
}

DeriveOutcome derive_timed(const Program &program, const Request &request, const std::vector<cga::InitialShape> &shapes) {
	const FileAssets assets(request.asset_folders);
	cga::DeriveOptions options;
	options.assets = &assets;
	options.counts_vertices = !request.report.empty();
	DeriveOutcome outcome;
	for (const cga::InitialShape &shape : shapes) {
		outcome.names.push_back(shape.name);
	}
	WorkOptions work;
	work.threads = request.threads;
	cga::Deriver deriver(program, options);
	const auto start = std::chrono::steady_clock::now();
	for (int64_t i = 0; i < request.repeat; ++i) {
		if (shapes.size() == 1) {
			outcome.models.clear();
			outcome.models.push_back(deriver.derive(shapes[0]));
		} else {
			outcome.models = cga::derive_all(program, shapes, options, work);
		}
	}
	outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / double(request.repeat);
	return outcome;
}

// Messages without a place come from the footprint: they name its file and the shape in it.
void name_footprint(const Request &request, DeriveOutcome &outcome) {
	for (size_t i = 0; i < outcome.models.size() && !request.footprint.empty(); ++i) {
		Diagnostics named;
		for (Diagnostic diagnostic : outcome.models[i].diagnostics.list()) {
			if (diagnostic.file.empty() && diagnostic.line == 0 && diagnostic.id.find("attribute") == std::string_view::npos) {
				diagnostic.file = request.footprint;
				diagnostic.message = "shape \"" + outcome.names[i] + "\": " + diagnostic.message;
			}
			named.add(std::move(diagnostic));
		}
		outcome.models[i].diagnostics = std::move(named);
	}
}

bool write_results(const Request &request, const DeriveOutcome &outcome, Diagnostics &diagnostics) {
	bool is_done = !diagnostics.has_errors();
	if (is_done && request.out.ends_with(".obj")) {
		is_done = write_file(request.out, obj_text(outcome), diagnostics);
	} else if (is_done && !request.out.empty()) {
		is_done = write_glb(outcome.sum, outcome.names.size() == 1 ? outcome.names[0] : "shapes", request.out, diagnostics);
	}
	if (!request.report.empty()) {
		const std::string text = report_json(outcome, diagnostics);
		is_done &= request.report == "-" ? std::fwrite(text.data(), 1, text.size(), stdout) == text.size() : write_file(request.report, text, diagnostics);
	}
	return is_done;
}

int run_derive(std::span<const std::string_view> raw) {
	Args args(raw,
			{ { "--shape", "FILE" }, { "--lot", "WxD" }, { "--start", "RULE" }, { "--style", "STYLE" }, { "--attr", "NAME=VALUE" }, { "--seed", "N" },
					{ "--assets", "DIR" }, { "--threads", "N" }, { "--repeat", "N" }, { "--out", "FILE" }, { "--json", "FILE" } });
	const Request request = read_request(args);
	if (!args.is_valid()) {
		return args.report(derive_command);
	}
	Diagnostics diagnostics;
	const auto program = load_program(request.rules, cga::cga_dialect(), diagnostics, request.style);
	std::vector<cga::InitialShape> shapes;
	bool is_done = program != nullptr && make_shapes(request, *program, shapes, diagnostics);
	if (is_done) {
		DeriveOutcome outcome = derive_timed(*program, request, shapes);
		name_footprint(request, outcome);
		outcome.sum = sum_of(outcome.models);
		diagnostics.append(outcome.sum.diagnostics);
		if (request.report != "-") {
			print_summary(outcome);
		}
		is_done = write_results(request, outcome, diagnostics);
	}
	std::fputs(to_text(diagnostics).c_str(), stderr);
	return is_done ? 0 : 1;
}

} // namespace

const Command derive_command = {
	"derive",
	"pcg derive RULE.cga [--shape FOOTPRINT.obj | --lot 20x30] [--start RULE] [--style STYLE] [--attr NAME=VALUE].. [--seed N]\n"
	"           [--assets DIR].. [--threads N] [--repeat N] [--out MODEL.glb|MODEL.obj] [--json REPORT.json]\n"
	"  Derives lots by a rule file and tells what came out: faces, entrances, zones, objects, reports.\n"
	"  --shape FILE      an OBJ file: each of its objects or groups, and each face outside of them, is a shape to begin with;\n"
	"                    without it a rectangle at the origin\n"
	"  --lot WxD         its width and depth in metres (20x20)\n"
	"  --start RULE      the rule to start with, instead of the file's @StartRule\n"
	"  --style STYLE     a style of the file, instead of Default\n"
	"  --attr NAME=VALUE value of an attribute; may be given several times\n"
	"  --seed N          other seed, other model (1)\n"
	"  --assets DIR      folder with models and pictures, beside the rule file's project; may be given several times\n"
	"  --threads N       for several shapes; 0 is as many as the machine runs at once\n"
	"  --repeat N        derives N times, for timing; tells the mean\n"
	"  --out FILE        the model\n"
	"  --json FILE       everything as JSON; - for standard output. Its vertices: those that faces of a shape share count once",
	"derive lots by a shape grammar",
	run_derive,
};

} // namespace pcg::cli
