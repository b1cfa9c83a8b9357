"""ROS 1 of this machine, as Debian packages it: a core, a robot, and the bridge, each a process."""

import json
import signal
import subprocess
import threading
from pathlib import Path
from typing import IO, Any

from .ports import free_port
from .server import ROOT, Server

Json = dict[str, Any]
Process = subprocess.Popen[str]

# Debian's packages are for Debian's own Python, whichever runs the tests.
PYTHON = "/usr/bin/python3"
CORE = "/usr/bin/roscore"
NEEDED = "import rospy, actionlib_msgs.msg, geometry_msgs.msg, nav_msgs.msg, sensor_msgs.msg, std_msgs.msg"
END_SECONDS = 15
PROGRAMS = ROOT / "e2e" / "dronemap_e2e"


def is_installed() -> bool:
    return (
        Path(CORE).exists()
        and subprocess.run([PYTHON, "-c", NEEDED], capture_output=True, check=False).returncode == 0
    )


class Ros:
    """A core of its own on the loopback interface, and what is started beside it."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._processes: list[Process] = []
        port = free_port()
        self._environment = {
            "PATH": "/usr/bin:/bin",
            "HOME": str(folder),
            "LANG": "C.UTF-8",
            "ROS_MASTER_URI": f"http://127.0.0.1:{port}",
            "ROS_IP": "127.0.0.1",
            "ROS_HOME": str(folder),
            "PYTHONPATH": f"{ROOT / 'ros-bridge'}:{PROGRAMS / 'ros1_packages'}",
        }
        # Nodes wait for it by themselves.
        self._start("core", CORE, "-p", str(port))

    def robot(self, picture: Path) -> "RobotProcess":
        return RobotProcess(
            self._start("machine", str(PROGRAMS / "ros1_robot.py"), str(picture), read_output=True)
        )

    def copter(self, namespace: str) -> "RobotProcess":
        """Behind a stand-in for mavros."""
        program = str(PROGRAMS / "ros1_copter.py")
        return RobotProcess(self._start("copter", program, namespace=namespace, read_output=True))

    def bridge(self, server: Server, system_id: int, key: str, *options: str, namespace: str = "") -> Process:
        return self._start(
            f"bridge-{system_id}",
            *("-m", "roslink_bridge", "127.0.0.1", "--port", str(server.robot_udp_port), "--ros", "1"),
            *("--system-id", str(system_id), "--key", key, "--name", "A robot of ROS", *options),
            namespace=namespace,
        )

    def _start(self, name: str, *arguments: str, namespace: str = "", read_output: bool = False) -> Process:
        with (self._folder / f"{name}.log").open("w") as log:
            process = subprocess.Popen(
                [PYTHON, *arguments],
                env={**self._environment, "ROS_NAMESPACE": namespace},
                stdout=subprocess.PIPE if read_output else log,
                stderr=log,
                text=True,
            )
        self._processes.append(process)
        return process

    def stop(self) -> None:
        """The core last; at this signal it ends its own children."""
        for process in reversed(self._processes):
            process.send_signal(signal.SIGINT)
            try:
                process.wait(END_SECONDS)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


class RobotProcess:
    """A robot's process, and the orders that it prints."""

    def __init__(self, process: Process) -> None:
        self._orders: list[Json] = []
        assert process.stdout
        threading.Thread(target=self._listen, args=(process.stdout,), daemon=True).start()

    def _listen(self, lines: IO[str]) -> None:
        for line in lines:
            # Between them stand rospy's own remarks.
            if line.startswith("{"):
                self._orders.append(json.loads(line))

    def orders(self, what: str) -> list[Json]:
        return [one for one in list(self._orders) if one["what"] == what]

    @property
    def forward(self) -> float | None:
        """m/s that it was last ordered to drive; None before the first order."""
        speeds = self.orders("cmd_vel")
        return float(speeds[-1]["forward"]) if speeds else None
