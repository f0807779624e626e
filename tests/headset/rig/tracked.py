"""Unpacks a session's tracked frames (docs/database.md says how they are packed) into a table to be asked with SQL."""

import zlib

POSES = ("head", "left_aim", "right_aim", "left_grip", "right_grip", "gaze")
COLUMNS = ("frame", "display_time_s", "begun_s", "submitted_s", "dropped_frames", "rendered", "off_place_m")
PARTS = ("x_m", "y_m", "z_m", "qw", "qx", "qy", "qz")
NOT_ASKED_FOR = 8


def _numbers(raw, at, count):
    """Differences in zigzag and LEB128, summed up; and where the next ones begin."""
    value, out = 0, []
    for _ in range(count):
        number = shift = 0
        while True:
            byte = raw[at]
            at, number, shift = at + 1, number | (byte & 127) << shift, shift + 7
            if byte < 128:
                break
        value += (number >> 1) ^ -(number & 1)
        out.append(value)
    return out, at


def _pose(validity, *numbers):
    """Validity, position and rotation; None for what is not valid."""
    position = [n / 65536 if validity & 1 else None for n in numbers[:3]]
    rotation = [n / 32768 if validity & 2 else None for n in numbers[3:]]
    return [None if validity == NOT_ASKED_FOR else validity, *position, *rotation]


def _frames(data):
    raw = zlib.decompress(data)
    if raw[0] != 1:
        raise AssertionError(f"tracked frames are packed in a format {raw[0]}")
    columns, at = [], 2
    for _ in range(55):
        column, at = _numbers(raw, at, raw[1])
        columns.append(column)
    for c in zip(*columns):
        times = [c[1] / 1e6, (c[1] + c[2]) / 1e6, (c[1] + c[3]) / 1e6]
        poses = [value for place in range(len(POSES)) for value in _pose(*c[7 + 8 * place : 15 + 8 * place])]
        yield [c[0], *times, c[4], c[5], c[6] / 65536, *poses]


def unpack(connection):
    """Makes the temporary table `tracking`, a row a frame."""
    poses = [f"{pose}_{part}" for pose in POSES for part in ("validity", *PARTS)]
    names = ["session", "trial_index", *COLUMNS, *poses]
    connection.execute(f"create temp table tracking ({', '.join(names)})")
    insert = f"insert into tracking values ({', '.join('?' * len(names))})"
    blocks = connection.execute("select session, trial_index, data from tracking_blocks order by session, first_frame")
    for session, trial, data in blocks.fetchall():
        connection.executemany(insert, ([session, trial, *frame] for frame in _frames(data)))
