package org.dronemap.sim.physics;

/**
 * The simulated ArduCopter's position controller for a moving target: a smoothed reference and a lean towards it. As
 * long as it would have to lean farther than it may, the reference waits: then it neither comes up nor turns. Owned by
 * its body.
 */
final class MovingTargetController {
    /** m/s² and m/s³ as delivered (WPNAV_ACCEL, PSC_JERK_XY). */
    private static final double ACCELERATION = 2.5;

    private static final double JERK = 5;
    private static final double SPEED_GAIN = JERK / ACCELERATION;

    private static final double FOLLOW_GAIN = 1;
    private static final double SPEED_TO_LEAN = 2;
    private static final double SUM_TO_LEAN = 1;
    private static final double CHANGE_TO_LEAN = 0.5;
    private static final double FILTER_SECONDS = 1 / (2 * Math.PI * 5);

    private final double most;
    private HorizontalVector place;
    private HorizontalVector velocity;
    private HorizontalVector acceleration = HorizontalVector.ZERO;
    private HorizontalVector late = HorizontalVector.ZERO;
    private HorizontalVector slow = HorizontalVector.ZERO;
    private HorizontalVector slowing = HorizontalVector.ZERO;
    private HorizontalVector sum;
    /** What it would lean for; zero: it may. */
    private HorizontalVector over = HorizontalVector.ZERO;

    /** A position over the ground and its velocity. */
    record Moving(HorizontalVector place, HorizontalVector velocity) {}

    /** {@code most}: what it may lean for, in m/s²; {@code leans}: what it leans for against the wind. */
    MovingTargetController(Moving begins, double most, HorizontalVector leans) {
        this.most = most;
        place = begins.place();
        velocity = begins.velocity();
        sum = leans;
    }

    /** What it leans for, in m/s²; {@code speed}: no faster than the target by more than that. */
    HorizontalVector leans(Moving target, Moving here, double speed, double seconds) {
        advance(seconds);
        shape(target, speed, seconds);
        return follow(here, seconds);
    }

    private void advance(double seconds) {
        HorizontalVector way = velocity.times(seconds).plus(acceleration.times(seconds * seconds / 2));
        if (!(way.dot(over) > 0 && late.dot(over) > 0)) {
            place = place.plus(way);
        }
        HorizontalVector change = acceleration.times(seconds);
        if (!(change.dot(over) > 0 && slow.dot(over) > 0 && velocity.dot(over) >= 0)) {
            velocity = velocity.plus(change);
        }
    }

    private void shape(Moving target, double speed, double seconds) {
        HorizontalVector wanted = target.velocity()
                .plus(approach(target.place().minus(place), SPEED_GAIN / 2, ACCELERATION / 2)
                        .within(speed));
        HorizontalVector faster =
                approach(wanted.minus(velocity), SPEED_GAIN, JERK).within(ACCELERATION);
        acceleration = acceleration.plus(faster.minus(acceleration).within(JERK * seconds));
    }

    private HorizontalVector follow(Moving here, double seconds) {
        late = place.minus(here.place());
        HorizontalVector wanted = velocity.plus(approach(late, FOLLOW_GAIN, ACCELERATION));
        double fresh = seconds / (seconds + FILTER_SECONDS);
        HorizontalVector before = slow;
        slow = slow.plus(wanted.minus(here.velocity()).minus(slow).times(fresh));
        slowing = slowing.plus(
                slow.minus(before).times(1 / seconds).minus(slowing).times(fresh));
        add(slow.times(SUM_TO_LEAN * seconds));
        HorizontalVector all = slow.times(SPEED_TO_LEAN)
                .plus(sum)
                .plus(slowing.times(CHANGE_TO_LEAN))
                .plus(acceleration);
        boolean allowed = all.length() <= most;
        over = allowed ? HorizontalVector.ZERO : all;
        return allowed ? all : sidewaysFirst(all);
    }

    /** What it cannot have it does not ask for more and more. */
    private void add(HorizontalVector more) {
        HorizontalVector next = sum.plus(more);
        sum = more.dot(over) > 0 ? next.within(sum.length()) : next;
    }

    /** Turning goes before keeping up. */
    private HorizontalVector sidewaysFirst(HorizontalVector all) {
        double speed = velocity.length();
        if (speed == 0) {
            return all.within(most);
        }
        HorizontalVector ahead = velocity.times(1 / speed);
        double along = all.dot(ahead);
        HorizontalVector aside = all.minus(ahead.times(along)).within(most);
        double left = Math.sqrt(Math.max(0, most * most - aside.dot(aside)));
        return aside.plus(ahead.times(Math.max(-left, Math.min(left, along))));
    }

    /** The speed, or the acceleration, from which a constant deceleration still ends in time; soft at the end. */
    private static HorizontalVector approach(HorizontalVector off, double gain, double decelerating) {
        double length = off.length();
        double linear = decelerating / (gain * gain);
        return length <= linear
                ? off.times(gain)
                : off.times(Math.sqrt(2 * decelerating * (length - linear / 2)) / length);
    }
}
