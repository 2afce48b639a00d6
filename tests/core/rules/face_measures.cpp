#include "face_measures.h"

namespace pcg {

double face_area(const Mesh &mesh, const MeshFace &face) {
	Mesh one;
	one.positions = mesh.positions;
	one.loop_ends = mesh.loop_ends;
	one.faces = { face };
	return area(one);
}

glm::dvec3 middle(const Mesh &mesh, const MeshFace &face) {
	glm::dvec3 sum(0.0);
	for (const glm::vec3 &point : mesh.loop(face.first_loop)) {
		sum += glm::dvec3(point);
	}
	return sum / double(mesh.loop(face.first_loop).size());
}

double polygon_area(const std::vector<glm::vec3> &polygon) {
	double sum = 0.0;
	for (size_t i = 0; i < polygon.size(); ++i) {
		const glm::vec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
		sum += double(a.z) * b.x - double(b.z) * a.x;
	}
	return 0.5 * sum;
}

} // namespace pcg
