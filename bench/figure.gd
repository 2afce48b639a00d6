extends RefCounted
## One figure, as tools/run_bench.py reads it: a JSON object on a line of its own.


## `peer` is what others need for the same, or what it may cost; 0: nothing to compare with, then it and the ratio are null.
static func tell(name: String, value: float, unit: String, peer: float = 0.0) -> void:
	var has_peer: bool = peer > 0.0
	print(JSON.stringify({"name": name, "value": snappedf(value, 0.001), "unit": unit, "peer": snappedf(peer, 0.001) if has_peer else null,
			"ratio": snappedf(value / peer, 0.001) if has_peer else null}))
