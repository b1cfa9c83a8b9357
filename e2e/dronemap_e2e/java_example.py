"""The Java example, copied out of the tree and built there from what a running server says of itself."""

import hashlib
import os
import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

from . import server_template
from .server import QUICK, ROOT, SERVER_JAR, Server

SOURCES = ROOT / "java-example"
JAR = "java-example.jar"


@dataclass(frozen=True)
class JavaExample:
    """Its jar, with the libraries that it needs beside it."""

    folder: Path

    @property
    def java(self) -> tuple[str, ...]:
        """A command, up to the name of a class or file."""
        return ("java", QUICK, "-cp", f"{self.folder / JAR}:{self.folder / 'lib'}/*")

    def run(
        self, program: str, address: str, key: str, *arguments: str
    ) -> "subprocess.CompletedProcess[str]":
        return subprocess.run(
            [*self.java, f"org.dronemap.example.{program}", *arguments],
            env=os.environ | {"DRONEMAP_URL": address, "DRONEMAP_KEY": key},
            cwd=self.folder,
            text=True,
            capture_output=True,
            timeout=150,
        )


def built(server: Server) -> JavaExample:
    """Made once for each jar of the server, from which follows what it serves, and state of the example."""

    def make(folder: Path) -> None:
        with tempfile.TemporaryDirectory(prefix="java-example-") as outside:
            copied = Path(outside) / "my-flights"
            shutil.copytree(SOURCES, copied, ignore=shutil.ignore_patterns("target"))
            package(copied, server)
            folder.mkdir()
            shutil.move(copied / "target" / JAR, folder)
            shutil.move(copied / "target" / "lib", folder)

    return JavaExample(server_template.made_once(SERVER_JAR, "java-example", make, _digest()))


def package(folder: Path, server: Server) -> None:
    done = subprocess.run(
        ["mvn", "-B", "-ntp", "-q", "package", f"-Ddronemap.url={server.address}"],
        cwd=folder,
        env=os.environ | {"MAVEN_OPTS": QUICK},
        text=True,
        capture_output=True,
        timeout=600,
    )
    assert done.returncode == 0, done.stdout + done.stderr


def _digest() -> str:
    digest = hashlib.sha256()
    for file in sorted(SOURCES.rglob("*")):
        if file.is_file() and "target" not in file.relative_to(SOURCES).parts:
            digest.update(str(file.relative_to(SOURCES)).encode() + b"\0" + file.read_bytes() + b"\0")
    return digest.hexdigest()
