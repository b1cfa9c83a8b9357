package org.dronemap.store;

import java.util.Comparator;
import org.dronemap.core.zone.Zone;

/** How zones are listed, in every adapter alike. */
public final class ZoneOrder {
    public static final Comparator<Zone> BY_NAME = Comparator.comparing(Zone::name, String.CASE_INSENSITIVE_ORDER)
            .thenComparing(Zone::name)
            .thenComparing(Zone::id);

    private ZoneOrder() {}
}
