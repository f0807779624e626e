#!/usr/bin/env python3
"""Runs scenarios of the real program at the desktop, on virtual displays, by mouse and keyboard.

    run.py [--program FILE] [--runs FOLDER] [--shorten ITEMS] [--jobs N] [SCENARIO ...]
"""

import argparse
import os
import signal
import sys
import time
import traceback
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import broken_off
import replayed
import rested
import resized
import studies
from window import Desktop

REPOSITORY = Path(__file__).resolve().parents[3]

SCENARIOS = {
    "pointing2023": studies.whole_study("pointing2023", "en"),
    "sgtoolkit2021": studies.whole_study("sgtoolkit2021", "de"),
    "genea-pairwise": studies.whole_study("genea-pairwise", "sv"),
    "distractor-distance": studies.whole_study("distractor-distance", "ko"),
    "pointing-style": studies.whole_study("pointing-style", "en"),
    "free-placement": studies.whole_study("free-placement", "de"),
    "questions": studies.questions,
    "killed": broken_off.killed,
    "paused": broken_off.paused,
    "declined": broken_off.declined,
    "closing": resized.closing_in_view,
    "rested": rested.rested,
    "resized": resized.resized,
    "replayed": replayed.replayed,
}


def attempt(settings, name):
    """Whether it passed; says so."""
    start = time.monotonic()
    try:
        outcome, detail = "passed", SCENARIOS[name](settings)
    except Exception as error:  # one scenario's failure does not keep the others from running
        outcome, detail = "FAILED", f"{error}"
        settings.runs.mkdir(parents=True, exist_ok=True)
        (settings.runs / f"{name}.failure.txt").write_text(traceback.format_exc())
    print(f"desktop: {name:20} {outcome} {time.monotonic() - start:6.1f} s  {detail}", flush=True)
    return outcome == "passed"


def end_all(*_):
    """Nothing is left behind where a time limit ends this."""
    for desktop in list(Desktop.open):
        desktop.close()
    os._exit(1)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path, default=REPOSITORY / "build/release/deixis")
    parser.add_argument("--runs", type=Path, default=REPOSITORY / "build/desktop-runs", help="for logs and databases")
    parser.add_argument("--shorten", type=int, default=0, metavar="ITEMS", help="so many in each stage [all]")
    parser.add_argument("--jobs", type=int, default=1, help="scenarios at the same time")
    parser.add_argument("--size", default="960x540", help="of the window")
    parser.add_argument("scenarios", nargs="*", metavar="SCENARIO", help=", ".join(SCENARIOS))
    options = parser.parse_args()
    unknown = set(options.scenarios) - set(SCENARIOS)
    if unknown:
        parser.error(f"no scenario is called {', '.join(sorted(unknown))}; there are {', '.join(SCENARIOS)}")
    settings = studies.Settings(options.program.resolve(), options.runs.resolve(), options.shorten, options.size)
    names = options.scenarios or list(SCENARIOS)
    signal.signal(signal.SIGTERM, end_all)
    with ThreadPoolExecutor(options.jobs) as pool:
        passed = sum(pool.map(lambda name: attempt(settings, name), names))
    print(f"desktop: {passed} passed, {len(names) - passed} failed", flush=True)
    return 0 if passed == len(names) else 1


if __name__ == "__main__":
    sys.exit(main())
