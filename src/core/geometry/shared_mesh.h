#pragma once

#include <memory>
#include <mutex>

#include "core/geometry/mesh.h"

namespace pcg {

// A mesh that is made by whoever wants it first, on any thread, and is the same for all who want it later.
class SharedMesh {
public:
	template <typename Make> std::shared_ptr<const Mesh> get(Make make) {
		std::call_once(_flag, [&] { _mesh = std::make_shared<const Mesh>(make()); });
		return _mesh;
	}

private:
	std::once_flag _flag;
	std::shared_ptr<const Mesh> _mesh;
};

} // namespace pcg
