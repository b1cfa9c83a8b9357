package org.dronemap.cognitive.cost;

/**
 * One drone as the search sees it.
 *
 * @param type which legs it flies ({@link Legs})
 * @param readySeconds when it can set off, on the plan's clock
 * @param rangeJoules what it may draw till its end, the reserve left out; infinite without a limit
 * @param mustFly it is in the air: with nothing to visit it still flies from its start to its end
 * @param busy it has visits of its own beside those of the problem, so that it is never idle
 */
public record AllocationDrone(int type, double readySeconds, double rangeJoules, boolean mustFly, boolean busy) {
    public AllocationDrone(int type, double readySeconds, double rangeJoules, boolean mustFly) {
        this(type, readySeconds, rangeJoules, mustFly, false);
    }

    public AllocationDrone(int type, double readySeconds, double rangeJoules) {
        this(type, readySeconds, rangeJoules, false);
    }
}
