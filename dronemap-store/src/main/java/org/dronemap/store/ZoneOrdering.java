package org.dronemap.store;

import java.util.Comparator;
import org.dronemap.core.zone.Zone;

/** The sort order of zones, by name, the same in every kind of store. */
public final class ZoneOrdering {
    public static final Comparator<Zone> BY_NAME = Comparator.comparing(Zone::name, String.CASE_INSENSITIVE_ORDER)
            .thenComparing(Zone::name)
            .thenComparing(Zone::id);

    private ZoneOrdering() {}
}
