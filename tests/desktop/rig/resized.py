"""What the window really shows, pixel by pixel: after it was resized, in full screen, and of pages that come up while
the participant looks elsewhere."""

from collections import Counter
from dataclasses import replace

import borrowed  # noqa: F401
from checks import require
from hands import button, head_of, pixel_of
from person import AGREE, GO_ON, Person
from processes import until
from studies import HERE, study_file

DECLINE, END_FOR_GOOD = 8, 5
SHAPES = {"4:3": (800, 600), "narrow": (420, 640), "wide": (1200, 400)}
LARGEST_DIFFERENCE = 4.0  # of 255, in the mean of a tile
TILES = 6  # across and down


def tiles(picture):
    """Mean blue, green and red of each tile, and of the whole."""
    height, width = len(picture), len(picture[0]) // 4
    means = []
    for down in range(TILES):
        for across in range(TILES):
            left, right = 4 * (width * across // TILES), 4 * (width * (across + 1) // TILES)
            rows = picture[height * down // TILES: height * (down + 1) // TILES]
            cut = b"".join(row[left:right] for row in rows)
            means.append(tuple(sum(cut[channel::4]) / (len(cut) / 4) for channel in range(3)))
    return means


def shown(rig, person, size):
    """The tiles of the window, once it has that size and shows the first page at rest."""
    until(f"window of {size}", lambda: rig.window_size() == size, 30.0)
    hands = person.hands
    hands.trace.settle(1.0)
    while hands.look()["state"] == "paused":  # a new window, and one that fills the screen, may lose the focus for once
        rig.focus()
        person.take_part(stop=lambda line: line["state"] != "paused")
        hands.trace.settle(1.0)
    rig.mouse.move_to(3, size[1] // 2)
    seen = hands.look()
    hands.wait("frames at rest", lambda now: now["frame"] > seen["frame"] + 4 and now["time_s"] > seen["time_s"] + 0.8)
    require(hands.look()["state"] == "questionnaire", f"the page is '{hands.look()['state']}'")
    return tiles(rig.screen())


def require_same(what, found, wanted):
    worst = max(abs(a - b) for tile, other in zip(found, wanted) for a, b in zip(tile, other))
    require(worst <= LARGEST_DIFFERENCE, f"{what}: a tile differs by {worst:.1f} from a window opened so")
    return worst


def resized(settings):
    """A window that was resized, or filled the screen, shows what one shows that was opened so."""
    study = HERE / "questions.toml"
    opened, worst = {}, 0.0
    for name, size in SHAPES.items():
        with replace(settings, size=f"{size[0]}x{size[1]}").desktop("opened") as rig:
            trace = rig.run(study, rig.folder / "study.sqlite")
            opened[name] = shown(rig, Person(trace, rig.mouse), size)
    with settings.desktop("opened") as rig:
        trace = rig.run(study, rig.folder / "study.sqlite", "--fullscreen")
        opened["full"] = shown(rig, Person(trace, rig.mouse), (1280, 800))
    with settings.desktop("resized") as rig:
        person = Person(rig.run(study, rig.folder / "study.sqlite"), rig.mouse)
        first_size = rig.window_size()
        first = shown(rig, person, first_size)
        for name, size in SHAPES.items():
            rig.mouse.resize(*size)
            worst = max(worst, require_same(name, shown(rig, person, size), opened[name]))
        rig.mouse.resize(*first_size)
        worst = max(worst, require_same("the first size again", shown(rig, person, first_size), first))
        rig.mouse.key("F11")
        worst = max(worst, require_same("full screen", shown(rig, person, (1280, 800)), opened["full"]))
        rig.mouse.key("F11")
        worst = max(worst, require_same("the window again", shown(rig, person, first_size), first))
        return f"{len(opened) + 2} shapes, tiles differ by {worst:.2f} at most"


def colour_of(rig, line, number):
    """Of a button: the commonest colour around its middle."""
    size = rig.window_size()
    at = pixel_of(line, tuple(button(line, number)["centre"]), size)
    require(
        at is not None and all(8 <= v < most - 8 for v, most in zip(at, size)),
        f"the button of '{line['state']}' is at {at} of {size}",
    )
    picture = rig.screen()
    x, y = (round(v) for v in at)
    near = [tuple(picture[y + down][4 * (x + right):][:3]) for down in range(-5, 6) for right in range(-8, 9)]
    return Counter(near).most_common(1)[0][0]


def closing_in_view(settings):
    """Who looked elsewhere when declining sees the closing page nevertheless."""
    with settings.desktop("closing") as rig:
        trace = rig.run(study_file(settings, rig, "sgtoolkit2021", shorten=1), rig.folder / "study.sqlite")
        person = Person(trace, rig.mouse)
        hands = person.hands

        def enabled(line):
            return (button(line, AGREE) or {}).get("enabled")

        hands.wait("consent", lambda line: line["state"] == "consent" and enabled(line))
        rig.mouse.move_to(3, 3)
        trace.settle(0.6)
        agree, ahead = colour_of(rig, hands.look(), AGREE), hands.look()["head"]
        rig.mouse.look_around(250, 60)
        trace.settle(0.5)
        require(hands.look()["head"] != ahead, "the right button turned nothing")
        hands.click_button(DECLINE)
        hands.click_button(END_FOR_GOOD)
        line = hands.wait("closing page", lambda now: now["state"] == "closing" and button(now, GO_ON))
        hands.wait("view of the page", lambda now: now["frame"] > line["frame"])
        before, now = (head_of(one).orientation for one in ({"head": ahead}, hands.look()))
        require(abs(before[2] - now[2]) < 1e-6, f"the page came up, and the view stays turned: {before}, {now}")
        rig.mouse.move_to(3, 3)
        trace.settle(0.6)
        go_on = colour_of(rig, hands.look(), GO_ON)
        require(
            max(abs(a - b) for a, b in zip(agree, go_on)) <= 12,
            f"where the closing page's button should be is {go_on}, the consent's was {agree}",
        )
        return f"the button is {go_on}"
