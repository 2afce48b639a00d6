class_name DemoSun
extends DirectionalLight3D
## Stands where the sun of a spring day in the mid latitudes stands, and colours its light and the sky.

const NOON_HEIGHT_DEGREES := 55.0
const SUNRISE_HOUR := 6.5
const SUNSET_HOUR := 20.0

@export var environment: WorldEnvironment


## `hour` of the day, 0 to 24.
func show_hour(hour: float) -> void:
	var share := (hour - SUNRISE_HOUR) / (SUNSET_HOUR - SUNRISE_HOUR)
	var height := sin(share * PI) if share > -0.2 and share < 1.2 else -0.6
	var daylight := smoothstep(-0.08, 0.25, height)
	rotation_degrees = Vector3(-maxf(4.0, absf(height) * NOON_HEIGHT_DEGREES), lerpf(110.0, -110.0, clampf(share, 0.0, 1.0)), 0.0)
	light_color = Color(1.0, 0.62, 0.38).lerp(Color(1.0, 0.96, 0.89), smoothstep(0.0, 0.55, height))
	light_energy = lerpf(0.06, 1.15, daylight)
	if daylight < 0.02:
		light_color = Color(0.55, 0.65, 1.0)
	var sky: ProceduralSkyMaterial = environment.environment.sky.sky_material
	sky.sky_top_color = Color(0.02, 0.03, 0.07).lerp(Color(0.27, 0.48, 0.79), daylight)
	sky.sky_horizon_color = Color(0.05, 0.06, 0.11).lerp(Color(0.78, 0.83, 0.87), daylight)
	sky.ground_horizon_color = sky.sky_horizon_color
	environment.environment.ambient_light_energy = lerpf(0.15, 0.55, daylight)
	environment.environment.fog_light_color = sky.sky_horizon_color
