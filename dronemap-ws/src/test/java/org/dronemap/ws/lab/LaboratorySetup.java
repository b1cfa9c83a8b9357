package org.dronemap.ws.lab;

import java.util.List;
import java.util.Optional;

/** Settings of a laboratory that is about to be built. */
public final class LaboratorySetup {
    /** A property of the virtual machine, or the environment's variable for those who start it through other programs. */
    private static final String PROPERTY = "dronemap.separation";

    private static final String VARIABLE = "DRONEMAP_SEPARATION";

    private static final List<String> OFF = List.of("false", "off");

    /** The one place that says whether servers have the mechanism that keeps drones of all operations apart. */
    private static final boolean HAS_SEPARATION = false;

    private final long seed;
    private boolean separation = isSeparationOn();

    private LaboratorySetup(long seed) {
        this.seed = seed;
    }

    public static LaboratorySetup seeded(long seed) {
        return new LaboratorySetup(seed);
    }

    /** Servers of this version can keep drones of all operations apart. */
    public static boolean hasSeparation() {
        return HAS_SEPARATION;
    }

    /** The mechanism is there, and was not switched off by {@code -Ddronemap.separation=false}. */
    public static boolean isSeparationOn() {
        Optional<String> wanted = Optional.ofNullable(System.getProperty(PROPERTY, System.getenv(VARIABLE)));
        return HAS_SEPARATION && wanted.filter(OFF::contains).isEmpty();
    }

    /** Drones of all operations are kept apart, or nobody is by anything beyond its own operation. */
    public LaboratorySetup separation(boolean on) {
        separation = on;
        return this;
    }

    public Laboratory build() {
        return new Laboratory(seed, HAS_SEPARATION && separation);
    }
}
