extends SceneTree
## Takes a picture of a city of the demo's lots, at mid-day:
##
##     godot --path . --script tools/city_picture.gd -- [--kind grid|radial|grown] [--lots 300] [--seed 1] [--jitter 0]
##         [--view X,Z,YAW,PITCH,DISTANCE] [--size 960x540] PICTURE.jpg
##
## The camera looks at the place X, Z of the ground from DISTANCE metres, YAW degrees from the south (positive: from the east) and PITCH above the
## ground. Needs a display (`xvfb-run -a` will do). The pictures of README.md were taken so.

const DemoCity := preload("res://demo/demo_city.gd")
const KINDS := {"grid": PCGLayout.KIND_GRID, "radial": PCGLayout.KIND_RADIAL, "grown": PCGLayout.KIND_GROWN}
const FRAMES_BEFORE_PICTURE := 6
const ZOOM := 2 ## drawn so much larger and then shrunk
const QUALITY := 0.82

var _options := {"--kind": "grid", "--lots": "300", "--seed": "1", "--jitter": "0", "--view": "0,0,30,35,260", "--size": "960x540"}


func _initialize() -> void:
	_run.call_deferred()


func _run() -> void:
	var path := ""
	var arguments: PackedStringArray = OS.get_cmdline_user_args()
	for i: int in arguments.size():
		if arguments[i].begins_with("--") and i + 1 < arguments.size():
			_options[arguments[i]] = arguments[i + 1]
		elif i == 0 or not arguments[i - 1].begins_with("--"):
			path = arguments[i]
	if path.is_empty() or not KINDS.has(_options["--kind"]):
		printerr("usage: tools/city_picture.gd -- [--kind grid|radial|grown] [--lots N] [--view X,Z,YAW,PITCH,DISTANCE] PICTURE.jpg")
		quit(1)
		return
	var size: PackedFloat64Array = _options["--size"].split_floats("x")
	var viewport := SubViewport.new()
	viewport.size = Vector2i(int(size[0]), int(size[1])) * ZOOM
	viewport.msaa_3d = Viewport.MSAA_2X
	viewport.render_target_update_mode = SubViewport.UPDATE_DISABLED
	root.add_child(viewport)
	_add_surroundings(viewport)
	var city: PCGCity = DemoCity.make_city(1, int(_options["--seed"]))
	city.layout = PCGLayout.new()
	city.layout.kind = KINDS[_options["--kind"]]
	city.layout.jitter = float(_options["--jitter"])
	city.layout.fit_lots(int(_options["--lots"]))
	viewport.add_child(city)
	if not city.generate_now():
		quit(1)
		return
	viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	for frame: int in FRAMES_BEFORE_PICTURE:
		await process_frame
	await RenderingServer.frame_post_draw
	var image: Image = viewport.get_texture().get_image()
	image.resize(int(size[0]), int(size[1]), Image.INTERPOLATE_LANCZOS)
	quit(0 if image.save_jpg(path, QUALITY) == OK else 1)


func _add_surroundings(viewport: Node) -> void:
	var world := WorldEnvironment.new()
	world.environment = load("res://demo/daylight.tres")
	viewport.add_child(world)
	var sun := DirectionalLight3D.new()
	sun.rotation_degrees = Vector3(-48.0, -32.0, 0.0)
	sun.light_color = Color(1.0, 0.96, 0.88)
	sun.light_energy = 1.25
	sun.shadow_enabled = true
	sun.directional_shadow_max_distance = 700.0
	viewport.add_child(sun)
	var grass := StandardMaterial3D.new()
	grass.albedo_color = Color(0.43, 0.52, 0.33)
	grass.roughness = 1.0
	grass.metallic_specular = 0.0
	var plane := PlaneMesh.new()
	plane.size = Vector2(8000.0, 8000.0)
	plane.material = grass
	var countryside := MeshInstance3D.new()
	countryside.mesh = plane
	countryside.position.y = -0.25
	viewport.add_child(countryside)
	var view: PackedFloat64Array = _options["--view"].split_floats(",")
	var camera := Camera3D.new()
	camera.fov = 40.0
	camera.far = 3000.0
	camera.near = 0.5
	viewport.add_child(camera)
	var turn := Basis(Vector3.UP, deg_to_rad(view[2])) * Basis(Vector3.RIGHT, -deg_to_rad(view[3]))
	camera.transform = Transform3D(turn, Vector3(view[0], 0.0, view[1]) + turn.z * view[4])
	camera.current = true
