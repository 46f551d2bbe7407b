"""The command, run in this process: it need not start, and load the solver, anew for each call."""

import io
import subprocess
from contextlib import chdir, redirect_stderr, redirect_stdout
from pathlib import Path

from typer.main import get_command

from properties.cli import app

COMMAND = get_command(app)


def graphbody(*arguments, cwd=None):
    """Run the command in a directory; return its exit status and what it has printed."""
    words = [str(argument) for argument in arguments]
    out, err = io.StringIO(), io.StringIO()
    with chdir(cwd or Path.cwd()), redirect_stdout(out), redirect_stderr(err):
        try:
            status = COMMAND(words, prog_name="graphbody")
        except SystemExit as end:
            status = end.code
    return subprocess.CompletedProcess(words, status or 0, out.getvalue(), err.getvalue())
