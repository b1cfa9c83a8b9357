"""Its services."""

from . import service

DONE = "bool success\nuint8 result\n"

CommandBool = service("CommandBool", "bool value\n", DONE)
CommandTOL = service(
    "CommandTOL",
    "float32 min_pitch\nfloat32 yaw\nfloat32 latitude\nfloat32 longitude\nfloat32 altitude\n",
    DONE,
)
SetMode = service("SetMode", "uint8 base_mode\nstring custom_mode\n", "bool mode_sent\n")
