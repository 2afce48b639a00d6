class_name DemoPicture
## Pictures of a running demo, for its documentation.

const FRAMES_BEFORE := 8 ## shadows, sky and people's scenes need a few
const QUALITY := 0.88 ## of pictures in JPEG


## Saves what `scene`'s viewport shows as PNG or, by the path's ending, JPEG.
static func take(scene: Node, path: String) -> Error:
	RenderingServer.render_loop_enabled = true
	for frame: int in FRAMES_BEFORE:
		await scene.get_tree().process_frame
	await RenderingServer.frame_post_draw
	var picture: Image = scene.get_viewport().get_texture().get_image()
	return picture.save_jpg(path, QUALITY) if path.get_extension() == "jpg" else picture.save_png(path)
