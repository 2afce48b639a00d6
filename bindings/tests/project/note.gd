extends Resource


func shout() -> String:
	return "NOTE"
