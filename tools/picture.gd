extends SceneTree
## Takes a picture of a model that `bin/pcg derive RULE.cga --out MODEL.glb` wrote, on level ground under a clear sky:
##
##     godot --path . --script tools/picture.gd -- [--view YAW,PITCH] [--size 960x600] [--sun YAW,HEIGHT] MODEL.glb PICTURE.png ..
##
## The camera stands YAW degrees from the front of the lot (positive: to the right) and PITCH degrees above the ground, as far away as the
## model needs. Options hold for the pairs of files that follow them. Needs a display (`xvfb-run -a` will do); add
## --rendering-method forward_plus for softer light. The pictures of docs/cga-gallery.md were taken so.

const FOV_DEGREES := 28.0
const FRAMES_BEFORE_PICTURE := 3 ## shadows and sky need a few
const MARGIN := 1.06
const USAGE := "usage: tools/picture.gd -- [--view YAW,PITCH] [--size WxH] [--zoom N] [--sun YAW,HEIGHT] [--ground #RRGGBB] MODEL.glb PICTURE.png .."

var _options := { "--view": "32,20", "--size": "960x600", "--sun": "-38,42", "--ground": "#a5a89e", "--zoom": "2" } ## zoom: drawn so much larger and then shrunk


func _initialize() -> void:
	_run.call_deferred()


func _run() -> void:
	var arguments: PackedStringArray = OS.get_cmdline_user_args()
	var files := PackedStringArray()
	var pictures := 0
	var i := 0
	while i < arguments.size():
		if _options.has(arguments[i]) and i + 1 < arguments.size():
			_options[arguments[i]] = arguments[i + 1]
			i += 1
		else:
			files.append(arguments[i])
		i += 1
		if files.size() == 2:
			if not await _take_picture(files[0], files[1]):
				quit(1)
				return
			files.clear()
			pictures += 1
	if pictures == 0 or not files.is_empty():
		printerr(USAGE)
		quit(1)
		return
	quit(0)


func _take_picture(model_file: String, picture_file: String) -> bool:
	var model: Node3D = _load(model_file)
	if model == null:
		return false
	var size: PackedFloat64Array = _options["--size"].split_floats("x")
	var zoom: float = _options["--zoom"].to_float()
	var viewport := SubViewport.new()
	viewport.size = Vector2i(int(size[0] * zoom), int(size[1] * zoom))
	viewport.own_world_3d = true
	viewport.msaa_3d = Viewport.MSAA_4X
	viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	root.add_child(viewport)
	viewport.add_child(model)
	_add_surroundings(viewport)
	_add_camera(viewport, model, size[0] / size[1])
	for frame: int in FRAMES_BEFORE_PICTURE:
		await process_frame
	await RenderingServer.frame_post_draw
	var image: Image = viewport.get_texture().get_image()
	viewport.queue_free()
	image.resize(int(size[0]), int(size[1]), Image.INTERPOLATE_LANCZOS)
	var error: Error = image.save_png(picture_file)
	if error != OK:
		printerr("cannot write %s: %s" % [picture_file, error_string(error)])
	return error == OK


func _load(path: String) -> Node3D:
	var document := GLTFDocument.new()
	var state := GLTFState.new()
	var error: Error = document.append_from_file(path, state)
	if error != OK:
		printerr("cannot read %s: %s" % [path, error_string(error)])
		return null
	return document.generate_scene(state) as Node3D


func _add_surroundings(viewport: Node) -> void:
	var sky_material := ProceduralSkyMaterial.new()
	sky_material.sky_top_color = Color("#4f86c6")
	sky_material.sky_horizon_color = Color("#c9d8e6")
	sky_material.ground_horizon_color = Color("#c9d8e6")
	sky_material.ground_bottom_color = Color("#8a8f86")
	sky_material.sky_curve = 0.2
	var sky := Sky.new()
	sky.sky_material = sky_material
	var environment := Environment.new()
	environment.background_mode = Environment.BG_SKY
	environment.sky = sky
	environment.ambient_light_source = Environment.AMBIENT_SOURCE_SKY
	environment.ambient_light_color = Color("#cfc9c0")
	environment.ambient_light_sky_contribution = 0.35
	environment.ambient_light_energy = 0.7
	environment.tonemap_mode = Environment.TONE_MAPPER_FILMIC
	environment.tonemap_white = 1.6
	environment.ssao_enabled = true # where the renderer has it
	environment.ssao_radius = 1.6
	environment.ssao_intensity = 2.0
	environment.fog_enabled = true
	environment.fog_mode = Environment.FOG_MODE_DEPTH
	environment.fog_light_color = Color("#c9d8e6")
	environment.fog_depth_begin = 150.0
	environment.fog_depth_end = 900.0
	environment.fog_sky_affect = 0.0
	var world := WorldEnvironment.new()
	world.environment = environment
	viewport.add_child(world)
	viewport.add_child(_make_sun())
	viewport.add_child(_make_ground())


func _make_sun() -> DirectionalLight3D:
	var angles: PackedFloat64Array = _options["--sun"].split_floats(",")
	var sun := DirectionalLight3D.new()
	sun.rotation_degrees = Vector3(-angles[1], angles[0], 0.0)
	sun.light_color = Color(1.0, 0.95, 0.86)
	sun.light_energy = 1.35
	sun.light_angular_distance = 0.6
	sun.shadow_enabled = true
	sun.shadow_bias = 0.03
	sun.shadow_normal_bias = 0.6
	sun.directional_shadow_mode = DirectionalLight3D.SHADOW_PARALLEL_4_SPLITS
	sun.directional_shadow_max_distance = 400.0
	return sun


func _make_ground() -> MeshInstance3D:
	var material := StandardMaterial3D.new()
	material.albedo_color = Color(_options["--ground"])
	material.roughness = 1.0
	material.metallic_specular = 0.0
	var plane := PlaneMesh.new()
	plane.size = Vector2(4000.0, 4000.0)
	plane.material = material
	var ground := MeshInstance3D.new()
	ground.mesh = plane
	ground.position.y = -0.02
	return ground


## The corners of all faces, as the camera's axes see them.
func _corners(node: Node, turn: Basis) -> PackedVector3Array:
	var corners := PackedVector3Array()
	for child: Node in node.find_children("*", "MeshInstance3D", true, false):
		var instance := child as MeshInstance3D
		var frame := Transform3D(turn.inverse(), Vector3.ZERO) * instance.global_transform
		for surface: int in instance.mesh.get_surface_count():
			corners.append_array(frame * (instance.mesh.surface_get_arrays(surface)[Mesh.ARRAY_VERTEX] as PackedVector3Array))
	return corners


## As near as all of the model stays in the picture, and in its middle.
func _add_camera(viewport: Node, model: Node, aspect: float) -> void:
	var angles: PackedFloat64Array = _options["--view"].split_floats(",")
	var turn := Basis(Vector3.UP, deg_to_rad(angles[0])) * Basis(Vector3.RIGHT, -deg_to_rad(angles[1]))
	var slope_y := tan(deg_to_rad(FOV_DEGREES) / 2.0) / MARGIN
	var slope_x := slope_y * aspect
	# A plane through the camera touches the model on each side; two of them fix the camera's place on an axis.
	var right := -INF
	var left := -INF
	var top := -INF
	var bottom := -INF
	var corners: PackedVector3Array = _corners(model, turn)
	for corner: Vector3 in corners:
		right = maxf(right, corner.x + corner.z * slope_x)
		left = maxf(left, -corner.x + corner.z * slope_x)
		top = maxf(top, corner.y + corner.z * slope_y)
		bottom = maxf(bottom, -corner.y + corner.z * slope_y)
	var distance := maxf((right + left) / (2.0 * slope_x), (top + bottom) / (2.0 * slope_y))
	var camera := Camera3D.new()
	camera.fov = FOV_DEGREES
	camera.far = 3000.0
	camera.near = 0.5
	viewport.add_child(camera)
	camera.global_transform = Transform3D(turn, turn * _centred(corners, Vector3((right - left) / 2.0, (top - bottom) / 2.0, distance)))
	camera.current = true


## Shifts the camera sideways until the picture has the same margin on opposite sides.
func _centred(corners: PackedVector3Array, place: Vector3) -> Vector3:
	for attempt: int in 3:
		var low := Vector2(INF, INF)
		var high := Vector2(-INF, -INF)
		for corner: Vector3 in corners:
			var seen := Vector2(corner.x - place.x, corner.y - place.y) / (place.z - corner.z)
			low = low.min(seen)
			high = high.max(seen)
		var shift: Vector2 = (low + high) / 2.0 * place.z
		place += Vector3(shift.x, shift.y, 0.0)
	return place
