"""Evaluated: what the thesis says of its prototype beside rigid bodies and of its cost, and what a run here shows."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class Judgement(Enum):
    """What a run shows of a statement of the thesis."""

    CONFIRMED = "confirmed"
    REFUTED = "refuted"
    EXPLAINED = "explained"


@dataclass(frozen=True)
class Evaluated:
    """What the thesis says, and what the run shows of it.

    It is confirmed if it is so, refuted if it is not, explained if it is so for a reason other than it seems to be.
    """

    id: str
    sentence: str
    source: str
    judgement: Judgement

    kind = "evaluation"

    @property
    def section(self) -> str:
        """The anchor of its section of docs/evaluation.md."""
        return self.id.replace("/", "-")


GRAVITY = Evaluated(
    "evaluation/gravity-slope",
    "On a slope without friction a graphbody that is shot upwards and slides down follows a rigid body closely.",
    "6.3.3, F6.10; E1",
    Judgement.CONFIRMED,
)
GRAVITY_OF_10 = Evaluated(
    "evaluation/gravity-of-10",
    "Gravity of 10 fits better than the 9.81 of the rigid bodies, maybe because collisions are solved otherwise.",
    "6.3.3, F6.10; E1, P3",
    Judgement.REFUTED,
)
FLAT_FRICTION = Evaluated(
    "evaluation/flat-friction",
    "On the flat a graphbody that slides until it stops follows a rigid body closely, whatever friction and speed are.",
    "6.3.3, F6.11; E2",
    Judgement.CONFIRMED,
)
STATIC_FRICTION = Evaluated(
    "evaluation/static-friction",
    "The prototype has no static friction, and yet no difference to rigid bodies, which have it, was measured.",
    "6.3.2, 6.3.3; E3, P2",
    Judgement.EXPLAINED,
)
NORMAL_FORCE = Evaluated(
    "evaluation/normal-force",
    "The force that presses a body onto a slope is gravity times 1 less the steepness.",
    "6.3.2, F6.7; P1",
    Judgement.REFUTED,
)
START_SPEED = Evaluated(
    "evaluation/start-speed",
    "In the tests of gravity and friction, bodies start with a velocity along the edge's normal.",
    "6.3.3, T6.3; P4",
    Judgement.REFUTED,
)
LINEAR_TIME = Evaluated(
    "evaluation/linear-time",
    "The effort of a movement step grows linearly with the boxes that are pushed.",
    "7.1.1, F7.1; E4",
    Judgement.CONFIRMED,
)
SPIKES = Evaluated(
    "evaluation/spikes",
    "Over time the effort has spikes, maybe because many boxes are pushed over to the next edge at the same time.",
    "7.1.1, F7.1; E4, E13",
    Judgement.CONFIRMED,
)
BOXES_IN_SCENE = Evaluated(
    "evaluation/boxes-in-scene",
    "The same push costs more with more boxes in the scene, because all are checked for collision.",
    "7.1.1, F7.2; E5",
    Judgement.CONFIRMED,
)
INTO_WALL = Evaluated(
    "evaluation/into-wall",
    "When several boxes are pushed into a wall, rigid bodies shake and graphbodies do not.",
    "7.2; E6",
    Judgement.CONFIRMED,
)
CONSTANT_SPEED = Evaluated(
    "evaluation/constant-speed",
    "A rigid body whose velocity is set in every tick is slowed down by pushing boxes; a graphbody is not.",
    "7.2; E7",
    Judgement.CONFIRMED,
)

EVALUATED = (
    GRAVITY,
    GRAVITY_OF_10,
    FLAT_FRICTION,
    STATIC_FRICTION,
    NORMAL_FORCE,
    START_SPEED,
    LINEAR_TIME,
    SPIKES,
    BOXES_IN_SCENE,
    INTO_WALL,
    CONSTANT_SPEED,
)
