#!/usr/bin/env python3
"""Runs scenarios of the real program with a real OpenXR runtime. To be started inside the system that
scripts/headset_root.sh makes, as scripts/test_headset.sh does.

    run.py [--program FILE] [--soak SECONDS] [SCENARIO ...]
"""

import argparse
import sys
import time
import traceback
from pathlib import Path

import attention
import endings
import interruptions
import kinds
import scenarios

REPOSITORY = Path(__file__).resolve().parents[3]

SCENARIOS = {
    "no-runtime": scenarios.no_runtime,
    "simple": scenarios.simple_controllers,
    "study": scenarios.whole_study,
    "killed": scenarios.runtime_killed,
    "inattentive": attention.inattentive_participant,
    "strayed": attention.strayed_participant,
    "interrupted": interruptions.interrupted_participant,
    "repeated": interruptions.repeated_trials,
    "endings": endings.ended_by_runtime,
    "kinds": kinds.every_kind,
    "soak": scenarios.soak,
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=REPOSITORY / "build/trixie/deixis")
    parser.add_argument("--runs", default=REPOSITORY / "build/headset-runs", help="folder for logs and databases")
    parser.add_argument("--pictures", default=REPOSITORY / "build/headset-pictures")
    parser.add_argument("--soak", type=float, default=60.0, metavar="SECONDS")
    parser.add_argument("scenarios", nargs="*", metavar="SCENARIO", help=", ".join(SCENARIOS))
    options = parser.parse_args()
    unknown = set(options.scenarios) - set(SCENARIOS)
    if unknown:
        parser.error(f"no scenario is called {', '.join(sorted(unknown))}; there are {', '.join(SCENARIOS)}")
    settings = scenarios.Settings(options.program, options.runs, options.pictures, options.soak)

    failed = 0
    for name in options.scenarios or SCENARIOS:
        start = time.monotonic()
        try:
            outcome, detail = "passed", SCENARIOS[name](settings)
        except Exception as error:  # one scenario's failure does not keep the others from running
            outcome, detail = "FAILED", f"{error}"
            failed += 1
            settings.runs.mkdir(parents=True, exist_ok=True)
            (settings.runs / f"{name}.failure.txt").write_text(traceback.format_exc())
        print(f"headset: {name:12} {outcome} {time.monotonic() - start:6.1f} s  {detail}", flush=True)
    print(f"headset: {len(options.scenarios or SCENARIOS) - failed} passed, {failed} failed", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
