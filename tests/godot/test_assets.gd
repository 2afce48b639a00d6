extends "res://tests/godot/suite.gd"
## Models, pictures and texts that rules name, as files and as what an exported game has left of them.

const CityForTests := preload("res://tests/godot/city_for_tests.gd")
const BOX := "mtllib box.mtl\nv 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0 1 0\nv 1 1 0\nv 1 1 1\nv 0 1 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl brick\n" \
		+ "f 1/1 2/2 3/3 4/4\nf 8/1 7/2 6/3 5/4\nf 4/1 3/2 7/3 8/4\nf 2/1 1/2 5/3 6/4\nf 3/1 2/2 6/3 7/4\nf 1/1 4/2 8/3 5/4\n"
## A door to the street in each lot, with %s on the ground before it.
const LOT := "@StartRule\nLot --> split(z) { ~1: extrude(4) comp(f) { front: entrance(\"house\", 2) W. | all: W. } | 5: Yard }\nYard --> %s\n"
const TEN := "split(x) { '0.1: s(0.5, 0.5, 0.5) i(\"%s\") }*"

var _project: String = "user://pcg_test_assets_%d" % OS.get_process_id() ## others may run the same tests meanwhile


func before_each() -> void:
	for folder: String in ["rules", "assets"]:
		DirAccess.make_dir_recursive_absolute(_project.path_join(folder))
	_write("assets/box.obj", BOX)
	_write("assets/box.mtl", "newmtl brick\nKd 1 1 1\nmap_Kd wall.png\n")
	_picture(Color.RED).save_png(_project.path_join("assets/wall.png"))


func after_each() -> void:
	_remove(_project)


func _remove(folder: String) -> void:
	for file: String in DirAccess.get_files_at(folder):
		DirAccess.remove_absolute(folder.path_join(file))
	for below: String in DirAccess.get_directories_at(folder):
		_remove(folder.path_join(below))
	DirAccess.remove_absolute(folder)


func _write(path: String, text: String) -> void:
	FileAccess.open(_project.path_join(path), FileAccess.WRITE).store_string(text)


func _picture(color: Color) -> Image:
	var image := Image.create_empty(16, 8, false, Image.FORMAT_RGB8)
	image.fill(color)
	return image


func _city(text: String) -> PCGCity:
	_write("rules/lot.cga", text)
	var type := PCGLotType.new()
	type.type = "house"
	type.rules = PCGRuleSet.from_file(_project.path_join("rules/lot.cga"))
	var city := PCGCity.new()
	city.layout = PCGLayout.new()
	city.layout.fit_lots(4)
	city.use_street_rules = false
	city.lot_types = [type]
	add_child(city)
	return city


func _grown(text: String) -> PCGCity:
	var city: PCGCity = _city(text)
	check(city.generate_now(), "it generates: %s" % [city.get_diagnostics()])
	check_equal(city.get_diagnostics().size(), 0, "without a word: %s" % [city.get_diagnostics()])
	return city


func _instances(city: PCGCity) -> Array[MultiMesh]:
	var found: Array[MultiMesh] = []
	for node: Node in city.find_children("Instances*", "MultiMeshInstance3D", true, false):
		found.append((node as MultiMeshInstance3D).multimesh)
	return found


## Places in all, and meshes in all.
func _check_instances(city: PCGCity, lots: int) -> void:
	var meshes := {}
	var places := 0
	for all: MultiMesh in _instances(city):
		meshes[all.mesh] = true
		places += all.instance_count
	check_equal(places, 10 * lots, "ten in each lot")
	check_equal(meshes.size(), 1, "and one mesh for all")


func _albedo(mesh: Mesh) -> Texture2D:
	return (mesh.surface_get_material(0) as BaseMaterial3D).albedo_texture


func test_a_model_stands_in_many_places_and_is_one_mesh() -> void:
	var city: PCGCity = _grown(LOT % (TEN % "box.obj"))
	var made: Dictionary = city.get_statistics()
	_check_instances(city, made["lots"])
	check_equal(made["instances"], 10 * made["lots"], "the city knows how many")
	check_equal(made["faces"], made["lots"] * (6 + 60), "and counts their faces")
	var texture: Texture2D = _albedo(_instances(city)[0].mesh)
	check(texture != null and texture.get_width() == 16, "its material has its picture")


func test_a_binary_model_brings_its_own_picture() -> void:
	var mesh := BoxMesh.new()
	var material := StandardMaterial3D.new()
	material.albedo_texture = ImageTexture.create_from_image(_picture(Color.BLUE))
	mesh.material = material
	var root := MeshInstance3D.new()
	root.mesh = mesh
	var document := GLTFDocument.new()
	var state := GLTFState.new()
	check_equal(document.append_from_scene(root, state), OK, "a model is made")
	check_equal(document.write_to_filesystem(state, _project.path_join("assets/box.glb")), OK, "and written")
	root.free()
	var city: PCGCity = _grown(LOT % (TEN % "box.glb"))
	_check_instances(city, city.get_statistics()["lots"])
	var texture: Texture2D = _albedo(_instances(city)[0].mesh)
	check(texture != null and texture.get_width() == 16, "its picture lies in the file itself")
	check_equal(city.save_gltf(_project.path_join("city.glb")), OK, "the city is saved")
	state = GLTFState.new()
	check_equal(GLTFDocument.new().append_from_file(_project.path_join("city.glb"), state), OK, "and read")
	var is_instance := func(node: GLTFNode) -> bool: return node.original_name == "instance"
	check_equal(state.get_nodes().filter(is_instance).size(), city.get_statistics()["instances"], "every place is a node")
	check_equal(state.get_images().size(), 1, "with the one picture")


func test_a_picture_is_on_the_walls() -> void:
	var wall := "setupProjection(0, scope.xy, 2, 1) texture(\"wall.png\") projectUV(0) W."
	var city: PCGCity = _grown("@StartRule\nLot --> extrude(4) comp(f) { front: entrance(\"house\", 2) %s | all: %s }" % [wall, wall])
	var found := 0
	for node: Node in city.find_children("Geometry", "MeshInstance3D", true, false):
		var mesh: Mesh = (node as MeshInstance3D).mesh
		if _albedo(mesh) != null:
			found += 1
			var uvs: PackedVector2Array = mesh.surface_get_arrays(0)[Mesh.ARRAY_TEX_UV]
			var ends := Vector2.ZERO
			for uv: Vector2 in uvs:
				ends = ends.max(uv.abs())
			check(ends.x > 1.0, "and is repeated: %s" % [ends])
	check_equal(found, city.get_statistics()["lots"], "every lot has it")


func test_an_opacity_map_of_its_own_is_the_alpha_of_the_colour() -> void:
	var mask := Image.create_empty(4, 4, false, Image.FORMAT_L8)
	mask.fill_rect(Rect2i(2, 0, 2, 4), Color.WHITE)
	mask.save_png(_project.path_join("assets/mask.png"))
	var wall := "setupProjection(0, scope.xy, 2, 1) texture(\"wall.png\") set(material.opacitymap, \"mask.png\") projectUV(0) W."
	var city: PCGCity = _grown("@StartRule\nLot --> extrude(4) comp(f) { front: entrance(\"house\", 2) %s | all: %s }" % [wall, wall])
	for node: Node in city.find_children("Geometry", "MeshInstance3D", true, false):
		var texture: Texture2D = _albedo((node as MeshInstance3D).mesh)
		if texture != null:
			var image: Image = texture.get_image()
			check_equal(image.get_size(), Vector2i(16, 8), "as large as the larger one")
			check_equal(image.get_pixel(0, 0), Color(1, 0, 0, 0), "black is clear")
			check_equal(image.get_pixel(15, 7), Color(1, 0, 0, 1), "white is not")
			return
	check(false, "some wall has a picture")


func test_rules_ask_for_files_sizes_and_texts() -> void:
	_write("assets/type.txt", "school")
	_write("assets/kinds.csv", "a,b\nc,workplace\n")
	var front := "case fileExists(\"wall.png\") && !fileExists(\"roof.png\") && imageInfo(\"wall.png\", sx) == 16 && listSize(fileSearch(\"assets/*.obj\")) == 1 : " \
			+ "entrance(readTextFile(\"type.txt\"), 1) entrance(readStringTable(\"kinds.csv\")[1, 1], 1) W. else : NIL"
	var city: PCGCity = _grown("@StartRule\nLot --> extrude(4) comp(f) { front: Front | all: W. }\nFront --> %s" % front)
	var made: Dictionary = city.get_statistics()
	check_equal(made["entrances"], { "school": made["lots"], "workplace": made["lots"] }, "entrances")


func test_folders_of_assets_are_searched_too() -> void:
	var city: PCGCity = CityForTests.make_city(4)
	city.lot_types = [CityForTests.make_type("house", 1, LOT % (TEN % "box.obj"))]
	city.asset_folders = [_project.path_join("assets")]
	add_child(city)
	check(city.generate_now(), "it generates")
	check_equal(city.get_diagnostics().size(), 0, "without a word: %s" % [city.get_diagnostics()])
	_check_instances(city, city.get_statistics()["lots"])


func test_a_model_that_is_missing_is_told_once() -> void:
	expect_message("there is no asset \"crate.obj\"")
	var city: PCGCity = _city(LOT % (TEN % "crate.obj"))
	check(city.generate_now(), "the city is there all the same")
	check_equal(_instances(city).size(), 0, "boxes are no instances")


## As the engine finds an imported file: by the note beside it, though the file itself is gone.
func _import_only(name: String, resource: Resource, type: String) -> void:
	var path: String = _project.path_join("imported_%s.res" % name.validate_filename())
	check_equal(ResourceSaver.save(resource, path), OK, "%s is saved" % path)
	_write("assets/%s.import" % name, "[remap]\n\nimporter=\"none\"\ntype=\"%s\"\npath=\"%s\"\n" % [type, path])
	if FileAccess.file_exists(_project.path_join("assets/" + name)):
		DirAccess.remove_absolute(_project.path_join("assets/" + name))


func _packed_box() -> PackedScene:
	var root := Node3D.new()
	var box := MeshInstance3D.new()
	var mesh := ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, BoxMesh.new().get_mesh_arrays())
	var material := StandardMaterial3D.new()
	material.albedo_color = Color.GREEN
	mesh.surface_set_material(0, material)
	box.mesh = mesh
	root.add_child(box)
	box.owner = root
	var scene := PackedScene.new()
	scene.pack(root)
	root.free()
	return scene


func test_imports_stand_for_files_that_are_gone() -> void:
	_import_only("box.glb", _packed_box(), "PackedScene")
	var city: PCGCity = _grown(LOT % (TEN % "box.glb"))
	_check_instances(city, city.get_statistics()["lots"])
	check_equal(city.get_statistics()["faces"], city.get_statistics()["lots"] * (6 + 10 * 12), "of twelve triangles")
	var box: AABB = _instances(city)[0].mesh.get_aabb()
	check(box.size.is_equal_approx(Vector3.ONE), "as large as it was: %s" % [box])
	await _check_async(city)


func test_an_imported_mesh_and_picture() -> void:
	var root: Node = _packed_box().instantiate()
	_import_only("box.obj", (root.get_child(0) as MeshInstance3D).mesh, "ArrayMesh")
	root.free()
	_import_only("wall.png", ImageTexture.create_from_image(Image.create_empty(32, 8, false, Image.FORMAT_RGBA8)), "ImageTexture")
	var asked := "case imageInfo(\"wall.png\", sx) == 32 && listSize(fileSearch(\"assets/*.obj\")) == 1 : texture(\"wall.png\") Ground. %s else : NIL"
	var city: PCGCity = _grown(LOT % (asked % (TEN % "box.obj")))
	_check_instances(city, city.get_statistics()["lots"])
	var clear := 0
	for node: Node in city.find_children("Geometry", "MeshInstance3D", true, false):
		var mesh: Mesh = (node as MeshInstance3D).mesh
		for i: int in mesh.get_surface_count():
			clear += int((mesh.surface_get_material(i) as BaseMaterial3D).transparency != BaseMaterial3D.TRANSPARENCY_DISABLED)
	check_equal(clear, city.get_statistics()["lots"], "a picture with alpha makes the ground transparent")


## The same beside the main thread, which answers meanwhile; and with an end before the answer.
func _check_async(city: PCGCity) -> void:
	var before: int = city.get_statistics()["faces"]
	await city.city_generated # of the first time: it is told when the caller has returned
	check(city.generate(), "it begins again")
	await city.city_generated
	check_equal(city.get_statistics()["faces"], before, "beside the main thread nothing is different")
	city.generate()
	OS.delay_msec(50) # the lots wait for their model now
	city.cancel()
	check(not city.is_generating(), "who waits for a model does not hold up the end")
