match {set = {"stand	rd.seconds=1"}, players = {"script", "script"}}
