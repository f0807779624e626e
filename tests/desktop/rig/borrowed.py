"""What the headset's rig has already: the trace, vectors, processes. Imported first, so that the rest finds it."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[2] / "headset/rig"))
