"""The second solver: cvc5 decides every file of an export, and must answer as Z3 did.

It reads the text of the files and nothing else of this project; what they say of themselves, as their status, is kept
from it. Its budget is counted work.
"""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from multiprocessing import get_context
from os import cpu_count
from pathlib import Path

from properties.evidence.files import LISTED

BUDGET = 10_000_000


class NoExport(Exception):
    """A directory holds no export."""


@dataclass(frozen=True)
class Answer:
    """What the list of an export, a file of it and cvc5 say; None where they say nothing."""

    path: Path
    listed: str | None
    stated: str | None
    answered: str | None

    @property
    def agreed(self) -> bool:
        """Whether all say the same, and it is an answer."""
        return self.answered in ("sat", "unsat") and self.listed == self.stated == self.answered

    def __str__(self) -> str:
        if self.stated is None:
            return f"{self.path}: listed as {self.listed}, but it is not there or states nothing"
        if self.listed is None:
            return f"{self.path}: not one of the obligations listed"
        return f"{self.path}: listed as {self.listed}, states {self.stated}, cvc5 answers {self.answered}"


def decide(proofs: bool, path: Path) -> str:
    """What cvc5 answers; with proofs, one in the format CPC is written beside a file that is unsat."""
    import cvc5

    terms = cvc5.TermManager()
    solver, symbols = cvc5.Solver(terms), cvc5.SymbolManager(terms)
    solver.setOption("rlimit", str(BUDGET))
    solver.setOption("produce-proofs", str(proofs).lower())
    parser = cvc5.InputParser(solver, symbols)
    parser.setFileInput(cvc5.InputLanguage.SMT_LIB_2_6, str(path))
    said = ""
    try:
        while not (command := parser.nextCommand()).isNull():
            if command.getCommandName() != "set-info":
                said += command.invoke(solver, symbols)
    except RuntimeError as error:
        return " ".join(str(error).split())
    answer = said.strip()
    if proofs and answer == "unsat":
        proof = solver.proofToString(solver.getProof()[0], cvc5.ProofFormat.CPC).decode()
        # As an answer, a proof is in parentheses; as a file, a checker wants it without.
        path.with_suffix(".cpc").write_text(proof.strip().removeprefix("(").removesuffix(")").strip() + "\n")
    return answer


def answer_of(proofs: bool, listed: tuple[Path, str | None]) -> Answer:
    """What is said of one file."""
    path, expected = listed
    if not path.exists():
        return Answer(path, expected, None, None)
    stated = re.search(r"\(set-info :status (\w+)\)", path.read_text())
    return Answer(path, expected, stated[1] if stated else None, decide(proofs, path))


def files_of(directory: Path) -> list[tuple[Path, str | None]]:
    """The files that an export lists, with what is to be answered; and those that are there and not listed."""
    try:
        listed: dict[str, str] = json.loads((directory / LISTED).read_text())
    except (OSError, ValueError) as error:
        raise NoExport(f"{directory}: expected an export, with its {LISTED}: {error}") from None
    names = sorted({*listed, *(path.name for path in directory.glob("*.smt2"))})
    return [(directory / name, listed.get(name)) for name in names]


def summary(found: list[Answer]) -> str:
    """How many files there are, what was answered, and how many are not as they must be."""
    count = Counter(answer.answered for answer in found)
    listed = sum(answer.listed is not None for answer in found)
    there = sum(answer.answered is not None for answer in found)
    unknown = there - count["sat"] - count["unsat"]
    differ = sum(not answer.agreed for answer in found)
    return (
        f"{listed} obligations, {there} files; cvc5 answers {count['unsat']} unsat, {count['sat']} sat, "
        f"{unknown} unknown; {differ} differ"
    )


def answers(directory: Path, proofs: bool = False) -> Iterator[Answer]:
    """Have cvc5 decide all files of an export, side by side."""
    files = files_of(directory)
    with ProcessPoolExecutor(cpu_count(), mp_context=get_context("forkserver")) as pool:
        yield from pool.map(partial(answer_of, proofs), files, chunksize=4)
