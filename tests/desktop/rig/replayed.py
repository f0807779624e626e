"""The replay's window by its keys."""

import time

from checks import require
from processes import until
from window import Mouse

TITLE = "Deixis replay"


def replayed(settings):
    """Every key that the bar names does what it says, and Escape ends it."""
    with settings.desktop("replayed") as rig:
        database = rig.folder / "study.sqlite"
        made = rig._start([settings.program, "simulate", "genea-pairwise", "--participants", "1", "--db", database], "made")
        require(made.wait(120) == 0, made.text())
        replay = rig._start([settings.program, "replay", database, "--participant", "S001", "--size", "480x270"], "replay")
        window = until("window", lambda: rig.windows(TITLE), 60.0)[0]
        rig.mouse = keys = Mouse(rig.environment, lambda: window)
        keys.do("windowfocus", window)

        def picture():
            return b"".join(bytes(row) for row in rig.screen())

        def still():
            before = picture()
            time.sleep(0.7)  # some frames
            return before == picture() and before

        def press(key, what, expected=lambda now, before: now != before):
            before = until("a still picture", still, 20.0)
            keys.do("key", key)
            until(what, lambda: expected(picture(), before), 20.0)
            return before

        until("the movement", lambda: picture() != picture(), 30.0)
        keys.do("key", "space")
        first = press("v", "the view from outside")
        press("v", "their eyes' view again", lambda now, _: now == first)
        press("Right", "the next frame")
        press("Left", "the frame before", lambda now, _: now == first)
        press("Next", "the next trial")
        keys.do("key", "Escape")
        require(replay.wait(20) == 0, replay.text())
        return "space, v, arrows, page keys and escape"
