"""The reference in docs has an entry for each ID, and pictures that are not from an old run."""

import re
from pathlib import Path

import pytest

from properties.claims.claim import Claim, Verdict
from properties.explain import everything, firings, witness_of
from properties.handbook import NoEvidence, page_of, picture_of, slug, write_handbook
from reference.draw import strip
from reference.recording import recording
from spec.profiles import PROFILES
from spec.registry import rules_of

REFERENCE = Path(__file__).parents[1] / "docs" / "reference"
RULES = list({rule.id: rule for profile in PROFILES.values() for rule in rules_of(profile)}.values())
REFUTED = [one for one in everything().values() if isinstance(one, Claim) and one.expected is Verdict.REFUTED]


def test_every_id_has_its_entry_with_its_sentence_and_source():
    for one in everything().values():
        page = (REFERENCE / page_of(one).file).read_text()
        entry = page.partition(f'<a id="{slug(one.id)}"></a>')[2].partition("<a id=")[0]
        assert f"## {one.id}\n\n{one.sentence}\n" in entry, "run `make docs`"
        assert f"- source: {one.source}\n" in entry, "run `make docs`"


def test_every_entry_has_an_id():
    slugs = {slug(name) for name in everything()}
    for page in REFERENCE.glob("*.md"):
        assert set(re.findall(r'<a id="([^"]+)">', page.read_text())) <= slugs


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.id)
def test_the_picture_of_a_rule_is_drawn_by_this_version(rule):
    found = firings()[rule.id]
    drawn = strip(recording(found.path), found.step - 1, found.step)
    assert (REFERENCE / "pictures" / picture_of(found)).read_text() == drawn, "run `make docs`"


@pytest.mark.parametrize("claim", REFUTED, ids=lambda claim: claim.id)
def test_the_picture_of_a_refuted_claim_is_that_of_its_witness(claim):
    witness = REFERENCE / "witnesses" / witness_of(claim).name
    drawn = strip(recording(witness), 0)
    assert (REFERENCE / "pictures" / f"{slug(claim.id)}.svg").read_text() == drawn, "run `make docs`"


def test_without_evidence_nothing_is_written(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(NoEvidence, match="run `make check` and `make check-long` first"):
        write_handbook(tmp_path / "docs")
    assert list(tmp_path.iterdir()) == []
