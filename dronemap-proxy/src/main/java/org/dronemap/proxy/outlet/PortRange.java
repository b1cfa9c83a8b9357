package org.dronemap.proxy.outlet;

/** UDP ports from the first to the last one, both among them; none when the last is before the first. */
public record PortRange(int first, int last) {
    public static final PortRange NONE = new PortRange(1, 0);
    private static final int HIGHEST = 65_535;

    public PortRange {
        if (first < 1 || last > HIGHEST) {
            throw new IllegalArgumentException("ports are 1 to " + HIGHEST + ": " + first + "-" + last);
        }
    }

    boolean isEmpty() {
        return last < first;
    }
}
