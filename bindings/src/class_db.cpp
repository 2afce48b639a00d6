#include <godot_cpp/core/class_db.hpp>

#include <godot_cpp/core/engine_call.hpp>
#include <godot_cpp/core/wrapper_registry.hpp>

namespace godot {

using namespace internal;

namespace {

GDExtensionInitializationLevel current_level = GDEXTENSION_INITIALIZATION_CORE;

} // namespace

struct ClassDB::Storage {
	NameMap<std::unique_ptr<ClassInfo>> classes;
	std::vector<ClassInfo *> in_order;

	// Built at first use: StringNames need the engine.
	static Storage &get() {
		static Storage *instance = new Storage;
		return *instance;
	}
};

ClassDB::ClassInfo *ClassDB::find_class(const StringName &p_name) {
	auto &classes = Storage::get().classes;
	auto found = classes.find(p_name);
	return found == classes.end() ? nullptr : found->second.get();
}

ClassDB::ClassInfo &ClassDB::begin_class(const StringName &p_name, const StringName &p_parent,
                                         GDExtensionClassCreationInfo5 &p_info, const RegisterOptions &p_options) {
	auto owned = std::make_unique<ClassInfo>();
	ClassInfo &info = *owned;
	info.name = p_name;
	info.parent = find_class(p_parent);
	info.level = current_level;
	Storage::get().in_order.push_back(&info);
	Storage::get().classes[p_name] = std::move(owned);
	register_extension_class(p_name);

	p_info.is_virtual = p_options.is_virtual;
	p_info.is_abstract = p_options.is_abstract;
	p_info.is_exposed = p_options.is_exposed;
	p_info.is_runtime = p_options.is_runtime;
	p_info.get_virtual_func = get_virtual;
	p_info.class_userdata = &info;
	engine.classdb_register_extension_class5(library, p_name._native_ptr(), p_parent._native_ptr(), &p_info);
	return info;
}

const MethodBind *ClassDB::find_method(const ClassInfo *p_class, const StringName &p_name) {
	for (; p_class; p_class = p_class->parent) {
		auto found = p_class->methods.find(p_name);
		if (found != p_class->methods.end()) {
			return found->second.get();
		}
	}
	return nullptr;
}

MethodBind *ClassDB::add_method(MethodBind *p_bind, const MethodDefinition &p_definition,
                                std::vector<Variant> p_defaults) {
	std::unique_ptr<MethodBind, MethodBindDeleter> bind(p_bind);
	ClassInfo *owner = find_class(bind->instance_class);
	const size_t count = bind->argument_infos.size();
	ERR_FAIL_NULL_V_MSG(owner, nullptr, String("Class '") + bind->instance_class + "' is not registered.");
	ERR_FAIL_COND_V_MSG(owner->methods.count(p_definition.name), nullptr,
	                    String("Method '") + p_definition.name + "' is bound twice.");
	ERR_FAIL_COND_V_MSG(p_definition.args.size() > count || p_defaults.size() > count, nullptr,
	                    String("Method '") + p_definition.name + "' is bound with more arguments than it takes.");
	bind->name = p_definition.name;
	bind->default_arguments = std::move(p_defaults);
	for (size_t i = 0; i < count; i++) {
		bind->argument_infos[i].name =
		        i < p_definition.args.size() ? p_definition.args[i] : StringName(vformat("_unnamed_arg%d", int64_t(i)));
	}
	announce_method(*owner, *bind);
	return (owner->methods[p_definition.name] = std::move(bind)).get();
}

void ClassDB::announce_method(const ClassInfo &p_class, MethodBind &p_bind) {
	std::vector<GDExtensionPropertyInfo> arguments;
	for (const PropertyInfo &info : p_bind.argument_infos) {
		arguments.push_back(info._to_gdextension());
	}
	std::vector<GDExtensionVariantPtr> defaults;
	for (const Variant &value : p_bind.default_arguments) {
		defaults.push_back(value._native_ptr());
	}
	GDExtensionPropertyInfo returned = p_bind.return_info._to_gdextension();
	GDExtensionClassMethodInfo info = {};
	info.name = p_bind.name._native_ptr();
	info.method_userdata = &p_bind;
	info.call_func = MethodBind::bind_call;
	info.ptrcall_func = MethodBind::bind_ptrcall;
	info.method_flags = p_bind.flags;
	info.has_return_value = p_bind.returns;
	info.return_value_info = &returned;
	info.return_value_metadata = p_bind.return_metadata;
	info.argument_count = uint32_t(arguments.size());
	info.arguments_info = arguments.data();
	info.arguments_metadata = p_bind.argument_metadata.data();
	info.default_argument_count = uint32_t(defaults.size());
	info.default_arguments = defaults.data();
	engine.classdb_register_extension_class_method(library, p_class.name._native_ptr(), &info);
}

void ClassDB::add_property_group(const StringName &p_class, const String &p_name, const String &p_prefix) {
	engine.classdb_register_extension_class_property_group(library, p_class._native_ptr(), p_name._native_ptr(),
	                                                       p_prefix._native_ptr());
}

void ClassDB::add_property_subgroup(const StringName &p_class, const String &p_name, const String &p_prefix) {
	engine.classdb_register_extension_class_property_subgroup(library, p_class._native_ptr(), p_name._native_ptr(),
	                                                          p_prefix._native_ptr());
}

void ClassDB::add_property(const StringName &p_class, const PropertyInfo &p_info, const StringName &p_setter,
                           const StringName &p_getter, int p_index) {
	ClassInfo *owner = find_class(p_class);
	ERR_FAIL_NULL_MSG(owner, String("Class '") + p_class + "' is not registered.");
	ERR_FAIL_COND_MSG(!owner->properties.insert(p_info.name).second,
	                  String("Property '") + p_info.name + "' of class '" + p_class + "' is added twice.");
	const int extra = p_index >= 0 ? 1 : 0;
	if (!p_setter.is_empty()) {
		const MethodBind *setter = find_method(owner, p_setter);
		ERR_FAIL_NULL_MSG(setter, String("Setter '") + p_setter + "' of property '" + p_info.name + "' is not bound.");
		ERR_FAIL_COND_MSG(setter->get_argument_count() != 1 + extra,
		                  String("Setter '") + p_setter + "' must take one value.");
	}
	const MethodBind *getter = find_method(owner, p_getter);
	ERR_FAIL_NULL_MSG(getter, String("Getter '") + p_getter + "' of property '" + p_info.name + "' is not bound.");
	ERR_FAIL_COND_MSG(getter->get_argument_count() != extra, String("Getter '") + p_getter + "' must take no value.");

	GDExtensionPropertyInfo info = p_info._to_gdextension();
	engine.classdb_register_extension_class_property_indexed(library, p_class._native_ptr(), &info,
	                                                         p_setter._native_ptr(), p_getter._native_ptr(), p_index);
}

void ClassDB::add_signal(const StringName &p_class, const MethodInfo &p_signal) {
	ClassInfo *owner = find_class(p_class);
	ERR_FAIL_NULL_MSG(owner, String("Class '") + p_class + "' is not registered.");
	for (const ClassInfo *check = owner; check; check = check->parent) {
		ERR_FAIL_COND_MSG(check->signals.count(p_signal.name),
		                  String("Class '") + p_class + "' already has the signal '" + p_signal.name + "'.");
	}
	owner->signals.insert(p_signal.name);
	std::vector<GDExtensionPropertyInfo> arguments;
	for (const PropertyInfo &argument : p_signal.arguments) {
		arguments.push_back(argument._to_gdextension());
	}
	engine.classdb_register_extension_class_signal(library, p_class._native_ptr(), p_signal.name._native_ptr(),
	                                               arguments.data(), int64_t(arguments.size()));
}

void ClassDB::bind_integer_constant(const StringName &p_class, const StringName &p_enum, const StringName &p_constant,
                                    GDExtensionInt p_value, bool p_is_bitfield) {
	ClassInfo *owner = find_class(p_class);
	ERR_FAIL_NULL_MSG(owner, String("Class '") + p_class + "' is not registered.");
	ERR_FAIL_COND_MSG(!owner->constants.insert(p_constant).second,
	                  String("Constant '") + p_constant + "' is bound twice.");
	// The engine wants the enum's name alone; ours comes with the class: "Class.Enum".
	const StringName enum_name = String(p_enum).get_slice(".", String(p_enum).get_slice_count(".") - 1);
	engine.classdb_register_extension_class_integer_constant(library, p_class._native_ptr(), enum_name._native_ptr(),
	                                                         p_constant._native_ptr(), p_value, p_is_bitfield);
}

void ClassDB::bind_virtual_method(const StringName &p_class, const StringName &p_method,
                                  GDExtensionClassCallVirtual p_call, uint32_t p_hash) {
	ClassInfo *owner = find_class(p_class);
	ERR_FAIL_NULL_MSG(owner, String("Class '") + p_class + "' is not registered.");
	owner->virtuals[p_method._identity()] = {p_method, p_hash, p_call};
}

GDExtensionClassCallVirtual ClassDB::get_virtual(void *p_class, GDExtensionConstStringNamePtr p_name, uint32_t p_hash) {
	const ClassInfo *info = static_cast<ClassInfo *>(p_class);
	auto found = info->virtuals.find(static_cast<const StringName *>(p_name)->_identity());
	return found != info->virtuals.end() && found->second.hash == p_hash ? found->second.call : nullptr;
}

void ClassDB::set_level(GDExtensionInitializationLevel p_level) {
	current_level = p_level;
}

void ClassDB::deinitialize(GDExtensionInitializationLevel p_level) {
	auto &in_order = Storage::get().in_order;
	for (size_t i = in_order.size(); i-- > 0;) {
		ClassInfo *info = in_order[i];
		if (info->level != p_level) {
			continue;
		}
		const StringName name = info->name;
		engine.classdb_unregister_extension_class(library, name._native_ptr());
		unregister_extension_class(name);
		in_order.erase(in_order.begin() + ptrdiff_t(i));
		Storage::get().classes.erase(name);
	}
}

} // namespace godot
