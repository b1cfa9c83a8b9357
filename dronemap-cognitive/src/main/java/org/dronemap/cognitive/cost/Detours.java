package org.dronemap.cognitive.cost;

import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/** The turns that lead legs between places round barriers, places numbered as in {@link Legs}. */
interface Detours {
    Detours NONE = new Detours() {
        @Override
        public List<Geodetic> between(int type, int from, int to) {
            return List.of();
        }

        @Override
        public @Nullable String obstacle(int type, int waypoint) {
            return null;
        }
    };

    /** Where the way turns; nothing for a straight one. */
    List<Geodetic> between(int type, int from, int to);

    /** What keeps drones from a waypoint, in words; null when nothing does. */
    @Nullable
    String obstacle(int type, int waypoint);
}
