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
from typing import Any

from properties.given import Given, Infeasible
from properties.worlds.window import ME, NEIGHBOUR, Capacity, Spot, Window, capacity, lonely_window, spot, window
from spec.conditions import FREE_SPACE
from spec.number import greater, lesser
from spec.profiles import Profile
from spec.rule import AnyRule, Chooser, Family, GuardError, Rule
from spec.rules.leave import Departure, Placement
from spec.rules.push import Way
from spec.rules.request import Ask, Rules, request
from spec.rules.walk import Motion, Tow, walk

Grant = Callable[[Ask[Any, str]], Any]
ONE_RULE = "rules/one-applies"
MOST_CHOICES = 20


@dataclass(frozen=True)
class Seen:
    """A family that reports to a `Given` which rules it chose, and breaks a promise where it cannot choose.

    A window has two edges: who chooses again and again goes on without getting on, and breaks a promise too.
    """

    family: Chooser
    given: Given
    chosen: list[str] = field(default_factory=list)

    def choose(self, facts: Any) -> AnyRule:
        """Return the rule that applies."""
        if len(self.chosen) == MOST_CHOICES:
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


def judged(program: Callable[[Profile, Given], None], profile: Profile, given: Given) -> None:
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
    """Run a program of the rules, answering each `Ask` by a contract, whose requirement it must meet."""
    answer = None
    while True:
        try:
            ask = running.send(answer)
        except StopIteration as end:
            return end.value
        given.ensure("asks for a distance", ask.distance is not None)
        if ask.distance is None:
            raise Infeasible
        given.ensure("asks for a distance of at least 0", ask.distance >= 0)
        seen.asks.append(ask)
        answer = grant(ask)
        seen.granted = seen.granted + answer


def any_motion(given: Given, at: Spot) -> Motion[Any, Spot]:
    """A motion anywhere in its course."""
    return Motion(at, rest=given.number("distance left"))


def no_more_than_asked(given: Given) -> Grant:
    """The weaker half of the contract: the neighbour moves by something from 0 to what it is asked."""

    def grant(ask: Ask[Any, str]) -> Any:
        granted = given.number("distance granted")
        given.assume(granted <= ask.distance, "the contract of the request that is asked for")
        return granted

    return grant


def run_segment(
    rules: Rules, given: Given, seen: Window, grant: Grant
) -> tuple[Any, Motion[Any, Spot], Motion[Any, Spot]]:
    """One segment of any motion in a window: the spare asks it had, and the motion before and after."""
    spare, before = given.natural("bodies that may still be asked"), any_motion(given, seen.start)
    after = drive(given, rules.segment(seen_by(given, rules), seen, ME, before, spare), seen, grant)
    return spare, before, after


def segment_accounts(rules: Rules, given: Given) -> None:
    """On any edge, with any neighbour in order: what a segment says it moved is what the border moved."""
    seen = window(given, margin_kept=False, edges_long=False, ledges=True)
    _, before, after = run_segment(rules, given, seen, no_more_than_asked(given))
    step = before.rest - after.rest
    given.ensure("the distance moved is where the border is", after.at.travelled == step)
    given.ensure("moved in the direction asked", step >= 0)
    given.ensure("moved at most what was asked", step <= before.rest)
    given.ensure(
        "the border is on its edge", ((after.at.reach >= 0) | seen.ledge) & (after.at.reach <= after.at.length)
    )


def segment_keeps_order(rules: Rules, given: Given) -> None:
    """On any edge, with any neighbour in order: the border does not pass it."""
    seen = window(given, margin_kept=False, edges_long=False, ledges=True)
    _, _, after = run_segment(rules, given, seen, no_more_than_asked(given))
    if seen.neighbour:
        given.ensure("the neighbour is still ahead", seen.gap(after.at, NEIGHBOUR) >= 0)


def segment_keeps_margin(rules: Rules, given: Given) -> None:
    """With edges at least as long as the margin: the border comes no nearer to its neighbour than the margin."""
    seen = window(given, margin_kept=True, edges_long=True, ledges=True)
    _, _, after = run_segment(rules, given, seen, no_more_than_asked(given))
    if seen.neighbour:
        given.ensure("the margin is kept", seen.gap(after.at, NEIGHBOUR) >= seen.margin)


def segment_terminates(rules: Rules, given: Given) -> None:
    """A segment asks once at most, uses up one of the spare asks, and goes on only to another edge.

    The measure of a request: the distance from the beginning of the border's edge to its target. It falls by the
    length of an edge whenever a segment goes on, so a request of a body takes at most as many segments as there
    are edges up to its target.
    """
    seen = window(given, margin_kept=False, edges_long=False, ledges=True)
    spare, before, after = run_segment(rules, given, seen, no_more_than_asked(given))
    given.ensure("asks once at most", len(seen.asks) <= 1)
    for ask in seen.asks:
        given.ensure("there was an ask to spare", spare > 0)
        given.ensure("the chain that may be asked is one shorter", ask.spare == spare - 1)
    if after.going:
        given.ensure("goes on to the next edge", after.at.edge == seen.start.edge + 1)
        covered = seen.start.length - seen.start.reach
        given.ensure("the measure falls by the edge", after.rest + seen.start.length == before.rest + covered)


def segment_exact(rules: Rules, given: Given) -> None:
    """With margins kept and edges as long: a segment follows the contract of a request exactly."""
    seen = window(given, margin_kept=True, edges_long=True)
    able = capacity(given, seen)
    spare, before, after = run_segment(rules, given, seen, lambda ask: lesser(ask.distance, able.neighbour))
    limit, step = able.of_me(replace(seen, granted=seen.granted * 0), spare), before.rest - after.rest
    most = before.rest if limit is None else lesser(before.rest, limit)
    given.ensure("moves as far as possible, or is on its way there", (step <= most) & (after.going | (step >= most)))
    given.ensure("has gone all of the edge, if it goes on", (not after.going) | (step == seen.start.reach))
    bystanders_keep(given, seen, step)


def bystanders_keep(given: Given, seen: Window, step: Any) -> None:
    """Promise that the neighbour moves by what the step exceeds the room, and that nobody else is asked."""
    excess = step - (seen.gap_before - seen.margin)
    pushed = greater(excess, excess * 0) if seen.neighbour else excess * 0
    given.ensure("the neighbour moves only as far as it is pushed", seen.granted == pushed)
    given.ensure("only the neighbour is asked", all(ask.body == NEIGHBOUR for ask in seen.asks))


def request_is_its_segments(rules: Rules, given: Given) -> None:
    """A request moves its front by its segments as long as they go on, tows its rear, leaves its edge if it must, and
    says how far it moved.

    Segments, towing and leaving are stood in for by their contracts.
    """
    seen = window(given, margin_kept=False, edges_long=False, ledges=True)
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
        given.ensure("each segment is of this body, by these rules", own is stand_ins and view is seen and body == ME)
        yield from ()
        went = given.number(f"distance of segment {len(rounds)}")
        given.assume(went <= motion.rest, "the contract of a segment")
        going = len(rounds) < MOST_ROUNDS and given.flag(f"segment {len(rounds)} goes on")
        rounds.append(Motion(view.along(motion.at, went), rest=motion.rest - went, going=going))
        return rounds[-1]

    def towed(tow: Tow[Any, Spot]) -> Spot:
        tows.append(tow)
        return rear_goes

    def leaves(leaving: Departure[Any, Any]) -> Placement[Any, Any]:
        departures.append(leaving)
        return ends

    follow, leave = Family("follow", (stand_in(towed),)), Family("leave", (stand_in(leaves),))
    stand_ins = replace(rules, segment=segments, follow=follow, leave=leave)
    moved = drive(given, request(stand_ins, seen, ME, distance, spare), seen, no_more_than_asked(given))
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


MOST_ROUNDS = 3


def same_motion(one: Motion[Any, Spot], other: Motion[Any, Spot]) -> Any:
    """Whether two motions are at the same spot, with as much left."""
    return (one.at is other.at) & (one.rest == other.rest)


def stand_in(effect: Callable[[Any], Any]) -> AnyRule:
    """A rule that always applies, to stand in for a family by its contract."""
    return Rule(id="contract", sentence="", source="", guard=(), effect=effect)


def rear_walks_on(rules: Rules, given: Given) -> None:
    """One walk of a rear border, whose string goes on as far as it is towed: it leaves nothing out."""
    seen = window(given, margin_kept=False, edges_long=False, ledges=True)
    before = any_motion(given, seen.start)
    if seen.next_length is None and not seen.ledge:
        given.assume(before.rest <= seen.start.reach, "the string goes on as far as the rear is towed")
    after = walk(seen_by(given, rules).walk, seen, before, Way(before.rest, blocked=False))
    step = before.rest - after.rest
    given.ensure("the distance moved is where the border is", after.at.travelled == step)
    given.ensure("it stops only when nothing is left", after.going | (after.rest == 0))
    given.ensure("it goes on only from the end of its edge", (not after.going) | (step == seen.start.reach))
    given.ensure(
        "the border is on its edge", ((after.at.reach >= 0) | seen.ledge) & (after.at.reach <= after.at.length)
    )


def rear_follows_by_the_same(rules: Rules, given: Given) -> None:
    """The rear border walks from where it was by the distance its front moved, as long as its walks go on."""
    seen = window(given, margin_kept=False, edges_long=False, ledges=True)
    rounds: list[Motion[Any, Spot]] = [Motion(seen.start, rest=given.number("distance the front moved"))]

    def walks(step: Any) -> Motion[Any, Spot]:
        given.ensure("each walk takes over from the one before", same_motion(step.motion, rounds[-1]))
        given.ensure("the rear does not look", not step.way.blocked)
        given.ensure("its way is open as far as it goes", step.way.distance == step.motion.rest)
        went = given.number(f"distance of walk {len(rounds)}")
        given.assume(went <= step.motion.rest, "the contract of a walk")
        going = len(rounds) < MOST_ROUNDS and given.flag(f"walk {len(rounds)} goes on")
        rounds.append(Motion(seen.along(step.motion.at, went), rest=step.motion.rest - went, going=going))
        return rounds[-1]

    tow = Tow(seen, Family("walk", (stand_in(walks),)), seen.start, rounds[0].rest)
    ends = seen_by(given, rules).follow.choose(tow).effect(tow)
    given.ensure("walks follow as long as they go on", not rounds[-1].going)
    given.ensure("the rear ends where its walks went", ends is rounds[-1].at)


def segment_in_wall(rules: Rules, given: Given) -> None:
    """A border that a landing has put inside a wall stays where it is, whatever is asked of it."""
    seen = lonely_window(given, edges_long=False, ledges=False)
    inside = given.number("how far inside the wall")
    given.assume(inside > 0, "the border is inside the wall")
    start = replace(seen.start, reach=inside * -1)
    seen = replace(seen, next_length=None, start=start)
    _, before, after = run_segment(rules, given, seen, no_more_than_asked(given))
    given.ensure("nothing is moved", after.rest == before.rest)
    given.ensure("the border is where it was", after.at.travelled == start.travelled)
    given.ensure("the motion ends", not after.going)


def segment_is_a_function(rules: Rules, given: Given) -> None:
    """The same segment, twice, gives the same."""
    first, again = (window(given, margin_kept=False, edges_long=False, ledges=True) for _ in range(2))
    _, _, one = run_segment(rules, given, first, no_more_than_asked(given))
    _, _, two = run_segment(rules, given, again, no_more_than_asked(given))
    given.ensure("the same distance", one.rest == two.rest)
    given.ensure("the same border", (one.at.travelled == two.at.travelled) & (one.at.reach == two.at.reach))
    given.ensure("the same requests", len(first.asks) == len(again.asks))


def by_contract(given: Given, distance: Any, room: Any, able: Capacity, limited: bool) -> tuple[Any, Any]:
    """What the contract says a request moves its body and its neighbour by."""
    most = room if limited else room + able.neighbour
    if able.wall is not None:
        most = lesser(most, able.wall)
    moved = lesser(distance, most)
    return moved, greater(moved - room, moved * 0)


def two_requests_are_one(rules: Rules, given: Given) -> None:
    """By the contract: a request for a + b moves body and neighbour as a request for a, then one for b.

    `regained` is what the first request gives the end of a chain that has come round to its mover; it is 0 but on
    a ring, and there the claim's premise is that both distances together fit into the free space.
    """
    a, b, room = given.number("first distance"), given.number("second distance"), given.number("room")
    wall = given.number("distance to the wall") if given.flag("there is a wall") else None
    able, limited = Capacity(given.number("capacity of the neighbour"), wall), given.flag("at the push limit")
    regained = given.number("regained on a ring") if given.flag("on a ring") else a * 0
    both, pushed = by_contract(given, a + b, room, able, limited)
    given.assume((regained == 0) | (both == a + b), FREE_SPACE.id)
    first, pushed_first = by_contract(given, a, room, able, limited)
    left = room - first + pushed_first
    able = Capacity(able.neighbour - pushed_first + regained, None if wall is None else wall - first)
    second, pushed_second = by_contract(given, b, left, able, limited)
    given.ensure("the body moves as far", first + second == both)
    given.ensure("the neighbour moves as far", pushed_first + pushed_second == pushed)
