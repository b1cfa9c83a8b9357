package org.dronemap.sim.autopilot.arduplane;

import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.IntSupplier;
import org.dronemap.sim.flight.Circle;
import org.dronemap.sim.flight.CruiseSpeeds;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.Manoeuvre;
import org.dronemap.sim.flight.MissionLegs;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedMission;
import org.dronemap.sim.flight.SimulatedMissionItem;
import org.dronemap.sim.flight.SimulatedParameters;
import org.dronemap.sim.flight.TextSeverity;
import org.dronemap.sim.flight.WingLeg;
import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;
import org.jspecify.annotations.Nullable;

/** Makes the manoeuvres by which the simulated ArduPlane flies the items of its mission. Owned by its vehicle. */
final class PlaneLegs implements MissionLegs {
    private final SimulatedMission plan;
    private final SimulatedParameters parameters;
    private final CruiseSpeeds cruise;
    private final IntSupplier current;
    private final Runnable returnToLaunch;
    private final FlyingEstimate estimate;
    private final @Nullable PlaneLift lift;
    private final Consumer<FlightEvent> events;
    private @Nullable NeuPosition last;
    private @Nullable PlaneLanding landing;

    /** {@code current} is the number of the item that is flown, {@code returnToLaunch} changes the mode. */
    PlaneLegs(
            SimulatedMission plan,
            SimulatedParameters parameters,
            CruiseSpeeds cruise,
            FlyingEstimate estimate,
            @Nullable PlaneLift lift,
            MissionLink link) {
        this.plan = plan;
        this.parameters = parameters;
        this.cruise = cruise;
        this.estimate = estimate;
        this.lift = lift;
        this.current = link.current();
        this.returnToLaunch = link.returnToLaunch();
        this.events = link.events();
    }

    /** The parts of the mission and the vehicle that the legs need. */
    record MissionLink(IntSupplier current, Runnable returnToLaunch, Consumer<FlightEvent> events) {}

    @Override
    public Manoeuvre legFor(SimulatedMissionItem item, SimulatedCraft craft, double yaw) {
        NeuPosition here = craft.body().position();
        NeuPosition target = craft.targetOf(item);
        boolean keepsLine = last != null;
        NeuPosition from = last == null ? here : last;
        landing = null;
        last = item.command() == SimulatedMissionItem.WAYPOINT ? target : null;
        if (lift != null && item.command() == SimulatedMissionItem.VTOL_TAKEOFF) {
            return lift.climbTo(item.up(craft.home()));
        }
        if (lift != null && item.command() == SimulatedMissionItem.VTOL_LAND) {
            return lift.landAt(item.hasPlace() ? target : here, craft.aboveHome());
        }
        return switch (item.command()) {
            case SimulatedMissionItem.TAKEOFF ->
                new MissionTakeOff(item.up(craft.home()), estimate.isFlying(craft.armed()), events);
            case SimulatedMissionItem.LAND -> land(from, item.hasPlace() ? target : here.withUp(target.up()), here);
            case SimulatedMissionItem.RETURN_TO_LAUNCH -> new OnceOnTheWay(returnToLaunch, false);
            case SimulatedMissionItem.LOITER_UNLIMITED -> circle(target, item.param3());
            case SimulatedMissionItem.LOITER_TIME,
                    SimulatedMissionItem.LOITER_TURNS,
                    SimulatedMissionItem.LOITER_TO_ALTITUDE -> loiter(item, target, craft);
            case SimulatedMissionItem.DELAY ->
                new OnceOnTheWay(() -> sendText("Delaying %.0f sec", item.param1()), true);
            default -> waypoint(from, target, keepsLine, craft);
        };
    }

    private PlaneLanding land(NeuPosition from, NeuPosition to, NeuPosition here) {
        NeuPosition begin = to.horizontalDistanceTo(here) < 1 ? here : from;
        PlaneLanding begun = new PlaneLanding(begin, to, parameters, events);
        landing = begun;
        return begun;
    }

    private Circle circle(NeuPosition centre, double radius) {
        double size = Math.abs(radius) > 1 ? Math.abs(radius) : parameters.value("WP_LOITER_RAD");
        return new Circle(centre, Math.copySign(size, radius), cruise);
    }

    private LoiterItem loiter(SimulatedMissionItem item, NeuPosition target, SimulatedCraft craft) {
        NeuPosition next = nextPlace(craft);
        return switch (item.command()) {
            case SimulatedMissionItem.LOITER_TIME ->
                new LoiterItem(
                        circle(target, Math.signum(item.param3())),
                        (circle, millis) -> millis > item.param1() * 1000,
                        next,
                        "Loiter time complete",
                        events);
            case SimulatedMissionItem.LOITER_TURNS ->
                new LoiterItem(
                        circle(target, item.param3()),
                        (circle, millis) -> circle.turns() > item.param1(),
                        next,
                        "Loiter orbits complete",
                        events);
            default ->
                new LoiterItem(
                        circle(target, item.param2()),
                        (circle, millis) -> circle.atHeight(),
                        next,
                        "Loiter to alt complete",
                        events);
        };
    }

    private Manoeuvre waypoint(NeuPosition from, NeuPosition to, boolean keepsLine, SimulatedCraft craft) {
        WingLeg leg = new WingLeg(from, to, acceptance(from, to, craft), keepsLine, cruise);
        int index = current.getAsInt();
        return new Manoeuvre() {
            @Override
            public MotionSetpoint fly(SimulatedCraft flown, long nowMillis) {
                MotionSetpoint setpoint = leg.fly(flown, nowMillis);
                if (leg.done()) {
                    sendText("%s waypoint #%d dist %.0fm", leg.near() ? "Reached" : "Passed", index, leg.distance());
                }
                return setpoint;
            }

            @Override
            public boolean done() {
                return leg.done();
            }
        };
    }

    /** It turns before a waypoint by as much as the turn there is sharp; in line with the next leg not at all. */
    private double acceptance(NeuPosition from, NeuPosition to, SimulatedCraft craft) {
        NeuPosition next = nextPlace(craft);
        double turn = next == null ? 90 : Math.abs(Math.toDegrees(turn(from, to, next)));
        return parameters.value("WP_RADIUS") * Math.min(1, turn / 90);
    }

    private static double turn(NeuPosition from, NeuPosition to, NeuPosition next) {
        return Math.IEEEremainder(to.bearingTo(next) - from.bearingTo(to), 2 * Math.PI);
    }

    private @Nullable NeuPosition nextPlace(SimulatedCraft craft) {
        for (int index = current.getAsInt() + 1; index < plan.size(); index++) {
            SimulatedMissionItem item = plan.item(index);
            if (item.isNavigation()) {
                return item.hasPlace() ? craft.targetOf(item) : null;
            }
        }
        return null;
    }

    @Override
    public boolean flies(SimulatedMissionItem item) {
        return switch (item.command()) {
            case SimulatedMissionItem.LOITER_TURNS, SimulatedMissionItem.LOITER_TO_ALTITUDE -> true;
            case SimulatedMissionItem.VTOL_TAKEOFF, SimulatedMissionItem.VTOL_LAND -> lift != null;
            default -> item.isFlown();
        };
    }

    @Override
    public long holdMillis(SimulatedMissionItem item) {
        return 0;
    }

    @Override
    public Manoeuvre afterwards(SimulatedCraft craft, Manoeuvre flown) {
        return circle(craft.body().position(), 0);
    }

    /** The landing that is flown; null when none is. */
    @Nullable
    PlaneLanding landing() {
        return landing;
    }

    private void sendText(String format, Object... values) {
        events.accept(new FlightEvent.Text(TextSeverity.INFO, String.format(Locale.ROOT, format, values)));
    }

    /** An item that does one thing at once, and ends with it or lasts until another mode is chosen. */
    private static final class OnceOnTheWay implements Manoeuvre {
        private final Runnable what;
        private final boolean ends;
        private boolean done;

        OnceOnTheWay(Runnable what, boolean ends) {
            this.what = what;
            this.ends = ends;
        }

        @Override
        public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
            if (!done) {
                done = true;
                what.run();
            }
            return new MotionSetpoint.Glide();
        }

        @Override
        public boolean done() {
            return done && ends;
        }
    }
}
