package org.dronemap.core.parameter;

import org.dronemap.core.stored.Stored;

/**
 * One vehicle parameter that the cloud has overridden, with the owner's value and the cloud's.
 *
 * @param ours what the cloud wrote
 * @param bits that the cloud may change, also in flight: of such a one only these are put back, and all others stay as they
 *     are found; 0: the value is one
 */
@Stored(names = "name owners ours bits")
public record OverriddenParameter(String name, double owners, double ours, long bits) {
    public OverriddenParameter(String name, double owners, double ours) {
        this(name, owners, ours, 0);
    }

    public boolean isToBeWritten() {
        return owners != ours;
    }

    /** Whether the vehicle shows what the cloud left there, or its owner's value: else somebody else has changed it. */
    public boolean isAsLeft(double shown) {
        return shown == ours || shown == owners || bits != 0;
    }

    /** What is to be there again, where that is shown now. */
    public double putBack(double shown) {
        return bits == 0 ? owners : (double) (others(shown) | ((long) owners & bits));
    }

    private long others(double value) {
        return (long) value & ~bits;
    }
}
