package org.dronemap.proxy.outlet.rights;

/** A range of UDP port numbers, used for the outlet's personal ports; both ends included, possibly empty. */
public record PortRange(int first, int last) {
    public static final PortRange NONE = new PortRange(1, 0);
    private static final int HIGHEST = 65_535;

    public PortRange {
        if (first < 1 || last > HIGHEST) {
            throw new IllegalArgumentException("ports are 1 to " + HIGHEST + ": " + first + "-" + last);
        }
    }

    public boolean isEmpty() {
        return last < first;
    }
}
