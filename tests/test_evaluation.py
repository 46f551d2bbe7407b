"""docs/evaluation.md says what its data say, and its data what this specification does now; Box2D is not needed."""

import re
from functools import partial
from pathlib import Path

import pytest
from evaluation import graphbodies, measure
from evaluation.cases import FREE, TICKS, UNITY, Slide
from evaluation.findings import findings
from evaluation.graphbodies import MENDED, PRINTED, VELOCITY, Prototype
from evaluation.gravity import GUESSES, Guess, fit
from evaluation.page import page
from evaluation.tables import DECIMALS, NAMES, Engine, Table, read, read_all

from properties.explain import explain, of_row
from spec.evaluated import EVALUATED, Judgement

DOCS = Path(__file__).parents[1] / "docs"
DATA = DOCS / "evaluation"
TABLES = read_all(DATA)
FINDINGS = {one.statement.id: one for one in findings(TABLES)}
AGAIN = "run `make evaluation`"


def recorded(table: Table) -> list[dict]:
    """The lines of the data that are about the same runs of the same engines."""
    known = {(line["run"], line["engine"], *gravity(line), *instant(line)): line for line in TABLES[table.name].lines}
    return [known[line["run"], line["engine"], *gravity(line), *instant(line)] for line in table.lines]


def gravity(line):
    return (float(line["gravity"]),) if "gravity" in line else ()


def instant(line):
    return (round(float(line["seconds"]), 2),) if "seconds" in line else ()


def assert_recorded(table: Table) -> None:
    for line, old in zip(table.lines, recorded(table), strict=True):
        for key, value in line.items():
            same = value if isinstance(value, str) else pytest.approx(float(value), abs=2 * 10**-DECIMALS)
            assert old[key] == same, f"{table.name}: {line['run']}, {line['engine']}, {key}: {AGAIN}"


def test_the_page_is_what_the_data_say():
    assert (DOCS / "evaluation.md").read_text() == page(TABLES), AGAIN


def test_every_line_names_run_engine_and_version():
    for table in TABLES.values():
        assert table.lines
        assert all(list(line)[:3] == ["run", "engine", "version"] for line in table.lines)
        assert all(line["run"] and line["engine"] and line["version"] for line in table.lines)


def test_every_figure_of_the_page_is_there():
    figures = re.findall(r"\(evaluation/(\w+\.svg)\)", page(TABLES))
    assert sorted(figures) == sorted(path.name for path in DATA.glob("*.svg"))
    assert sorted(NAMES) == sorted(path.stem for path in DATA.glob("*.csv"))


@pytest.mark.parametrize("statement", EVALUATED, ids=lambda one: one.id)
def test_what_is_judged_of_a_statement_is_what_the_run_shows(statement):
    assert FINDINGS[statement.id].judgement is statement.judgement
    assert f'<a id="{statement.section}"></a>' in page(TABLES)


@pytest.mark.parametrize("row", ["E1", "E2", "E3", "E4", "E5", "E6", "E7", "E13", "P1", "P2", "P3", "P4"])
def test_rows_are_found(row):
    assert any(one.kind == "evaluation" for one in of_row(row))


def test_an_explanation_says_where_it_is_measured():
    lines = list(explain(EVALUATED[0]))
    assert "  judgement: confirmed" in lines
    assert "  measured in: docs/evaluation.md#evaluation-gravity-slope" in lines


@pytest.mark.parametrize(
    ("engine", "gravity", "slider"), list(measure.sliders()), ids=["printed", "printed, 10", "mended"]
)
def test_bodies_slide_as_they_are_recorded_to(engine, gravity, slider):
    assert_recorded(measure.on_slopes(engine, gravity, slider))
    if gravity == UNITY:
        assert_recorded(measure.on_flat(engine, gravity, slider))


@pytest.mark.parametrize("engine", VELOCITY)
def test_bodies_at_rest_stay_where_they_are_recorded_to(engine):
    assert_recorded(measure.holds(engine, partial(graphbodies.rests, VELOCITY[engine])))


def test_bodies_slide_to_where_they_are_recorded_to():
    lines = [line for line in TABLES["ends"].lines if line["engine"] in ("graphbody printed", "graphbody mended")]
    for line in lines[::9]:
        run = Slide(line["degrees"], line["friction"], line["speed"])
        engine = PRINTED if line["engine"] == PRINTED.name else MENDED
        ticks = TICKS if run.degrees else measure.TICKS_ON_FLAT
        assert line["end"] == pytest.approx(graphbodies.slide(VELOCITY[engine], run, ticks)[-1], abs=1e-5), AGAIN


def test_boxes_are_pushed_as_they_are_recorded_to():
    assert_recorded(Table("wall", list(measure.lines_at_wall((1, 3)))))
    assert_recorded(Table("scene", list(measure.lines_of_scene((1, 5, 25)))))
    (constant,) = (
        line
        for line in TABLES["constant"].lines
        if line["engine"] == "graphbody thesis" and line["boxes"] == 20 and line["speed"] == 4
    )
    assert constant["mean"] == 4


def test_the_work_of_a_tick_is_what_is_recorded():
    lines = [line for line in TABLES["row"].lines if line["run"] == "edges of 5/4" and "thesis" in line["engine"]]
    game = graphbodies.games(graphbodies.picking_up(measure.BOXES_IN_ROW, measure.EDGES["edges of 5/4"]))
    found = [graphbodies.tick(game[graphbodies.IN_THESIS])[0] for _ in range(40)]
    assert [move.work["queries"] for move in found] == [line["work"] for line in lines[:40]], AGAIN


def test_the_gravity_that_fits_is_found_again():
    run, rules = FREE[12], VELOCITY[PRINTED]
    assert fit(GUESSES[0], run, graphbodies.slide(rules, run, TICKS, 9.5)).best == pytest.approx(9.5)
    inset = Guess("", {}, Prototype(inset=0.01))
    assert fit(inset, run, graphbodies.slide(rules, run, TICKS, UNITY)).best == pytest.approx(UNITY / 0.98)


def test_a_wrong_rule_is_not_judged_as_the_printed_one_is():
    """With data in which 10 fits, the statement on it would be confirmed, and those on what follows refuted."""
    lines = [
        {**line, "furthest": 1, "error at 9.81": 1, "error at 10": 0}
        for name in ("differences", "gravity")
        for line in TABLES[name].lines
    ]
    spoilt = dict(TABLES)
    for name, key in (("differences", "gravity"), ("gravity", "guess")):
        spoilt[name] = Table(name, [line for line in lines if key in line])
    found = {one.statement.id: one.judgement for one in findings(spoilt)}
    assert found["evaluation/gravity-slope"] is Judgement.REFUTED
    assert found["evaluation/gravity-of-10"] is Judgement.CONFIRMED
    assert found["evaluation/flat-friction"] is Judgement.REFUTED


def test_numbers_are_written_and_read_again(tmp_path):
    line = Engine("Box2D", "2").line("a run, with a comma", speed=2.5, along=-0.0000001, guess="(a)")
    Table("some", [line]).write(tmp_path)
    assert read(tmp_path, "some").lines == [{**line, "along": 0.0}]
