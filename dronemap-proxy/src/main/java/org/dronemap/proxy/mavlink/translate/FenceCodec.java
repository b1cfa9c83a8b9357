package org.dronemap.proxy.mavlink.translate;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.command.SetFence;
import org.dronemap.core.drone.OnboardFence;
import org.dronemap.core.drone.OnboardRallyPoints;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.FenceReturnPoint;
import org.dronemap.core.mission.HeightReference;
import org.dronemap.core.mission.RallyPoint;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.MavMissionType;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;

/** Converts fences and rally points between the cloud's model and MAVLink mission items. */
public final class FenceCodec {
    static final int RETURN_POINT = 5000;
    static final int POLYGON_INSIDE = 5001;
    static final int POLYGON_OUTSIDE = 5002;
    static final int CIRCLE_INSIDE = 5003;
    static final int CIRCLE_OUTSIDE = 5004;
    static final int RALLY_POINT = 5100;
    static final double E7 = 1e7;
    private static final int FRAME_TERRAIN = 10;
    private static final int MOST_METERS = 10_000;

    private FenceCodec() {}

    /** The return point comes first, as ground stations of ArduPilot write it. */
    public static List<MissionItemInt> fenceToWire(SetFence fence, MavlinkTarget target) {
        List<MissionItemInt> items = new ArrayList<>();
        FenceReturnPoint home = fence.returnPoint();
        if (home != null) {
            items.add(new Wire(RETURN_POINT, 0, frame(home.reference()), home.altitudeMeters())
                    .item(target, 0, home.point()));
        }
        for (FenceArea zone : fence.zones()) {
            if (zone instanceof FenceArea.Polygon polygon) {
                Wire corners = Wire.part(
                        polygon.inside() ? POLYGON_INSIDE : POLYGON_OUTSIDE,
                        polygon.corners().size());
                polygon.corners().forEach(corner -> items.add(corners.item(target, items.size(), corner)));
            } else if (zone instanceof FenceArea.Circle circle) {
                Wire round = Wire.part(circle.inside() ? CIRCLE_INSIDE : CIRCLE_OUTSIDE, circle.radiusMeters());
                items.add(round.item(target, items.size(), circle.center()));
            }
        }
        return items;
    }

    public static OnboardFence fenceFromWire(List<MissionItemInt> items) {
        return FenceItemReader.read(items);
    }

    public static List<MissionItemInt> rallyToWire(List<RallyPoint> points, MavlinkTarget target) {
        List<MissionItemInt> items = new ArrayList<>();
        for (RallyPoint point : points) {
            items.add(new Wire(RALLY_POINT, 0, frame(point.reference()), point.altitudeMeters())
                    .item(target, items.size(), point.point()));
        }
        return items;
    }

    public static OnboardRallyPoints rallyFromWire(List<MissionItemInt> items) {
        List<RallyPoint> points = new ArrayList<>();
        List<String> leftOut = new ArrayList<>();
        for (int index = 0; index < items.size(); index++) {
            MissionItemInt item = items.get(index);
            Optional<HeightReference> reference = reference(item.frame());
            String which = "Item " + (index + 1);
            if (item.command() != RALLY_POINT) {
                leftOut.add(which + " (command " + item.command() + ") is no rally point.");
            } else if (!isPlace(item)) {
                leftOut.add(which + " is no place, " + item.x() / E7 + ", " + item.y() / E7 + ".");
            } else if (reference.isEmpty() || !isHeight(item.z())) {
                leftOut.add(which + " has a height of " + exact(item.z()) + " m in frame " + item.frame()
                        + ", which cannot be told.");
            } else {
                points.add(new RallyPoint(point(item), exact(item.z()), reference.get()));
            }
        }
        return new OnboardRallyPoints(points, leftOut);
    }

    static boolean isPlace(MissionItemInt item) {
        return Math.abs(item.x() / E7) <= 90 && Math.abs(item.y() / E7) <= 180;
    }

    static boolean isHeight(float meters) {
        return Math.abs(meters) <= MOST_METERS;
    }

    static Geodetic point(MissionItemInt item) {
        return new Geodetic(item.x() / E7, item.y() / E7);
    }

    /** A float's decimals as they were meant, 20.1 and not 20.10000038, which make the same float again. */
    static double exact(float value) {
        return Double.parseDouble(Float.toString(value));
    }

    /** What heights in a frame of MAVLink are measured from; empty when that is nothing that can be told. */
    static Optional<HeightReference> reference(int frame) {
        return switch (frame) {
            case MissionCodec.FRAME_GLOBAL, 5 -> Optional.of(HeightReference.AMSL);
            case MissionCodec.FRAME_RELATIVE, 6 -> Optional.of(HeightReference.HOME);
            case FRAME_TERRAIN, 11 -> Optional.of(HeightReference.TERRAIN);
            default -> Optional.empty();
        };
    }

    private static int frame(HeightReference reference) {
        return switch (reference) {
            case AMSL -> MissionCodec.FRAME_GLOBAL;
            case HOME -> MissionCodec.FRAME_RELATIVE;
            case TERRAIN -> FRAME_TERRAIN;
        };
    }

    /** Command, first parameter, frame and height of an item: all that it has beside its place. */
    private record Wire(int command, double first, int frame, double altitude) {
        static Wire part(int command, double first) {
            return new Wire(command, first, MissionCodec.FRAME_GLOBAL, 0);
        }

        MissionItemInt item(MavlinkTarget target, int seq, Geodetic point) {
            return new MissionItemInt(
                    target.systemId(),
                    target.componentId(),
                    seq,
                    frame,
                    command,
                    0,
                    1,
                    (float) first,
                    0f,
                    0f,
                    0f,
                    MissionCodec.e7(point.latitudeDegrees()),
                    MissionCodec.e7(point.longitudeDegrees()),
                    (float) altitude,
                    (command == RALLY_POINT ? MavMissionType.RALLY : MavMissionType.FENCE).number());
        }
    }
}
