package org.dronemap.sim.flight;

import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.NeuPosition;
import org.jspecify.annotations.Nullable;

/**
 * Simulated manoeuvre: flies the stored mission item by item. The plan may change under it: the item that is being
 * flown stays as it was begun, the next ones are read when their turn comes. Owned by its vehicle.
 */
public final class MissionManoeuvre implements Manoeuvre {
    /** Beyond so many jumps with nothing to fly between them it takes the mission for ended. */
    private static final int MAX_JUMPS = 64;

    private final SimulatedMission plan;
    private final CruiseSpeeds cruise;
    private final MissionLegs legs;
    private final Consumer<FlightEvent> events;
    private final Map<Integer, Integer> jumpsDone = new HashMap<>();
    private int index;
    private boolean ended;
    private double yaw = Double.NaN;
    private long arrivedAt = -1;
    private @Nullable NeuPosition lookedAt;
    private @Nullable SimulatedMissionItem item;
    private @Nullable Manoeuvre leg;

    public MissionManoeuvre(
            SimulatedMission plan,
            CruiseSpeeds cruise,
            MissionLegs legs,
            int firstIndex,
            Consumer<FlightEvent> events) {
        this.plan = plan;
        this.cruise = cruise;
        this.legs = legs;
        this.index = firstIndex;
        this.events = events;
    }

    @Override
    public MotionSetpoint fly(SimulatedCraft craft, long nowMillis) {
        if (item == null && !ended) {
            begin(craft);
        }
        if (item != null && leg != null) {
            MotionSetpoint setpoint =
                    facing(leg.fly(craft, nowMillis), craft.body().position());
            if (isComplete(item, leg, nowMillis)) {
                finish(craft);
            }
            return setpoint;
        }
        return leg == null ? new MotionSetpoint.Still() : leg.fly(craft, nowMillis);
    }

    /** The nose to the place that is looked at: its camera is fixed to it. */
    private MotionSetpoint facing(MotionSetpoint setpoint, NeuPosition here) {
        if (lookedAt == null || here.horizontalDistanceTo(lookedAt) < 1) {
            return setpoint;
        }
        double there = here.bearingTo(lookedAt);
        if (setpoint instanceof MotionSetpoint.Reach reach) {
            return new MotionSetpoint.Reach(
                    reach.target(), reach.horizontalSpeed(), reach.climbSpeed(), reach.sinkSpeed(), there);
        }
        return setpoint instanceof MotionSetpoint.Velocity velocity
                ? new MotionSetpoint.Velocity(velocity.north(), velocity.east(), velocity.up(), there)
                : setpoint;
    }

    private void begin(SimulatedCraft craft) {
        for (int jumps = 0; index < plan.size() && !legs.flies(plan.item(index)) && jumps < MAX_JUMPS; ) {
            SimulatedMissionItem order = plan.item(index);
            if (order.command() == SimulatedMissionItem.JUMP) {
                jumps++;
                jump(order);
                continue;
            }
            if (order.isNavigation()) {
                // What the autopilot stores and this vehicle cannot do is passed over, not flown to somewhere.
                events.accept(legs.passedOver(index, order));
                index++;
                continue;
            }
            events.accept(new FlightEvent.ItemStarted(index, order.typeName()));
            execute(order, craft);
            events.accept(new FlightEvent.ItemReached(index));
            index++;
        }
        if (index >= plan.size() || !legs.flies(plan.item(index))) {
            ended = true;
            leg = legs.afterwards(craft, leg == null ? new Grounded() : leg);
            events.accept(new FlightEvent.MissionEnded());
            return;
        }
        SimulatedMissionItem next = plan.item(index);
        item = next;
        leg = legs.legFor(next, craft, yaw);
        arrivedAt = -1;
        events.accept(new FlightEvent.ItemStarted(index, next.typeName()));
    }

    /** Goes back to an item so many times, or for ever; then on. */
    private void jump(SimulatedMissionItem order) {
        int times = (int) order.param2();
        int done = jumpsDone.getOrDefault(index, 0);
        if (times >= 0 && done >= times) {
            index++;
            return;
        }
        jumpsDone.put(index, done + 1);
        String word = times < 0 ? order.typeName() + " unlimited" : order.typeName() + " " + (done + 1) + "/" + times;
        events.accept(new FlightEvent.ItemStarted(index, word));
        index = (int) order.param1();
    }

    private void execute(SimulatedMissionItem order, SimulatedCraft craft) {
        if (order.command() == SimulatedMissionItem.CHANGE_SPEED && order.param2() > 0) {
            cruise.setHorizontal(order.param2());
        } else if (order.command() == SimulatedMissionItem.CONDITION_YAW) {
            double relative = order.param4() != 0 ? craft.body().yaw() : 0;
            yaw = relative + Math.toRadians(order.param1());
        } else if (order.command() == SimulatedMissionItem.LOOK_AT) {
            lookedAt = craft.targetOf(order);
        } else if (order.command() == SimulatedMissionItem.LOOK_AHEAD) {
            lookedAt = null;
        } else if (order.command() == SimulatedMissionItem.SET_ROI) {
            lookedAt = order.hasPlace() ? craft.targetOf(order) : null;
        } else {
            events.accept(new FlightEvent.Ordered(order));
        }
    }

    private boolean isComplete(SimulatedMissionItem flown, Manoeuvre flying, long nowMillis) {
        if (flown.command() == SimulatedMissionItem.LOITER_UNLIMITED) {
            return false;
        }
        boolean there = flown.command() == SimulatedMissionItem.DELAY || flying.done();
        if (there && arrivedAt < 0) {
            arrivedAt = nowMillis;
            events.accept(new FlightEvent.ItemArrived(index));
        }
        return arrivedAt >= 0 && nowMillis - arrivedAt >= legs.holdMillis(flown);
    }

    private void finish(SimulatedCraft craft) {
        events.accept(new FlightEvent.ItemReached(index));
        index++;
        item = null;
        begin(craft);
    }

    /** Goes on with another item at once. */
    public void jumpTo(int newIndex) {
        index = newIndex;
        item = null;
        ended = false;
    }

    public int index() {
        return index;
    }

    public boolean ended() {
        return ended;
    }

    /** True while the present item ends on the ground. */
    public boolean landing() {
        return leg instanceof LandingAt || (leg instanceof ReturnHome home && home.landing());
    }

    @Override
    public boolean done() {
        return ended;
    }
}
