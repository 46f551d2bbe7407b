"""What the documents show is what the commands print, and what they name is there."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

from properties.explain import find

ROOT = Path(__file__).parents[1]
GRAPHBODY = str(Path(sys.executable).parent / "graphbody")
DOCUMENTS = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]


def test_the_scenario_in_the_readme_does_what_the_readme_says(tmp_path):
    text = (ROOT / "README.md").read_text()
    scenario = re.search(r"```json\n(.*?)```", text, re.DOTALL)[1]
    (tmp_path / "slope.json").write_text(scenario)
    done = subprocess.run(
        [GRAPHBODY, "simulate", "slope.json"], cwd=tmp_path, capture_output=True, text=True, check=True
    )
    shown = text[text.index("graphbody simulate slope.json") :].split("\n", 1)[1]
    printed = "\n".join(f"    {line}" if line else "" for line in done.stdout.splitlines())
    assert shown.startswith(printed)


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.name)
def test_every_id_that_a_command_in_a_document_names_is_there(path):
    named = re.findall(r"graphbody (?:check|explain) ([a-z][a-z/-]+)", path.read_text())
    for name in named:
        find(name)


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.name)
def test_every_file_that_a_document_links_to_is_there(path):
    for link in re.findall(r"\]\(([^)#:]+)\)", path.read_text()):
        assert (path.parent / link).exists(), link


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.name)
def test_every_target_that_a_document_names_is_in_the_makefile(path):
    targets = set(re.findall(r"^([a-z-]+):", (ROOT / "Makefile").read_text(), re.MULTILINE))
    assert set(re.findall(r"`make ([a-z-]+)`", path.read_text())) <= targets
