"""Sessions that are interrupted: paused, ended early and gone on with, killed, declined."""

import signal
import subprocess
import time

import borrowed  # noqa: F401
import kept
from checks import Database, require
from hands import button, slider
from person import FIRST_SLIDER, Person
from processes import until
from studies import require_clean_end, study_file

DECLINE, END_SESSION, END_FOR_GOOD = 8, 3, 5


def at_page(stage, state="watching"):
    return lambda line: line["stage"] == stage and line["state"] == state


def rows(database, query, *values):
    with Database(database) as db:
        return [tuple(row) for row in db.rows(query, *values)]


def killed(settings):
    """kill -9 in the middle of a page of parallel ratings; the same command goes on with that page."""
    with settings.desktop("killed") as rig:
        database = rig.folder / "study.sqlite"
        study = study_file(settings, rig, "sgtoolkit2021", shorten=1)
        person = Person(rig.run(study, database), rig.mouse)
        person.take_part(stop=at_page("human-likeness"))
        page = person.hands.look()["trial"]
        for stimulus in (0, 2):
            person.play(stimulus)
        person.rate_on_page(2)
        answered = rows(database, "select * from responses order by id")
        require(len(answered) == len(person.meant), f"{len(answered)} answers are kept before the kill")
        require(all(row[0] for row in rows(database, "pragma integrity_check")), "the database is damaged")
        rig.deixis.popen.send_signal(signal.SIGKILL)
        require(rig.deixis.wait(30.0) == -signal.SIGKILL, "the program was not killed")

        trace = rig.run(study, database)
        person.sits_down_again(trace, rig.mouse)
        person.take_part(stop=at_page("human-likeness"))
        pages = [state for state in trace.states if state != "paused"]  # a new window may lose the focus for once
        # Nothing of the stage is answered, so its instructions come once more.
        require(pages == ["welcome-back", "instructions", "watching"], f"after the kill came {pages}")
        line = person.hands.look()
        require(line["trial"] == page, f"it goes on at trial {line['trial']}, not at {page}")
        require(
            slider(line, FIRST_SLIDER + 2)["value"] is None and not slider(line, FIRST_SLIDER + 2)["enabled"],
            "a page that was not handed in is not empty",
        )
        person.take_part()
        require_clean_end(rig)
        count = kept.check_whole_session(database, person.meant)
        after = rows(database, "select * from responses order by id")
        require(after[: len(answered)] == answered, "an answer from before the kill was changed")
        begun = rows(database, "select trial_index from responses where begun_before = 1")
        require(begun == [(page,)], f"marked as begun before: {begun}")
        outcomes = rows(database, "select outcome from sessions order by id")
        require(outcomes == [(None,), ("finished",)], f"the outcomes are {outcomes}")
        return f"killed in trial {page} of {count}, after {len(answered)} answers"


def paused(settings):
    """Esc on a page, in a clip, on a questionnaire and before a choice; full screen; ended and gone on with."""
    with settings.desktop("paused") as rig:
        database = rig.folder / "study.sqlite"
        study = study_file(settings, rig, "pointing-style", shorten=1)
        trace = rig.run(study, database)
        person = Person(trace, rig.mouse, seed=2)
        hands = person.hands

        def escape():
            hands.press_key("Escape", lambda line: line["state"] == "paused")

        # On a page of questions: what was answered stays.
        person.take_part(stop=lambda line: line["state"] == "questionnaire")
        line = hands.look()
        option = next(b["id"] for b in line["buttons"] if b["role"] == "option")
        hands.pick(option)
        trial = line["trial"]
        escape()
        person.take_part(stop=lambda now: now["state"] == "questionnaire")
        line = hands.look()
        require(line["trial"] == trial and button(line, option)["chosen"], "the pause lost what was answered")

        full_screen(rig, hands)
        look_elsewhere(rig, hands)

        # In a clip: it starts over.
        person.take_part(stop=lambda now: now["state"] == "playing" and now["stage"] == "certainty")
        clip = hands.look()["trial"]
        escape()
        before = len(person.meant)
        person.take_part(stop=lambda now: now["state"] == "waiting")
        require(hands.look()["trial"] == clip and len(person.meant) == before, "the clip did not start over")

        # Before a choice: the time does not count.
        person.take_part(stop=lambda now: now["state"].startswith("choosing") and now["stage"] == "game")
        choice = hands.look()["trial"]
        escape()
        paused_at = time.monotonic()
        hands.wait("a while", lambda now: time.monotonic() - paused_at > 3.0)
        person.take_part(stop=lambda now: now["state"].startswith("confidence"))

        # Ended on the board of the pause, which asks twice; then gone on with.
        escape()
        hands.click_button(END_SESSION)
        hands.click_button(END_FOR_GOOD, lambda now: now["state"] == "over")
        require_clean_end(rig)
        require(rows(database, "select outcome from sessions") == [("quit",)], "the session is not marked as ended")
        del person.meant[choice]  # without the confidence it was no answer
        person.sits_down_again(rig.run(study, database), rig.mouse)
        person.take_part()
        require_clean_end(rig)
        count = kept.check_whole_session(database, person.meant)
        check_pauses(database, clip, choice)
        return f"{count} answers, {len(rows(database, 'select 1 from events where kind = ?', 'pause'))} pauses"


def full_screen(rig, hands):
    """F11 fills the screen and gives it back; nothing else changes."""
    windowed = rig.window_size()
    line = hands.look()
    for wanted in ((1280, 800), windowed):
        rig.mouse.key("F11")
        until(f"window of {wanted}", lambda: rig.window_size() == wanted, 30.0)
        frames_pass(hands)
    require(hands.look()["state"] in (line["state"], "paused"), "F11 changed what is shown")


def frames_pass(hands):
    seen = hands.look()["frame"]
    hands.wait("frames", lambda now: now["frame"] > seen + 3)


def look_elsewhere(rig, hands):
    """Somebody takes the mouse to another window and back: that pauses, and does not turn the participant's head."""
    root = subprocess.run(
        ["xdotool", "search", "--maxdepth", "0", ""], env=rig.environment, capture_output=True, text=True, check=True
    ).stdout.split()[0]
    rig.mouse.do("windowfocus", root)
    hands.wait("pause", lambda now: now["state"] == "paused")
    frames_pass(hands)
    before = hands.look()["head"]
    rig.mouse.do("mousemove", 1100, 700)
    rig.focus()
    frames_pass(hands)
    turned = max(abs(now - then) for now, then in zip(hands.look()["head"], before))
    require(turned < 1e-6, f"the mouse elsewhere turned the head: {before} became {hands.look()['head']}")


def check_pauses(database, clip, choice):
    reasons = {row[0] for row in rows(database, "select detail from events where kind = 'pause'")}
    require("escape" in reasons, f"the pauses are {reasons}")
    pauses, waited_s = rows(database, "select pauses, paused_s from responses where trial_index = ?", clip)[0]
    require(pauses >= 1 and waited_s == 0.0, f"trial {clip}: {pauses} pauses of {waited_s} s")
    begun = rows(database, "select begun_before from responses where trial_index = ?", choice)[0][0]
    require(begun == 1, f"trial {choice} is not marked as begun before")


def declined(settings):
    """Who does not agree is thanked and asked nothing."""
    with settings.desktop("declined") as rig:
        database = rig.folder / "study.sqlite"
        trace = rig.run(study_file(settings, rig, "sgtoolkit2021", shorten=1), database)
        person = Person(trace, rig.mouse)
        person.take_part(stop=lambda line: line["state"] == "consent")
        person.hands.click_button(DECLINE)
        person.hands.click_button(END_FOR_GOOD)
        person.take_part()
        require_clean_end(rig)
        states = [state for state in trace.states if state != "over"]
        require(states == ["consent", "closing"], f"the session was in {states}")
        require(rows(database, "select outcome from sessions") == [("declined",)], "the outcome is not 'declined'")
        require(rows(database, "select agreed from consents") == [(0,)], "the consent is not kept as declined")
        return "nothing was asked"
