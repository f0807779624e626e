"""A virtual display, an OpenXR runtime and the program, each in its place and ended at the end."""

import os
import shutil
import signal
import socket
import subprocess
import time
from pathlib import Path

import remote
import x11
from conditions import LAYER, Conditions
from session_trace import Trace

RUNTIME_JSON = "/usr/share/openxr/1/openxr_monado.json"
INSTALLED_LAYERS = "/usr/share/openxr/1/api_layers/explicit.d"
SOFTWARE_VULKAN = "/usr/share/vulkan/icd.d/lvp_icd.json"


class RigError(AssertionError):
    """Something around the program did not work."""


def until(what, condition, timeout_s=20.0):
    """The first true value of condition()."""
    end = time.monotonic() + timeout_s
    while True:
        value = condition()
        if value:
            return value
        if time.monotonic() > end:
            raise RigError(f"no {what} within {timeout_s:.0f} s")
        time.sleep(0.01)


class Process:
    def __init__(self, arguments, environment, log, **more):
        self.log = log
        self._log_file = open(log, "wb")
        self.popen = subprocess.Popen(
            [str(a) for a in arguments],
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=self._log_file,
            stderr=subprocess.STDOUT,
            start_new_session=True,
            **more,
        )

    def alive(self):
        return self.popen.poll() is None

    def text(self):
        return self.log.read_text(errors="replace")

    def wait(self, timeout_s):
        try:
            return self.popen.wait(timeout_s)
        except subprocess.TimeoutExpired:
            raise RigError(f"{self.popen.args[0]} did not end within {timeout_s:.0f} s; see {self.log}") from None

    def kill(self):
        if self.alive():
            os.killpg(self.popen.pid, signal.SIGKILL)
        self.popen.wait()
        self._log_file.close()

    def resident_kb(self):
        for line in Path(f"/proc/{self.popen.pid}/status").read_text().splitlines():
            if line.startswith("VmRSS:"):
                return int(line.split()[1])
        return 0


class Rig:
    """One scenario's folder, display, runtime and program. A context manager: all ends with it."""

    def __init__(self, folder, program, driver="remote", compositor="null", screen="1280x1024"):
        self.folder = Path(folder)
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        self._program = program
        self._driver = driver
        self._compositor = compositor
        self._screen = screen
        self._processes = []
        self._runs = 0
        self.service = None
        self.deixis = None
        self.conditions = None
        self.trace = None
        self.remote = None
        home = self.folder / "home"
        runtime = self.folder / "runtime"
        (home / ".config/monado").mkdir(parents=True)
        runtime.mkdir(mode=0o700)
        if driver == "remote":
            (home / ".config/monado/config_v0.json").write_text(
                f'{{"active": "remote", "remote": {{"version": 0, "port": {remote.PORT}}}}}'
            )
        self.environment = {
            "PATH": os.environ["PATH"],
            "LANG": "C.UTF-8",
            "HOME": str(home),
            "XDG_RUNTIME_DIR": str(runtime),
            "VK_DRIVER_FILES": SOFTWARE_VULKAN,
            "LIBGL_ALWAYS_SOFTWARE": "1",
            "XR_RUNTIME_JSON": RUNTIME_JSON,
        }

    def __enter__(self):
        try:
            self._start_display()
            return self
        except BaseException:
            self.close()
            raise

    def __exit__(self, *_):
        self.close()

    def close(self):
        if self.remote is not None:
            self.remote.close()
        for process in reversed(self._processes):
            process.kill()

    def _start(self, arguments, name, environment=None, **more):
        environment = self.environment | (environment or {})
        environment = {name: value for name, value in environment.items() if value is not None}
        process = Process(arguments, environment, self.folder / f"{name}.log", **more)
        self._processes.append(process)
        return process

    def _start_display(self):
        read, write = os.pipe()
        self._start(
            ["Xvfb", "-displayfd", write, "-screen", "0", f"{self._screen}x24", "-nolisten", "tcp", "-noreset"]
            + ["-fbdir", self.folder],  # where Screen reads what is shown
            "xvfb",
            pass_fds=[write],
        )
        os.close(write)
        with os.fdopen(read) as pipe:  # says the display's number when it is ready
            number = pipe.readline().strip()
        if not number:
            raise RigError("Xvfb did not start")
        self.environment["DISPLAY"] = f":{number}"

    def start_service(self):
        """Starts monado-service and, with the remote driver, connects to it."""
        runtime = Path(self.environment["XDG_RUNTIME_DIR"])
        for left in runtime.iterdir():  # of a service that was killed
            left.unlink()
        environment = {"XRT_NO_STDIN": "1"}
        if self._compositor == "null":
            environment["XRT_COMPOSITOR_NULL"] = "1"
        else:
            environment["XRT_COMPOSITOR_FORCE_XCB"] = "1"
            environment["XRT_COMPOSITOR_XCB_FULLSCREEN"] = "1"
        if self._driver == "simulated":
            environment |= {"SIMULATED_ENABLE": "1", "SIMULATED_LEFT": "simple", "SIMULATED_RIGHT": "simple"}
        self.service = self._start(["monado-service"], f"service-{len(self._processes)}", environment)
        until("OpenXR service", lambda: self._service_ready(), 30.0)
        if self._driver == "remote":
            self.remote = until("remote driver", self._connect)

    def _service_ready(self):
        if not self.service.alive():
            raise RigError(f"monado-service ended at once; see {self.service.log}")
        return "The Monado service has started" in self.service.text()

    def _connect(self):
        try:
            return remote.Remote()
        except (ConnectionRefusedError, socket.timeout):
            return None

    def kill_service(self):
        if self.remote is not None:
            self.remote.close()
            self.remote = None
        self.service.kill()

    def run(self, study, database, *options, environment=None, conditions=None):
        """Starts `deixis run` with the validation layer on, and follows its trace. `environment`: more variables; one
        that is None is left out. `conditions`: first lines to the layer that brings them about; then self.conditions
        takes more."""
        self._runs += 1
        trace = self.folder / f"trace-{self._runs}.jsonl"
        layer = {
            "XR_ENABLE_API_LAYERS": "XR_APILAYER_LUNARG_core_validation",
            "XR_CORE_VALIDATION_EXPORT_TYPE": "text",
            "XR_CORE_VALIDATION_FILE_NAME": str(self.folder / f"validation-{self._runs}.txt"),
        }
        if conditions is not None:
            self.conditions = Conditions(self.folder / f"conditions-{self._runs}.txt", *conditions)
            built = self._program.parent / "tests/headset/conditions_layer"
            layer |= {
                "XR_API_LAYER_PATH": f"{built}:{INSTALLED_LAYERS}",
                # The validation layer, nearer to the program, checks what this one makes the program do.
                "XR_ENABLE_API_LAYERS": f"{layer['XR_ENABLE_API_LAYERS']}:{LAYER}",
                "DEIXIS_CONDITIONS": str(self.conditions.file),
            }
        self.deixis = self._start(
            [self._program, "run", study, "--station", "headset", "--participant", "P01"]
            + ["--db", database, "--trace", trace, *options],
            f"deixis-{self._runs}",
            layer | (environment or {}),
            cwd=self.folder,
        )
        self.trace = Trace(trace, self.deixis.alive)
        return self.trace

    def windows(self, name):
        """Ids of the visible windows of that name, a regular expression."""
        found = subprocess.run(
            ["xdotool", "search", "--onlyvisible", "--name", name],
            env=self.environment, capture_output=True, text=True, check=False,
        )
        return [int(line) for line in found.stdout.split()]

    def close_window(self, name):
        """Asks the window to close, as its frame's button would; twice, as the program wants it confirmed."""
        window = until(f"window '{name}'", lambda: self.windows(name))[0]
        for _ in range(2):
            x11.ask_to_close(self.environment["DISPLAY"], window)
            time.sleep(0.5)
            if not self.deixis.alive():
                return
