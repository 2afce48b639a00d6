class_name DemoSun
extends DirectionalLight3D
## Stands where the sun of a spring day in the mid latitudes stands, and colours its light and the sky; at night it is the moon.

const NOON_HEIGHT_DEGREES := 56.0
const SUNRISE_HOUR := 6.5
const SUNSET_HOUR := 20.0
const AMBIENT := 0.42 ## its colour changes
const MOON_HEIGHT_DEGREES := 48.0

@export var environment: WorldEnvironment


## 0 at night .. 1 by day.
static func daylight_at(hour: float) -> float:
	return smoothstep(-0.1, 0.3, _height_at(hour))


## Sine of the sun's way over the sky; negative below the horizon.
static func _height_at(hour: float) -> float:
	var share: float = (hour - SUNRISE_HOUR) / (SUNSET_HOUR - SUNRISE_HOUR)
	return sin(share * PI) if share > -0.2 and share < 1.2 else -0.6


## `hour` of the day, 0 to 24.
func show_hour(hour: float) -> void:
	var share: float = (hour - SUNRISE_HOUR) / (SUNSET_HOUR - SUNRISE_HOUR)
	var height: float = _height_at(hour)
	var daylight: float = daylight_at(hour)
	var is_night: bool = height < -0.05
	var degrees: float = MOON_HEIGHT_DEGREES if is_night else maxf(7.0, height * NOON_HEIGHT_DEGREES)
	rotation_degrees = Vector3(-degrees, 40.0 if is_night else lerpf(105.0, -105.0, clampf(share, 0.0, 1.0)), 0.0)
	light_color = Color(0.66, 0.74, 0.95) if is_night else Color(1.0, 0.68, 0.42).lerp(Color(1.0, 0.965, 0.91), smoothstep(0.0, 0.5, height))
	# Around sunset the sun has gone and the moon has not risen, so that nothing is seen of the change.
	light_energy = 0.3 * smoothstep(-0.05, -0.3, height) if is_night else 1.25 * smoothstep(-0.05, 0.25, height)
	var sky: ProceduralSkyMaterial = environment.environment.sky.sky_material
	var dusk: float = smoothstep(0.45, 0.0, absf(height)) * smoothstep(-0.25, 0.0, height)
	sky.sky_top_color = Color(0.015, 0.025, 0.06).lerp(Color(0.24, 0.45, 0.78), daylight)
	sky.sky_horizon_color = Color(0.04, 0.055, 0.11).lerp(Color(0.74, 0.82, 0.89), daylight).lerp(Color(0.95, 0.7, 0.52), dusk * 0.5)
	sky.ground_horizon_color = sky.sky_horizon_color
	sky.ground_bottom_color = Color(0.02, 0.025, 0.03).lerp(Color(0.35, 0.38, 0.36), daylight)
	environment.environment.ambient_light_color = Color(0.42, 0.47, 0.6).lerp(Color(0.68, 0.73, 0.82), daylight)
	environment.environment.ambient_light_energy = AMBIENT
	environment.environment.fog_light_color = sky.sky_horizon_color
