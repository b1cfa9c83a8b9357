package org.dronemap.proxy.mavlink.translate;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.RallyPoint;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.MavMissionType;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;

/** Converts fences and rally points between the cloud's model and MAVLink mission items. */
public final class FenceCodec {
    private static final int POLYGON_INSIDE = 5001;
    private static final int POLYGON_OUTSIDE = 5002;
    private static final int CIRCLE_INSIDE = 5003;
    private static final int CIRCLE_OUTSIDE = 5004;
    private static final int RALLY_POINT = 5100;
    private static final double E7 = 1e7;

    private FenceCodec() {}

    public static List<MissionItemInt> fenceToWire(List<FenceArea> zones, MavlinkTarget target) {
        List<MissionItemInt> items = new ArrayList<>();
        for (FenceArea zone : zones) {
            if (zone instanceof FenceArea.Polygon polygon) {
                int command = polygon.inside() ? POLYGON_INSIDE : POLYGON_OUTSIDE;
                for (Geodetic corner : polygon.corners()) {
                    items.add(item(
                            target, items.size(), command, polygon.corners().size(), corner, 0));
                }
            } else if (zone instanceof FenceArea.Circle circle) {
                int command = circle.inside() ? CIRCLE_INSIDE : CIRCLE_OUTSIDE;
                items.add(item(target, items.size(), command, circle.radiusMeters(), circle.center(), 0));
            }
        }
        return items;
    }

    public static List<FenceArea> fenceFromWire(List<MissionItemInt> items) {
        List<FenceArea> zones = new ArrayList<>();
        List<Geodetic> corners = new ArrayList<>();
        for (MissionItemInt item : items) {
            switch (item.command()) {
                case POLYGON_INSIDE, POLYGON_OUTSIDE -> {
                    corners.add(point(item));
                    if (corners.size() == Math.round(item.param1())) {
                        if (corners.size() >= 3 && corners.size() <= 100) {
                            zones.add(new FenceArea.Polygon(item.command() == POLYGON_INSIDE, corners));
                        }
                        corners.clear();
                    }
                }
                case CIRCLE_INSIDE, CIRCLE_OUTSIDE -> {
                    double radius = Math.max(1, Math.min(100_000, Math.round(item.param1() * 1000.0) / 1000.0));
                    zones.add(new FenceArea.Circle(item.command() == CIRCLE_INSIDE, point(item), radius));
                }
                default -> {}
            }
        }
        return zones;
    }

    public static List<MissionItemInt> rallyToWire(List<RallyPoint> points, MavlinkTarget target) {
        List<MissionItemInt> items = new ArrayList<>();
        for (RallyPoint point : points) {
            items.add(item(target, items.size(), RALLY_POINT, 0, point.point(), point.altitudeMeters()));
        }
        return items;
    }

    public static List<RallyPoint> rallyFromWire(List<MissionItemInt> items) {
        return items.stream()
                .filter(item -> item.command() == RALLY_POINT && Math.abs(item.z()) <= 10_000)
                .map(item -> new RallyPoint(point(item), Math.round(item.z() * 1000.0) / 1000.0))
                .toList();
    }

    private static Geodetic point(MissionItemInt item) {
        return new Geodetic(Math.max(-90, Math.min(90, item.x() / E7)), Math.max(-180, Math.min(180, item.y() / E7)));
    }

    private static MissionItemInt item(
            MavlinkTarget target, int seq, int command, double first, Geodetic point, double altitude) {
        boolean rally = command == RALLY_POINT;
        return new MissionItemInt(
                target.systemId(),
                target.componentId(),
                seq,
                rally ? MissionCodec.FRAME_RELATIVE : MissionCodec.FRAME_GLOBAL,
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
                (rally ? MavMissionType.RALLY : MavMissionType.FENCE).number());
    }
}
