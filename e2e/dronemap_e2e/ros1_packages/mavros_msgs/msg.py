"""Its messages."""

from . import HEADER, message

State = message(
    "State",
    HEADER + "bool connected\nbool armed\nbool guided\nbool manual_input\nstring mode\nuint8 system_status\n",
)
Altitude = message(
    "Altitude",
    HEADER
    + "float32 monotonic\nfloat32 amsl\nfloat32 local\nfloat32 relative\nfloat32 terrain\n"
    + "float32 bottom_clearance\n",
)
PositionTarget = message(
    "PositionTarget",
    HEADER
    + "uint8 coordinate_frame\nuint16 type_mask\ngeometry_msgs/Point position\n"
    + "geometry_msgs/Vector3 velocity\ngeometry_msgs/Vector3 acceleration_or_force\n"
    + "float32 yaw\nfloat32 yaw_rate\n",
)
