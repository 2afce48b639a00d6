#include "core/io/gltf_accessor.h"

#include <cstring>
#include <type_traits>

namespace pcg {

namespace {

template <typename T> T number_at(const unsigned char *bytes) {
	T value;
	std::memcpy(&value, bytes, sizeof value);
	return value;
}

template <typename T> double as_double(const unsigned char *bytes, bool is_normalized) {
	const double value = double(number_at<T>(bytes));
	if constexpr (std::is_integral_v<T>) {
		return is_normalized ? value / double(std::numeric_limits<T>::max()) : value;
	}
	return value;
}

double component(const unsigned char *bytes, int type, bool is_normalized) {
	switch (type) {
		case TINYGLTF_COMPONENT_TYPE_BYTE:
			return as_double<int8_t>(bytes, is_normalized);
		case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
			return as_double<uint8_t>(bytes, is_normalized);
		case TINYGLTF_COMPONENT_TYPE_SHORT:
			return as_double<int16_t>(bytes, is_normalized);
		case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
			return as_double<uint16_t>(bytes, is_normalized);
		case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
			return as_double<uint32_t>(bytes, is_normalized);
		default:
			return as_double<float>(bytes, is_normalized);
	}
}

// Where the elements lie; nothing if that is not wholly inside of the buffer.
struct Place {
	const unsigned char *bytes = nullptr;
	size_t count = 0, stride = 0, component_size = 0;
};

Place place_of(const tinygltf::Model &model, int index, size_t components) {
	if (index < 0 || size_t(index) >= model.accessors.size()) {
		return {};
	}
	const tinygltf::Accessor &accessor = model.accessors[size_t(index)];
	if (accessor.sparse.isSparse || accessor.bufferView < 0 || size_t(accessor.bufferView) >= model.bufferViews.size()) {
		return {};
	}
	const tinygltf::BufferView &view = model.bufferViews[size_t(accessor.bufferView)];
	const int size = tinygltf::GetComponentSizeInBytes(uint32_t(accessor.componentType));
	if (size <= 0 || size > 4 || tinygltf::GetNumComponentsInType(uint32_t(accessor.type)) != int(components) || view.buffer < 0 ||
			size_t(view.buffer) >= model.buffers.size()) {
		return {};
	}
	const std::vector<unsigned char> &data = model.buffers[size_t(view.buffer)].data;
	const size_t element = size_t(size) * components;
	const size_t stride = view.byteStride > 0 ? view.byteStride : element;
	const bool is_view_inside = view.byteOffset <= data.size() && view.byteLength <= data.size() - view.byteOffset;
	if (!is_view_inside || accessor.count == 0 || element > view.byteLength || accessor.byteOffset > view.byteLength - element ||
			(accessor.count - 1) > (view.byteLength - element - accessor.byteOffset) / stride) {
		return {};
	}
	return { data.data() + view.byteOffset + accessor.byteOffset, accessor.count, stride, size_t(size) };
}

} // namespace

std::vector<double> read_accessor(const tinygltf::Model &model, int index, size_t components) {
	const Place place = place_of(model, index, components);
	std::vector<double> numbers;
	numbers.reserve(place.count * components);
	for (size_t i = 0; i < place.count; ++i) {
		const tinygltf::Accessor &accessor = model.accessors[size_t(index)];
		for (size_t k = 0; k < components; ++k) {
			numbers.push_back(component(place.bytes + i * place.stride + k * place.component_size, accessor.componentType, accessor.normalized));
		}
	}
	return numbers;
}

std::vector<uint32_t> read_indices(const tinygltf::Model &model, int index) {
	const Place place = place_of(model, index, 1);
	std::vector<uint32_t> indices;
	indices.reserve(place.count);
	for (size_t i = 0; i < place.count; ++i) {
		const int type = model.accessors[size_t(index)].componentType;
		const unsigned char *bytes = place.bytes + i * place.stride;
		if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
			indices.push_back(number_at<uint32_t>(bytes));
		} else if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) {
			indices.push_back(number_at<uint16_t>(bytes));
		} else if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) {
			indices.push_back(number_at<uint8_t>(bytes));
		} else {
			return {};
		}
	}
	return indices;
}

} // namespace pcg
