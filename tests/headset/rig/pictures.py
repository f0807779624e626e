"""Pictures of what the lenses would show: the runtime's real compositor in an X window."""

import subprocess

import checks
from checks import require
from participant import Choices
from processes import until
from scenarios import begin, changed_study, require_clean_end, require_valid

SCREEN = "1920x1080"  # the compositor's window fills it
# When the compositor shows what is wanted of a state: what is chosen is gone soon, a movement must have begun.
SHOWN_S = {"chosen": 0.2, "playing": 0.8, "pointing": 0.1}
WANTED = (
    ["welcome", "instructions", "practice", "break", "goodbye", "playing", "pointing", "rating"]
    + [f"{state}-{layout}" for state in ("waiting", "playing", "pointing", "choosing", "aiming", "chosen")
       for layout in ("across", "side-by-side")]
)


def pictures(settings):
    """A picture of every state, taken from the compositor's window."""
    settings.pictures.mkdir(parents=True, exist_ok=True)
    for old in settings.pictures.glob("*.png"):
        old.unlink()
    with settings.rig("pictures", compositor="xcb", screen=SCREEN) as rig:
        database = rig.folder / "short.sqlite"
        rig_window = []

        def compositor_window():
            if not rig_window:
                rig_window.extend(until("the compositor's window", lambda: rig.windows("Monado|OpenXR")))
            return rig_window[0]

        fewer = (("items = 2", "items = 1"), ("items = 4", "items = 2"), ("break_every = 4", "break_every = 2"))
        study = changed_study(rig, "pictured", *fewer)
        # Drawn by the processor: at full resolution a frame would take a second. Text has its own resolution.
        person, trace = begin(rig, database, "--resolution-scale", "0.4", study=study)
        # The experimenter's window must not lie over the other: beside the screen.
        for window in rig.windows("P01"):
            beside = SCREEN.split("x")[0]
            subprocess.run(["xdotool", "windowmove", str(window), beside, "0"], env=rig.environment, check=True)
        taken = set()

        def take(state):
            taken.add(state)
            subprocess.run(
                ["import", "-window", str(compositor_window()), str(settings.pictures / f"{state}.png")],
                env=rig.environment, check=True,
            )

        def watch(line):
            state = line["state"]
            # Pointing is taken anew each time: the first time the picture of the state before has used up the moment.
            if state not in WANTED or (state in taken and not state.startswith("pointing")):
                return
            trace.settle(SHOWN_S.get(state.split("-")[0], 0.5))
            if trace.now["state"] == state or state.startswith("chosen"):
                take(state)

        person.before_press = lambda trace: watch(trace.now)
        person.take_part(trace, Choices(), watch=watch)
        require_clean_end(rig, 60.0)
        checks.check_exactly_given(database, person.given)
        missing = [state for state in WANTED if state not in taken]
        require(not missing, f"no picture was taken of {missing}")
        for picture in settings.pictures.glob("*.png"):
            seen = subprocess.run(
                ["identify", "-format", "%k %[fx:mean]", str(picture)], capture_output=True, text=True, check=True
            ).stdout.split()
            # A lit room with an avatar: many colours, and hardly any black but beyond the lenses' edges.
            require(int(seen[0]) > 1000 and float(seen[1]) > 0.4, f"{picture} shows no lit room")
        require_valid(rig)
        return f"{len(taken)} pictures in {settings.pictures}"
