package org.dronemap.ws.flights;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.MissionRunFlight;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.mission.MissionItemRequest;
import org.dronemap.ws.plan.PlanRequest;
import org.dronemap.ws.virtual.VirtualDroneRequest;

/** Scratch. */
final class CrossingStudy {
    private final Laboratory lab;
    private final SplittableRandom chance;
    private final List<LabDrone> all = new ArrayList<>();

    private CrossingStudy(long seed) {
        lab = new Laboratory(seed);
        chance = new SplittableRandom(seed);
    }

    public static void main(String[] arguments) {
        String kind = arguments[0];
        for (long seed = Long.parseLong(arguments[1]); seed <= Long.parseLong(arguments[2]); seed++) {
            CrossingStudy study = new CrossingStudy(seed);
            try {
                System.out.println(seed + " " + study.fly(kind));
            } catch (Throwable e) {
                System.out.println(
                        seed + " FAILED " + String.valueOf(e.getMessage()).replaceAll("\\s+", " "));
            } finally {
                study.lab.close();
            }
        }
    }

    private LabDrone drone(double north, double east) {
        LabDrone drone = lab.ready(lab.add(
                VehicleSpec.COPTER, new LocalFrame(47.3977 + north / 111_190.0, 8.5456 + east / 75_300.0, 488)));
        all.add(drone);
        return drone;
    }

    private List<PlanRequest.WaypointRequest> waypoints(LabDrone from, int count, double northwards) {
        List<PlanRequest.WaypointRequest> all = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            all.add(MissionRunFlight.waypoint(
                    from.place(northwards * chance.nextDouble(40, 160), chance.nextDouble(-60, 60)),
                    from.groundAmsl() + 20 + chance.nextDouble(-1, 1)));
        }
        return all;
    }

    private String fly(String kind) {
        Pilot ann = lab.pilot("ann", Role.SUPERVISOR);
        LabDrone one = drone(0, 0);
        LabDrone two = drone(0, 30);
        LabDrone other = drone(200, 0);
        MissionRunFlight second = null;
        String virtual = null;
        if (kind.equals("runs")) {
            LabDrone fourth = drone(200, 30);
            Pilot bob = lab.pilot("bob", Role.SUPERVISOR);
            second = MissionRunFlight.begins(
                    lab, bob, List.of(other, fourth), waypoints(other, 8, -1), MissionRunFlight.Manner.ON);
        } else if (kind.equals("virtual")) {
            List<MissionItem> items = new ArrayList<>();
            for (int i = 0; i < 6; i++) {
                items.add(new MissionItem.Waypoint(
                        other.place(-chance.nextDouble(40, 160), chance.nextDouble(-60, 60)),
                        Altitude.aboveHome(20),
                        0));
            }
            lab.server().warehouse().put(ann.principal(), other.id().value());
            virtual = lab.server()
                    .virtuals()
                    .add(ann.principal(), new VirtualDroneRequest("Survey", null, MissionItemRequest.of(items)))
                    .id();
            lab.server().virtuals().start(ann.principal(), virtual, null).id();
        }
        MissionRunFlight run =
                MissionRunFlight.begins(lab, ann, List.of(one, two), waypoints(one, 8, 1), MissionRunFlight.Manner.ON);
        Pilot hand = lab.pilot("hand", Role.OPERATOR);
        if (kind.equals("hand")) {
            hand.takesControl(other);
            hand.takesOff(other, 20);
        }
        Separation apart = new Separation(all);
        long begun = lab.time().nanos();
        double next = 0;
        boolean calledHome = false;
        for (int tenth = 0; tenth < 10 * 900; tenth++) {
            lab.goOn(Duration.ofMillis(100));
            apart.look();
            if (kind.equals("hand") && tenth > 20) {
                if (!calledHome && tenth % 50 == 0 && tenth < 2_000) {
                    double heading = chance.nextDouble(0, 2 * Math.PI);
                    double n = -100 + 200 * chance.nextDouble();
                    Geodetic there = one.place(100 + 90 * Math.cos(heading), 80 * Math.sin(heading));
                    if (other.distanceTo(there) > 30) {
                        hand.give(
                                other,
                                CommandRequests.goTo(
                                        there.latitudeDegrees(),
                                        there.longitudeDegrees(),
                                        20 + chance.nextDouble(-1, 1)));
                    }
                } else if (!calledHome && tenth >= 2_000) {
                    calledHome = true;
                    hand.give(other, CommandRequests.returnToLaunch());
                }
            }
            boolean over = run.view().state().equals("over")
                    && (second == null || second.view().state().equals("over"))
                    && all.stream().allMatch(LabDrone::isDown)
                    && tenth > 300;
            if (over) {
                break;
            }
        }
        long seconds = (lab.time().nanos() - begun) / 1_000_000_000;
        String waits = run.told("tooNear").size() + "";
        return String.format(
                java.util.Locale.ROOT,
                "%.2f %s | run %s visited %d in %d s, waits %s %s %s",
                apart.least(),
                apart.words(),
                run.view().state(),
                run.view().counts().visited(),
                seconds,
                waits,
                second == null
                        ? ""
                        : second.view().state() + " " + second.view().counts().visited(),
                virtual == null
                        ? ""
                        : lab.server().virtuals().one(ann.principal(), virtual).run());
    }
}
