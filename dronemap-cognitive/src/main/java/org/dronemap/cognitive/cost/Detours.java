package org.dronemap.cognitive.cost;

import java.util.List;
import org.dronemap.core.geo.Geodetic;

/** Where a way turns between two places, numbered as in {@link Legs}. */
interface Detours {
    Detours NONE = (type, from, to) -> List.of();

    /** Nothing for a straight way. */
    List<Geodetic> between(int type, int from, int to);
}
