"""The command line. It imports what a command needs when the command runs, so that help comes at once."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NoReturn

import typer

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from properties.claims.claim import Claim
    from properties.evidence.settle import Jobs
    from properties.evidence.showing import Job
    from properties.evidence.store import Result, Store

app = typer.Typer(
    help="Graph-based 2D character movement: check its specification, play it, look it up.",
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    no_args_is_help=True,
)


def refuse(message: str) -> NoReturn:
    """Bad input: one line, exit status 2."""
    print(f"graphbody: {message}", file=sys.stderr)
    raise typer.Exit(2)


@app.command()
def check(
    claim: Annotated[str | None, typer.Argument(help="A claim's ID; all but the long ones if left out.")] = None,
    long: Annotated[bool, typer.Option("--long", help="All claims that take long, instead.")] = False,
    seed: Annotated[int, typer.Option(help="In which order hunts go through shapes of the same size.")] = 0,
    export: Annotated[Path | None, typer.Option(help="A directory for what Z3 decided, as SMT-LIB 2.")] = None,
    ledgers: Annotated[
        bool, typer.Option("--explain", help="Print what each verdict rests on; proves again with other seeds.")
    ] = False,
) -> None:
    """Settle claims: prove, test or refute them. Exit status 1 if a verdict is not the expected one.

    What an earlier run has shown of the same sources is taken over.
    """
    from rich.console import Console

    from properties.evidence.files import BUILD, JOBS, RESULTS, RESULTS_LONG, WITNESSES
    from properties.evidence.settle import all_jobs, settle
    from properties.evidence.showing import Showing
    from properties.evidence.sources import sources
    from properties.evidence.store import Store
    from properties.report import show_effort, show_ledgers, show_surprises, show_table, write_results

    claims = chosen_claims(claim, long)
    if BUILD.exists() and not BUILD.is_dir():
        refuse(f"{BUILD}: expected a directory, to write results to")
    prepare_export(export)
    store = Store(JOBS if export is None else export / "jobs", sources(), Showing)
    showings = run_all(exporting(export, all_jobs(claims, seed, ledgers)), store)
    if sources() != store.sources:
        refuse("the sources have changed during the run; nothing was written: run it again")
    settled = [settle(one, showings, WITNESSES, seed) for one in claims]
    console = Console(width=None if sys.stdout.isatty() else 120)
    show_table(settled, console)
    show_effort(showings, console)
    if ledgers:
        show_ledgers(settled, showings, console)
    if claim is None:
        path = RESULTS_LONG if long else RESULTS
        write_results(settled, showings, store.sources, path)
        console.print(f"\n{len(settled)} claims; results in {path}", markup=False)
    if export is not None:
        from properties.evidence.export import list_export

        console.print(f"{list_export(export, showings, seed)} obligations in {export}", markup=False)
    show_surprises(settled, console)
    if not all(one.as_expected for one in settled):
        raise typer.Exit(1)


def prepare_export(directory: Path | None) -> None:
    """Make the directory of an export, if there is to be one."""
    if directory is None:
        return
    from properties.evidence.export import Unwritable, prepare

    try:
        prepare(directory)
    except Unwritable as error:
        refuse(str(error))


def exporting(directory: Path | None, jobs: Jobs) -> Jobs:
    """The same jobs, which also export what they explore, if there is a directory to do so."""
    if directory is None:
        return jobs
    from properties.evidence.export import exported

    return exported(directory, jobs)


def chosen_claims(name: str | None, long: bool) -> Sequence[Claim]:
    """The claim of that name, or all that take long, or all that do not."""
    from properties.claims.catalogue import CLAIMS

    if name is None:
        return [one for one in CLAIMS if one.long == long]
    from properties.claims.claim import Claim
    from properties.explain import UnknownID, find

    try:
        found = find(name)
    except UnknownID as error:
        refuse(error.args[0])
    if not isinstance(found, Claim):
        refuse(f"{found.id} is a {found.kind}, not a claim; `graphbody explain {found.id}` says which claims it is in")
    return [found]


def run_all(jobs: Mapping[Job, Callable[[], Result]], store: Store[Result]) -> dict[Job, Result]:
    """Run jobs in processes, with progress on a terminal; those that were done before are taken over."""
    from rich.console import Console
    from rich.progress import Progress

    from properties.evidence.settle import processes, run

    with Progress(console=Console(stderr=True), transient=True, disable=not sys.stderr.isatty()) as progress:
        task = progress.add_task("evidence", total=None)
        executor = processes()

        def tell(done: int, total: int) -> None:
            progress.update(task, completed=done, total=total)

        before = len(store.current(jobs))
        if before:
            print(f"{before} of {len(jobs)} pieces of evidence are taken over from {store.directory}")
        try:
            showings = run(jobs, executor, store, tell)
        except KeyboardInterrupt:
            executor.shutdown(wait=False, cancel_futures=True)
            kept = f"{len(store.current(jobs))} of {len(jobs)} pieces of evidence are kept"
            print(f"graphbody: interrupted; {kept}, the next run goes on from there", file=sys.stderr)
            raise typer.Exit(130) from None
        executor.shutdown()
    return showings


@app.command()
def simulate(
    scenario: Annotated[Path, typer.Argument(help="A scenario file.")],
    floats: Annotated[bool, typer.Option("--floats", help="In binary floating point, as a game would.")] = False,
    as_json: Annotated[bool, typer.Option("--json", help="One JSON line per step.")] = False,
) -> None:
    """Play a scenario, step by step, with the rules that fired."""
    from collections import deque
    from itertools import chain

    import msgspec

    from properties.sketch import sketch
    from properties.telling import text_lines
    from reference.formats.files import FormatError
    from reference.play import play
    from reference.recording import header_of, lines_of

    try:
        if any(step.add or step.remove for step in play(scenario, floats).scenario.steps):
            deque(play(scenario, floats).steps, maxlen=0)
        playing = play(scenario, floats)
    except FormatError as error:
        refuse(str(error))
    record, game = playing.scenario, playing.game
    if as_json:
        for line in chain([header_of(playing, floats)], lines_of(playing)):
            print(msgspec.json.encode(line).decode())
    else:
        print(f"{record.name}: {record.note}" if record.note else record.name)
        print(*sketch(game.world), *text_lines(None, game), sep="\n")
        for step in playing.steps:
            movers = [move.body for move in step.moves]
            print("", *sketch(game.world, movers), *text_lines(step, game), sep="\n")
    if record.solved is not None and record.solved != game.world.solved():
        print(f"graphbody: {scenario}: expected solved to be {record.solved}", file=sys.stderr)
        raise typer.Exit(1)


@app.command()
def validate(
    traces: Annotated[list[Path], typer.Argument(help="Trace files, of any implementation.")],
    as_json: Annotated[bool, typer.Option("--json", help="One JSON line per trace.")] = False,
) -> None:
    """Hold traces against the rules. Exit status 1 if one does not conform, 2 if one is no trace, 3 if this failed."""
    from properties.conformance.account import account, json_line, write_divergence
    from properties.conformance.validate import Crash, validate as report_of
    from reference.formats.files import FormatError

    status = 0
    for trace in traces:
        try:
            report = report_of(trace)
            replay = write_divergence(report)
        except (FormatError, Crash) as error:
            print(f"graphbody: {error}", file=sys.stderr)
            status = max(status, 2 if isinstance(error, FormatError) else 3)
            continue
        print(json_line(report, replay) if as_json else "\n".join(account(report, replay)))
        if report.unread is not None:
            print(f"graphbody: {report.unread}", file=sys.stderr)
        status = max(status, 2 if report.unread is not None else 0 if report.conforms else 1)
    if status:
        raise typer.Exit(status)


@app.command()
def lint(
    level: Annotated[Path, typer.Argument(help="A level or scenario file.")],
    profile: Annotated[
        str | None, typer.Option(help="The profile; if left out, that of the scenario, or thesis.")
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="As a JSON document.")] = False,
) -> None:
    """Look for what may go wrong in a level. Exit status 1 if anything was found."""
    import msgspec

    from properties.lint.account import account, anything, record_of, write_scenarios
    from properties.lint.findings import found_in, opened
    from reference.formats.files import FormatError

    try:
        linted = opened(level, profile)
        record = record_of(linted, found_in(linted))
        write_scenarios(record)
    except FormatError as error:
        refuse(str(error))
    print(msgspec.json.encode(record).decode() if as_json else "\n".join(account(linted, record)))
    if anything(record):
        raise typer.Exit(1)


@app.command()
def draw(
    file: Annotated[Path, typer.Argument(help="A scenario, level or trace file.")],
    out: Annotated[Path, typer.Option(help="The directory for the drawings.")] = Path("build/drawings"),
    steps: Annotated[str, typer.Option(metavar="A-B", help="Only these steps; step 0 is the start.")] = "",
) -> None:
    """Draw a scenario, a level or a trace as SVG: the start and each step, six to a page."""
    from properties.drawings import Undrawable, drawn

    try:
        for path in drawn(file, out, steps):
            print(path)
    except Undrawable as error:
        refuse(str(error))


@app.command()
def schema(
    kind: Annotated[str | None, typer.Argument(help="A kind of file; lists the kinds if left out.")] = None,
) -> None:
    """Print the JSON Schema of a kind of file."""
    from properties import schemas

    if kind is None:
        width = max(map(len, schemas.KINDS))
        print(*(f"{name:<{width}}  {one.sentence}" for name, one in schemas.KINDS.items()), sep="\n")
    elif kind in schemas.KINDS:
        print(json.dumps(schemas.schema(kind), indent=2))
    else:
        refuse(f"expected one of {', '.join(schemas.KINDS)}, got {kind!r}")


@app.command()
def itf(file: Annotated[Path, typer.Argument(help="A scenario, level or trace file.")]) -> None:
    """Print a trace as ITF, the JSON of Apalache and Quint, with exact numbers."""
    from reference.formats.files import FormatError
    from reference.itf import text
    from reference.recording import recording

    try:
        for _ in recording(file).lines:
            pass
        for piece in text(recording(file)):
            print(piece, end="")
    except FormatError as error:
        refuse(str(error))


@app.command()
def explain(
    name: Annotated[
        str, typer.Argument(metavar="ID", help="An ID or an obligation, as in push/request; or a source, as in R22.")
    ],
) -> None:
    """Say what an ID stands for: sentence, source, guard, effect, claims, and a scenario in which it fires."""
    from properties.explain import UnknownID, explain as lines, find, of_row

    try:
        found = of_row(name) if name[:1].isupper() else [find(name)]
    except UnknownID as error:
        refuse(error.args[0])
    print(*("\n".join(lines(statement)) for statement in found), sep="\n\n")


@app.command(name="list")
def list_all(as_json: Annotated[bool, typer.Option("--json", help="As a JSON array.")] = False) -> None:
    """List every rule, invariant, condition, reading and claim."""
    from properties.explain import everything

    table = everything()
    if as_json:
        fields = ("id", "kind", "sentence", "source")
        print(json.dumps([{field: getattr(s, field) for field in fields} for s in table.values()], indent=2))
        return
    width = max(map(len, table))
    for statement in table.values():
        print(f"{statement.id:<{width}}  {statement.kind:<9}  {statement.sentence}")


@app.command()
def handbook(docs: Annotated[Path, typer.Argument(help="The directory of the documents.")] = Path("docs")) -> None:
    """Write the reference: a page for each kind of statement, with pictures, from the last runs of the check."""
    from properties.handbook import NoEvidence, write_handbook

    try:
        print(f"{write_handbook(docs)} entries in {docs / 'reference'}")
    except NoEvidence as error:
        refuse(str(error))


@app.command(name="map")
def make_map(
    again: Annotated[bool, typer.Option("--check", help="Only look at what was found again, and play it.")] = False,
) -> None:
    """Find out what levels are safe under which rules, and write docs/map.md. With --check, exit status 1 if it fails.

    What an earlier run has found out of the same sources is taken over.
    """
    from properties.evidence.files import FOUND
    from properties.evidence.sources import sources
    from properties.evidence.store import Store
    from properties.map.assembly import map_jobs, write_map, wrong_on_the_map
    from reference.formats.files import FormatError

    if not again:
        write_map(run_all(map_jobs(), Store(FOUND, sources(), object)))
    try:
        wrong = list(wrong_on_the_map())
    except FormatError as error:
        refuse(f"{error}; run `make map`")
    print(*wrong, sep="\n", end="\n" if wrong else "")
    if wrong:
        raise typer.Exit(1)


@app.command(name="cross-check")
def cross_check(
    directories: Annotated[list[Path], typer.Argument(help="Directories of exports.")],
    proofs: Annotated[bool, typer.Option("--proofs", help="Write a proof beside each file that is unsat.")] = False,
) -> None:
    """Have cvc5 decide what was exported. Exit status 1 if an answer is not that of Z3 or files are not as listed."""
    from importlib.util import find_spec

    from properties.evidence.cross import NoExport, answers, summary

    if find_spec("cvc5") is None:
        refuse("cross-check needs the package cvc5")
    status = 0
    for directory in directories:
        try:
            found = list(answers(directory, proofs))
        except NoExport as error:
            refuse(str(error))
        differing = [answer for answer in found if not answer.agreed]
        print(*differing, f"{directory}: {summary(found)}", sep="\n")
        if differing or not found:
            status = 1
    if status:
        raise typer.Exit(status)


@app.command()
def mutants(
    record: Annotated[bool, typer.Option("--record", help="Find what catches each, and write it down.")] = False,
    export: Annotated[Path | None, typer.Option(help="A directory for the proofs that fail, as SMT-LIB 2.")] = None,
) -> None:
    """Change the project's source in one place at a time; each change must be caught, as it is recorded to be."""
    from rich.console import Console

    from properties.evidence.mutants.matrix import PAGE, page_of, show_matrix
    from properties.evidence.mutants.record import RECORD, read_record, write_record
    from properties.evidence.mutants.run import exported, lost, record_all

    prepare_export(export)
    if record:
        try:
            found = record_all(read_record(), lambda *told: print(*told, file=sys.stderr, flush=True))
        except KeyboardInterrupt:
            print("graphbody: interrupted; what was found is kept, the next run goes on from there", file=sys.stderr)
            raise typer.Exit(130) from None
        write_record(found)
        PAGE.write_text(page_of(read_record()))
    known = read_record()
    show_matrix(known, Console(width=None if sys.stdout.isatty() else 120))
    wrong = list(lost(known))
    if not PAGE.exists() or PAGE.read_text() != page_of(known):
        wrong.append(f"{PAGE}: expected what {RECORD} says; `make mutants-record` writes both")
    print(*wrong, sep="\n")
    if export is not None:
        from properties.evidence.export import write_list

        print(f"{write_list(export, exported(known, export))} failed obligations in {export}")
    if wrong or not known.kills:
        raise typer.Exit(1)


@app.command()
def compare(
    scenarios: Annotated[int, typer.Option(min=1, help="How many scenarios: levels, each with a request or a tick.")],
    seed: Annotated[int | None, typer.Option(help="The seed of the first thousand, counted on.")] = None,
) -> None:
    """Compare `repaired` with `thesis`, step by step. Exit status 1 if a difference has none of the known causes."""
    from rich.console import Console

    from properties.comparison.campaign import SEED, campaign, told

    console = Console(stderr=True)
    with console.status("comparing") as status:
        tally = campaign(scenarios, SEED if seed is None else seed, lambda done: status.update(f"{done} compared"))
    print(*told(tally), sep="\n")
    if tally.unexplained or tally.tame:
        raise typer.Exit(1)


def main() -> None:
    """Run the command line."""
    app()
