"""What the desktop's rig has already: somebody who answers every kind of board, and what must be kept of it. Imported
first, so that the rest finds it."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[2] / "desktop/rig"))
