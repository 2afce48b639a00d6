#include <doctest/doctest.h>

#include <algorithm>

#include "core/cga/dialect.h"
#include "core/cga/neighborhood.h"
#include "core/io/rule_loader.h"

using namespace pcg;
using namespace pcg::cga;

namespace {

std::shared_ptr<const Program> compiled(const std::string &text) {
	MemorySourceProvider provider;
	provider.add("test.cga", text);
	Diagnostics diagnostics;
	auto program = load_program("test.cga", cga_dialect(), provider, diagnostics);
	REQUIRE_MESSAGE(program != nullptr, to_text(diagnostics));
	return program;
}

// Draws in every way, splits, inserts, and asks its neighbours.
constexpr const char *town = R"(
attr height = rand(5, 20)
attr tint = 50% : "#ff0000" else : "#00ff00"
Lot --> extrude(height) s('rand(0.9, 1.1), '1, '1) color(tint) comp(f) { side : Wall | top : Roof }
Wall --> split(x) { ~rand(1, 3) : Tile }*
Tile -->
	case touches(inter) : Blank.
	else : Window
Window -->
	30% : color(rand(), rand(), rand()) X.
	30% : report("window", rand(10)) s('1, '1, 0.2) primitiveCube()
	else : NIL
Roof --> case rand() < 0.5 : roofHip(rand(20, 40)) else : roofGable(30)
)";

std::vector<InitialShape> street(size_t count) {
	std::vector<InitialShape> lots;
	for (size_t i = 0; i < count; ++i) {
		lots.push_back(InitialShape::rectangle(10.0, 12.0, 1000 + i));
		for (glm::dvec3 &point : lots.back().faces[0].outline) {
			point.x += 10.0 * double(i);
		}
	}
	return lots;
}

bool is_same(const DerivationResult &a, const DerivationResult &b) {
	const auto same_report = [](const ModelReport &x, const ModelReport &y) {
		return x.key == y.key && x.count == y.count && x.sum == y.sum && x.min == y.min && x.max == y.max;
	};
	const auto same_face = [](const MeshFace &x, const MeshFace &y) { return x.material == y.material && x.first_loop == y.first_loop; };
	return a.mesh.positions == b.mesh.positions && a.mesh.loop_ends == b.mesh.loop_ends && std::ranges::equal(a.mesh.faces, b.mesh.faces, same_face) &&
			a.materials == b.materials && std::ranges::equal(a.reports, b.reports, same_report) && a.prints == b.prints && a.shape_count == b.shape_count &&
			to_text(a.diagnostics) == to_text(b.diagnostics);
}

DerivationResult derive_text(const std::string &text, uint64_t seed = 5) {
	DerivationResult model = derive(*compiled(text), InitialShape::rectangle(10.0, 10.0, seed));
	CHECK_MESSAGE(model.diagnostics.is_empty(), to_text(model.diagnostics));
	return model;
}

double sum_of(const DerivationResult &model, const std::string &key) {
	const auto found = std::ranges::find(model.reports, key, &ModelReport::key);
	REQUIRE(found != model.reports.end());
	return found->sum;
}

} // namespace

TEST_CASE("equal seeds make equal models on one, two and four threads") {
	const auto program = compiled(town);
	const std::vector<InitialShape> lots = street(24);
	const std::vector<DerivationResult> once = derive_all(*program, lots, {}, { 1, {}, nullptr });
	CHECK(once[3].face_count > 10);
	CHECK_FALSE(is_same(once[3], once[4]));
	for (const unsigned threads : { 1u, 2u, 4u }) {
		const std::vector<DerivationResult> again = derive_all(*program, lots, {}, { threads, {}, nullptr });
		CHECK(std::ranges::equal(once, again, is_same));
	}
}

TEST_CASE("the order of the lots changes nothing") {
	const auto program = compiled(town);
	std::vector<InitialShape> lots = street(24);
	std::vector<DerivationResult> once = derive_all(*program, lots);
	std::ranges::reverse(lots);
	std::rotate(lots.begin(), lots.begin() + 7, lots.end());
	const std::vector<DerivationResult> again = derive_all(*program, lots, {}, { 2, {}, nullptr });
	std::ranges::reverse(once);
	std::rotate(once.begin(), once.begin() + 7, once.end());
	CHECK(std::ranges::equal(once, again, is_same));
}

TEST_CASE("another seed or size of one lot changes that lot, and at most what its neighbours see of it") {
	const auto program = compiled(town);
	std::vector<InitialShape> lots = street(24);
	const std::vector<DerivationResult> before = derive_all(*program, lots);
	lots[12].seed = 99;
	lots[12].faces[0].outline[2].z -= 2.0;
	const std::vector<DerivationResult> after = derive_all(*program, lots);
	for (size_t i = 0; i < lots.size(); ++i) {
		const bool is_near = i >= 11 && i <= 13;
		CHECK((is_near || is_same(before[i], after[i])));
	}
	CHECK_FALSE(is_same(before[12], after[12]));
}

TEST_CASE("what one branch draws does not reshuffle its sisters") {
	const std::string sisters = " B B\nB --> report(\"b\", rand()) report(\"b\", rand()) C\nC --> report(\"c\", rand()) NIL\n";
	const DerivationResult plain = derive_text("Lot --> A" + sisters + "A --> NIL");
	const DerivationResult busy = derive_text("Lot --> A" + sisters + "A --> report(\"a\", rand() + rand() + rand()) split(x) { ~1 : D }*\nD --> 50% : X. else : Y. ");
	CHECK(sum_of(plain, "b") == sum_of(busy, "b"));
	CHECK(sum_of(plain, "c") == sum_of(busy, "c"));

	// Nor do draws of the parent before it calls them, nor what comes after them.
	const DerivationResult drawn = derive_text("Lot --> report(\"a\", rand()) A" + sisters + "A --> NIL");
	const DerivationResult longer = derive_text("Lot --> A" + sisters.substr(0, 4) + " B A" + sisters.substr(4) + "A --> NIL");
	CHECK(sum_of(plain, "b") == sum_of(drawn, "b"));
	CHECK(sum_of(plain, "b") < sum_of(longer, "b"));
	CHECK(sum_of(plain, "b") != sum_of(derive_text("Lot --> A" + sisters + "A --> NIL", 6), "b"));
}

TEST_CASE("an attribute's random value does not depend on which others are drawn") {
	const DerivationResult alone = derive_text("attr a = rand()\nLot --> report(\"a\", a) NIL");
	const DerivationResult with_others = derive_text("attr b = rand() + c\nattr c = rand()\nattr a = rand()\nLot --> report(\"x\", b + rand()) report(\"a\", a) NIL");
	CHECK(sum_of(alone, "a") == sum_of(with_others, "a"));
}

TEST_CASE("who asks nothing pays nothing, and who asks is known beforehand") {
	CHECK(context_use(*compiled("Lot --> comp(f) { inside : X. | border : Y. }")).asks_nothing());
	const ContextUse intra = context_use(*compiled("Lot --> case touches(intra, \"a\") : X. else : Y."));
	CHECK((intra.intra && !intra.asks_inter()));
	const ContextUse inter = context_use(*compiled("attr name = \"a\"\nLot --> case overlaps(inter, name) : X. else : Y."));
	CHECK((!inter.intra && inter.inter_occlusion && !inter.inter_labels));
	const ContextUse all = context_use(*compiled("Lot --> case inside() : X. else : Y."));
	CHECK((all.intra && all.inter_occlusion));
	const ContextUse labels = context_use(*compiled("Lot --> print(minimumDistance(inter, \"a\" + \"b\"))"));
	CHECK((labels.inter_labels && !labels.inter_occlusion));
}

// Faces name their materials by 16 bits. What one lot has used up of them is no matter to the next.
TEST_CASE("lots keep the colours of what they inline, however many lots were made before") {
	const auto program = compiled("Lot --> inline(append) split(x) { 0.02 : color(rand(), rand(), rand()) Strip. }*");
	const std::vector<InitialShape> lots = street(140); // of 500 strips each
	const std::vector<DerivationResult> models = derive_all(*program, lots, {}, { 1, {}, nullptr });
	CHECK(models.front().materials.size() == 500);
	CHECK(models.back().materials.size() == 500);
	CHECK(is_same(models.back(), derive_all(*program, std::span(lots).last(1), {}, { 1, {}, nullptr })[0]));
}
