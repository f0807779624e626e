"""Studies that ship, with fewer items: the same stages, boards and kinds of answer, in a minute or two."""

import re


def shortened(text, items):
    """The study file's text with at most so many items in each stage, and breaks that are short and come early."""

    def at_most(key, most, text):
        return re.sub(
            rf"^{key} = (\d+(?:\.\d+)?)", lambda found: f"{key} = {min(float(found[1]), most):g}", text, flags=re.MULTILINE
        )

    head, stages = text.split("[[stages]]", 1)
    for key, most in (
        ("items", items), ("break_every", 3 * items), ("break_minimum_s", 2), ("minimum_s", 2), ("count", 1),
    ):
        stages = at_most(key, most, stages)
    if items == 1:  # all of one target
        stages = stages.replace("no_target_twice_running = true", "no_target_twice_running = false")
    return head + "[[stages]]" + stages
