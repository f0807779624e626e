"""Clumsy hands: a cursor that rests where an option comes up, clicks without looking, a button held over."""

import borrowed  # noqa: F401
from broken_off import rows
from checks import require
from hands import button
from person import FIRST_RATING, Person
from studies import study_file

OPTION = FIRST_RATING + 3  # "4"


def lit(line):
    return [b["id"] for b in line["buttons"] if b["hovered"]]


def centre(line):
    found = button(line, OPTION)
    return tuple(found["centre"]) if found else None


def rested(settings):
    """Nothing is lit or answered at onset; what is moved to then is."""
    with settings.desktop("rested") as rig:
        database = rig.folder / "study.sqlite"
        trace = rig.run(study_file(settings, rig, "pointing2023", shorten=4), database)
        person = Person(trace, rig.mouse)
        hands = person.hands

        def rating(line):
            return line["state"] == "rating"

        def answers():
            return rows(database, "select count(*) from responses")[0][0]

        person.take_part(stop=rating)
        view = hands.look()["head"]
        require(not lit(hands.look()), "the first board opens with an option lit")
        hands.read()
        hands.point_at("option 4", centre, lambda line: button(line, OPTION)["hovered"])
        rig.mouse.click()
        hands.wait("answer", lambda line: line["state"] == "rated")

        # The cursor rests on "4"; the next board brings it up again.
        hands.wait("next board", lambda line: rating(line) and answers() == 1)
        for _ in range(3):
            rig.mouse.do("click", "--repeat", 2, "--delay", 60, 1)
            hands.trace.settle(0.5)
            require(rating(hands.look()) and not lit(hands.look()), f"a resting cursor lights {lit(hands.look())}")
        require(answers() == 1, "clicks of a cursor that had not moved were kept as an answer")
        require(hands.look()["head"] == view, "the view is elsewhere than with the first board")

        # Moved away and back it is lit, and a click is an answer.
        hands.point_at("option 4", centre, lambda line: button(line, OPTION)["hovered"])
        rig.mouse.click()
        hands.wait("answer", lambda line: line["state"] == "rated")

        # Pressed before the onset and held: no answer, also where it is moved to an option.
        person.take_part(stop=lambda line: line["state"] == "pointing")
        rig.mouse.press()
        hands.wait("next board", rating)
        hands.point_at("option 4", centre, lambda line: button(line, OPTION)["hovered"])
        rig.mouse.release()
        hands.trace.settle(0.5)
        require(rating(hands.look()) and answers() == 2, "a button held over from before was taken for an answer")
        rig.mouse.click()
        hands.wait("answer", lambda line: line["state"] == "rated")
        return "three ratings, each meant"
