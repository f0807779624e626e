"""A participant who does what was not asked: no answer may come of it."""

import checks
from checks import Database, require
from participant import FIRST_RATING, RESUME, Choices
from scenarios import begin, require_clean_end, require_valid, tiny_study

UNMOVED_S = 0.6  # how long nothing must happen


def require_unanswered(trace, what):
    """For a while no answer is taken, in a trial whose answer is open."""
    trial = trace.now["trial"]
    states = len(trace.states)
    trace.settle(UNMOVED_S)
    taken = [state for state in trace.states[states:] if state.split("-")[0] in ("rated", "chosen")]
    require(not taken and trace.now["trial"] == trial, f"{what} was taken as an answer in trial {trial}")


def pull_both_in_one_frame(rig, person, trace):
    """The runtime looks at one controller after the other: what reaches it between the two comes in two frames."""
    rig.conditions.say("input held")
    frame = trace.now["frame"]
    trace.wait("frames without news of the hands", lambda line: line["frame"] > frame + 2)
    person.trigger(True, "left", "right")
    trace.settle(0.2)
    rig.conditions.say("input passed")


def choosing(line):
    return line["state"].startswith(("choosing", "aiming"))


def inattentive_participant(settings):
    """Head turned away, select too early, both triggers, the other hand, select held on, hands asleep."""
    with settings.rig("inattentive") as rig:
        database = rig.folder / "tiny.sqlite"
        person, trace = begin(rig, database, study=tiny_study(rig), conditions=[])
        choices = Choices()

        def play(until):
            person.take_part(trace, choices, stop=until)

        # Select before the answer is open, and held until well after.
        play(lambda line: line["state"] == "playing")
        person.trigger(True)
        trace.wait("rating", lambda line: line["state"] == "rating")
        person.hover_button(trace, FIRST_RATING + 2)
        require_unanswered(trace, "a select from before the answer was open")
        person.trigger(False)
        require_unanswered(trace, "letting go")

        # Both at once: nobody can tell which was meant. Then the other hand: it takes the ray over, no more.
        pull_both_in_one_frame(rig, person, trace)
        require_unanswered(trace, "a press of both triggers")
        person.trigger(False, "left", "right")
        trace.settle(UNMOVED_S)
        person.aim(trace, button_centre(trace, FIRST_RATING), hand="left")
        person.trigger(True, "left")
        require_unanswered(trace, "the press that takes the ray over")
        person.trigger(False, "left")
        person.aim_away("right")
        person.hand = "left"
        person.rate(trace, choices.rating(trace.now["trial"]))

        # The answer's press held on into the next trial, and through its answer.
        play(lambda line: line["state"] == "rating")
        held = trace.now["trial"]
        person.hover_button(trace, FIRST_RATING)
        person.trigger(True)
        trace.wait("rated", lambda line: line["state"] == "rated")
        person.has_given(held, rating=1)
        trace.wait("instructions", lambda line: line["state"] == "instructions")
        person.hover_button(trace, 1)
        trace.settle(UNMOVED_S * 2)
        require(trace.now["state"] == "instructions", "a select held on has turned a page")
        person.trigger(False)

        play(choosing)
        first = trace.now["trial"]
        place = choices.place(first)
        person.hover_ball(trace, place)
        person.trigger(True)
        trace.wait("chosen", lambda line: line["state"].startswith("chosen"))
        person.has_given(first, place=place)
        trace.wait("next answer", lambda line: choosing(line) and line["trial"] != first)
        person.hover_ball(trace, 1)
        require_unanswered(trace, "a select held since the trial before")
        person.trigger(False)
        require_unanswered(trace, "letting go")

        # Looking away: nothing behind one's back is met.
        centre = trace.now["balls"][1]["centre"]
        person.stand(turn_deg=150.0)
        person.aim(trace, centre, look=False)
        trace.wait("balls without light", lambda line: all(ball["look"] != "hovered" for ball in line["balls"]))
        person.trigger(True)
        require_unanswered(trace, "a select while looking away")
        person.trigger(False)

        # Hands asleep for a while: the participant is told, and goes on.
        person.stand()
        person.awake(False)
        trace.wait("notice of the lost pointer", lambda line: line["notice"] != "" and line["ray"] is None)
        person.awake(True)
        person.hover_ball(trace, 1)
        trace.wait("no notice", lambda line: line["notice"] == "")
        person.choose(trace, choices.place(trace.now["trial"]))

        # A pause by the menu button, with a select beside the buttons.
        play(choosing)
        person.button("b_click", True)
        trace.wait("pause", lambda line: line["state"] == "paused")
        person.button("b_click", False)
        person.aim_away()
        person.trigger(True)
        trace.settle(UNMOVED_S)
        require(trace.now["state"] == "paused", "a select beside the buttons has ended the pause")
        person.trigger(False)
        person.hover_button(trace, RESUME)
        person.press_until(trace, "the answer again", choosing)

        person.take_part(trace, choices)
        require_clean_end(rig)
        count = checks.check_exactly_given(database, person.given)
        require(count == 6, f"{count} answers instead of 6")
        with Database(database) as db:
            kinds = {row["kind"] for row in db.rows("select distinct kind from events")}
            for kind in ("early_select", "pointing_hand", "pointer_lost", "pause", "resume"):
                require(kind in kinds, f"no '{kind}' was recorded, only {sorted(kinds)}")
        require_valid(rig)
        return f"{count} answers, all meant"


def button_centre(trace, button):
    return next(b["centre"] for b in trace.now["buttons"] if b["id"] == button)


def strayed_participant(settings):
    """Steps off the place, is asked back, comes back; takes another place by the recentre button."""
    with settings.rig("strayed") as rig:
        database = rig.folder / "tiny.sqlite"
        person, trace = begin(rig, database, study=tiny_study(rig))
        choices = Choices()
        person.take_part(trace, choices, stop=choosing)
        strayed = trace.now["trial"]
        person.step_aside(0.6)
        trace.wait("request to step back", lambda line: "back" in line["notice"].lower())
        person.choose(trace, choices.place(strayed))
        person.step_aside(0.0)
        trace.wait("no notice", lambda line: line["notice"] == "")

        person.take_part(trace, choices, stop=lambda line: choosing(line) and line["trial"] != strayed)
        placed = len(trace.note("placement"))
        person.step_aside(0.5)
        trace.wait("request to step back", lambda line: "back" in line["notice"].lower())
        person.button("thumbstick_click", True)
        trace.wait("another place", lambda line: len(trace.note("placement")) > placed)
        person.button("thumbstick_click", False)
        trace.wait("no notice", lambda line: line["notice"] == "")
        person.take_part(trace, choices)
        require_clean_end(rig)
        count = checks.check_exactly_given(database, person.given)
        require(count == 6, f"{count} answers instead of 6")
        with Database(database, tracking=True) as db:
            off = db.value("select max_off_place_m from trial_tracking where trial_index = ?", strayed)
            require(0.55 < off < 0.65, f"the strayed trial is marked with {off:.2f} m")
            marked = [row["trial_index"] for row in db.rows("select * from events where kind = 'off_place'")]
            require(strayed in marked, f"the trials marked as off the place are {marked}")
            by = [row["detail"] for row in db.rows("select detail from events where kind = 'recentre'")]
            require(by == ["button"], f"the recentrings recorded are {by}")
            last = db.rows(
                "select off_place_m from tracking where trial_index = (select max(trial_index) from responses) "
                "order by frame desc limit 1"
            )[0]["off_place_m"]
            require(last < 0.1, f"after recentring the participant is {last:.2f} m off the place")
        require_valid(rig)
        return f"{count} answers, {off:.2f} m off the place"
