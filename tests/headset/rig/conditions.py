"""Speaks to the API layer in tests/headset/conditions_layer, which brings about what a simulated headset cannot do. Its
commands.hpp has the language."""

import json

LAYER = "XR_APILAYER_DEIXIS_conditions"


class Conditions:
    """Those of one run of the program."""

    def __init__(self, file, *first):
        self.file = file
        self.file.write_text("".join(f"{line}\n" for line in first))

    def say(self, *lines):
        """Holds from the program's next look at the runtime's events on."""
        with open(self.file, "a", encoding="utf-8") as file:
            file.write("".join(f"{line}\n" for line in lines))

    def counts(self):
        """What the layer has counted, once the program has ended."""
        return json.loads(self.file.with_name(self.file.name + ".counts").read_text())
