package org.dronemap.ws.lab;

import java.util.List;
import java.util.Optional;

/** Settings of a laboratory that is about to be built. */
public final class LaboratorySetup {
    /** A property of the virtual machine, or the environment's variable for those who start it through other programs. */
    private static final String PROPERTY = "dronemap.separation";

    private static final String VARIABLE = "DRONEMAP_SEPARATION";

    private static final List<String> OFF = List.of("false", "off");

    private final long seed;
    private boolean separation = isSeparationOn();

    private LaboratorySetup(long seed) {
        this.seed = seed;
    }

    public static LaboratorySetup seeded(long seed) {
        return new LaboratorySetup(seed);
    }

    /** Drones are kept apart, unless that was switched off by {@code -Ddronemap.separation=false}. */
    public static boolean isSeparationOn() {
        Optional<String> wanted = Optional.ofNullable(System.getProperty(PROPERTY, System.getenv(VARIABLE)));
        return wanted.filter(OFF::contains).isEmpty();
    }

    /** Drones of all operations are kept apart, or nobody is by anything beyond its own operation. */
    public LaboratorySetup separation(boolean on) {
        separation = on;
        return this;
    }

    public Laboratory build() {
        return new Laboratory(seed, separation);
    }
}
