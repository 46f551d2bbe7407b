"""The contract of a request, proved of the code of the rules by taking one edge and one neighbour at a time.

The argument. Let *capacity* be how far a body can move at most: to the wall, and to its neighbour after that
has moved by its own capacity (not at all, at the push limit). The contract: a request to move by `d` moves the
body by `min(d, capacity)`, and its neighbour by what that exceeds the room between them. It follows by
induction on the length of the chain that may still be asked (`spare`, which falls by one with each `Ask`): in
each obligation an `Ask` is answered by the contract itself. Within one request it follows by induction on the
edges: one segment keeps the loop's invariant, and leaves behind an edge of positive length each time it goes
on. The pair of a body and the one behind it only moves apart; no other pair is touched.

Each function below is one obligation. It reads the rules from its first argument, so that it can be tried on
wrong ones, and its values from the second, so that it can be proved, replayed and sampled.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from dataclasses import dataclass, field, replace
from typing import Any, TypeVar

from properties.contracts.contract import (
    AS_FAR,
    AT_MOST,
    LEAVING,
    MARGIN,
    ON_EDGE,
    REAR,
    REQUEST,
    REQUEST_EXACT,
    SEGMENT,
    SEGMENT_EXACT,
    Ahead,
    Call,
    Contract,
    Parting,
    Stretch,
    assume_required,
    promise,
    stand_in_for,
)
from properties.given import Given, Infeasible
from properties.worlds.window import ME, NEIGHBOUR, Capacity, Spot, Window, capacity, lonely_window, spot, window
from spec.conditions import IN_ORDER
from spec.invariants import every
from spec.rule import AnyFamily, AnyRule, Chooser, Family, GuardError, Rule
from spec.rules.leave import Departure, Placement
from spec.rules.push import Way
from spec.rules.request import Ask, Rules, request
from spec.rules.walk import Motion, Tow, walk

Grant = Callable[[Ask[Any, str]], Any]
ONE_RULE = "rules/one-applies"
P = TypeVar("P")
MOST_CHOICES = 20
MOST_ROUNDS = 3
EXACT_SEGMENT = (SEGMENT, SEGMENT_EXACT)


@dataclass(frozen=True)
class Seen:
    """A family that reports to a `Given` which rules it chose, and breaks a promise where it cannot choose.

    A window has two edges: who chooses again and again goes on without getting on, and breaks a promise too; `most` is
    how often is too often.
    """

    family: Chooser
    given: Given
    most: int = MOST_CHOICES
    chosen: list[str] = field(default_factory=list)

    def choose(self, facts: Any) -> AnyRule:
        """Return the rule that applies."""
        if len(self.chosen) == self.most:
            self.given.ensure("it ends", False)
            raise Infeasible
        try:
            rule = self.family.choose(facts)
        except GuardError:
            self.given.ensure(ONE_RULE, False)
            raise Infeasible from None
        self.chosen.append(rule.id)
        self.given.saw(rule.id)
        return rule


def seen_by(given: Given, rules: Rules) -> Rules:
    """The same rules, seen."""
    return rules.through(lambda family: Seen(family, given))


def judged(program: Callable[[P, Given], None], profile: P, given: Given) -> None:
    """Run an obligation; it fails where no rule or two apply, or an effect's own requirement (an `assert`) fails."""
    try:
        program(profile, given)
    except GuardError:
        given.ensure(ONE_RULE, False)
        raise Infeasible from None
    except AssertionError:
        given.ensure("what an effect requires of its facts holds", False)
        raise Infeasible from None


def drive(given: Given, running: Generator[Ask[Any, str], Any, Any], seen: Window, grant: Grant) -> Any:
    """Run a program of the rules, answering each `Ask` by a contract, whose requirements it must meet."""
    answer = None
    while True:
        try:
            ask = running.send(answer)
        except StopIteration as end:
            return end.value
        given.ensure("asks for a distance", ask.distance is not None)
        if ask.distance is None:
            raise Infeasible
        promise(given, REQUEST, Call(asked=ask.distance, moved=ask.distance), REQUEST.requires)
        given.ensure("only the neighbour is asked", ask.body is NEIGHBOUR)
        seen.asks.append(ask)
        answer = grant(ask)
        seen.granted = seen.granted + answer


def any_motion(given: Given, at: Spot) -> Motion[Any, Spot]:
    """A motion anywhere in its course."""
    return Motion(at, rest=given.number("distance left"))


def granted_by(given: Given, *contracts: Contract, capacity: Any | None = None) -> Grant:
    """Answer each `Ask` by the contracts of the request that is asked for, which has this capacity."""

    def grant(ask: Ask[Any, str]) -> Any:
        granted = given.number("distance granted")
        for contract in contracts:
            stand_in_for(given, contract, Call(asked=ask.distance, moved=granted, capacity=capacity))
        return granted

    return grant


def ahead_in(seen: Window, spare: Any, able: Capacity | None) -> Ahead:
    """What lies ahead in a window; what it does not show is left out where a contract does not speak of it."""
    gap = seen.gap(seen.start, NEIGHBOUR) if seen.neighbour else None
    edges = () if seen.next_length is None else (seen.next_length,)
    wall, neighbour = (None, None) if able is None else (able.wall, able.neighbour)
    return Ahead(seen.margin, gap, wall, neighbour, spare, seen.may_push, edges)


def run_segment(
    rules: Rules, given: Given, seen: Window, contract: Contract, able: Capacity | None = None
) -> tuple[Stretch, Motion[Any, Spot]]:
    """One segment of any motion in a window that meets the requirements of a contract, and the motion after it.

    Requests are answered by their contract: the exact one if it is known what the neighbour is able to do.
    """
    spare, before = given.natural("bodies that may still be asked"), any_motion(given, seen.start)
    ahead = ahead_in(seen, spare, able)
    assume_required(given, contract, Call(asked=before.rest, moved=before.rest, ahead=ahead))
    grant = granted_by(given, REQUEST)
    if able is not None:
        grant = granted_by(given, REQUEST, REQUEST_EXACT, capacity=able.neighbour)
    after = drive(given, rules.segment(seen_by(given, rules), seen, ME, before, spare), seen, grant)
    stretch = stretch_of(seen, before, after, ahead)
    if able is None:
        return stretch, after
    later = ahead.after(stretch.moved, stretch.pushed)
    return replace(stretch, capacity=ahead.capacity(), left=later.capacity()), after


def stretch_of(seen: Window, before: Motion[Any, Spot], after: Motion[Any, Spot], ahead: Ahead) -> Stretch:
    """The facts of one segment, or of one walk, in a window."""
    behind = after.at.length - after.at.reach
    return Stretch(
        asked=before.rest,
        moved=before.rest - after.rest,
        ahead=ahead,
        pushed=seen.granted,
        borders=(after.at.travelled - before.at.travelled,),
        spare=ahead.spare,
        asks=tuple(ask.spare for ask in seen.asks),
        going=after.going,
        length=before.at.length,
        reach=before.at.reach,
        slack=(behind,) if seen.ledge else (behind, after.at.reach),
        to_go=after.rest + behind,
    )


def segment_keeps_its_contract(rules: Rules, given: Given) -> None:
    """On any edge, with any neighbour in order: a segment keeps its contract, and goes on only to the next edge."""
    seen = window(given, ledges=True)
    stretch, after = run_segment(rules, given, seen, SEGMENT)
    promise(given, SEGMENT, stretch)
    given.ensure("there was an ask to spare", every(stretch.spare > 0 for _ in stretch.asks))
    given.ensure("goes on to the next edge", not after.going or after.at.edge == seen.start.edge + 1)


def segment_keeps_margin(rules: Rules, given: Given) -> None:
    """With edges at least as long as the margin: the border comes no nearer to its neighbour than the margin."""
    stretch, _ = run_segment(rules, given, window(given, ledges=True), SEGMENT_EXACT)
    promise(given, SEGMENT_EXACT, stretch, [MARGIN])


def segment_exact(rules: Rules, given: Given) -> None:
    """With margins kept and edges as long: a segment moves as far as possible, or is on its way there."""
    seen = window(given)
    stretch, _ = run_segment(rules, given, seen, SEGMENT_EXACT, capacity(given, seen))
    promise(given, SEGMENT_EXACT, stretch)


def request_is_its_segments(rules: Rules, given: Given) -> None:
    """A request moves its front by its segments as long as they go on, tows its rear, leaves its edge if it must, and
    says how far it moved.

    Segments, towing and leaving are stood in for by their contracts.
    """
    seen = window(given, ledges=True)
    seen = replace(seen, resting=spot(given, "front at rest"), back=spot(given, "rear"))
    assert seen.resting is not None
    distance, spare = given.number("distance asked"), given.natural("bodies that may be asked")
    rear_goes, ends = (
        spot(given, "rear after the move"),
        Placement(object(), object(), given.number("moved in the end")),
    )
    rounds: list[Motion[Any, Spot]] = [Motion(seen.resting, rest=distance)]
    tows: list[Tow[Any, Spot]] = []
    departures: list[Departure[Any, Any]] = []

    def segments(own: Rules, view: Window, body: str, motion: Motion[Any, Spot], left: Any) -> Any:
        given.ensure("each segment takes over from the one before", same_motion(motion, rounds[-1]))
        given.ensure("each segment may ask as many", left == spare)
        given.ensure("each segment is of this body, by these rules", own is stand_ins and view is seen and body is ME)
        yield from ()
        going, went = any_round(given, len(rounds))
        stand_in_for(given, SEGMENT, Stretch(asked=motion.rest, moved=went, going=going))
        front = spot(given, f"front after segment {len(rounds)}")
        rounds.append(Motion(front, rest=motion.rest - went, going=going))
        return rounds[-1]

    def towed(tow: Tow[Any, Spot]) -> Spot:
        tows.append(tow)
        return rear_goes

    def leaves(leaving: Departure[Any, Any]) -> Placement[Any, Any]:
        departures.append(leaving)
        stand_in_for(given, LEAVING, Parting(leaving, ends), [AS_FAR])
        return ends

    stand_ins = replace(rules, segment=segments, follow=stand_in("follow", towed), leave=stand_in("leave", leaves))
    moved = drive(given, request(stand_ins, seen, ME, distance, spare), seen, granted_by(given, REQUEST))
    went = distance - rounds[-1].rest
    given.ensure("segments follow as long as they go on", not rounds[-1].going)
    given.ensure("the rear is towed once", len(tows) == 1)
    for tow in tows:
        given.ensure("it is the rear that is towed", tow.rear is seen.back and tow.view is seen)
        given.ensure("it walks by these rules", tow.walk is stand_ins.walk)
        given.ensure("the rear is towed by the distance moved", tow.moved == went)
    given.ensure("it leaves, or stays, once", len(departures) == 1)
    for leaving in departures:
        given.ensure("it leaves from where the front went", leaving.front is rounds[-1].at)
        given.ensure("it leaves from where the rear was towed", leaving.rear is rear_goes)
        given.ensure("it leaves with the distance moved", leaving.moved == went)
    given.ensure("says how far it moved", moved == ends.moved)
    given.ensure("places its own body where it came to stand, once", seen.placed == [(ME, ends.front, ends.rear)])
    promise(given, REQUEST, Call(asked=distance, moved=moved), [AT_MOST])


def request_of(rules: Rules, given: Given, start: Ahead, *contracts: Contract) -> Call:
    """Any request of a body that stays, with something ahead, its segments and its rear border by contracts.

    A segment that goes on may be several in a row (`segments_in_a_row`), so one and the last stand for any number.
    """
    seen = lonely_window(given, ledges=False)
    seen = replace(seen, resting=spot(given, "front at rest"), back=spot(given, "rear"))
    assert seen.resting is not None
    assert seen.back is not None
    distance, states, pushed = given.number("distance asked"), [start], [start.margin * 0]

    def segments(own: Rules, view: Window, body: str, motion: Motion[Any, Spot], left: Any) -> Any:
        yield from ()
        number = len(states)
        going, went = any_round(given, number, most=2)
        stretch = any_stretch(given, f"segment {number}", motion.rest, states[-1], going, went, *contracts)
        states.append(states[-1].after(stretch.moved, stretch.pushed))
        pushed.append(pushed[-1] + stretch.pushed)
        return Motion(view.along(motion.at, went), motion.rest - went, going)

    def towed(tow: Tow[Any, Spot]) -> Spot:
        return tow.view.along(tow.rear, tow.moved)

    def stays(leaving: Departure[Any, Any]) -> Placement[Any, Any]:
        return Placement(leaving.front, leaving.rear, leaving.moved)

    stand_ins = replace(rules, segment=segments, follow=stand_in("follow", towed), leave=stand_in("leave", stays))
    moved = drive(given, request(stand_ins, seen, ME, distance, start.spare), seen, granted_by(given))
    ((_, front, rear),) = seen.placed
    borders = (front.travelled, rear.travelled)
    call = Call(asked=distance, moved=moved, ahead=start, pushed=pushed[-1], borders=borders, spare=start.spare)
    exact = SEGMENT_EXACT in contracts
    return replace(call, capacity=start.capacity(), left=states[-1].capacity()) if exact else call


def request_keeps_its_contract(rules: Rules, given: Given) -> None:
    """By the contracts of its segments and of its rear border, a request of a body that stays keeps its own."""
    promise(given, REQUEST, request_of(rules, given, any_order(given), SEGMENT))


def request_exact(rules: Rules, given: Given) -> None:
    """By the exact contract of its segments, a request moves as far as it can, and pushes the excess over the room."""
    promise(given, REQUEST_EXACT, request_of(rules, given, any_ahead(given), *EXACT_SEGMENT))


def any_order(given: Given) -> Ahead:
    """Anything ahead of a body: a body ahead of it, at any distance, or none."""
    gap = given.number("gap", IN_ORDER.id) if given.flag("a body is ahead") else None
    return Ahead(given.number("margin"), gap, None, None, given.natural("bodies that may be asked"))


def any_ahead(given: Given) -> Ahead:
    """Anything ahead of a body that a request requires: a wall or none, a body at the margin or further, or none."""
    margin, spare = given.number("margin"), given.natural("bodies that may be asked")
    wall = given.number("distance to the wall") if given.flag("there is a wall") else None
    if not given.flag("a body is ahead"):
        return Ahead(margin, None, wall, None, spare)
    gap, able = given.number("gap"), given.number("capacity of the neighbour")
    ahead = Ahead(margin, gap, wall, able, spare, given.flag("the body may push"))
    assume_required(given, REQUEST_EXACT, Call(asked=gap, moved=gap, ahead=ahead))
    return ahead


def any_stretch(
    given: Given, name: str, asked: Any, ahead: Ahead, going: bool, moved: Any, *contracts: Contract
) -> Stretch:
    """Any segment that keeps some contracts, with something ahead."""
    pushed = given.number(f"pushed in {name}")
    stretch = Stretch(asked=asked, moved=moved, ahead=ahead, pushed=pushed, going=going)
    if SEGMENT_EXACT in contracts:
        later = ahead.after(moved, pushed)
        stretch = replace(stretch, capacity=ahead.capacity(), left=later.capacity())
    for contract in contracts:
        stand_in_for(given, contract, stretch)
    return stretch


def any_round(given: Given, number: int, most: int = MOST_ROUNDS) -> tuple[bool, Any]:
    """Whether a segment goes on, and how far it went: any, but that the last one ends."""
    going = number < most and given.flag(f"segment {number} goes on")
    return going, given.number(f"distance of segment {number}")


def two_stretches(given: Given, ahead: Ahead, *contracts: Contract) -> Stretch:
    """Any segment that goes on and the one after it, as if they were one."""
    asked = given.number("distance asked")
    one = any_stretch(given, "the first", asked, ahead, True, given.number("distance of the first"), *contracts)
    further, rest = ahead.after(one.moved, one.pushed), asked - one.moved
    going, went = given.flag("it goes on again"), given.number("distance of the second")
    two = any_stretch(given, "the second", rest, further, going, went, *contracts)
    moved, pushed = one.moved + two.moved, one.pushed + two.pushed
    return replace(two, asked=asked, moved=moved, ahead=ahead, pushed=pushed, capacity=one.capacity)


def segments_in_a_row(rules: Rules, given: Given) -> None:
    """What the contract says of a segment after one that goes on, it says of both together as of one."""
    promise(given, SEGMENT, two_stretches(given, any_order(given), SEGMENT), SEGMENT.ensures)


def exact_segments_in_a_row(rules: Rules, given: Given) -> None:
    """What the exact contract says of a segment after one that goes on, it says of both together as of one."""
    promise(given, SEGMENT_EXACT, two_stretches(given, any_ahead(given), *EXACT_SEGMENT), SEGMENT_EXACT.ensures)


def same_motion(one: Motion[Any, Spot], other: Motion[Any, Spot]) -> Any:
    """Whether two motions are at the same spot, with as much left."""
    return (one.at is other.at) & (one.rest == other.rest)


def stand_in(family: str, effect: Callable[[Any], Any]) -> AnyFamily:
    """A family of one rule that always applies, to stand in for another by its contract."""
    return Family(family, (Rule(id="contract", sentence="", source="", guard=(), effect=effect),))


def rear_walks_on(rules: Rules, given: Given) -> None:
    """One walk of a rear border, whose string goes on as far as it is towed: it leaves nothing out."""
    seen = window(given, ledges=True)
    before = any_motion(given, seen.start)
    wall = seen.start.reach if seen.next_length is None and not seen.ledge else None
    ahead = Ahead(seen.margin, None, wall, None, before.rest * 0)
    assume_required(given, REAR, Stretch(asked=before.rest, moved=before.rest, ahead=ahead))
    after = walk(seen_by(given, rules).walk, seen, before, Way(before.rest, blocked=False))
    stretch = stretch_of(seen, before, after, ahead)
    promise(given, REAR, stretch)
    promise(given, SEGMENT, stretch, [ON_EDGE])


def rear_follows_by_the_same(rules: Rules, given: Given) -> None:
    """The rear border walks from where it was by the distance its front moved, as long as its walks go on."""
    seen = window(given, ledges=True)
    rounds: list[Motion[Any, Spot]] = [Motion(seen.start, rest=given.number("distance the front moved"))]

    def walks(step: Any) -> Motion[Any, Spot]:
        given.ensure("each walk takes over from the one before", same_motion(step.motion, rounds[-1]))
        given.ensure("the rear does not look", not step.way.blocked)
        given.ensure("its way is open as far as it goes", step.way.distance == step.motion.rest)
        going, went = any_round(given, len(rounds))
        stand_in_for(given, REAR, Stretch(asked=step.motion.rest, moved=went, going=going))
        rounds.append(Motion(seen.along(step.motion.at, went), rest=step.motion.rest - went, going=going))
        return rounds[-1]

    tow = Tow(seen, stand_in("walk", walks), seen.start, rounds[0].rest)
    ends = seen_by(given, rules).follow.choose(tow).effect(tow)
    given.ensure("walks follow as long as they go on", not rounds[-1].going)
    given.ensure("the rear ends where its walks went", ends is rounds[-1].at)
    given.ensure("the rear has followed by the same", ends.travelled == rounds[0].rest)


def segment_in_wall(rules: Rules, given: Given) -> None:
    """A border that a landing has put at a wall or inside it stays where it is, whatever is asked of it."""
    seen = lonely_window(given, ledges=False)
    inside = given.number("how far inside the wall")
    start = replace(seen.start, reach=inside * -1)
    seen = replace(seen, next_length=None, start=start)
    stretch, after = run_segment(rules, given, seen, SEGMENT)
    given.ensure("nothing is moved", stretch.moved == 0)
    given.ensure("the border is where it was", after.at.travelled == start.travelled)
    given.ensure("the motion ends", not after.going)


def segment_is_a_function(rules: Rules, given: Given) -> None:
    """The same segment, twice, gives the same, whichever numbers the edges have."""
    first, again = (window(given, ledges=True) for _ in range(2))
    again = replace(again, start=replace(again.start, edge=first.start.edge + 1))
    _, one = run_segment(rules, given, first, SEGMENT)
    _, two = run_segment(rules, given, again, SEGMENT)
    given.ensure("the same distance", one.rest == two.rest)
    given.ensure("the same requests", len(first.asks) == len(again.asks))
