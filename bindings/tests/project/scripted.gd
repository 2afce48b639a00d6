extends ProbeNode


func twice() -> float:
	return speed * 2
