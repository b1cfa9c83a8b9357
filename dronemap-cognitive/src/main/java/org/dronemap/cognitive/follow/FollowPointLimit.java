package org.dronemap.cognitive.follow;

/**
 * Limits the moving point that a following drone is told to be at: its distance from the drone, and its speed. An
 * autopilot that leans as far as it may no longer turns: a real ArduCopter that was asked for more than it had flew
 * straight on in bends, up to 55 m off. So a carrot that its drone does not keep up with goes slower than the drone
 * does, until that has something left to turn with.
 *
 * @param meters from where the drone is expected
 * @param speed of the carrot, m/s
 */
record FollowPointLimit(double meters, double speed) {
    private static final double LENGTH = 1;
    /** Nothing is wrong with a drone that is this far off. */
    private static final double USUAL = 0.5;

    /** So much faster than its drone a carrot goes that is a little farther off, m/s; */
    private static final double FASTER = 2;
    /** and so much slower for each metre more. */
    private static final double SLOWER_PER_METER = 2.5;
    /** It never stands for that. */
    private static final double SLOWEST = 2;
    /** m/s²: what a drone may have done since it was heard. */
    private static final double UNHEARD = 2;

    /**
     * For a carrot that is {@code apart} metres from where its drone is expected.
     *
     * @param speed of the drone, m/s
     * @param late from when the drone was heard to when the carrot counts, in seconds
     */
    static FollowPointLimit of(double apart, double speed, double late) {
        double unheard = UNHEARD * late * late / 2;
        double off = apart - USUAL - unheard;
        double most = off <= 0 ? Double.POSITIVE_INFINITY : Math.max(SLOWEST, speed + FASTER - SLOWER_PER_METER * off);
        return new FollowPointLimit(LENGTH + unheard, most);
    }
}
