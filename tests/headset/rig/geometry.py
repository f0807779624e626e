"""Vectors, quaternions (w, x, y, z) and poses, right-handed, y up, metres; -z is forward."""

import math
from dataclasses import dataclass, field

IDENTITY = (1.0, 0.0, 0.0, 0.0)


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def subtract(a, b):
    return tuple(x - y for x, y in zip(a, b))


def scaled(a, factor):
    return tuple(x * factor for x in a)


def length(a):
    return math.sqrt(sum(x * x for x in a))


def multiply(a, b):
    aw, ax, ay, az = a
    bw, bx, by, bz = b
    return (
        aw * bw - ax * bx - ay * by - az * bz,
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
    )


def rotate(q, v):
    w, x, y, z = multiply(multiply(q, (0.0, *v)), (q[0], -q[1], -q[2], -q[3]))
    return (x, y, z)


def turned_about_y(degrees):
    half = math.radians(degrees) / 2.0
    return (math.cos(half), 0.0, math.sin(half), 0.0)


def turned_about_x(degrees):
    half = math.radians(degrees) / 2.0
    return (math.cos(half), math.sin(half), 0.0, 0.0)


def looking_along(direction):
    """The rotation without roll that turns -z to the direction."""
    x, y, z = scaled(direction, 1.0 / length(direction))
    yaw = math.degrees(math.atan2(-x, -z))
    pitch = math.degrees(math.asin(max(-1.0, min(1.0, y))))
    return multiply(turned_about_y(yaw), turned_about_x(pitch))


def angle_deg(a, b):
    """Between two directions."""
    cosine = sum(x * y for x, y in zip(a, b)) / (length(a) * length(b))
    return math.degrees(math.acos(max(-1.0, min(1.0, cosine))))


def angle_between_deg(a, b):
    """Between two rotations, of whatever length: those that were stored are rounded."""
    turn = multiply((a[0], -a[1], -a[2], -a[3]), b)
    return math.degrees(2.0 * math.atan2(length(turn[1:]), abs(turn[0])))


@dataclass
class Pose:
    position: tuple = (0.0, 0.0, 0.0)
    orientation: tuple = field(default=IDENTITY)

    def point(self, v):
        return add(self.position, rotate(self.orientation, v))

    def __mul__(self, other):
        return Pose(self.point(other.position), multiply(self.orientation, other.orientation))

    def inverse(self):
        back = (self.orientation[0], *scaled(self.orientation[1:], -1.0))
        return Pose(rotate(back, scaled(self.position, -1.0)), back)


@dataclass
class Placement:
    """Stage point = scale * (turn * tracking point) + shift, as the program's "placement" note says it."""

    scale: float
    yaw_deg: float
    shift: tuple

    def to_stage(self, point):
        turned = rotate(turned_about_y(self.yaw_deg), point)
        return add(scaled(turned, self.scale), self.shift)

    def to_tracking(self, point):
        back = scaled(subtract(point, self.shift), 1.0 / self.scale)
        return rotate(turned_about_y(-self.yaw_deg), back)
