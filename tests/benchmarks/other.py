"""CrossHair, in a process of its own.

`python -m benchmarks.other BODIES CHARACTERS LACKING SECONDS` prints what it concluded.
"""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path
from typing import Any

MOST_SECONDS = 200
TESTS = Path(__file__).parents[1]
CONCLUDED = {"confirmed": "confirmed", "exec_err": "refuted", "post_fail": "refuted", "cannot_confirm": "not confirmed"}


def crosshair(bodies: int, characters: int, lacking: int, most_seconds: int) -> dict[str, Any]:
    """What CrossHair concludes of the claim within so many seconds of the processor."""
    sizes = (bodies, characters, lacking, most_seconds)
    command = [sys.executable, "-m", "benchmarks.other", *map(str, sizes)]
    done = subprocess.run(command, cwd=TESTS, capture_output=True, text=True, check=True)
    return dict(json.loads(done.stdout))


def analyse(bodies: int, characters: int, lacking: int, most_seconds: int) -> dict[str, Any]:
    """Let CrossHair explore all paths of the claim; its start-up is not counted."""
    from crosshair.core_and_libs import AnalysisKind, analyze_function, run_checkables
    from crosshair.options import AnalysisOptionSet

    from benchmarks.on_integers import tick

    work: Counter[str] = Counter()
    options = AnalysisOptionSet(
        analysis_kind=[AnalysisKind.asserts],
        report_all=True,
        per_condition_timeout=most_seconds,
        per_path_timeout=most_seconds,
        stats=work,
    )
    started = time.process_time()
    (message,) = run_checkables(analyze_function(tick(bodies, characters, lacking), options))
    seconds = time.process_time() - started
    return {"seconds": seconds, "verdict": CONCLUDED[message.state.value], "paths": work["num_paths"]}


if __name__ == "__main__":
    print(json.dumps(analyse(*map(int, sys.argv[1:]))))
