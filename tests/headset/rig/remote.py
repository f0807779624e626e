"""The wire protocol of Monado's "remote" driver (version 25): what a headset and two controllers do.

The client sends one fixed structure an update; the last one holds until the next. On connecting, the service first
sends two of the same: its reset state and its latest.
"""

import ctypes
import socket
import struct

PORT = 4242
HEADER = struct.unpack("<Q", b"mndrmt3\0")[0]


class _Packed(ctypes.LittleEndianStructure):
    _pack_ = 1


class WirePose(_Packed):
    _fields_ = [("orientation", ctypes.c_float * 4), ("position", ctypes.c_float * 3)]  # x y z w, then x y z

    def set(self, pose):
        w, x, y, z = pose.orientation
        self.orientation = (ctypes.c_float * 4)(x, y, z, w)
        self.position = (ctypes.c_float * 3)(*pose.position)


class Controller(_Packed):
    _fields_ = [
        ("pose", WirePose),
        ("linear_velocity", ctypes.c_float * 3),
        ("angular_velocity", ctypes.c_float * 3),
        ("hand_curl", ctypes.c_float * 5),  # little, ring, middle, index, thumb
        ("trigger_value", ctypes.c_float),
        ("squeeze_value", ctypes.c_float),
        ("squeeze_force", ctypes.c_float),
        ("thumbstick", ctypes.c_float * 2),
        ("trackpad_force", ctypes.c_float),
        ("trackpad", ctypes.c_float * 2),
        ("hand_tracking_active", ctypes.c_bool),
        ("active", ctypes.c_bool),
        ("system_click", ctypes.c_bool),
        ("system_touch", ctypes.c_bool),
        ("a_click", ctypes.c_bool),
        ("a_touch", ctypes.c_bool),
        ("b_click", ctypes.c_bool),
        ("b_touch", ctypes.c_bool),
        ("trigger_click", ctypes.c_bool),
        ("trigger_touch", ctypes.c_bool),
        ("thumbstick_click", ctypes.c_bool),
        ("thumbstick_touch", ctypes.c_bool),
        ("trackpad_touch", ctypes.c_bool),
        ("padding", ctypes.c_uint8 * 3),
    ]

    def pull_trigger(self, down):
        self.trigger_value = 1.0 if down else 0.0
        self.trigger_click = down
        self.trigger_touch = down


class View(_Packed):
    _fields_ = [("fov", ctypes.c_float * 4), ("pose", WirePose), ("padding", ctypes.c_uint32)]


class Head(_Packed):
    _fields_ = [
        ("views", View * 2),
        ("centre", WirePose),
        ("views_valid", ctypes.c_bool),
        ("padding", ctypes.c_uint8 * 3),
    ]


class State(_Packed):
    _fields_ = [("header", ctypes.c_uint64), ("head", Head), ("left", Controller), ("right", Controller)]


assert ctypes.sizeof(State) == 376


class Remote:
    """A connection. Change `state`, then send()."""

    def __init__(self, port=PORT):
        self._socket = socket.create_connection(("127.0.0.1", port), timeout=10.0)
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.state = self._receive()  # the reset state: both controllers awake, the head at 1.6 m
        self._receive()  # the latest
        self.state.header = HEADER

    def _receive(self):
        size = ctypes.sizeof(State)
        data = b""
        while len(data) < size:
            more = self._socket.recv(size - len(data))
            if not more:
                raise ConnectionError("the remote driver closed the connection")
            data += more
        return State.from_buffer_copy(data)

    def send(self):
        self._socket.sendall(bytes(self.state))

    def close(self):
        self._socket.close()
